import type { RigidBody } from '../../body.js';
import { FIRM_STEPS, JOINT_MOMENTUM } from '../../config-joints.js';
import type { Constraint, Numbers } from '../../constraint/constraint.js';
import { POSE } from '../../constraint/layout.js';
import { writeSoftness } from '../../constraint/softness.js';
import { List } from '../../math/list.js';
import {
  type BlockLayout,
  BREAK,
  CARRY,
  CHECKED,
  CUSTOM,
  KEPT_IMPULSE_X,
  KEPT_IMPULSE_Y,
  KEPT_ORIGIN_AX,
  KEPT_ORIGIN_AY,
  KEPT_SUM_WA,
  KEPT_SUM_WB,
  KEPT_SUM_X,
  KEPT_SUM_Y,
  LIMIT,
  MAX_BIAS,
  MAX_ERROR,
  POINT,
  PUSH,
  REACH,
  SNAPPED,
  SNAPS,
  TURN,
  TURN_GIVEN_A,
  TURN_GIVEN_B,
  TURN_IMPULSE,
} from './joint-layout.js';

/** A constraint's place in the packed arrays. */
export interface Joint {
  readonly constraint: Constraint;
  readonly kernel: number;
  readonly layout: BlockLayout;
  /** Offset of its record; for a rigid point joint, of what it keeps from step to step. */
  readonly at: number;
  /** The index of its record for a step, if it is a rigid point joint; whether these are solved two at a time … */
  slot: number;
  isPaired: boolean;
  /** … and whether two groups share them, each with every second record. */
  isBeside: boolean;
  /** Index of its first member in `bodies`. */
  readonly first: number;
  /** rad. The angle that a point keeps, else NaN: see `order/pinned.ts`. */
  readonly angle: number;
  /** Pairs of indices of members that are the same body. */
  readonly twins: readonly (readonly [number, number])[];
  /** Until one of the joints is changed: it drives its bodies, … */
  drives: boolean;
  /** … and its impulse turns with its bodies where these may be stressed, see `energy/stress.ts`. */
  turns: boolean;
}

/**
 * Joints next to each other that one kernel solves: from `start` up to, not including, `end`. At most as many as a window of contacts, see
 * `inPieces`.
 */
export interface Run {
  readonly kernel: number;
  readonly start: number;
  end: number;
  /** At the start of the sub-step, some error was larger than the one from which on joints are off. */
  isOff: boolean;
}

/**
 * Joints that hang together: those that are reached from one by way of the dynamic bodies that they share. Its fields are ordered by how
 * long they are valid.
 */
export class Group {
  // As long as the same joints hang together. Written as they are listed, in `order`.

  end: number;
  readonly runs: Run[] = [];
  /** Another group lies beside it, joint by joint: as no body is in both, both can be solved at once. */
  isBeside = false;
  /** For the first of two that lie side by side: the other one, which comes next. */
  beside: Group | null = null;
  /** How many members of its joints are static or kinematic. */
  anchors = 0;
  /** Some body has three of its joints or more. */
  branches = false;
  /** Some of its joints are custom constraints. */
  hasCustoms = false;
  /** m, rad. It is swept over once more for each such part of its worst error. */
  tolerance = 0;

  // Until one of the joints is changed. Written as a step begins, by `listBodies`, `lookAtKinds` and `lookAtStress`.

  /** Offsets of the records of the bodies that move, each once. */
  readonly bodies = new List<number>();
  /** Some member of a joint does not move. */
  isAnchored = false;
  /** Joints hold it to bodies that do not move at two places or more, so it may be that they cannot all be met. */
  isHeldTwice = false;
  /** It has a motor that turns, or a custom constraint that is no spring, whose work is not known. */
  isDriven = false;
  /** One of its joints breaks under force. */
  mayBreak = false;
  /** Hz. The frequency of the hardest of its springs; 0 without any. */
  frequency = 0;
  /** Welds hold it together so that nothing of it can move by itself: it turns as one body. */
  isWhole = false;
  /** Its joints may pull against each other: see `energy/stress.ts`. */
  isOverheld = false;
  /** There are more joints than needed, so that the impulse of each is not determined. Such joints are never solved to their end. */
  isIndeterminate = false;
  /**
   * The same, and they are of several kinds, such as points and then angles. They are swept over to and fro: swept one way, rings of nine
   * bodies and more would tremble, ever more, and lose all momentum as that energy is taken back.
   */
  isMixed = false;

  // From step to step: part of the state of a world, see `keepGroup` in `state/rows.ts`. First what `classify` in `plan/plan.ts` finds …

  /** It is yet to be looked at. */
  isNew = true;
  /** One body is far heavier than another. Sweeps are slow to close the joints between these. */
  burdened = false;
  /** Its joints may make energy, if sub-steps are too long for them. */
  mayGain = false;
  /**
   * Its joints leave few degrees of freedom: if it stands on something, or is held, they are solved to their end, see `plan/gradients.ts`.
   */
  isMechanism = false;
  /**
   * It has few rigid joints that do not break, some of which are held by what does not move. Whatever freedom they leave, they are solved
   * to their end under the conditions of `mayBeFirm` in `plan/plan.ts`.
   */
  isSmallAndHeld = false;
  /** Some body is a hub, or `isMixed`: all joints are swept over to and fro, see `plan/hubs.ts`. */
  toAndFro = false;

  // … then what changes from step to step …

  /** One of the joints was changed before this step, or the set of joints that hang together changed: some may have gone. */
  fresh = true;
  /** For so many steps more, large errors are corrected without momentum. */
  settling = 0;
  /** The number of steps in a row with an error that no sweep removed, at most STUCK_STEPS. */
  stuckSteps = 0;
  /** The number of steps in a row in which its velocities meant far more motion than there was, at most UNTRUE_STEPS. */
  untrueSteps = 0;
  /**
   * The number of steps in a row in which it touched nothing, at most FIRM_STEPS: after as many, very few joints are solved to their end.
   */
  untouchedSteps = FIRM_STEPS;
  /** J. The energy that its joints made in the steps so far and that was not taken back yet; below 0, what they lost a short while ago. */
  excess = 0;
  /** J. What the group and its guests lost since it touches something, below 0: a bridge gives back some of what fell onto it. */
  lost = 0;

  // … and from sub-step to sub-step: the plan.

  /** How many velocity sweeps it has in this sub-step, spread over the iterations. */
  sweeps = 1;
  /** Indices of the joints that these sweeps are over, from the first to the one after the last; the last sweep is over all. */
  from = 0;
  to = 0;
  /** s. Corrections make as much momentum as in a sub-step of this length: that of the present one, or more after longer ones. */
  span = 0;

  // In this step. Written as it begins and, from `stands` to `isTorn`, with the plan of its first sub-step.

  /** One of its bodies is in contact. */
  touched = false;
  /** What its bodies touch, as bits of `touching/neighbours.ts`. */
  neighbours = 0;
  /** So few of its bodies are in contact that it stands on something, rather than lies in a heap. Set for mechanisms only. */
  stands = false;
  /** It is a frame that stands on something, and its joints were open as the step began: see `touching/momentum.ts`. */
  isBent = false;
  /** Its joints cannot all be met, so its bodies may get the velocities with which they moved: see `energy/motion.ts`. */
  isUnmet = false;
  /** So is a torn one, with an error above JOINT_TORN: its corrections make no momentum, and part of its impulses is forgotten. */
  isTorn = false;
  /** The energy that its joints make is looked at in this step: see `energy/energy.ts`. */
  isWatched = false;
  /** For a watched group that touches something: neither it nor its guests touch or hang on anything that is not dynamic. */
  isAfloat = false;
  /** For a watched group that touches something: offsets of the other bodies of its company, see `energy/company.ts`. */
  readonly guests = new List<number>();
  /** J. The energy of its bodies and guests, as the step begins. */
  energy = 0.5;

  // In this sub-step.

  /** The square of the largest error at the start of the sub-step. */
  errorSquare = 0;
  /** The square of the largest error that the last exact position sweep found. */
  pushedSquare = 0;
  /** For one of two side by side: how many position sweeps have been done over both at once. */
  pushed = 0;
  /** The last of these found no error of this one. */
  isPushed = false;
  /** Its joints are solved to their end in this sub-step. */
  isFirm = false;

  /** Makes a group without joints; the first one will be at `start`. */
  constructor(readonly start: number) {
    this.end = start;
  }
}

/** Whether the joints of a run are custom constraints. */
export function hasCallbacks({ kernel }: Run): boolean {
  return kernel === CUSTOM;
}

/** Whether the numbers of joints of a kernel stay in their records from step to step, and are only fetched when somebody asks. */
export function keepsNumbers(kernel: number): boolean {
  return kernel === POINT || kernel === TURN;
}

/** The joints of a world. The list and its order change with the set of live constraints; the numbers are written in each step. */
export class JointData {
  readonly joints: Joint[] = [];
  readonly runs: Run[] = [];
  readonly groups: Group[] = [];
  records = new Float64Array(0);
  /** Offsets of the records of the members' bodies, joint by joint. */
  bodies = new Int32Array(0);
  /** Joints that broke in this step … */
  readonly broken: Joint[] = [];
  /**
   * … and joints whose bounds or anchors were changed since the last step: they are corrected bit by bit in the sub-steps that are left.
   */
  readonly shifted: Joint[] = [];
  substepsLeft = 1;
  /** Length of a sub-step, s, and how many there are. */
  h = 0;
  substeps = 1;
  /**
   * The number of steps since the joints were listed, up to EASE_STEPS, and then from 1 again. Part of the state. The step count of the
   * world would not do: a level that is played again in the same world would go differently.
   */
  age = 0;
  /** Some joint is a custom constraint. */
  hasCustoms = false;
  /** There are springs in this step. Their work, J, is added up by slot … */
  hasSprings = false;
  work = new Float64Array(0);
  /** … for which the velocities at the start of a sub-step are kept: three numbers for each body. */
  begun = new Float64Array(0);
  /**
   * Squared: the worst error of a group so far in this sweep or at the start of the sub-step, of rigid point joints by whether their slots
   * are even or odd …
   */
  readonly worst = new Float64Array(2);
  /** … the error above which a joint is off … */
  readonly asked = new Float64Array(1);
  /** … and the joints that are off: the index of the first, and that after the last. */
  readonly off = new Int32Array(2);
  /** rad/s. By how much the motor that is farthest from its rate misses it. */
  readonly lag = new Float64Array(1);
  /**
   * The share of the momentum of corrections that is made at the end of a sub-step. An array like the others, as a number would be boxed
   * where it is passed on.
   */
  readonly share = new Float64Array(1);
  /** m, rad. The largest error that is left, found by the `measure…` functions and as blocks are linearised. */
  readonly left = new Float64Array(1);
  /** The pose of each member of one joint. */
  pose = new Float64Array(4 * POSE);
  /** Bodies that were moved for callbacks, with their placements as the step began. */
  readonly shown = new Map<RigidBody, Float64Array>();
  /** Counts the steps: what constraints fetched in an earlier one is no longer valid. */
  solved = 0;
  /**
   * How many records there are for rigid point joints in a step. Of two side by side, the second is missing if it would share a body with
   * the first or belong to another run.
   */
  slots = 0;
  /** How many numbers all records have together, and how many members all joints. */
  size = 0;
  members = 0;
}

/** Before a sweep, or a sub-step. */
export function clearWorst({ worst }: JointData): void {
  worst[0] = 0;
  worst[1] = 0;
}

/** Starts a new list. */
export function resetJoints(data: JointData): void {
  for (const { constraint } of data.joints) {
    constraint.leave(data);
  }
  data.joints.length = 0;
  data.runs.length = 0;
  data.groups.length = 0;
  data.hasCustoms = false;
  data.age = 0;
  data.size = 0;
  data.members = 0;
}

/** Reads the impulse of a joint that keeps its numbers here, and what it gave to each body, from its record. */
export function fetchNumbers({ joints, records: r }: JointData, index: number, { impulse, given }: Numbers): void {
  const { kernel, at } = joints[index]!;
  if (kernel === TURN) {
    impulse[0] = r[at + TURN_IMPULSE]!;
    given[2] = r[at + TURN_GIVEN_A]!;
    given[5] = r[at + TURN_GIVEN_B]!;
    return;
  }
  impulse[0] = r[at + KEPT_IMPULSE_X]!;
  impulse[1] = r[at + KEPT_IMPULSE_Y]!;
  given[0] = -r[at + KEPT_SUM_X]!;
  given[1] = -r[at + KEPT_SUM_Y]!;
  given[2] = r[at + KEPT_SUM_WA]!;
  given[3] = r[at + KEPT_SUM_X]!;
  given[4] = r[at + KEPT_SUM_Y]!;
  given[5] = r[at + KEPT_SUM_WB]!;
  for (let k = 0; k < 2; k += 1) {
    const x = r[at + KEPT_ORIGIN_AX + 2 * k]!;
    const y = r[at + KEPT_ORIGIN_AY + 2 * k]!;
    if (x !== 0 || y !== 0) {
      given[3 * k + 2] = given[3 * k + 2]! - (x * given[3 * k + 1]! - y * given[3 * k]!);
    }
  }
}

/** Lets all constraints fetch their numbers, if they have not yet. */
export function fetchAll({ joints }: JointData): void {
  for (const { constraint } of joints) {
    constraint.fetch();
  }
}

/** Notes that a joint broke; from now on it has no effect. */
export function breakJoint(data: JointData, joint: Joint): void {
  data.broken.push(joint);
  silence(data, joint);
}

/** Takes a joint out of the rest of the step: with softness 0, nothing it finds has an effect. */
export function silence({ records: r }: JointData, { at, layout }: Joint): void {
  r.fill(0, at, at + layout.own);
  r[at + MAX_ERROR] = Infinity;
}

/** Writes the head of a record. */
export function packHead(data: JointData, joint: Joint): void {
  const { records: r, h, substeps } = data;
  const { constraint, at } = joint;
  const { isElastic, stiff, positional, breakUnderForce, breakUnderError, maxForce, maxError } = constraint;
  writeSoftness(constraint, h, substeps, r, at);
  r[at + MAX_BIAS] = isElastic && !breakUnderError ? maxError : Infinity;
  r[at + LIMIT] = !breakUnderForce && (isElastic || !positional) ? maxForce * h : Infinity;
  r[at + BREAK] = breakUnderForce ? maxForce * h * substeps : Infinity;
  r[at + MAX_ERROR] = breakUnderError && positional ? maxError : Infinity;
  r[at + CARRY] = isElastic ? 0 : JOINT_MOMENTUM / h;
  r[at + PUSH] = stiff && positional ? 1 : 0;
  r[at + SNAPPED] = 0;
  r[at + SNAPS] = 0;
  r[at + REACH] = Infinity;
  r[at + CHECKED] = r[at + LIMIT]! < Infinity || r[at + BREAK]! < Infinity ? 1 : 0;
}
