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

/** The type of `World.poses`: a `PoseBuffer`, or anything with this method. */
export interface PoseUpdate {
  /** Called at the end of each step, before events. The rules for their handlers apply. */
  update(): void;
}

/** Called with the interaction, `this` = the world. */
export type WorldContactHandler = (this: World, arbiter: Arbiter) => void;

/** Called with the collision that has begun and how hard it was, `this` = the world. */
export type WorldHitHandler = (this: World, arbiter: Arbiter, hit: Hit) => void;

/** Called with the body that was frozen, `this` = the world. */
export type WorldBodyHandler = (this: World, body: RigidBody) => void;

/** The events of a world, and the types of their handlers. Those of shapes are reported for all shapes in the world, each once. */
export interface WorldEvents {
  /** Two shapes touch for the first time, or again. */
  begin: WorldContactHandler;
  /** They still touch in another step, and are awake. */
  progress: WorldContactHandler;
  /** They no longer touch, or one of them is gone. */
  end: WorldContactHandler;
  /** A collision has begun. */
  hit: WorldHitHandler;
  /** A body was frozen, because its motion would not have been finite. */
  nonfinite: WorldBodyHandler;
}

/** The types of events of a world. */
export type WorldEventType = keyof WorldEvents;

/** Options of `createWorld`. */
export interface WorldParams {
  /** Finds pairs of shapes that are near each other: any object with that interface. Default: a box tree. */
  broadphase?: Broadphase | undefined;
  /** Gravity, m/s². Default `[0, 10]`: down, as y points down. */
  gravity?: Vec2Like | undefined;
  /** Velocity iterations per step, integer from 1 to 1e9; they are spread over the sub-steps, at least one each. Default 8. */
  velocityIterations?: number | undefined;
  /** Position iterations per step, as `velocityIterations`. Default 8. */
  positionIterations?: number | undefined;
  /** Sub-steps: the equal parts in which a step is integrated, integer from 1 to 1e9; the iterations are spread over them. Default 4. */
  substeps?: number | undefined;
  /** Whether bodies at rest fall asleep by themselves. Default `true`. */
  allowSleeping?: boolean | undefined;
  /**
   * What implements `snapshot`, `restore` and `hash`: `worldState`. Default: `worldState` with `phys2D.createWorld`; with the function
   * `createWorld` nothing, so that a bundle that saves no worlds has no code for it, and these methods throw.
   */
  state?: WorldSaving | undefined;
  /**
   * The loops that solve contacts and joints: `simdKernels`, which work on two at a time, in WebAssembly where that is available. Default:
   * `simdKernels` with `phys2D.createWorld`; with the function `createWorld` plain TypeScript, so that a bundle is smaller. The results are
   * the same to the bit.
   */
  kernels?: Kernels | undefined;
}

/** The type of `WorldParams.state`: `worldState`. */
export interface WorldSaving {
  /** The version of the snapshots that it writes and reads. */
  readonly version: number;
  /** @internal the class of bodies in its own copy of the engine */
  readonly bodyClass: typeof RigidBody;
  /** @internal */
  hash(world: World): string;
  /** @internal */
  snapshot(where: string, world: World, target: ArrayBuffer | undefined): ArrayBuffer;
  /** @internal */
  restore(where: string, world: World, snapshot: ArrayBuffer | ArrayBufferView, held: Iterable<unknown>): void;
}

const BROADPHASE_METHODS = ['insert', 'update', 'remove', 'clear', 'perform', 'sample'] as const;

/** The world that uses each broadphase: the one that has bodies, else the last one it was given to. */
const users = /* @__PURE__ */ new WeakMap<Broadphase, WorldState>();

/** The state of a world: its lists, its settings, and the parts it owns. {@link World} is its public face. */
export abstract class WorldState {
  /** All bodies in this world, in no order. `addRigidBody` and `removeRigidBody` change it, nobody else should; to remove what you walk through, walk through a copy. */
  readonly rigidBodies: RigidBody[] = [];
  /** All constraints in this world; as `rigidBodies`. */
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
  /** @internal in `step`, until its events are about to be delivered */
  stepping = false;
  /** @internal bodies whose geometry has to be refreshed */
  readonly stale = new List<RigidBody>();
  /** @internal a body, shape or constraint has left since `letGo` was last called */
  someLeft = false;
  /** @internal sleeping bodies that were hit in this step */
  readonly toWake = new List<RigidBody>();
  /** @internal pairs that are near each other, but too fast to tell from their placements how they will meet */
  readonly closing = new List<Arbiter>();
  /** @internal shapes that lie on or near several static ones in this step */
  readonly straddling = new List<Shape>();
  /** @internal deep contacts of this step, where one of the bodies has several shapes */
  readonly deep = new List<Arbiter>();
  /** @internal */
  readonly saving: WorldSaving | null;
  /** @internal the solver of constraints, since the first one was added */
  jointSolver: JointSolver | null = null;
  /** @internal the solver has to list the live constraints anew */
  jointsStale = false;
  /** @internal … or only the slots of their bodies, or numbers of some constraint, have changed */
  jointsTouched = false;
  /** @internal the `order` of the next body, shape or constraint that is added; one that was never in a world has 0 */
  nextOrder = 1;
  /**
   * @internal grows whenever pairs that were kept apart may interact from now on: a filter changed, or which joints keep their bodies from
   * interacting
   */
  filters = 1;
  /** @internal `filters` has grown within this step already */
  filtersChanged = false;
  /** @internal */
  readonly pairs = new Pairs();
  /** @internal */
  readonly events = new EventQueue(this);
  /** @internal */
  readonly solver: SolverData;
  /** @internal */
  readonly islandWork = new IslandWork();
  /** @internal the bodies that moved fast in this step */
  readonly movers = new Movers();
  /** @internal bodies that are frozen in this step, as their motion is not finite */
  readonly frozen = new Set<RigidBody>();
  /** @internal sleeping bodies on which forces act in the next step, or did in the last one */
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

  /** @internal Called before the first body is added: two worlds in one broadphase would break each other for good. */
  claimBroadphase(where: string): void {
    const user = users.get(this.broadphase);
    if (user !== undefined && user !== this && user.rigidBodies.length > 0) {
      throw new Error(`${where}: broadphase must not be that of another world that has bodies`);
    }
    users.set(this.broadphase, this);
  }

  /**
   * @internal Called before the first body is added to an empty world: what is played again there goes as it did in a new one, whatever the
   * last steps were.
   */
  beginAnew(where: string): void {
    this.claimBroadphase(where);
    this.solver.previousH = 0;
    this.solver.span = 0;
  }

  /** Simulated time, s. Grows by the step length at the start of each step; never reset. */
  get simulatedTime(): number {
    return this.time;
  }

  /** Number of steps so far. Grows at the start of each step; never reset. */
  get timeStamp(): number {
    return this.stamp;
  }

  /** Velocity iterations per step, over all sub-steps; integer from 1 to 1e9. */
  get velocityIterations(): number {
    return this.velocityTotal;
  }

  set velocityIterations(value: number) {
    this.velocityTotal = integer('World', 'velocityIterations', value, 1);
  }

  /** Position iterations per step, over all sub-steps; integer from 1 to 1e9. */
  get positionIterations(): number {
    return this.positionTotal;
  }

  set positionIterations(value: number) {
    this.positionTotal = integer('World', 'positionIterations', value, 1);
  }

  /** Sub-steps: the equal parts in which a step is integrated, integer from 1 to 1e9; the iterations are spread over them, at least one each. */
  get substeps(): number {
    return this.substepCount;
  }

  set substeps(value: number) {
    this.substepCount = integer('World', 'substeps', value, 1);
  }

  /**
   * A clock that times the phases of each step for `profile`, such as `() => performance.now()`. The default, `null`, costs nothing. The
   * engine has no clock of its own, so that no result can depend on one.
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

  /** The times of the phases of the latest step; `null` without a `clock`. The same object in each step. */
  get profile(): Profile | null {
    return this.measured;
  }

  /** An object that is updated with the placements of bodies at the end of each step, before events. Default `null`. */
  get poses(): PoseUpdate | null {
    return this.told;
  }

  set poses(value: PoseUpdate | null) {
    if (value !== null) {
      callable('World', 'poses.update', (value as Partial<PoseUpdate> | undefined)?.update);
    }
    this.told = value;
  }

  /** Whether bodies at rest fall asleep by themselves. A change wakes everything: the delay until they sleep begins anew. */
  get allowSleeping(): boolean {
    return this.mayRest;
  }

  set allowSleeping(value: boolean) {
    if (boolean('World', 'allowSleeping', value) !== this.mayRest) {
      this.mayRest = value;
      this.wakeAll();
    }
  }

  /** What the clock throws waits until the step is over, so that no step is left half done. */
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
