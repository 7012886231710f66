import type { RigidBody } from '../body.js';
import type { Constraint } from './constraint.js';
import { COS, POSE, SIN, X, Y } from './layout.js';
import { AnchoredConstraint, type TwoAnchorParams } from './two-body.js';

/** Options of `createPointConstraint`. */
export interface PointConstraintParams extends TwoAnchorParams {}

/**
 * Two points of two bodies coincide; the bodies turn freely about them. A second one between the same bodies holds them like a weld, at any distance: of the two, added in this order, the first gives what keeps the
 * points together, and the second what keeps the angle, as if it were a couple.
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

  /** @internal Whether one of two points keeps an angle only hangs on where both are: joints are to be listed again. */
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
    pointRows(pose, this.anchors, out, c, j, 6);
  }
}

/** @internal */
export function holdsBoth({ members }: Constraint, bodyA: RigidBody, bodyB: RigidBody): boolean {
  return members.includes(bodyA) && members.includes(bodyB);
}

/** @internal the two rows of "wB = wA", `stride` apart */
export function pointRows(
  pose: Float64Array,
  anchors: Float64Array,
  out: Float64Array,
  c: number,
  j: number,
  stride: number,
): void {
  for (let k = 0; k < 2; k += 1) {
    const at = k * POSE;
    const sign = k === 0 ? -1 : 1;
    const rx = pose[at + COS]! * anchors[2 * k]! - pose[at + SIN]! * anchors[2 * k + 1]!;
    const ry = pose[at + SIN]! * anchors[2 * k]! + pose[at + COS]! * anchors[2 * k + 1]!;
    out[c] = out[c]! + sign * (pose[at + X]! + rx);
    out[c + 1] = out[c + 1]! + sign * (pose[at + Y]! + ry);
    out[j + 3 * k] = sign;
    out[j + 3 * k + 2] = -sign * ry;
    out[j + stride + 3 * k + 1] = sign;
    out[j + stride + 3 * k + 2] = sign * rx;
  }
}
