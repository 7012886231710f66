import { SPECULATIVE_MARGIN } from '../config.js';
import type { Shape } from '../shape/shape.js';

// Bounds, `[minX, minY, maxX, maxY]`, around shapes and places, for queries of broadphases.

/** By how much bounds are widened, m. An object, as a number of its own would be boxed where it is handed on. */
export interface Reach {
  readonly reach: number;
}

/** Half the margin within which pairs are solved: two shapes that are closer than the margin overlap if both are widened by this. */
export const HALF_MARGIN: Reach = { reach: SPECULATIVE_MARGIN / 2 };

/** Writes the bounds of a shape, widened by the reach on all sides. */
export function growBounds({ numbers: n, at }: Shape, { reach }: Reach, out: Float64Array): void {
  out[0] = n[at]! - reach;
  out[1] = n[at + 1]! - reach;
  out[2] = n[at + 2]! + reach;
  out[3] = n[at + 3]! + reach;
}

/** Writes the bounds of the square around a point, with sides of twice the reach. */
export function squareAround(x: number, y: number, reach: number, out: Float64Array): void {
  out[0] = x - reach;
  out[1] = y - reach;
  out[2] = x + reach;
  out[3] = y + reach;
}
