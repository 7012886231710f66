import { BREAK_STEPS, BREAK_STEPS_STEADY, FIRM_FEW, STEADY_CHANGE } from '../../../config-joints.js';
import type { SolverData } from '../../data.js';
import { breakJoint, type Joint } from '../joint-data.js';
import * as j from '../joint-layout.js';
import { applyRows, findLength, length } from './jacobian.js';

// Joints that break under force: in a velocity iteration, or by all they gave in a step. Those that break under their error are in
// `blocks.ts`.

/**
 * Cuts the impulse at `work` to its limit, or breaks the joint if the impulse of the step so far is too large. @returns whether it broke.
 */
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
  if (size > limit && joint.constraint.breakUnderForce) r[at + j.PUSH] = 0;
  return false;
}

/**
 * Breaks a joint of which a velocity iteration asks for more than it bears. A sub-step is warm started with the impulse of the last one: if
 * the step has too much with that alone already, that is taken back. Else a rope that tore as it caught a load would throw it upwards.
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
  breakJoint(data.joints, joint);
  spareOthers(data, joint);
}

/**
 * In this step, no other joint of the group breaks by force, as the break may relieve it; else a blow would shatter a whole bridge. The
 * others are limited to their breaking force, and one that gives way is not pushed into place in this step. In this step and the next one, in
 * which they may break, all are pushed without momentum.
 */
function spareOthers({ joints: { groups, joints, records: r, h, substepsLeft } }: SolverData, broken: Joint): void {
  const index = joints.indexOf(broken);
  const { start, end } = groups.find((group) => group.start <= index && index < group.end)!;
  for (let k = start; k < end; k += 1) {
    const { at, constraint, layout } = joints[k]!;
    if (constraint.breakUnderForce) {
      findLength(r, at + layout.total, layout.rows);
      // This sub-step and those to come share what it may still give in the step.
      const left = Math.max(0, r[at + j.BREAK]! - length[0]!) / (substepsLeft + 1);
      r[at + j.BREAK] = Infinity;
      r[at + j.LIMIT] = Math.min(constraint.maxForce * h, left);
      r[at + j.CARRY] = 0;
      constraint.touch();
    }
  }
}

/**
 * Breaks what bore too much in this step; the constraints still hold the numbers of the last one. In each group, only the joint breaks that
 * bore the most beyond its limit, as that may relieve the others: else a taut rope or bridge, all of whose joints bear about the same,
 * would go to pieces at once.
 */
export function breakOverloaded(data: SolverData): void {
  const { groups, joints } = data.joints;
  for (const { mayBreak, start, end } of groups) {
    let worst: Joint | null = null;
    let most = 0;
    for (let k = start; k < end && mayBreak; k += 1) {
      const joint = joints[k]!;
      if (joint.constraint.breakUnderForce && bearsTooMuch(data, joint, end - start <= FIRM_FEW)) {
        const excess = length[0]! / data.joints.records[joint.at + j.BREAK]!;
        if (excess > most) {
          worst = joint;
          most = excess;
        }
      }
    }
    if (worst !== null) breakJoint(data.joints, worst);
  }
}

/**
 * Whether a joint bore too much for long enough. Velocity iterations see only part of what a joint has to bear: of what turns a swinging
 * body, half comes from corrections. But after a sudden load these overshoot for a few steps, and for more where many joints hang together.
 * So the whole breaks a joint only if it is too much for several steps in a row; for fewer, if the group has `few` joints and the load is
 * about as large as in the last step. Leaves the impulse of the step in `length`.
 */
function bearsTooMuch(data: SolverData, joint: Joint, few: boolean): boolean {
  const { records: r } = data.joints;
  const { at, layout, constraint } = joint;
  const { rows, work, total, carried } = layout;
  for (let n = 0; n < rows; n += 1) {
    r[at + work + n] = r[at + total + n]! + r[at + carried + n]!;
  }
  findLength(r, at + work, rows);
  constraint.overloadedSteps = length[0]! > r[at + j.BREAK]! ? constraint.overloadedSteps + 1 : 0;
  return constraint.overloadedSteps >= (few && isSteady(data, joint) ? BREAK_STEPS_STEADY : BREAK_STEPS);
}

/** Whether a joint pulls about as hard in this step as in the last one, whose numbers the constraint still holds. */
function isSteady({ impulseScale, joints: { records: r } }: SolverData, { at, layout, constraint }: Joint): boolean {
  let before = 0;
  let now = 0;
  for (let k = 0; k < 3 * layout.members; k += 1) {
    const last = constraint.given[k]! * impulseScale;
    before += last * last;
    now += r[at + layout.given + k]! * r[at + layout.given + k]!;
  }
  return Math.abs(now - before) <= 2 * STEADY_CHANGE * now;
}
