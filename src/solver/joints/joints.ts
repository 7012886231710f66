import { EASE_STEPS, FIRM_ERROR, FIRM_STEPS, JOINT_FAR, JOINT_PUSHES, SWEPT_ONCE } from '../../config-joints.js';
import type { World } from '../../world.js';
import type { SolverData } from '../data.js';
import { findHinge, noteHinges } from '../impacts/hinge.js';
import { shareOfChange } from '../impacts/onset.js';
import { sleepConstraint, wakeConstraint } from '../sleep.js';
import {
  breakOff,
  countIgnoring,
  joinTied,
  keepDriven,
  leaveWorld,
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
import { fetchAll, fetchNumbers, type Group, type Joint, resetJoints } from './joint-data.js';
import { CUSTOM, POINT, PUSH } from './joint-layout.js';
import { listBodies, steady } from './joint-numbers.js';
import { lineariseBlock, pushBlock, solveVelocityBlock } from './kernels/blocks.js';
import { breakOverloaded } from './kernels/breaking.js';
import { finishPoints, pushPoints, solveVelocityPoints, warmStartPoints } from './kernels/points.js';
import { advancePoses, hidePoses, packPoses } from './kernels/pose.js';
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
import { beginGradients, goOn, noteStart } from './plan/gradients.js';
import { beginGroup, correctShare, lookAtKinds, plan } from './plan/plan.js';
import { closeOpen } from './touching/close-joints.js';
import { pushHeld } from './touching/held-contacts.js';
import { forgetShocks, linkShocks, solveFrames } from './touching/joint-shocks.js';

/** Packs the live constraints for sub-steps of length h. Of those that keep their numbers here, the many, what did not change is still there. */
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
    // Their callbacks may ask for what other constraints gave: that of the last step, as long as this one is being solved.
    fetchAll(joints);
  }
  for (let i = 0; i < joints.groups.length; i += 1) {
    packGroup(data, joints.groups[i]!, isChanged);
  }
  pushHeld(data);
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
  group.untouched = group.touched ? 0 : Math.min(FIRM_STEPS, group.untouched + 1);
  if (isChanged) {
    listBodies(data, group);
    lookAtKinds(data, group);
  }
  group.guests.clear();
  group.isWatched = group.mayGain && !group.isDriven && !group.touched;
  if (group.isWatched) noteEnergy(data, group);
}

/** Of groups that touch something what they are with is watched, too. */
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

/** What was changed is corrected without momentum in this step, and as all others from the next one on. */
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

/** Starts a sub-step: finds how often each group has to be swept over. */
function warmStartJoints(data: SolverData, isFirst: boolean): void {
  const { groups, worst } = data.joints;
  noteVelocities(data);
  for (let i = 0; i < groups.length; i += 1) {
    const group = groups[i]!;
    const { beside } = group;
    if (beside === null) {
      warmStartGroup(data, group, isFirst);
    } else {
      worst[0] = 0;
      worst[1] = 0;
      warmStartPoints(data, group.start, beside.end);
      group.error = worst[0]!;
      beside.error = worst[1]!;
      planChain(data, group, isFirst);
      planChain(data, beside, isFirst);
      i += 1;
    }
  }
  spreadShifts(data);
}

/** The way to what is asked for anew is made over the whole step: all of it in the first sub-step would be so many times as fast, and what hangs on it, whose joints make momentum, be flung up. */
function spreadShifts(data: SolverData): void {
  const { shifted, substepsLeft } = data.joints;
  for (let i = 0; i < shifted.length; i += 1) {
    correctShare(data, shifted[i]!, 1 / substepsLeft);
  }
  data.joints.substepsLeft -= 1;
  // Nobody is held on to.
  if (substepsLeft === 1) shifted.length = 0;
}

function warmStartGroup(data: SolverData, group: Group, isFirst: boolean): void {
  const { worst, asked } = data.joints;
  beginGroup(data, group);
  group.error = 0;
  for (let n = 0; n < group.runs.length; n += 1) {
    worst[0] = 0;
    worst[1] = 0;
    warmStartRun(data, group.runs[n]!, isFirst);
    const error = worst[0]! > worst[1]! ? worst[0]! : worst[1]!;
    group.runs[n]!.isOff = error > asked[0]!;
    group.error = error > group.error ? error : group.error;
  }
  plan(data, group, isFirst);
}

/** Of a group that lies beside another, and was warm started with it. */
function planChain(data: SolverData, group: Group, isFirst: boolean): void {
  beginGroup(data, group);
  group.runs[0]!.isOff = group.error > data.joints.asked[0]!;
  plan(data, group, isFirst);
}

/** Velocity iteration `i` of `count`. */
function solveVelocityJoints(data: SolverData, i: number, count: number): void {
  const { groups } = data.joints;
  if (data.joints.hasCustoms) sweepCustoms(data, i, solveVelocityBlock);
  for (let k = 0; k < groups.length; k += 1) {
    const group = groups[k]!;
    const { beside } = group;
    const areTwo = beside !== null && !group.isFirm && !beside.isFirm;
    solveVelocityGroup(data, group, i, count, areTwo);
    if (areTwo) {
      solveVelocityGroup(data, beside, i, count, true);
      if (i === count - 1) solveVelocityPoints(data, group.start, beside.end, false);
      k += 1;
    }
  }
}

/** Of two groups side by side the last sweep is left out: it is over both at once. */
function solveVelocityGroup(data: SolverData, group: Group, i: number, count: number, isOfTwo: boolean): void {
  const { sweeps } = group;
  const last = sweeps - 1;
  if (group.isFirm) {
    // What touches nothing has it once, as nothing changes in between.
    if (group.touched || i === count - 1) solveFirmly(data, group);
    return;
  }
  const after = Math.floor(((i + 1) * sweeps) / count);
  for (let sweep = Math.floor((i * sweeps) / count); sweep < after && !(isOfTwo && sweep === last); sweep += 1) {
    sweepOver(data, group, sweep, sweep === last, solveVelocityRun);
  }
}

/** Sweeps until nothing changes any more. */
function solveFirmly(data: SolverData, group: Group): void {
  beginGradients(data, group, false);
  for (let sweep = 0; sweep < group.sweeps; sweep += 1) {
    noteStart(data, false);
    sweepOver(data, group, sweep, true, solveVelocityRun);
    if (sweep < group.sweeps - 1 && !goOn(data, group, false)) {
      return;
    }
  }
}

/** Custom constraints, whose callbacks are called once in each iteration. In odd iterations groups that are swept over to and fro begin with their last. @returns whether it was for one of them. */
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

/** Position iteration `i` of `count`; where there are fewer sweeps than iterations the first iterations have them. @returns whether there is something left for another. */
function solvePositionJoints(data: SolverData, i: number, count: number): boolean {
  const { groups } = data.joints;
  let isLeft = data.joints.hasCustoms && sweepCustoms(data, i, pushCustom);
  for (let k = 0; k < groups.length; k += 1) {
    const group = groups[k]!;
    if (i === 0 && group.beside !== null) {
      pushBoth(data, group, group.beside);
    }
    const sweeps = group.sweeps === 1 ? 1 : JOINT_PUSHES * group.sweeps;
    const before = Math.ceil((i * sweeps) / count);
    const after = Math.ceil(((i + 1) * sweeps) / count);
    if (after > before) {
      isLeft = (pushGroup(data, group, before, after) && after < sweeps) || isLeft;
    }
  }
  return isLeft;
}

/** The first sweep over groups side by side: over both at once. */
function pushBoth(data: SolverData, first: Group, second: Group): void {
  const { worst } = data.joints;
  worst[0] = 0;
  worst[1] = 0;
  pushPoints(data, first.start, second.end, false);
  first.pushed = worst[0]!;
  second.pushed = worst[1]!;
}

/**
 * Position sweeps, until errors are small. Those after the first take the errors of point joints as linear in the motion, unless
 * contacts came in between, or bodies are to be moved without turning. @returns whether the last one found an error that was worth another.
 */
function pushGroup(data: SolverData, group: Group, before: number, after: number): boolean {
  const { worst } = data.joints;
  linearise(data, group);
  const isBegun = before === 0 && group.isBeside;
  if (group.isFirm) beginGradients(data, group, true);
  if (isBegun && group.pushed === 0) {
    return false;
  }
  for (let sweep = isBegun ? 1 : before; sweep < after; sweep += 1) {
    const isLinear = sweep > 0 && group.settling === 0 && (sweep > before || !group.touched);
    // More than small motion was left when all exact errors were found the last time.
    const pushAgain = group.pushed > JOINT_FAR * JOINT_FAR ? pushTurnedRun : pushRunLinearly;
    worst[0] = 0;
    worst[1] = 0;
    const goesOn = group.isFirm && isLinear && group.pushed < FIRM_ERROR * FIRM_ERROR;
    if (goesOn) noteStart(data, true);
    const isOff = sweepOver(data, group, sweep, sweep === 0, isLinear ? pushAgain : pushRun);
    if (!isLinear) {
      group.pushed = worst[0]! > worst[1]! ? worst[0]! : worst[1]!;
    }
    const isExact = group.isFirm && isOfPoints(group) && (goesOn || sweep === 0);
    // What is swept to is swept fro, too.
    if (!isOff && !isExact && !(group.toAndFro && sweep % 2 === 0)) {
      return false;
    }
    if (goesOn && sweep < after - 1 && !goOn(data, group, true) && isExact) {
      return false;
    }
  }
  return true;
}

/** Rigid points alone are pushed until nothing changes: where small errors wait until they are worth a sweep, forces jump from step to step. */
function isOfPoints({ runs, start, end }: Group): boolean {
  return runs.length === 1 && runs[0]!.kernel === POINT && end - start > 1;
}

/** @returns whether something may be left for another iteration. */
function pushCustom(data: SolverData, joint: Joint): boolean {
  lineariseBlock(data, joint);
  pushBlock(data, joint);
  return data.joints.records[joint.at + PUSH] !== 0;
}

/** Sets what share of the momentum of corrections is made. One sweep leaves some of the errors of several joints for the next sub-step, which would make too much of them where something swings; so do several kinds of joints that are more than needed. */
function findShare({ joints: { h, share } }: SolverData, { span, sweeps, start, end, isWhole, isMixed }: Group): void {
  const isLess = isMixed || (sweeps === 1 && end - start > 1 && !isWhole);
  const kept = isLess ? Math.max(0, 1 - SWEPT_ONCE * h) : 1;
  share[0] = kept * (h / span) * (h / span);
}

/** Whether two groups that lie side by side, of as many joints, make the same share of it. */
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

/** Ends a sub-step. */
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

/** Writes the outcome of the step back to the constraints, but those that fetch it; those that broke leave. */
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
    // A callback may have switched it off, which forgot its impulses then.
    const { constraint } = joints.joints[k]!;
    if (!constraint.enabled) constraint.forget();
  }
  for (const { constraint } of joints.broken) {
    breakOff(world, constraint);
  }
  joints.broken.length = 0;
}

/** One more sweep over a group. */
function sweepShock(data: SolverData, index: number): void {
  sweepOver(data, data.joints.groups[index]!, 0, true, solveVelocityRun);
}

/** What a world solves its constraints with. These bring it along, so that a bundle without any has nothing of it. */
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
  countIgnoring,
  wakeConstraint,
  sleepConstraint,
  keepDriven,
  joinTied,
  sleepIdle,
  fetchNumbers,
};

export type JointSolver = typeof jointSolver;
