import { CROWD_SWEEPS, HARD_SWEEPS } from '../config.js';
import type { SolverData } from './data.js';
import { solvePositionOne, solveVelocityOne, warmStartOne } from './one-point.js';
import { inPieces } from './pieces.js';
import { solvePositionTwo, solveVelocityTwo, warmStartTwo } from './two-point.js';

/** Starts a sub-step of length h. */
export function warmStartContacts(data: SolverData, h: number, isFirst: boolean): void {
  inPieces(data, 0, data.two.count, warmStartTwo, h, isFirst);
  inPieces(data, 0, data.one.count, warmStartOne, h, isFirst);
}

/** A loop over contacts of one or of two points from one index to another. */
type Loop = (data: SolverData, from: number, to: number) => boolean;

/** The further sweeps over contacts that are hard to solve, until nothing changes. */
function sweepHard(data: SolverData, loopTwo: Loop, loopOne: Loop): void {
  const { hard, hardCount } = data;
  for (let i = 0; i < hardCount; i += 4) {
    let changed = true;
    for (let sweep = 1; sweep < HARD_SWEEPS && changed; sweep += 1) {
      const changedTwo = loopTwo(data, hard[i]!, hard[i + 1]!);
      changed = loopOne(data, hard[i + 2]!, hard[i + 3]!) || changedTwo;
    }
  }
}

/** One sweep over all contacts; over those that are hard to solve some more. @returns whether any velocity changed by more than the tolerance. */
export function solveVelocityContacts(data: SolverData): boolean {
  const changedTwo = inPieces(data, 0, data.two.count, solveVelocityTwo);
  const changedOne = inPieces(data, 0, data.one.count, solveVelocityOne);
  const changed = changedTwo || changedOne;
  if (changed) {
    sweepHard(data, solveVelocityTwo, solveVelocityOne);
  }
  return changed;
}

/** One position iteration, likewise. @returns whether anything was pushed. */
export function solvePositionContacts(data: SolverData): boolean {
  data.crowded = false;
  const pushedTwo = inPieces(data, 0, data.two.count, solvePositionTwo);
  const pushedOne = inPieces(data, 0, data.one.count, solvePositionOne);
  const pushed = pushedTwo || pushedOne;
  if (pushed) {
    sweepHard(data, solvePositionTwo, solvePositionOne);
  }
  return pushed;
}

/** Some more position iterations where circles crowd each other; what rests never does. */
export function partCrowds(data: SolverData): void {
  for (let i = 0; i < CROWD_SWEEPS && data.crowded; i += 1) {
    solvePositionContacts(data);
  }
}
