import type { Tape } from '../state/tape.js';
import { nonNegativeOrInfinite } from '../validate.js';
import { Link } from './link.js';
import { BoundedConstraint, type Bounds, type TwoAnchorParams, takeBounds } from './two-body.js';

/**
 * Options of `createDistanceConstraint`. Bounds in m, `lowerBound` >= 0. Both are 0 by default, so give `upperBound` for a rope, and both
 * for a rod.
 */
export interface DistanceConstraintParams extends TwoAnchorParams, Bounds {}

/**
 * Keeps the distance between points of two bodies within bounds: a rod, a rope (no lower bound), a spring (not stiff). For a distance of 0
 * use a point constraint.
 *
 *     lower ≤ |wB − wA| ≤ upper,   w = x + R(θ) · anchor
 */
export class DistanceConstraint extends BoundedConstraint {
  /** Tells the kinds apart. */
  readonly type = 'DISTANCE';

  /** @internal */
  readonly link = new Link(0, 1);

  /** @internal use `createDistanceConstraint` */
  constructor(params: DistanceConstraintParams) {
    const where = 'createDistanceConstraint';
    super(where, 1, params);
    takeBounds(this, where, params, 0, 0);
    nonNegativeOrInfinite(where, 'lowerBound', this.lower);
  }

  /** @internal */
  protected override checkedBound(where: string, name: string, bound: number): number {
    return nonNegativeOrInfinite(where, name, bound);
  }

  /**
   * @internal A lower bound of 0 cannot be passed. As a body swings through the anchor, the distance extrapolated in a straight line is
   * below 0, and must not be taken for an error.
   */
  override lowerLimit(): number {
    return this.lower === 0 && this.upper > 0 ? -Infinity : this.lower;
  }

  /** @internal */
  override keep(tape: Tape): void {
    this.link.keep(tape);
    super.keep(tape);
  }

  /** @internal What `kernels/distances.ts` finds from its records; its tests compare the two. */
  measure(pose: Float64Array, out: Float64Array, c: number, j: number): void {
    this.link.add(1, pose, this.anchors, out, c, j);
  }
}
