import { type NumberSink, type Vec2, type Vec2Like, vec2 } from '../math/vectors.js';
import type { Tape } from '../state/tape.js';
import { rangeError, vector } from '../validate.js';
import { COS, POSE, ROW_AW, ROW_AX, ROW_AY, ROW_BW, ROW_BX, ROW_BY, ROW_SIZE, SIN, X, Y } from './layout.js';
import { BoundedConstraint, type Bounds, type TwoAnchorParams, takeBounds } from './two-body.js';

/** Options of `createLineConstraint`: bounds in m, none by default. */
export interface LineConstraintParams extends TwoAnchorParams, Bounds {
  /** Direction of the line in the coordinates of body A, of any length but 0. */
  axis: Vec2Like;
}

/**
 * Keeps a point of body B on a line of body A, within bounds along it: a slider, a wheel's guide.
 *
 *     C = a × d = 0,   lower ≤ a·d ≤ upper,   a = R(θA) · axis,   d = wB − wA
 *     J = [a.y, −a.x, −arm·a, −a.y, a.x, rB·a;  −a, −arm × a, a, rB × a],   arm = rA + d
 *
 * The line turns with body A, which receives the impulse at B's anchor: so its arm leads there.
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

  /** The direction of the line, a unit vector in the coordinates of body A. */
  getAxis(): Vec2;
  getAxis<T extends NumberSink>(dst: T): T;
  getAxis<T extends NumberSink>(dst?: T): T | Vec2 {
    return vec2(this.axisX, this.axisY, 'LineConstraint.getAxis', dst);
  }

  /** Sets the direction of the line, in the coordinates of body A, of any length; a zero vector is ignored. Wakes the constraint if changed. */
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
    out[j + ROW_AX] = ay;
    out[j + ROW_AY] = -ax;
    out[j + ROW_AW] = -armY * ay - armX * ax;
    out[j + ROW_BX] = -ay;
    out[j + ROW_BY] = ax;
    out[j + ROW_BW] = bx * ax + by * ay;
    const k = j + ROW_SIZE;
    out[k + ROW_AX] = -ax;
    out[k + ROW_AY] = -ay;
    out[k + ROW_AW] = armY * ax - armX * ay;
    out[k + ROW_BX] = ax;
    out[k + ROW_BY] = ay;
    out[k + ROW_BW] = bx * ay - by * ax;
  }
}

/** An axis scaled so that its length neither overflows nor vanishes, and that length. */
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
