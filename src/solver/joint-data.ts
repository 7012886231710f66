import type { RigidBody } from '../body.js';
import { KINEMATIC } from '../body-kind.js';
import {
  FEW_JOINTS,
  JOINT_MOMENTUM,
  JOINT_SWEEP_ERROR,
  JOINT_SWEEP_ERROR_OF_FEW,
  NEW_JOINT_SWEEPS,
} from '../config.js';
import type { Constraint, Keeper, Numbers } from '../constraint/constraint.js';
import { POSE } from '../constraint/layout.js';
import { writeSoftness } from '../constraint/softness.js';
import {
  type BlockLayout,
  BREAK,
  CARRY,
  CHECKED,
  KEPT_IMPULSE_X,
  KEPT_IMPULSE_Y,
  KEPT_STRIDE,
  KEPT_SUM_WA,
  KEPT_SUM_WB,
  KEPT_SUM_X,
  KEPT_SUM_Y,
  LIMIT,
  MAX_BIAS,
  MAX_ERROR,
  POINT,
  PUSH,
  SNAPPED,
  SNAPS,
  TURN,
  TURN_GIVEN_A,
  TURN_GIVEN_B,
  TURN_IMPULSE,
  TURN_STRIDE,
} from './joint-layout.js';
import { WINDOW } from './layout.js';

/** So many rigid point joints are solved two at a time, if that takes no more records than so many for each: ragdolls and single chains are as fast one by one. */
const FEWEST_PAIRED = 24;
const MOST_RECORDS = 1.5;

/** From so many rigid point joints on, two groups of as many and nothing else lie side by side. */
const FEWEST_BESIDE = 4;

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
  /** Pairs of members that are the same body. */
  readonly twins: readonly (readonly [number, number])[];
}

/** Joints next to each other that one kernel solves: from `start` up to, not including, `end`. No more than a window of contacts, see `inPieces`. */
export interface Run {
  readonly kernel: number;
  readonly start: number;
  end: number;
  /** At the start of the sub-step some error was larger than is asked for. */
  isStrained: boolean;
}

/** Joints that hang together. */
export class Group {
  end: number;
  readonly runs: Run[] = [];
  /** m, rad. The part of the worst error for which it is swept over once more. */
  tolerance = 0;
  /** One of the joints was changed before this step. */
  fresh = false;
  /** For so many steps more large errors are corrected without momentum. */
  settling = 0;
  /** s. Corrections make as much momentum as in a sub-step of this length: the present one's, or more after longer ones. */
  span = 0;
  /** How often it is in this sub-step, spread over the iterations … */
  sweeps = 1;
  /** … and which of its joints, but in the last sweep. */
  from = 0;
  to = 0;
  /** One of the bodies is in contact. */
  touched = false;
  /** The square of the largest error at the start of the sub-step … */
  error = 0;
  /** … and of the largest that the first position iteration found. */
  pushed = 0;
  /** Another one lies beside it, joint by joint: as no body hangs on both, both can be solved at once … */
  isBeside = false;
  /** … of the first of them, the other one, which comes next. */
  beside: Group | null = null;

  /** Without joints, the first of which will be at `start`. */
  constructor(readonly start: number) {
    this.end = start;
  }
}

/** Whether the numbers of a joint stay in its record from step to step, and are only fetched when somebody asks. */
export function keepsNumbers(kernel: number): boolean {
  return kernel === POINT || kernel === TURN;
}

/** The joints of a world. Which there are, and their order, changes with the set of live constraints; the numbers are written in each step. */
export class JointData implements Keeper {
  readonly joints: Joint[] = [];
  readonly runs: Run[] = [];
  readonly groups: Group[] = [];
  records = new Float64Array(0);
  /** Offsets of the members' records. */
  bodies = new Int32Array(0);
  /** Those that broke in this step. */
  readonly broken: Joint[] = [];
  /** s. Length of a sub-step, and how many there are. */
  h = 0;
  parts = 1;
  /** In this step what touches something may be swept over once less. */
  eases = false;
  /** Squares: the worst error of a group so far in this sweep or at the start of the sub-step, of rigid point joints by whether their slots are even or odd … */
  readonly worst = new Float64Array(2);
  /** … and the error from which on a joint is strained … */
  readonly asked = new Float64Array(1);
  /** … and which are strained: the first, and the one after the last. */
  readonly strained = new Int32Array(2);
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
  private size = 0;
  private members = 0;

  /** Starts a new list. */
  reset(): void {
    for (const { constraint } of this.joints) {
      constraint.leave(this);
    }
    this.joints.length = 0;
    this.runs.length = 0;
    this.groups.length = 0;
    this.size = 0;
    this.members = 0;
  }

  /** Appends a constraint to the last group. */
  add(constraint: Constraint, kernel: number, layout: BlockLayout): void {
    const { joints } = this;
    const group = this.groups[this.groups.length - 1]!;
    const twins = twinsOf(constraint.members);
    if (keepsNumbers(kernel)) {
      constraint.keepAt(this, joints.length);
    }
    const run = group.runs[group.runs.length - 1];
    group.end += 1;
    if (run !== undefined && run.kernel === kernel && run.end - run.start < WINDOW) {
      run.end += 1;
    } else {
      const added = { kernel, start: joints.length, end: joints.length + 1, isStrained: false };
      group.runs.push(added);
      this.runs.push(added);
    }
    const at = this.size;
    const first = this.members;
    joints.push({ constraint, kernel, layout, at, slot: 0, isPaired: false, isBeside: false, first, twins });
    this.size += kernel === POINT ? KEPT_STRIDE : kernel === TURN ? TURN_STRIDE : layout.size;
    this.members += constraint.members.length;
    if (this.pose.length < POSE * layout.members) {
      this.pose = new Float64Array(POSE * layout.members);
    }
  }

  /**
   * Ends the list: makes room for it. More sweeps make impulses of a sudden load larger: where joints may break by them they are kept few, else chains
   * break as they are built.
   */
  allot(): void {
    for (const group of this.groups) {
      const isCareful = this.joints.slice(group.start, group.end).some(({ constraint }) => constraint.breakUnderForce);
      group.tolerance = isCareful ? JOINT_SWEEP_ERROR : toleranceOf(group.end - group.start);
      group.sweeps = isCareful || !this.isNew(group) ? 1 : NEW_JOINT_SWEEPS;
    }
    this.allotSlots();
    if (this.records.length < this.size) {
      this.records = new Float64Array(2 * this.size);
    }
    if (this.bodies.length < this.members) {
      this.bodies = new Int32Array(2 * this.members);
    }
  }

  /** Gives rigid point joints their records for a step. Side by side lie no two that share a body. */
  private allotSlots(): void {
    this.slots = 0;
    for (const run of this.runs) {
      if (run.kernel === POINT) {
        this.allotRun(run);
      }
    }
    const { groups } = this;
    for (let i = 0; i + 1 < groups.length; i += 1) {
      const group = groups[i]!;
      const next = groups[i + 1]!;
      if (this.isChain(group) && this.isChain(next) && this.mayLieBeside(group, next)) {
        group.beside = next;
        group.isBeside = true;
        next.isBeside = true;
        this.layBeside(group, next);
        i += 1;
      }
    }
  }

  /** Within a run, where two would share a body, the second is missing. Where most would be, as in a chain, joints are solved one by one. */
  private allotRun({ start, end }: Run): void {
    const joints = this.joints.slice(start, end);
    let offset = 0;
    const offsets = joints.map(({ constraint }, k) => {
      const isSecond = k > 0 && offset % 2 === 1;
      offset += isSecond && sharesBody(constraint, joints[k - 1]!.constraint) ? 2 : 1;
      return offset - 1;
    });
    const isPaired = joints.length >= FEWEST_PAIRED && offset < MOST_RECORDS * joints.length;
    for (const [k, joint] of joints.entries()) {
      joint.isPaired = isPaired;
      joint.slot = this.slots + (isPaired ? offsets[k]! : k);
    }
    this.slots = joints[joints.length - 1]!.slot + 1;
    this.slots += this.slots & 1;
  }

  /** One run of rigid point joints, solved one by one. */
  private isChain({ start, end, runs }: Group): boolean {
    return (
      end - start >= FEWEST_BESIDE && runs.length === 1 && runs[0]!.kernel === POINT && !this.joints[start]!.isPaired
    );
  }

  /** Of as many joints, and what moves by its own will does not hang on two that would lie side by side. */
  private mayLieBeside({ start, end }: Group, next: Group): boolean {
    return (
      next.end - next.start === end - start &&
      this.joints.slice(start, end).every(({ constraint: { members } }, k) => {
        const { constraint } = this.joints[next.start + k]!;
        return !members.some((body) => body.kind === KINEMATIC && constraint.members.includes(body));
      })
    );
  }

  /** Two chains: the first one gets the even slots of both, the other one the odd ones. */
  private layBeside({ start, end }: Group, { end: last }: Group): void {
    const { slot } = this.joints[start]!;
    for (let k = start; k < last; k += 1) {
      const joint = this.joints[k]!;
      joint.isPaired = true;
      joint.isBeside = true;
      joint.slot = slot + (k < end ? 2 * (k - start) : 2 * (k - end) + 1);
    }
  }

  /** Most of its joints carried nothing yet. */
  private isNew({ start, end }: Group): boolean {
    let count = 0;
    for (let k = start; k < end; k += 1) {
      if (this.joints[k]!.constraint.impulse.every((part) => part === 0)) {
        count += 1;
      }
    }
    return 2 * count > end - start;
  }

  /** What a joint that keeps its numbers here has in its record. */
  fetch(index: number, { impulse, given }: Numbers): void {
    const { records: r } = this;
    const { kernel, at } = this.joints[index]!;
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
  }

  /** Lets all constraints fetch what they have not yet. */
  fetchAll(): void {
    for (const { constraint } of this.joints) {
      constraint.fetch();
    }
  }

  /** Notes that a joint broke; from now on it does nothing. */
  break(joint: Joint): void {
    this.broken.push(joint);
    this.silence(joint);
  }

  /** Takes a joint out of the rest of the step: it is as soft as can be, so nothing it finds has an effect. */
  silence(joint: Joint): void {
    const { records: r } = this;
    const { at, layout } = joint;
    r.fill(0, at, at + layout.size);
    r[at + MAX_ERROR] = Infinity;
  }
}

/** Of so many joints that hang together. */
function toleranceOf(count: number): number {
  const tolerance = (JOINT_SWEEP_ERROR_OF_FEW * count) / FEW_JOINTS;
  return Math.min(JOINT_SWEEP_ERROR, Math.max(JOINT_SWEEP_ERROR_OF_FEW, tolerance));
}

function sharesBody({ members }: Constraint, other: Constraint): boolean {
  return members.some((body) => other.members.includes(body));
}

/** Each member that was listed before, with the first place it was listed at. */
function twinsOf(members: Constraint['members']): [number, number][] {
  return members.flatMap((body, k): [number, number][] => {
    const first = members.indexOf(body);
    return first < k ? [[first, k]] : [];
  });
}

/** Writes the head of a record. */
export function packHead(data: JointData, joint: Joint): void {
  const { records: r, h, parts } = data;
  const { constraint, at } = joint;
  const { isElastic, stiff, positional, breakUnderForce, breakUnderError, maxForce, maxError } = constraint;
  writeSoftness(constraint, h, parts, r, at);
  r[at + MAX_BIAS] = isElastic && !breakUnderError ? maxError : Infinity;
  r[at + LIMIT] = !breakUnderForce && (isElastic || !positional) ? maxForce * h : Infinity;
  r[at + BREAK] = breakUnderForce ? maxForce * h * parts : Infinity;
  r[at + MAX_ERROR] = breakUnderError && positional ? maxError : Infinity;
  r[at + CARRY] = isElastic ? 0 : JOINT_MOMENTUM / h;
  r[at + PUSH] = stiff && positional ? 1 : 0;
  r[at + SNAPPED] = 0;
  r[at + SNAPS] = 0;
  r[at + CHECKED] = r[at + LIMIT]! < Infinity || r[at + BREAK]! < Infinity ? 1 : 0;
}
