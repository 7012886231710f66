import type { World } from './world.js';

/** Milliseconds, or whatever the clock counts, since any moment. */
export type Clock = () => number;

/** What the step is made of, in the order in which it comes first. */
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

/** The parts of a step that are timed. */
export type Phase = (typeof PHASES)[number];

/**
 * Where the time of the latest step went, and how much there was to do: `world.profile`, while `world.clock` is set. Times are what the clock counts,
 * milliseconds of `performance.now`; they add up to the whole step.
 */
export class Profile {
  /** Bounds and broadphase brought up to date, pairs found, collisions worked out, `preSolve` handlers. */
  pairs = 0;
  /** Looking ahead for what moves fast. */
  foresight = 0;
  /** Islands; what rests falls asleep. */
  islands = 0;
  /** Writing bodies, contacts and joints into the arrays of the solver. */
  prepare = 0;
  /** Forces, warm start and velocity iterations, of all sub-steps. */
  velocities = 0;
  /** Motion and position iterations, of all sub-steps. */
  positions = 0;
  /** Writing the outcome back. */
  store = 0;
  /** Impacts of what moved fast. */
  continuous = 0;
  /** Handlers. */
  events = 0;

  /** Bodies in the solver, dynamic and kinematic. */
  awakeBodies = 0;
  /** Pairs of shapes whose bounds overlap, or that interacted a short while ago, with something awake. */
  activePairs = 0;
  /** Pairs of shapes, no sensors, whose collision was worked out. */
  manifolds = 0;
  /** Contacts in the solver, of one and of two points. */
  contacts = 0;
  /** How many of `contacts` are in parts that are swept over more often. */
  hardContacts = 0;
  /** Constraints in the solver. */
  joints = 0;
  /** Groups of awake dynamic bodies that touch or are tied, and sleep and wake together; 0 while `allowSleeping` is false. */
  awakeIslands = 0;
  /** Impacts that were found by sweeping. */
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

  /** @internal the time since the last call went into a phase */
  lap(phase: Phase): void {
    const now = this.clock();
    this[phase] += now - this.last;
    this.last = now;
  }

  /** @internal what the solver has to do */
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
