import { CROWD_SWEEPS, HARD_SWEEPS } from '../../config.js';
import type { SolverData } from '../data.js';
import * as d from '../layout.js';
import type { Sweep } from '../loops.js';
import { inPieces } from '../pieces.js';

/** Warm start: begins a sub-step of length h. */
export function warmStartContacts(data: SolverData, h: number): void {
  const { warmStartTwo, warmStartOne } = data.loops!;
  inPieces(data, 0, data.two.count, warmStartTwo, h);
  inPieces(data, 0, data.one.count, warmStartOne, h);
}

/**
 * One sweep over all contacts, and further ones over those that are hard to solve, until nothing changes there. @returns whether the first
 * one changed anything.
 */
function sweep(data: SolverData, sweepTwo: Sweep, sweepOne: Sweep, h: number): boolean {
  const { hard, hardCount } = data;
  const changedTwo = inPieces(data, 0, data.two.count, sweepTwo, h);
  const changedOne = inPieces(data, 0, data.one.count, sweepOne, h);
  const changed = changedTwo || changedOne;
  for (let i = 0; i < hardCount && changed; i += d.HARD_STRIDE) {
    let more = true;
    for (let times = 1; times < HARD_SWEEPS && more; times += 1) {
      const moreTwo = sweepTwo(data, hard[i + d.FROM_TWO]!, hard[i + d.TO_TWO]!, h);
      more = sweepOne(data, hard[i + d.FROM_ONE]!, hard[i + d.TO_ONE]!, h) || moreTwo;
    }
  }
  return changed;
}

/** One sweep over all contacts, in a sub-step of length h. @returns whether any velocity changed by more than CALM_ACCELERATION · h. */
export function solveVelocityContacts(data: SolverData, h: number): boolean {
  return sweep(data, data.loops!.solveVelocityTwo, data.loops!.solveVelocityOne, h);
}

/** One position iteration over all contacts, in the same way. @returns whether anything was pushed. */
export function solvePositionContacts(data: SolverData): boolean {
  data.deepCircles = 0;
  return sweep(data, data.loops!.solvePositionTwo, data.loops!.solvePositionOne, 0);
}

/** Adds some position iterations where a crowd of circles overlaps deeply, and none that are pressed together do. */
export function partCrowds(data: SolverData): void {
  for (let i = 0; i < CROWD_SWEEPS && data.deepCircles === d.CROWDED; i += 1) {
    solvePositionContacts(data);
  }
}
