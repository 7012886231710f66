import type { Constraint } from './constraint.js';

/** Offsets of what `writeSoftness` writes, the same as in `joint-layout.ts`, which must not be imported here. */
const SOFTNESS = 0;
const FEEDBACK = 1;
const RATE = 2;

/**
 * A damped spring with a frequency and a damping ratio, as a soft constraint that is stable for any time step h (Catto, "Soft Constraints",
 * GDC 2011). With w = 2π · frequency and damping ratio ζ, in the velocity row
 *
 *     Δλ = s · K⁻¹ · (−C · rate − J·v) − γ · s · λ
 *     γ = 1 / (h · w · (2ζ + w·h)),   s = 1 / (1 + γ),   rate = w / (2ζ + w·h)
 *
 * The scheme itself damps by about w·h / 2. Where a step has several sub-steps, that is subtracted from ζ, down to 0, so that the damping
 * in all is what was asked for (at 5 Hz, ζ = 0.1 and h = 1/960 s it would be a sixth too strong); it stays stable, as it does with ζ = 0. A
 * step in one sub-step uses the plain formula.
 *
 * Writes s, γ · s and rate; for a rigid constraint 1, 0, 0.
 */
export function writeSoftness(
  constraint: Constraint,
  h: number,
  substeps: number,
  out: Float64Array,
  at: number,
): void {
  if (!constraint.isElastic) {
    out[at + SOFTNESS] = 1;
    out[at + FEEDBACK] = 0;
    out[at + RATE] = 0;
    return;
  }
  const w = 2 * Math.PI * constraint.frequency;
  const damping = substeps > 1 ? Math.max(0, constraint.damping - (w * h) / 2) : constraint.damping;
  const stiffness = 2 * damping + w * h;
  const gamma = 1 / (h * w * stiffness);
  const softness = 1 / (1 + gamma);
  out[at + SOFTNESS] = softness;
  out[at + FEEDBACK] = gamma * softness;
  out[at + RATE] = w / stiffness;
}
