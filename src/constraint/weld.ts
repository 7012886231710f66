import { FAR } from '../config.js';
import type { Tape } from '../state/tape.js';
import { optional, within } from '../validate.js';
import { ANGLE, POSE, ROW_AW, ROW_BW, ROW_SIZE } from './layout.js';
import { pointRows } from './point.js';
import { AnchoredConstraint, type TwoAnchorParams } from './two-body.js';

/** Options of `createWeldConstraint`. */
export interface WeldConstraintParams extends TwoAnchorParams {
  /** The rotation of body B minus that of body A, rad, not wrapped. Default 0. */
  phase?: number | undefined;
}

/**
 * Holds a point of one body on a point of another, and the angle between the bodies. Rotations are not wrapped: a body that has turned by
 * 2π is 2π away.
 *
 *     C = (wB − wA, θB − θA − phase) = 0,   w = x + R(θ) · anchor
 */
export class WeldConstraint extends AnchoredConstraint {
  /** Tells the kinds apart. */
  readonly type = 'WELD';

  private phase: number;

  /** @internal use `createWeldConstraint` */
  constructor(params: WeldConstraintParams) {
    super('createWeldConstraint', 3, params);
    this.phase = within('createWeldConstraint', 'phase', optional(params.phase, 0), FAR);
  }

  /** The angle that the bodies keep, rad. */
  getPhase(): number {
    return this.phase;
  }

  /** Sets the angle that the bodies keep, rad. Wakes the constraint if changed. */
  setPhase(phase: number): void {
    within('WeldConstraint.setPhase', 'phase', phase, FAR);
    if (phase !== this.phase) {
      this.phase = phase;
      this.rouse();
    }
  }

  /** @internal */
  override keep(tape: Tape): void {
    this.phase = tape.number(this.phase);
    super.keep(tape);
  }

  /** @internal */
  measure(pose: Float64Array, out: Float64Array, c: number, j: number): void {
    pointRows(pose, this.anchors, out, c, j);
    out[c + 2] = pose[POSE + ANGLE]! - pose[ANGLE]! - this.phase;
    out[j + 2 * ROW_SIZE + ROW_AW] = -1;
    out[j + 2 * ROW_SIZE + ROW_BW] = 1;
  }
}
