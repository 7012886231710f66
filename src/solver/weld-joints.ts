import { cutOrBreak } from './breaking.js';
import type { SolverData } from './data.js';
import * as j from './joint-layout.js';
import * as d from './layout.js';

/** The sweeps of block joints for welds, straight-line: rows of two points that coincide, which have unit columns, and one of an angle. All else is done there. */

/** Numbers of a row of the Jacobian, and where in one those of the arms are. */
const ROW = 6;
const ARM_A = 2;
const ARM_B = 5;

/** One velocity sweep, from the first to the last, or back: as `solveVelocityBlock`. */
export function solveVelocityWelds(data: SolverData, start: number, end: number, isBack: boolean): void {
  const { records: r, bodies, joints } = data.joints;
  const v = data.velocity;
  const { impulse, bias, jacobian, matrix, work } = joints[start]!.layout;
  for (let m = start; m < end; m += 1) {
    const joint = joints[isBack ? start + end - 1 - m : m]!;
    const i = joint.at & d.OFFSET;
    const n = joint.first & d.OFFSET;
    const a = bodies[n]! & d.OFFSET;
    const b = bodies[n + 1]! & d.OFFSET;
    const p = (i + jacobian) & d.OFFSET;
    const k = (i + matrix) & d.OFFSET;
    const ax = r[p + ARM_A]!;
    const bx = r[p + ARM_B]!;
    const ay = r[p + ROW + ARM_A]!;
    const by = r[p + ROW + ARM_B]!;
    const vax = v[a + d.VX]!;
    const vay = v[a + d.VY]!;
    const wA = v[a + d.W]!;
    const vbx = v[b + d.VX]!;
    const vby = v[b + d.VY]!;
    const wB = v[b + d.W]!;
    const softness = -r[i + j.SOFTNESS]!;
    const l10 = r[k + 3]!;
    const l20 = r[k + 6]!;
    const l21 = r[k + 7]!;
    let x = softness * (ax * wA - vax + (vbx + bx * wB) + r[i + bias]!);
    let y = softness * (ay * wA - vay + (vby + by * wB) + r[i + bias + 1]!) - l10 * x;
    const w = (softness * (wB - wA + r[i + bias + 2]!) - l20 * x - l21 * y) * r[k + 8]!;
    y = y * r[k + 4]! - l21 * w;
    x = x * r[k]! - l10 * y - l20 * w;
    const kept = 1 - r[i + j.FEEDBACK]!;
    const oldX = r[i + impulse]!;
    const oldY = r[i + impulse + 1]!;
    const oldW = r[i + impulse + 2]!;
    let nextX = kept * oldX + x;
    let nextY = kept * oldY + y;
    let nextW = kept * oldW + w;
    if (r[i + j.CHECKED] !== 0) {
      r[i + work] = nextX;
      r[i + work + 1] = nextY;
      r[i + work + 2] = nextW;
      if (cutOrBreak(data, joint)) {
        continue;
      }
      nextX = r[i + work]!;
      nextY = r[i + work + 1]!;
      nextW = r[i + work + 2]!;
    }
    r[i + impulse] = nextX;
    r[i + impulse + 1] = nextY;
    r[i + impulse + 2] = nextW;
    x = nextX - oldX;
    y = nextY - oldY;
    const turn = nextW - oldW;
    const mA = v[a + d.INV_MASS]!;
    const iA = v[a + d.INV_INERTIA]!;
    const mB = v[b + d.INV_MASS]!;
    const iB = v[b + d.INV_INERTIA]!;
    v[a + d.VX] = vax - mA * x;
    v[a + d.VY] = vay - mA * y;
    v[a + d.W] = wA + iA * x * ax + iA * y * ay - iA * turn;
    v[b + d.VX] = vbx + mB * x;
    v[b + d.VY] = vby + mB * y;
    v[b + d.W] = wB + iB * x * bx + iB * y * by + iB * turn;
  }
}

/** One sweep of a position iteration, from the first to the last, or back: as `pushBlock`. */
export function pushWelds(data: SolverData, start: number, end: number, isBack: boolean): void {
  const { records: r, bodies, joints } = data.joints;
  const { motion: q } = data;
  const { push, error, turned, matrix } = joints[start]!.layout;
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
    const k = (i + matrix) & d.OFFSET;
    const ax = r[p + ARM_A]!;
    const bx = r[p + ARM_B]!;
    const ay = r[p + ROW + ARM_A]!;
    const by = r[p + ROW + ARM_B]!;
    const qax = q[a + d.QX]!;
    const qay = q[a + d.QY]!;
    const wA = q[a + d.QW]!;
    const qbx = q[b + d.QX]!;
    const qby = q[b + d.QY]!;
    const wB = q[b + d.QW]!;
    const l10 = r[k + 3]!;
    const l20 = r[k + 6]!;
    const l21 = r[k + 7]!;
    let x = -(r[i + error]! + (ax * wA - qax + (qbx + bx * wB)));
    let y = -(r[i + error + 1]! + (ay * wA - qay + (qby + by * wB))) - l10 * x;
    const w = (-(r[i + error + 2]! + (wB - wA)) - l20 * x - l21 * y) * r[k + 8]!;
    y = y * r[k + 4]! - l21 * w;
    x = x * r[k]! - l10 * y - l20 * w;
    r[i + push] = r[i + push]! + x;
    r[i + push + 1] = r[i + push + 1]! + y;
    r[i + push + 2] = r[i + push + 2]! + w;
    const mA = q[a + d.INV_MASS]!;
    const iA = q[a + d.INV_INERTIA]!;
    const mB = q[b + d.INV_MASS]!;
    const iB = q[b + d.INV_INERTIA]!;
    q[a + d.QX] = qax - mA * x;
    q[a + d.QY] = qay - mA * y;
    q[a + d.QW] = wA + iA * x * ax + iA * y * ay - iA * w;
    q[b + d.QX] = qbx + mB * x;
    q[b + d.QY] = qby + mB * y;
    q[b + d.QW] = wB + iB * x * bx + iB * y * by + iB * w;
  }
}
