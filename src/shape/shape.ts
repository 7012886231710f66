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

/** As a `ShapeHandler`, also given how the collision began. */
export type HitHandler = (this: Shape, arbiter: Arbiter, otherShape: Shape, hit: Hit) => void;

/** The events of a shape, and the types of their handlers. */
export interface ShapeEvents {
  /** Two shapes touch for the first time, or again. */
  begin: ShapeHandler;
  /** They still touch in another step, and are awake. */
  progress: ShapeHandler;
  /** They no longer touch, or one of them is gone. */
  end: ShapeHandler;
  /** They are about to collide; the handler may reject that. Called within the step. */
  preSolve: ShapeHandler;
  /** A collision has begun. */
  hit: HitHandler;
}

/** The types of events of a shape. */
export type ShapeEventType = keyof ShapeEvents;

/** Options that circles and polygons share. */
export interface ShapeParams {
  /** Reports overlaps and takes part in no collision. Default `false`. */
  sensor?: boolean | undefined;
  /** What it is made of. Default: the default material. */
  material?: Material | undefined;
  /** The groups that this shape is in, as bits. Default 1. */
  group?: number | undefined;
  /**
   * The groups that this shape meets, as bits: two shapes meet if the `group` of each has a bit in common with the `mask` of the other.
   * Default 0xffffffff.
   */
  mask?: number | undefined;
  /** Anything of yours. Default `null`. */
  userData?: UserDataOf<'shape'> | undefined;
}

/** A circle or a polygon. Where `shape.type === 'CIRCLE'`, it is a {@link Circle} and has a radius. */
export type Shape = Circle | Polygon;

/** @internal the values of `kind` */
export type ShapeKind = typeof CIRCLE | typeof POLYGON;

let nextId = 0;

/** The numbers of shapes. */
const slab = /* @__PURE__ */ new Slab();

/**
 * A convex piece of a body: its geometry, material and collision filter. Coordinates are those of the body. After every change of geometry
 * or material the mass and inertia of the body follow, unless they were given.
 */
export abstract class BaseShape {
  // What steps read of thousands of shapes comes first, side by side in memory: they wait for every cache line.

  /** @internal */
  owner: RigidBody | null = null;
  /** @internal where its numbers begin in the slab: all that depends on the placement of the body, see `geometry/layout.ts` */
  at = 0;
  /** @internal the slab that holds them */
  numbers: Float64Array = slab.numbers;
  /** Whether it is a sensor: reports overlaps and collides with nothing. */
  readonly sensor: boolean = false;
  /** @internal as a signed 32-bit integer, for comparisons */
  group = 0;
  /** @internal */
  mask = 0;
  /**
   * @internal m. How far the surface is from the corners: for a circle its radius, for a polygon 0. Both have the field, as one that may be
   * missing is boxed
   */
  radius = 0;
  /** @internal */
  handle: BroadphaseHandle | null = null;
  /** @internal if dynamic: the first of its pairs with the static and kinematic shapes that it lies on or near */
  grounds: Arbiter | null = null;
  /** @internal the step in which these were found */
  groundStamp = -1;
  /** A number that grows in the order of creation, unique in the program. The shape of a pair with the lower id is `shapeA`. */
  readonly id: number = nextId;
  /** The arbiters of interactions that this shape takes part in, or did within the last 30 steps. Do not modify. */
  readonly arbiters: Arbiter[] = [];
  /** @internal */
  listeners: Listeners<HitHandler> = NO_LISTENERS;
  /** @internal while the broadphase reports: shapes that it may be paired with, see `Crowd` */
  partners: List<Shape> | null = null;
  /** @internal rank in the order in which bodies, shapes and constraints came into their worlds. Keeps its name */
  order = 0;
  /** @internal the last step before it came into its world */
  entered = -1;
  /** @internal the last body it was on, for the `end` events of its removal */
  former: RigidBody | null = null;
  /** @internal its index while the state of the world is walked over */
  stateIndex = 0;
  /** @internal */
  material: Material;
  /** Anything of yours. */
  userData: UserDataOf<'shape'>;
  /** The kind of shape, which tells circles from polygons. */
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

  /** @internal allots a number of numbers in the slab */
  protected resize(count: number): void {
    this.at = slab.take(count);
    this.numbers = slab.numbers;
  }

  /** The body this shape is attached to, or `null`. */
  get body(): RigidBody | null {
    return this.owner;
  }

  /** The groups that this shape is in, as bits. */
  getGroup(): number {
    return this.group >>> 0;
  }

  /** Sets the groups that this shape is in, as bits. Wakes the body; if that is static, also what rests on it; and what sleeps in a sensor. */
  setGroup(group: number): void {
    this.changeFilter(bits('Shape.setGroup', 'group', group) | 0, this.mask);
  }

  /** The groups that this shape meets, as bits. */
  getMask(): number {
    return this.mask >>> 0;
  }

  /** Sets the groups that this shape meets, as bits. Wakes as `setGroup` does. */
  setMask(mask: number): void {
    this.changeFilter(this.group, bits('Shape.setMask', 'mask', mask) | 0);
  }

  /**
   * What sleeps in a sensor, or in a collision that was rejected, is woken like what rests on the shape, so that it gets its `end` event if
   * the interaction is over.
   */
  private changeFilter(group: number, mask: number): void {
    const isOther = this.setFilter(group, mask);
    this.owner?.rouse();
    for (const pair of this.arbiters) {
      if (isOther && pair.sleeping) this.owner!.owner!.wakeBoth(pair);
    }
  }

  /** @internal sets both, as signed 32-bit integers; in a world, pairs that the filters left out may interact now. @returns whether they changed */
  setFilter(group: number, mask: number): boolean {
    const isOther = group !== this.group || mask !== this.mask;
    const world = this.handle !== null && isOther ? this.owner!.owner! : null;
    world?.changeFilters();
    this.group = group;
    this.mask = mask;
    world?.broadphase.refilter?.(this.handle!);
    return isOther;
  }

  /** What the shape is made of. */
  getMaterial(): Material {
    return this.material;
  }

  /** Replaces the material; present contacts change with it. Wakes the body if it is another one. */
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

  /** The area, m². */
  abstract computeArea(): number;

  /** The second moment of area about the body origin divided by the area, m². */
  abstract computeMasslessInertia(): number;

  /** The centroid in body coordinates, m. */
  abstract computeCenterOfMass(): Vec2;
  abstract computeCenterOfMass<T extends NumberSink>(dst: T): T;

  /** A copy with a new id and the same `userData`, without body and listeners. */
  abstract clone(): this;

  /**
   * Scales the shape about the body origin. A circle uses `scaleX` alone. Ignored for factors ≤ 0, during a step, and for a static body in
   * a world. Wakes the body.
   *
   * @throws RangeError, as do `translate`, `rotate` and `transform`, if corners would coincide, no area would be left, or a corner would be
   * farther than 1e75 m from the body origin.
   */
  scale(scaleX: number, scaleY: number = scaleX): void {
    finite('Shape.scale', 'scaleX', scaleX);
    finite('Shape.scale', 'scaleY', scaleY);
    const other = this.type === 'POLYGON' ? scaleY : scaleX;
    if (this.isLocked() || scaleX <= 0 || other <= 0) {
      return;
    }
    // Blame the factor that changes more.
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

  /** @internal whether it keeps its shape if it is moved by so much: very far away corners would coincide */
  staysWhole(x: number, y: number): boolean {
    return this.clone().mapGeometry([1, 0, 0, 1, x, y]);
  }

  /** Rotates the shape about the body origin, clockwise on screen. Ignored as `translate` is. Wakes the body. */
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
   * Transforms the shape by `[m0, m1, m2, m3, m4, m5]`: x' = m0·x + m2·y + m4, y' = m1·x + m3·y + m5. A circle stays a circle, of the
   * transformed area. Matrices that mirror or flatten (determinant ≤ 0) are ignored; otherwise the rules of `translate` apply.
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
   * Adds a handler for interactions of this shape with others:
   *
   * - `begin`, `progress`, `end`: an interaction starts, goes on for another step, is over. Delivered when the step is done; the handler
   *   may change anything. All that the step found is delivered, even about a body that a handler has removed meanwhile.
   * - `preSolve`: a collision was found and is about to be solved; the handler may reject it with `arbiter.setAcceptedState(false)`. It is
   *   called within the step: at its start, for shapes that overlap by then (without such handlers, shapes are solved shortly before they
   *   touch); and later, where shapes meet in fast motion or, though they touch already, get too deep into each other. So it may be called
   *   twice in a step. `option`: the handler always decides alike (default `false`), so that the bodies may sleep.
   * - `hit`: a collision that takes effect has begun; the handler also gets how hard. `option`: m/s, >= 0, slower ones are left out
   *   (default 0).
   *
   * With a `mask` the handler is only called for other shapes with `(mask & group) !== 0`. Without one it is a different listener than with
   * 0xffffffff. The least speed of a `hit` is the fourth argument: as the third it would be a mask. `begin`, `progress` and `end` have no
   * option.
   *
   * @returns `false` for an unknown type, or if the same (type, handler, mask) is present. Otherwise wakes the body without an event.
   */
  addEventListener<T extends ShapeEventType>(
    eventType: T,
    handler: ShapeEvents[T],
    mask?: number,
    option?: T extends 'hit' ? number : T extends 'preSolve' ? boolean : undefined,
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

  /** @internal whether the geometry may not change now: the world is stepping, or the body is static in a world */
  isLocked(): boolean {
    return this.owner?.isLocked() ?? false;
  }

  /** @internal */
  geometryChanged(): void {
    this.owner?.shapesChanged();
    this.owner?.moved();
    this.owner?.rouse();
  }

  /** @internal resets all that belongs to the world the shape was in */
  leave(): void {
    this.handle = null;
    this.grounds = null;
    this.groundStamp = -1;
    this.arbiters.length = 0;
  }

  /** @internal takes it off its body */
  detach(): void {
    this.former = this.owner;
    this.owner = null;
  }

  /** @internal writes the geometry turned with the body, and the world bounds, to `numbers` */
  abstract place(body: RigidBody): void;

  /** @internal writes its outline for the placement in `into` */
  abstract outline(into: Outline): void;

  /** @internal the largest distance of a point of the shape from the body origin, m */
  abstract reach(): number;

  /** @internal whether it looks the same however its body is turned */
  abstract isRound(): boolean;

  /**
   * @internal transforms the geometry by a matrix as in `transform`. @returns `false`, without effect, if the result would be no shape: too
   * large, or with points that coincide.
   */
  protected abstract mapGeometry(matrix: ArrayLike<number>): boolean;

  /** @internal the options that `clone` passes on */
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

/**
 * The class of all shapes, for `instanceof`, which narrows to `Circle | Polygon`. Shapes are made by `createCircleShape` and
 * `createPolygonShape`.
 */
export const Shape = BaseShape as unknown as abstract new (...args: never[]) => Shape;

/** Whether a shape was made before another: the order used wherever results must not depend on any other. The older shape of a pair comes first. */
export function isOlder(a: Shape, b: Shape): boolean {
  return a.id < b.id;
}

/** Half of the least width, m. Not a method, as the result of one has to be boxed; this is short enough to be inlined. */
export function halfWidthOf(shape: Shape): number {
  return shape.kind === CIRCLE ? shape.radius : shape.form.halfWidth;
}
