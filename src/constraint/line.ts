import { type NumberSink, type Vec2, type Vec2Like, vec2 } from '../math/vectors.js';
import type { Tape } from '../state/tape.js';
import { rangeError, vector } from '../validate.js';
import { COS, POSE, SIN, X, Y } from './layout.js';
import { BoundedConstraint, type Bounds, type TwoAnchorParams, takeBounds } from './two-body.js';

/** Options of `createLineConstraint`: bounds in m, none by default. */
export interface LineConstraintParams extends TwoAnchorParams, Bounds {
  /** Direction of the line in body A coordinates, of any length but 0. */
  axis: Vec2Like;
}

/**
 * A point of body B stays on a line of body A, between bounds along it: a slider, a wheel's guide.
 *
 *     C = a × d = 0,   lower ≤ a·d ≤ upper,   a = R(θA) · axis,   d = wB − wA
 *
 * Body A gets the impulse at B's anchor, so its arm is rA + d.
 */
export class LineConstraint extends BoundedConstraint {
  /** Tells the kinds apart. */
  readonly type = 'LINE';

  private axisX: number;
  private axisY: number;

  /** @internal use `createLineConstraint` */
  constructor(params: LineConstraintParams) {
    const where = 'createLineConstraint';
    super(where, 2, params);
    const [x, y, length] = checkedAxis(where, params.axis);
    if (length === 0) {
      throw rangeError(where, 'axis', 'other than [0, 0]', params.axis);
    }
    this.axisX = x / length;
    this.axisY = y / length;
    takeBounds(this, where, params, -Infinity, Infinity);
  }

  /** Unit vector in body A coordinates. */
  getAxis(): Vec2;
  getAxis<T extends NumberSink>(dst: T): T;
  getAxis<T extends NumberSink>(dst?: T): T | Vec2 {
    return vec2(this.axisX, this.axisY, 'LineConstraint.getAxis', dst);
  }

  /** Sets the direction, body A coordinates, of any length; a zero vector is ignored. */
  setAxis(axis: Vec2Like): void {
    const [x, y, length] = checkedAxis('LineConstraint.setAxis', axis);
    if (length > 0 && (x / length !== this.axisX || y / length !== this.axisY)) {
      this.axisX = x / length;
      this.axisY = y / length;
      this.rouse();
    }
  }

  /** @internal */
  override keep(tape: Tape): void {
    this.axisX = tape.number(this.axisX);
    this.axisY = tape.number(this.axisY);
    super.keep(tape);
  }

  /** @internal */
  measure(pose: Float64Array, out: Float64Array, c: number, j: number): void {
    const { anchors, axisX, axisY } = this;
    const cosA = pose[COS]!;
    const sinA = pose[SIN]!;
    const ax = cosA * axisX - sinA * axisY;
    const ay = sinA * axisX + cosA * axisY;
    const bx = pose[POSE + COS]! * anchors[2]! - pose[POSE + SIN]! * anchors[3]!;
    const by = pose[POSE + SIN]! * anchors[2]! + pose[POSE + COS]! * anchors[3]!;
    const armX = pose[POSE + X]! + bx - pose[X]!;
    const armY = pose[POSE + Y]! + by - pose[Y]!;
    const dx = armX - (cosA * anchors[0]! - sinA * anchors[1]!);
    const dy = armY - (sinA * anchors[0]! + cosA * anchors[1]!);
    out[c] = ax * dy - ay * dx;
    out[c + 1] = ax * dx + ay * dy;
    lineRow(out, j, -ay, ax, armX, armY, bx, by);
    lineRow(out, j + 6, ax, ay, armX, armY, bx, by);
  }
}

/** The row of n·d where n turns with A: [−n, −arm × n, n, rB × n]. */
function lineRow(
  out: Float64Array,
  j: number,
  nx: number,
  ny: number,
  armX: number,
  armY: number,
  bx: number,
  by: number,
): void {
  out[j] = -nx;
  out[j + 1] = -ny;
  out[j + 2] = armY * nx - armX * ny;
  out[j + 3] = nx;
  out[j + 4] = ny;
  out[j + 5] = bx * ny - by * nx;
}

/** x, y and length of an axis, computed so that it neither overflows nor vanishes. */
function checkedAxis(where: string, axis: unknown): [x: number, y: number, length: number] {
  const v = vector(where, 'axis', axis, 2);
  const size = Math.max(Math.abs(v[0]!), Math.abs(v[1]!));
  if (size === 0) {
    return [0, 0, 0];
  }
  const x = v[0]! / size;
  const y = v[1]! / size;
  return [x, y, Math.sqrt(x * x + y * y)];
}
