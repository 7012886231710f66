import { ANGLE, POSE } from './layout.js';
import { type Bounds, RatioConstraint, type RatioParams, takeBounds } from './two-body.js';

/** Options of `createAngleConstraint`: bounds in rad, both 0 by default. */
export interface AngleConstraintParams extends RatioParams, Bounds {}

/**
 * The angle between two bodies stays between bounds; with a ratio, a gear. Rotations are not wrapped.
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

  /** rad. */
  getLowerBound(): number {
    return this.lower;
  }

  /** Not above the upper bound. */
  setLowerBound(lowerBound: number): void {
    this.setLower(lowerBound);
  }

  /** rad. */
  getUpperBound(): number {
    return this.upper;
  }

  /** Not below the lower bound. */
  setUpperBound(upperBound: number): void {
    this.setUpper(upperBound);
  }

  /** @internal */
  measure(pose: Float64Array, out: Float64Array, c: number, j: number): void {
    out[c] = this.ratio * pose[POSE + ANGLE]! - pose[ANGLE]!;
    out[j + 2] = -1;
    out[j + 5] = this.ratio;
  }
}
