import { MIN_INVERSE_MASS } from '../../../config.js';
import { JOINT_FAR_TURN, JOINT_SNAP, JOINT_TOLERANCE, SINGULAR, STRESS_FADES } from '../../../config-joints.js';
import { COS, SIN, X, Y } from '../../../constraint/layout.js';
import { cosSin } from '../../../math/trig.js';
import type { SolverData } from '../../data.js';
import * as d from '../../layout.js';
import * as j from '../joint-layout.js';

// The loops over rigid point joints, from the record `from` up to, not including, `to`: over each, or every second one, or back. `to` must
// be a whole number of steps away.

/** Angle, cosine, sine: scratch. */
const turn = /* @__PURE__ */ new Float64Array(3);

/** Starts a sub-step: finds arms, error and K⁻¹ for the present placement, and warm starts with the impulse of the last sub-step. */
export function warmStartPoints(data: SolverData, from: number, to: number, step: number): number {
  const { points: r, pointBodies: bodies, velocity: v, pose: p } = data;
  const { worst } = data.joints;
  for (let k = from; k !== to; k += step) {
    if ((bodies[2 * k]! & d.MISSING) !== 0) {
      continue;
    }
    const i = ((k & d.EVEN) * j.POINT_STRIDE + (k & 1)) & d.OFFSET;
    const a = bodies[2 * k]! & d.OFFSET;
    const b = bodies[2 * k + 1]! & d.OFFSET;
    const xA = r[i + j.ANCHOR_AX]!;
    const yA = r[i + j.ANCHOR_AY]!;
    const xB = r[i + j.ANCHOR_BX]!;
    const yB = r[i + j.ANCHOR_BY]!;
    const cosA = p[a + COS]!;
    const sinA = p[a + SIN]!;
    const cosB = p[b + COS]!;
    const sinB = p[b + SIN]!;
    const ax = cosA * xA - sinA * yA;
    const ay = sinA * xA + cosA * yA;
    const bx = cosB * xB - sinB * yB;
    const by = sinB * xB + cosB * yB;
    const cx = p[b + X]! - p[a + X]! + (bx - ax);
    const cy = p[b + Y]! - p[a + Y]! + (by - ay);
    const square = cx * cx + cy * cy;
    if (square > worst[k & 1]!) {
      worst[k & 1] = square;
    }
    r[i + j.ARM_AX] = ax;
    r[i + j.ARM_AY] = ay;
    r[i + j.ARM_BX] = bx;
    r[i + j.ARM_BY] = by;
    r[i + j.ERROR_X] = cx;
    r[i + j.ERROR_Y] = cy;
    r[i + j.PUSH_X] = 0;
    r[i + j.PUSH_Y] = 0;
    const mA = v[a + d.INV_MASS]!;
    const mB = v[b + d.INV_MASS]!;
    const iA = v[a + d.INV_INERTIA]!;
    const iB = v[b + d.INV_INERTIA]!;
    const m = mA + mB;
    const k11 = m + iA * ay * ay + iB * by * by;
    const k12 = -iA * ax * ay - iB * bx * by;
    const k22 = m + iA * ax * ax + iB * bx * bx;
    r[i + j.I11] = k11;
    r[i + j.I12] = k12;
    r[i + j.I22] = k22;
    invert(r, i);
    const px = r[i + j.IMPULSE_X]!;
    const py = r[i + j.IMPULSE_Y]!;
    v[a + d.VX] = v[a + d.VX]! - mA * px;
    v[a + d.VY] = v[a + d.VY]! - mA * py;
    v[a + d.W] = v[a + d.W]! - iA * (ax * py - ay * px);
    v[b + d.VX] = v[b + d.VX]! + mB * px;
    v[b + d.VY] = v[b + d.VY]! + mB * py;
    v[b + d.W] = v[b + d.W]! + iB * (bx * py - by * px);
  }
  return 0;
}

/**
 * Inverts K in place. If K has rank 1, only its larger diagonal element is inverted; if it is 0, so is the result. In the record, as
 * doubles would be boxed if passed.
 */
function invert(r: Float64Array, i: number): void {
  const k11 = r[i + j.I11]!;
  const k12 = r[i + j.I12]!;
  const k22 = r[i + j.I22]!;
  const product = k11 * k22;
  const det = product - k12 * k12;
  if (det > SINGULAR * product && k11 > MIN_INVERSE_MASS && k22 > MIN_INVERSE_MASS) {
    const inverse = 1 / det;
    r[i + j.I11] = k22 * inverse;
    r[i + j.I12] = -k12 * inverse;
    r[i + j.I22] = k11 * inverse;
  } else {
    r[i + j.I11] = k11 >= k22 && k11 > MIN_INVERSE_MASS ? 1 / k11 : 0;
    r[i + j.I12] = 0;
    r[i + j.I22] = k22 > k11 && k22 > MIN_INVERSE_MASS ? 1 / k22 : 0;
  }
}

/** One velocity sweep: Δλ = −K⁻¹C'. */
export function solveVelocityPoints(data: SolverData, from: number, to: number, step: number): number {
  const { points: r, pointBodies: bodies, velocity: v } = data;
  for (let k = from; k !== to; k += step) {
    if ((bodies[2 * k]! & d.MISSING) !== 0) {
      continue;
    }
    const i = ((k & d.EVEN) * j.POINT_STRIDE + (k & 1)) & d.OFFSET;
    const a = bodies[2 * k]! & d.OFFSET;
    const b = bodies[2 * k + 1]! & d.OFFSET;
    const ax = r[i + j.ARM_AX]!;
    const ay = r[i + j.ARM_AY]!;
    const bx = r[i + j.ARM_BX]!;
    const by = r[i + j.ARM_BY]!;
    const vax = v[a + d.VX]!;
    const vay = v[a + d.VY]!;
    const wA = v[a + d.W]!;
    const vbx = v[b + d.VX]!;
    const vby = v[b + d.VY]!;
    const wB = v[b + d.W]!;
    const cx = vbx - vax - wB * by + wA * ay;
    const cy = vby - vay + wB * bx - wA * ax;
    const i12 = r[i + j.I12]!;
    const x = r[i + j.I11]! * cx + i12 * cy;
    const y = i12 * cx + r[i + j.I22]! * cy;
    r[i + j.IMPULSE_X] = r[i + j.IMPULSE_X]! - x;
    r[i + j.IMPULSE_Y] = r[i + j.IMPULSE_Y]! - y;
    const mA = v[a + d.INV_MASS]!;
    const mB = v[b + d.INV_MASS]!;
    v[a + d.VX] = vax + mA * x;
    v[a + d.VY] = vay + mA * y;
    v[a + d.W] = wA + v[a + d.INV_INERTIA]! * (ax * y - ay * x);
    v[b + d.VX] = vbx - mB * x;
    v[b + d.VY] = vby - mB * y;
    v[b + d.W] = wB - v[b + d.INV_INERTIA]! * (bx * y - by * x);
  }
  return 0;
}

/**
 * One exact position sweep: corrects by −K⁻¹C, with error, arms and K⁻¹ of the placement reached so far. With K⁻¹ of the start of the
 * sub-step, a pendulum is 1 mm off after 5 s.
 *
 * @returns which errors were worth another iteration: 1 for one in an even slot, plus 2 for one in an odd slot.
 */
export function pushPoints(data: SolverData, from: number, to: number, step: number): number {
  const { points: r, pointBodies: bodies, motion: q } = data;
  const { worst } = data.joints;
  let found = 0;
  for (let k = from; k !== to; k += step) {
    if ((bodies[2 * k]! & d.MISSING) !== 0) {
      continue;
    }
    const i = ((k & d.EVEN) * j.POINT_STRIDE + (k & 1)) & d.OFFSET;
    const a = bodies[2 * k]! & d.OFFSET;
    const b = bodies[2 * k + 1]! & d.OFFSET;
    const qax = q[a + d.QX]!;
    const qay = q[a + d.QY]!;
    const wA = q[a + d.QW]!;
    const qbx = q[b + d.QX]!;
    const qby = q[b + d.QY]!;
    const wB = q[b + d.QW]!;
    const squareA = wA * wA;
    const squareB = wB * wB;
    // For small turns, the first terms are exact to a ten-millionth of the arm; the next sub-step removes that error.
    let ca = squareA * (squareA * (1 / 24) - 0.5);
    let sa = wA * (1 - squareA * (1 / 6 - squareA * (1 / 120)));
    let cb = squareB * (squareB * (1 / 24) - 0.5);
    let sb = wB * (1 - squareB * (1 / 6 - squareB * (1 / 120)));
    if (squareA > d.SMALL_TURN * d.SMALL_TURN || squareB > d.SMALL_TURN * d.SMALL_TURN) {
      turn[0] = wA;
      cosSin(turn);
      ca = turn[1]! - 1;
      sa = turn[2]!;
      turn[0] = wB;
      cosSin(turn);
      cb = turn[1]! - 1;
      sb = turn[2]!;
    }
    let ax = r[i + j.ARM_AX]!;
    let ay = r[i + j.ARM_AY]!;
    let bx = r[i + j.ARM_BX]!;
    let by = r[i + j.ARM_BY]!;
    const dax = ca * ax - sa * ay;
    const day = sa * ax + ca * ay;
    const dbx = cb * bx - sb * by;
    const dby = sb * bx + cb * by;
    const cx = r[i + j.ERROR_X]! + (qbx - qax) + (dbx - dax);
    const cy = r[i + j.ERROR_Y]! + (qby - qay) + (dby - day);
    const square = cx * cx + cy * cy;
    if (square > JOINT_TOLERANCE * JOINT_TOLERANCE) {
      found |= 1 + (k & 1);
      if (square > worst[k & 1]!) {
        worst[k & 1] = square;
      }
    }
    const mA = q[a + d.INV_MASS]!;
    const mB = q[b + d.INV_MASS]!;
    ax += dax;
    ay += day;
    bx += dbx;
    by += dby;
    const iA = q[a + d.INV_INERTIA]!;
    const iB = q[b + d.INV_INERTIA]!;
    const m = mA + mB;
    const k11 = m + iA * ay * ay + iB * by * by;
    const k12 = -iA * ax * ay - iB * bx * by;
    const k22 = m + iA * ax * ax + iB * bx * bx;
    r[i + j.PLACED_WA] = wA;
    r[i + j.PLACED_WB] = wB;
    r[i + j.PLACED_AX] = ax;
    r[i + j.PLACED_AY] = ay;
    r[i + j.PLACED_BX] = bx;
    r[i + j.PLACED_BY] = by;
    r[i + j.OFFSET_X] = cx - (qbx - qax - wB * by + wA * ay);
    r[i + j.OFFSET_Y] = cy - (qby - qay + wB * bx - wA * ax);
    r[i + j.I11] = k11;
    r[i + j.I12] = k12;
    r[i + j.I22] = k22;
    invert(r, i);
    const i12 = r[i + j.I12]!;
    let x = r[i + j.I11]! * cx + i12 * cy;
    let y = i12 * cx + r[i + j.I22]! * cy;
    if (square > JOINT_SNAP * JOINT_SNAP && r[i + j.POINT_SNAPS] !== 0 && m > MIN_INVERSE_MASS) {
      x = cx / m;
      y = cy / m;
      ax = 0;
      ay = 0;
      bx = 0;
      by = 0;
    }
    r[i + j.PUSH_X] = r[i + j.PUSH_X]! - x;
    r[i + j.PUSH_Y] = r[i + j.PUSH_Y]! - y;
    q[a + d.QX] = qax + mA * x;
    q[a + d.QY] = qay + mA * y;
    q[a + d.QW] = wA + iA * (ax * y - ay * x);
    q[b + d.QX] = qbx - mB * x;
    q[b + d.QY] = qby - mB * y;
    q[b + d.QW] = wB - iB * (bx * y - by * x);
  }
  return found;
}

/**
 * Another position sweep, as if error and arms were linear in the motion since the last exact one. @returns as `pushPoints`.
 */
export function pushPointsLinearly(data: SolverData, from: number, to: number, step: number): number {
  const { points: r, pointBodies: bodies, motion: q } = data;
  let found = 0;
  for (let k = from; k !== to; k += step) {
    if ((bodies[2 * k]! & d.MISSING) !== 0) {
      continue;
    }
    const i = ((k & d.EVEN) * j.POINT_STRIDE + (k & 1)) & d.OFFSET;
    const a = bodies[2 * k]! & d.OFFSET;
    const b = bodies[2 * k + 1]! & d.OFFSET;
    const ax = r[i + j.PLACED_AX]!;
    const ay = r[i + j.PLACED_AY]!;
    const bx = r[i + j.PLACED_BX]!;
    const by = r[i + j.PLACED_BY]!;
    const qax = q[a + d.QX]!;
    const qay = q[a + d.QY]!;
    const wA = q[a + d.QW]!;
    const qbx = q[b + d.QX]!;
    const qby = q[b + d.QY]!;
    const wB = q[b + d.QW]!;
    const cx = r[i + j.OFFSET_X]! + (qbx - qax - wB * by + wA * ay);
    const cy = r[i + j.OFFSET_Y]! + (qby - qay + wB * bx - wA * ax);
    if (cx * cx + cy * cy > JOINT_TOLERANCE * JOINT_TOLERANCE) {
      found |= 1 + (k & 1);
    }
    const i12 = r[i + j.I12]!;
    const x = r[i + j.I11]! * cx + i12 * cy;
    const y = i12 * cx + r[i + j.I22]! * cy;
    r[i + j.PUSH_X] = r[i + j.PUSH_X]! - x;
    r[i + j.PUSH_Y] = r[i + j.PUSH_Y]! - y;
    const mA = q[a + d.INV_MASS]!;
    const mB = q[b + d.INV_MASS]!;
    q[a + d.QX] = qax + mA * x;
    q[a + d.QY] = qay + mA * y;
    q[a + d.QW] = wA + q[a + d.INV_INERTIA]! * (ax * y - ay * x);
    q[b + d.QX] = qbx - mB * x;
    q[b + d.QY] = qby - mB * y;
    q[b + d.QW] = wB - q[b + d.INV_INERTIA]! * (bx * y - by * x);
  }
  return found;
}

/** Turns the impulses by the mean turn of their bodies in the sub-step, and lets them fade, as `energy/stress.ts` does with all others. */
export function turnPoints(data: SolverData, from: number, to: number, step: number): void {
  const { points: r, pointBodies: bodies, motion: q } = data;
  for (let k = from; k !== to; k += step) {
    if ((bodies[2 * k]! & d.MISSING) !== 0) {
      continue;
    }
    const i = ((k & d.EVEN) * j.POINT_STRIDE + (k & 1)) & d.OFFSET;
    const half = 0.25 * (q[(bodies[2 * k]! & d.OFFSET) + d.QW]! + q[(bodies[2 * k + 1]! & d.OFFSET) + d.QW]!);
    const kept = 1 - STRESS_FADES * Math.min(1, 2 * Math.abs(half));
    const share = kept / (1 + half * half);
    const c = share * (1 - half * half);
    const s = share * 2 * half;
    const x = r[i + j.IMPULSE_X]!;
    const y = r[i + j.IMPULSE_Y]!;
    r[i + j.IMPULSE_X] = c * x - s * y;
    r[i + j.IMPULSE_Y] = s * x + c * y;
  }
}

/** Whether a body has turned far since the last exact position sweep. */
export function haveTurned(data: SolverData, from: number, to: number, step: number): boolean {
  const { points: r, pointBodies: bodies, motion: q } = data;
  for (let k = from; k !== to; k += step) {
    if ((bodies[2 * k]! & d.MISSING) !== 0) {
      continue;
    }
    const i = ((k & d.EVEN) * j.POINT_STRIDE + (k & 1)) & d.OFFSET;
    const wA = Math.abs(q[(bodies[2 * k]! & d.OFFSET) + d.QW]! - r[i + j.PLACED_WA]!);
    const wB = Math.abs(q[(bodies[2 * k + 1]! & d.OFFSET) + d.QW]! - r[i + j.PLACED_WB]!);
    if (wA > JOINT_FAR_TURN || wB > JOINT_FAR_TURN) {
      return true;
    }
  }
  return false;
}

/** Writes to `left` the largest error now, m, as if linear in the motion since the last exact sweep. */
export function measurePoints(data: SolverData, from: number, to: number, step: number): void {
  const { points: r, pointBodies: bodies, motion: q } = data;
  let most = 0;
  for (let k = from; k !== to; k += step) {
    if ((bodies[2 * k]! & d.MISSING) !== 0) {
      continue;
    }
    const i = ((k & d.EVEN) * j.POINT_STRIDE + (k & 1)) & d.OFFSET;
    const a = bodies[2 * k]! & d.OFFSET;
    const b = bodies[2 * k + 1]! & d.OFFSET;
    const wA = q[a + d.QW]!;
    const wB = q[b + d.QW]!;
    const turnedX = wA * r[i + j.PLACED_AY]! - wB * r[i + j.PLACED_BY]!;
    const turnedY = wB * r[i + j.PLACED_BX]! - wA * r[i + j.PLACED_AX]!;
    const cx = r[i + j.OFFSET_X]! + (q[b + d.QX]! - q[a + d.QX]! + turnedX);
    const cy = r[i + j.OFFSET_Y]! + (q[b + d.QY]! - q[a + d.QY]! + turnedY);
    const square = cx * cx + cy * cy;
    most = square > most ? square : most;
  }
  data.joints.left[0] = Math.sqrt(most);
}

/** Ends a sub-step: makes momentum of a share of the corrections, and adds up what the joints gave. */
export function finishPoints(data: SolverData, from: number, to: number, step: number): number {
  const share = data.joints.share[0]!;
  const { points: r, pointBodies: bodies, velocity: v } = data;
  for (let k = from; k !== to; k += step) {
    if ((bodies[2 * k]! & d.MISSING) !== 0) {
      continue;
    }
    const i = ((k & d.EVEN) * j.POINT_STRIDE + (k & 1)) & d.OFFSET;
    const a = bodies[2 * k]! & d.OFFSET;
    const b = bodies[2 * k + 1]! & d.OFFSET;
    const carry = share * r[i + j.POINT_CARRY]!;
    const x = carry * r[i + j.PUSH_X]!;
    const y = carry * r[i + j.PUSH_Y]!;
    const ax = r[i + j.ARM_AX]!;
    const ay = r[i + j.ARM_AY]!;
    const bx = r[i + j.ARM_BX]!;
    const by = r[i + j.ARM_BY]!;
    const mA = v[a + d.INV_MASS]!;
    const mB = v[b + d.INV_MASS]!;
    v[a + d.VX] = v[a + d.VX]! - mA * x;
    v[a + d.VY] = v[a + d.VY]! - mA * y;
    v[a + d.W] = v[a + d.W]! - v[a + d.INV_INERTIA]! * (ax * y - ay * x);
    v[b + d.VX] = v[b + d.VX]! + mB * x;
    v[b + d.VY] = v[b + d.VY]! + mB * y;
    v[b + d.W] = v[b + d.W]! + v[b + d.INV_INERTIA]! * (bx * y - by * x);
    const jx = x + r[i + j.IMPULSE_X]!;
    const jy = y + r[i + j.IMPULSE_Y]!;
    r[i + j.SUM_X] = r[i + j.SUM_X]! + jx;
    r[i + j.SUM_Y] = r[i + j.SUM_Y]! + jy;
    r[i + j.SUM_WA] = r[i + j.SUM_WA]! - (ax * jy - ay * jx);
    r[i + j.SUM_WB] = r[i + j.SUM_WB]! + (bx * jy - by * jx);
  }
  return 0;
}
