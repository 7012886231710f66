import { grown } from '../math/doubles.js';
import type { SolverData } from './data.js';
import type { Joint } from './joint-data.js';
import { TURN, TURN_RATIO } from './joint-layout.js';
import { impulseAt } from './joint-numbers.js';
import * as d from './layout.js';

// The work of springs: what bodies have of energy by it no rigid joint has made.

/** As a step begins: whether it is to be added up. */
export function beginWork({ joints: data, bodyCount }: SolverData): void {
  const { groups } = data;
  let isWatched = false;
  let isElastic = false;
  for (let i = 0; i < groups.length; i += 1) {
    isWatched ||= groups[i]!.isWatched;
    isElastic ||= groups[i]!.frequency > 0;
  }
  data.addsWork = isWatched && isElastic;
  if (data.addsWork) {
    if (data.work.length < bodyCount) {
      data.work = new Float64Array(grown(bodyCount));
      data.begun = new Float64Array(3 * data.work.length);
    }
    data.work.fill(0, 0, bodyCount);
  }
}

/** As a sub-step begins, after forces and drag: the velocities, less what half of the former adds. */
export function noteVelocities({ joints: { addsWork, begun }, velocity: v, drive: f, bodyCount }: SolverData): void {
  for (let slot = 1; slot < bodyCount && addsWork; slot += 1) {
    const i = slot * d.BODY_STRIDE;
    const n = 3 * slot;
    begun[n] = v[i + d.VX]! - f[i + d.GAIN_X]!;
    begun[n + 1] = v[i + d.VY]! - f[i + d.GAIN_Y]!;
    begun[n + 2] = v[i + d.W]! - f[i + d.GAIN_W]!;
  }
}

/** As it ends: λ · J · v of the mean of the velocities before and after is what an impulse adds to the kinetic energy. */
export function addWork(data: SolverData): void {
  const { joints, addsWork } = data.joints;
  for (let k = 0; k < joints.length && addsWork; k += 1) {
    const joint = joints[k]!;
    if (joint.constraint.isElastic) {
      addWorkOf(data, joint);
    }
  }
}

/** It is written down for the first member that can move. */
function addWorkOf(data: SolverData, joint: Joint): void {
  const { records: r, bodies, work } = data.joints;
  const { velocity: v } = data;
  const { kernel, at, layout, first } = joint;
  const { rows, members, jacobian } = layout;
  let slot = 0;
  let sum = 0;
  for (let k = 0; k < members; k += 1) {
    const i = bodies[first + k]!;
    if (slot === 0 && v[i + d.INV_MASS]! + v[i + d.INV_INERTIA]! > 0) slot = i / d.BODY_STRIDE;
    for (let row = 0; row < rows; row += 1) {
      const lambda = r[impulseAt(joint, row)]!;
      const n = at + jacobian + 3 * (row * members + k);
      sum +=
        kernel === TURN
          ? lambda * (k === 0 ? -1 : r[at + TURN_RATIO]!) * mean(data, i, d.W)
          : lambda * (r[n]! * mean(data, i, d.VX) + r[n + 1]! * mean(data, i, d.VY) + r[n + 2]! * mean(data, i, d.W));
    }
  }
  work[slot] = work[slot]! + sum;
}

function mean({ velocity: v, joints: { begun } }: SolverData, i: number, part: number): number {
  return i === 0 ? 0 : 0.5 * (v[i + part]! + begun[3 * (i / d.BODY_STRIDE) + part]!);
}
