import type { Tape } from '../state/tape.js';
import { finite, optional } from '../validate.js';
import { checkedRatio, TwoBodyConstraint, type TwoBodyParams } from './two-body.js';

/** Options of `createMotorConstraint`. */
export interface MotorConstraintParams extends TwoBodyParams {
  /** Turns of body A for one of body B, not 0. Default 1. */
  ratio?: number | undefined;
  /** rad/s. Default 0. */
  rate?: number | undefined;
}

/**
 * Two bodies turn against each other at a rate, as far as `maxForce`, here a torque, can drive them.
 *
 *     ratio · ωB − ωA = rate
 */
export class MotorConstraint extends TwoBodyConstraint {
  /** Tells the kinds apart. */
  readonly type = 'MOTOR';

  private rate: number;

  /** @internal use `createMotorConstraint` */
  constructor(params: MotorConstraintParams) {
    const where = 'createMotorConstraint';
    super(where, 1, params);
    this.ratio = checkedRatio(where, optional(params.ratio, 1));
    this.rate = finite(where, 'rate', optional(params.rate, 0));
    this.positional = false;
  }

  /** Turns of body A for one of body B. */
  getRatio(): number {
    return this.ratio;
  }

  /** Sets the ratio, not 0. */
  setRatio(ratio: number): void {
    this.changeRatio(ratio);
  }

  /** rad/s. */
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
    out[j + 2] = -1;
    out[j + 5] = this.ratio;
  }
}
