import { ROW_AW, ROW_BW, ROW_SIZE } from '../../../constraint/layout.js';
import type { SolverData } from '../../data.js';
import * as d from '../../layout.js';
import * as j from '../joint-layout.js';
import { cutOrBreak } from './breaking.js';
import { applyRows } from './jacobian.js';

/**
 * Welds, and points that are soft or may break: block joints whose first two rows keep two anchors together, and so have unit columns, and
 * whose third, if it is a weld, keeps an angle. Straight-line; what is not here is done in `blocks.ts`.
 */

/**
 * One sweep, from the first to the last, or back: over velocities, as `solveVelocityBlock`, or, if `isPush`, over the motion of the
 * sub-step, as `pushBlock`.
 */
export function sweepAnchored(data: SolverData, start: number, end: number, isBack: boolean, isPush: boolean): void {
  const { records: r, bodies, joints } = data.joints;
  const v = isPush ? data.motion : data.velocity;
  for (let m = start; m < end; m += 1) {
    const joint = joints[isBack ? start + end - 1 - m : m]!;
    const i = joint.at & d.OFFSET;
    if (isPush && r[i + j.PUSH] === 0) {
      continue;
    }
    const { rows, impulse, push, bias, error, jacobian, turned, matrix, work } = joint.layout;
    const isWeld = rows === 3;
    const n = joint.first & d.OFFSET;
    const a = bodies[n]! & d.OFFSET;
    const b = bodies[n + 1]! & d.OFFSET;
    const p = (i + (isPush ? turned : jacobian)) & d.OFFSET;
    const k = (i + matrix) & d.OFFSET;
    const o = (i + (isPush ? push : impulse)) & d.OFFSET;
    const e = (i + (isPush ? error : bias)) & d.OFFSET;
    const softness = isPush ? -1 : -r[i + j.SOFTNESS]!;
    const kept = isPush ? 1 : 1 - r[i + j.FEEDBACK]!;
    const ax = r[p + ROW_AW]!;
    const bx = r[p + ROW_BW]!;
    const ay = r[p + ROW_SIZE + ROW_AW]!;
    const by = r[p + ROW_SIZE + ROW_BW]!;
    const vax = v[a + d.VX]!;
    const vay = v[a + d.VY]!;
    const wA = v[a + d.W]!;
    const vbx = v[b + d.VX]!;
    const vby = v[b + d.VY]!;
    const wB = v[b + d.W]!;
    const l10 = r[k + rows]!;
    const l20 = isWeld ? r[k + 6]! : 0;
    const l21 = isWeld ? r[k + 7]! : 0;
    const oldX = r[o]!;
    const oldY = r[o + 1]!;
    const oldW = isWeld ? r[o + 2]! : 0;
    let x = softness * (ax * wA - vax + (vbx + bx * wB) + r[e]!);
    let y = softness * (ay * wA - vay + (vby + by * wB) + r[e + 1]!) - l10 * x;
    let w = isWeld ? (softness * (wB - wA + r[e + 2]!) - l20 * x - l21 * y) * r[k + 8]! : 0;
    y = y * r[k + rows + 1]! - l21 * w;
    x = x * r[k]! - l10 * y - l20 * w;
    let nextX = kept * oldX + x;
    let nextY = kept * oldY + y;
    let nextW = kept * oldW + w;
    if (!isPush) {
      if (r[i + j.CHECKED] !== 0) {
        r[i + work] = nextX;
        r[i + work + 1] = nextY;
        if (isWeld) r[i + work + 2] = nextW;
        if (cutOrBreak(data, joint)) {
          continue;
        }
        nextX = r[i + work]!;
        nextY = r[i + work + 1]!;
        if (isWeld) nextW = r[i + work + 2]!;
      }
      x = nextX - oldX;
      y = nextY - oldY;
      w = nextW - oldW;
    }
    r[o] = nextX;
    r[o + 1] = nextY;
    if (isWeld) r[o + 2] = nextW;
    const mA = v[a + d.INV_MASS]!;
    const iA = v[a + d.INV_INERTIA]!;
    const mB = v[b + d.INV_MASS]!;
    const iB = v[b + d.INV_INERTIA]!;
    v[a + d.VX] = vax - mA * x;
    v[a + d.VY] = vay - mA * y;
    v[a + d.W] = wA + iA * x * ax + iA * y * ay - iA * w;
    v[b + d.VX] = vbx + mB * x;
    v[b + d.VY] = vby + mB * y;
    v[b + d.W] = wB + iB * x * bx + iB * y * by + iB * w;
  }
}

/** Ends a sub-step, as `finishBlock`. */
export function finishAnchored(data: SolverData, start: number, end: number): void {
  const { records: r, joints, share } = data.joints;
  for (let m = start; m < end; m += 1) {
    const joint = joints[m]!;
    const { rows, push, impulse, jacobian, total, carried, given } = joint.layout;
    const isWeld = rows === 3;
    const i = joint.at & d.OFFSET;
    const p = (i + jacobian) & d.OFFSET;
    const g = (i + given) & d.OFFSET;
    const ax = r[p + ROW_AW]!;
    const bx = r[p + ROW_BW]!;
    const ay = r[p + ROW_SIZE + ROW_AW]!;
    const by = r[p + ROW_SIZE + ROW_BW]!;
    const carry = share[0]! * r[i + j.CARRY]!;
    const heldX = r[i + impulse]!;
    const heldY = r[i + impulse + 1]!;
    const heldW = isWeld ? r[i + impulse + 2]! : 0;
    const pushX = r[i + push]!;
    const pushY = r[i + push + 1]!;
    const pushW = isWeld ? r[i + push + 2]! : 0;
    const x = carry * pushX;
    const y = carry * pushY;
    const w = carry * pushW;
    if (carry !== 0) {
      applyRows(data, joint, jacobian, push, carry, false);
    }
    r[i + total] = r[i + total]! + heldX;
    r[i + total + 1] = r[i + total + 1]! + heldY;
    r[i + carried] = r[i + carried]! + x;
    r[i + carried + 1] = r[i + carried + 1]! + y;
    if (isWeld) {
      r[i + total + 2] = r[i + total + 2]! + heldW;
      r[i + carried + 2] = r[i + carried + 2]! + w;
    }
    r[g] = r[g]! - heldX - x;
    r[g + 1] = r[g + 1]! - heldY - y;
    r[g + 2] = r[g + 2]! + ax * heldX + ax * x + ay * heldY + ay * y - heldW - w;
    r[g + 3] = r[g + 3]! + heldX + x;
    r[g + 4] = r[g + 4]! + heldY + y;
    r[g + 5] = r[g + 5]! + bx * heldX + bx * x + by * heldY + by * y + heldW + w;
  }
}
