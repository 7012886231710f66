import { BREAK_STEPS } from '../../../config-joints.js';
import type { SolverData } from '../../data.js';
import type { Joint } from '../joint-data.js';
import * as j from '../joint-layout.js';
import { applyRows, findLength, length } from './jacobian.js';

// Joints break under what they give: in a velocity iteration, or by what they gave as a whole. Under their errors they do in `blocks.ts`.

/** Cuts the impulse to its limit, or breaks the joint if that of the step is too large. @returns whether it broke. */
export function cutOrBreak(data: SolverData, joint: Joint): boolean {
  const { records: r } = data.joints;
  const { at, layout } = joint;
  const { rows, work, total } = layout;
  let square = 0;
  for (let n = 0; n < rows; n += 1) {
    const sum = r[at + total + n]! + r[at + work + n]!;
    square += sum * sum;
  }
  const most = r[at + j.BREAK]!;
  if (square > most * most) {
    tear(data, joint);
    return true;
  }
  findLength(r, at + work, rows);
  const size = length[0]!;
  const limit = r[at + j.LIMIT]!;
  for (let n = 0; n < rows && size > limit; n += 1) {
    r[at + work + n] = (r[at + work + n]! * limit) / size;
  }
  return false;
}

/**
 * A velocity iteration asks for more than a joint bears: it breaks. A sub-step begins with what the last one gave, once more: where the step would have had too much with that alone, it is taken back. Else a
 * rope that tore as it caught a load would throw it upwards.
 */
export function tear(data: SolverData, joint: Joint): void {
  const { records: r } = data.joints;
  const { at, layout } = joint;
  const { rows, work, total, impulse, jacobian } = layout;
  for (let n = 0; n < rows; n += 1) {
    r[at + work + n] = r[at + total + n]! + r[at + impulse + n]!;
  }
  findLength(r, at + work, rows);
  if (length[0]! > r[at + j.BREAK]!) applyRows(data, joint, jacobian, impulse, -1, false);
  data.joints.break(joint);
}

/**
 * Velocity iterations see only part of what a joint has to bear; what turns a swinging body comes half from corrections. But after a
 * sudden load these overshoot for a few steps: only when the whole is too much for several steps on end does the joint break by it.
 */
export function breakByWhole(data: SolverData, joint: Joint): void {
  const { records: r } = data.joints;
  const { at, layout, constraint } = joint;
  const { rows, work, total, carried } = layout;
  for (let n = 0; n < rows; n += 1) {
    r[at + work + n] = r[at + total + n]! + r[at + carried + n]!;
  }
  findLength(r, at + work, rows);
  constraint.strainedSteps = length[0]! > r[at + j.BREAK]! ? constraint.strainedSteps + 1 : 0;
  if (constraint.strainedSteps >= BREAK_STEPS) {
    data.joints.break(joint);
  }
}
