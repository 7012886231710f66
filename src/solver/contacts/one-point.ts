import {
  CALM_ACCELERATION,
  CONTACT_SLOP,
  DEEP_OVERLAP,
  DEEP_OVERLAP_CIRCLES,
  MAX_PUSH,
  MAX_PUSH_HOOKED,
  PUSH_SHARE_CIRCLES,
  PUSH_SHARE_CROWD,
  PUSH_SHARE_DEEP,
  PUSH_SHARE_DEEP_CIRCLES,
  PUSH_SHARE_HOOKED,
  PUSH_SHARE_STATIC,
  PUSH_TOLERANCE,
  TOUCH_DEPTH,
} from '../../config.js';
import type { SolverData } from '../data.js';
import * as d from '../layout.js';
import { boundPush } from './pressed.js';

/** Starts a sub-step, as `warmStartTwo`, for contacts of one point. Circles have a rolling impulse as well. */
export function warmStartOne(data: SolverData, from: number, to: number, h: number): void {
  const { records: r, bodies } = data.one;
  const { velocity: v, motion: q } = data;
  const inverseH = 1 / h;
  for (let k = from; k < to; k += 1) {
    const i = ((k & d.EVEN) * d.ONE_STRIDE + (k & 1)) & d.OFFSET;
    const a = bodies[2 * k]! & d.OFFSET;
    const b = bodies[2 * k + 1]! & d.OFFSET;
    const nx = r[i + d.NX]!;
    const ny = r[i + d.NY]!;
    const rnA = r[i + d.RN_A1]!;
    const rnB = r[i + d.RN_B1]!;
    const rtA = r[i + d.RT_A]!;
    const rtB = r[i + d.RT_B]!;
    const s =
      r[i + d.START1]! +
      nx * (q[b + d.DX]! - q[a + d.DX]!) +
      ny * (q[b + d.DY]! - q[a + d.DY]!) +
      v[b + d.COS_LESS_ONE]! * r[i + d.PIVOT_B]! +
      v[b + d.SIN]! * rnB -
      v[a + d.COS_LESS_ONE]! * r[i + d.PIVOT_A]! -
      v[a + d.SIN]! * rnA;
    const surface = r[i + d.SURFACE_N]!;
    r[i + d.SEPARATION1] = s;
    const gap = s + TOUCH_DEPTH;
    r[i + d.BIAS1] = 0.5 * (gap + Math.abs(gap)) * inverseH + surface;
    const p = r[i + d.NORMAL1]!;
    const t = r[i + d.TANGENT]!;
    const roll = r[i + d.ROLL]!;
    if (p === 0 && t === 0 && roll === 0) {
      continue;
    }
    r[i + d.NORMAL_SUM1] = r[i + d.NORMAL_SUM1]! + p;
    r[i + d.TANGENT_SUM] = r[i + d.TANGENT_SUM]! + t;
    r[i + d.ROLL_SUM] = r[i + d.ROLL_SUM]! + roll;
    const jx = nx * p - ny * t;
    const jy = ny * p + nx * t;
    const mA = v[a + d.INV_MASS]!;
    const mB = v[b + d.INV_MASS]!;
    v[a + d.VX] = v[a + d.VX]! - mA * jx;
    v[a + d.VY] = v[a + d.VY]! - mA * jy;
    v[a + d.W] = v[a + d.W]! - v[a + d.INV_INERTIA]! * (rnA * p + rtA * t + roll);
    v[b + d.VX] = v[b + d.VX]! + mB * jx;
    v[b + d.VY] = v[b + d.VY]! + mB * jy;
    v[b + d.W] = v[b + d.W]! + v[b + d.INV_INERTIA]! * (rnB * p + rtB * t + roll);
  }
}

/**
 * One sweep over the contacts from one index to another: friction, rolling (drives ωB − ωA to 0 within ± rolling friction · normal
 * impulse), normal. A contact without impulses whose surfaces do not approach is skipped.
 *
 * Each of the three acts on velocities that those before have changed. By how much is known in advance (`NORMAL_OF_TANGENT` and its like),
 * so that none has to wait for new velocities: that saves a sixth of the time. For two points it would gain nothing, as their sweeps do not
 * wait but have more to do.
 *
 * Where chance decides which bound holds, as for circles that roll or slide, it is found by absolute values, x⁺ = (x + |x|) / 2: branches
 * that the processor predicts wrongly cost a tenth of a step.
 *
 * @returns as `solveVelocityTwo`.
 */
export function solveVelocityOne(data: SolverData, from: number, to: number, h: number): boolean {
  const { records: r, bodies } = data.one;
  const v = data.velocity;
  const tolerance = CALM_ACCELERATION * h;
  let changed = false;
  for (let k = from; k < to; k += 1) {
    const i = ((k & d.EVEN) * d.ONE_STRIDE + (k & 1)) & d.OFFSET;
    const a = bodies[2 * k]! & d.OFFSET;
    const b = bodies[2 * k + 1]! & d.OFFSET;
    const nx = r[i + d.NX]!;
    const ny = r[i + d.NY]!;
    const mA = v[a + d.INV_MASS]!;
    const mB = v[b + d.INV_MASS]!;
    const iA = v[a + d.INV_INERTIA]!;
    const iB = v[b + d.INV_INERTIA]!;
    const vax = v[a + d.VX]!;
    const vay = v[a + d.VY]!;
    const vbx = v[b + d.VX]!;
    const vby = v[b + d.VY]!;
    const wA = v[a + d.W]!;
    const wB = v[b + d.W]!;
    const dvx = vbx - vax;
    const dvy = vby - vay;
    const p = r[i + d.NORMAL1]!;
    const t = r[i + d.TANGENT]!;
    const roll = r[i + d.ROLL]!;
    const rnA = r[i + d.RN_A1]!;
    const rnB = r[i + d.RN_B1]!;
    const vn = nx * dvx + ny * dvy + (rnB * wB - rnA * wA + r[i + d.BIAS1]!);
    if (p === 0 && t === 0 && roll === 0 && vn >= 0) {
      continue;
    }

    const rtA = r[i + d.RT_A]!;
    const rtB = r[i + d.RT_B]!;
    const limit = r[i + d.FRICTION]! * p;
    const slide = nx * dvy - ny * dvx + (rtB * wB - rtA * wA + r[i + d.SURFACE_T]!);
    let nextT = t - slide * r[i + d.TANGENT_MASS]!;
    if (Math.abs(nextT) > limit) {
      nextT = 0.5 * (Math.abs(nextT + limit) - Math.abs(nextT - limit));
    }
    const dt = nextT - t;
    r[i + d.TANGENT] = nextT;

    const rollLimit = r[i + d.ROLL_FRICTION]! * p;
    let nextRoll = roll - (wB - wA) * r[i + d.ROLL_MASS]! - r[i + d.ROLL_OF_TANGENT]! * dt;
    if (Math.abs(nextRoll) > rollLimit) {
      nextRoll = 0.5 * (Math.abs(nextRoll + rollLimit) - Math.abs(nextRoll - rollLimit));
    }
    const dr = nextRoll - roll;
    r[i + d.ROLL] = nextRoll;

    const wanted = p - vn * r[i + d.NORMAL_MASS]! - r[i + d.NORMAL_OF_TANGENT]! * dt - r[i + d.NORMAL_OF_ROLL]! * dr;
    const nextP = 0.5 * (wanted + Math.abs(wanted));
    const dp = nextP - p;
    r[i + d.NORMAL1] = nextP;
    changed =
      changed ||
      Math.abs(dp) > tolerance * r[i + d.NORMAL_MASS]! ||
      Math.abs(dt) > tolerance * r[i + d.TANGENT_MASS]! ||
      Math.abs(dr) > tolerance * r[i + d.ROLL_MASS]!;
    const jx = nx * dp - ny * dt;
    const jy = ny * dp + nx * dt;
    v[a + d.VX] = vax - mA * jx;
    v[a + d.VY] = vay - mA * jy;
    v[a + d.W] = wA - iA * (rtA * dt + dr + rnA * dp);
    v[b + d.VX] = vbx + mB * jx;
    v[b + d.VY] = vby + mB * jy;
    v[b + d.W] = wB + iB * (rtB * dt + dr + rnB * dp);
  }
  return changed;
}

/** One position sweep, as `solvePositionTwo`, for contacts of one point. */
export function solvePositionOne(data: SolverData, from: number, to: number): boolean {
  const { records: r, bodies } = data.one;
  const q = data.motion;
  let pushed = false;
  for (let k = from; k < to; k += 1) {
    const i = ((k & d.EVEN) * d.ONE_STRIDE + (k & 1)) & d.OFFSET;
    const a = bodies[2 * k]! & d.OFFSET;
    const b = bodies[2 * k + 1]! & d.OFFSET;
    const nx = r[i + d.NX]!;
    const ny = r[i + d.NY]!;
    const rnA = r[i + d.RN_A1]!;
    const rnB = r[i + d.RN_B1]!;
    const c =
      r[i + d.SEPARATION1]! +
      nx * (q[b + d.QX]! - q[a + d.QX]!) +
      ny * (q[b + d.QY]! - q[a + d.QY]!) +
      rnB * q[b + d.QW]! -
      rnA * q[a + d.QW]! +
      CONTACT_SLOP;
    if (c > -PUSH_TOLERANCE) {
      continue;
    }
    pushed = true;
    const signed = r[i + d.SHARE]!;
    const share = Math.abs(signed);
    const isRound = share === PUSH_SHARE_CIRCLES;
    const deep = c + (isRound ? DEEP_OVERLAP_CIRCLES : DEEP_OVERLAP);
    let e = share * c;
    if (deep < 0 && share !== PUSH_SHARE_STATIC) {
      const isPressed = r[i + d.NORMAL1]! !== 0;
      if (isRound && c < -DEEP_OVERLAP) {
        data.deepCircles |= isPressed ? d.PRESSED : d.CROWDED;
      }
      const ofDeep = isRound ? (isPressed ? PUSH_SHARE_DEEP_CIRCLES : PUSH_SHARE_CROWD) : PUSH_SHARE_DEEP;
      e += (ofDeep - share) * deep;
      if (isPressed && signed > 0) {
        e = boundPush(e, c, r[i + d.SEPARATION1]! + CONTACT_SLOP);
      }
    }
    const most = share === PUSH_SHARE_HOOKED ? MAX_PUSH_HOOKED : MAX_PUSH;
    const x = (e < -most ? most : -e) * r[i + d.NORMAL_MASS]!;
    const mA = q[a + d.INV_MASS]! * x;
    const mB = q[b + d.INV_MASS]! * x;
    q[a + d.QX] = q[a + d.QX]! - mA * nx;
    q[a + d.QY] = q[a + d.QY]! - mA * ny;
    q[a + d.QW] = q[a + d.QW]! - q[a + d.INV_INERTIA]! * rnA * x;
    q[b + d.QX] = q[b + d.QX]! + mB * nx;
    q[b + d.QY] = q[b + d.QY]! + mB * ny;
    q[b + d.QW] = q[b + d.QW]! + q[b + d.INV_INERTIA]! * rnB * x;
  }
  return pushed;
}
