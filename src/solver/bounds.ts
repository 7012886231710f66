import { SPECULATIVE_MARGIN } from '../config.js';
import { MAX_X, MAX_Y, MIN_X, MIN_Y } from '../geometry/layout.js';
import type { Shape } from '../shape/shape.js';

// Bounds, laid out as those in the numbers of a shape, around shapes and places, for queries of broadphases.

/** By how much bounds are widened, m. An object, as a number of its own would be boxed where it is handed on. */
export interface Reach {
  readonly reach: number;
}

/** Half the margin within which pairs are solved: two shapes that are closer than the margin overlap if both are widened by this. */
export const HALF_MARGIN: Reach = { reach: SPECULATIVE_MARGIN / 2 };

/** Writes the bounds of a shape, widened by the reach on all sides. */
export function growBounds({ numbers: n, at }: Shape, { reach }: Reach, out: Float64Array): void {
  out[MIN_X] = n[at + MIN_X]! - reach;
  out[MIN_Y] = n[at + MIN_Y]! - reach;
  out[MAX_X] = n[at + MAX_X]! + reach;
  out[MAX_Y] = n[at + MAX_Y]! + reach;
}

/** Writes the bounds of the square around a point, with sides of twice the reach. */
export function squareAround(x: number, y: number, reach: number, out: Float64Array): void {
  out[MIN_X] = x - reach;
  out[MIN_Y] = y - reach;
  out[MAX_X] = x + reach;
  out[MAX_Y] = y + reach;
}
