import { cutOrBreak } from './breaking.js';
import type { SolverData } from './data.js';
import * as j from './joint-layout.js';
import * as d from './layout.js';

/** The sweeps of block joints for lines, two rows between two bodies, straight-line. All else is done there. */

/** One velocity sweep, from the first to the last, or back: as `solveVelocityBlock`. */
export function solveVelocityLines(data: SolverData, start: number, end: number, isBack: boolean): void {
  const { records: r, bodies, joints } = data.joints;
  const v = data.velocity;
  const { impulse, bias, jacobian, matrix, low, high, work } = joints[start]!.layout;
  for (let m = start; m < end; m += 1) {
    const joint = joints[isBack ? start + end - 1 - m : m]!;
    const i = joint.at & d.OFFSET;
    const n = joint.first & d.OFFSET;
    const a = bodies[n]! & d.OFFSET;
    const b = bodies[n + 1]! & d.OFFSET;
    const p = (i + jacobian) & d.OFFSET;
    const ax = r[p]!;
    const ay = r[p + 1]!;
    const aw = r[p + 2]!;
    const bx = r[p + 3]!;
    const by = r[p + 4]!;
    const bw = r[p + 5]!;
    const ax1 = r[p + 6]!;
    const ay1 = r[p + 7]!;
    const aw1 = r[p + 8]!;
    const bx1 = r[p + 9]!;
    const by1 = r[p + 10]!;
    const bw1 = r[p + 11]!;
    const vax = v[a + d.VX]!;
    const vay = v[a + d.VY]!;
    const wA = v[a + d.W]!;
    const vbx = v[b + d.VX]!;
    const vby = v[b + d.VY]!;
    const wB = v[b + d.W]!;
    const c = ax * vax + ay * vay + aw * wA + (bx * vbx + by * vby + bw * wB) + r[i + bias]!;
    const c1 = ax1 * vax + ay1 * vay + aw1 * wA + (bx1 * vbx + by1 * vby + bw1 * wB) + r[i + bias + 1]!;
    const softness = -r[i + j.SOFTNESS]!;
    const kept = 1 - r[i + j.FEEDBACK]!;
    const l = r[i + matrix + 2]!;
    const old = r[i + impulse]!;
    const old1 = r[i + impulse + 1]!;
    const begun = kept * old1;
    let x1 = (softness * c1 - l * (softness * c)) * r[i + matrix + 3]!;
    if (joint.constraint.bounded) {
      const wanted = begun + x1;
      const least = r[i + low]!;
      const most = r[i + high]!;
      x1 = (wanted < least ? least : wanted > most ? most : wanted) - begun;
    }
    let next = kept * old + (softness * c * r[i + matrix]! - l * x1);
    let next1 = begun + x1;
    if (r[i + j.CHECKED] !== 0) {
      r[i + work] = next;
      r[i + work + 1] = next1;
      if (cutOrBreak(data, joint)) {
        continue;
      }
      next = r[i + work]!;
      next1 = r[i + work + 1]!;
    }
    r[i + impulse] = next;
    r[i + impulse + 1] = next1;
    const lambda = next - old;
    const lambda1 = next1 - old1;
    const mA = v[a + d.INV_MASS]!;
    const iA = v[a + d.INV_INERTIA]!;
    const mB = v[b + d.INV_MASS]!;
    const iB = v[b + d.INV_INERTIA]!;
    v[a + d.VX] = vax + mA * lambda * ax + mA * lambda1 * ax1;
    v[a + d.VY] = vay + mA * lambda * ay + mA * lambda1 * ay1;
    v[a + d.W] = wA + iA * lambda * aw + iA * lambda1 * aw1;
    v[b + d.VX] = vbx + mB * lambda * bx + mB * lambda1 * bx1;
    v[b + d.VY] = vby + mB * lambda * by + mB * lambda1 * by1;
    v[b + d.W] = wB + iB * lambda * bw + iB * lambda1 * bw1;
  }
}

/** One sweep of a position iteration, from the first to the last, or back: as `pushBlock`. */
export function pushLines(data: SolverData, start: number, end: number, isBack: boolean): void {
  const { records: r, bodies, joints } = data.joints;
  const { motion: q } = data;
  const { push, error, turned, matrix, low, high } = joints[start]!.layout;
  for (let m = start; m < end; m += 1) {
    const joint = joints[isBack ? start + end - 1 - m : m]!;
    const i = joint.at & d.OFFSET;
    if (r[i + j.PUSH] === 0) {
      continue;
    }
    const n = joint.first & d.OFFSET;
    const a = bodies[n]! & d.OFFSET;
    const b = bodies[n + 1]! & d.OFFSET;
    const p = (i + turned) & d.OFFSET;
    const ax = r[p]!;
    const ay = r[p + 1]!;
    const aw = r[p + 2]!;
    const bx = r[p + 3]!;
    const by = r[p + 4]!;
    const bw = r[p + 5]!;
    const ax1 = r[p + 6]!;
    const ay1 = r[p + 7]!;
    const aw1 = r[p + 8]!;
    const bx1 = r[p + 9]!;
    const by1 = r[p + 10]!;
    const bw1 = r[p + 11]!;
    const qax = q[a + d.QX]!;
    const qay = q[a + d.QY]!;
    const wA = q[a + d.QW]!;
    const qbx = q[b + d.QX]!;
    const qby = q[b + d.QY]!;
    const wB = q[b + d.QW]!;
    const c = r[i + error]! + (ax * qax + ay * qay + aw * wA + (bx * qbx + by * qby + bw * wB));
    const c1 = r[i + error + 1]! + (ax1 * qax + ay1 * qay + aw1 * wA + (bx1 * qbx + by1 * qby + bw1 * wB));
    const l = r[i + matrix + 2]!;
    const old1 = r[i + push + 1]!;
    let lambda1 = (l * c - c1) * r[i + matrix + 3]!;
    if (joint.constraint.bounded) {
      const wanted = old1 + lambda1;
      const least = r[i + low]!;
      const most = r[i + high]!;
      lambda1 = (wanted < least ? least : wanted > most ? most : wanted) - old1;
    }
    const lambda = -c * r[i + matrix]! - l * lambda1;
    r[i + push] = r[i + push]! + lambda;
    r[i + push + 1] = old1 + lambda1;
    const mA = q[a + d.INV_MASS]!;
    const iA = q[a + d.INV_INERTIA]!;
    const mB = q[b + d.INV_MASS]!;
    const iB = q[b + d.INV_INERTIA]!;
    q[a + d.QX] = qax + mA * lambda * ax + mA * lambda1 * ax1;
    q[a + d.QY] = qay + mA * lambda * ay + mA * lambda1 * ay1;
    q[a + d.QW] = wA + iA * lambda * aw + iA * lambda1 * aw1;
    q[b + d.QX] = qbx + mB * lambda * bx + mB * lambda1 * bx1;
    q[b + d.QY] = qby + mB * lambda * by + mB * lambda1 * by1;
    q[b + d.QW] = wB + iB * lambda * bw + iB * lambda1 * bw1;
  }
}
