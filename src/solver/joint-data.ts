import type { RigidBody } from '../body.js';
import { JOINT_MOMENTUM } from '../config.js';
import type { Constraint } from '../constraint/constraint.js';
import { POSE } from '../constraint/layout.js';
import { writeSoftness } from '../constraint/softness.js';

/**
 * Joints: the packed form of constraints, in the order in which they are solved. A record begins with what is common to all, of which
 * the first three numbers are those of softness.ts; the rest depends on the kernel that solves it.
 */
export const SOFTNESS = 0;
export const FEEDBACK = 1;
export const RATE = 2;
/** Largest correcting speed. */
export const MAX_BIAS = 3;
/** The impulse of a sub-step is cut to this; that of the step breaks the joint above the next. */
export const LIMIT = 4;
export const BREAK = 5;
/** An error above this breaks the joint. */
export const MAX_ERROR = 6;
/** s⁻¹. What a position correction is multiplied by to become momentum. */
export const CARRY = 7;
/** 1 if position errors are corrected. */
export const PUSH = 8;
/** 1 if LIMIT or BREAK is finite. */
export const CHECKED = 9;
/** 1 if the last position iteration did without turning. */
export const SNAPPED = 10;
export const HEAD = 11;

/**
 * Rigid point joints have records without such a head: two rows with unit columns, so their arms say all. Arms, K⁻¹ and impulse in
 * velocity iterations; error at the start of the sub-step and corrections so far in position iterations …
 */
export const ARM_AX = 0;
export const ARM_AY = 1;
export const ARM_BX = 2;
export const ARM_BY = 3;
export const I11 = 4;
export const I12 = 5;
export const I22 = 6;
export const IMPULSE_X = 7;
export const IMPULSE_Y = 8;
export const ERROR_X = 9;
export const ERROR_Y = 10;
export const PUSH_X = 11;
export const PUSH_Y = 12;
/** … anchors in the coordinates of their bodies, of immovable ones in the world … */
export const ANCHOR_AX = 13;
export const ANCHOR_AY = 14;
export const ANCHOR_BX = 15;
export const ANCHOR_BY = 16;
/** … and what the step gave so far: an impulse to B, its opposite to A, and what turned each; the momentum of corrections, as CARRY. */
export const SUM_X = 17;
export const SUM_Y = 18;
export const SUM_WA = 19;
export const SUM_WB = 20;
export const POINT_CARRY = 21;
export const POINT_STRIDE = 22;

/** Kernels: rigid point joints that do not break … */
export const POINT = 0;
/** … one row between two bodies … */
export const ROW = 1;
/** … any number of rows and bodies … */
export const BLOCK = 2;
/** … and the same by callbacks. */
export const CUSTOM = 3;

/** Where things are in the record of a joint of D rows and N members. */
export class BlockLayout {
  /** λ, corrections of this sub-step, bias, error (in position iterations less its linear part), scratch, λ of the step: D each. */
  readonly impulse: number;
  readonly push: number;
  readonly bias: number;
  readonly error: number;
  readonly work: number;
  readonly total: number;
  /** Range of the last row's impulse. */
  readonly low: number;
  readonly high: number;
  /** Jacobian of velocity iterations, and of position iterations. */
  readonly jacobian: number;
  readonly turned: number;
  /** K, factored. */
  readonly matrix: number;
  /** What the step gave to each member so far. */
  readonly given: number;
  readonly size: number;

  constructor(
    readonly rows: number,
    readonly members: number,
  ) {
    this.impulse = HEAD;
    this.push = HEAD + rows;
    this.bias = HEAD + 2 * rows;
    this.error = HEAD + 3 * rows;
    this.work = HEAD + 4 * rows;
    this.total = HEAD + 5 * rows;
    this.low = HEAD + 6 * rows;
    this.high = this.low + 1;
    this.jacobian = this.low + 2;
    this.turned = this.jacobian + 3 * members * rows;
    this.matrix = this.turned + 3 * members * rows;
    this.given = this.matrix + rows * rows;
    this.size = this.given + 3 * members;
  }
}

/** A constraint's place in the packed arrays. */
export interface Joint {
  readonly constraint: Constraint;
  readonly kernel: number;
  readonly layout: BlockLayout;
  /** Offset of its record. */
  readonly at: number;
  /** Index of its first member in `bodies`. */
  readonly first: number;
  /** Pairs of members that are the same body. */
  readonly twins: readonly (readonly [number, number])[];
}

/** Joints next to each other that one kernel solves: from `start` up to, not including, `end`. */
export interface Run {
  readonly kernel: number;
  readonly start: number;
  end: number;
}

/** The joints of a world. Which there are, and their order, changes with the set of live constraints; the numbers are written in each step. */
export class JointData {
  readonly joints: Joint[] = [];
  readonly runs: Run[] = [];
  records = new Float64Array(0);
  /** Offsets of the members' records. */
  bodies = new Int32Array(0);
  /** Those that broke in this step. */
  readonly broken: Joint[] = [];
  /** s. Length of a sub-step, and how many there are. */
  h = 0;
  parts = 1;
  /** The square of the worst error as the sub-step starts … */
  readonly worst = new Float64Array(1);
  /** … and which joints have one above JOINT_SWEEP_ERROR: the first, and the one after the last. */
  readonly strained = new Int32Array(2);
  /** The pose of each member of one joint. */
  pose = new Float64Array(4 * POSE);
  /** Bodies that callbacks were shown elsewhere than where the step began, and where that was. */
  readonly shown: { readonly body: RigidBody; readonly start: readonly number[] }[] = [];
  private size = 0;
  private members = 0;

  /** Starts a new list. */
  reset(): void {
    this.joints.length = 0;
    this.runs.length = 0;
    this.size = 0;
    this.members = 0;
  }

  /** Appends a constraint to the list. */
  add(constraint: Constraint, kernel: number, layout: BlockLayout): void {
    const { joints, runs } = this;
    const twins = twinsOf(constraint.members);
    joints.push({ constraint, kernel, layout, at: this.size, first: this.members, twins });
    this.size += kernel === POINT ? POINT_STRIDE : layout.size;
    this.members += constraint.members.length;
    const run = runs[runs.length - 1];
    if (run !== undefined && run.kernel === kernel) {
      run.end += 1;
    } else {
      runs.push({ kernel, start: joints.length - 1, end: joints.length });
    }
    if (this.pose.length < POSE * layout.members) {
      this.pose = new Float64Array(POSE * layout.members);
    }
  }

  /** Ends the list: makes room for it. */
  allot(): void {
    if (this.records.length < this.size) {
      this.records = new Float64Array(2 * this.size);
    }
    if (this.bodies.length < this.members) {
      this.bodies = new Int32Array(2 * this.members);
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
    r[at + SOFTNESS] = 0;
    r[at + FEEDBACK] = 0;
    r[at + RATE] = 0;
    r[at + MAX_ERROR] = Infinity;
    r[at + PUSH] = 0;
    r[at + CHECKED] = 0;
    r.fill(0, at + HEAD, at + layout.size);
  }
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
  const { stiff, positional, breakUnderForce, breakUnderError, maxForce, maxError } = constraint;
  writeSoftness(constraint, h, parts, r, at);
  const elastic = !stiff && positional;
  r[at + MAX_BIAS] = elastic && !breakUnderError ? maxError : Infinity;
  r[at + LIMIT] = !breakUnderForce && (elastic || !positional) ? maxForce * h : Infinity;
  r[at + BREAK] = breakUnderForce ? maxForce * h * parts : Infinity;
  r[at + MAX_ERROR] = breakUnderError && positional ? maxError : Infinity;
  r[at + CARRY] = elastic || constraint.fresh ? 0 : JOINT_MOMENTUM / h;
  r[at + PUSH] = stiff && positional ? 1 : 0;
  r[at + SNAPPED] = 0;
  r[at + CHECKED] = r[at + LIMIT]! < Infinity || r[at + BREAK]! < Infinity ? 1 : 0;
}
