import type { Tape } from '../state/tape.js';
import { finite, optional } from '../validate.js';
import { ROW_AW, ROW_BW } from './layout.js';
import { RatioConstraint, type RatioParams } from './two-body.js';

/** Options of `createMotorConstraint`. */
export interface MotorConstraintParams extends RatioParams {
  /** How fast body B is to turn against body A, rad/s. Default 0. */
  rate?: number | undefined;
}

/**
 * A motor: turns two bodies against each other at a rate, as far as `maxForce`, here a torque, can drive them. At a bound of a rigid angle
 * constraint between the same two bodies it rests.
 *
 *     ratio · ωB − ωA = rate
 */
export class MotorConstraint extends RatioConstraint {
  /** Tells the kinds apart. */
  readonly type = 'MOTOR';

  private rate: number;

  /** @internal use `createMotorConstraint` */
  constructor(params: MotorConstraintParams) {
    const where = 'createMotorConstraint';
    super(where, params);
    this.rate = finite(where, 'rate', optional(params.rate, 0));
    this.positional = false;
  }

  /** The target rate, rad/s. */
  getRate(): number {
    return this.rate;
  }

  /** Sets the rate, rad/s. Wakes the constraint if changed. */
  setRate(rate: number): void {
    finite('MotorConstraint.setRate', 'rate', rate);
    if (rate !== this.rate) {
      this.rate = rate;
      this.rouse();
    }
  }

  /** @internal */
  override get drives(): boolean {
    return this.rate !== 0;
  }

  /** @internal */
  override keep(tape: Tape): void {
    this.rate = tape.number(this.rate);
    super.keep(tape);
  }

  /** @internal */
  measure(_pose: Float64Array, out: Float64Array, c: number, j: number): void {
    out[c] = -this.rate;
    out[j + ROW_AW] = -1;
    out[j + ROW_BW] = this.ratio;
  }
}
