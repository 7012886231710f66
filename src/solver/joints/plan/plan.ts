import {
  EASE_STEPS,
  FEW_JOINTS,
  FIRM_ERROR,
  FIRM_FEW,
  FIRM_JOINTS,
  FIRM_ROWS,
  FIRM_STEPS,
  FIRM_SWEEPS,
  HEAVY,
  JOINT_CALM,
  JOINT_REST_ERROR,
  JOINT_SETTLED,
  JOINT_SNAP,
  JOINT_SWEEP_MARGIN,
  JOINT_TORN,
  MAX_JOINT_SWEEPS,
  MOTOR_LAG,
  NEW_JOINT_SWEEPS,
  SETTLE_STEPS,
  SNAP_STEPS,
  SPRING_SWEEPS,
  SPRING_TURN,
  STUCK_ERROR,
  STUCK_STEPS,
  TOUCHED_PATIENCE,
  TOUCHED_SWEEPS,
  WEIGH_STEPS,
} from '../../../config-joints.js';
import { recordAt, type SolverData } from '../../data.js';
import { INV_MASS, W } from '../../layout.js';
import { mayMakeEnergy } from '../energy/energy.js';
import { lookAtStress } from '../energy/stress.js';
import type { Group, Joint } from '../joint-data.js';
import {
  CUSTOM,
  ERROR_X,
  ERROR_Y,
  POINT,
  POINT_STRIDE,
  REACH,
  TURN,
  TURN_LOWER,
  TURN_UPPER,
  TURN_VALUE,
} from '../joint-layout.js';
import { heldRows, steady } from '../joint-numbers.js';
import { findLength, length } from '../kernels/jacobian.js';
import { findOff } from '../kernels/points.js';
import { steadyTouched } from '../touching/momentum.js';
import { isBlocked } from '../touching/neighbours.js';
import { findMovers } from './gradients.js';
import { hasHub } from './hubs.js';

// The plan for the errors that a group has as a sub-step starts: how often it is swept over, and what momentum its corrections make.

/** Finds what drives a group, how hard its springs are, whether it may break, and whether its joints may pull against each other. */
export function lookAtKinds(data: SolverData, group: Group): void {
  const { joints } = data.joints;
  group.isDriven = false;
  group.mayBreak = false;
  group.frequency = 0;
  for (let k = group.start; k < group.end; k += 1) {
    const { constraint } = joints[k]!;
    joints[k]!.drives = constraint.drives;
    if (constraint.isElastic) group.frequency = Math.max(group.frequency, constraint.frequency);
    group.isDriven ||= constraint.drives;
    group.mayBreak ||= constraint.breakUnderForce && constraint.maxForce < Infinity;
  }
  lookAtStress(data, group);
}

/**
 * Resets what is noted while a group is warm started: which of its joints are off, and the lag of its motors. Blocks and turns are noted
 * right there, points only afterwards.
 */
export function beginGroup({ joints: { asked, off, lag } }: SolverData, { tolerance, start, end }: Group): void {
  lag[0] = 0;
  asked[0] = tolerance * tolerance;
  off[0] = end;
  off[1] = start;
}

/** Makes the plan for a group, once warm starting has found its error. */
export function plan(data: SolverData, group: Group, isFirst: boolean): void {
  const { asked, age } = data.joints;
  if (group.errorSquare > asked[0]!) {
    findPointsOff(data, group);
  }
  if (isFirst) {
    if (group.touched) steadyTouched(data, group);
    classify(data, group);
    findUnmet(group);
    if (group.isTorn) steadyAll(data, group, 0);
    settle(data, group);
  }
  limitMomentum(data, group, isFirst);
  if (group.touched && group.errorSquare > JOINT_TORN * JOINT_TORN && isBlocked(group)) {
    reachLess(data, group);
  }
  planSweeps(data, group, isFirst && age === EASE_STEPS);
}

function findPointsOff(data: SolverData, { runs }: Group): void {
  for (let i = 0; i < runs.length; i += 1) {
    const { kernel, start, end, isOff } = runs[i]!;
    if (kernel === POINT && isOff) {
      findOff(data, start, end);
    }
  }
}

/** Finds what kind of group it is, once in a while; and whether it has a hub, in each step if it has few joints. */
function classify(data: SolverData, group: Group): void {
  const isDue = data.joints.age % WEIGH_STEPS === 0 || group.isNew;
  if (isDue) {
    group.burdened = isBurdened(data, group);
    group.mayGain = !group.isDriven && mayMakeEnergy(data, group);
    findFirmness(data, group);
    group.isNew = false;
  }
  if (group.branches && (isDue || group.end - group.start <= FEW_JOINTS)) {
    group.toAndFro = group.isMixed || hasHub(data, group);
  }
}

/**
 * Finds whether a group is a mechanism, where bodies that are welded together count as one, and whether it is held. It is neither if joints
 * may break by force, as sweeps that try out impulses would break them; nor if a kinematic body turns. What that carries is swept over, not
 * solved to its end: its velocities would then be off by a seventh, or by half, as it is always corrected the same way.
 */
function findFirmness(data: SolverData, group: Group): void {
  const { velocity: v } = data;
  const { joints } = data.joints;
  const { start, end, frequency, bodies } = group;
  let isFit = end - start > 1 && end - start <= FIRM_JOINTS && frequency === 0;
  let isHeld = group.isAnchored;
  let rows = 0;
  let welds = 0;
  for (let k = start; k < end && isFit; k += 1) {
    const { constraint, kernel, layout } = joints[k]!;
    isFit = kernel !== CUSTOM && !constraint.breakUnderForce;
    if (layout.rows === 3) welds += 1;
    else rows += heldRows(constraint);
  }
  for (let n = 0; n < bodies.count && isFit; n += 1) {
    const b = bodies.items[n]!;
    if (v[b + INV_MASS] === 0) {
      isHeld = true;
      isFit = v[b + W] === 0;
    }
  }
  group.isMechanism = isFit && rows > 0 && rows >= FIRM_ROWS * (findMovers(data, group) - welds);
  group.isSmallAndHeld = isFit && isHeld;
}

/** 1/kg. The inverse masses of the heaviest and the lightest body of a group: scratch. */
const range = /* @__PURE__ */ new Float64Array(2);

/** Whether a body of a group is far heavier than another. */
function isBurdened(data: SolverData, { bodies }: Group): boolean {
  range[0] = Infinity;
  range[1] = 0;
  for (let n = 0; n < bodies.count; n += 1) {
    widenRange(data, bodies.items[n]!);
  }
  return range[1]! > HEAVY * range[0]!;
}

/** A function of its own, which is soon compiled, see BATCH in `energy.ts`. */
function widenRange({ velocity: v }: SolverData, body: number): void {
  const inverse = v[body + INV_MASS]!;
  if (inverse > 0) {
    range[0] = Math.min(range[0]!, inverse);
    range[1] = Math.max(range[1]!, inverse);
  }
}

/**
 * Counts the steps in which joints between things that do not move had an error that no sweep removed: such joints cannot all be met. For
 * what was changed, as long as it stays open from then on, and for what is torn, that is assumed at once. What is torn is not taken for
 * such if it bears or is joined to something far heavier, which has to be held up, or if force may break something of it.
 */
function findUnmet(group: Group): void {
  const { isHeldTwice, errorSquare, fresh, touched, mayBreak, burdened } = group;
  const isOpen = isHeldTwice && errorSquare > STUCK_ERROR * STUCK_ERROR;
  const isLarge = errorSquare > JOINT_TORN * JOINT_TORN;
  group.stuckSteps = isOpen ? Math.min(group.stuckSteps + 1, STUCK_STEPS) : fresh ? STUCK_STEPS - 1 : 0;
  group.isTorn = isOpen && isLarge && !mayBreak && !burdened && (!touched || isBlocked(group));
  const isLong = group.stuckSteps === STUCK_STEPS && !(isLarge && touched);
  group.isUnmet = group.isTorn || isLong || (isHeldTwice && !isLarge && fresh);
}

/** Lets no correction of a group make momentum in this step. What is torn would get the more of it the longer it is torn. */
function steadyAll(data: SolverData, { start, end }: Group, snaps: number): void {
  for (let k = start; k < end; k += 1) {
    steady(data, data.joints.joints[k]!, snaps);
  }
}

/**
 * Where a change left large errors, or something that let go in the last step did, all joints of the group are corrected without momentum
 * until errors are small: the links of a chain that a cannon ball had torn open by metres flew off at 500 m/s once it had let go of them.
 */
function settle(data: SolverData, group: Group): void {
  const most = group.settling > 0 ? JOINT_SETTLED : JOINT_SNAP;
  const isLarge = group.errorSquare > most * most;
  const first = group.fresh ? SETTLE_STEPS : group.untouchedSteps === 1 ? SETTLE_STEPS - SNAP_STEPS : 0;
  group.settling = isLarge ? Math.max(first, group.settling - 1) : 0;
  group.fresh = false;
  if (group.settling > 0) {
    steadyAll(data, group, group.touched || group.settling <= SETTLE_STEPS - SNAP_STEPS ? 0 : 1);
  }
}

/**
 * Where something is in the way, joints that cannot be met are corrected by no more at once than contacts can undo: else what is dragged
 * along or hauled up would be pulled into a wall, deeper and deeper, and through it. Joints on which something heavy lies are left out, as
 * it has to be held up.
 */
function reachLess(data: SolverData, { start, end }: Group): void {
  const { joints, records: r } = data.joints;
  const { points: p } = data;
  for (let k = start; k < end; k += 1) {
    const { kernel, at, slot } = joints[k]!;
    if (kernel === POINT) {
      const i = recordAt(slot, POINT_STRIDE);
      const error = Math.sqrt(p[i + ERROR_X]! * p[i + ERROR_X]! + p[i + ERROR_Y]! * p[i + ERROR_Y]!);
      const share = Math.min(1, JOINT_TORN / error);
      p[i + ERROR_X] = share * p[i + ERROR_X]!;
      p[i + ERROR_Y] = share * p[i + ERROR_Y]!;
    } else if (kernel === TURN) {
      const most = r[at + TURN_UPPER]! + JOINT_TORN;
      const least = r[at + TURN_LOWER]! - JOINT_TORN;
      r[at + TURN_VALUE] = Math.max(least, Math.min(most, r[at + TURN_VALUE]!));
    } else {
      r[at + REACH] = JOINT_TORN;
    }
  }
}

/** In this sub-step, corrects only a share of the error of a joint, unless it is so large that bodies are moved without turning them. */
export function correctShare(data: SolverData, { kernel, at, slot, layout }: Joint, share: number): void {
  const { records: r } = data.joints;
  const { points: p } = data;
  if (kernel === POINT) {
    const i = recordAt(slot, POINT_STRIDE);
    const x = p[i + ERROR_X]!;
    const y = p[i + ERROR_Y]!;
    if (x * x + y * y <= JOINT_SNAP * JOINT_SNAP) {
      p[i + ERROR_X] = share * x;
      p[i + ERROR_Y] = share * y;
    }
  } else if (kernel === TURN) {
    const value = r[at + TURN_VALUE]!;
    const bound = Math.max(r[at + TURN_LOWER]!, Math.min(r[at + TURN_UPPER]!, value));
    r[at + TURN_VALUE] = bound + share * (value - bound);
  } else {
    findLength(r, at + layout.error, layout.rows);
    r[at + REACH] = share < 1 && length[0]! <= JOINT_SNAP ? (share - 1) * length[0]! : Infinity;
  }
}

/**
 * Errors that longer sub-steps left make less momentum than they would have made in those: corrected in a thousandth of the time, they
 * would make a thousand times as much, and as sweeps hand errors on, nobody can tell later whose they are. With the square of the ratio,
 * nothing grows either when steps become longer again. This ends after four times as much time has passed, or sooner if errors are small;
 * those of custom joints are not known when a step begins. If impulses were dropped, the group has as many sweeps as a new one.
 */
function limitMomentum(data: SolverData, group: Group, isFirst: boolean): void {
  const { impulseScale } = data;
  const { h } = data.joints;
  const before = isFirst ? h / (impulseScale || 1) : h;
  const span = Math.max(h, before, group.span - h / 4);
  const calm = JOINT_CALM * h * (h / span);
  group.span = group.errorSquare > calm * calm || (isFirst && group.hasCustoms) ? span : h;
  if (isFirst && impulseScale === 0) {
    group.sweeps = NEW_JOINT_SWEEPS;
  }
}

/**
 * Sets how often a group is swept over, and which of its joints: as its worst error asks for, but never much less than before where it
 * touches something or bears something heavy. There, sweeps that come and go shake what hangs on it, fling up what lies on it, and make a
 * thin rope with a load whirl by itself.
 */
function planSweeps(data: SolverData, group: Group, eases: boolean): void {
  const { off, lag, h } = data.joints;
  const springs = Math.ceil(SPRING_SWEEPS * (group.frequency * h - SPRING_TURN));
  const motors = Math.floor(lag[0]! / MOTOR_LAG);
  // Springs and motors ask for sweeps over all joints; errors for sweeps over those that are off, and those near them.
  const ofAll = group.end - group.start > 1 ? Math.max(springs, motors) : 0;
  const part = group.touched ? TOUCHED_PATIENCE * group.tolerance : group.tolerance;
  const ofSome = Math.ceil((Math.sqrt(group.errorSquare) - JOINT_REST_ERROR) / part);
  const isSteady = group.touched || group.burdened;
  const isFewer = !isSteady || group.sweeps > MAX_JOINT_SWEEPS || eases;
  const least = Math.max(isSteady ? TOUCHED_SWEEPS : 1, isFewer ? group.sweeps - 1 : group.sweeps);
  const wanted = 1 + Math.max(0, ofAll, ofSome);
  group.sweeps = wanted < least ? least : Math.min(wanted, MAX_JOINT_SWEEPS);
  group.isFirm = group.errorSquare < FIRM_ERROR * FIRM_ERROR && group.settling === 0 && mayBeFirm(group);
  if (group.isFirm) {
    group.sweeps = Math.max(group.sweeps, FIRM_SWEEPS);
  }
  if (group.toAndFro) {
    group.sweeps = Math.max(2, group.sweeps - (group.sweeps & 1));
  }
  if (ofAll > 0 || group.isFirm) {
    group.from = group.start;
    group.to = group.end;
  } else if (off[1]! > off[0]!) {
    const margin = JOINT_SWEEP_MARGIN * (off[1]! - off[0]!);
    group.from = off[0]! - margin;
    group.to = off[1]! + margin;
  }
}

/**
 * Whether a group may be solved to its end. Not if it has more joints than are needed: gradients would make these give ever more against
 * each other, and corrections momentum of that.
 */
function mayBeFirm(group: Group): boolean {
  if (group.isIndeterminate || group.stuckSteps === STUCK_STEPS) {
    return false;
  }
  if (group.touched) {
    return group.isMechanism && group.stands;
  }
  const isVerySmall = group.end - group.start <= FIRM_FEW;
  return group.isSmallAndHeld && (group.isMechanism || (isVerySmall && group.untouchedSteps === FIRM_STEPS));
}
