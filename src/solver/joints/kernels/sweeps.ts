import type { SolverData } from '../../data.js';
import { type Group, keepsNumbers, packHead, type Run } from '../joint-data.js';
import { ANCHORED, BLOCK, CUSTOM, DISTANCE, LINE, POINT, TURN } from '../joint-layout.js';
import { finishAnchored, sweepAnchored } from './anchored.js';
import {
  finishBlock,
  hasTurned,
  lineariseBlock,
  packBlock,
  pushBlock,
  solveVelocityBlock,
  storeBlock,
  warmStartBlock,
} from './blocks.js';
import {
  finishDistances,
  lineariseDistance,
  packDistance,
  storeDistance,
  sweepDistances,
  warmStartDistances,
} from './distances.js';
import { sweepLines } from './lines.js';
import {
  beginPoints,
  finishPoints,
  keepPoints,
  packPoint,
  pushPoints,
  pushPointsLinearly,
  pushTurnedPoints,
  solveVelocityPoints,
  warmStartPoints,
} from './points.js';
import {
  beginTurns,
  finishTurns,
  keepTurns,
  packTurn,
  pushTurns,
  solveVelocityTurns,
  warmStartTurns,
} from './turns.js';

// Each phase for one run, by its kernel; and sweeps over the runs of a group.

/**
 * Starts a step. Joints that keep their numbers in their records are written anew only if something changed. @returns whether one of the
 * bodies is in contact.
 */
export function packRun(data: SolverData, { kernel, start, end }: Run, isChanged: boolean): boolean {
  const { joints } = data.joints;
  if (keepsNumbers(kernel)) {
    const pack = kernel === POINT ? packPoint : packTurn;
    for (let k = start; k < end && isChanged; k += 1) {
      pack(data, joints[k]!);
    }
    return kernel === POINT ? beginPoints(data, start, end) : beginTurns(data, start, end);
  }
  let isInContact = false;
  for (let k = start; k < end; k += 1) {
    packHead(data.joints, joints[k]!);
    isInContact = packBlock(data, joints[k]!) || isInContact;
    if (kernel === DISTANCE) packDistance(data, joints[k]!);
  }
  return isInContact;
}

/** Starts a sub-step. */
export function warmStartRun(data: SolverData, { kernel, start, end }: Run, isFirst: boolean): void {
  if (kernel === POINT) {
    warmStartPoints(data, start, end);
  } else if (kernel === TURN) {
    warmStartTurns(data, start, end);
  } else if (kernel === DISTANCE) {
    warmStartDistances(data, start, end);
  } else {
    for (let k = start; k < end; k += 1) {
      warmStartBlock(data, k, isFirst);
    }
  }
}

/** Sweeps over a part of a run, from its first joint to its last, or back. @returns whether an error was worth another sweep. */
type Solve = (data: SolverData, kernel: number, start: number, end: number, isBack: boolean) => boolean;

/**
 * Sweep number `sweep` over a group: over all its joints, or only over those that are off and those near them. To and fro it is always over
 * all. @returns whether an error was worth another sweep.
 */
export function sweepOver(data: SolverData, group: Group, sweep: number, isWhole: boolean, solve: Solve): boolean {
  const { runs, toAndFro } = group;
  if (toAndFro && sweep % 2 === 1) {
    return sweepBack(data, runs, solve);
  }
  const from = isWhole || toAndFro ? group.start : group.from;
  const to = isWhole || toAndFro ? group.end : group.to;
  let found = false;
  for (let k = 0; k < runs.length; k += 1) {
    const { kernel, start, end } = runs[k]!;
    if (start < to && end > from) {
      found = solve(data, kernel, start > from ? start : from, end < to ? end : to, false) || found;
    }
  }
  return found;
}

/** Sweeps from the last joint to the first. */
function sweepBack(data: SolverData, runs: readonly Run[], solve: Solve): boolean {
  let found = false;
  for (let n = runs.length - 1; n >= 0; n -= 1) {
    const { kernel, start, end } = runs[n]!;
    found = solve(data, kernel, start, end, true) || found;
  }
  return found;
}

/** One velocity sweep. */
export function solveVelocityRun(
  data: SolverData,
  kernel: number,
  start: number,
  end: number,
  isBack: boolean,
): boolean {
  if (kernel === POINT) {
    solveVelocityPoints(data, start, end, isBack);
  } else if (kernel === TURN) {
    solveVelocityTurns(data, start, end, isBack);
  } else {
    sweepWritten(data, kernel, start, end, isBack, false);
  }
  return false;
}

/** One position sweep. What is left of the errors of rows and blocks is not known: they always ask for another. @returns as `Solve`. */
export function pushRun(data: SolverData, kernel: number, start: number, end: number, isBack: boolean): boolean {
  if (kernel === POINT) {
    return pushPoints(data, start, end, isBack) !== 0;
  }
  if (kernel === TURN) {
    return pushTurns(data, start, end, isBack);
  }
  sweepWritten(data, kernel, start, end, isBack, true);
  return kernel !== CUSTOM;
}

/**
 * Sweeps over joints whose Jacobian is written out: over velocities or, if `isPush`, over the motion of the sub-step. Custom constraints
 * are not swept over, they have iterations of their own.
 */
function sweepWritten(
  data: SolverData,
  kernel: number,
  start: number,
  end: number,
  isBack: boolean,
  isPush: boolean,
): void {
  if (kernel === DISTANCE) {
    sweepDistances(data, start, end, isBack, isPush);
  } else if (kernel === LINE) {
    sweepLines(data, start, end, isBack, isPush);
  } else if (kernel === ANCHORED) {
    sweepAnchored(data, start, end, isBack, isPush);
  } else if (kernel === BLOCK) {
    const sweep = isPush ? pushBlock : solveVelocityBlock;
    for (let k = start; k < end; k += 1) {
      sweep(data, data.joints.joints[isBack ? start + end - 1 - k : k]!);
    }
  }
}

export function pushRunLinearly(
  data: SolverData,
  kernel: number,
  start: number,
  end: number,
  isBack: boolean,
): boolean {
  return kernel === POINT
    ? pushPointsLinearly(data, start, end, isBack) !== 0
    : pushRun(data, kernel, start, end, isBack);
}

export function pushTurnedRun(data: SolverData, kernel: number, start: number, end: number, isBack: boolean): boolean {
  return kernel === POINT
    ? pushTurnedPoints(data, start, end, isBack) !== 0
    : pushRun(data, kernel, start, end, isBack);
}

/**
 * Linearises the joints of a group that are not points or turns or, if `isAnew`, those of them whose bodies have turned far since that was
 * done last. @returns whether there were any.
 */
export function linearise(data: SolverData, { runs }: Group, isAnew: boolean): boolean {
  const { joints } = data.joints;
  let found = false;
  for (let i = 0; i < runs.length; i += 1) {
    const { kernel, start, end } = runs[i]!;
    for (let k = start; k < end && kernel >= DISTANCE && kernel <= BLOCK; k += 1) {
      if (!isAnew || hasTurned(data, joints[k]!)) {
        if (kernel === DISTANCE) lineariseDistance(data, joints[k]!);
        else lineariseBlock(data, joints[k]!);
        found = true;
      }
    }
  }
  return found;
}

/** Ends a sub-step. */
export function finishRun(data: SolverData, { kernel, start, end }: Run): void {
  if (kernel === POINT) {
    finishPoints(data, start, end);
  } else if (kernel === TURN) {
    finishTurns(data, start, end);
  } else if (kernel === ANCHORED) {
    finishAnchored(data, start, end);
  } else if (kernel === DISTANCE) {
    finishDistances(data, start, end);
  } else {
    for (let k = start; k < end; k += 1) {
      finishBlock(data, data.joints.joints[k]!);
    }
  }
}

/** Ends a step: writes its results to the records of joints that keep their numbers, and for all others to the constraints. */
export function storeRun(data: SolverData, { kernel, start, end }: Run): void {
  if (kernel === POINT) {
    keepPoints(data, start, end);
  } else if (kernel === TURN) {
    keepTurns(data, start, end);
  }
  for (let k = start; k < end && !keepsNumbers(kernel); k += 1) {
    storeBlock(data, data.joints.joints[k]!);
    if (kernel === DISTANCE) storeDistance(data, data.joints.joints[k]!);
  }
}
