import { findImpactDepth, impactDepth } from '../collide/gap.js';
import { BOUNCE_SWEEPS, BOUNCE_THRESHOLD, FORESIGHT_DEPTH, IMPACT_DEPTH } from '../config.js';
import type { BounceList, ContactBatch, SolverData } from './data.js';
import * as d from './data.js';
import { solveVelocityOne } from './one-point.js';
import { solveVelocityTwo } from './two-point.js';

/** A mark of a body that bounces; those that `markHard` gives are not needed any more. */
const BOUNCES = -1;

function normalVelocity(data: SolverData, batch: ContactBatch, k: number, shift: number): number {
  const r = batch.records;
  const v = data.velocity;
  const record = k * batch.stride;
  const a = batch.bodies[2 * k]!;
  const b = batch.bodies[2 * k + 1]!;
  const i = record + shift;
  return (
    r[record + d.NX]! * (v[b + d.VX]! - v[a + d.VX]!) +
    r[record + d.NY]! * (v[b + d.VY]! - v[a + d.VY]!) +
    r[i + d.RN_B1]! * v[b + d.W]! -
    r[i + d.RN_A1]! * v[a + d.W]!
  );
}

/** What `planBounce` knows of a point: numbers that go from function to function would be boxed. */
const plan = { elasticity: 0.5, comes: 0.5, gain: 0.5, separation: 0.5 };

/** Finds the separation of a point for the present placement; see `warmStartTwo` and `warmStartOne`. */
function findSeparation(data: SolverData, batch: ContactBatch, k: number, shift: number): void {
  const r = batch.records;
  const { velocity: v, motion: q } = data;
  const record = k * batch.stride;
  const a = batch.bodies[2 * k]!;
  const b = batch.bodies[2 * k + 1]!;
  const i = record + shift;
  const isOne = batch === data.one;
  plan.separation =
    r[i + d.START1]! +
    r[record + d.NX]! * (q[b + d.DX]! - q[a + d.DX]!) +
    r[record + d.NY]! * (q[b + d.DY]! - q[a + d.DY]!) +
    v[b + d.COS_LESS_ONE]! * r[record + (isOne ? d.PIVOT_B : d.RT_B)]! +
    v[b + d.SIN]! * r[i + d.RN_B1]! -
    v[a + d.COS_LESS_ONE]! * r[record + (isOne ? d.PIVOT_A : d.RT_A)]! -
    v[a + d.SIN]! * r[i + d.RN_A1]!;
}

/** What forces add in a sub-step to the velocity of one body against another along `(nx, ny)`; `a` and `b` are the offsets of their records. */
export function normalGain({ drive: f }: SolverData, a: number, b: number, nx: number, ny: number): number {
  return nx * (f[b + d.GAIN_X]! - f[a + d.GAIN_X]!) + ny * (f[b + d.GAIN_Y]! - f[a + d.GAIN_Y]!);
}

/**
 * The normal velocity that a bounce ends with, with the sign changed, as its bias, for one that comes with `comes` and is found at a separation ≤ 0: what
 * fell on below the surface gets the speed that it would have there if it had bounced on it. The velocity at which the integrator moves things is
 * ahead of the true one by half of `gain`, so (v − g·h/2)²/2 + g·y is what stays the same (and comes down to e² of it in the bounce).
 */
function planSpeed({ bias }: SolverData['bounces'], k: number, h: number): void {
  const { elasticity, comes, gain, separation } = plan;
  const lift = gain < 0 ? (2 * gain * separation) / h : 0;
  const speed = comes + 0.5 * gain;
  const onSurface = speed * speed - lift;
  bias[k] = -Math.sqrt(elasticity * elasticity * (onSurface > 0 ? onSurface : 0) + lift) - 0.5 * gain;
}

/**
 * Before gravity: how fast each point of a bouncing material has to leave. One that will bounce but has not met the other
 * surface yet is left out of the sub-step, so that it gets there at full speed.
 */
export function planBounces(data: SolverData, h: number): void {
  for (let k = 0; k < data.bounces.count; k += 1) {
    planBounce(data, k, h);
  }
}

function planBounce(data: SolverData, k: number, h: number): void {
  const list = data.bounces;
  const batch = list.batches[k]!;
  const index = list.index[k]!;
  const shift = list.shift[k]!;
  const elasticity = list.elasticity[k]!;
  const comes = normalVelocity(data, batch, index, shift);
  list.bias[k] = elasticity * comes > BOUNCE_THRESHOLD ? elasticity * comes : 0;
  if (elasticity * comes < -BOUNCE_THRESHOLD) {
    findSeparation(data, batch, index, shift);
    const { records: r, bodies, stride } = batch;
    const record = index * stride;
    plan.elasticity = elasticity;
    plan.comes = comes;
    plan.gain = normalGain(data, bodies[2 * index]!, bodies[2 * index + 1]!, r[record + d.NX]!, r[record + d.NY]!);
    if (plan.separation <= 0) {
      planSpeed(list, k, h);
    } else {
      list.bias[k] = d.OFF;
      const i = record + shift;
      r[i + d.NORMAL_SUM1] = r[i + d.NORMAL_SUM1]! + r[i + d.NORMAL1]!;
      r[record + d.TANGENT_SUM] = r[record + d.TANGENT_SUM]! + r[record + d.TANGENT]!;
      r[i + d.NORMAL1] = 0;
      // Of two points the other one asks for it again.
      r[record + d.TANGENT] = 0;
    }
  }
}

/** After warm start: puts the plan in place of what the separation asked for. */
export function applyBounces(data: SolverData): void {
  const list = data.bounces;
  for (let k = 0; k < list.count; k += 1) {
    const bias = list.bias[k]!;
    if (bias !== 0) {
      const { records: r, stride } = list.batches[k]!;
      const record = list.index[k]! * stride;
      const at = record + list.shift[k]! + d.BIAS1;
      r[at] = bias + (bias > 0 && bias < d.OFF ? r[at]! : r[record + d.SURFACE_N]!);
    }
  }
}

/**
 * After the sweeps: more of them over what bounces in this sub-step and over what touches that and could bounce, until nothing changes. Where such points share a body,
 * as of a ball that is hit while it lies at a wall, a few sweeps leave some of the bounce undone, and its energy would be lost. Friction gets no larger in
 * these: in a corner that of one wall presses onto the other one, and would grow with each sweep.
 */
export function finishBounces(data: SolverData, h: number): void {
  const { bounces: list, velocity: v } = data;
  const count = listBouncing(data);
  let changed = count > 0;
  for (let n = 0; n < count; n += 1) {
    const k = list.bouncing[n]!;
    const { records: r, stride } = list.batches[k]!;
    const at = list.index[k]! * stride + d.TANGENT_MASS;
    // The biases are not needed any more in this sub-step.
    list.bias[k] = r[at]!;
    r[at] = 0;
  }
  for (let i = 0; i < BOUNCE_SWEEPS && changed; i += 1) {
    changed = false;
    for (let n = 0; n < count; n += 1) {
      const k = list.bouncing[n]!;
      const solve = list.batches[k] === data.two ? solveVelocityTwo : solveVelocityOne;
      changed = solve(data, list.index[k]!, list.index[k]! + 1, h) || changed;
    }
  }
  for (let n = 0; n < count; n += 1) {
    const k = list.bouncing[n]!;
    const { records: r, stride } = list.batches[k]!;
    r[list.index[k]! * stride + d.TANGENT_MASS] = list.bias[k]!;
  }
  for (let k = 0; k < list.count && count > 0; k += 1) {
    v[bodyOf(list, k, 0) + d.MARK] = 0;
    v[bodyOf(list, k, 1) + d.MARK] = 0;
  }
}

/** Marks the bodies that bounce, and lists their contacts: by the first point of each. @returns how many there are. */
function listBouncing({ bounces: list, velocity: v }: SolverData): number {
  let found = false;
  for (let k = 0; k < list.count; k += 1) {
    if (list.bias[k]! < 0) {
      found = true;
      v[bodyOf(list, k, 0) + d.MARK] = BOUNCES;
      v[bodyOf(list, k, 1) + d.MARK] = BOUNCES;
    }
  }
  // What stands for all that cannot move.
  v[d.MARK] = 0;
  let count = 0;
  for (let k = 0; k < list.count && found; k += 1) {
    if (
      list.shift[k] === 0 &&
      (v[bodyOf(list, k, 0) + d.MARK] === BOUNCES || v[bodyOf(list, k, 1) + d.MARK] === BOUNCES)
    ) {
      list.bouncing[count] = k;
      count += 1;
    }
  }
  return count;
}

/** Offset of the record of body A, 0, or B, 1, of a point. */
function bodyOf({ batches, index }: BounceList, k: number, which: number): number {
  return batches[k]!.bodies[2 * index[k]! + which]!;
}

/**
 * Before position iterations: points of bouncing materials that are flying apart are not pushed, which would add height; unless they are so deep
 * that an impact would have come before.
 */
export function releaseBounces(data: SolverData): void {
  const list = data.bounces;
  for (let k = 0; k < list.count; k += 1) {
    const batch = list.batches[k]!;
    const index = list.index[k]!;
    const shift = list.shift[k]!;
    if (normalVelocity(data, batch, index, shift) > BOUNCE_THRESHOLD) {
      const { records: r } = batch;
      const at = index * batch.stride + shift + d.SEPARATION1;
      if (r[at]! < -FORESIGHT_DEPTH) {
        const { shapeA, shapeB } = batch.arbiters[index]!;
        findImpactDepth(shapeA, shapeB, IMPACT_DEPTH);
        r[at] = r[at]! + impactDepth[0]!;
      } else {
        r[at] = d.NEVER;
      }
    }
  }
}
