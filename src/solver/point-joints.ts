import { JOINT_ROUNDING, JOINT_SNAP, JOINT_TOLERANCE, MIN_INVERSE_MASS } from '../config.js';
import type { PointConstraint } from '../constraint/point.js';
import { cos, sin } from '../math/trig.js';
import type { SolverData } from './data.js';
import * as d from './data.js';
import type { Joint } from './joint-data.js';
import * as j from './joint-data.js';

/**
 * Point joints: the error is C = Δ(x + r) between the bodies, and by velocities C' = vB + ωB × rB − vA − ωA × rA. Velocity iterations
 * bring C' to zero at the start of the sub-step; position iterations bring C to zero at its end, where their corrections, times the arms
 * of the start, become momentum. Together they are RATTLE (Andersen 1983), which neither gains nor loses energy.
 */

/** A matrix whose determinant is below this share of the product of its diagonal has rank 1. */
const SINGULAR = 1e-12;

/** Arms and gap of the anchors at the start of the step, and the impulse to start with. */
export function packPoint(data: SolverData, joint: Joint): void {
  const { records: r, bodies } = data.joints;
  const { at, first } = joint;
  const constraint = joint.constraint as PointConstraint;
  const { anchors, impulse } = constraint;
  const bodyA = constraint.bodyA;
  const bodyB = constraint.bodyB;
  const ax = bodyA.cos * anchors[0]! - bodyA.sin * anchors[1]!;
  const ay = bodyA.sin * anchors[0]! + bodyA.cos * anchors[1]!;
  const bx = bodyB.cos * anchors[2]! - bodyB.sin * anchors[3]!;
  const by = bodyB.sin * anchors[2]! + bodyB.cos * anchors[3]!;
  r[at + j.START_AX] = ax;
  r[at + j.START_AY] = ay;
  r[at + j.START_BX] = bx;
  r[at + j.START_BY] = by;
  r[at + j.GAP_X] = bodyB.x - bodyA.x + (bx - ax);
  r[at + j.GAP_Y] = bodyB.y - bodyA.y + (by - ay);
  r[at + j.IMPULSE_X] = impulse[0]! * data.impulseScale;
  r[at + j.IMPULSE_Y] = impulse[1]! * data.impulseScale;
  r.fill(0, at + j.SUM_X, at + j.SUM_WB + 1);
  bodies[first] = bodyA.slot * d.BODY_STRIDE;
  bodies[first + 1] = bodyB.slot * d.BODY_STRIDE;
}

/** Starts a sub-step: arms, error and K⁻¹ for the present placement, and the impulse of the last sub-step once more. */
export function warmStartPoints(data: SolverData, start: number, end: number): void {
  const { joints, records: r, bodies } = data.joints;
  const { velocity: v, motion: q } = data;
  for (let k = start; k < end; k += 1) {
    const { at: i, first } = joints[k]!;
    const a = bodies[first]!;
    const b = bodies[first + 1]!;
    const ca = v[a + d.COS_LESS_ONE]!;
    const sa = v[a + d.SIN]!;
    const cb = v[b + d.COS_LESS_ONE]!;
    const sb = v[b + d.SIN]!;
    const ax0 = r[i + j.START_AX]!;
    const ay0 = r[i + j.START_AY]!;
    const bx0 = r[i + j.START_BX]!;
    const by0 = r[i + j.START_BY]!;
    const dax = ca * ax0 - sa * ay0;
    const day = sa * ax0 + ca * ay0;
    const dbx = cb * bx0 - sb * by0;
    const dby = sb * bx0 + cb * by0;
    const ax = ax0 + dax;
    const ay = ay0 + day;
    const bx = bx0 + dbx;
    const by = by0 + dby;
    const cx = r[i + j.GAP_X]! + (q[b + d.DX]! - q[a + d.DX]!) + (dbx - dax);
    const cy = r[i + j.GAP_Y]! + (q[b + d.DY]! - q[a + d.DY]!) + (dby - day);
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
    writeInverse(r, i, m + iA * ay * ay + iB * by * by, -iA * ax * ay - iB * bx * by, m + iA * ax * ax + iB * bx * bx);
    if (r[i + j.SOFTNESS] !== 1) {
      soften(data, joints[k]!, cx, cy);
    } else {
      r[i + j.BIAS_X] = 0;
      r[i + j.BIAS_Y] = 0;
    }
    const px = r[i + j.IMPULSE_X]!;
    const py = r[i + j.IMPULSE_Y]!;
    v[a + d.VX] = v[a + d.VX]! - mA * px;
    v[a + d.VY] = v[a + d.VY]! - mA * py;
    v[a + d.W] = v[a + d.W]! - iA * (ax * py - ay * px);
    v[b + d.VX] = v[b + d.VX]! + mB * px;
    v[b + d.VY] = v[b + d.VY]! + mB * py;
    v[b + d.W] = v[b + d.W]! + iB * (bx * py - by * px);
  }
}

/** K⁻¹; of a K of rank 1 the larger diagonal element alone, of none nothing. */
function writeInverse(r: Float64Array, i: number, k11: number, k12: number, k22: number): void {
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

/** An elastic joint: a velocity towards the target, and a softer K⁻¹. */
function soften(data: SolverData, joint: Joint, cx: number, cy: number): void {
  const { records: r } = data.joints;
  const { at: i } = joint;
  const softness = r[i + j.SOFTNESS]!;
  const rate = r[i + j.RATE]!;
  const error = Math.sqrt(cx * cx + cy * cy);
  const most = r[i + j.MAX_BIAS]!;
  const scale = error * rate > most ? most / error : rate;
  r[i + j.BIAS_X] = cx * scale;
  r[i + j.BIAS_Y] = cy * scale;
  r[i + j.I11] = r[i + j.I11]! * softness;
  r[i + j.I12] = r[i + j.I12]! * softness;
  r[i + j.I22] = r[i + j.I22]! * softness;
  if (error > r[i + j.MAX_ERROR]!) {
    data.joints.break(joint);
  }
}

/** One sweep: Δλ = −K⁻¹(C' + bias) − feedback · λ. */
export function solveVelocityPoints(data: SolverData, start: number, end: number): void {
  const { records: r, bodies, joints } = data.joints;
  const v = data.velocity;
  let i = joints[start]!.at;
  let m = joints[start]!.first;
  for (let k = start; k < end; k += 1, i = (i + j.POINT_STRIDE) & d.OFFSET, m = (m + 2) & d.OFFSET) {
    const a = bodies[m]! & d.OFFSET;
    const b = bodies[m + 1]! & d.OFFSET;
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
    const cx = vbx - vax - wB * by + wA * ay + r[i + j.BIAS_X]!;
    const cy = vby - vay + wB * bx - wA * ax + r[i + j.BIAS_Y]!;
    const i12 = r[i + j.I12]!;
    const feedback = r[i + j.FEEDBACK]!;
    const px = r[i + j.IMPULSE_X]!;
    const py = r[i + j.IMPULSE_Y]!;
    let x = -(r[i + j.I11]! * cx + i12 * cy) - feedback * px;
    let y = -(i12 * cx + r[i + j.I22]! * cy) - feedback * py;
    if (r[i + j.CHECKED] !== 0) {
      if (breaks(r, i, px + x, py + y)) {
        data.joints.break(joints[k]!);
        continue;
      }
      const scale = shareWithin(r[i + j.LIMIT]!, px + x, py + y);
      x = scale * (px + x) - px;
      y = scale * (py + y) - py;
    }
    r[i + j.IMPULSE_X] = px + x;
    r[i + j.IMPULSE_Y] = py + y;
    const mA = v[a + d.INV_MASS]!;
    const mB = v[b + d.INV_MASS]!;
    v[a + d.VX] = vax - mA * x;
    v[a + d.VY] = vay - mA * y;
    v[a + d.W] = wA - v[a + d.INV_INERTIA]! * (ax * y - ay * x);
    v[b + d.VX] = vbx + mB * x;
    v[b + d.VY] = vby + mB * y;
    v[b + d.W] = wB + v[b + d.INV_INERTIA]! * (bx * y - by * x);
  }
}

/** Whether the impulse of the step would be too large with (x, y) in this sub-step. */
function breaks(r: Float64Array, i: number, x: number, y: number): boolean {
  const sx = r[i + j.SUM_X]! + x;
  const sy = r[i + j.SUM_Y]! + y;
  const most = r[i + j.BREAK]!;
  return sx * sx + sy * sy > most * most;
}

/** What (x, y) has to be multiplied by to be no longer than `limit`. */
function shareWithin(limit: number, x: number, y: number): number {
  const length = Math.sqrt(x * x + y * y);
  return length > limit ? limit / length : 1;
}

/**
 * Starts a position iteration: error, arms and K⁻¹ for the placement reached so far. What follows works with the linear part, so of
 * the error the rest is kept.
 *
 * @returns whether any error is worth a sweep.
 */
export function linearisePoints(data: SolverData, start: number, end: number, isFirst: boolean): boolean {
  const { joints, records: r, bodies } = data.joints;
  const { motion: q } = data;
  const tolerance = isFirst ? JOINT_ROUNDING : JOINT_TOLERANCE;
  let found = false;
  for (let k = start; k < end; k += 1) {
    const { at: i, first } = joints[k]!;
    if (r[i + j.PUSH] === 0) {
      continue;
    }
    const a = bodies[first]!;
    const b = bodies[first + 1]!;
    const ax0 = r[i + j.ARM_AX]!;
    const ay0 = r[i + j.ARM_AY]!;
    const bx0 = r[i + j.ARM_BX]!;
    const by0 = r[i + j.ARM_BY]!;
    const wA = q[a + d.QW]!;
    const wB = q[b + d.QW]!;
    const ca = cosLessOne(wA);
    const sa = sine(wA);
    const cb = cosLessOne(wB);
    const sb = sine(wB);
    const dax = ca * ax0 - sa * ay0;
    const day = sa * ax0 + ca * ay0;
    const dbx = cb * bx0 - sb * by0;
    const dby = sb * bx0 + cb * by0;
    let ax = ax0 + dax;
    let ay = ay0 + day;
    let bx = bx0 + dbx;
    let by = by0 + dby;
    const ex = r[i + j.ERROR_X]! + (dbx - dax);
    const ey = r[i + j.ERROR_Y]! + (dby - day);
    const cx = ex + (q[b + d.QX]! - q[a + d.QX]!);
    const cy = ey + (q[b + d.QY]! - q[a + d.QY]!);
    const square = cx * cx + cy * cy;
    const m = q[a + d.INV_MASS]! + q[b + d.INV_MASS]!;
    const most = r[i + j.MAX_ERROR]!;
    if (square > most * most) {
      data.joints.break(joints[k]!);
      continue;
    }
    if (square > JOINT_SNAP * JOINT_SNAP) {
      r[i + j.CARRY] = 0;
      if (m > MIN_INVERSE_MASS) {
        ax = 0;
        ay = 0;
        bx = 0;
        by = 0;
      }
    }
    found ||= square > tolerance * tolerance;
    r[i + j.TURNED_AX] = ax;
    r[i + j.TURNED_AY] = ay;
    r[i + j.TURNED_BX] = bx;
    r[i + j.TURNED_BY] = by;
    r[i + j.REST_X] = ex + wB * by - wA * ay;
    r[i + j.REST_Y] = ey - wB * bx + wA * ax;
    const iA = q[a + d.INV_INERTIA]!;
    const iB = q[b + d.INV_INERTIA]!;
    writeInverse(r, i, m + iA * ay * ay + iB * by * by, -iA * ax * ay - iB * bx * by, m + iA * ax * ax + iB * bx * bx);
  }
  return found;
}

/** cos t − 1 … */
function cosLessOne(t: number): number {
  const s = t * t;
  return s < d.SMALL_TURN * d.SMALL_TURN ? s * (-1 / 2 + s * (1 / 24 - s * (1 / 720))) : cos(t) - 1;
}

/** … and sin t, for the turn of a sub-step. */
function sine(t: number): number {
  const s = t * t;
  return s < d.SMALL_TURN * d.SMALL_TURN ? t * (1 - s * (1 / 6 - s * (1 / 120 - s * (1 / 5040)))) : sin(t);
}

/** One sweep of a position iteration: moves the bodies by −K⁻¹C, C as its linear part has it. */
export function pushPoints(data: SolverData, start: number, end: number): void {
  const { records: r, bodies, joints } = data.joints;
  const { motion: q } = data;
  let i = joints[start]!.at;
  let n = joints[start]!.first;
  for (let k = start; k < end; k += 1, i = (i + j.POINT_STRIDE) & d.OFFSET, n = (n + 2) & d.OFFSET) {
    if (r[i + j.PUSH] === 0) {
      continue;
    }
    const a = bodies[n]! & d.OFFSET;
    const b = bodies[n + 1]! & d.OFFSET;
    const ax = r[i + j.TURNED_AX]!;
    const ay = r[i + j.TURNED_AY]!;
    const bx = r[i + j.TURNED_BX]!;
    const by = r[i + j.TURNED_BY]!;
    const qax = q[a + d.QX]!;
    const qay = q[a + d.QY]!;
    const wA = q[a + d.QW]!;
    const qbx = q[b + d.QX]!;
    const qby = q[b + d.QY]!;
    const wB = q[b + d.QW]!;
    const cx = r[i + j.REST_X]! + qbx - qax - wB * by + wA * ay;
    const cy = r[i + j.REST_Y]! + qby - qay + wB * bx - wA * ax;
    const i12 = r[i + j.I12]!;
    const x = -(r[i + j.I11]! * cx + i12 * cy);
    const y = -(i12 * cx + r[i + j.I22]! * cy);
    r[i + j.PUSH_X] = r[i + j.PUSH_X]! + x;
    r[i + j.PUSH_Y] = r[i + j.PUSH_Y]! + y;
    const mA = q[a + d.INV_MASS]!;
    const mB = q[b + d.INV_MASS]!;
    q[a + d.QX] = qax - mA * x;
    q[a + d.QY] = qay - mA * y;
    q[a + d.QW] = wA - q[a + d.INV_INERTIA]! * (ax * y - ay * x);
    q[b + d.QX] = qbx + mB * x;
    q[b + d.QY] = qby + mB * y;
    q[b + d.QW] = wB + q[b + d.INV_INERTIA]! * (bx * y - by * x);
  }
}

/** Ends a sub-step: corrections become momentum, and what the joint gave is added up. */
export function finishPoints(data: SolverData, start: number, end: number): void {
  const { joints, records: r, bodies } = data.joints;
  const v = data.velocity;
  for (let k = start; k < end; k += 1) {
    const { at: i, first } = joints[k]!;
    const a = bodies[first]!;
    const b = bodies[first + 1]!;
    const carry = r[i + j.CARRY]!;
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
}

/** Writes the outcome of the step back to the constraint. */
export function storePoint(data: SolverData, joint: Joint): void {
  const { records: r } = data.joints;
  const { at: i, constraint } = joint;
  const { impulse, given } = constraint;
  impulse[0] = r[i + j.IMPULSE_X]!;
  impulse[1] = r[i + j.IMPULSE_Y]!;
  given[0] = -r[i + j.SUM_X]!;
  given[1] = -r[i + j.SUM_Y]!;
  given[2] = r[i + j.SUM_WA]!;
  given[3] = r[i + j.SUM_X]!;
  given[4] = r[i + j.SUM_Y]!;
  given[5] = r[i + j.SUM_WB]!;
}
