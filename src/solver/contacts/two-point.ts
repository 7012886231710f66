import {
  CALM_ACCELERATION,
  CONTACT_SLOP,
  DEEP_OVERLAP,
  MAX_PUSH,
  MAX_PUSH_HOOKED,
  PUSH_SHARE_DEEP,
  PUSH_SHARE_HOOKED,
  PUSH_TOLERANCE,
  TOUCH_DEPTH,
} from '../../config.js';
import type { SolverData } from '../data.js';
import * as d from '../layout.js';
import { boundPush } from './pressed.js';

/**
 * Starts a sub-step: separations for the present placement, what the normal velocities are driven to, and the impulses of
 * the last sub-step applied once more.
 *
 *     s = s₀ + n·(ΔdB − ΔdA) + (cos θ − 1)·RT + sin θ·RN   of B less that of A
 */
export function warmStartTwo(data: SolverData, from: number, to: number, h: number): void {
  const { records: r, bodies } = data.two;
  const { velocity: v, motion: q } = data;
  const inverseH = 1 / h;
  for (let k = from; k < to; k += 1) {
    const i = ((k & d.EVEN) * d.TWO_STRIDE + (k & 1)) & d.OFFSET;
    const a = bodies[2 * k]! & d.OFFSET;
    const b = bodies[2 * k + 1]! & d.OFFSET;
    const nx = r[i + d.NX]!;
    const ny = r[i + d.NY]!;
    const rnA1 = r[i + d.RN_A1]!;
    const rnB1 = r[i + d.RN_B1]!;
    const rnA2 = r[i + d.RN_A2]!;
    const rnB2 = r[i + d.RN_B2]!;
    const rtA = r[i + d.RT_A]!;
    const rtB = r[i + d.RT_B]!;
    const sinA = v[a + d.SIN]!;
    const sinB = v[b + d.SIN]!;
    const moved =
      nx * (q[b + d.DX]! - q[a + d.DX]!) +
      ny * (q[b + d.DY]! - q[a + d.DY]!) +
      v[b + d.COS_LESS_ONE]! * rtB -
      v[a + d.COS_LESS_ONE]! * rtA;
    const s1 = r[i + d.START1]! + moved + sinB * rnB1 - sinA * rnA1;
    const s2 = r[i + d.START2]! + moved + sinB * rnB2 - sinA * rnA2;
    const surface = r[i + d.SURFACE_N]!;
    r[i + d.SEPARATION1] = s1;
    r[i + d.SEPARATION2] = s2;
    // The positive part by absolute values: the sign is a matter of chance, see `solveVelocityOne`.
    const gap1 = s1 + TOUCH_DEPTH;
    const gap2 = s2 + TOUCH_DEPTH;
    r[i + d.BIAS1] = 0.5 * (gap1 + Math.abs(gap1)) * inverseH + surface;
    r[i + d.BIAS2] = 0.5 * (gap2 + Math.abs(gap2)) * inverseH + surface;
    const p1 = r[i + d.NORMAL1]!;
    const p2 = r[i + d.NORMAL2]!;
    const t = r[i + d.TANGENT]!;
    if (p1 === 0 && p2 === 0 && t === 0) {
      continue;
    }
    r[i + d.NORMAL_SUM1] = r[i + d.NORMAL_SUM1]! + p1;
    r[i + d.NORMAL_SUM2] = r[i + d.NORMAL_SUM2]! + p2;
    r[i + d.TANGENT_SUM] = r[i + d.TANGENT_SUM]! + t;
    const p = p1 + p2;
    const jx = nx * p - ny * t;
    const jy = ny * p + nx * t;
    const mA = v[a + d.INV_MASS]!;
    const mB = v[b + d.INV_MASS]!;
    v[a + d.VX] = v[a + d.VX]! - mA * jx;
    v[a + d.VY] = v[a + d.VY]! - mA * jy;
    v[a + d.W] = v[a + d.W]! - v[a + d.INV_INERTIA]! * (rnA1 * p1 + rnA2 * p2 + rtA * t);
    v[b + d.VX] = v[b + d.VX]! + mB * jx;
    v[b + d.VY] = v[b + d.VY]! + mB * jy;
    v[b + d.W] = v[b + d.W]! + v[b + d.INV_INERTIA]! * (rnB1 * p1 + rnB2 * p2 + rtB * t);
  }
}

/**
 * One sweep over the contacts from one index to another. Friction, within ± μ · both normal impulses; then both normals as one linear
 * complementarity problem, by trying in turn "both push", "only the first", "only the second", "none" (Catto, "Modeling and Solving
 * Constraints", GDC 2009): K x + β ≥ 0, x ≥ 0, with β = vₙ + bias − K · p, where p is the impulse so far. When both push, x = p − K⁻¹(vₙ +
 * bias). Where one point hardly pushes, rounding may deny all four cases: then "both push" holds but for what is below 0. With the impulses
 * left as they are, a crate that had been pressed into a wall left it at 1,500 m/s, as none was needed any more. A contact without impulses
 * whose surfaces do not approach is skipped.
 *
 * @returns whether any velocity changed by more than CALM_ACCELERATION would change it in the sub-step, of length h.
 */
export function solveVelocityTwo(data: SolverData, from: number, to: number, h: number): boolean {
  const { records: r, bodies } = data.two;
  const v = data.velocity;
  const tolerance = CALM_ACCELERATION * h;
  let changed = false;
  for (let k = from; k < to; k += 1) {
    const i = ((k & d.EVEN) * d.TWO_STRIDE + (k & 1)) & d.OFFSET;
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
    let wA = v[a + d.W]!;
    let wB = v[b + d.W]!;
    const dvx = vbx - vax;
    const dvy = vby - vay;
    const vn = nx * dvx + ny * dvy;
    const p1 = r[i + d.NORMAL1]!;
    const p2 = r[i + d.NORMAL2]!;
    const before = r[i + d.TANGENT]!;
    const rnA1 = r[i + d.RN_A1]!;
    const rnB1 = r[i + d.RN_B1]!;
    const rnA2 = r[i + d.RN_A2]!;
    const rnB2 = r[i + d.RN_B2]!;
    if (
      p1 === 0 &&
      p2 === 0 &&
      before === 0 &&
      vn + rnB1 * wB - rnA1 * wA + r[i + d.BIAS1]! >= 0 &&
      vn + rnB2 * wB - rnA2 * wA + r[i + d.BIAS2]! >= 0
    ) {
      continue;
    }

    const rtA = r[i + d.RT_A]!;
    const rtB = r[i + d.RT_B]!;
    const limit = r[i + d.FRICTION]! * (p1 + p2);
    const slide = nx * dvy - ny * dvx + r[i + d.SURFACE_T]! + rtB * wB - rtA * wA;
    let after = before - slide * r[i + d.TANGENT_MASS]!;
    after = after > limit ? limit : after < -limit ? -limit : after;
    const t = after - before;
    r[i + d.TANGENT] = after;
    wA -= iA * rtA * t;
    wB += iB * rtB * t;

    const c1 = vn + rnB1 * wB - rnA1 * wA + r[i + d.BIAS1]!;
    const c2 = vn + rnB2 * wB - rnA2 * wA + r[i + d.BIAS2]!;
    const i12 = r[i + d.I12]!;
    const both1 = p1 - (r[i + d.I11]! * c1 + i12 * c2);
    const both2 = p2 - (i12 * c1 + r[i + d.I22]! * c2);
    let x1 = both1;
    let x2 = both2;
    if (!(x1 >= 0 && x2 >= 0)) {
      const k11 = r[i + d.K11]!;
      const k12 = r[i + d.K12]!;
      const k22 = r[i + d.K22]!;
      const b1 = c1 - k11 * p1 - k12 * p2;
      const b2 = c2 - k12 * p1 - k22 * p2;
      x1 = -b1 / k11;
      x2 = 0;
      if (!(x1 >= 0 && k12 * x1 + b2 >= 0)) {
        x1 = 0;
        x2 = -b2 / k22;
        if (!(x2 >= 0 && k12 * x2 + b1 >= 0)) {
          if (b1 >= 0 && b2 >= 0) {
            x2 = 0;
          } else {
            x1 = both1 > 0 ? both1 : 0;
            x2 = both2 > 0 ? both2 : 0;
          }
        }
      }
    }
    r[i + d.NORMAL1] = x1;
    r[i + d.NORMAL2] = x2;
    const d1 = x1 - p1;
    const d2 = x2 - p2;
    changed =
      changed ||
      Math.abs(d1) * r[i + d.K11]! > tolerance ||
      Math.abs(d2) * r[i + d.K22]! > tolerance ||
      Math.abs(t) > tolerance * r[i + d.TANGENT_MASS]!;
    const p = d1 + d2;
    const jx = nx * p - ny * t;
    const jy = ny * p + nx * t;
    v[a + d.VX] = vax - mA * jx;
    v[a + d.VY] = vay - mA * jy;
    v[a + d.W] = wA - iA * (rnA1 * d1 + rnA2 * d2);
    v[b + d.VX] = vbx + mB * jx;
    v[b + d.VY] = vby + mB * jy;
    v[b + d.W] = wB + iB * (rnB1 * d1 + rnB2 * d2);
  }
  return changed;
}

/**
 * One position sweep over the contacts from one index to another. Moves the bodies apart by a share of the overlap beyond the slop, at both
 * points together; if one of them would have to pull, at the deeper one alone. A point that is not too deep may come nearer by as much as
 * that. Were it held where it is, what is pressed together at one end would be levered up at the other, as the one correction turns it and
 * the other does not turn it back. Velocities are not touched.
 *
 * @returns whether anything was pushed; if not, further iterations would find the same.
 */
export function solvePositionTwo(data: SolverData, from: number, to: number): boolean {
  const { records: r, bodies } = data.two;
  const q = data.motion;
  let pushed = false;
  for (let k = from; k < to; k += 1) {
    const i = ((k & d.EVEN) * d.TWO_STRIDE + (k & 1)) & d.OFFSET;
    const a = bodies[2 * k]! & d.OFFSET;
    const b = bodies[2 * k + 1]! & d.OFFSET;
    const nx = r[i + d.NX]!;
    const ny = r[i + d.NY]!;
    const rnA1 = r[i + d.RN_A1]!;
    const rnB1 = r[i + d.RN_B1]!;
    const rnA2 = r[i + d.RN_A2]!;
    const rnB2 = r[i + d.RN_B2]!;
    const qax = q[a + d.QX]!;
    const qay = q[a + d.QY]!;
    const qaw = q[a + d.QW]!;
    const qbx = q[b + d.QX]!;
    const qby = q[b + d.QY]!;
    const qbw = q[b + d.QW]!;
    const moved = nx * (qbx - qax) + ny * (qby - qay) + CONTACT_SLOP;
    const c1 = r[i + d.SEPARATION1]! + moved + rnB1 * qbw - rnA1 * qaw;
    const c2 = r[i + d.SEPARATION2]! + moved + rnB2 * qbw - rnA2 * qaw;
    if (c1 > -PUSH_TOLERANCE && c2 > -PUSH_TOLERANCE) {
      continue;
    }
    pushed = true;
    const signed = r[i + d.SHARE]!;
    const share = Math.abs(signed);
    const least = share === PUSH_SHARE_HOOKED ? -MAX_PUSH_HOOKED : -MAX_PUSH;
    const shy = PUSH_SHARE_DEEP - share;
    const more = shy > 0 ? shy : 0;
    const deep1 = c1 + DEEP_OVERLAP;
    const deep2 = c2 + DEEP_OVERLAP;
    let s1 = share * c1 + more * (deep1 < 0 ? deep1 : 0);
    let s2 = share * c2 + more * (deep2 < 0 ? deep2 : 0);
    if (signed > 0 && (r[i + d.NORMAL1]! !== 0 || r[i + d.NORMAL2]! !== 0)) {
      s1 = boundPush(s1, c1, r[i + d.SEPARATION1]! + CONTACT_SLOP);
      s2 = boundPush(s2, c2, r[i + d.SEPARATION2]! + CONTACT_SLOP);
    }
    const e1 = s1 < least ? least : c1 < 0 ? s1 : c1;
    const e2 = s2 < least ? least : c2 < 0 ? s2 : c2;
    const i12 = r[i + d.I12]!;
    let x1 = -(r[i + d.I11]! * e1 + i12 * e2);
    let x2 = -(i12 * e1 + r[i + d.I22]! * e2);
    if (x1 < 0 || x2 < 0) {
      x1 = -e1 / r[i + d.K11]!;
      x2 = -e2 / r[i + d.K22]!;
      if (c1 < c2) {
        x2 = 0;
      } else {
        x1 = 0;
      }
    }
    const x = x1 + x2;
    const mA = q[a + d.INV_MASS]! * x;
    const mB = q[b + d.INV_MASS]! * x;
    q[a + d.QX] = qax - mA * nx;
    q[a + d.QY] = qay - mA * ny;
    q[a + d.QW] = qaw - q[a + d.INV_INERTIA]! * (rnA1 * x1 + rnA2 * x2);
    q[b + d.QX] = qbx + mB * nx;
    q[b + d.QY] = qby + mB * ny;
    q[b + d.QW] = qbw + q[b + d.INV_INERTIA]! * (rnB1 * x1 + rnB2 * x2);
  }
  return pushed;
}
