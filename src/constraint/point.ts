import type { RigidBody } from '../body.js';
import type { Constraint } from './constraint.js';
import { COS, POSE, ROW_AW, ROW_AX, ROW_AY, ROW_BW, ROW_BX, ROW_BY, ROW_SIZE, SIN, X, Y } from './layout.js';
import { AnchoredConstraint, type TwoAnchorParams } from './two-body.js';

/** Options of `createPointConstraint`. */
export interface PointConstraintParams extends TwoAnchorParams {}

/**
 * A hinge: holds a point of one body on a point of another, about which both turn freely. For limits add an angle constraint, to drive it a
 * motor constraint. A second point constraint between the same bodies holds them as a weld does: the first one then reports the impulse
 * that keeps the points together, and the second the impulse that keeps the angle.
 *
 *     C = wB − wA = 0,   w = x + r,   r = R(θ) · anchor
 *     J = [−1, 0, rA.y, 1, 0, −rB.y;  0, −1, −rA.x, 0, 1, rB.x]
 */
export class PointConstraint extends AnchoredConstraint {
  /** Tells the kinds apart. */
  readonly type = 'POINT';

  /** @internal use `createPointConstraint` */
  constructor(params: PointConstraintParams) {
    super('createPointConstraint', 2, params);
  }

  /** @internal Of two points between the same bodies the second keeps the angle, unless both are in one place: so joints have to be listed again. */
  protected override moved(): void {
    const { owner, bodyA, bodyB } = this;
    if (owner !== null) {
      owner.jointsStale ||= bodyA.constraints.some(
        (other) => other.type === 'POINT' && other !== this && holdsBoth(other, bodyA, bodyB),
      );
    }
  }

  /** @internal */
  measure(pose: Float64Array, out: Float64Array, c: number, j: number): void {
    pointRows(pose, this.anchors, out, c, j);
  }
}

/** @internal */
export function holdsBoth({ members }: Constraint, bodyA: RigidBody, bodyB: RigidBody): boolean {
  return members.includes(bodyA) && members.includes(bodyB);
}

/** @internal the two rows of wB = wA */
export function pointRows(pose: Float64Array, anchors: Float64Array, out: Float64Array, c: number, j: number): void {
  const cosA = pose[COS]!;
  const sinA = pose[SIN]!;
  const cosB = pose[POSE + COS]!;
  const sinB = pose[POSE + SIN]!;
  const ax = cosA * anchors[0]! - sinA * anchors[1]!;
  const ay = sinA * anchors[0]! + cosA * anchors[1]!;
  const bx = cosB * anchors[2]! - sinB * anchors[3]!;
  const by = sinB * anchors[2]! + cosB * anchors[3]!;
  out[c] = out[c]! - (pose[X]! + ax) + (pose[POSE + X]! + bx);
  out[c + 1] = out[c + 1]! - (pose[Y]! + ay) + (pose[POSE + Y]! + by);
  out[j + ROW_AX] = -1;
  out[j + ROW_AW] = ay;
  out[j + ROW_BX] = 1;
  out[j + ROW_BW] = -by;
  const k = j + ROW_SIZE;
  out[k + ROW_AY] = -1;
  out[k + ROW_AW] = -ax;
  out[k + ROW_BY] = 1;
  out[k + ROW_BW] = bx;
}
