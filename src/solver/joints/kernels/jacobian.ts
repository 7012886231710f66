import { MIN_INVERSE_MASS } from '../../../config.js';
import { DEPENDENT, factor } from '../../../math/solve.js';
import type { SolverData } from '../../data.js';
import * as d from '../../layout.js';
import type { Joint } from '../joint-data.js';

// Products with the Jacobian J of a joint whose rows are written out.

/** The result of `findLength`; an array, so that it is not boxed. */
export const length = /* @__PURE__ */ new Float64Array(1);

/** Writes to `length` the length of the vector of `count` numbers of a record. */
export function findLength(r: Float64Array, from: number, count: number): void {
  let square = 0;
  for (let n = 0; n < count; n += 1) {
    square += r[from + n]! * r[from + n]!;
  }
  length[0] = Math.sqrt(square);
}

/** Writes K = J·M⁻¹·Jᵀ, factored. */
export function writeMatrix(data: SolverData, joint: Joint, jacobian: number): void {
  const { records: r, bodies } = data.joints;
  const v = data.velocity;
  const { at, layout, first } = joint;
  const { rows, members, matrix } = layout;
  const row = 3 * members;
  if (members === 2 && rows <= 3) {
    writePairMatrix(data, joint, jacobian);
    return;
  }
  for (let n = 0; n < rows; n += 1) {
    for (let m = 0; m <= n; m += 1) {
      let p = at + jacobian + n * row;
      let q = at + jacobian + m * row;
      let sum = 0;
      for (let k = first; k < first + members; k += 1, p += 3, q += 3) {
        const b = bodies[k]!;
        sum += v[b + d.INV_MASS]! * (r[p]! * r[q]! + r[p + 1]! * r[q + 1]!);
        sum += v[b + d.INV_INERTIA]! * r[p + 2]! * r[q + 2]!;
      }
      r[at + matrix + n * rows + m] = sum;
    }
  }
  factor(r, at + matrix, rows);
}

/** The same for two bodies and at most three rows, straight-line. */
function writePairMatrix(data: SolverData, { at, layout, first }: Joint, jacobian: number): void {
  const { records: r, bodies } = data.joints;
  const v = data.velocity;
  const { rows } = layout;
  const p = (at + jacobian) & d.OFFSET;
  const k = (at + layout.matrix) & d.OFFSET;
  const a = bodies[first]! & d.OFFSET;
  const b = bodies[first + 1]! & d.OFFSET;
  const mA = v[a + d.INV_MASS]!;
  const iA = v[a + d.INV_INERTIA]!;
  const mB = v[b + d.INV_MASS]!;
  const iB = v[b + d.INV_INERTIA]!;
  const ax = r[p]!;
  const ay = r[p + 1]!;
  const aw = r[p + 2]!;
  const bx = r[p + 3]!;
  const by = r[p + 4]!;
  const bw = r[p + 5]!;
  const k00 = mA * (ax * ax + ay * ay) + iA * aw * aw + mB * (bx * bx + by * by) + iB * bw * bw;
  const d0 = k00 > MIN_INVERSE_MASS && k00 < Infinity ? 1 / k00 : 0;
  r[k] = d0;
  if (rows === 1) return;
  const ax1 = r[p + 6]!;
  const ay1 = r[p + 7]!;
  const aw1 = r[p + 8]!;
  const bx1 = r[p + 9]!;
  const by1 = r[p + 10]!;
  const bw1 = r[p + 11]!;
  const k10 = mA * (ax1 * ax + ay1 * ay) + iA * aw1 * aw + mB * (bx1 * bx + by1 * by) + iB * bw1 * bw;
  const k11 = mA * (ax1 * ax1 + ay1 * ay1) + iA * aw1 * aw1 + mB * (bx1 * bx1 + by1 * by1) + iB * bw1 * bw1;
  const l10 = k10 * d0;
  const pivot1 = k11 - l10 * k10;
  const d1 = pivot1 > MIN_INVERSE_MASS && pivot1 > DEPENDENT * k11 && pivot1 < Infinity ? 1 / pivot1 : 0;
  r[k + rows] = l10;
  r[k + rows + 1] = d1;
  if (rows === 2) return;
  const ax2 = r[p + 12]!;
  const ay2 = r[p + 13]!;
  const aw2 = r[p + 14]!;
  const bx2 = r[p + 15]!;
  const by2 = r[p + 16]!;
  const bw2 = r[p + 17]!;
  const k20 = mA * (ax2 * ax + ay2 * ay) + iA * aw2 * aw + mB * (bx2 * bx + by2 * by) + iB * bw2 * bw;
  const k21 = mA * (ax2 * ax1 + ay2 * ay1) + iA * aw2 * aw1 + mB * (bx2 * bx1 + by2 * by1) + iB * bw2 * bw1;
  const k22 = mA * (ax2 * ax2 + ay2 * ay2) + iA * aw2 * aw2 + mB * (bx2 * bx2 + by2 * by2) + iB * bw2 * bw2;
  const u21 = k21 - k20 * l10;
  const l20 = k20 * d0;
  const l21 = u21 * d1;
  const pivot2 = k22 - l20 * k20 - l21 * u21;
  r[k + 6] = l20;
  r[k + 7] = l21;
  r[k + 8] = pivot2 > MIN_INVERSE_MASS && pivot2 > DEPENDENT * k22 && pivot2 < Infinity ? 1 / pivot2 : 0;
}

/**
 * Multiplies all rows of J by the velocities or, if `isPush`, by the motion of the sub-step, whose three numbers are laid out alike; the
 * products go to the numbers at `work`.
 */
export function multiplyRows(data: SolverData, joint: Joint, jacobian: number, isPush: boolean): void {
  const { records: r, bodies } = data.joints;
  const v = isPush ? data.motion : data.velocity;
  const { at, layout, first } = joint;
  const { rows, members, work } = layout;
  let p = at + jacobian;
  for (let n = 0; n < rows; n += 1) {
    let sum = 0;
    for (let k = first; k < first + members; k += 1, p += 3) {
      const b = bodies[k]!;
      sum += r[p]! * v[b + d.VX]! + r[p + 1]! * v[b + d.VY]! + r[p + 2]! * v[b + d.W]!;
    }
    r[at + work + n] = sum;
  }
}

/** Adds `scale` · M⁻¹·Jᵀ·λ, with λ at the offset `from`, to the velocities or, if `isPush`, to the motion of the sub-step. */
export function applyRows(
  data: SolverData,
  joint: Joint,
  jacobian: number,
  from: number,
  scale: number,
  isPush: boolean,
): void {
  const { records: r, bodies } = data.joints;
  const v = isPush ? data.motion : data.velocity;
  const { at, layout, first } = joint;
  const { rows, members } = layout;
  for (let k = 0; k < members; k += 1) {
    const b = bodies[first + k]!;
    const inverseMass = scale * v[b + d.INV_MASS]!;
    const inverseInertia = scale * v[b + d.INV_INERTIA]!;
    let x = v[b + d.VX]!;
    let y = v[b + d.VY]!;
    let w = v[b + d.W]!;
    let p = at + jacobian + 3 * k;
    for (let n = 0; n < rows; n += 1, p += 3 * members) {
      const lambda = r[at + from + n]!;
      x += inverseMass * lambda * r[p]!;
      y += inverseMass * lambda * r[p + 1]!;
      w += inverseInertia * lambda * r[p + 2]!;
    }
    v[b + d.VX] = x;
    v[b + d.VY] = y;
    v[b + d.W] = w;
  }
}

/** Sets `count` numbers of a record to 0: so few that `fill` would take longer. */
export function clear(r: Float64Array, from: number, count: number): void {
  for (let n = from; n < from + count; n += 1) {
    r[n] = 0;
  }
}
