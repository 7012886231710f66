import { SPECULATIVE_MARGIN } from '../config.js';
import type { Shape } from '../shape/shape.js';

// Bounds, `[minX, minY, maxX, maxY]`, around shapes and places: what broadphases are asked by.

/** m. By how much bounds are wider; a number of its own would be boxed where it is handed on. */
export interface Reach {
  readonly reach: number;
}

/** Half the margin within which pairs are solved: two shapes within that overlap. */
export const HALF_MARGIN: Reach = { reach: SPECULATIVE_MARGIN / 2 };

/** Writes the bounds of a shape, so much wider on all sides. */
export function growBounds({ numbers: n, at }: Shape, { reach }: Reach, out: Float64Array): void {
  out[0] = n[at]! - reach;
  out[1] = n[at + 1]! - reach;
  out[2] = n[at + 2]! + reach;
  out[3] = n[at + 3]! + reach;
}

/** Writes the square that reaches so far from a point. */
export function squareAround(x: number, y: number, reach: number, out: Float64Array): void {
  out[0] = x - reach;
  out[1] = y - reach;
  out[2] = x + reach;
  out[3] = y + reach;
}
