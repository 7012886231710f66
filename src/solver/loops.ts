import type { SolverData } from './data.js';
import { solvePositionOne, solveVelocityOne, warmStartOne } from './one-point.js';
import { solvePositionTwo, solveVelocityTwo, warmStartTwo } from './two-point.js';

/** Starts a sub-step, of length h, for contacts from one index to another. */
type Start = (data: SolverData, from: number, to: number, h: number) => void;

/** Sweeps over contacts from one index to another. @returns whether it changed anything worth another iteration. */
export type Sweep = (data: SolverData, from: number, to: number, h: number) => boolean;

/** The loops over contacts of one point and of two. */
export interface Loops {
  readonly warmStartOne: Start;
  readonly warmStartTwo: Start;
  readonly solveVelocityOne: Sweep;
  readonly solveVelocityTwo: Sweep;
  readonly solvePositionOne: Sweep;
  readonly solvePositionTwo: Sweep;
}

/** The loops in plain TypeScript. */
export const plain: Loops = {
  warmStartOne,
  warmStartTwo,
  solveVelocityOne,
  solveVelocityTwo,
  solvePositionOne,
  solvePositionTwo,
};
