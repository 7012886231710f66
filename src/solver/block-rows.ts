import { MIN_INVERSE_MASS } from '../config.js';
import { factor } from '../math/solve.js';
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
