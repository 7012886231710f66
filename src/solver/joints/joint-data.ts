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
  /** Offset of its record; of a rigid point joint, of what it keeps. */
  readonly at: number;
  /** Which of the records of rigid point joints it has in a step, and whether these are solved two at a time … */
  slot: number;
  isPaired: boolean;
  /** … of two groups, each of which has every second record. */
  isBeside: boolean;
  /** Index of its first member in `bodies`. */
  readonly first: number;
  /** rad. That of a point that keeps an angle, else NaN: see `order/pinned.ts`. */
  readonly angle: number;
  /** Pairs of members that are the same body. */
  readonly twins: readonly (readonly [number, number])[];
}

/** Joints next to each other that one kernel solves: from `start` up to, not including, `end`. No more than a window of contacts, see `inPieces`. */
export interface Run {
  readonly kernel: number;
  readonly start: number;
  end: number;
  /** At the start of the sub-step some error was larger than is asked for. */
  isOff: boolean;
}

/** Joints that hang together. */
export class Group {
  // As long as the same joints hang together.

  end: number;
  readonly runs: Run[] = [];
  /** Another one lies beside it, joint by joint: as no body hangs on both, both can be solved at once. */
  isBeside = false;
  /** Of the first of two that lie side by side, the other one, which comes next. */
  beside: Group | null = null;
  /** Offsets of the bodies that move, each once. */
  readonly bodies = new List<number>();
  /** A joint holds something that does not move, too. */
  isAnchored = false;
  /** How often its joints hold on to something static or kinematic. */
  anchors = 0;
  /** Joints hold it to what does not move at two places or more: they may not all be met. */
  isBetween = false;
  /** Some body has three of its joints or more. */
  branches = false;
  /** Some of its joints are custom constraints. */
  hasCustoms = false;
  /** m, rad. The part of the worst error for which it is swept over once more. */
  tolerance = 0;
  /** A motor that turns, or a custom constraint that is no spring, does what nobody knows. */
  isDriven = false;
  /** One of its joints breaks under force. */
  mayBreak = false;
  /** Hz. That of the hardest of its springs. */
  frequency = 0;
  /** Welds hold it together, and leave nothing of it to move: it turns as one body. */
  isWhole = false;
  /** Its joints may pull against each other: see `energy/stress.ts`. */
  isOverheld = false;
  /** There are more joints than are needed, so that what each of them gives is not determined: they are never solved to their end. */
  isIndeterminate = false;
  /** There are, and of several kinds, as points and then angles. They are swept over to and fro: one way rings of nine bodies and more would tremble, ever more, and lose all momentum as that is taken back. */
  isMixed = false;

  // Carried over from step to step, and so part of the state of a world: see `keepGroup` in `state/rows.ts`.

  /** One of the joints was changed before this step, or they hang together in another way: some may have gone. */
  fresh = true;
  /** The heaviest of the bodies, and how they hang together, are yet to be looked at. */
  isNew = true;
  /** One body is far heavier than another: sweeps are slow to close the joints between these. */
  burdened = false;
  /** Its joints may make energy, if sub-steps are too long for them. */
  mayGain = false;
  /** Its joints leave little to move: if it stands on something, or is held, they are solved to their end, see `plan/gradients.ts`. */
  isMechanism = false;
  /** Few rigid joints that do not break, some of which hang on what does not move: what they leave to move is solved to its end, see `mayBeFirm` in `plan/plan.ts`. */
  isHeld = false;
  /** Some body is a hub, so that all joints are swept over to and fro: see `plan/hubs.ts`. */
  toAndFro = false;
  /** How often it is swept over in this sub-step, spread over the iterations. */
  sweeps = 1;
  /** Which of its joints these sweeps are over, but for the last one, which is over all. */
  from = 0;
  to = 0;
  /** s. Corrections make as much momentum as in a sub-step of this length: the present one's, or more after longer ones. */
  span = 0;
  /** For so many steps more large errors are corrected without momentum. */
  settling = 0;
  /** For so many steps there was an error that no sweep removed. */
  stuck = 0;
  /** For so many steps its velocities told of far more motion than there was. */
  untrue = 0;
  /** For so many steps it touched nothing, FIRM_STEPS at most: very few joints are solved to their end after as many. */
  untouched = FIRM_STEPS;
  /** J. What its joints made in the steps so far, and was not taken back yet; below 0 what was lost a short while ago. */
  excess = 0;

  // Of the step.

  /** One of the bodies is in contact. */
  touched = false;
  /** So few of them are in contact that it stands on something, rather than lies in a heap; known of mechanisms. */
  stands = false;
  /** A frame that stands on something, and whose joints were open as the step began: see `touching/momentum.ts`. */
  isBent = false;
  /** In this step its bodies are told how they moved, as its joints cannot all be met: see `energy/motion.ts`. */
  isUnmet = false;
  /** An error is above JOINT_TORN: corrections make no momentum, and part of what joints gave is forgotten. */
  isTorn = false;
  /** It is looked at in this step for the energy its joints make: see `energy/energy.ts`. */
  isWatched = false;
  /** Of what is watched and touches something: neither that nor what it is with touches or hangs on something that is not dynamic. */
  isAfloat = false;
  /** Of what is watched and touches something: offsets of the bodies that lie on its own, or on those. */
  readonly guests = new List<number>();
  /** J. Of its bodies, as the step begins. */
  energy = 0.5;

  // Of the sub-step.

  /** The square of the largest error at the start of the sub-step. */
  error = 0;
  /** The square of the largest error that the first position iteration found. */
  pushed = 0;
  /** In this sub-step they are solved to their end. */
  isFirm = false;

  /** Without joints, the first of which will be at `start`. */
  constructor(readonly start: number) {
    this.end = start;
  }
}

/** Joints by callbacks. */
export function hasCallbacks({ kernel }: Run): boolean {
  return kernel === CUSTOM;
}

/** Whether the numbers of a joint stay in its record from step to step, and are only fetched when somebody asks. */
export function keepsNumbers(kernel: number): boolean {
  return kernel === POINT || kernel === TURN;
}

/** The joints of a world. Which there are, and their order, changes with the set of live constraints; the numbers are written in each step. */
export class JointData {
  readonly joints: Joint[] = [];
  readonly runs: Run[] = [];
  readonly groups: Group[] = [];
  records = new Float64Array(0);
  /** Offsets of the members' records. */
  bodies = new Int32Array(0);
  /** Those that broke in this step … */
  readonly broken: Joint[] = [];
  /** … and those that ask for something else than in the last one, which are corrected bit by bit in the sub-steps that are left. */
  readonly shifted: Joint[] = [];
  substepsLeft = 1;
  /** s. Length of a sub-step, and how many there are. */
  h = 0;
  substeps = 1;
  /** Steps since the joints were listed, up to EASE_STEPS, and from 1 on again: that of the world would make a level that is played again in the same world another one. Part of its state. */
  age = 0;
  /** Some joint is a custom constraint. */
  hasCustoms = false;
  /** There are springs in this step. Their work is added up, by slot … */
  hasSprings = false;
  work = new Float64Array(0);
  /** … for which the velocities are kept with which a sub-step began: three of each body. */
  begun = new Float64Array(0);
  /** Squares: the worst error of a group so far in this sweep or at the start of the sub-step, of rigid point joints by whether their slots are even or odd … */
  readonly worst = new Float64Array(2);
  /** … and the error from which on a joint is off … */
  readonly asked = new Float64Array(1);
  /** … and which are off: the first, and the one after the last. */
  readonly off = new Int32Array(2);
  /** rad/s. … and by how much the motor that is farthest from its rate misses it. */
  readonly lag = new Float64Array(1);
  /** What share of the momentum of the corrections of a group is made, at the end of a sub-step. As the others no number of its own, which would be boxed where it is handed on. */
  readonly share = new Float64Array(1);
  /** m, rad. The largest error that is left. */
  readonly left = new Float64Array(1);
  /** The pose of each member of one joint. */
  pose = new Float64Array(4 * POSE);
  /** Bodies that callbacks were shown elsewhere than where the step began, and where that was. */
  readonly shown = new Map<RigidBody, Float64Array>();
  /** Counts the steps: what constraints fetched before is not so any more. */
  solved = 0;
  /** How many records there are for rigid point joints in a step: of two side by side the second is missing if it would share a body with the first or be of another run. */
  slots = 0;
  /** How many numbers all records have, and how many members all joints. */
  size = 0;
  members = 0;
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

/** What a joint that keeps its numbers here has in its record. */
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

/** Lets all constraints fetch what they have not yet. */
export function fetchAll({ joints }: JointData): void {
  for (const { constraint } of joints) {
    constraint.fetch();
  }
}

/** Notes that a joint broke; from now on it does nothing. */
export function breakJoint(data: JointData, joint: Joint): void {
  data.broken.push(joint);
  silence(data, joint);
}

/** Takes a joint out of the rest of the step: it is as soft as can be, so nothing it finds has an effect. */
export function silence({ records: r }: JointData, { at, layout }: Joint): void {
  r.fill(0, at, at + layout.size);
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
