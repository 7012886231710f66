import { works } from '../collide/polygon-works.js';
import { addForces, advance, moveOn } from './body-loops.js';
import { solvePositionOne, solveVelocityOne, warmStartOne } from './contacts/one-point.js';
import type { SolverData } from './data.js';

/** A loop in a sub-step of length h, over bodies or contacts from one index to another. */
export type Start = (data: SolverData, from: number, to: number, h: number) => void;

/** Sweeps over contacts from one index to another. @returns whether it changed anything worth another iteration. */
export type Sweep = (data: SolverData, from: number, to: number, h: number) => boolean;

/** The loops over bodies, and over contacts of one point and of two. */
export interface Loops {
  readonly addForces: (data: SolverData, from: number, to: number) => void;
  readonly moveOn: Start;
  readonly advance: (data: SolverData, from: number, to: number) => void;
  readonly warmStartOne: Start;
  readonly warmStartTwo: Start;
  readonly solveVelocityOne: Sweep;
  readonly solveVelocityTwo: Sweep;
  readonly solvePositionOne: Sweep;
  readonly solvePositionTwo: Sweep;
}

/** As `Sweep`, over contacts of two points: these are of polygons, which bring the loop along. */
export const solveVelocityTwo: Sweep = (data, from, to, h) => works?.solveVelocityTwo(data, from, to, h) ?? false;

/** The loops in plain TypeScript. */
export const plain: Loops = {
  addForces,
  moveOn,
  advance,
  warmStartOne,
  warmStartTwo: (data, from, to, h) => works?.warmStartTwo(data, from, to, h),
  solveVelocityOne,
  solveVelocityTwo,
  solvePositionOne,
  solvePositionTwo: (data, from, to, h) => works?.solvePositionTwo(data, from, to, h) ?? false,
};
