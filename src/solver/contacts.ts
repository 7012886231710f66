import { CROWD_SWEEPS, HARD_SWEEPS } from '../config.js';
import { type SolverData, WINDOW } from './data.js';
import { solvePositionOne, solveVelocityOne, warmStartOne } from './one-point.js';
import { solvePositionTwo, solveVelocityTwo, warmStartTwo } from './two-point.js';

/** Where the piece of a list ends that begins at `from`. */
function endOf(from: number, count: number): number {
  return from + WINDOW < count ? from + WINDOW : count;
}

/** Starts a sub-step of length h. */
export function warmStartContacts(data: SolverData, h: number, isFirst: boolean): void {
  const two = data.two.count;
  const one = data.one.count;
  for (let from = 0; from < two; from += WINDOW) {
    warmStartTwo(data, from, endOf(from, two), h, isFirst);
  }
  for (let from = 0; from < one; from += WINDOW) {
    warmStartOne(data, from, endOf(from, one), h, isFirst);
  }
}

/**
 * One sweep over all contacts; over those that are hard to solve some more. They are given to the loops in pieces: a loop that runs so long in its
 * first calls that it is compiled there may be entered in its middle ever after, with numbers boxed until it gets there.
 */
export function solveVelocityContacts(data: SolverData): void {
  const two = data.two.count;
  const one = data.one.count;
  for (let from = 0; from < two; from += WINDOW) {
    solveVelocityTwo(data, from, endOf(from, two));
  }
  for (let from = 0; from < one; from += WINDOW) {
    solveVelocityOne(data, from, endOf(from, one));
  }
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
  const two = data.two.count;
  const one = data.one.count;
  let pushedTwo = false;
  let pushedOne = false;
  for (let from = 0; from < two; from += WINDOW) {
    pushedTwo = solvePositionTwo(data, from, endOf(from, two)) || pushedTwo;
  }
  for (let from = 0; from < one; from += WINDOW) {
    pushedOne = solvePositionOne(data, from, endOf(from, one)) || pushedOne;
  }
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
