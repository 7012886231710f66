import { RigidBody } from './body.js';
import { STATIC } from './body-kind.js';
import type { Constraint } from './constraint/constraint.js';
import type { Arbiter } from './contact/arbiter.js';
import { holdAtEnd } from './contact/at-end.js';
import type { Kernels } from './kernels.js';
import { addListener, bitOf, OF_WORLDS, plainListener, removeListener } from './listeners.js';
import { takeOut } from './math/list.js';
import { type NumberSink, type Ray, type RectLike, type Vec2, type Vec2Like, vec2 } from './math/vectors.js';
import { type CastResult, castRay, castRayThrough, castShape } from './query/casts.js';
import {
  bodiesOf,
  shapesAtPoint,
  shapesInCircle,
  shapesInRectangle,
  shapesMeeting,
  writeResults,
} from './query/queries.js';
import { bodyOf } from './shape/presently.js';
import type { Shape } from './shape/shape.js';
import { POLYGON } from './shape/shape-kind.js';
import { changeFilters } from './solver/find-pairs.js';
import { wakePushed } from './solver/forces.js';
import { letGo } from './solver/let-go.js';
import { changeKind, cutPairs, rouseNeighbours } from './solver/membership.js';
import { insertHandle } from './solver/refresh.js';
import { quieten, sleepBody, wakeAll, wakeBody, wakeBoth, wakeConstraint } from './solver/sleep.js';
import { step } from './solver/step.js';
import { enlivenTied } from './solver/ties.js';
import {
  boolean,
  callable,
  callbackOf,
  checkedRay,
  instance,
  list,
  numbers,
  positive,
  positiveOrInfinite,
  typeError,
  vector,
} from './validate.js';
import {
  type WorldEvents,
  type WorldEventType,
  type WorldParams,
  type WorldSaving,
  WorldState,
} from './world-state.js';

/**
 * A simulated world: bodies, constraints, and the time that passes for them. All its lists are live and in no particular order; do not
 * modify them. During a step (in `preSolve` handlers) nothing can be added or removed; in all other handlers everything may be changed.
 * `validate(world)`, from the separate module `phys2d/validate`, checks that the state of a world is consistent.
 */
export class World extends WorldState {
  /** Of the class, as in Turbulenz. */
  static get version(): number {
    return 1;
  }

  /** @internal use `createWorld` */
  constructor(params?: WorldParams, saving?: WorldSaving, kernels?: Kernels) {
    super(params, saving, kernels);
  }

  /**
   * Advances the world by one step of `deltaTime` seconds (> 0), then delivers events. Use a fixed step such as 1/60.
   *
   * @throws Error when called from a handler. If a handler or `poses` throws, the world stays consistent: the step is completed, the other
   * handlers are called, and then the first exception is rethrown.
   */
  step(deltaTime: number): void {
    positive('World.step', 'deltaTime', deltaTime);
    this.refuseInside('World.step');
    // Before the step begins, as other wakes are: within it, contacts that go on would begin anew, and lose their impulses.
    if (this.pushed.size > 0) wakePushed(this, deltaTime);
    this.stamp += 1;
    this.time = Math.min(this.time + deltaTime, Number.MAX_VALUE);
    this.stepping = true;
    try {
      step(this, deltaTime);
    } finally {
      this.stepping = false;
    }
    this.delivering = true;
    this.events.readHits();
    try {
      if (this.poses !== null) {
        this.events.call(this.poses.update, this.poses, null, null, null);
      }
      this.events.deliver();
    } finally {
      this.delivering = false;
      this.profile?.lap('events');
    }
    this.events.rethrow();
  }

  /** The gravity, m/s²; y points down. */
  getGravity(): Vec2;
  getGravity<T extends NumberSink>(dst: T): T;
  getGravity<T extends NumberSink>(dst?: T): T | Vec2 {
    return vec2(this.gravityX, this.gravityY, 'World.getGravity', dst);
  }

  /** Sets the gravity, m/s². Wakes everything if changed. */
  setGravity(gravity: Vec2Like): void {
    vector('World.setGravity', 'gravity', gravity, 2);
    if (gravity[0] !== this.gravityX || gravity[1] !== this.gravityY) {
      this.gravityX = gravity[0]!;
      this.gravityY = gravity[1]!;
      this.wakeAll();
    }
  }

  /**
   * Adds a body. @returns `false`, without effect, if it is in a world already, or during a step. @throws Error if this world is empty and
   * its broadphase belongs to another world that has bodies.
   */
  addRigidBody(body: RigidBody): boolean {
    instance('World.addRigidBody', 'body', body, RigidBody, 'a RigidBody');
    if (this.stepping || body.owner !== null) {
      return false;
    }
    if (this.rigidBodies.length === 0) this.beginAnew('World.addRigidBody');
    body.place();
    body.placeStale = false;
    body.refreshMass();
    body.owner = this;
    body.index = this.rigidBodies.push(body) - 1;
    body.order = this.nextOrder;
    this.nextOrder += 1;
    body.forgetMotion();
    body.asleep = body.asleep || body.kind === STATIC;
    for (const shape of body.shapes) {
      this.enter(shape);
    }
    this.jointsStale ||= body.constraints.length > 0;
    if (!body.asleep) {
      enlivenTied(this, body);
    }
    return true;
  }

  /**
   * Removes a body, and its constraints with it. What touches it wakes, and its interactions end.
   *
   * @returns `false`, without effect, if it is not in this world, or during a step.
   */
  removeRigidBody(body: RigidBody): boolean {
    instance('World.removeRigidBody', 'body', body, RigidBody, 'a RigidBody');
    if (this.stepping || body.owner !== this) {
      return false;
    }
    wakeBody(this, body, true);
    rouseNeighbours(this, body);
    for (const constraint of [...body.constraints]) {
      this.removeConstraint(constraint);
    }
    if (body.liveIndex >= 0) {
      quieten(this, body);
    }
    for (const shape of body.shapes) {
      cutPairs(this, shape);
      this.broadphase.remove(shape.handle!);
    }
    const moved = takeOut(this.rigidBodies, body.index);
    if (moved !== null) moved.index = body.index;
    body.leave();
    return true;
  }

  /**
   * Adds a constraint, and wakes its bodies unless it was put to sleep or disabled.
   *
   * @returns `false`, without effect, if it is in a world already, or during a step.
   */
  addConstraint(constraint: Constraint): boolean {
    checkConstraint('World.addConstraint', constraint);
    if (this.stepping || constraint.owner !== null) {
      return false;
    }
    constraint.solver!.tie(this, constraint);
    return true;
  }

  /** Removes a constraint; if it was asleep, its bodies wake. @returns `false`, without effect, if it is not in this world, or during a step. */
  removeConstraint(constraint: Constraint): boolean {
    checkConstraint('World.removeConstraint', constraint);
    if (this.stepping || constraint.owner !== this) {
      return false;
    }
    wakeConstraint(this, constraint, true);
    constraint.solver!.untie(this, constraint);
    return true;
  }

  /** Removes everything, without events; queued events are dropped. Time, gravity and settings stay. Ignored during a step. */
  clear(): void {
    if (this.stepping) {
      return;
    }
    for (const body of this.rigidBodies) {
      body.leave();
    }
    for (const constraint of this.constraints) {
      constraint.solver!.leaveWorld(constraint);
    }
    for (const list of [this.rigidBodies, this.constraints, this.dynamicArbiters, this.staticArbiters]) {
      list.length = 0;
    }
    for (const list of [this.liveDynamics, this.liveKinematics, this.liveConstraints]) {
      list.length = 0;
    }
    this.broadphase.clear();
    this.jointSolver?.reset(this.solver.joints);
    this.jointsStale = true;
    this.stale.clear();
    this.pairs.clear();
    this.events.clear();
    // Within a delivery, a handler may still read the event it was called for.
    if (!this.delivering) letGo(this);
  }

  /**
   * Finds the shapes that contain a point, boundaries included, and writes them to the start of `store`, in the order in which they were
   * made. @returns how many.
   */
  shapePointQuery(point: Vec2Like, store: Shape[]): number {
    return writeResults(this.atPoint('World.shapePointQuery', point, store), store);
  }

  /** Finds the bodies with a shape that contains a point, as `shapePointQuery`; in the order of their first such shapes. */
  bodyPointQuery(point: Vec2Like, store: RigidBody[]): number {
    return writeResults(bodiesOf(this.atPoint('World.bodyPointQuery', point, store)), store);
  }

  /** Finds the shapes that intersect a disc, as `shapePointQuery`; touching counts. `radius` > 0, may be `Infinity`. @returns how many. */
  shapeCircleQuery(center: Vec2Like, radius: number, store: Shape[]): number {
    return writeResults(this.inCircle('World.shapeCircleQuery', center, radius, store), store);
  }

  /** Finds the bodies with a shape that intersects a disc, as `bodyPointQuery` and `shapeCircleQuery`. */
  bodyCircleQuery(center: Vec2Like, radius: number, store: RigidBody[]): number {
    return writeResults(bodiesOf(this.inCircle('World.bodyCircleQuery', center, radius, store)), store);
  }

  /**
   * Finds the shapes that intersect an axis-aligned rectangle, as `shapePointQuery`; touching counts. The rectangle is given by two
   * opposite corners in any order, which may be infinite. @returns how many.
   */
  shapeRectangleQuery(rectangle: RectLike, store: Shape[]): number {
    return writeResults(this.inRectangle('World.shapeRectangleQuery', rectangle, store), store);
  }

  /** Finds the bodies with a shape that intersects a rectangle, as `bodyPointQuery` and `shapeRectangleQuery`. */
  bodyRectangleQuery(rectangle: RectLike, store: RigidBody[]): number {
    return writeResults(bodiesOf(this.inRectangle('World.bodyRectangleQuery', rectangle, store)), store);
  }

  /**
   * Finds the shapes of other bodies that intersect a shape where its body is now, in this world or not; as `shapePointQuery`, touching
   * counts. @returns how many.
   */
  shapeQuery(shape: Shape, store: Shape[]): number {
    const where = 'World.shapeQuery';
    bodyOf(where, 'shape', shape);
    list(where, 'store', store);
    return writeResults(shapesMeeting(this, shape), store);
  }

  /**
   * The nearest hit of a ray at a factor below `ray.maxFactor`, or `null`. A ray that starts inside a shape hits it where it leaves it,
   * unless `ignoreInnerSurfaces` (default `false`). `callback` is called for each hit that is nearer than those accepted before, with a
   * result object that is used again. If it returns `false` or nothing, the shape is left out. It must not change the world.
   */
  rayCast(
    ray: Ray,
    ignoreInnerSurfaces: boolean = false,
    callback?: (ray: Ray, temporaryResult: CastResult) => boolean,
    thisObject?: unknown,
  ): CastResult | null {
    const where = 'World.rayCast';
    checkedRay(where, ray);
    boolean(where, 'ignoreInnerSurfaces', ignoreInnerSurfaces);
    const accept = callbackOf(where, callback);
    return castRay(this, ray, ignoreInnerSurfaces, accept && ((found) => accept.call(thisObject, ray, found)));
  }

  /** Finds all hits of a ray, one a shape, as `rayCast`, and writes them to the start of `store`, nearest first. @returns how many. */
  rayCastAll(ray: Ray, ignoreInnerSurfaces: boolean, store: CastResult[]): number {
    const where = 'World.rayCastAll';
    checkedRay(where, ray);
    boolean(where, 'ignoreInnerSurfaces', ignoreInnerSurfaces);
    list(where, 'store', store);
    return writeResults(castRayThrough(this, ray, ignoreInnerSurfaces), store);
  }

  /**
   * Sweeps a shape with its body's velocities for `deltaTime` seconds (> 0) against everything else in the world, which stands still.
   * Returns the first hit, or `null`. What touches at the start, and other shapes of the body, are left out; the body may be in any world
   * or none, and is not moved. `factor` is the time of the hit, s; `callback` as in `rayCast`. If the shape turns more than some three
   * hundred times within reach of another one, that one is left out.
   */
  convexCast(
    shape: Shape,
    deltaTime: number,
    callback?: (shape: Shape, temporaryResult: CastResult) => boolean,
    thisObject?: unknown,
  ): CastResult | null {
    const where = 'World.convexCast';
    bodyOf(where, 'shape', shape);
    positive(where, 'deltaTime', deltaTime);
    const accept = callbackOf(where, callback);
    return castShape(this, shape, deltaTime, accept && ((found) => accept.call(thisObject, shape, found)));
  }

  /**
   * A digest of all that influences the future, 16 hexadecimal digits: worlds with equal digests continue alike, as far as handlers and
   * callbacks do. It is the same in every JavaScript engine, whatever the broadphase, for the same calls.
   *
   * @throws Error, as do `snapshot` and `restore`, when called from a handler or callback of this world, or if the world was made without
   * `state`.
   */
  hash(): string {
    return this.saved('World.hash').hash(this);
  }

  /**
   * Saves the state of the world: all that `restore` needs to continue from here to the bit. Not included are listeners, user data, the
   * variables of handlers and callbacks (but see `state` of custom constraints), and bodies that are in no world; if a constraint in this
   * world has such a body, its placement and motion are included, its shapes are not.
   *
   * @param target is written to and returned, if it is large enough. If a game saves each step and passes what the last call returned, it
   * makes no garbage.
   */
  snapshot(target?: ArrayBuffer): ArrayBuffer {
    const where = 'World.snapshot';
    return this.saved(where).snapshot(where, this, target);
  }

  /**
   * Restores the world, in place, to its state when a snapshot was taken: bodies, shapes, constraints and materials are the same objects.
   * What was added since is removed, without events. What was removed comes back, as do shapes and materials that were exchanged. A pair of
   * shapes may have another arbiter object than before.
   *
   * A buffer that `snapshot` returned knows its objects, so they always come back. In a copy of its bytes, objects are identified by the
   * order in which they were added: what is not in the world then has to be in `held`.
   *
   * @param snapshot may be bytes in another buffer, such as a Node `Buffer`: a copy then.
   * @param held bodies, shapes and constraints that are not in the world.
   * @throws RangeError if the bytes are damaged, no snapshot, or of another version; Error if an object of it cannot be found, or is in
   * another world. Nothing has changed then.
   */
  restore(snapshot: ArrayBuffer | ArrayBufferView, held: Iterable<RigidBody | Shape | Constraint> = []): void {
    const where = 'World.restore';
    this.saved(where).restore(where, this, snapshot, held);
  }

  private saved(where: string): WorldSaving {
    this.refuseInside(where);
    if (this.saving === null) {
      throw new Error(`${where}: the world was made without state: pass { state: worldState } to createWorld`);
    }
    return this.saving;
  }

  /**
   * Adds a handler, which is called when the step is done, and may change anything.
   *
   * - `begin`, `progress`, `end`, `hit`: as for shapes, see `shape.addEventListener`, for any two shapes, after the handlers of these.
   *   Adding one wakes nothing. Of more than 64 shapes that lie in the middle of each other and have no handlers, some pairs are left out.
   * - `nonfinite`: a body was frozen in the step, because its motion would not have been finite, or would have led farther than 1e150 m. It
   *   is where it was, without velocity, force and torque, and moved nothing else. Causes are extreme forces and masses, and custom
   *   constraints.
   *
   * @returns `false` for an unknown type or a handler already present.
   */
  addEventListener<T extends WorldEventType>(eventType: T, handler: WorldEvents[T]): boolean {
    callable('World.addEventListener', 'handler', handler);
    return addListener(this, plainListener(bitOf(eventType, OF_WORLDS), handler), null);
  }

  /** Removes a handler. @returns whether it was there. */
  removeEventListener<T extends WorldEventType>(eventType: T, handler: WorldEvents[T]): boolean {
    callable('World.removeEventListener', 'handler', handler);
    return removeListener(this, plainListener(bitOf(eventType, OF_WORLDS), handler), null);
  }

  /** @internal in a step or delivering its events: handlers and callbacks are being called. Keeps its name */
  get busy(): boolean {
    return this.stepping || this.delivering;
  }

  /** @internal Keeps its name */
  refuseInside(where: string): void {
    if (this.busy) {
      throw new Error(`${where}: must not be called from a handler or callback of the same world`);
    }
  }

  private atPoint(where: string, point: Vec2Like, store: unknown): Shape[] {
    vector(where, 'point', point, 2);
    list(where, 'store', store);
    return shapesAtPoint(this, point);
  }

  private inCircle(where: string, center: Vec2Like, radius: number, store: unknown): Shape[] {
    vector(where, 'center', center, 2);
    positiveOrInfinite(where, 'radius', radius);
    list(where, 'store', store);
    return shapesInCircle(this, center, radius);
  }

  private inRectangle(where: string, rectangle: RectLike, store: unknown): Shape[] {
    numbers(where, 'rectangle', rectangle, 4);
    list(where, 'store', store);
    return shapesInRectangle(this, rectangle);
  }

  // Bodies call the solver through their world, so that their modules need not import it; constraints have their own reference to it.

  /** @internal */
  wakeBody(body: RigidBody, silent: boolean): void {
    wakeBody(this, body, silent);
  }

  /** @internal */
  wakeBoth(pair: Arbiter): void {
    wakeBoth(this, pair);
  }

  /** @internal */
  sleepBody(body: RigidBody): void {
    sleepBody(this, body);
  }

  /** @internal */
  changeKind(body: RigidBody, kind: number): void {
    changeKind(this, body, kind);
  }

  /** @internal to be called before a change of filters, or of what joints keep from interacting */
  changeFilters(): void {
    changeFilters(this);
  }

  /** @internal keeps the manifolds of a body that is about to be moved by hand */
  holdContacts({ shapes }: Pick<RigidBody, 'shapes'>): void {
    for (const { arbiters } of shapes) {
      arbiters.forEach(holdAtEnd);
    }
  }

  /** @internal called after a shape was attached to a body of this world */
  shapeAdded(shape: Shape): void {
    shape.place(shape.owner!);
    this.enter(shape);
  }

  private enter(shape: Shape): void {
    shape.order = this.nextOrder;
    shape.entered = this.stamp;
    // Its pairs are new. What was changed before is in no snapshot: it must not tell worlds apart that are alike.
    if (shape.kind === POLYGON) shape.geometryStamp = 1;
    this.nextOrder += 1;
    insertHandle(this, shape);
  }

  /** @internal called before a shape is detached from a body of this world */
  shapeRemoved(shape: Shape): void {
    rouseNeighbours(this, shape.owner!);
    cutPairs(this, shape);
    this.broadphase.remove(shape.handle!);
    shape.leave();
    this.someLeft = true;
  }

  /** @internal */
  protected override wakeAll(): void {
    wakeAll(this);
  }
}

/** By what it can do, as naming its class would put that into every bundle that has a world. */
function checkConstraint(where: string, constraint: Constraint): void {
  if (typeof constraint?.measure !== 'function') {
    throw typeError(where, 'constraint', 'a Constraint', constraint);
  }
}
