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

/** One sweep over all contacts; over those that are hard to solve some more. */
export function solveVelocityContacts(data: SolverData): void {
  inPieces(data, 0, data.two.count, solveVelocityTwo);
  inPieces(data, 0, data.one.count, solveVelocityOne);
  const { hard, hardCount } = data;
  for (let i = 0; i < hardCount; i += 4) {
    for (let sweep = 1; sweep < HARD_SWEEPS; sweep += 1) {
      solveVelocityTwo(data, hard[i]!, hard[i + 1]!);
      solveVelocityOne(data, hard[i + 2]!, hard[i + 3]!);
    }
  }
}

/** One position iteration, likewise. @returns whether anything was pushed. */
export function solvePositionContacts(data: SolverData): boolean {
  data.crowded = false;
  const pushedTwo = inPieces(data, 0, data.two.count, solvePositionTwo);
  const pushedOne = inPieces(data, 0, data.one.count, solvePositionOne);
  const { hard, hardCount } = data;
  for (let i = 0; i < hardCount && (pushedTwo || pushedOne); i += 4) {
    for (let sweep = 1; sweep < HARD_SWEEPS; sweep += 1) {
      solvePositionTwo(data, hard[i]!, hard[i + 1]!);
      solvePositionOne(data, hard[i + 2]!, hard[i + 3]!);
    }
  }
  return pushedTwo || pushedOne;
}

/** Some more position iterations where circles crowd each other; what rests never does. */
export function partCrowds(data: SolverData): void {
  for (let i = 0; i < CROWD_SWEEPS && data.crowded; i += 1) {
    solvePositionContacts(data);
  }
}
