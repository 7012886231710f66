import { ROW_TURN } from '../../../config-joints.js';
import type { SolverData } from '../../data.js';
import * as d from '../../layout.js';
import * as j from '../joint-layout.js';
import { beginBound, beginSpring, clampToBounds, isSlack, noteError } from './blocks.js';
import { tear } from './breaking.js';
import { applyRows, length, writeMatrix } from './jacobian.js';
import { measure } from './pose.js';

/**
 * Block joints with one row between two bodies, straight-line: distances, and the angles that `turns.ts` does not solve. What is not here
 * is done in `blocks.ts`.
 */

/** Starts a sub-step, as `warmStartBlock`. */
export function warmStartRows(data: SolverData, start: number, end: number): void {
  const { records: r, joints } = data.joints;
  for (let m = start; m < end; m += 1) {
    const joint = joints[m]!;
    const { layout, constraint } = joint;
    const { impulse, push, error, jacobian } = layout;
    const i = joint.at & d.OFFSET;
    measure(data, joint, false);
    writeMatrix(data, joint, jacobian);
    r[i + push] = 0;
    if (constraint.isElastic) {
      beginSpring(data, joint);
    } else {
      beginBound(data, joint);
    }
    if (r[i + j.PUSH] !== 0) {
      length[0] = isSlack(r, joint, error) ? 0 : Math.abs(r[i + error]!);
      noteError(data, m);
    }
    applyRows(data, joint, jacobian, impulse, 1, false);
  }
}

/**
 * One sweep, from the first to the last, or back. Over velocities: λ → clamp(λ − (J·v + bias) · softness / K − feedback · λ); or, if
 * `isPush`, over the motion of the sub-step, with C as linear in it.
 */
export function sweepRows(data: SolverData, start: number, end: number, isBack: boolean, isPush: boolean): void {
  const { records: r, bodies, joints } = data.joints;
  const v = isPush ? data.motion : data.velocity;
  const { size, impulse, push, bias, error, jacobian, turned, matrix, low, high, farBias, farError, total } =
    joints[start]!.layout;
  const step = isBack ? -1 : 1;
  let m = isBack ? end - 1 : start;
  let i = joints[m]!.at & d.OFFSET;
  let n = joints[m]!.first & d.OFFSET;
  for (; m >= start && m < end; m += step, i = (i + step * size) & d.OFFSET, n = (n + 2 * step) & d.OFFSET) {
    if (isPush && r[i + j.PUSH] === 0) {
      continue;
    }
    const a = bodies[n]! & d.OFFSET;
    const b = bodies[n + 1]! & d.OFFSET;
    const p = (i + (isPush ? turned : jacobian)) & d.OFFSET;
    const o = (i + (isPush ? push : impulse)) & d.OFFSET;
    const softness = isPush ? 1 : r[i + j.SOFTNESS]!;
    const feedback = isPush ? 0 : r[i + j.FEEDBACK]!;
    const ax = r[p]!;
    const ay = r[p + 1]!;
    const aw = r[p + 2]!;
    const bx = r[p + 3]!;
    const by = r[p + 4]!;
    const bw = r[p + 5]!;
    const vax = v[a + d.VX]!;
    const vay = v[a + d.VY]!;
    const wA = v[a + d.W]!;
    const vbx = v[b + d.VX]!;
    const vby = v[b + d.VY]!;
    const wB = v[b + d.W]!;
    // In pairs: one sum after the other takes twice as long.
    const c = ax * vax + ay * vay + (bx * vbx + by * vby) + (aw * wA + bw * wB + r[i + (isPush ? error : bias)]!);
    const old = r[o]!;
    const least = r[i + low]!;
    const most = r[i + high]!;
    let next = old - feedback * old - softness * r[i + matrix]! * c;
    next = clampToBounds(next, least, most, r[i + matrix]! * r[i + (isPush ? farError : farBias)]!);
    if (!isPush && r[i + j.CHECKED] !== 0) {
      const sum = r[i + total]! + next;
      const breaking = r[i + j.BREAK]!;
      if (sum > breaking || sum < -breaking) {
        tear(data, joints[m]!);
        continue;
      }
      const limit = r[i + j.LIMIT]!;
      // One that was spared gives way: see `breaking.ts`.
      if (Math.abs(next) > limit && joints[m]!.constraint.breakUnderForce) r[i + j.PUSH] = 0;
      next = next > limit ? limit : next < -limit ? -limit : next;
    }
    const lambda = next - old;
    r[o] = next;
    const mA = v[a + d.INV_MASS]! * lambda;
    const mB = v[b + d.INV_MASS]! * lambda;
    v[a + d.VX] = vax + mA * ax;
    v[a + d.VY] = vay + mA * ay;
    v[a + d.W] = wA + v[a + d.INV_INERTIA]! * lambda * aw;
    v[b + d.VX] = vbx + mB * bx;
    v[b + d.VY] = vby + mB * by;
    v[b + d.W] = wB + v[b + d.INV_INERTIA]! * lambda * bw;
  }
}

/** Ends a sub-step, as `finishBlock`. */
export function finishRows(data: SolverData, start: number, end: number): void {
  const { records: r, joints, share } = data.joints;
  for (let m = start; m < end; m += 1) {
    const joint = joints[m]!;
    const { push, impulse, jacobian, turned, total, carried, given } = joint.layout;
    const i = joint.at & d.OFFSET;
    const p = (i + jacobian) & d.OFFSET;
    const t = (i + turned) & d.OFFSET;
    const g = (i + given) & d.OFFSET;
    const ax = r[p]!;
    const ay = r[p + 1]!;
    const bx = r[p + 3]!;
    const by = r[p + 4]!;
    // As `hasTurnedFar`.
    const dot = ax * r[t]! + ay * r[t + 1]! + (bx * r[t + 3]! + by * r[t + 4]!);
    const along = dot < ROW_TURN * (ax * ax + ay * ay + (bx * bx + by * by)) ? t : p;
    const carry = share[0]! * r[i + j.CARRY]!;
    const held = r[i + impulse]!;
    const pushed = carry * r[i + push]!;
    if (carry !== 0) {
      applyRows(data, joint, along - i, push, carry, false);
    }
    r[i + total] = r[i + total]! + held;
    r[i + carried] = r[i + carried]! + pushed;
    for (let c = 0; c < 6; c += 1) {
      r[g + c] = r[g + c]! + r[p + c]! * held + r[along + c]! * pushed;
    }
  }
}
