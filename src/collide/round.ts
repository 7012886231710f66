import { EDGE_STRIDE, EDGES } from '../geometry/layout.js';
import type { Polygon } from '../shape/polygon.js';

/** A circle; or a corner of a polygon, which is one of radius 0. Relative to the origin of its body. */
export class Round {
  x = 0.5;
  y = 0.5;
  radius = 0.5;
  /** From a corner to the two beside it, m; zeros for a circle. */
  readonly sides = new Float64Array(4);
}

/** m. By how much a point of a contact may be off a corner by rounding. */
const SAME = 1e-9;

/** Finds the corner of a placed polygon at `(x, y)`. @returns whether there is one. */
export function findCorner(round: Round, { numbers: n, at, offsets }: Polygon, x: number, y: number): boolean {
  const from = at + EDGES;
  const end = from + EDGE_STRIDE * offsets.length;
  for (let k = from; k < end; k += EDGE_STRIDE) {
    if (Math.abs(n[k]! - x) + Math.abs(n[k + 1]! - y) < SAME) {
      const before = k === from ? end - EDGE_STRIDE : k - EDGE_STRIDE;
      const after = k + EDGE_STRIDE === end ? from : k + EDGE_STRIDE;
      round.x = n[k]!;
      round.y = n[k + 1]!;
      round.radius = 0;
      for (let i = 0; i < 2; i += 1) {
        round.sides[i] = n[before + i]! - n[k + i]!;
        round.sides[2 + i] = n[after + i]! - n[k + i]!;
      }
      return true;
    }
  }
  return false;
}

/** Whether it is what is met by something that lies in a direction: not where a corner stands for one of the edges beside it. */
export function faces({ sides }: Round, nx: number, ny: number): boolean {
  return nx * sides[0]! + ny * sides[1]! <= 0 && nx * sides[2]! + ny * sides[3]! <= 0;
}
