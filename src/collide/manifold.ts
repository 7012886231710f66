import { FACE_KEPT_MOTION } from '../config.js';
import * as g from './layout.js';

// The manifold in the record of a pair, written by a collision kernel: how two shapes overlap, or face each other within the speculative
// margin. Points are relative to the origin of body A, so that nothing is lost far from the world's origin. It lives on from step to step:
// a kernel starts from its last result.

/** Whether some point is in contact. Circles that just touch collide, polygons that just touch do not. */
export function overlaps(n: Float64Array, o: number): boolean {
  const count = n[o + g.COUNT]!;
  return count === 2 ? n[o + g.S0]! < 0 || n[o + g.S1]! < 0 : count === 1 && n[o + g.S0]! <= 0;
}

/** The result of `findLeastSeparation`, m; an array, so that it is not boxed. */
export const leastSeparation = /* @__PURE__ */ new Float64Array(1);

/** Writes to `leastSeparation` the separation of the deepest point, of the one or two that there are. */
export function findLeastSeparation(n: Float64Array, o: number): void {
  leastSeparation[0] = n[o + g.COUNT] === 2 ? Math.min(n[o + g.S0]!, n[o + g.S1]!) : n[o + g.S0]!;
}

/**
 * Whether the reference face can be kept: the bodies have hardly moved relative to each other since it was chosen, however both turn
 * together, as in a drum; and the shapes are the same. `stamp` is the sum of their stamps, `reach` the radius of B's body, m.
 */
export function keepsFace(n: Float64Array, o: number, stamp: number, reach: number): boolean {
  const x = n[o + g.LOCAL_X]! - n[o + g.FACE_X]!;
  const y = n[o + g.LOCAL_Y]! - n[o + g.FACE_Y]!;
  const turn = n[o + g.ANGLE_B]! - n[o + g.ANGLE_A]! - n[o + g.FACE_TURN]!;
  const rim = reach > 1 ? turn * reach : turn;
  return (
    n[o + g.FACE]! >= 0 &&
    n[o + g.FACE_STAMP] === stamp &&
    x * x + y * y < FACE_KEPT_MOTION * FACE_KEPT_MOTION &&
    rim * rim < FACE_KEPT_MOTION * FACE_KEPT_MOTION
  );
}

/** Notes the placement and the shapes that the reference face was chosen for. */
export function noteFace(n: Float64Array, o: number, stamp: number): void {
  n[o + g.FACE_STAMP] = stamp;
  n[o + g.FACE_X] = n[o + g.LOCAL_X]!;
  n[o + g.FACE_Y] = n[o + g.LOCAL_Y]!;
  n[o + g.FACE_TURN] = n[o + g.ANGLE_B]! - n[o + g.ANGLE_A]!;
}

/** Drops normal and points. */
export function empty(n: Float64Array, o: number): void {
  n[o + g.COUNT] = 0;
  n[o + g.NX] = 0;
  n[o + g.NY] = 0;
}

/** Resets a record, for a new pair. */
export function reset(n: Float64Array, o: number): void {
  n.fill(0, o, o + g.PAIR_NUMBERS);
  n[o + g.EDGE_A] = -1;
  n[o + g.EDGE_B] = -1;
  n[o + g.AXIS] = -1;
  n[o + g.FACE] = -1;
}
