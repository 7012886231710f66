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
import { changeFilters } from './solver/find-pairs.js';
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
 * Bodies, and the time that passes for them. All lists are live and without order; do not modify them. During a step
 * (in `preSolve` handlers) nothing can be added or removed; in all other handlers everything may be changed.
 * `validate(world)`, imported apart from `phys2d/validate`, checks that all that a world consists of is consistent.
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
   * @throws Error when called from a handler. An exception of a handler, or of `poses`, leaves the world consistent: the step is completed,
   * the other handlers are called, then the first exception is thrown on.
   */
  step(deltaTime: number): void {
    positive('World.step', 'deltaTime', deltaTime);
    this.refuseInside('World.step');
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

  /** m/s². */
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

  /** Adds a body. @returns `false`, without effect, if it is in a world already, or during a step. @throws if another world with bodies has the broadphase of this one. */
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
    body.lastDx = 0;
    body.lastDy = 0;
    body.lastTurn = 0;
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
   * Removes a body, and its constraints with it; what touches it wakes, its interactions end.
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
   * Adds a constraint; wakes its bodies unless it was put to sleep or disabled.
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

  /** Removes a constraint; if it was asleep its bodies wake. @returns `false`, without effect, if not in this world, or during a step. */
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
    // Who is told of an event may still ask what it was.
    if (!this.delivering) letGo(this);
  }

  /** The shapes that contain a point, in the order in which they were made, written to the start of `store`; boundaries count. @returns how many. */
  shapePointQuery(point: Vec2Like, store: Shape[]): number {
    return writeResults(this.atPoint('World.shapePointQuery', point, store), store);
  }

  /** The bodies with a shape that contains a point, in the order of their first such shapes; as `shapePointQuery`. */
  bodyPointQuery(point: Vec2Like, store: RigidBody[]): number {
    return writeResults(bodiesOf(this.atPoint('World.bodyPointQuery', point, store)), store);
  }

  /** The shapes that a disc meets; as `shapePointQuery`, touching counts. `radius` > 0, may be `Infinity`. @returns how many. */
  shapeCircleQuery(center: Vec2Like, radius: number, store: Shape[]): number {
    return writeResults(this.inCircle('World.shapeCircleQuery', center, radius, store), store);
  }

  /** The bodies that a disc meets; as `bodyPointQuery` and `shapeCircleQuery`. */
  bodyCircleQuery(center: Vec2Like, radius: number, store: RigidBody[]): number {
    return writeResults(bodiesOf(this.inCircle('World.bodyCircleQuery', center, radius, store)), store);
  }

  /**
   * The shapes that an upright rectangle meets; as `shapePointQuery`, touching counts. Two opposite corners in any order, which may be
   * infinite. @returns how many.
   */
  shapeRectangleQuery(rectangle: RectLike, store: Shape[]): number {
    return writeResults(this.inRectangle('World.shapeRectangleQuery', rectangle, store), store);
  }

  /** The bodies that a rectangle meets; as `bodyPointQuery` and `shapeRectangleQuery`. */
  bodyRectangleQuery(rectangle: RectLike, store: RigidBody[]): number {
    return writeResults(bodiesOf(this.inRectangle('World.bodyRectangleQuery', rectangle, store)), store);
  }

  /** The shapes of other bodies that a shape meets where its body is now, in this world or not; as `shapePointQuery`, touching counts. @returns how many. */
  shapeQuery(shape: Shape, store: Shape[]): number {
    const where = 'World.shapeQuery';
    bodyOf(where, 'shape', shape);
    list(where, 'store', store);
    return writeResults(shapesMeeting(this, shape), store);
  }

  /**
   * The nearest surface that a ray meets at a factor below `ray.maxFactor`, or `null`. A ray that starts inside a shape meets it where it leaves it,
   * unless `ignoreInnerSurfaces` (default `false`). `callback` is asked about each hit that is nearer than those before, by an object that is used again; if it
   * returns nothing or `false` the shape is left out. It must not change the world.
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

  /** Every shape that a ray meets, as `rayCast` would, nearest first, written to the start of `store`. @returns how many. */
  rayCastAll(ray: Ray, ignoreInnerSurfaces: boolean, store: CastResult[]): number {
    const where = 'World.rayCastAll';
    checkedRay(where, ray);
    boolean(where, 'ignoreInnerSurfaces', ignoreInnerSurfaces);
    list(where, 'store', store);
    return writeResults(castRayThrough(this, ray, ignoreInnerSurfaces), store);
  }

  /**
   * Sweeps a shape with its body's velocities for `deltaTime` seconds (> 0) against everything else in the world, which stands still: the first hit, or
   * `null`. What touches at the start, and other shapes of the body, are left out; the body may be in any world or none, and stays as it
   * is. `factor` is the time of the hit, s; `callback` as in `rayCast`. What turns more than some three hundred times while it is within reach of another shape
   * is given up there.
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
   * A digest of all that influences the future, 16 hexadecimal digits: worlds of equal digests go on alike, as far as handlers and callbacks do. The same in
   * every JavaScript engine, whatever the broadphase, for the same calls.
   *
   * @throws Error when called from a handler or callback of this world, or of a world that was made without `state`, as `snapshot` and `restore`.
   */
  hash(): string {
    return this.saved('World.hash').hash(this);
  }

  /**
   * The state of the world: all that `restore` needs to go on from here to the bit. Listeners, user data and the variables of handlers and
   * callbacks are not in it (but see `state` of custom constraints), nor are bodies that are in no world: of one that a constraint in this world has,
   * place and motion are in it, its shapes are not.
   *
   * @param target is written to, if it is large enough, and returned: keep what is returned, and a game that saves each step makes no garbage.
   */
  snapshot(target?: ArrayBuffer): ArrayBuffer {
    const where = 'World.snapshot';
    return this.saved(where).snapshot(where, this, target);
  }

  /**
   * Brings the world back to where it was when a snapshot was taken, in place: bodies, shapes, constraints and materials are the same objects. What was added
   * since is removed, without events; what was removed comes back, as do shapes and materials that were exchanged. A pair of shapes may have another
   * arbiter object than before.
   *
   * A buffer that `snapshot` returned names its objects, so they always come back. A copy of its bytes names them by when they were added:
   * what is not in the world then has to be in `held`.
   *
   * @param snapshot may be bytes in another buffer, such as a Node `Buffer`: a copy then.
   * @param held bodies, shapes and constraints that are not in the world.
   * @throws RangeError if the snapshot is damaged, none, or of another version; Error if an object of it cannot be found, or is in another world.
   * Nothing has changed then.
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
   * - `begin`, `progress`, `end`, `hit`: as of shapes, see `shape.addEventListener`, for any two shapes, after their own handlers. What sleeps is not woken to tell. Of more than 64 shapes that
   *   lie in the middle of each other, and have no handlers, some pairs are left out.
   * - `nonfinite`: a body was frozen in the step, as its motion would not have been finite, or farther than 1e150 m. It is where it was,
   *   without velocity, force and torque, and moved nothing else. Causes are forces and masses of no measure, and custom constraints.
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

  /** @internal in a step, or telling of it: handlers and callbacks are being called. Keeps its name */
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

  // What bodies ask of the solver goes through their world, so that their modules need not import it; constraints ask their own.

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

  /** @internal before a change of what filters or joints let interact */
  changeFilters(): void {
    changeFilters(this);
  }

  /** @internal a body is about to be put elsewhere */
  holdContacts({ shapes }: Pick<RigidBody, 'shapes'>): void {
    for (const { arbiters } of shapes) {
      arbiters.forEach(holdAtEnd);
    }
  }

  /** @internal a shape was attached to a body of this world */
  shapeAdded(shape: Shape): void {
    shape.place(shape.owner!);
    this.enter(shape);
  }

  private enter(shape: Shape): void {
    shape.order = this.nextOrder;
    shape.entered = this.stamp;
    this.nextOrder += 1;
    insertHandle(this, shape);
  }

  /** @internal a shape is about to be detached from a body of this world */
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

/** Asked for what it can do, as its class would be in every bundle that has a world. */
function checkConstraint(where: string, constraint: Constraint): void {
  if (typeof constraint?.measure !== 'function') {
    throw typeError(where, 'constraint', 'a Constraint', constraint);
  }
}
