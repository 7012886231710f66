import type { World } from './world.js';

/** A clock: returns the time in milliseconds, or in any other unit, since any moment. */
export type Clock = () => number;

/** The phases of a step, in the order in which they first come. */
export const PHASES = [
  'pairs',
  'foresight',
  'islands',
  'prepare',
  'velocities',
  'positions',
  'store',
  'continuous',
  'events',
] as const;

/** A phase of a step that is timed. */
export type Phase = (typeof PHASES)[number];

/**
 * The times of the phases of the latest step, and the amount of work in it: `world.profile`, while `world.clock` is set. Times are in the
 * unit of the clock, milliseconds for `performance.now`; they add up to the whole step.
 */
export class Profile {
  /** Update of bounds and broadphase, search for pairs, narrow phase, `preSolve` handlers. */
  pairs = 0;
  /** Prediction of contacts of what moves fast. */
  foresight = 0;
  /** Search for islands, and putting those at rest to sleep. */
  islands = 0;
  /** Packing of bodies, contacts and joints into the arrays of the solver. */
  prepare = 0;
  /** Forces, warm start and velocity iterations, of all sub-steps. */
  velocities = 0;
  /** Integration of positions and position iterations, of all sub-steps. */
  positions = 0;
  /** Writing the results back to bodies, contacts and joints. */
  store = 0;
  /** Continuous collision: impacts of what moved fast. */
  continuous = 0;
  /** Event handlers. */
  events = 0;

  /** Bodies in the solver, dynamic and kinematic. */
  awakeBodies = 0;
  /** Pairs of shapes, with at least one awake body, whose bounds overlap or that interacted a short while ago. */
  activePairs = 0;
  /** Pairs of shapes that the narrow phase collided; without sensors. */
  manifolds = 0;
  /** Contact constraints in the solver, each of one or two points. */
  contacts = 0;
  /** How many of `contacts` are hard to solve, and get more iterations. */
  hardContacts = 0;
  /** Constraints in the solver. */
  joints = 0;
  /**
   * Awake islands: groups of dynamic bodies that touch or are connected by constraints, and sleep and wake together; 0 while
   * `allowSleeping` is false.
   */
  awakeIslands = 0;
  /** Impacts that continuous collision found. */
  impacts = 0;

  private last = 0;

  /** @internal */
  constructor(private readonly clock: Clock) {}

  /** @internal starts a step */
  begin(): void {
    for (const phase of PHASES) {
      this[phase] = 0;
    }
    this.impacts = 0;
    this.last = this.clock();
  }

  /** @internal adds the time since the last call to a phase */
  lap(phase: Phase): void {
    const now = this.clock();
    this[phase] += now - this.last;
    this.last = now;
  }

  /** @internal counts the work of the step */
  count({ solver, pairs, timeStamp, islandWork }: World): void {
    this.awakeBodies = solver.bodyCount - 1;
    this.activePairs = pairs.sorted.count;
    this.contacts = solver.one.count + solver.two.count;
    this.hardContacts = solver.hardContacts;
    this.joints = solver.joints.joints.length;
    this.manifolds = 0;
    for (let i = 0; i < pairs.sorted.count; i += 1) {
      const { sensor, seen } = pairs.sorted.items[i]!;
      this.manifolds += !sensor && seen === timeStamp ? 1 : 0;
    }
    this.awakeIslands = islandWork.awake;
  }
}
