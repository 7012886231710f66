import type { RigidBody } from '../body.js';
import { MAX_SIZE } from '../config.js';
import { CENTRE_X, CENTRE_Y, CIRCLE_NUMBERS } from '../geometry/layout.js';
import type { Outline } from '../geometry/outline.js';
import { type NumberSink, type Vec2, type Vec2Like, vec2 } from '../math/vectors.js';
import { options, positive, vector, within } from '../validate.js';
import { BaseShape, type ShapeParams } from './shape.js';
import { CIRCLE } from './shape-kind.js';

/** By how much the determinant of a rotation may differ from 1 by rounding. */
const ROUNDING = 1e-15;

/** Options of `createCircleShape`. */
export interface CircleParams extends ShapeParams {
  /** Radius, m, > 0, at most 1e75. */
  radius: number;
  /** Centre in body coordinates, m, each coordinate at most 1e75. Default `[0, 0]`. */
  origin?: Vec2Like | undefined;
}

/** A circle: a solid disc. */
export class Circle extends BaseShape {
  /** Of the class, as in Turbulenz. */
  static get version(): number {
    return 1;
  }

  /** The kind of shape. */
  readonly type = 'CIRCLE';

  /** @internal */
  declare readonly kind: typeof CIRCLE;
  /** @internal */
  originX: number;
  /** @internal */
  originY: number;

  /** @internal use `createCircleShape` */
  constructor(params: CircleParams) {
    const where = 'createCircleShape';
    const given = options(where, params, true);
    const radius = checkedRadius(where, given.radius);
    const origin = given.origin === undefined ? [0, 0] : vector(where, 'origin', given.origin, 2, MAX_SIZE);
    super(where, given, CIRCLE, CIRCLE_NUMBERS);
    this.radius = radius;
    this.originX = origin[0]!;
    this.originY = origin[1]!;
  }

  /** The radius, m. */
  getRadius(): number {
    return this.radius;
  }

  /** Sets the radius, m, > 0. Ignored during a step and for a static body in a world. Wakes the body if changed. */
  setRadius(radius: number): void {
    checkedRadius('Circle.setRadius', radius);
    if (this.isLocked() || radius === this.radius) {
      return;
    }
    this.radius = radius;
    this.geometryChanged();
  }

  /** The centre in body coordinates, m. */
  getOrigin(): Vec2;
  getOrigin<T extends NumberSink>(dst: T): T;
  getOrigin<T extends NumberSink>(dst?: T): T | Vec2 {
    return vec2(this.originX, this.originY, 'Circle.getOrigin', dst);
  }

  /** Sets the centre in body coordinates, m. Ignored as `setRadius` is. Wakes the body if changed. */
  setOrigin(origin: Vec2Like): void {
    vector('Circle.setOrigin', 'origin', origin, 2, MAX_SIZE);
    if (this.isLocked() || (origin[0] === this.originX && origin[1] === this.originY)) {
      return;
    }
    this.originX = origin[0]!;
    this.originY = origin[1]!;
    this.geometryChanged();
  }

  override computeArea(): number {
    return Math.PI * this.radius * this.radius;
  }

  override computeMasslessInertia(): number {
    return 0.5 * this.radius * this.radius + this.originX * this.originX + this.originY * this.originY;
  }

  override computeCenterOfMass(): Vec2;
  override computeCenterOfMass<T extends NumberSink>(dst: T): T;
  override computeCenterOfMass<T extends NumberSink>(dst?: T): T | Vec2 {
    return vec2(this.originX, this.originY, 'Circle.computeCenterOfMass', dst);
  }

  override clone(): this {
    const origin: Vec2 = [this.originX, this.originY];
    return new Circle({ ...this.commonParams(), radius: this.radius, origin }) as this;
  }

  /** @internal */
  override place(body: RigidBody): void {
    const { x, y, cos: c, sin: s } = body;
    const cx = c * this.originX - s * this.originY;
    const cy = s * this.originX + c * this.originY;
    const { numbers: n, at: o } = this;
    n[o] = x + cx - this.radius;
    n[o + 1] = y + cy - this.radius;
    n[o + 2] = x + cx + this.radius;
    n[o + 3] = y + cy + this.radius;
    n[o + CENTRE_X] = cx;
    n[o + CENTRE_Y] = cy;
  }

  /** @internal */
  override outline(into: Outline): void {
    const { x, y, cos, sin, corners } = into;
    into.setCircle(this.radius);
    corners[0] = x + cos * this.originX - sin * this.originY;
    corners[1] = y + sin * this.originX + cos * this.originY;
  }

  /** @internal */
  override reach(): number {
    return Math.sqrt(this.originX * this.originX + this.originY * this.originY) + this.radius;
  }

  /** @internal */
  override isRound(): boolean {
    return this.originX === 0 && this.originY === 0;
  }

  /** @internal */
  protected override mapGeometry(m: ArrayLike<number>): boolean {
    const { originX, originY } = this;
    const area = m[0]! * m[3]! - m[2]! * m[1]!;
    // Of a rotation it is 1: what rounding makes of it would add up over many.
    const radius = this.radius * (Math.abs(area - 1) < ROUNDING ? 1 : Math.sqrt(area));
    const x = m[0]! * originX + m[2]! * originY + m[4]!;
    const y = m[1]! * originX + m[3]! * originY + m[5]!;
    if (!(radius > 0 && Math.max(radius, Math.abs(x), Math.abs(y)) <= MAX_SIZE)) {
      return false;
    }
    this.radius = radius;
    this.originX = x;
    this.originY = y;
    return true;
  }
}

function checkedRadius(where: string, value: unknown): number {
  return within(where, 'radius', positive(where, 'radius', value), MAX_SIZE);
}
