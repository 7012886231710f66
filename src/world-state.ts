import { RigidBody } from './body.js';
import type { BodyState } from './body-state.js';
import { BoxTreeBroadphase } from './broadphase/box-tree-broadphase.js';
import type { Broadphase } from './broadphase/broadphase.js';
import { DEFAULT_ITERATIONS, DEFAULT_SUBSTEPS } from './config.js';
import type { Constraint } from './constraint/constraint.js';
import type { Arbiter } from './contact/arbiter.js';
import type { Hit } from './contact/hit.js';
import { Pairs } from './contact/pairs.js';
import { EventQueue } from './events/events.js';
import { Kernels, plainKernels } from './kernels.js';
import { type Listeners, NO_LISTENERS } from './listeners.js';
import { List } from './math/list.js';
import type { Vec2Like } from './math/vectors.js';
import { type Clock, Profile } from './profile.js';
import type { Shape } from './shape/shape.js';
import { SolverData } from './solver/data.js';
import { Movers } from './solver/impacts/movers.js';
import { IslandWork } from './solver/islands.js';
import { JointData } from './solver/joints/joint-data.js';
import type { JointSolver } from './solver/joints/joints.js';
import { boolean, callable, instance, integer, optional, options, typeError, vector } from './validate.js';
import type { World } from './world.js';

/** What `World.poses` is: a `PoseBuffer`, or anything with such a method. */
export interface PoseUpdate {
  /** Called at the end of each step, before events. The rules are those of their handlers. */
  update(): void;
}

/** Called with the interaction, `this` = the world. */
export type WorldContactHandler = (this: World, arbiter: Arbiter) => void;

/** Called with the collision that has begun, and how hard that was. */
export type WorldHitHandler = (this: World, arbiter: Arbiter, hit: Hit) => void;

/** Called with the body that was frozen. */
export type WorldBodyHandler = (this: World, body: RigidBody) => void;

/** The events of a world, and what their handlers are: those of all shapes in it, each told once. */
export interface WorldEvents {
  /** Two shapes touch for the first time, or again. */
  begin: WorldContactHandler;
  /** They touch in another step, and are awake. */
  progress: WorldContactHandler;
  /** They do not touch any more, or one of them is gone. */
  end: WorldContactHandler;
  /** A collision has begun. */
  hit: WorldHitHandler;
  /** A body was frozen, as its motion would not have been finite. */
  nonfinite: WorldBodyHandler;
}

/** What worlds tell their listeners. */
export type WorldEventType = keyof WorldEvents;

/** Options of `createWorld`. */
export interface WorldParams {
  /** Finds pairs of shapes that are near each other; any object of that interface. Default: a box tree. */
  broadphase?: Broadphase | undefined;
  /** m/s². Default `[0, 10]`: down, as y points down. */
  gravity?: Vec2Like | undefined;
  /** In a whole step, integer from 1 to 1e9; each sub-step has its share, at least one. Default 8. */
  velocityIterations?: number | undefined;
  /** In a whole step, as `velocityIterations`. Default 8. */
  positionIterations?: number | undefined;
  /** Equal parts in which a step is integrated, integer from 1 to 1e9; the iterations are spread over them. Default 4. */
  substeps?: number | undefined;
  /** Whether bodies at rest fall asleep by themselves. Default `true`. */
  allowSleeping?: boolean | undefined;
  /**
   * What `snapshot`, `restore` and `hash` work with: `worldState`. Default: nothing with the function `createWorld`, so that a bundle that does not
   * save worlds has nothing of it, and these methods throw; `worldState` with the one of `phys2D`.
   */
  state?: WorldSaving | undefined;
  /**
   * What solves contacts and joints: `simdKernels`, two at a time in WebAssembly where there is such. Default: `simdKernels` with the `createWorld` of `phys2D`, and with the function
   * plain TypeScript, so that a bundle has less. The results are the same to the bit.
   */
  kernels?: Kernels | undefined;
}

/** What `WorldParams.state` is: `worldState`. */
export interface WorldSaving {
  /** Of the snapshots that it writes and reads. */
  readonly version: number;
  /** @internal the class of the bodies that it knows: that of its own copy of the engine */
  readonly bodyClass: typeof RigidBody;
  /** @internal */
  hash(world: World): string;
  /** @internal */
  snapshot(where: string, world: World, target: ArrayBuffer | undefined): ArrayBuffer;
  /** @internal */
  restore(where: string, world: World, snapshot: ArrayBuffer | ArrayBufferView, held: Iterable<unknown>): void;
}

const BROADPHASE_METHODS = ['insert', 'update', 'remove', 'clear', 'perform', 'sample'] as const;

/** What a world is made of: its lists, its settings, and the parts it owns. {@link World} is its public face. */
export abstract class WorldState {
  /** All bodies in this world. */
  readonly rigidBodies: RigidBody[] = [];
  /** All constraints in this world. */
  readonly constraints: Constraint[] = [];
  /** Dynamic bodies that are awake. */
  readonly liveDynamics: RigidBody[] = [];
  /** Kinematic bodies that are awake. */
  readonly liveKinematics: RigidBody[] = [];
  /** Constraints that are enabled and awake. */
  readonly liveConstraints: Constraint[] = [];
  /** Awake interactions, running or cached, between two dynamic bodies. */
  readonly dynamicArbiters: Arbiter[] = [];
  /** Awake interactions, running or cached, with a static or kinematic body. */
  readonly staticArbiters: Arbiter[] = [];
  /** What finds pairs of shapes that are near each other. */
  readonly broadphase: Broadphase;

  /** @internal */
  gravityX: number;
  /** @internal */
  gravityY: number;
  /** @internal from the first line of `step` until its events are about to be delivered */
  stepping = false;
  /** @internal bodies whose geometry has to be refreshed */
  readonly stale = new List<RigidBody>();
  /** @internal a body, shape or constraint did, since `letGo` */
  someLeft = false;
  /** @internal sleeping bodies hit in this step */
  readonly toWake = new List<RigidBody>();
  /** @internal pairs that are near, but go too fast to tell how they will meet from how they lie */
  readonly closing = new List<Arbiter>();
  /** @internal shapes that lie on or near several static ones, of one step */
  readonly straddling = new List<Shape>();
  /** @internal */
  readonly saving: WorldSaving | null;
  /** @internal since there was a constraint */
  jointSolver: JointSolver | null = null;
  /** @internal what the solver knows of the live constraints is out of date */
  jointsStale = false;
  /** @internal … or only which bodies are where in its arrays, or numbers of some constraint */
  jointsTouched = false;
  /** @internal grows with each body, shape and constraint added, whose `order` it becomes; of what never was in a world that is 0 */
  nextOrder = 1;
  /** @internal grows where pairs that were kept apart may interact now: a filter changed, or which joints keep their bodies from interacting */
  filters = 1;
  /** @internal that happened within this step already */
  filtersChanged = false;
  /** @internal */
  readonly pairs = new Pairs();
  /** @internal */
  readonly events = new EventQueue(this);
  /** @internal */
  readonly solver: SolverData;
  /** @internal */
  readonly islandWork = new IslandWork();
  /** @internal what moved fast in this step */
  readonly movers = new Movers();
  /** @internal what cannot be moved in this step, as its motion is not finite */
  readonly frozen = new Set<RigidBody>();
  /** @internal what sleeps though forces push it in the next step, or did in the last one */
  readonly pushed = new Set<BodyState>();
  /** @internal */
  listeners: Listeners<WorldEvents[WorldEventType]> = NO_LISTENERS;

  /** @internal */
  time = 0;
  /** @internal */
  stamp = 0;
  /** @internal events are being delivered */
  protected delivering = false;
  /** @internal */
  velocityTotal: number;
  /** @internal */
  positionTotal: number;
  /** @internal */
  substepCount: number;
  /** @internal */
  mayRest: boolean;
  private told: PoseUpdate | null = null;
  private timepiece: Clock | null = null;
  private measured: Profile | null = null;

  /** @internal use `createWorld` */
  constructor(params?: WorldParams, saving: WorldSaving | null = null, kernels: Kernels = plainKernels) {
    const where = 'createWorld';
    const given = options(where, params, false);
    const gravity = given.gravity === undefined ? [0, 10] : vector(where, 'gravity', given.gravity, 2);
    this.gravityX = gravity[0]!;
    this.gravityY = gravity[1]!;
    this.velocityTotal = integer(
      where,
      'velocityIterations',
      optional(given.velocityIterations, DEFAULT_ITERATIONS),
      1,
    );
    this.positionTotal = integer(
      where,
      'positionIterations',
      optional(given.positionIterations, DEFAULT_ITERATIONS),
      1,
    );
    this.substepCount = integer(where, 'substeps', optional(given.substeps, DEFAULT_SUBSTEPS), 1);
    this.mayRest = boolean(where, 'allowSleeping', optional(given.allowSleeping, true));
    this.saving = given.state === undefined ? saving : checkedSaving(where, given.state);
    this.solver = new SolverData(
      new JointData(),
      given.kernels === undefined ? kernels : instance(where, 'kernels', given.kernels, Kernels, 'simdKernels'),
    );
    this.broadphase =
      given.broadphase === undefined ? new BoxTreeBroadphase() : checkedBroadphase(where, given.broadphase);
    this.claimBroadphase(where);
  }

  /** @internal Before the first body comes: two worlds in one broadphase would cut each other for ever. */
  claimBroadphase(where: string): void {
    const user = users.get(this.broadphase);
    if (user !== undefined && user !== this && user.rigidBodies.length > 0) {
      throw new Error(`${where}: broadphase must not be that of another world that has bodies`);
    }
    users.set(this.broadphase, this);
  }

  /** @internal Before the first body comes to an empty world: what is played again goes as it did in a new one, whatever the steps were last. */
  beginAnew(where: string): void {
    this.claimBroadphase(where);
    this.solver.previousH = 0;
    this.solver.span = 0;
  }

  /** s. Grows by the step length at the start of each step; never reset. */
  get simulatedTime(): number {
    return this.time;
  }

  /** Number of steps; grows at the start of each step; never reset. */
  get timeStamp(): number {
    return this.stamp;
  }

  /** Velocity iterations per step in total, integer from 1 to 1e9. */
  get velocityIterations(): number {
    return this.velocityTotal;
  }

  set velocityIterations(value: number) {
    this.velocityTotal = integer('World', 'velocityIterations', value, 1);
  }

  /** Position iterations per step in total, integer from 1 to 1e9. */
  get positionIterations(): number {
    return this.positionTotal;
  }

  set positionIterations(value: number) {
    this.positionTotal = integer('World', 'positionIterations', value, 1);
  }

  /** Equal parts in which a step is integrated, integer from 1 to 1e9; the iterations are spread over them, at least one each. */
  get substeps(): number {
    return this.substepCount;
  }

  set substeps(value: number) {
    this.substepCount = integer('World', 'substeps', value, 1);
  }

  /**
   * Times the phases of each step for `profile`, such as `() => performance.now()`; `null`, the default, costs nothing. The engine has no clock of its
   * own, so that nothing it does can depend on one.
   */
  get clock(): Clock | null {
    return this.timepiece;
  }

  set clock(value: Clock | null) {
    if (value !== null) {
      callable('World', 'clock', value);
    }
    this.timepiece = value;
    this.measured = value === null ? null : new Profile(() => this.readClock(value));
  }

  /** Where the time of the latest step went; `null` without a `clock`. The same object in each step. */
  get profile(): Profile | null {
    return this.measured;
  }

  /** Told at the end of each step where bodies are, before events. Default `null`: nothing is. */
  get poses(): PoseUpdate | null {
    return this.told;
  }

  set poses(value: PoseUpdate | null) {
    if (value !== null) {
      callable('World', 'poses.update', (value as Partial<PoseUpdate> | undefined)?.update);
    }
    this.told = value;
  }

  /** Whether bodies at rest fall asleep by themselves. A change wakes everything: their delay begins anew. */
  get allowSleeping(): boolean {
    return this.mayRest;
  }

  set allowSleeping(value: boolean) {
    if (boolean('World', 'allowSleeping', value) !== this.mayRest) {
      this.mayRest = value;
      this.wakeAll();
    }
  }

  /** What a clock throws waits until the step is over, so that it cannot leave one half done. */
  private readClock(clock: Clock): number {
    try {
      return clock();
    } catch (error) {
      this.events.fail(error);
      return NaN;
    }
  }

  /** @internal wakes all bodies */
  protected abstract wakeAll(): void;
}

function checkedSaving(where: string, value: unknown): WorldSaving {
  if ((value as WorldSaving | null)?.bodyClass !== RigidBody) {
    throw typeError(where, 'state', 'worldState of the same bundle', value);
  }
  return value as WorldSaving;
}

/** The world that each broadphase is for: the one that has bodies, else the one that it was given to last. */
const users = /* @__PURE__ */ new WeakMap<Broadphase, WorldState>();

function checkedBroadphase(where: string, value: unknown): Broadphase {
  if (typeof value !== 'object' || value === null) {
    throw typeError(where, 'broadphase', 'a Broadphase', value);
  }
  for (const method of BROADPHASE_METHODS) {
    if (typeof (value as Record<string, unknown>)[method] !== 'function') {
      throw typeError(where, 'broadphase', `a Broadphase with the method ${method}`, value);
    }
  }
  return value as Broadphase;
}
