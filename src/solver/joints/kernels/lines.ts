import type { SolverData } from '../../data.js';
import * as d from '../../layout.js';
import * as j from '../joint-layout.js';
import { clampToBounds } from './blocks.js';
import { cutOrBreak } from './breaking.js';

/** The sweeps of block joints for lines, two rows between two bodies, straight-line. All else is done in `blocks.ts`. */

/**
 * One sweep, from the first to the last, or back: over velocities, as `solveVelocityBlock`, or, if `isPush`, over the motion of the
 * sub-step, as `pushBlock`.
 */
export function sweepLines(data: SolverData, start: number, end: number, isBack: boolean, isPush: boolean): void {
  const { records: r, bodies, joints } = data.joints;
  const v = isPush ? data.motion : data.velocity;
  const { impulse, push, bias, error, jacobian, turned, matrix, low, high, farBias, farError, work } =
    joints[start]!.layout;
  for (let m = start; m < end; m += 1) {
    const joint = joints[isBack ? start + end - 1 - m : m]!;
    const i = joint.at & d.OFFSET;
    if (isPush && r[i + j.PUSH] === 0) {
      continue;
    }
    const n = joint.first & d.OFFSET;
    const a = bodies[n]! & d.OFFSET;
    const b = bodies[n + 1]! & d.OFFSET;
    const p = (i + (isPush ? turned : jacobian)) & d.OFFSET;
    const o = (i + (isPush ? push : impulse)) & d.OFFSET;
    const e = (i + (isPush ? error : bias)) & d.OFFSET;
    const softness = isPush ? -1 : -r[i + j.SOFTNESS]!;
    const kept = isPush ? 1 : 1 - r[i + j.FEEDBACK]!;
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
    const c = softness * (ax * vax + ay * vay + aw * wA + (bx * vbx + by * vby + bw * wB) + r[e]!);
    const c1 = softness * (ax1 * vax + ay1 * vay + aw1 * wA + (bx1 * vbx + by1 * vby + bw1 * wB) + r[e + 1]!);
    const l = r[i + matrix + 2]!;
    const old = r[o]!;
    const old1 = r[o + 1]!;
    const begun = kept * old1;
    const least = r[i + low]!;
    const most = r[i + high]!;
    const wanted = begun + (c1 - l * c) * r[i + matrix + 3]!;
    const way = r[i + matrix + 3]! * r[i + (isPush ? farError : farBias)]!;
    let lambda1 = clampToBounds(wanted, least, most, way) - begun;
    let lambda = c * r[i + matrix]! - l * lambda1;
    let next = kept * old + lambda;
    let next1 = begun + lambda1;
    if (!isPush) {
      if (r[i + j.CHECKED] !== 0) {
        r[i + work] = next;
        r[i + work + 1] = next1;
        if (cutOrBreak(data, joint)) {
          continue;
        }
        next = r[i + work]!;
        next1 = r[i + work + 1]!;
      }
      lambda = next - old;
      lambda1 = next1 - old1;
    }
    r[o] = next;
    r[o + 1] = next1;
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
