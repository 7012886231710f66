import { FACE_MOTION, FACE_TURN } from '../config.js';
import { doubles } from '../math/doubles.js';
import * as g from './layout.js';

/**
 * What a collision kernel found: how two shapes overlap, or face each other within the speculative margin. Points are given relative to
 * the origin of body A, so that nothing is lost far from the world's origin. Lives in its pair from step to step: a kernel starts from
 * what it found last time.
 */
export class Manifold {
  /** See `layout.ts`. */
  readonly numbers = doubles(g.PAIR_NUMBERS);
  /** Number of points, 0 to 2. With two, the first lies lower along the tangent (−ny, nx). */
  count = 0;
  /** The corner that limits the overlap at this end: 2 · index, + 1 for a corner of B. */
  id0 = 0;
  id1 = 0;
  /** The two edges that face each other. */
  edgeA = -1;
  edgeB = -1;
  /** Where to look first for a separating axis: 2 · edge, + 1 for an edge of B; −1: nowhere. */
  axis = -1;
  /** Whose edge the other's was clipped to: 0 A's, 1 B's, −1: there was no such choice; and for which shapes. */
  face = -1;
  faceStamp = 0;

  /** Some point is in contact. Circles that touch collide, polygons that touch do not. */
  overlaps(): boolean {
    const n = this.numbers;
    return this.count === 2 ? n[g.S0]! < 0 || n[g.S1]! < 0 : this.count === 1 && n[g.S0]! <= 0;
  }

  /** The bodies have hardly moved since the choice of edges, and the shapes are the same: `stamp` is the sum of theirs. */
  keepsFace(stamp: number): boolean {
    const n = this.numbers;
    const x = n[g.DX]! - n[g.FACE_DX]!;
    const y = n[g.DY]! - n[g.FACE_DY]!;
    const a = n[g.ANGLE_A]! - n[g.FACE_ANGLE_A]!;
    const b = n[g.ANGLE_B]! - n[g.FACE_ANGLE_B]!;
    return (
      this.face >= 0 &&
      this.faceStamp === stamp &&
      x * x + y * y < FACE_MOTION * FACE_MOTION &&
      a * a < FACE_TURN * FACE_TURN &&
      b * b < FACE_TURN * FACE_TURN
    );
  }

  /** Remembers for what the edges were chosen. */
  faceChosen(stamp: number): void {
    const n = this.numbers;
    this.faceStamp = stamp;
    n[g.FACE_DX] = n[g.DX]!;
    n[g.FACE_DY] = n[g.DY]!;
    n[g.FACE_ANGLE_A] = n[g.ANGLE_A]!;
    n[g.FACE_ANGLE_B] = n[g.ANGLE_B]!;
  }

  /** Drops normal and points. */
  empty(): void {
    this.count = 0;
    this.numbers[g.NX] = 0;
    this.numbers[g.NY] = 0;
  }

  /** Forgets what was found for another pair. */
  reset(): void {
    this.count = 0;
    this.numbers.fill(0);
    this.id0 = 0;
    this.id1 = 0;
    this.edgeA = -1;
    this.edgeB = -1;
    this.axis = -1;
    this.face = -1;
    this.faceStamp = 0;
  }
}
