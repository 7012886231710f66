import type { SolverData } from './data.js';
import { WINDOW } from './layout.js';

/** A loop over bodies or contacts from one index to another; `h` is for those that need it. */
type Loop = (data: SolverData, from: number, to: number, h: number) => unknown;

/**
 * Runs a loop from one index to another, in pieces. A loop that runs so long in its first calls that it is compiled meanwhile may be
 * entered in its middle ever after, with numbers boxed until it gets there. @returns whether the loop returned `true` for any piece.
 */
export function inPieces(data: SolverData, first: number, end: number, loop: Loop, h = 0): boolean {
  let found = false;
  for (let from = first; from < end; from += WINDOW) {
    found = loop(data, from, Math.min(from + WINDOW, end), h) === true || found;
  }
  return found;
}
