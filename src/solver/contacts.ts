import { CROWD_SWEEPS, HARD_SWEEPS } from '../config.js';
import type { SolverData } from './data.js';
import { solvePositionOne, solveVelocityOne, warmStartOne } from './one-point.js';
import { inPieces } from './pieces.js';
import { solvePositionTwo, solveVelocityTwo, warmStartTwo } from './two-point.js';

/** Starts a sub-step of length h. */
export function warmStartContacts(data: SolverData, h: number): void {
  inPieces(data, 0, data.two.count, warmStartTwo, h);
  inPieces(data, 0, data.one.count, warmStartOne, h);
}

/** A loop over contacts of one or of two points from one index to another. */
type Loop = (data: SolverData, from: number, to: number, h: number) => boolean;

/** One sweep over all contacts; over those that are hard to solve some more, until nothing changes. @returns whether anything did. */
function sweep(data: SolverData, loopTwo: Loop, loopOne: Loop, h: number): boolean {
  const { hard, hardCount } = data;
  const changedTwo = inPieces(data, 0, data.two.count, loopTwo, h);
  const changedOne = inPieces(data, 0, data.one.count, loopOne, h);
  const changed = changedTwo || changedOne;
  for (let i = 0; i < hardCount && changed; i += 4) {
    let more = true;
    for (let times = 1; times < HARD_SWEEPS && more; times += 1) {
      const moreTwo = loopTwo(data, hard[i]!, hard[i + 1]!, h);
      more = loopOne(data, hard[i + 2]!, hard[i + 3]!, h) || moreTwo;
    }
  }
  return changed;
}

/** One sweep over all contacts, in a sub-step of length h. @returns whether any velocity changed by more than CALM_ACCELERATION · h. */
export function solveVelocityContacts(data: SolverData, h: number): boolean {
  return sweep(data, solveVelocityTwo, solveVelocityOne, h);
}

/** One position iteration, likewise. @returns whether anything was pushed. */
export function solvePositionContacts(data: SolverData): boolean {
  data.crowded = false;
  return sweep(data, solvePositionTwo, solvePositionOne, 0);
}

/** Some more position iterations where circles crowd each other; what rests never does. */
export function partCrowds(data: SolverData): void {
  for (let i = 0; i < CROWD_SWEEPS && data.crowded; i += 1) {
    solvePositionContacts(data);
  }
}
