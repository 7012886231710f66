import { RigidBody } from '../body.js';
import * as g from '../collide/layout.js';
import { reset } from '../collide/manifold.js';
import { mixElasticity, mixFriction } from '../material.js';
import { type NumberSink, type Vec2, type Vec3, vec2, vec3 } from '../math/vectors.js';
import type { Shape } from '../shape/shape.js';
import { POLYGON } from '../shape/shape-kind.js';
import { boolean, instance, nonNegative, notNaN } from '../validate.js';
import { atEnd, normalAtEnd } from './at-end.js';
import {
  ACCEPTED,
  AWAKE,
  DEAD,
  FIXED,
  FRESH,
  LISTED,
  NEAR,
  PERSISTENT,
  SENSOR,
  SHOWN,
  USED,
  USED_BEFORE,
} from './bits.js';
import { Contact } from './contact.js';
import * as c from './layout.js';
import { PairState } from './pair-state.js';

/** Bits of `fixed`: which of the combined material values were set by hand. */
const FIXED_ELASTICITY = 1;
const FIXED_STATIC = 2;
const FIXED_DYNAMIC = 4;
const FIXED_ROLLING = 8;

/** [jx, jy, jw], written by `sumImpulses`: scratch. */
const sum = /* @__PURE__ */ new Float64Array(3);

/** Zeroes the impulses of a point, 0 or 1, in the record of a pair: the point is new. */
export function clearPoint(n: Float64Array, o: number, which: number): void {
  const from = o + c.NORMAL + c.IMPULSES * which;
  n.fill(0, from, from + c.IMPULSES);
}

/** The impulses of a pair from before it was collided a second time within a step: linear on body B, angular on each body. */
export interface EarlierImpulses {
  step: number;
  x: number;
  y: number;
  wA: number;
  wB: number;
}

/** A manifold as it was at the end of a step, kept because a body has been moved by hand since. */
export interface HeldManifold {
  step: number;
  /** The normal, then position and penetration of the first point and of the second. */
  readonly numbers: Float64Array;
}

/**
 * The interaction of two shapes: contacts, impulses, combined material. Made and recycled by the engine: read it from
 * `world.dynamicArbiters`, `world.staticArbiters`, `shape.arbiters` and event handlers, and do not keep it beyond the next step.
 */
export class Arbiter extends PairState {
  /** Of the class, as in Turbulenz. */
  static get version(): number {
    return 1;
  }

  /** @internal links the list that begins at `shape.grounds` of its dynamic shape; in the pool, the next free arbiter */
  next: Arbiter | null = null;
  /** @internal index in shapeA.arbiters */
  indexA = -1;
  /** @internal index in shapeB.arbiters */
  indexB = -1;
  /** @internal the impulses from before the pair was collided a second time within a step; valid if `metAgain` */
  before: EarlierImpulses | null = null;
  /** @internal the manifold at the end of a step, if a body was moved by hand since: see `at-end.ts`; valid if `isHeld` */
  held: HeldManifold | null = null;
  /** The array behind `contacts`, and the two objects it is filled with. Made on first use: most pairs are never asked. */
  private seenPoints: { readonly list: Contact[]; readonly points: readonly Contact[] } | null = null;

  /** @internal how many points the manifold has, 0 to 2 */
  get count(): number {
    return this.numbers[this.at + g.COUNT]! | 0;
  }

  /** The body of `shapeA`. In an `end` handler, if the shape was removed from its body: the body it was on, unless it is on another by now. */
  get bodyA(): RigidBody {
    return this.shapeA.owner ?? this.shapeA.former!;
  }

  /** The body of `shapeB`; likewise. */
  get bodyB(): RigidBody {
    return this.shapeB.owner ?? this.shapeB.former!;
  }

  /**
   * Up to two contact points. Of two, the second lies farther along (−ny, nx), the normal turned by a right angle. Skip those that are not
   * `active`.
   */
  get contacts(): Contact[] {
    this.seenPoints ??= { list: [], points: [new Contact(this, 0), new Contact(this, 1)] };
    const { list, points } = this.seenPoints;
    if (list.length !== this.shown) {
      list.length = 0;
      for (let i = 0; i < this.shown; i += 1) {
        list.push(points[i]!);
      }
    }
    return list;
  }

  /** Unit vector from `shapeA` towards `shapeB`, at the end of the step; `[0, 0]` for a sensor. */
  getNormal(): Vec2;
  getNormal<T extends NumberSink>(dst: T): T;
  getNormal<T extends NumberSink>(dst?: T): T | Vec2 {
    normalAtEnd(this);
    return vec2(atEnd.nx, atEnd.ny, 'Arbiter.getNormal', dst);
  }

  /** The rolling impulse of the latest step, N·m·s; 0 unless a circle is involved. */
  getRollingImpulse(): number {
    return this.numbers[this.at + c.STEP_ROLL]!;
  }

  /**
   * The impulse `[jx, jy, jw]` that a body received in the latest step, N·s and N·m·s, jw about the body's origin; zeros for any other
   * body. With two contacts, the share of friction in jw is the sum over both as each reports it. It may be some per cent off where one
   * contact is deeper than the other, as the solver has one friction for both.
   */
  getImpulseForBody(body: RigidBody): Vec3;
  getImpulseForBody<T extends NumberSink>(body: RigidBody, dst: T): T;
  getImpulseForBody<T extends NumberSink>(body: RigidBody, dst?: T): T | Vec3 {
    instance('Arbiter.getImpulseForBody', 'body', body, RigidBody, 'a RigidBody');
    const sign = body === this.bodyA ? -1 : body === this.bodyB ? 1 : 0;
    if (sign === 0 || !this.active) {
      return vec3(0, 0, 0, 'Arbiter.getImpulseForBody', dst);
    }
    this.sumImpulses(sign);
    return vec3(sum[0]!, sum[1]!, sum[2]!, 'Arbiter.getImpulseForBody', dst);
  }

  /** Sums the impulses of this step that body B (`sign` 1) or body A (−1) received, into `sum`. */
  private sumImpulses(sign: number): void {
    const { numbers: n, at: o } = this;
    const ofB = sign > 0 ? 1 : 0;
    let x = 0;
    let y = 0;
    let w = 0;
    w += sign * n[o + c.STEP_ROLL]!;
    const { before } = this;
    if (this.metAgain()) {
      x += sign * before!.x;
      y += sign * before!.y;
      w += ofB === 1 ? before!.wB : before!.wA;
    }
    // The arms are those the solver used, not those at the end of the step: of circles to the surface, if they were apart.
    const half = hasCircle(this) ? sign * 0.5 * Math.max(0, n[o + g.S0]!) : 0;
    for (let i = 0; i < this.shown; i += 1) {
      const normal = sign * n[o + c.STEP_NORMAL + c.IMPULSES * i]!;
      const tangent = sign * n[o + c.STEP_TANGENT + c.IMPULSES * i]!;
      const jx = n[o + g.NX]! * normal - n[o + g.NY]! * tangent;
      const jy = n[o + g.NY]! * normal + n[o + g.NX]! * tangent;
      const armX = n[o + g.X0 + g.POINT * i]! - ofB * n[o + g.DX]! + half * n[o + g.NX]!;
      const armY = n[o + g.Y0 + g.POINT * i]! - ofB * n[o + g.DY]! + half * n[o + g.NY]!;
      w += armX * jy - armY * jx;
      x += jx;
      y += jy;
    }
    sum[0] = x;
    sum[1] = y;
    sum[2] = w;
  }

  /** The combined elasticity: mixed from both materials unless set by hand; `undefined` for a sensor. */
  getElasticity(): number | undefined {
    return this.material(c.ELASTICITY);
  }

  /** As `getElasticity`. */
  getStaticFriction(): number | undefined {
    return this.material(c.STATIC_FRICTION);
  }

  /** As `getElasticity`. */
  getDynamicFriction(): number | undefined {
    return this.material(c.DYNAMIC_FRICTION);
  }

  /** As `getElasticity`, m. */
  getRollingFriction(): number | undefined {
    return this.material(c.ROLLING_FRICTION);
  }

  /**
   * Fixes the combined elasticity: any number, ±Infinity as in a material. It holds until `setElasticityFromShapes`, or for the life of the
   * arbiter, which ends 30 steps after the shapes part. Outside a step, wakes both bodies without an event.
   */
  setElasticity(elasticity: number): void {
    const given = notNaN('Arbiter.setElasticity', 'elasticity', elasticity);
    this.fix(FIXED_ELASTICITY, c.ELASTICITY, Number.isFinite(given) ? given : mixElasticity(given, given));
  }

  /** As `setElasticity`, >= 0. */
  setStaticFriction(friction: number): void {
    this.fix(FIXED_STATIC, c.STATIC_FRICTION, nonNegative('Arbiter.setStaticFriction', 'friction', friction));
  }

  /** As `setElasticity`, >= 0. */
  setDynamicFriction(friction: number): void {
    this.fix(FIXED_DYNAMIC, c.DYNAMIC_FRICTION, nonNegative('Arbiter.setDynamicFriction', 'friction', friction));
  }

  /** As `setElasticity`, m, >= 0. */
  setRollingFriction(friction: number): void {
    this.fix(FIXED_ROLLING, c.ROLLING_FRICTION, nonNegative('Arbiter.setRollingFriction', 'friction', friction));
  }

  /** Mixes the elasticity from the shapes' materials again. */
  setElasticityFromShapes(): void {
    this.release(FIXED_ELASTICITY);
  }

  /** Back to what the materials come to. */
  setStaticFrictionFromShapes(): void {
    this.release(FIXED_STATIC);
  }

  /** Back to what the materials come to. */
  setDynamicFrictionFromShapes(): void {
    this.release(FIXED_DYNAMIC);
  }

  /** Back to what the materials come to. */
  setRollingFrictionFromShapes(): void {
    this.release(FIXED_ROLLING);
  }

  /** Whether the collision is accepted, and so takes effect. */
  isStateAccepted(): boolean {
    return this.is(ACCEPTED);
  }

  /** Whether the accepted state is persistent: holds until the interaction ends. */
  isStatePersistent(): boolean {
    return this.is(PERSISTENT);
  }

  /** Accepts or rejects the collision. Reset to accepted in every step, unless persistent. */
  setAcceptedState(accepted: boolean): void {
    boolean('Arbiter.setAcceptedState', 'accepted', accepted);
    if (!this.sensor) {
      this.put(ACCEPTED, accepted);
      this.rouse();
    }
  }

  /** Makes the accepted state persistent: it holds until the interaction ends, and `preSolve` handlers are not called again. */
  setPersistentState(persistent: boolean): void {
    boolean('Arbiter.setPersistentState', 'persistent', persistent);
    if (!this.sensor) {
      this.put(PERSISTENT, persistent);
      this.rouse();
    }
  }

  /** @internal mixes the materials, except for values set by hand */
  mixMaterials(): void {
    const a = this.shapeA.material;
    const b = this.shapeB.material;
    const { numbers: n, at: o } = this;
    const fixed = this.fixed;
    if ((fixed & FIXED_ELASTICITY) === 0) n[o + c.ELASTICITY] = mixElasticity(a.elasticity, b.elasticity);
    if ((fixed & FIXED_STATIC) === 0) n[o + c.STATIC_FRICTION] = mixFriction(a.staticFriction, b.staticFriction);
    if ((fixed & FIXED_DYNAMIC) === 0) n[o + c.DYNAMIC_FRICTION] = mixFriction(a.dynamicFriction, b.dynamicFriction);
    if ((fixed & FIXED_ROLLING) === 0) n[o + c.ROLLING_FRICTION] = mixFriction(a.rollingFriction, b.rollingFriction);
  }

  /** @internal makes a recycled object the arbiter of a new pair */
  reuse(shapeA: Shape, shapeB: Shape): void {
    this.shapeA = shapeA;
    this.shapeB = shapeB;
    this.bits = shapeA.sensor || shapeB.sensor ? SENSOR : 0;
    reset(this.numbers, this.at);
    this.began = -1;
    this.calm();
    this.lastInteraction = -1;
    this.seen = -1;
    this.revive();
    this.forget();
  }

  /** @internal resets what a snapshot does not hold; in a world that is being restored, what it does hold is set next */
  revive(): void {
    this.unmark(DEAD | AWAKE | NEAR);
    this.foreseen = 0;
    this.before = null;
    this.held = null;
  }

  /** @internal drops what lasts only as long as the interaction runs or is cached */
  forget(): void {
    this.dropPoints();
    this.unmark(PERSISTENT | (3 << SHOWN) | (15 << FIXED));
    this.put(ACCEPTED, !this.sensor);
  }

  /**
   * @internal the pair is collided a second time in this step: keeps the sum of the impulses so far, in a spare object if there is one, and
   * drops the points
   */
  meetAgain(spare: EarlierImpulses[]): void {
    this.sumImpulses(-1);
    const wA = sum[2]!;
    this.sumImpulses(1);
    this.before ??= spare.pop() ?? null;
    this.noteBefore(sum[0]!, sum[1]!, wA, sum[2]!);
    this.clearPoints();
  }

  /**
   * @internal N·s along (x, y) that body B received before the pair was collided again in the latest step: the share of one point, split as
   * the normal impulses since are, or in equal parts. A point that was not used since is virtual, and has none.
   */
  shareBefore(which: number, x: number, y: number): number {
    if (!this.active || !this.metAgain()) {
      return 0;
    }
    const { numbers: n, at: o, before, usedPoints } = this;
    const both = n[o + c.STEP_NORMAL]! + n[o + c.STEP_NORMAL + c.IMPULSES]!;
    const equal = usedPoints === 3 ? 0.5 : (usedPoints >> which) & 1;
    const share = both > 0 ? n[o + c.STEP_NORMAL + c.IMPULSES * which]! / both : equal;
    return share * (before!.x * x + before!.y * y);
  }

  /** @internal sets `before` for the latest step */
  noteBefore(x: number, y: number, wA: number, wB: number): void {
    this.before ??= { step: 0, x: 0.5, y: 0.5, wA: 0.5, wB: 0.5 };
    const { before } = this;
    before.step = this.lastInteraction;
    before.x = x;
    before.y = y;
    before.wA = wA;
    before.wB = wB;
  }

  /** @internal whether the pair was collided a second time in the latest step, so that `before` counts */
  metAgain(): boolean {
    return this.before !== null && this.before.step === this.lastInteraction;
  }

  /** @internal whether `held` is the manifold at the end of the latest step */
  isHeld(): boolean {
    return this.held !== null && this.held.step === this.lastInteraction;
  }

  /** @internal makes `held` that of the latest step. @returns its numbers, for the caller to write. */
  hold(): Float64Array {
    this.held ??= { step: -1, numbers: new Float64Array(c.HELD_NUMBERS) };
    this.held.step = this.lastInteraction;
    return this.held.numbers;
  }

  /** @internal lists the points of the manifold as new ones, without impulses */
  showPoints(): void {
    this.dropPoints();
    this.bits = (this.bits & ~(3 << SHOWN)) | (this.count << SHOWN);
  }

  /** @internal drops the impulses of both points */
  dropPoints(): void {
    this.clearPoints();
    this.unmark(3 << USED_BEFORE);
  }

  /** Nothing is known of them but whether they were used before this step. */
  private clearPoints(): void {
    const { numbers, at } = this;
    // Not by `fill`, which takes longer for so few.
    for (let i = at + c.NORMAL; i < at + c.ELASTICITY; i += 1) {
      numbers[i] = 0;
    }
    this.unmark((3 << USED) | (3 << FRESH));
  }

  /** @internal zeroes the impulses of this step; those that warm start the next one stay */
  idle(): void {
    const { numbers: n, at: o } = this;
    n[o + c.STEP_NORMAL] = 0;
    n[o + c.STEP_TANGENT] = 0;
    n[o + c.STEP_NORMAL + c.IMPULSES] = 0;
    n[o + c.STEP_TANGENT + c.IMPULSES] = 0;
    n[o + c.STEP_ROLL] = 0;
    this.unmark(3 << FRESH);
  }

  private material(at: number): number | undefined {
    return this.sensor ? undefined : this.numbers[this.at + at];
  }

  private fix(which: number, at: number, value: number): void {
    if (!this.sensor) {
      this.numbers[this.at + at] = value;
      this.mark(which << FIXED);
      this.rouse();
    }
  }

  private release(which: number): void {
    if (!this.sensor) {
      this.unmark(which << FIXED);
      this.mixMaterials();
      this.rouse();
    }
  }

  /** Wakes both bodies; not if the arbiter is only kept for its `end` event, as its shapes may be anywhere by then. */
  private rouse(): void {
    const world = this.is(LISTED) ? this.bodyA.owner : null;
    if (world !== null && !world.stepping) {
      world.wakeBoth(this);
    }
  }
}

/** @internal whether one of the shapes is a circle, so that there is one point */
export function hasCircle({ shapeA, shapeB }: Arbiter): boolean {
  return shapeA.kind !== POLYGON || shapeB.kind !== POLYGON;
}
