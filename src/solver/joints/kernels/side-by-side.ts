import { JOINT_FAR } from '../../../config-joints.js';
import type { SolverData } from '../../data.js';
import { clearWorst, type Group } from '../joint-data.js';
import { pushPoints, pushPointsLinearly, solveVelocityPoints } from './points.js';

// Sweeps over two groups that lie side by side, over both at once for as long as both ask for the same ones.

/** Which of the two a sweep found an error of: see `Loop` in `points.ts`, as one has the even slots and the other the odd ones. */
const FIRST = 1;
const SECOND = 2;

/** Whether two groups have the same sweeps, over the same ones of their joints, all of them to. */
export function areInStep(first: Group, second: Group): boolean {
  return (
    first.sweeps === second.sweeps &&
    first.from - first.start === second.from - second.start &&
    first.to - first.start === second.to - second.start &&
    !first.toAndFro &&
    !second.toAndFro
  );
}

/** A velocity sweep over two groups that are in step. */
export function solveVelocityBeside(data: SolverData, first: Group, second: Group): void {
  solveVelocityPoints(data, startOf(first), endOf(second), false);
}

/** Position sweeps from number `before` up to `after`. The first one, which is exact, is over both in any case. */
export function pushBeside(data: SolverData, first: Group, second: Group, before: number, after: number): void {
  const { worst } = data.joints;
  let sweep = before;
  let found = FIRST + SECOND;
  if (before === 0) {
    clearWorst(data.joints);
    found = pushPoints(data, first.start, second.end, false);
    first.pushedSquare = worst[0]!;
    second.pushedSquare = worst[1]!;
    sweep = 1;
  }
  const areAlike = areInStep(first, second) && isLinear(first) && isLinear(second);
  for (; areAlike && found === FIRST + SECOND && sweep < after; sweep += 1) {
    found = pushPointsLinearly(data, startOf(first), endOf(second), false);
  }
  first.pushed = sweep;
  second.pushed = areAlike ? sweep : 1;
  first.isPushed = (found & FIRST) === 0;
  second.isPushed = (found & SECOND) === 0;
}

/** Whether all position sweeps after the first one are linear, and no more than that finds errors. */
function isLinear({ pushedSquare, isFirm, settling, touched }: Group): boolean {
  return pushedSquare <= JOINT_FAR * JOINT_FAR && !isFirm && settling === 0 && !touched;
}

function startOf({ start, from }: Group): number {
  return Math.max(start, from);
}

function endOf({ end, to }: Group): number {
  return Math.min(end, to);
}
