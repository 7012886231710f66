import type { SolverData } from '../../data.js';
import type { Group, Run } from '../joint-data.js';
import { ANCHORED, BLOCK, CUSTOM, LINE, POINT, ROW, TURN } from '../joint-layout.js';
import { sweepAnchored } from './anchored.js';
import { lineariseBlock, pushBlock, solveVelocityBlock } from './blocks.js';
import { sweepLines } from './lines.js';
import { pushPoints, pushPointsLinearly, pushTurnedPoints, solveVelocityPoints } from './points.js';
import { sweepRows } from './rows.js';
import { pushTurns, solveVelocityTurns } from './turns.js';

// Sweeps over the runs of a group, each by its kernel.

/** Solves a part of a run, from its first joint to its last, or back. @returns whether it was worth another sweep. */
type Solve = (data: SolverData, kernel: number, start: number, end: number, isBack: boolean) => boolean;

/** The sweep of that number: over all joints of a group, or over those that are off and near that; to and fro it is over all. */
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

/** From the last joint to the first. */
function sweepBack(data: SolverData, runs: readonly Run[], solve: Solve): boolean {
  let found = false;
  for (let n = runs.length - 1; n >= 0; n -= 1) {
    const { kernel, start, end } = runs[n]!;
    found = solve(data, kernel, start, end, true) || found;
  }
  return found;
}

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
  } else if (kernel === ROW) {
    sweepRows(data, start, end, isBack, false);
  } else if (kernel === LINE) {
    sweepLines(data, start, end, isBack, false);
  } else if (kernel === ANCHORED) {
    sweepAnchored(data, start, end, isBack, false);
  } else if (kernel === BLOCK) {
    for (let k = start; k < end; k += 1) {
      solveVelocityBlock(data, data.joints.joints[isBack ? start + end - 1 - k : k]!);
    }
  }
  return false;
}

/** What is left of the errors of rows and blocks is not known. */
export function pushRun(data: SolverData, kernel: number, start: number, end: number, isBack: boolean): boolean {
  if (kernel === POINT) {
    return pushPoints(data, start, end, isBack);
  }
  if (kernel === TURN) {
    return pushTurns(data, start, end, isBack);
  }
  if (kernel === ROW) {
    sweepRows(data, start, end, isBack, true);
  } else if (kernel === LINE) {
    sweepLines(data, start, end, isBack, true);
  } else if (kernel === ANCHORED) {
    sweepAnchored(data, start, end, isBack, true);
  } else if (kernel === BLOCK) {
    for (let k = start; k < end; k += 1) {
      pushBlock(data, data.joints.joints[isBack ? start + end - 1 - k : k]!);
    }
  }
  return kernel !== CUSTOM;
}

export function pushRunLinearly(
  data: SolverData,
  kernel: number,
  start: number,
  end: number,
  isBack: boolean,
): boolean {
  return kernel === POINT ? pushPointsLinearly(data, start, end, isBack) : pushRun(data, kernel, start, end, isBack);
}

export function pushTurnedRun(data: SolverData, kernel: number, start: number, end: number, isBack: boolean): boolean {
  return kernel === POINT ? pushTurnedPoints(data, start, end, isBack) : pushRun(data, kernel, start, end, isBack);
}

export function linearise(data: SolverData, { runs }: Group): void {
  const { joints } = data.joints;
  for (let i = 0; i < runs.length; i += 1) {
    const { kernel, start, end } = runs[i]!;
    for (let k = start; k < end && kernel >= ROW && kernel <= BLOCK; k += 1) {
      lineariseBlock(data, joints[k]!);
    }
  }
}
