import type { Arbiter } from '../contact/arbiter.js';
import type { JointData } from './joint-data.js';

/**
 * The packed arrays that the iterations of a step run on. They live as long as the world and grow by doubling. A record is
 * a run of numbers at a multiple of its stride; the names below are offsets into it.
 *
 * Bodies: slot 0 stands for everything that can neither move nor be moved; awake dynamic bodies follow, then awake
 * kinematic ones. A body has a record in `velocity`, one in `motion`, one in `drive`, and in `pose` if there are joints.
 *
 * This file imports types alone: only then do its numbers stand in the loops themselves, which is worth a quarter of a step.
 */
export const BODY_STRIDE = 8;

/** `velocity`: what velocity iterations read and write. */
export const VX = 0;
export const VY = 1;
export const W = 2;
/** Inverse mass and inertia, in `velocity` and in `motion` at the same offsets. */
export const INV_MASS = 3;
export const INV_INERTIA = 4;
/** Cosine − 1 and sine of the turn since the start of the step, in `velocity`, where the contacts look anyway. */
export const COS_LESS_ONE = 5;
export const SIN = 6;
/** How near it is to strained contacts, in `velocity`, see `markHard`. */
export const MARK = 7;
/** Marks that all and no contacts are above. */
export const ALL_HARD = 0;
export const NONE_HARD = 1e9;

/** `motion`: displacement within this sub-step (velocity · h, then pushes) … */
export const QX = 0;
export const QY = 1;
export const QW = 2;
/** … and since the start of the step, without this sub-step's. */
export const DX = 5;
export const DY = 6;
export const DW = 7;

/** `drive`: what integration adds and takes in each sub-step. */
export const GAIN_X = 0;
export const GAIN_Y = 1;
export const GAIN_W = 2;
export const KEEP_LINEAR = 3;
export const KEEP_ANGULAR = 4;
/** Square of the radius of gyration times REST_SPIN_WEIGHT; negative for bodies that rest damping leaves alone … */
export const REST_RADIUS = 5;
/** … as it does with those that have no contact: 1 if the body has one. */
export const TOUCHED = 6;
/** N·s. The normal impulses that all contacts of the body together start the step with. */
export const LOAD = 7;

/** Bits of `SolverData.traits`: some joint that is no custom constraint holds the body, it has several shapes, or its surface moves. */
export const LINKED = 1;
export const COMPOUND = 2;
export const RUBS = 4;

/**
 * Contacts. With normal n, tangent t = (−n.y, n.x) and arm r, `RN` = r × n and `RT` = r × t = r · n are all that the
 * solver needs of r: n · (R(θ) r) = RT·cos θ + RN·sin θ.
 *
 * Two points lie on a line along t, or nearly so; friction at either does the same. So there is one friction for both, at a point between them, with both their loads.
 */
export const NX = 0;
export const NY = 1;
/** Share of the overlap that a position iteration removes. */
export const SHARE = 2;
/** Surface velocity along t and along n. */
export const SURFACE_T = 3;
export const SURFACE_N = 4;
export const RT_A = 5;
export const RT_B = 6;
/** Effective mass along the tangent, coefficient of friction. */
export const TANGENT_MASS = 7;
export const FRICTION = 8;
/** Impulse of this sub-step, and of the whole step without this sub-step's. */
export const TANGENT = 9;
export const TANGENT_SUM = 10;

/** Of each point: */
export const RN_A1 = 11;
export const RN_B1 = 12;
/** Impulse of this sub-step, and of the whole step without this sub-step's. */
export const NORMAL1 = 13;
export const NORMAL_SUM1 = 14;
/** What the normal velocity is driven to, with the sign changed. */
export const BIAS1 = 15;
/** Separation at the start of the step, and at the start of the sub-step. */
export const START1 = 16;
export const SEPARATION1 = 17;

/** One-point records only: effective mass along the normal. */
export const NORMAL_MASS = 18;
/** One-point records only: rolling. */
export const ROLL_MASS = 19;
export const ROLL_FRICTION = 20;
export const ROLL = 21;
export const ROLL_SUM = 22;
/** One-point records only: as RT, of what turns with the body; of a circle that is its centre, as its surface stays where it is when it turns. */
export const PIVOT_A = 23;
export const PIVOT_B = 24;
/** One-point records only: by how much friction and rolling, for each unit that they change, lessen the normal impulse that is found after them, and friction the rolling. */
export const NORMAL_OF_TANGENT = 25;
export const NORMAL_OF_ROLL = 26;
export const ROLL_OF_TANGENT = 27;
export const ONE_STRIDE = 28;
/** A bit of `ContactBatch.point`. */
export const ONE_OF_TWO = 2;

/** Two-point records only: the second point at the offsets of the first plus SECOND, and K of both points. */
export const SECOND = 8;
export const RN_A2 = RN_A1 + SECOND;
export const RN_B2 = RN_B1 + SECOND;
export const NORMAL2 = NORMAL1 + SECOND;
export const NORMAL_SUM2 = NORMAL_SUM1 + SECOND;
export const BIAS2 = BIAS1 + SECOND;
export const START2 = START1 + SECOND;
export const SEPARATION2 = SEPARATION1 + SECOND;
export const K11 = 18;
export const K22 = K11 + SECOND;
export const K12 = 27;
/** K⁻¹. */
export const I11 = 28;
export const I12 = 29;
export const I22 = 30;
/** How far friction is from the second point, 0, towards the first, 1: that much of it the first point keeps for the next step. */
export const PART = 31;
export const TWO_STRIDE = 32;

/**
 * Offsets pass through this mask in the hot loops. It changes none, as no array is that long, but tells the compiler that they are small,
 * so that adding a field to one needs no check for overflow: a twentieth of a step.
 */
export const OFFSET = 0xfffffff;

/** Contacts are solved in the order of their shapes, but each window of this many in four runs by turns. */
export const WINDOW = 128;
export const RUN = 32;

/** kg⁻¹. Stands for an infinite inverse mass, but may be multiplied by zero. */
export const IMMOVABLE = 1e30;
/** m. A separation that no motion of a step can close: switches a point off. */
export const NEVER = 1e9;
/** m/s. A bias that no impulse can meet by pushing: keeps a point out of a sub-step. */
export const OFF = 1e9;
/** rad. Up to this turn a short series for sine and cosine is exact to the last digit that matters. */
export const SMALL_TURN = 0.2;

/** Contacts of one kind, in the order in which they are solved. */
export class ContactBatch {
  count = 0;
  records = new Float64Array(0);
  /** Offsets of the two bodies' records, A then B. */
  bodies = new Int32Array(0);
  arbiters: Arbiter[] = [];
  /** Which of the arbiter's points a one-point record is, 0 or 1; with `ONE_OF_TWO` if there is another. */
  point = new Uint8Array(0);
  private capacity = 32;

  /** Grows at once: what never changed is taken for constant, and loops that were compiled for that are thrown away when it first grows. */
  constructor(readonly stride: number) {
    this.grow();
  }

  /** Appends a record for a pair. @returns its index. */
  add(pair: Arbiter): number {
    const index = this.count;
    if (index === this.capacity) {
      this.grow();
    }
    this.arbiters[index] = pair;
    this.count = index + 1;
    return index;
  }

  private grow(): void {
    this.capacity *= 2;
    this.records = widened(this.records, new Float64Array(this.capacity * this.stride));
    this.bodies = widened(this.bodies, new Int32Array(this.capacity * 2));
    this.point = widened(this.point, new Uint8Array(this.capacity));
  }
}

/** The contents of a typed array in a longer one. */
function widened<T extends { set(from: T): void }>(from: T, to: T): T {
  to.set(from);
  return to;
}

/** Points of bouncing materials: which contact of its batch, which of its points (`shift` 0 or SECOND), and what is planned for it. */
export class BounceList {
  count = 0;
  readonly batches: ContactBatch[] = [];
  index = new Int32Array(16);
  shift = new Int32Array(16);
  /** Offsets of the records of the two bodies of each. */
  bodies = new Int32Array(32);
  /** Its NX, NY, RN_A1 and RN_B1 once more, four numbers each: all of them are looked at twice in a sub-step, and most do not bounce. */
  arms = new Float64Array(64);
  bias = new Float64Array(16);
  /** Which bounced in the sub-step, see `bounce.ts`. */
  hit = new Uint8Array(16);
  /** Places in the list of the contacts that bounce in a round, by their first points. */
  bouncing = new Int32Array(16);
  /** Of the pair, to be written where a point is added: in each sub-step its arbiter would be waited for. */
  elasticity = new Float64Array(16);

  /** @returns the place in the list. */
  add(batch: ContactBatch, index: number, shift: number): number {
    const i = this.count;
    if (i === this.index.length) {
      this.grow();
    }
    this.batches[i] = batch;
    this.index[i] = index;
    this.shift[i] = shift;
    this.bodies[2 * i] = batch.bodies[2 * index]!;
    this.bodies[2 * i + 1] = batch.bodies[2 * index + 1]!;
    const { records, stride } = batch;
    const record = index * stride;
    this.arms[4 * i] = records[record + NX]!;
    this.arms[4 * i + 1] = records[record + NY]!;
    this.arms[4 * i + 2] = records[record + shift + RN_A1]!;
    this.arms[4 * i + 3] = records[record + shift + RN_B1]!;
    this.bias[i] = 0;
    this.count = i + 1;
    return i;
  }

  private grow(): void {
    const size = this.index.length * 2;
    this.index = widened(this.index, new Int32Array(size));
    this.shift = widened(this.shift, new Int32Array(size));
    this.bodies = widened(this.bodies, new Int32Array(2 * size));
    this.arms = widened(this.arms, new Float64Array(4 * size));
    this.bias = widened(this.bias, new Float64Array(size));
    this.bouncing = new Int32Array(size);
    this.hit = new Uint8Array(size);
    this.elasticity = widened(this.elasticity, new Float64Array(size));
  }
}

/** Everything the solver keeps for a world. Of it only the previous sub-step's length and what joints remember survives a step. */
export class SolverData {
  bodyCount = 0;
  velocity = new Float64Array(64 * BODY_STRIDE);
  motion = new Float64Array(64 * BODY_STRIDE);
  drive = new Float64Array(64 * BODY_STRIDE);
  /** Placements as the sub-step starts; constraint/layout.ts names the offsets. */
  pose = new Float64Array(64 * BODY_STRIDE);
  /** What contacts ask of their bodies, by slot: bits. */
  traits = new Uint8Array(64);
  /** The pairs that are being packed; what lies beyond their count is old. */
  readonly window: Arbiter[] = [];
  readonly one = new ContactBatch(ONE_STRIDE);
  readonly two = new ContactBatch(TWO_STRIDE);
  readonly bounces = new BounceList();
  /**
   * Parts of the contacts that are hard to solve, four numbers each: from where to where, of those of two points and of one. What lies beyond
   * the count is old: shortening the list would cost its storage.
   */
  readonly hard: number[] = [];
  hardCount = 0;
  /** Something was taken from what an awake body lies on or carries. */
  unloads = false;
  /** Set by a position iteration in which circles overlapped deeply. */
  crowded = false;
  /** How many sub-steps the step has: handlers may ask for others meanwhile. */
  parts = 1;
  /** s. Length of the sub-steps of the last step … */
  previousH = 0;
  /**
   * … and what its impulses are multiplied by to fit the present ones. Begins with a fraction: a field that turns from an integer into a number with one
   * gives the object another layout, and what was compiled for the old one, the solver's loops, is never compiled as a whole again.
   */
  impulseScale = 0.5;

  constructor(readonly joints: JointData) {}

  clearContacts(): void {
    this.one.count = 0;
    this.two.count = 0;
    this.bounces.count = 0;
    this.hardCount = 0;
  }

  /** Makes room for `count` bodies; slot 0 is cleared, the others are to be filled. */
  resetBodies(count: number): void {
    this.bodyCount = count;
    if (count * BODY_STRIDE > this.velocity.length) {
      const size = Math.max(count, (this.velocity.length / BODY_STRIDE) * 2);
      this.velocity = new Float64Array(size * BODY_STRIDE);
      this.motion = new Float64Array(size * BODY_STRIDE);
      this.drive = new Float64Array(size * BODY_STRIDE);
      this.pose = new Float64Array(size * BODY_STRIDE);
      this.traits = new Uint8Array(size);
    }
    this.motion.fill(0, 0, count * BODY_STRIDE);
    this.velocity.fill(0, 0, BODY_STRIDE);
    this.drive.fill(0, 0, BODY_STRIDE);
    this.drive[KEEP_LINEAR] = 1;
    this.drive[KEEP_ANGULAR] = 1;
    this.drive[REST_RADIUS] = -1;
  }
}
