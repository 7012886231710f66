import { SPRING_DEBT, SPRING_GAIN } from '../../../config-joints.js';
import { grown } from '../../../math/doubles.js';
import type { SolverData } from '../../data.js';
import * as d from '../../layout.js';
import type { Joint } from '../joint-data.js';
import { BLOCK, DISTANCE, TURN, TURN_RATIO } from '../joint-layout.js';
import { impulseAt } from '../joint-numbers.js';
import { weighByError } from '../kernels/blocks.js';
import { length } from '../kernels/jacobian.js';

// Accounts of the energy of springs. A spring that has the same frequency whatever the masses is harder in one pose of its bodies than in
// another, and bodies that hang on each other could draw energy from it in every turn. So a spring gives only as much as it was given;
// after that it only damps. And its work is not counted as made by rigid joints.

/** The result of `findGiven` and `findHeld`; an array, so that it is not boxed. */
const found = /* @__PURE__ */ new Float64Array(1);

/** Called as a step begins: finds whether there are springs. */
export function beginSprings({ joints: data, bodyCount }: SolverData): void {
  const { groups } = data;
  data.hasSprings = false;
  for (let i = 0; i < groups.length; i += 1) {
    data.hasSprings ||= groups[i]!.frequency > 0;
  }
  if (data.hasSprings && data.work.length < bodyCount) {
    data.work = new Float64Array(grown(bodyCount));
    data.begun = new Float64Array(3 * data.work.length);
  }
  if (data.hasSprings) data.work.fill(0, 0, bodyCount);
}

/** Called as a sub-step begins, after forces and drag: notes the velocities without what these added. */
export function noteVelocities({ joints: { hasSprings, begun }, velocity: v, drive: f, bodyCount }: SolverData): void {
  for (let slot = 1; slot < bodyCount && hasSprings; slot += 1) {
    const i = slot * d.BODY_STRIDE;
    const n = 3 * slot;
    begun[n] = v[i + d.VX]! - f[i + d.GAIN_X]!;
    begun[n + 1] = v[i + d.VY]! - f[i + d.GAIN_Y]!;
    begun[n + 2] = v[i + d.W]! - f[i + d.GAIN_W]!;
  }
}

/** Called as it ends: enters the work of each spring. */
export function enterSprings(data: SolverData): void {
  const { joints, hasSprings, work } = data.joints;
  for (let k = 0; k < joints.length && hasSprings; k += 1) {
    const joint = joints[k]!;
    if (joint.constraint.isElastic) {
      const slot = findGiven(data, joint);
      const given = found[0]!;
      work[slot] = work[slot]! + given;
      if (joint.kernel >= DISTANCE && joint.kernel <= BLOCK) enter(data, joint, given);
    }
  }
}

/**
 * Enters the work of a spring in what it has stored. Angles are left out, as they are as hard in any pose, and custom constraints, as their
 * energy is not known.
 */
function enter(data: SolverData, joint: Joint, given: number): void {
  const { constraint } = joint;
  findHeld(data, joint);
  // Within a sub-step, the account is ahead or behind by half of the work. Debt beyond SPRING_DEBT times that is forgotten: else the spring
  // would be slack for long.
  const most = SPRING_GAIN * found[0]! + Math.abs(given);
  // If numbers have run wild, nothing is entered.
  if (most < Infinity) constraint.stored = Math.max(-SPRING_DEBT * most, Math.min(constraint.stored, most) - given);
}

/**
 * Writes to `found` the work of a spring in the sub-step, J: λ · J · v, with the mean of the velocities before and after, is exactly what
 * an impulse adds to the kinetic energy. @returns the slot of the first member that can move.
 */
function findGiven(data: SolverData, joint: Joint): number {
  const { velocity: v } = data;
  const { records: r, bodies, begun } = data.joints;
  const { kernel, at, layout, first } = joint;
  const { rows, members, jacobian } = layout;
  let slot = 0;
  let twice = 0;
  for (let k = 0; k < members; k += 1) {
    const i = bodies[first + k]!;
    const b = 3 * (i / d.BODY_STRIDE);
    if (slot === 0 && v[i + d.INV_MASS]! + v[i + d.INV_INERTIA]! > 0) slot = i / d.BODY_STRIDE;
    for (let row = 0; row < rows && i > 0; row += 1) {
      const n = at + jacobian + 3 * (row * members + k);
      const turn = begun[b + 2]! + v[i + d.W]!;
      const speed =
        kernel === TURN
          ? turn * (k === 0 ? -1 : r[at + TURN_RATIO]!)
          : r[n]! * (begun[b]! + v[i + d.VX]!) + r[n + 1]! * (begun[b + 1]! + v[i + d.VY]!) + r[n + 2]! * turn;
      twice += r[impulseAt(joint, row)]! * speed;
    }
  }
  found[0] = 0.5 * twice;
  return slot;
}

/**
 * Writes to `found` the energy, J, that a spring as hard as it is now holds at the error with which the sub-step began: ½ · (2π ·
 * frequency)² · C · K⁻¹ · C.
 */
function findHeld(data: SolverData, joint: Joint): void {
  const { records: r } = data.joints;
  const { at, layout, constraint } = joint;
  const { rows, error, work } = layout;
  const w = 2 * Math.PI * constraint.frequency;
  r.copyWithin(at + work, at + error, at + error + rows);
  weighByError(data, joint);
  found[0] = 0.5 * w * w * length[0]!;
}
