import type { RigidBody } from '../body.js';
import type { BroadphaseHandle } from '../broadphase/broadphase.js';
import { MAX_SIZE } from '../config.js';
import type { Arbiter } from '../contact/arbiter.js';
import type { Hit } from '../contact/hit.js';
import type { Outline } from '../geometry/outline.js';
import { addListener, bitOf, HIT, type Listeners, NO_LISTENERS, OF_SHAPES, removeListener } from '../listeners.js';
import { DEFAULT_MATERIAL, Material } from '../material.js';
import { Slab } from '../math/doubles.js';
import type { List } from '../math/list.js';
import { cos, sin } from '../math/trig.js';
import type { Matrix23Like, NumberSink, Vec2, Vec2Like } from '../math/vectors.js';
import type { UserDataOf } from '../user-data.js';
import { bits, boolean, callable, finite, instance, nonNegative, optional, rangeError, vector } from '../validate.js';
import type { Circle } from './circle.js';
import type { Polygon } from './polygon.js';
import { CIRCLE, type POLYGON } from './shape-kind.js';

/** Called with `this` = the shape that the handler was added to. */
export type ShapeHandler = (this: Shape, arbiter: Arbiter, otherShape: Shape) => void;

/** Called as a `ShapeHandler`, and told how the collision began. */
export type HitHandler = (this: Shape, arbiter: Arbiter, otherShape: Shape, hit: Hit) => void;

/** The events of a shape, and what their handlers are. */
export interface ShapeEvents {
  /** Two shapes touch for the first time, or again. */
  begin: ShapeHandler;
  /** They touch in another step, and are awake. */
  progress: ShapeHandler;
  /** They do not touch any more, or one of them is gone. */
  end: ShapeHandler;
  /** They are about to collide; the handler may refuse. Called within the step. */
  preSolve: ShapeHandler;
  /** A collision has begun. */
  hit: HitHandler;
}

/** What shapes tell their listeners. */
export type ShapeEventType = keyof ShapeEvents;

/** Options that circles and polygons share. */
export interface ShapeParams {
  /** Reports overlaps and takes part in no collision. Default `false`. */
  sensor?: boolean | undefined;
  /** Default: the default material. */
  material?: Material | undefined;
  /** Bits that say what this shape is. Default 1. */
  group?: number | undefined;
  /** Bits of the groups that this shape meets: two shapes meet if each one's `group` has a bit in the other's `mask`. Default 0xffffffff. */
  mask?: number | undefined;
  /** Anything of yours. Default `null`. */
  userData?: UserDataOf<'shape'> | undefined;
}

/** A circle or a polygon: where `shape.type === 'CIRCLE'` it is the former, and has a radius. */
export type Shape = Circle | Polygon;

/** @internal kernels are looked up by `kind` */
export type ShapeKind = typeof CIRCLE | typeof POLYGON;

let nextId = 0;

/** The numbers of shapes. */
const slab = /* @__PURE__ */ new Slab();

/**
 * A convex piece of a body: where it collides, what it is made of, what it meets. Coordinates are those of the body.
 * After every change of geometry or material the body's mass and inertia follow, unless they were given.
 */
export abstract class BaseShape {
  // What steps ask of thousands comes first, side by side in memory: they wait for every line of it.

  /** @internal */
  owner: RigidBody | null = null;
  /** @internal where its numbers begin in a slab: what follows the placement of the body, see `geometry/layout.ts` */
  at = 0;
  /** @internal the slab */
  numbers: Float64Array = slab.numbers;
  /** Tells what passes, and collides with nothing. */
  readonly sensor: boolean = false;
  /** @internal of 32 bits with a sign, as it is compared */
  group = 0;
  /** @internal */
  mask = 0;
  /** @internal m. How far the surface is from the corners: that of a circle from its centre, 0 of a polygon. Both have it, as what may be missing is boxed */
  radius = 0;
  /** @internal */
  handle: BroadphaseHandle | null = null;
  /** @internal the first of the pairs with the static and kinematic shapes that this one, if dynamic, lies on or near */
  grounds: Arbiter | null = null;
  /** @internal the step in which they were found */
  groundStamp = -1;
  /** Grows with creation order, unique in the program. The lower id of a pair is `shapeA`. */
  readonly id: number = nextId;
  /** Arbiters of the interactions this shape takes part in, or did within the last 30 steps. Do not modify. */
  readonly arbiters: Arbiter[] = [];
  /** @internal */
  listeners: Listeners<HitHandler> = NO_LISTENERS;
  /** @internal others that it may be paired with, while the broadphase reports: see `Crowd` */
  partners: List<Shape> | null = null;
  /** @internal when it came into its world; grows with each body, shape and constraint. Keeps its name */
  order = 0;
  /** @internal the last step before it came into its world */
  entered = -1;
  /** @internal the body that it was on last, for whoever is told that an interaction ended by that */
  former: RigidBody | null = null;
  /** @internal its place while the state of the world is walked over */
  stateIndex = 0;
  /** @internal */
  material: Material;
  /** Anything of yours. */
  userData: UserDataOf<'shape'>;
  /** Tells circles from polygons. */
  abstract readonly type: 'CIRCLE' | 'POLYGON';

  /** @internal */
  constructor(
    where: string,
    params: Partial<ShapeParams>,
    /** @internal kernels are looked up by it */
    readonly kind: ShapeKind,
    count: number,
  ) {
    this.sensor = boolean(where, 'sensor', optional(params.sensor, false));
    this.material =
      params.material === undefined
        ? DEFAULT_MATERIAL
        : instance(where, 'material', params.material, Material, 'a Material');
    this.group = bits(where, 'group', optional(params.group, 1)) | 0;
    this.mask = bits(where, 'mask', optional(params.mask, 0xffffffff)) | 0;
    this.userData = params.userData === undefined ? null : params.userData;
    this.resize(count);
    nextId += 1;
  }

  /** @internal takes room for another count of numbers */
  protected resize(count: number): void {
    this.at = slab.take(count);
    this.numbers = slab.numbers;
  }

  /** The body this shape is attached to, or `null`. */
  get body(): RigidBody | null {
    return this.owner;
  }

  /** Bits that the masks of others are compared with. */
  getGroup(): number {
    return this.group >>> 0;
  }

  /** Sets the bits that say what this shape is. Wakes the body; if that is static, what rests on it; and what sleeps in a sensor. */
  setGroup(group: number): void {
    this.changeFilter(bits('Shape.setGroup', 'group', group) | 0, this.mask);
  }

  /** Which groups it meets. */
  getMask(): number {
    return this.mask >>> 0;
  }

  /** Sets the bits of the groups that this shape meets. Wakes as `setGroup` does. */
  setMask(mask: number): void {
    this.changeFilter(this.group, bits('Shape.setMask', 'mask', mask) | 0);
  }

  /** What sleeps in a sensor, or where a collision was rejected, wakes as what rests on it, so that it is told that this is over. */
  private changeFilter(group: number, mask: number): void {
    const isOther = this.setFilter(group, mask);
    this.owner?.rouse();
    for (const pair of this.arbiters) {
      if (isOther && pair.sleeping) this.owner!.owner!.wakeBoth(pair);
    }
  }

  /** @internal sets both, of 32 bits with a sign; in a world pairs that were left out for them may interact now. @returns whether they are others */
  setFilter(group: number, mask: number): boolean {
    const isOther = group !== this.group || mask !== this.mask;
    const world = this.handle !== null && isOther ? this.owner!.owner! : null;
    world?.changeFilters();
    this.group = group;
    this.mask = mask;
    world?.broadphase.refilter?.(this.handle!);
    return isOther;
  }

  /** What it is made of. */
  getMaterial(): Material {
    return this.material;
  }

  /** Replaces the material; running contacts follow. Wakes the body if it is another one. */
  setMaterial(material: Material): void {
    instance('Shape.setMaterial', 'material', material, Material, 'a Material');
    if (material === this.material) {
      return;
    }
    this.material = material;
    for (const arbiter of this.arbiters) {
      arbiter.mixMaterials();
    }
    this.owner?.shapesChanged();
    this.owner?.rouse();
  }

  /** Area, m². */
  abstract computeArea(): number;

  /** Second moment of area about the body origin, over the area, m². */
  abstract computeMasslessInertia(): number;

  /** Centre of area in body coordinates, m. */
  abstract computeCenterOfMass(): Vec2;
  abstract computeCenterOfMass<T extends NumberSink>(dst: T): T;

  /** An equal shape with a new id, the same `userData`, no body and no listeners. */
  abstract clone(): this;

  /**
   * Scales about the body origin. A circle uses `scaleX` alone. Nothing happens for factors ≤ 0, during a step, or for a
   * static body in a world. Wakes the body.
   *
   * @throws RangeError, as `translate`, `rotate` and `transform`, if corners would coincide, no area were left, or a corner were farther than 1e75 m from the body origin.
   */
  scale(scaleX: number, scaleY: number = scaleX): void {
    finite('Shape.scale', 'scaleX', scaleX);
    finite('Shape.scale', 'scaleY', scaleY);
    if (this.isLocked() || scaleX <= 0 || (this.type === 'POLYGON' && scaleY <= 0)) {
      return;
    }
    const other = this.type === 'POLYGON' ? scaleY : scaleX;
    // The one that does more is to blame.
    const isOther = Math.max(other, 1 / other) > Math.max(scaleX, 1 / scaleX);
    this.map('Shape.scale', isOther ? 'scaleY' : 'scaleX', isOther ? other : scaleX, [scaleX, 0, 0, other, 0, 0]);
  }

  /** Moves the shape within its body. Ignored during a step and for a static body in a world. Wakes the body. */
  translate(translation: Vec2Like): void {
    vector('Shape.translate', 'translation', translation, 2);
    if (this.isLocked()) {
      return;
    }
    this.map('Shape.translate', 'translation', translation, [1, 0, 0, 1, translation[0]!, translation[1]!]);
  }

  /** @internal whether it may be moved by so much: from very far away corners would coincide */
  staysWhole(x: number, y: number): boolean {
    return this.clone().mapGeometry([1, 0, 0, 1, x, y]);
  }

  /** Turns the shape about the body origin, clockwise on screen. Ignored as `translate` is. Wakes the body. */
  rotate(clockwiseRadians: number): void {
    finite('Shape.rotate', 'clockwiseRadians', clockwiseRadians);
    if (this.isLocked()) {
      return;
    }
    const c = cos(clockwiseRadians);
    const s = sin(clockwiseRadians);
    this.map('Shape.rotate', 'clockwiseRadians', clockwiseRadians, [c, s, -s, c, 0, 0]);
  }

  /**
   * Maps the shape by `[m0, m1, m2, m3, m4, m5]`: x' = m0·x + m2·y + m4, y' = m1·x + m3·y + m5. A circle stays a circle of
   * the mapped area. Matrices that mirror or flatten (determinant ≤ 0) are ignored. Otherwise as `translate`.
   */
  transform(matrix: Matrix23Like): void {
    const m = vector('Shape.transform', 'matrix', matrix, 6);
    if (this.isLocked() || !(m[0]! * m[3]! - m[2]! * m[1]! > 0)) {
      return;
    }
    this.map('Shape.transform', 'matrix', matrix, m);
  }

  private map(where: string, name: string, value: unknown, matrix: ArrayLike<number>): void {
    if (!this.mapGeometry(matrix)) {
      throw rangeError(where, name, `one that leaves points apart, an area, and all within ${MAX_SIZE} m`, value);
    }
    this.geometryChanged();
  }

  /**
   * Adds a handler for what this shape has to do with another one:
   *
   * - `begin`, `progress`, `end`: an interaction starts, goes on for another step, is over. Told when the step is done; the handler may
   *   change anything. What had been found in the step by then is told all the same, also of a body that it removed.
   * - `preSolve`: a collision was found and is about to be solved; the handler may reject it with `arbiter.setAcceptedState(false)`. Runs within
   *   the step: where it begins, for shapes that overlap there, not a moment earlier as others are found; and where shapes meet on fast ways or, though they
   *   touch already, get too deep into each other. So it may run twice. `option`: the handler always decides alike (default `false`), so that the bodies may sleep.
   * - `hit`: a collision that takes effect has begun; the handler is also told how hard. `option`: m/s, >= 0, slower ones are left out (default 0).
   *
   * With a `mask` the handler is only called for other shapes with `(mask & group) !== 0`; leaving it out is another listener than 0xffffffff.
   *
   * @returns `false` for an unknown type, or if the same (type, handler, mask) is present. Wakes the body silently otherwise.
   */
  addEventListener<T extends ShapeEventType>(
    eventType: T,
    handler: ShapeEvents[T],
    mask?: number,
    option?: T extends 'hit' ? number : boolean,
  ): boolean {
    const where = 'Shape.addEventListener';
    const type = bitOf(eventType, OF_SHAPES);
    callable(where, 'handler', handler);
    const checked = mask === undefined ? undefined : bits(where, 'mask', mask);
    const deterministic = type !== HIT && boolean(where, 'isDeterministic', optional<unknown>(option, false));
    const minimumSpeed = type === HIT ? nonNegative(where, 'minimumSpeed', optional<unknown>(option, 0)) : 0;
    return addListener(this, { type, handler, mask: checked, deterministic, minimumSpeed }, this.owner);
  }

  /** Removes the handler added with the same (type, handler, mask). @returns whether there was one. */
  removeEventListener<T extends ShapeEventType>(eventType: T, handler: ShapeEvents[T], mask?: number): boolean {
    callable('Shape.removeEventListener', 'handler', handler);
    const checked = mask === undefined ? undefined : bits('Shape.removeEventListener', 'mask', mask);
    return removeListener(this, { type: bitOf(eventType, OF_SHAPES), handler, mask: checked }, this.owner);
  }

  /** @internal geometry may not change now: the world is stepping, or the body is static in a world */
  isLocked(): boolean {
    return this.owner?.isLocked() ?? false;
  }

  /** @internal */
  geometryChanged(): void {
    this.owner?.shapesChanged();
    this.owner?.moved();
    this.owner?.rouse();
  }

  /** @internal resets what the shape had from its world */
  leave(): void {
    this.handle = null;
    this.grounds = null;
    this.groundStamp = -1;
    this.arbiters.length = 0;
  }

  /** @internal off its body */
  detach(): void {
    this.former = this.owner;
    this.owner = null;
  }

  /** @internal turns the geometry with the body and sets the bounds */
  abstract place(body: RigidBody): void;

  /** @internal writes the outline of the shape of a body that is where the outline was put */
  abstract outline(into: Outline): void;

  /** @internal largest distance of a point of the shape from the body origin */
  abstract reach(): number;

  /** @internal it looks the same however its body is turned */
  abstract isRound(): boolean;

  /** @internal by a matrix as that of `transform`. @returns `false`, without effect, if that would be no shape: too large, or with points that coincide. */
  protected abstract mapGeometry(matrix: ArrayLike<number>): boolean;

  /** @internal options for `clone` */
  protected commonParams(): ShapeParams {
    return {
      sensor: this.sensor,
      material: this.material,
      group: this.getGroup(),
      mask: this.getMask(),
      userData: this.userData,
    };
  }
}

/** For `instanceof`, which tells a `Circle | Polygon`. Shapes are made by `createCircleShape` and `createPolygonShape`. */
export const Shape = BaseShape as unknown as abstract new (...args: never[]) => Shape;

/** Whether a shape comes before another wherever the order must not matter: in that in which they were made. Of a pair the older one comes first. */
export function isOlder(a: Shape, b: Shape): boolean {
  return a.id < b.id;
}

/** m. Half of the least width. No method, as what those return has to be boxed; this is short enough to be put into its callers. */
export function halfWidthOf(shape: Shape): number {
  return shape.kind === CIRCLE ? shape.radius : shape.form.halfWidth;
}
