import type { SolverData } from './data.js';
import { inPieces } from './pieces.js';

/** Forces, gravity and drag of one sub-step. */
export function integrateVelocities(data: SolverData): void {
  inPieces(data, 1, data.bodyCount, data.loops!.addForces);
}

/** The motion of one sub-step, of length h. */
export function integratePositions(data: SolverData, h: number): void {
  inPieces(data, 1, data.bodyCount, data.loops!.moveOn, h);
}

/** Adds the motion of the sub-step, position corrections included, to that of the step. */
export function advance(data: SolverData): void {
  inPieces(data, 1, data.bodyCount, data.loops!.advance);
}
