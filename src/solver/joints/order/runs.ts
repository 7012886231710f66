import type { RigidBody } from '../../../body.js';
import { DYNAMIC, KINEMATIC } from '../../../body-kind.js';
import { FEW_JOINTS, JOINT_SWEEP_ERROR, JOINT_SWEEP_ERROR_OF_FEW, NEW_JOINT_SWEEPS } from '../../../config-joints.js';
import type { Constraint } from '../../../constraint/constraint.js';
import { POSE } from '../../../constraint/layout.js';
import { WINDOW } from '../../layout.js';
import { type Group, type Joint, type JointData, keepsNumbers, type Run } from '../joint-data.js';
import { type BlockLayout, CUSTOM, KEPT_STRIDE, POINT, TURN, TURN_STRIDE } from '../joint-layout.js';

// Lists joints: which lie side by side in runs, and where each has its numbers. A bundle without constraints has none of this.

/**
 * From this many rigid point joints on, they are solved two at a time, if that takes no more than this many records for each: ragdolls and
 * single chains are as fast one by one.
 */
const FEWEST_PAIRED = 24;
const MOST_RECORDS = 1.5;

/** From this many rigid point joints on, two groups of as many and of nothing else are laid side by side. */
const FEWEST_BESIDE = 4;

/** Appends a constraint to the last group; a point that keeps an angle with that angle. */
export function addJoint(
  data: JointData,
  constraint: Constraint,
  kernel: number,
  layout: BlockLayout,
  angle = Number.NaN,
): void {
  const { joints, size, members } = data;
  const group = data.groups[data.groups.length - 1]!;
  const twins = twinsOf(constraint.members);
  if (keepsNumbers(kernel)) {
    constraint.keepAt(data, joints.length);
  }
  const run = group.runs[group.runs.length - 1];
  group.end += 1;
  group.hasCustoms ||= kernel === CUSTOM;
  data.hasCustoms ||= kernel === CUSTOM;
  if (run !== undefined && run.kernel === kernel && run.end - run.start < WINDOW) {
    run.end += 1;
  } else {
    const added = { kernel, start: joints.length, end: joints.length + 1, isOff: false };
    group.runs.push(added);
    data.runs.push(added);
  }
  const where = { at: size, slot: 0, isPaired: false, isBeside: false, first: members };
  joints.push({ constraint, kernel, layout, ...where, angle, twins, drives: false, turns: false });
  data.size += kernel === POINT ? KEPT_STRIDE : kernel === TURN ? TURN_STRIDE : layout.size;
  data.members += constraint.members.length;
  if (data.pose.length < POSE * layout.members) {
    data.pose = new Float64Array(POSE * layout.members);
  }
}

/**
 * Ends the list: allots records, and sets how often new groups are swept over. More sweeps make the impulses of a sudden load larger: where
 * joints may break by them, sweeps are kept few, else chains break as they are built.
 */
export function allot(data: JointData): void {
  for (const group of data.groups) {
    const isCareful = data.joints.slice(group.start, group.end).some(({ constraint }) => constraint.breakUnderForce);
    group.tolerance = toleranceOf(group.end - group.start);
    group.sweeps = isCareful || !carriesNothing(data, group) ? 1 : NEW_JOINT_SWEEPS;
    group.branches = branches(data, group);
  }
  allotSlots(data);
  if (data.records.length < data.size) {
    data.records = new Float64Array(2 * data.size);
  }
  if (data.bodies.length < data.members) {
    data.bodies = new Int32Array(2 * data.members);
  }
}

/** Whether some dynamic body has three joints or more. Only bodies with as many constraints are counted, as few have them. */
function branches({ joints }: JointData, { start, end }: Group): boolean {
  const counts = new Map<RigidBody, number>();
  let most = 0;
  for (let k = start; k < end && most <= 2; k += 1) {
    const { members } = joints[k]!.constraint;
    for (let m = 0; m < members.length; m += 1) {
      const body = members[m]!;
      if (body.kind === DYNAMIC && body.constraints.length > 2 && members.indexOf(body) === m) {
        const count = (counts.get(body) ?? 0) + 1;
        counts.set(body, count);
        most = Math.max(most, count);
      }
    }
  }
  return most > 2;
}

/**
 * Gives rigid point joints their records for a step. Where they are solved two at a time, no two side by side share a body: the second
 * record is left empty there.
 */
function allotSlots(data: JointData): void {
  const { runs, groups } = data;
  data.slots = 0;
  for (const run of runs) {
    if (run.kernel === POINT) {
      allotRun(data, run);
    }
  }
  for (let i = 0; i + 1 < groups.length; i += 1) {
    const group = groups[i]!;
    const next = groups[i + 1]!;
    if (isChain(data, group) && isChain(data, next) && mayLieBeside(data, group, next)) {
      layBeside(data, group, next);
      i += 1;
    }
  }
}

/**
 * Allots the records of a run. Where two side by side would share a body, the second is left empty. Where most would be, as in a chain,
 * joints are solved one by one.
 */
function allotRun(data: JointData, { start, end }: Run): void {
  const joints = data.joints.slice(start, end);
  let offset = 0;
  const offsets = joints.map(({ constraint }, k) => {
    const isSecond = k > 0 && offset % 2 === 1;
    offset += isSecond && sharesBody(constraint, joints[k - 1]!.constraint) ? 2 : 1;
    return offset - 1;
  });
  const isPaired = joints.length >= FEWEST_PAIRED && offset < MOST_RECORDS * joints.length;
  for (const [k, joint] of joints.entries()) {
    joint.isPaired = isPaired;
    joint.slot = data.slots + (isPaired ? offsets[k]! : k);
  }
  data.slots = joints[joints.length - 1]!.slot + 1;
  data.slots += data.slots & 1;
}

/** Whether a group is one run of rigid point joints, solved one by one, without branches. */
function isChain({ joints }: JointData, { start, end, runs, branches }: Group): boolean {
  const isOneRun = runs.length === 1 && runs[0]!.kernel === POINT;
  return end - start >= FEWEST_BESIDE && isOneRun && !branches && !joints[start]!.isPaired;
}

/** Whether two groups have as many joints, and no kinematic body is in both of two joints that would lie side by side. */
function mayLieBeside({ joints }: JointData, { start, end }: Group, next: Group): boolean {
  return (
    next.end - next.start === end - start &&
    joints.slice(start, end).every(({ constraint: { members } }, k) => {
      const { constraint } = joints[next.start + k]!;
      return !members.some((body) => body.kind === KINEMATIC && constraint.members.includes(body));
    })
  );
}

/** Lays two chains side by side: the first one gets the even slots of both, the other one the odd ones. */
function layBeside({ joints }: JointData, group: Group, next: Group): void {
  const { start, end } = group;
  const { slot } = joints[start]!;
  group.beside = next;
  group.isBeside = true;
  next.isBeside = true;
  for (let k = start; k < next.end; k += 1) {
    const joint = joints[k]!;
    joint.isPaired = true;
    joint.isBeside = true;
    joint.slot = slot + (k < end ? 2 * (k - start) : 2 * (k - end) + 1);
  }
}

/** Whether most of the joints of a group carried nothing yet. */
function carriesNothing({ joints }: JointData, { start, end }: Group): boolean {
  let count = 0;
  for (let k = start; k < end; k += 1) {
    if (joints[k]!.constraint.impulse.every((part) => part === 0)) {
      count += 1;
    }
  }
  return 2 * count > end - start;
}

/** The tolerance of a group of so many joints. */
function toleranceOf(count: number): number {
  const tolerance = (JOINT_SWEEP_ERROR_OF_FEW * count) / FEW_JOINTS;
  return Math.min(JOINT_SWEEP_ERROR, Math.max(JOINT_SWEEP_ERROR_OF_FEW, tolerance));
}

function sharesBody({ members }: Constraint, other: Constraint): boolean {
  return members.some((body) => other.members.includes(body));
}

const NO_TWINS: Joint['twins'] = [];

/** Each member that is the same body as an earlier one, with the first index of that body. */
function twinsOf(members: Constraint['members']): Joint['twins'] {
  if (members.length === 2 && members[0] !== members[1]) {
    return NO_TWINS;
  }
  return members.flatMap((body, k): [number, number][] => {
    const first = members.indexOf(body);
    return first < k ? [[first, k]] : [];
  });
}
