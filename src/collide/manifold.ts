import { FACE_KEPT_MOTION } from '../config.js';
import * as g from './layout.js';

// What a collision kernel found, in the record of a pair: how two shapes overlap, or face each other within the speculative margin. Points are given
// relative to the origin of body A, so that nothing is lost far from the world's origin. It lives on from step to step: a kernel starts from what it
// found last time.

/** Some point is in contact. Circles that touch collide, polygons that touch do not. */
export function overlaps(n: Float64Array, o: number): boolean {
  const count = n[o + g.COUNT]!;
  return count === 2 ? n[o + g.S0]! < 0 || n[o + g.S1]! < 0 : count === 1 && n[o + g.S0]! <= 0;
}

/** m. What `findLeastSeparation` found; an array, so that it is not boxed. */
export const leastSeparation = /* @__PURE__ */ new Float64Array(1);

/** Writes to `leastSeparation` the separation of the point that is deepest, of the one or two that were found. */
export function findLeastSeparation(n: Float64Array, o: number): void {
  leastSeparation[0] = n[o + g.COUNT] === 2 ? Math.min(n[o + g.S0]!, n[o + g.S1]!) : n[o + g.S0]!;
}

/**
 * The bodies have hardly moved against each other since the choice of edges, however both turn together, as in a drum; and the shapes are the same: `stamp` is
 * the sum of theirs. B's body reaches so far from its origin.
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

/** Remembers for what the edges were chosen. */
export function faceChosen(n: Float64Array, o: number, stamp: number): void {
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

/** Forgets what was found for another pair. */
export function reset(n: Float64Array, o: number): void {
  n.fill(0, o, o + g.PAIR_NUMBERS);
  n[o + g.EDGE_A] = -1;
  n[o + g.EDGE_B] = -1;
  n[o + g.AXIS] = -1;
  n[o + g.FACE] = -1;
}
