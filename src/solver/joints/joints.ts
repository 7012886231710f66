import {
  BLOCK_FAR,
  EASE_STEPS,
  FIRM_ERROR,
  FIRM_STEPS,
  JOINT_FAR,
  JOINT_PUSHES,
  SWEPT_ONCE,
} from '../../config-joints.js';
import type { World } from '../../world.js';
import type { SolverData } from '../data.js';
import { findHinge, noteHinges } from '../impacts/hinge.js';
import { shareOfChange } from '../impacts/onset.js';
import { sleepConstraint, wakeConstraint } from '../sleep.js';
import {
  breakOff,
  joinTied,
  keepDriven,
  leaveWorld,
  listIgnoring,
  sleepIdle,
  switchOff,
  switchOn,
  tie,
  untie,
} from '../ties.js';
import { findCompanies, findGuests } from './energy/company.js';
import { noteEnergy, takeExcesses } from './energy/energy.js';
import { beginSprings, enterSprings, noteVelocities } from './energy/springs.js';
import { turnStress } from './energy/stress.js';
import { clearWorst, fetchAll, fetchNumbers, type Group, type Joint, resetJoints } from './joint-data.js';
import { CUSTOM, POINT, PUSH } from './joint-layout.js';
import { listBodies, steady } from './joint-numbers.js';
import { lineariseBlock, pushBlock, solveVelocityBlock } from './kernels/blocks.js';
import { breakOverloaded } from './kernels/breaking.js';
import { finishPoints, solveVelocityPoints, warmStartPoints } from './kernels/points.js';
import { advancePoses, hidePoses, packPoses } from './kernels/pose.js';
import { areInStep, pushBeside, solveVelocityBeside } from './kernels/side-by-side.js';
import {
  finishRun,
  linearise,
  packRun,
  pushRun,
  pushRunLinearly,
  pushTurnedRun,
  solveVelocityRun,
  storeRun,
  sweepOver,
  warmStartRun,
} from './kernels/sweeps.js';
import { orderJoints } from './order/order.js';
import { beginGradients, beginSweep, followGradient } from './plan/gradients.js';
import { beginGroup, correctShare, lookAtKinds, plan } from './plan/plan.js';
import { closeOpen } from './touching/close-joints.js';
import { pushHeld } from './touching/held-contacts.js';
import { forgetShocks, linkShocks, solveFrames } from './touching/joint-shocks.js';
import { findNeighbours } from './touching/neighbours.js';

/**
 * Packs the live constraints for sub-steps of length h. Rigid points, angles and motors, which most joints are, keep their numbers in their
 * records from step to step; these are written anew only after a change.
 */
function packJoints(world: World, h: number): void {
  const data = world.solver;
  const { joints } = data;
  const isChanged = world.jointsTouched || world.jointsStale || joints.h !== h || joints.substeps !== data.substeps;
  if (world.jointsStale) {
    orderJoints(world);
  }
  world.jointsStale = false;
  world.jointsTouched = false;
  joints.h = h;
  joints.substeps = data.substeps;
  joints.substepsLeft = data.substeps;
  if (joints.slots > 0) {
    data.makeRoomForPoints(joints.slots);
  }
  joints.age = (joints.age % EASE_STEPS) + 1;
  if (joints.runs.length > 0) {
    packPoses(world);
  }
  if (joints.hasCustoms) {
    // A callback may ask for the impulses of other constraints. While this step is being solved, it gets those of the last one.
    fetchAll(joints);
  }
  for (let i = 0; i < joints.groups.length; i += 1) {
    packGroup(data, joints.groups[i]!, isChanged);
  }
  pushHeld(data);
  findNeighbours(world);
  watchTouched(world);
  beginSprings(data);
  if (isChanged) {
    steadyFresh(data);
  }
}

function packGroup(data: SolverData, group: Group, isChanged: boolean): void {
  group.touched = false;
  for (let i = 0; i < group.runs.length; i += 1) {
    group.touched = packRun(data, group.runs[i]!, isChanged) || group.touched;
  }
  group.untouchedSteps = group.touched ? 0 : Math.min(FIRM_STEPS, group.untouchedSteps + 1);
  if (isChanged) {
    listBodies(data, group);
    lookAtKinds(data, group);
  }
  group.guests.clear();
  group.isWatched = group.mayGain && !group.isDriven && !group.touched;
  if (group.isWatched) noteEnergy(data, group);
}

/** Watches groups that touch something together with their guests, the bodies that they exchange energy with: see `energy/company.ts`. */
function watchTouched(world: World): void {
  const { solver } = world;
  const { groups } = solver.joints;
  let isKnown = false;
  for (let i = 0; i < groups.length; i += 1) {
    const group = groups[i]!;
    if (group.mayGain && !group.isDriven && group.touched) {
      if (!isKnown) findCompanies(world);
      isKnown = true;
      group.isWatched = findGuests(solver, group);
      if (group.isWatched) noteEnergy(solver, group);
    }
  }
}

/** Lets joints that were changed be corrected without momentum in this step; from the next one on, they are corrected as all others. */
function steadyFresh(data: SolverData): void {
  const { joints, groups, shifted } = data.joints;
  for (const group of groups) {
    for (let k = group.start; k < group.end; k += 1) {
      const { constraint } = joints[k]!;
      if (constraint.fresh) {
        constraint.fresh = false;
        constraint.stored = Infinity;
        group.fresh = true;
        group.isWatched = false;
        steady(data, joints[k]!, group.touched ? 0 : 1);
        if (constraint.shifted && !group.touched) {
          shifted.push(joints[k]!);
        }
        constraint.shifted = false;
      }
    }
  }
}

/** Starts a sub-step: warm starts all joints, and plans how often each group is swept over. */
function warmStartJoints(data: SolverData, isFirst: boolean): void {
  const { groups, worst } = data.joints;
  noteVelocities(data);
  for (let i = 0; i < groups.length; i += 1) {
    const group = groups[i]!;
    const { beside } = group;
    if (beside === null) {
      warmStartGroup(data, group, isFirst);
    } else {
      clearWorst(data.joints);
      warmStartPoints(data, group.start, beside.end);
      group.errorSquare = worst[0]!;
      beside.errorSquare = worst[1]!;
      planChain(data, group, isFirst);
      planChain(data, beside, isFirst);
      i += 1;
    }
  }
  spreadShifts(data);
}

/**
 * Spreads the correction of a changed joint over the whole step. All of it in the first sub-step would be as many times as fast as there
 * are sub-steps, and would fling up what hangs on the joint, as the joints of that make momentum of their corrections.
 */
function spreadShifts(data: SolverData): void {
  const { shifted, substepsLeft } = data.joints;
  for (let i = 0; i < shifted.length; i += 1) {
    correctShare(data, shifted[i]!, 1 / substepsLeft);
  }
  data.joints.substepsLeft -= 1;
  // Afterwards nothing refers to these joints any more.
  if (substepsLeft === 1) shifted.length = 0;
}

function warmStartGroup(data: SolverData, group: Group, isFirst: boolean): void {
  const { worst, asked } = data.joints;
  beginGroup(data, group);
  group.errorSquare = 0;
  for (let n = 0; n < group.runs.length; n += 1) {
    clearWorst(data.joints);
    warmStartRun(data, group.runs[n]!, isFirst);
    const error = worst[0]! > worst[1]! ? worst[0]! : worst[1]!;
    group.runs[n]!.isOff = error > asked[0]!;
    group.errorSquare = error > group.errorSquare ? error : group.errorSquare;
  }
  plan(data, group, isFirst);
}

/** Plans the sweeps of one of two groups that lie side by side and were warm started together. */
function planChain(data: SolverData, group: Group, isFirst: boolean): void {
  beginGroup(data, group);
  group.runs[0]!.isOff = group.errorSquare > data.joints.asked[0]!;
  plan(data, group, isFirst);
}

/** Velocity iteration `i` of `count`. */
function solveVelocityJoints(data: SolverData, i: number, count: number): void {
  const { groups } = data.joints;
  if (data.joints.hasCustoms) sweepCustoms(data, i, solveVelocityBlock);
  for (let k = 0; k < groups.length; k += 1) {
    const group = groups[k]!;
    const { beside } = group;
    if (beside !== null && !group.isFirm && !beside.isFirm) {
      solveVelocityBoth(data, group, beside, i, count);
      k += 1;
    } else if (!group.isFirm) {
      solveVelocityGroup(data, group, i, count, group.sweeps);
    } else if (group.touched || i === count - 1) {
      // A group that touches nothing is solved once, in the last iteration, as nothing changes its velocities in between.
      solveFirmly(data, group);
    }
  }
}

/** Sweeps over two groups that lie side by side; the last one is always over both at once, as it is over all joints. */
function solveVelocityBoth(data: SolverData, first: Group, second: Group, i: number, count: number): void {
  if (areInStep(first, second)) {
    const after = Math.min(sweepsBefore(first, i + 1, count), first.sweeps - 1);
    for (let sweep = sweepsBefore(first, i, count); sweep < after; sweep += 1) {
      solveVelocityBeside(data, first, second);
    }
  } else {
    solveVelocityGroup(data, first, i, count, first.sweeps - 1);
    solveVelocityGroup(data, second, i, count, second.sweeps - 1);
  }
  if (i === count - 1) solveVelocityPoints(data, first.start, second.end, false);
}

/** Sweeps over a group, up to number `end` at most. */
function solveVelocityGroup(data: SolverData, group: Group, i: number, count: number, end: number): void {
  const after = Math.min(sweepsBefore(group, i + 1, count), end);
  for (let sweep = sweepsBefore(group, i, count); sweep < after; sweep += 1) {
    sweepOver(data, group, sweep, sweep === group.sweeps - 1, solveVelocityRun);
  }
}

/** How many velocity sweeps a group has had before iteration `i` of `count`. */
function sweepsBefore({ sweeps }: Group, i: number, count: number): number {
  return Math.floor((i * sweeps) / count);
}

/** Sweeps until a sweep changes nothing worth another, with conjugate gradients in between: see `plan/gradients.ts`. */
function solveFirmly(data: SolverData, group: Group): void {
  beginGradients(data, group, false);
  for (let sweep = 0; sweep < group.sweeps; sweep += 1) {
    beginSweep(data, false);
    sweepOver(data, group, sweep, true, solveVelocityRun);
    if (sweep < group.sweeps - 1 && !followGradient(data, group, false)) {
      return;
    }
  }
}

/**
 * Solves the custom constraints, whose callbacks are called once in each iteration. In odd iterations, groups that are swept over to and
 * fro begin with their last joint. @returns whether `solve` returned true for one of them.
 */
function sweepCustoms(data: SolverData, i: number, solve: (data: SolverData, joint: Joint) => unknown): boolean {
  const { groups, joints } = data.joints;
  let found = false;
  for (let g = 0; g < groups.length; g += 1) {
    const { runs, toAndFro } = groups[g]!;
    const isBack = toAndFro && i % 2 === 1;
    for (let n = 0; n < runs.length; n += 1) {
      const { kernel, start, end } = runs[isBack ? runs.length - 1 - n : n]!;
      for (let k = start; k < end && kernel === CUSTOM; k += 1) {
        found = solve(data, joints[isBack ? start + end - 1 - k : k]!) === true || found;
      }
    }
  }
  return found;
}

/**
 * Position iteration `i` of `count`. If there are fewer sweeps than iterations, the first iterations have them. @returns whether another
 * iteration is worth while.
 */
function solvePositionJoints(data: SolverData, i: number, count: number): boolean {
  const { groups } = data.joints;
  let isLeft = data.joints.hasCustoms && sweepCustoms(data, i, pushCustom);
  for (let k = 0; k < groups.length; k += 1) {
    const group = groups[k]!;
    const sweeps = group.sweeps === 1 ? 1 : JOINT_PUSHES * group.sweeps;
    const before = Math.ceil((i * sweeps) / count);
    const after = Math.ceil(((i + 1) * sweeps) / count);
    if (group.beside !== null) {
      pushBeside(data, group, group.beside, before, after);
    }
    if (after > before) {
      isLeft = (pushGroup(data, group, before, after) && after < sweeps) || isLeft;
    }
  }
  return isLeft;
}

/**
 * Position sweeps, until errors are small; of two groups side by side, the first ones are done already.
 * @returns whether the last sweep found an error that was worth another one.
 */
function pushGroup(data: SolverData, group: Group, before: number, after: number): boolean {
  const { left } = data.joints;
  left[0] = 0;
  linearise(data, group, false);
  const isFar = left[0] > BLOCK_FAR;
  if (group.isFirm) beginGradients(data, group, true);
  if (group.isPushed) {
    return false;
  }
  for (let sweep = Math.max(before, group.pushed); sweep < after; sweep += 1) {
    // Joints that are not points are linear in the motion, too, and are linearised anew where much turned.
    if (isFar && sweep > before && linearise(data, group, true) && group.isFirm) beginGradients(data, group, true);
    // Not linear where contacts came in between, or the bodies are to be moved without turning.
    const isLinear = sweep > 0 && group.settling === 0 && (sweep > before || !group.touched);
    const hasGradient = group.isFirm && isLinear && group.pushedSquare < FIRM_ERROR * FIRM_ERROR;
    if (hasGradient) beginSweep(data, true);
    const isOff = pushOnce(data, group, sweep, isLinear);
    const isToEnd = group.isFirm && isOfPoints(group) && (hasGradient || sweep === 0);
    // A sweep to is always followed by one fro.
    if (!isOff && !isToEnd && !(group.toAndFro && sweep % 2 === 0)) {
      return false;
    }
    if (hasGradient && sweep < after - 1 && !followGradient(data, group, true) && isToEnd) {
      return false;
    }
  }
  return true;
}

/** One position sweep. It is exact, or takes the errors of points as linear in the motion. @returns whether it found one worth another. */
function pushOnce(data: SolverData, group: Group, sweep: number, isLinear: boolean): boolean {
  const { worst } = data.joints;
  if (isLinear) {
    // The last exact sweep found errors so large that linear ones are not enough where bodies have turned since.
    const isLarge = group.pushedSquare > JOINT_FAR * JOINT_FAR;
    return sweepOver(data, group, sweep, false, isLarge ? pushTurnedRun : pushRunLinearly);
  }
  clearWorst(data.joints);
  const isOff = sweepOver(data, group, sweep, sweep === 0, pushRun);
  group.pushedSquare = worst[0]! > worst[1]! ? worst[0]! : worst[1]!;
  return isOff;
}

/**
 * Whether a group has rigid points alone. These are pushed until nothing changes: if small errors waited until they were worth a sweep,
 * forces would jump from step to step.
 */
function isOfPoints({ runs, start, end }: Group): boolean {
  return runs.length === 1 && runs[0]!.kernel === POINT && end - start > 1;
}

/** One position iteration of a custom constraint. @returns whether another one may be worth while. */
function pushCustom(data: SolverData, joint: Joint): boolean {
  lineariseBlock(data, joint);
  pushBlock(data, joint);
  return data.joints.records[joint.at + PUSH] !== 0;
}

/**
 * Sets what share of the momentum of corrections is made. It is less than all in two cases: where several joints are swept over once, as
 * one sweep leaves some of their errors for the next sub-step, which would make too much momentum of them where something swings; and where
 * joints of several kinds are more than needed.
 */
function findShare({ joints: { h, share } }: SolverData, { span, sweeps, start, end, isWhole, isMixed }: Group): void {
  const isLess = isMixed || (sweeps === 1 && end - start > 1 && !isWhole);
  const kept = isLess ? Math.max(0, 1 - SWEPT_ONCE * h) : 1;
  share[0] = kept * (h / span) * (h / span);
}

/** Whether two groups that lie side by side make the same share of it. */
function areAlike(one: Group, other: Group): boolean {
  return one.span === other.span && (one.sweeps === 1) === (other.sweeps === 1);
}

function finishGroup(data: SolverData, group: Group): void {
  const { runs } = group;
  findShare(data, group);
  for (let i = 0; i < runs.length; i += 1) {
    finishRun(data, runs[i]!);
  }
}

/** Ends a sub-step: makes momentum of corrections, closes joints that contacts hold open, and moves the poses on. */
function finishJoints(data: SolverData): void {
  const { groups, runs } = data.joints;
  for (let k = 0; k < groups.length; k += 1) {
    const group = groups[k]!;
    const { beside } = group;
    if (beside !== null && areAlike(group, beside)) {
      findShare(data, group);
      finishPoints(data, group.start, beside.end);
      closeOpen(data, group);
      closeOpen(data, beside);
      k += 1;
    } else {
      finishGroup(data, group);
      closeOpen(data, group);
      if (group.isOverheld) turnStress(data, group);
    }
  }
  enterSprings(data);
  forgetShocks(data);
  if (runs.length > 0) {
    advancePoses(data);
  }
}

/**
 * Ends a step: takes back energy that joints made, breaks what bore too much, and writes the results to the constraints or, for joints that
 * keep their numbers, to their records. Joints that broke leave the world.
 */
function storeJoints(world: World): void {
  const data = world.solver;
  const { joints } = data;
  hidePoses(data);
  takeExcesses(data);
  joints.solved += 1;
  breakOverloaded(data);
  for (let i = 0; i < joints.runs.length; i += 1) {
    storeRun(data, joints.runs[i]!);
  }
  for (let k = 0; k < joints.joints.length && world.jointsStale; k += 1) {
    // A callback may have disabled it, which resets its impulses; storing has just set them again.
    const { constraint } = joints.joints[k]!;
    if (!constraint.enabled) constraint.forget();
  }
  for (const { constraint } of joints.broken) {
    breakOff(world, constraint);
  }
  joints.broken.length = 0;
}

/** One velocity sweep over all joints of a group, for the shock it is part of: see `contacts/shocks.ts`. */
function sweepShock(data: SolverData, index: number): void {
  sweepOver(data, data.joints.groups[index]!, 0, true, solveVelocityRun);
}

/**
 * All functions with which a world solves its constraints. Constraints bring it along, so that a bundle without any has no code for them.
 */
export const jointSolver = {
  pack: packJoints,
  warmStart: warmStartJoints,
  solveVelocities: solveVelocityJoints,
  solvePositions: solvePositionJoints,
  finish: finishJoints,
  store: storeJoints,
  linkShocks,
  sweepShock,
  solveFrames,
  findHinge,
  noteHinges,
  shareOfChange,
  tie,
  untie,
  reset: resetJoints,
  leaveWorld,
  switchOn,
  switchOff,
  listIgnoring,
  wakeConstraint,
  sleepConstraint,
  keepDriven,
  joinTied,
  sleepIdle,
  fetchNumbers,
};

export type JointSolver = typeof jointSolver;
