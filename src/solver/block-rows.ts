import { MIN_INVERSE_MASS } from '../config.js';
import { DEPENDENT, factor } from '../math/solve.js';
import type { SolverData } from './data.js';
import type { Joint } from './joint-data.js';
import * as d from './layout.js';

// The rows of the Jacobian J of a joint whose numbers are written out: products with it.

/** What `findLength` found: a result would be boxed. */
export const length = new Float64Array(1);

/** Of so many numbers of a record, to `length`. */
export function findLength(r: Float64Array, from: number, count: number): void {
  let square = 0;
  for (let n = 0; n < count; n += 1) {
    square += r[from + n]! * r[from + n]!;
  }
  length[0] = Math.sqrt(square);
}

/** K = J·M⁻¹·Jᵀ, factored. */
export function writeMatrix(data: SolverData, joint: Joint, jacobian: number): void {
  const { records: r, bodies } = data.joints;
  const v = data.velocity;
  const { at, layout, first } = joint;
  const { rows, members, matrix } = layout;
  const row = 3 * members;
  if (members === 2 && rows <= 3) {
    writePairMatrix(
      r,
      v,
      (at + jacobian) & d.OFFSET,
      (at + matrix) & d.OFFSET,
      rows,
      bodies[first]! & d.OFFSET,
      bodies[first + 1]! & d.OFFSET,
    );
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
  factor(r, at + matrix, rows, MIN_INVERSE_MASS);
}

function writePairMatrix(
  r: Float64Array,
  v: Float64Array,
  p: number,
  k: number,
  rows: number,
  a: number,
  b: number,
): void {
  const mA = v[a + d.INV_MASS]!;
  const iA = v[a + d.INV_INERTIA]!;
  const mB = v[b + d.INV_MASS]!;
  const iB = v[b + d.INV_INERTIA]!;
  const x = r[p]!;
  const y = r[p + 1]!;
  const w = r[p + 2]!;
  const X = r[p + 3]!;
  const Y = r[p + 4]!;
  const W = r[p + 5]!;
  const k00 = mA * (x * x + y * y) + iA * w * w + mB * (X * X + Y * Y) + iB * W * W;
  const d0 = k00 > MIN_INVERSE_MASS && k00 < Infinity ? 1 / k00 : 0;
  r[k] = d0;
  if (rows === 1) return;
  const x1 = r[p + 6]!;
  const y1 = r[p + 7]!;
  const w1 = r[p + 8]!;
  const X1 = r[p + 9]!;
  const Y1 = r[p + 10]!;
  const W1 = r[p + 11]!;
  const k10 = mA * (x1 * x + y1 * y) + iA * w1 * w + mB * (X1 * X + Y1 * Y) + iB * W1 * W;
  const k11 = mA * (x1 * x1 + y1 * y1) + iA * w1 * w1 + mB * (X1 * X1 + Y1 * Y1) + iB * W1 * W1;
  const l10 = k10 * d0;
  const p1 = k11 - l10 * k10;
  const d1 = p1 > MIN_INVERSE_MASS && p1 > DEPENDENT * k11 && p1 < Infinity ? 1 / p1 : 0;
  r[k + rows] = l10;
  r[k + rows + 1] = d1;
  if (rows === 2) return;
  const x2 = r[p + 12]!;
  const y2 = r[p + 13]!;
  const w2 = r[p + 14]!;
  const X2 = r[p + 15]!;
  const Y2 = r[p + 16]!;
  const W2 = r[p + 17]!;
  const k20 = mA * (x2 * x + y2 * y) + iA * w2 * w + mB * (X2 * X + Y2 * Y) + iB * W2 * W;
  const k21 = mA * (x2 * x1 + y2 * y1) + iA * w2 * w1 + mB * (X2 * X1 + Y2 * Y1) + iB * W2 * W1;
  const k22 = mA * (x2 * x2 + y2 * y2) + iA * w2 * w2 + mB * (X2 * X2 + Y2 * Y2) + iB * W2 * W2;
  const u21 = k21 - k20 * l10;
  const l20 = k20 * d0;
  const l21 = u21 * d1;
  const p2 = k22 - l20 * k20 - l21 * u21;
  r[k + 6] = l20;
  r[k + 7] = l21;
  r[k + 8] = p2 > MIN_INVERSE_MASS && p2 > DEPENDENT * k22 && p2 < Infinity ? 1 / p2 : 0;
}

/** All rows of J, times velocities or times the motion of the sub-step, to the numbers at `work`. */
export function multiplyRows(data: SolverData, joint: Joint, jacobian: number, motion: boolean): void {
  const { records: r, bodies } = data.joints;
  const v = motion ? data.motion : data.velocity;
  const { at, layout, first } = joint;
  const { rows, members, work } = layout;
  let p = at + jacobian;
  for (let n = 0; n < rows; n += 1) {
    let sum = 0;
    for (let k = first; k < first + members; k += 1, p += 3) {
      const b = bodies[k]!;
      sum += r[p]! * v[b]! + r[p + 1]! * v[b + 1]! + r[p + 2]! * v[b + 2]!;
    }
    r[at + work + n] = sum;
  }
}

/** Adds `scale` · M⁻¹·Jᵀ·λ, λ at the offset `from`, to velocities or to the motion of the sub-step. */
export function applyRows(
  data: SolverData,
  joint: Joint,
  jacobian: number,
  from: number,
  scale: number,
  motion: boolean,
): void {
  const { records: r, bodies } = data.joints;
  const v = motion ? data.motion : data.velocity;
  const { at, layout, first } = joint;
  const { rows, members } = layout;
  for (let k = 0; k < members; k += 1) {
    const b = bodies[first + k]!;
    const inverseMass = scale * v[b + d.INV_MASS]!;
    const inverseInertia = scale * v[b + d.INV_INERTIA]!;
    let x = v[b]!;
    let y = v[b + 1]!;
    let w = v[b + 2]!;
    let p = at + jacobian + 3 * k;
    for (let n = 0; n < rows; n += 1, p += 3 * members) {
      const lambda = r[at + from + n]!;
      x += inverseMass * lambda * r[p]!;
      y += inverseMass * lambda * r[p + 1]!;
      w += inverseInertia * lambda * r[p + 2]!;
    }
    v[b] = x;
    v[b + 1] = y;
    v[b + 2] = w;
  }
}

/** Sets so many numbers of a record to 0: so few that `fill` would take longer. */
export function clear(r: Float64Array, from: number, count: number): void {
  for (let n = from; n < from + count; n += 1) {
    r[n] = 0;
  }
}
