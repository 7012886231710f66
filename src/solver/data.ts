import type { Arbiter } from '../contact/arbiter.js';
import { ELASTICITY } from '../contact/layout.js';
import type { Kernels } from '../kernels.js';
import { grown, widened } from '../math/doubles.js';
import { List } from '../math/list.js';
import type { JointData } from './joints/joint-data.js';
import type { PointKernels } from './joints/kernels/points.js';
import * as d from './layout.js';
import type { Loops } from './loops.js';
import type { Scratch } from './scratch.js';

/** The index at which the record of a contact begins, of `stride` numbers. */
export function recordAt(index: number, stride: number): number {
  return (index & d.EVEN) * stride + (index & 1);
}

/** The batch of a contact. Here and elsewhere one number stands for a contact: twice its index, plus 1 if it is of one point. */
export function batchOf({ one, two }: SolverData, contact: number): ContactBatch {
  return (contact & 1) === 1 ? one : two;
}

/** Packs that nothing is added to the velocity of a body or taken from it. */
export function packUndriven({ drive }: SolverData, slot: number): void {
  const at = slot * d.BODY_STRIDE;
  drive.fill(0, at, at + d.BODY_STRIDE);
  drive[at + d.KEEP_LINEAR] = 1;
  drive[at + d.KEEP_ANGULAR] = 1;
  drive[at + d.REST_RADIUS] = -1;
}

/** The impulses of a contact in its record: of two points both normal ones and friction; of one the third is that of rolling. */
export const IMPULSES = [d.NORMAL1, d.TANGENT, d.NORMAL2];

/** Contacts of one kind, in the order in which they are solved. */
export class ContactBatch {
  count = 0;
  /** Lent for a step, like the offsets below: see `scratch.ts`. */
  records = new Float64Array(0);
  /** Offsets of the two bodies' records, A then B. */
  bodies = new Int32Array(0);
  capacity = 0;
  arbiters: Arbiter[] = [];
  /**
   * Of the arbiters, for storing the step: the slab and place of each pair's record, and its bits. Else storing would wait for the memory
   * of each arbiter.
   */
  numbers: Float64Array[] = [];
  at = new Int32Array(0);
  bits = new Int32Array(0);
  /** Which of the arbiter's points the record of a one-point contact is, 0 or 1; with `ONE_OF_TWO` if there is another. */
  point = new Uint8Array(0);

  constructor(
    readonly stride: number,
    private readonly owner: SolverData,
  ) {}

  /** Appends a record for a pair. @returns its index. */
  add(pair: Arbiter): number {
    const index = this.count;
    if (index === this.capacity) {
      this.owner.makeRoomForContacts(this.owner.one.count + 1, this.owner.two.count + 1);
    }
    this.arbiters[index] = pair;
    this.numbers[index] = pair.numbers;
    this.at[index] = pair.at;
    this.bits[index] = pair.bits;
    this.count = index + 1;
    return index;
  }

  lay(records: Float64Array<ArrayBuffer>, bodies: Int32Array<ArrayBuffer>): void {
    this.records = records;
    this.bodies = bodies;
    this.capacity = bodies.length / 2;
    if (this.point.length < this.capacity) {
      this.point = widened(this.point, new Uint8Array(this.capacity));
      this.at = widened(this.at, new Int32Array(this.capacity));
      this.bits = widened(this.bits, new Int32Array(this.capacity));
    }
  }
}

/** The impulse with which a contact or joint starts the next step, if it started this one with `before` and now has `now`. Never −0. */
export function remember({ remembered }: SolverData, before: number, now: number): number {
  return (remembered > 0 ? now + remembered * (before - now) : now) + 0;
}

/** Points of materials that bounce: each one's contact, which of its points it is (`shift` 0 or SECOND), and what is planned for it. */
export class BounceList {
  count = 0;
  readonly batches: ContactBatch[] = [];
  index = new Int32Array(16);
  /** Where the record of its contact begins. */
  record = new Int32Array(16);
  shift = new Int32Array(16);
  /** Offsets of the records of the two bodies. */
  bodies = new Int32Array(32);
  /**
   * The normal and arms of its contact once more, see `layout.ts`: all points of the list are looked at twice in a sub-step, and most do
   * not bounce.
   */
  arms = new Float64Array(16 * d.BOUNCE_STRIDE);
  /**
   * What is planned: below 0 the normal velocity, with the sign changed, that a bounce ends with; 0 nothing; `OFF` that the point is left
   * out; else with what speed it leaves anyway, m/s.
   */
  bias = new Float64Array(16);
  /** With what speed a point that bounced was to leave, m/s. */
  leaves = new Float64Array(16);
  /** Whether it bounced in the sub-step, or is going to, see `bounce.ts`. */
  state = new Uint8Array(16);
  /** The contacts that bounce in the present round: the places of their first points in the list. */
  bouncing = new Int32Array(16);
  /** Of the pair: else each sub-step would wait for its memory. */
  elasticity = new Float64Array(16);
  /** m. How deep its shapes may overlap before that is an impact; 0 if nobody has asked yet. */
  depth = new Float64Array(16);

  /** Adds a point. */
  add(batch: ContactBatch, index: number, shift: number): void {
    const i = this.count;
    if (i === this.index.length) {
      this.grow();
    }
    const { records, stride } = batch;
    const record = recordAt(index, stride);
    this.batches[i] = batch;
    this.index[i] = index;
    this.record[i] = record;
    this.shift[i] = shift;
    this.bodies[2 * i] = batch.bodies[2 * index]! & d.OFFSET;
    this.bodies[2 * i + 1] = batch.bodies[2 * index + 1]!;
    const at = d.BOUNCE_STRIDE * i;
    this.arms[at + d.BOUNCE_NX] = records[record + d.NX]!;
    this.arms[at + d.BOUNCE_NY] = records[record + d.NY]!;
    this.arms[at + d.BOUNCE_RN_A] = records[record + shift + d.RN_A1]!;
    this.arms[at + d.BOUNCE_RN_B] = records[record + shift + d.RN_B1]!;
    this.bias[i] = 0;
    this.elasticity[i] = batch.numbers[index]![batch.at[index]! + ELASTICITY]!;
    this.depth[i] = 0;
    this.count = i + 1;
  }

  private grow(): void {
    const size = this.index.length * 2;
    this.index = widened(this.index, new Int32Array(size));
    this.record = widened(this.record, new Int32Array(size));
    this.shift = widened(this.shift, new Int32Array(size));
    this.bodies = widened(this.bodies, new Int32Array(2 * size));
    this.arms = widened(this.arms, new Float64Array(d.BOUNCE_STRIDE * size));
    this.bias = widened(this.bias, new Float64Array(size));
    this.leaves = new Float64Array(size);
    this.bouncing = new Int32Array(size);
    this.state = new Uint8Array(size);
    this.elasticity = widened(this.elasticity, new Float64Array(size));
    this.depth = widened(this.depth, new Float64Array(size));
  }
}

/** Contacts of bodies that turn together, see `turning.ts`. What lies beyond the count is of earlier steps. */
export class TurningList {
  /** As `batchOf` takes them. */
  readonly contacts: number[] = [];
  kept = new Float64Array(8 * d.TURNING_STRIDE);
  count = 0;

  /** Adds a contact. @returns where its numbers are to be kept. */
  add(contact: number): number {
    const at = d.TURNING_STRIDE * this.count;
    if (at === this.kept.length) {
      this.kept = widened(this.kept, new Float64Array(2 * at));
    }
    this.contacts[this.count] = contact;
    this.count += 1;
    return at;
  }
}

/**
 * What was struck in a step, see `shocks.ts`. Contacts are as `batchOf` takes them. A contact has two ends, one at each body: twice its
 * number, plus 1 for B.
 */
export class ShockList {
  /** Contacts whose surfaces approach each other fast as the step begins, or whose bodies hang on joints. */
  readonly struck = new List<number>();
  /** By contact, for those of `struck`: the normal impulse with which the step began, N·s. The numbers of pairs would have to be waited for. */
  before = new Float64Array(64);
  /** Linked lists of the ends at each body: `first` by slot, `next` by end. Made at most once a step. */
  isLinked = false;
  first = new Int32Array(64);
  next = new Int32Array(256);
  /** By slot: that the body is refused, or the latest round in which it was found. There is one round for each sub-step. */
  known = new Int32Array(64);
  round = 0;
  /** By slot: one more than the index of the group of joints, 0 if there is none, or UNSOLVABLE. */
  groupOf = new Int32Array(64);
  /** The shock that was found last; and how many more contacts and joints it may have, negative if there were too many. */
  readonly contacts = new List<number>();
  readonly groups = new List<number>();
  readonly slots = new List<number>();
  room = 0;
  /** Groups of joints that were struck in the sub-step. */
  readonly struckGroups = new List<number>();

  clear(): void {
    this.struck.clear();
    this.struckGroups.clear();
    this.isLinked = false;
  }

  reserve(bodies: number, ends: number): void {
    if (bodies > this.first.length) {
      this.first = new Int32Array(grown(bodies));
      this.known = new Int32Array(grown(bodies));
      this.groupOf = new Int32Array(grown(bodies));
    }
    if (ends > this.next.length) {
      this.next = new Int32Array(grown(ends));
    }
  }
}

/** What is squeezed, see `squeezes.ts`. */
export class SqueezeList {
  /** Contacts deeper than SQUEEZE_DEPTH, as `batchOf` takes them; later only those of them that are of what is squeezed. */
  readonly contacts = new List<number>();
  /** The impulse with which each of their points, two by two, may start a sub-step however deep it is, N·s. */
  least = new Float64Array(0);
  /**
   * Sets of `math/sets.ts`, by index in `liveDynamics`. By their roots: the impulse of their weight in a sub-step, N·s; whether joints are
   * in them; and whether they are squeezed.
   */
  parent = new Int32Array(0);
  weight = new Float64Array(0);
  tied = new Uint8Array(0);
  pressed = new Uint8Array(0);

  reserve(bodies: number, contacts: number): void {
    if (bodies > this.parent.length) {
      this.parent = new Int32Array(grown(bodies));
      this.weight = new Float64Array(grown(bodies));
      this.tied = new Uint8Array(grown(bodies));
      this.pressed = new Uint8Array(grown(bodies));
    }
    if (2 * contacts > this.least.length) {
      this.least = new Float64Array(grown(2 * contacts));
    }
  }
}

/** Everything the solver keeps for a world. Only the lengths of earlier sub-steps, and what joints remember, survive a step. */
export class SolverData {
  bodyCount = 0;
  /**
   * The loops over bodies and contacts; and the arrays that they work on, which are lent for a step, as those of contacts are. At other
   * times these may be anyone's.
   */
  loops: Loops | null = null;
  velocity = new Float64Array(0);
  motion = new Float64Array(0);
  /** Placements at the start of the sub-step, if there are joints; `constraint/layout.ts` names the offsets. */
  pose = new Float64Array(0);
  /**
   * Rigid point joints: their records, the offsets of the two bodies' records, and the loops over them, if there are others than those in
   * TypeScript.
   */
  points = new Float64Array(0);
  pointBodies = new Int32Array(0);
  pointKernels: PointKernels | null = null;
  drive = new Float64Array(0);
  /** By slot: what contacts have to know of their bodies, as bits, see LINKED in `layout.ts`. */
  traits = new Uint8Array(64);
  /** The pairs that are being packed. What lies beyond their count is of earlier windows. */
  readonly window: Arbiter[] = [];
  readonly one = new ContactBatch(d.ONE_STRIDE, this);
  readonly two = new ContactBatch(d.TWO_STRIDE, this);
  readonly bounces = new BounceList();
  readonly shocks = new ShockList();
  readonly squeezes = new SqueezeList();
  readonly turning = new TurningList();
  /** Contacts of bodies that may be hooked into each other, as `batchOf` takes them. */
  readonly hooked = new List<number>();
  /**
   * Parts of the contacts that are hard to solve, HARD_STRIDE numbers each. What lies beyond the count is of earlier steps: shortening the
   * list would cost its storage.
   */
  readonly hard: number[] = [];
  hardCount = 0;
  /** For how many pairs, of which not all are contacts, room was last made at once: as soon as there are twice as many it is again. */
  roomFor = 0;
  /** Whether something was taken away that an awake body rested on or carried. */
  unloads = false;
  /** Which circles that move overlapped deeply in the latest position iteration: CROWDED, PRESSED. */
  deepCircles = 0;
  /** How many sub-steps the running step has: handlers may set another number meanwhile. */
  substeps = 1;
  /** s. Length of the sub-steps of the last step; and of those that impulses are remembered from, the longest of late. */
  previousH = 0;
  span = 0;
  /** How many steps of such sub-steps there were in a row: for as long as these took they are remembered. */
  spans = 0;
  /**
   * Share of the impulse with which a contact or joint started a step that it also starts the next one with: 0, except in sub-steps that
   * are shorter than those that are remembered.
   */
  remembered = 0.5;
  /**
   * Factor on the impulses of the last step, to fit the length of the present sub-steps. Starts as a fraction: a field that turns from an
   * integer into a fraction gives the object another layout, and what was compiled for the old one, the solver's loops, is never compiled
   * as a whole again.
   */
  impulseScale = 0.5;
  /** The same for contacts. Where the other is 0, impulses of contacts were dropped one by one, see `dropUnsteady` in `prepare.ts`. */
  contactScale = 0.5;

  private scratch: Scratch | null = null;

  constructor(
    readonly joints: JointData,
    private readonly kernels: Kernels,
  ) {}

  /**
   * Whether nothing is awake, so that nothing moves: there is no body but the one that stands for everything that cannot move, and no
   * joint.
   */
  get isIdle(): boolean {
    return this.bodyCount === 1 && this.joints.runs.length === 0;
  }

  /** How many contacts are hard to solve. */
  get hardContacts(): number {
    const { hard, hardCount } = this;
    let count = 0;
    for (let i = 0; i < hardCount; i += d.HARD_STRIDE) {
      count += hard[i + d.TO_TWO]! - hard[i + d.FROM_TWO]! + hard[i + d.TO_ONE]! - hard[i + d.FROM_ONE]!;
    }
    return count;
  }

  clearContacts(): void {
    this.one.count = 0;
    this.two.count = 0;
    this.bounces.count = 0;
    this.shocks.clear();
    this.squeezes.contacts.clear();
    this.turning.count = 0;
    this.hooked.clear();
    this.hardCount = 0;
  }

  /** Takes arrays for a step, with room for `count` bodies. Slot 0 is cleared, the others are to be filled. */
  resetBodies(count: number): void {
    this.bodyCount = count;
    this.scratch = this.kernels.lend(this, this.scratch);
    this.scratch.reserve(count, 0, 0, 0);
    this.lay(this.scratch);
    if (count > this.traits.length) {
      this.traits = new Uint8Array(grown(count));
    }
    this.motion.fill(0, 0, count * d.BODY_STRIDE);
    this.velocity.fill(0, 0, d.BODY_STRIDE);
    packUndriven(this, 0);
  }

  /** Makes room for so many contacts of one point and of two. */
  makeRoomForContacts(ones: number, twos: number): void {
    const scratch = this.scratch!;
    scratch.reserve(this.bodyCount, ones, twos, 0);
    this.lay(scratch);
  }

  /** Makes room for so many rigid point joints. */
  makeRoomForPoints(count: number): void {
    const scratch = this.scratch!;
    scratch.reserve(this.bodyCount, 0, 0, count);
    this.lay(scratch);
  }

  /** Gives the arrays back. */
  returnArrays(): void {
    if (this.scratch !== null) {
      this.scratch.user = null;
    }
  }

  private lay({ room, doubles, offsets }: Scratch): void {
    this.loops = room.loops;
    this.pointKernels = room.pointKernels;
    this.velocity = doubles[0]!;
    this.motion = doubles[1]!;
    this.pose = doubles[2]!;
    this.drive = doubles[3]!;
    this.one.lay(doubles[4]!, offsets[0]!);
    this.two.lay(doubles[5]!, offsets[1]!);
    this.points = doubles[6]!;
    this.pointBodies = offsets[2]!;
  }
}
