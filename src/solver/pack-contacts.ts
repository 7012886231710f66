import {
  MAX_CONDITION,
  MIN_INVERSE_MASS,
  PUSH_SHARE_DYNAMIC,
  PUSH_SHARE_STATIC,
  REST_SPIN_WEIGHT,
  SPECULATIVE_MARGIN,
  STATIC_FRICTION_SPEED_SQUARED,
} from '../config.js';
import type { Arbiter } from '../contact/arbiter.js';
import type { ContactBatch, SolverData } from './data.js';
import * as d from './data.js';

/**
 * Writes the records of all contacts. Impulses kept from the last sub-step are scaled by `impulseScale`.
 *
 * The order is that of the shapes' ids, but neighbours there share a body, and the processor would wait for one contact before it
 * can begin the next; so each window of the list is taken in four runs by turns. That saves a quarter of an iteration and changes
 * no result that matters. Refused: greedy colouring, so that no neighbours share a body. Solving, say, all left supports before all
 * right ones leaves the same error in all rows of a pyramid: of base 20 it slides 0.3 m and never rests (this order: 0.02 m, rests).
 */
export function packContacts(data: SolverData, pairs: readonly Arbiter[]): void {
  const solved = data.solved;
  let count = 0;
  for (const pair of pairs) {
    if (pair.isSolved()) {
      solved[count] = pair;
      count += 1;
    }
  }
  data.one.count = 0;
  data.two.count = 0;
  data.bounces.count = 0;
  for (let start = 0; start < count; start += d.WINDOW) {
    const end = Math.min(count, start + d.WINDOW);
    for (let first = start; first < start + d.RUN && first < end; first += 1) {
      for (let i = first; i < end; i += d.RUN) {
        packContact(data, solved[i]!);
      }
    }
  }
}

function packContact(data: SolverData, pair: Arbiter): void {
  if (hasTwoPoints(pair)) {
    packTwo(data, data.two.add(pair));
  } else {
    packOne(data, data.one.add(pair));
  }
}

/** Both points are near enough to matter. */
function hasTwoPoints(pair: Arbiter): boolean {
  const m = pair.manifold;
  return m.count === 2 && m.separation0 <= SPECULATIVE_MARGIN && m.separation1 <= SPECULATIVE_MARGIN;
}

function packTwo(data: SolverData, index: number): void {
  const batch = data.two;
  const at = index * d.TWO_STRIDE;
  const pair = batch.arbiters[index]!;
  const m = pair.manifold;
  const records = batch.records;
  packPair(data, batch, index, pair);
  packPoint(data, batch, index, 0, 0);
  packPoint(data, batch, index, d.SECOND, 1);
  const { velocity } = data;
  const a = batch.bodies[2 * index]!;
  const b = batch.bodies[2 * index + 1]!;
  const k11 = records[at + d.K11]!;
  const k22 = records[at + d.K22]!;
  const k12 =
    velocity[a + d.INV_MASS]! +
    velocity[b + d.INV_MASS]! +
    velocity[a + d.INV_INERTIA]! * records[at + d.RN_A1]! * records[at + d.RN_A2]! +
    velocity[b + d.INV_INERTIA]! * records[at + d.RN_B1]! * records[at + d.RN_B2]!;
  const det = k11 * k22 - k12 * k12;
  if (k11 * k11 < MAX_CONDITION * det) {
    records[at + d.K12] = k12;
    records[at + d.INV_DET] = 1 / det;
  } else {
    const shallow = m.separation0 <= m.separation1 ? d.SECOND : 0;
    records[at + shallow + d.START1] = d.NEVER;
    records[at + d.K12] = 0;
    records[at + d.INV_DET] = 1 / (k11 * k22);
  }
  if (pair.elasticity > 0) {
    data.bounces.add(true, at, 0, pair.elasticity);
    data.bounces.add(true, at, d.SECOND, pair.elasticity);
  }
}

function packOne(data: SolverData, index: number): void {
  const batch = data.one;
  const at = index * d.ONE_STRIDE;
  const pair = batch.arbiters[index]!;
  const m = pair.manifold;
  const records = batch.records;
  const second = m.count === 2 && m.separation1 < m.separation0;
  batch.point[index] = second ? 1 : 0;
  packPair(data, batch, index, pair);
  packPoint(data, batch, index, 0, second ? 1 : 0);
  const { velocity } = data;
  const a = batch.bodies[2 * index]!;
  const b = batch.bodies[2 * index + 1]!;
  const k = velocity[a + d.INV_INERTIA]! + velocity[b + d.INV_INERTIA]!;
  const rolls = m.count === 1 && k > MIN_INVERSE_MASS;
  records[at + d.ROLL_MASS] = rolls ? 1 / k : 0;
  records[at + d.ROLL_FRICTION] = rolls ? pair.rollingFriction : 0;
  records[at + d.ROLL] = pair.rolling * data.impulseScale;
  records[at + d.ROLL_SUM] = 0;
  if (pair.elasticity > 0) {
    data.bounces.add(false, at, 0, pair.elasticity);
  }
}

/** What the points of a pair share. */
function packPair(data: SolverData, batch: ContactBatch, index: number, pair: Arbiter): void {
  const records = batch.records;
  const at = index * batch.stride;
  const bodyA = pair.bodyA;
  const bodyB = pair.bodyB;
  const a = bodyA.slot * d.BODY_STRIDE;
  const b = bodyB.slot * d.BODY_STRIDE;
  batch.bodies[2 * index] = a;
  batch.bodies[2 * index + 1] = b;
  records[at + d.NX] = pair.manifold.nx;
  records[at + d.NY] = pair.manifold.ny;
  const bothMove = data.velocity[a + d.INV_MASS]! > 0 && data.velocity[b + d.INV_MASS]! > 0;
  records[at + d.SHARE] = bothMove ? PUSH_SHARE_DYNAMIC : PUSH_SHARE_STATIC;
  records[at + d.SURFACE_T] = -(bodyA.surfaceX + bodyB.surfaceX);
  records[at + d.SURFACE_N] = -(bodyA.surfaceY + bodyB.surfaceY);
  damp(data, a);
  damp(data, b);
}

/** A body with a contact is subject to rest damping; a body that nothing moves is not. */
function damp(data: SolverData, at: number): void {
  const invMass = data.velocity[at + d.INV_MASS]!;
  const invInertia = data.velocity[at + d.INV_INERTIA]!;
  if (invMass > 0 || invInertia > 0) {
    data.drive[at + d.REST_RADIUS] = invInertia === 0 ? 0 : (REST_SPIN_WEIGHT * invMass) / invInertia;
  }
}

/** Arms, masses, friction and kept impulses of point 0 or 1 of a manifold. */
function packPoint(data: SolverData, batch: ContactBatch, index: number, shift: number, which: number): void {
  const { velocity } = data;
  const records = batch.records;
  const pair = batch.arbiters[index]!;
  const base = index * batch.stride;
  const at = base + shift;
  const a = batch.bodies[2 * index]!;
  const b = batch.bodies[2 * index + 1]!;
  const nx = records[base + d.NX]!;
  const ny = records[base + d.NY]!;
  const m = pair.manifold;
  const x = which === 0 ? m.x0 : m.x1;
  const y = which === 0 ? m.y0 : m.y1;
  const bx = x - m.dx;
  const by = y - m.dy;
  const rnA = x * ny - y * nx;
  const rtA = x * nx + y * ny;
  const rnB = bx * ny - by * nx;
  const rtB = bx * nx + by * ny;
  records[at + d.RN_A1] = rnA;
  records[at + d.RN_B1] = rnB;
  records[at + d.RT_A1] = rtA;
  records[at + d.RT_B1] = rtB;
  const mass = velocity[a + d.INV_MASS]! + velocity[b + d.INV_MASS]!;
  const iA = velocity[a + d.INV_INERTIA]!;
  const iB = velocity[b + d.INV_INERTIA]!;
  const kn = mass + iA * rnA * rnA + iB * rnB * rnB;
  const kt = mass + iA * rtA * rtA + iB * rtB * rtB;
  records[at + d.K11] = kn > MIN_INVERSE_MASS ? kn : d.IMMOVABLE;
  records[at + d.TANGENT_MASS1] = kt > MIN_INVERSE_MASS ? 1 / kt : 0;
  const vt =
    nx * (velocity[b + d.VY]! - velocity[a + d.VY]!) -
    ny * (velocity[b + d.VX]! - velocity[a + d.VX]!) +
    rtB * velocity[b + d.W]! -
    rtA * velocity[a + d.W]!;
  records[at + d.FRICTION1] = vt * vt > STATIC_FRICTION_SPEED_SQUARED ? pair.dynamicFriction : pair.staticFriction;
  records[at + d.START1] = which === 0 ? m.separation0 : m.separation1;
  records[at + d.NORMAL_SUM1] = 0;
  records[at + d.TANGENT_SUM1] = 0;
  const point = pair.points[which]!;
  records[at + d.NORMAL1] = point.normal * data.impulseScale;
  records[at + d.TANGENT1] = point.tangent * data.impulseScale;
}
