import { ANGLE, POSE, ROW_AW, ROW_BW } from './layout.js';
import { type Bounds, RatioConstraint, type RatioParams, takeBounds } from './two-body.js';

/** Options of `createAngleConstraint`. Bounds in rad; both are 0 by default, which holds the bodies at the same angle. */
export interface AngleConstraintParams extends RatioParams, Bounds {}

/**
 * Keeps the angle between two bodies within bounds; with a ratio, a gear. Rotations are not wrapped.
 *
 *     lower ≤ ratio · θB − θA ≤ upper
 */
export class AngleConstraint extends RatioConstraint {
  /** Tells the kinds apart. */
  readonly type = 'ANGLE';

  /** @internal use `createAngleConstraint` */
  constructor(params: AngleConstraintParams) {
    const where = 'createAngleConstraint';
    super(where, params);
    takeBounds(this, where, params, 0, 0);
  }

  /** The least angle, rad. */
  getLowerBound(): number {
    return this.lower;
  }

  /** Sets the least angle, rad: not above the upper bound. Wakes the constraint if changed. */
  setLowerBound(lowerBound: number): void {
    this.setLower(lowerBound);
  }

  /** The greatest angle, rad. */
  getUpperBound(): number {
    return this.upper;
  }

  /** Sets the greatest angle, rad: not below the lower bound. Wakes the constraint if changed. */
  setUpperBound(upperBound: number): void {
    this.setUpper(upperBound);
  }

  /** @internal */
  measure(pose: Float64Array, out: Float64Array, c: number, j: number): void {
    out[c] = this.ratio * pose[POSE + ANGLE]! - pose[ANGLE]!;
    out[j + ROW_AW] = -1;
    out[j + ROW_BW] = this.ratio;
  }
}
