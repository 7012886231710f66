import { MIN_INVERSE_MASS } from '../config.js';

/**
 * Symmetric systems of equations K x = r, by K = L·D·Lᵀ in place: after `factor` the diagonal holds D⁻¹, and the lower triangle L. K may be
 * singular: an unknown whose pivot is (nearly) zero depends on those before it, or has no effect at all, and gets 0.
 */

/** A pivot below this share of its diagonal element is rounding noise. */
export const DEPENDENT = 1e-10;

/** Factors the n × n matrix at `k[at]`, of which only the lower triangle is read. */
export function factor(k: Float64Array, at: number, n: number): void {
  for (let i = 0; i < n; i += 1) {
    const row = at + i * n;
    const diagonal = k[row + i]!;
    let pivot = diagonal;
    for (let c = 0; c < i; c += 1) {
      const column = at + c * n;
      let u = k[row + c]!;
      for (let m = 0; m < c; m += 1) {
        u -= k[row + m]! * k[column + m]!;
      }
      k[row + c] = u;
    }
    for (let c = 0; c < i; c += 1) {
      const u = k[row + c]!;
      const l = u * k[at + c * n + c]!;
      k[row + c] = l;
      pivot -= l * u;
    }
    k[row + i] = pivot > MIN_INVERSE_MASS && pivot > DEPENDENT * diagonal && pivot < Infinity ? 1 / pivot : 0;
  }
}

/** r → D⁻¹·L⁻¹·r, in place. The last number is then that of the solution already. */
export function forward(k: Float64Array, at: number, n: number, x: Float64Array, from: number): void {
  for (let i = 1; i < n; i += 1) {
    let r = x[from + i]!;
    for (let c = 0; c < i; c += 1) {
      r -= k[at + i * n + c]! * x[from + c]!;
    }
    x[from + i] = r;
  }
  for (let i = 0; i < n; i += 1) {
    x[from + i] = x[from + i]! * k[at + i * n + i]!;
  }
}

/** The rest of the solution, in place: x → L⁻ᵀ·x. */
export function backward(k: Float64Array, at: number, n: number, x: Float64Array, from: number): void {
  for (let i = n - 2; i >= 0; i -= 1) {
    let r = x[from + i]!;
    for (let c = i + 1; c < n; c += 1) {
      r -= k[at + c * n + i]! * x[from + c]!;
    }
    x[from + i] = r;
  }
}
