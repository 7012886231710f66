import { FACE_MOTION, FACE_TURN } from '../config.js';

/**
 * What a collision kernel found: how two shapes overlap, or face each other within the speculative margin. Points are given relative to the origin of body A, so that
 * nothing is lost far from the world's origin. Lives in its pair from step to step: a kernel starts from the last axis.
 */
export class Manifold {
  /** Input: from body A's origin to body B's. A field, because numbers handed over as arguments would be boxed. */
  dx = 0;
  dy = 0;
  /** Input: the rotations of both bodies. */
  angleA = 0;
  angleB = 0;
  /** Number of points, 0 to 2. */
  count = 0;
  /** Unit normal from A to B. */
  nx = 0;
  ny = 0;
  /** Points half-way into the overlap. With two, the first lies lower along the tangent (−ny, nx). */
  x0 = 0;
  y0 = 0;
  x1 = 0;
  y1 = 0;
  /** m; negative where the surfaces overlap. */
  separation0 = 0;
  separation1 = 0;
  /** The corner that limits the overlap at this end: 2 · index, + 1 for a corner of B. */
  id0 = 0;
  id1 = 0;
  /** The two edges that face each other. */
  edgeA = -1;
  edgeB = -1;
  /** Where to look first for a separating axis: 2 · edge, + 1 for an edge of B; −1: nowhere. */
  axis = -1;

  /** Whose edge the other's was clipped to: 0 A's, 1 B's, −1: there was no such choice … */
  face = -1;
  /** … for this placement and these shapes. */
  faceDx = 0;
  faceDy = 0;
  faceAngleA = 0;
  faceAngleB = 0;
  faceStamp = 0;

  /** The bodies have hardly moved since the choice of edges, and the shapes are the same: `stamp` is the sum of theirs. */
  keepsFace(stamp: number): boolean {
    const x = this.dx - this.faceDx;
    const y = this.dy - this.faceDy;
    const a = this.angleA - this.faceAngleA;
    const b = this.angleB - this.faceAngleB;
    return (
      this.face >= 0 &&
      this.faceStamp === stamp &&
      x * x + y * y < FACE_MOTION * FACE_MOTION &&
      a * a < FACE_TURN * FACE_TURN &&
      b * b < FACE_TURN * FACE_TURN
    );
  }

  /** Remembers the choice. */
  setFace(face: number, stamp: number): void {
    this.face = face;
    this.faceStamp = stamp;
    this.faceDx = this.dx;
    this.faceDy = this.dy;
    this.faceAngleA = this.angleA;
    this.faceAngleB = this.angleB;
  }

  /** Forgets what was found for another pair. */
  reset(): void {
    this.count = 0;
    this.edgeA = -1;
    this.edgeB = -1;
    this.axis = -1;
    this.face = -1;
  }

  /** Some point is in contact. Circles that touch collide, polygons that touch do not. */
  overlaps(): boolean {
    return this.count === 2 ? this.separation0 < 0 || this.separation1 < 0 : this.count === 1 && this.separation0 <= 0;
  }
}
