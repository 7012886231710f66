import {
  BOUNCE_LOAD,
  BOUNCE_ROUNDS,
  BOUNCE_RUBS,
  BOUNCE_SWEEPS,
  BOUNCE_THRESHOLD,
  FORESIGHT_DEPTH,
  TOUCH_DEPTH,
} from '../../config.js';
import { type BounceList, IMPULSES, type SolverData } from '../data.js';
import { findImpactDepth, impactDepth } from '../impact-depth.js';
import * as d from '../layout.js';
import { solveVelocityTwo } from '../loops.js';
import { isTied } from '../ties.js';
import { Ledger } from './no-gain.js';
import { solveVelocityOne } from './one-point.js';

/** A `state`: the point bounced in this sub-step, … */
const BOUNCED = 1;
/** … or it will bounce in the sweeps over all contacts, as it bears a load, with which these have to start. */
const LOADED = 2;

/** What was found of a point. An object, as numbers passed from function to function would be boxed. */
const plan = { elasticity: 0.5, comes: 0.5, gain: 0.5, separation: 0.5 };

/** Finds the normal velocity of a point: negative where its surfaces approach. */
function findSpeed({ bounces: { bodies, arms }, velocity: v }: SolverData, k: number): void {
  const a = bodies[2 * k]! & d.OFFSET;
  const b = bodies[2 * k + 1]! & d.OFFSET;
  const at = d.BOUNCE_STRIDE * k;
  plan.comes =
    arms[at + d.BOUNCE_NX]! * (v[b + d.VX]! - v[a + d.VX]!) +
    arms[at + d.BOUNCE_NY]! * (v[b + d.VY]! - v[a + d.VY]!) +
    arms[at + d.BOUNCE_RN_B]! * v[b + d.W]! -
    arms[at + d.BOUNCE_RN_A]! * v[a + d.W]!;
}

/** Finds the separation of a point for the present placement, as `warmStartTwo` and `warmStartOne`. */
function findSeparation({ bounces: list, velocity: v, motion: q }: SolverData, k: number): void {
  const { records: r, stride } = list.batches[k]!;
  const record = list.record[k]!;
  const i = record + list.shift[k]!;
  const a = list.bodies[2 * k]!;
  const b = list.bodies[2 * k + 1]!;
  const isOne = stride === d.ONE_STRIDE;
  plan.separation =
    r[i + d.START1]! +
    r[record + d.NX]! * (q[b + d.DX]! - q[a + d.DX]!) +
    r[record + d.NY]! * (q[b + d.DY]! - q[a + d.DY]!) +
    v[b + d.COS_LESS_ONE]! * r[record + (isOne ? d.PIVOT_B : d.RT_B)]! +
    v[b + d.SIN]! * r[i + d.RN_B1]! -
    v[a + d.COS_LESS_ONE]! * r[record + (isOne ? d.PIVOT_A : d.RT_A)]! -
    v[a + d.SIN]! * r[i + d.RN_A1]!;
}

/** What forces add in a sub-step to the velocity of body B relative to A along `(nx, ny)`; `a` and `b` are the offsets of their records. */
export function normalGain({ drive: f }: SolverData, a: number, b: number, nx: number, ny: number): number {
  return nx * (f[b + d.GAIN_X]! - f[a + d.GAIN_X]!) + ny * (f[b + d.GAIN_Y]! - f[a + d.GAIN_Y]!);
}

/** The same for a point of the list, along its normal. */
function gainOf(data: SolverData, k: number): number {
  const { bounces: list } = data;
  const { records: r } = list.batches[k]!;
  const record = list.record[k]!;
  return normalGain(data, list.bodies[2 * k]!, list.bodies[2 * k + 1]!, r[record + d.NX]!, r[record + d.NY]!);
}

/**
 * Writes the bias of a point that bounces: the normal velocity that the bounce ends with, with the sign changed. Its surfaces approach with
 * `comes`, at a separation ≤ 0. What fell on below the surface gets the speed that it would have there if it had bounced on the surface.
 * The velocity at which the integrator moves things is ahead of the true one by half of `gain`, which is about to be added. So what is
 * conserved is (v − g·h/2)²/2 + g·y, of which a bounce at the surface leaves e².
 */
function planSpeed({ bias }: BounceList, k: number, h: number): void {
  const { elasticity, comes, gain, separation } = plan;
  const lift = gain < 0 ? (2 * gain * separation) / h : 0;
  const speed = comes + 0.5 * gain;
  const onSurface = speed * speed - lift;
  bias[k] = -Math.sqrt(elasticity * elasticity * (onSurface > 0 ? onSurface : 0) + lift) + 0.5 * gain;
}

/**
 * Before gravity: plans how fast each point of a bouncing material has to leave. Blows are passed on from body to body in rounds: what
 * arrives at once bounces at once, and what that sends on bounces in the next round. So the last of a row of balls that touch flies off,
 * and the others stay. A point that will bounce but has not met the other surface yet is left out of the sub-step, so that it gets there at
 * full speed.
 */
export function planBounces(data: SolverData, h: number): void {
  const { bounces: list } = data;
  list.state.fill(0);
  if (data.turning.count > 0) followNormals(list);
  let count = planRound(data, h, 0);
  for (let round = 1; round <= BOUNCE_ROUNDS && count > 0; round += 1) {
    solveRound(data, h, count, round);
    count = planRound(data, h, round);
  }
  for (let k = 0; k < list.count; k += 1) {
    if (list.state[k] === BOUNCED && hangs(list, k)) {
      keepLeaving(data, k);
    } else if (list.bias[k]! > 0) {
      dropImpulses(list, k);
    }
  }
}

/** Takes over the normals of contacts that turned with their bodies. */
function followNormals({ arms, batches, record, count }: BounceList): void {
  for (let k = 0; k < count; k += 1) {
    const { records: r } = batches[k]!;
    arms[d.BOUNCE_STRIDE * k + d.BOUNCE_NX] = r[record[k]! + d.NX]!;
    arms[d.BOUNCE_STRIDE * k + d.BOUNCE_NY] = r[record[k]! + d.NY]!;
  }
}

/**
 * Plans what bounces in a round: in the first one among all points, then among those of the bodies that bounced in the last one, which are
 * marked. The marks of `markHard` are not needed any more. @returns how many contacts bounce.
 */
function planRound(data: SolverData, h: number, round: number): number {
  const { bounces: list, velocity: v } = data;
  const { bodies, bouncing, bias, state, elasticity, shift } = list;
  let count = 0;
  for (let k = 0; k < list.count; k += 1) {
    if (round > 0 && v[bodies[2 * k]! + d.MARK] !== -round && v[bodies[2 * k + 1]! + d.MARK] !== -round) {
      continue;
    }
    // What makes energy makes it once in a sub-step.
    const restitution = round === 0 ? elasticity[k]! : Math.min(elasticity[k]!, 1);
    findSpeed(data, k);
    const leaves = restitution * plan.comes;
    bias[k] = leaves > BOUNCE_THRESHOLD ? leaves : 0;
    state[k] = state[k]! & BOUNCED;
    if (leaves < -BOUNCE_THRESHOLD) {
      plan.elasticity = restitution;
      planBounce(data, k, h, round);
      const first = shift[k] === 0 ? k : k - 1;
      if (bouncesNow(list, k) && (count === 0 || bouncing[count - 1] !== first)) {
        bouncing[count] = first;
        count += 1;
      }
    }
  }
  for (let n = 0; n < count; n += 1) {
    const k = bouncing[n]!;
    setBiases(data, k);
    v[bodies[2 * k]! + d.MARK] = -1 - round;
    v[bodies[2 * k + 1]! + d.MARK] = -1 - round;
  }
  // This body stands for everything that cannot move.
  v[d.MARK] = 0;
  return count;
}

/** Sets the biases of a contact that bounces, given by its first point. Those of its points that do not bounce stay out of the round. */
function setBiases({ bounces: list }: SolverData, first: number): void {
  const { records: r, stride } = list.batches[first]!;
  const record = list.record[first]!;
  const after = first + (stride === d.TWO_STRIDE ? 2 : 1);
  for (let k = first; k < after; k += 1) {
    const bounces = bouncesNow(list, k);
    r[record + list.shift[k]! + d.BIAS1] = bounces ? list.bias[k]! + r[record + d.SURFACE_N]! : d.OFF;
    if (bounces) {
      list.state[k] = BOUNCED;
      list.leaves[k] = -list.bias[k]!;
    }
    list.bias[k] = 0;
  }
}

function bouncesNow({ bias, state }: BounceList, k: number): boolean {
  return bias[k]! < 0 && state[k] !== LOADED;
}

/**
 * Sweeps over what bounces in a round until nothing changes. After the first few sweeps friction is kept as it is: in a corner the friction
 * on one wall presses onto the other one, and would grow with each sweep.
 */
function solveRound(data: SolverData, h: number, count: number, round: number): void {
  const { bounces: list } = data;
  const isFree = collect(data, count, round);
  noteVelocities(data, ledger.before);
  dropAll(list, count);
  let changed = true;
  for (let i = 0; i < BOUNCE_RUBS && changed; i += 1) {
    changed = sweepBouncing(data, h, count);
  }
  swapFriction(list, count);
  for (let i = 0; i < BOUNCE_SWEEPS && changed; i += 1) {
    changed = sweepBouncing(data, h, count);
  }
  swapFriction(list, count);
  noteVelocities(data, ledger.after);
  if (isFree && ledger.gains()) {
    lessenFriction(data, h, count);
  }
  dropAll(list, count);
}

/** The bodies of a round, by the offsets of their records, and their energies: scratch. */
const involved: number[] = [];
let bodyCount = 0;
const ledger = /* @__PURE__ */ new Ledger();
/** The impulses of the contacts of a round, with friction: scratch. */
const given: number[] = [];

/**
 * Lists the bodies of a round, which are marked, and loses their marks meanwhile, so that each is listed once. @returns whether nothing
 * drives them, and nothing is set to bounce faster than it came.
 */
function collect({ bounces: list, velocity: v }: SolverData, count: number, round: number): boolean {
  let isFree = true;
  bodyCount = 0;
  for (let n = 0; n < count; n += 1) {
    const k = list.bouncing[n]!;
    const { records: r } = list.batches[k]!;
    const record = list.record[k]!;
    isFree &&= list.elasticity[k]! <= 1 && r[record + d.SURFACE_T] === 0 && r[record + d.SURFACE_N] === 0;
    for (let side = 0; side < 2; side += 1) {
      const at = list.bodies[2 * k + side]!;
      if (v[at + d.MARK] === -round) {
        v[at + d.MARK] = 0;
        involved[bodyCount] = at;
        bodyCount += 1;
      }
    }
  }
  ledger.open(bodyCount);
  const { weights } = ledger;
  for (let n = 0; n < bodyCount; n += 1) {
    const at = involved[n]!;
    const inverseMass = v[at + d.INV_MASS]!;
    const inverseInertia = v[at + d.INV_INERTIA]!;
    v[at + d.MARK] = -round;
    weights[3 * n] = inverseMass > 0 ? 1 / inverseMass : 0;
    weights[3 * n + 1] = weights[3 * n]!;
    weights[3 * n + 2] = inverseInertia > 0 ? 1 / inverseInertia : 0;
    isFree &&= inverseMass > 0 || inverseInertia > 0 || (v[at + d.VX] === 0 && v[at + d.VY] === 0 && v[at + d.W] === 0);
  }
  return isFree;
}

function noteVelocities({ velocity: v }: SolverData, into: Float64Array): void {
  for (let n = 0; n < bodyCount; n += 1) {
    const at = involved[n]!;
    into[3 * n] = v[at + d.VX]!;
    into[3 * n + 1] = v[at + d.VY]!;
    into[3 * n + 2] = v[at + d.W]!;
  }
}

function setVelocities({ velocity: v }: SolverData, from: Float64Array): void {
  for (let n = 0; n < bodyCount; n += 1) {
    const at = involved[n]!;
    v[at + d.VX] = from[3 * n]!;
    v[at + d.VY] = from[3 * n + 1]!;
    v[at + d.W] = from[3 * n + 2]!;
  }
}

/** Keeps only as much friction in a round as makes no energy, see `no-gain.ts`. */
function lessenFriction(data: SolverData, h: number, count: number): void {
  const { bounces: list } = data;
  setVelocities(data, ledger.before);
  let size = 0;
  for (let n = 0; n < count; n += 1) {
    const k = list.bouncing[n]!;
    const { records: r } = list.batches[k]!;
    const record = list.record[k]!;
    for (const impulse of IMPULSES) {
      given[size] = r[record + impulse]!;
      r[record + impulse] = 0;
      size += 1;
    }
  }
  swapFriction(list, count);
  for (let i = 0, changed = true; i < BOUNCE_SWEEPS && changed; i += 1) {
    changed = sweepBouncing(data, h, count);
  }
  swapFriction(list, count);
  noteVelocities(data, ledger.without);
  const kept = ledger.lessen();
  setVelocities(data, ledger.without);
  size = 0;
  for (let n = 0; n < count; n += 1) {
    const k = list.bouncing[n]!;
    const { records: r } = list.batches[k]!;
    const record = list.record[k]!;
    for (const impulse of IMPULSES) {
      const without = r[record + impulse]!;
      r[record + impulse] = without + kept * (given[size]! - without);
      size += 1;
    }
  }
}

/**
 * Exchanges the effective masses along the tangents of what bounces with its biases, which are 0 by then, so that friction does not change;
 * and back.
 */
function swapFriction({ bouncing, batches, record, bias }: BounceList, count: number): void {
  for (let n = 0; n < count; n += 1) {
    const k = bouncing[n]!;
    const { records: r } = batches[k]!;
    const at = record[k]! + d.TANGENT_MASS;
    const mass = r[at]!;
    r[at] = bias[k]!;
    bias[k] = mass;
  }
}

/** Sweeps once over what bounces in a round. @returns whether it changed anything. */
function sweepBouncing(data: SolverData, h: number, count: number): boolean {
  const { bounces: list } = data;
  let changed = false;
  for (let n = 0; n < count; n += 1) {
    const k = list.bouncing[n]!;
    const solve = list.batches[k] === data.two ? solveVelocityTwo : solveVelocityOne;
    changed = solve(data, list.index[k]!, list.index[k]! + 1, h) || changed;
  }
  return changed;
}

/** Drops the impulses of all points that bounced in a round. */
function dropAll(list: BounceList, count: number): void {
  for (let n = 0; n < count; n += 1) {
    const k = list.bouncing[n]!;
    dropImpulses(list, k);
    if (list.batches[k]!.stride === d.TWO_STRIDE) dropImpulses(list, k + 1);
  }
}

/** Plans what becomes of a point that approaches fast enough to bounce, see `plan`. */
function planBounce(data: SolverData, k: number, h: number, round: number): void {
  const { bounces: list } = data;
  findSeparation(data, k);
  plan.gain = gainOf(data, k);
  const { records: r, stride } = list.batches[k]!;
  const record = list.record[k]!;
  const i = record + list.shift[k]!;
  const load = BOUNCE_LOAD * r[i + d.NORMAL1]!;
  const isLoaded =
    stride === d.ONE_STRIDE ? -plan.comes * r[record + d.NORMAL_MASS]! <= load : -plan.comes <= load * r[i + d.K11]!;
  if (plan.separation > TOUCH_DEPTH) {
    list.bias[k] = d.OFF;
  } else if (!isLoaded) {
    planSpeed(list, k, h);
  } else if (round === 0) {
    planSpeed(list, k, h);
    list.bias[k] = list.bias[k]! - plan.gain;
    list.state[k] = LOADED;
  }
}

/** Whether a constraint acts on one of the bodies of a point. */
function hangs({ batches, index }: BounceList, k: number): boolean {
  const { bodyA, bodyB } = batches[k]!.arbiters[index[k]!]!;
  return isTied(bodyA) || isTied(bodyB);
}

/**
 * Makes the sweeps keep the speed with which a point leaves now, as a constraint acts on one of its bodies: a plank that a ball struck may
 * be welded to a house. But no point is to leave faster than planned. A free body may be thrown off by one of its points so that the other
 * one leaves still faster; on an axle it cannot be without turning as much faster.
 */
function keepLeaving(data: SolverData, k: number): void {
  const { bounces: list } = data;
  const { records: r } = list.batches[k]!;
  const record = list.record[k]!;
  findSpeed(data, k);
  const leaves = Math.min(plan.comes, list.leaves[k]!);
  list.bias[k] = leaves > 0 ? Math.min(0, -leaves - gainOf(data, k) - r[record + d.SURFACE_N]!) : 0;
}

/** Lets a point start from nothing: its impulses until now only count towards the step. */
function dropImpulses(list: BounceList, k: number): void {
  const { records: r } = list.batches[k]!;
  const record = list.record[k]!;
  const i = record + list.shift[k]!;
  r[i + d.NORMAL_SUM1] = r[i + d.NORMAL_SUM1]! + r[i + d.NORMAL1]!;
  r[record + d.TANGENT_SUM] = r[record + d.TANGENT_SUM]! + r[record + d.TANGENT]!;
  r[i + d.NORMAL1] = 0;
  // If there is a second point, it asks for friction again.
  r[record + d.TANGENT] = 0;
}

/** After warm start: replaces the bias from the separation with the planned one. */
export function applyBounces(data: SolverData): void {
  const { bounces: list } = data;
  for (let k = 0; k < list.count; k += 1) {
    const bias = list.bias[k]!;
    if (bias !== 0) {
      const { records: r } = list.batches[k]!;
      const record = list.record[k]!;
      const at = record + list.shift[k]! + d.BIAS1;
      r[at] = bias + (bias > 0 && bias < d.OFF ? r[at]! : r[record + d.SURFACE_N]!);
    }
  }
}

function fliesApart(data: SolverData, k: number): boolean {
  findSpeed(data, k);
  return plan.comes > BOUNCE_THRESHOLD;
}

/**
 * Before position iterations: takes points of bouncing materials that fly apart out of these, which would add height; unless they are so
 * deep that it should have been an impact earlier.
 */
export function spareBounces(data: SolverData): void {
  const { bounces: list } = data;
  for (let k = 0; k < list.count; k += 1) {
    if (list.bias[k] === d.OFF || fliesApart(data, k)) {
      const { records: r } = list.batches[k]!;
      const at = list.record[k]! + list.shift[k]! + d.SEPARATION1;
      if (r[at]! < -FORESIGHT_DEPTH) {
        if (list.depth[k] === 0) findDepth(list, k);
        r[at] = r[at]! + list.depth[k]!;
      } else {
        r[at] = d.OUT_OF_REACH;
      }
    }
  }
}

/** Once a step, as the memory of shapes has to be waited for. */
function findDepth({ batches, index, depth }: BounceList, k: number): void {
  const { shapeA, shapeB } = batches[k]!.arbiters[index[k]!]!;
  findImpactDepth(shapeA, shapeB);
  depth[k] = impactDepth[0]!;
}
