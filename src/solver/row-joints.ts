import { tear } from './breaking.js';
import type { SolverData } from './data.js';
import * as j from './joint-layout.js';
import * as d from './layout.js';

/** The sweeps of block joints for one row between two bodies, straight-line. All else is done there. */

/** One velocity sweep, from the first to the last, or back: λ → clamp(λ − (J·v + bias) · softness / K − feedback · λ). */
export function solveVelocityRows(data: SolverData, start: number, end: number, isBack: boolean): void {
  const { records: r, bodies, joints } = data.joints;
  const v = data.velocity;
  const { layout } = joints[start]!;
  const { impulse, bias, jacobian, matrix, low, high, total, size } = layout;
  const step = isBack ? -1 : 1;
  let k = isBack ? end - 1 : start;
  let i = joints[k]!.at;
  let n = joints[k]!.first;
  for (; k >= start && k < end; k += step, i = (i + step * size) & d.OFFSET, n = (n + 2 * step) & d.OFFSET) {
    const a = bodies[n]! & d.OFFSET;
    const b = bodies[n + 1]! & d.OFFSET;
    const row = (i + jacobian) & d.OFFSET;
    const ax = r[row]!;
    const ay = r[row + 1]!;
    const aw = r[row + 2]!;
    const bx = r[row + 3]!;
    const by = r[row + 4]!;
    const bw = r[row + 5]!;
    const vax = v[a + d.VX]!;
    const vay = v[a + d.VY]!;
    const wA = v[a + d.W]!;
    const vbx = v[b + d.VX]!;
    const vby = v[b + d.VY]!;
    const wB = v[b + d.W]!;
    const c = ax * vax + ay * vay + aw * wA + bx * vbx + by * vby + bw * wB + r[i + bias]!;
    const old = r[i + impulse]!;
    const least = r[i + low]!;
    const most = r[i + high]!;
    let next = old - r[i + j.SOFTNESS]! * r[i + matrix]! * c - r[i + j.FEEDBACK]! * old;
    next = next < least ? least : next > most ? most : next;
    if (r[i + j.CHECKED] !== 0) {
      const sum = r[i + total]! + next;
      const breaking = r[i + j.BREAK]!;
      if (sum > breaking || sum < -breaking) {
        tear(data, joints[k]!);
        continue;
      }
      const limit = r[i + j.LIMIT]!;
      next = next > limit ? limit : next < -limit ? -limit : next;
    }
    const lambda = next - old;
    r[i + impulse] = next;
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

/** One sweep of a position iteration, from the first to the last, or back: moves the bodies by −M⁻¹·Jᵀ·C / K, C as its linear part has it. */
export function pushRows(data: SolverData, start: number, end: number, isBack: boolean): void {
  const { records: r, bodies, joints } = data.joints;
  const { motion: q } = data;
  const { layout } = joints[start]!;
  const { push, error, turned, matrix, low, high, size } = layout;
  const step = isBack ? -1 : 1;
  let k = isBack ? end - 1 : start;
  let i = joints[k]!.at;
  let n = joints[k]!.first;
  for (; k >= start && k < end; k += step, i = (i + step * size) & d.OFFSET, n = (n + 2 * step) & d.OFFSET) {
    if (r[i + j.PUSH] === 0) {
      continue;
    }
    const a = bodies[n]! & d.OFFSET;
    const b = bodies[n + 1]! & d.OFFSET;
    const row = (i + turned) & d.OFFSET;
    const ax = r[row]!;
    const ay = r[row + 1]!;
    const aw = r[row + 2]!;
    const bx = r[row + 3]!;
    const by = r[row + 4]!;
    const bw = r[row + 5]!;
    const qax = q[a + d.QX]!;
    const qay = q[a + d.QY]!;
    const wA = q[a + d.QW]!;
    const qbx = q[b + d.QX]!;
    const qby = q[b + d.QY]!;
    const wB = q[b + d.QW]!;
    const c = ax * qax + ay * qay + aw * wA + bx * qbx + by * qby + bw * wB + r[i + error]!;
    const old = r[i + push]!;
    const least = r[i + low]!;
    const most = r[i + high]!;
    let next = old - r[i + matrix]! * c;
    next = next < least ? least : next > most ? most : next;
    const lambda = next - old;
    r[i + push] = next;
    const mA = q[a + d.INV_MASS]! * lambda;
    const mB = q[b + d.INV_MASS]! * lambda;
    q[a + d.QX] = qax + mA * ax;
    q[a + d.QY] = qay + mA * ay;
    q[a + d.QW] = wA + q[a + d.INV_INERTIA]! * lambda * aw;
    q[b + d.QX] = qbx + mB * bx;
    q[b + d.QY] = qby + mB * by;
    q[b + d.QW] = wB + q[b + d.INV_INERTIA]! * lambda * bw;
  }
}
