import * as g from '../collide/layout.js';
import {
  MAX_CONDITION,
  MIN_INVERSE_MASS,
  PUSH_SHARE_DYNAMIC,
  PUSH_SHARE_STATIC,
  SPECULATIVE_MARGIN,
  STATIC_FRICTION_SPEED_SQUARED,
} from '../config.js';
import type { Arbiter } from '../contact/arbiter.js';
import * as c from '../contact/layout.js';
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
  const { count, numbers: n } = pair.manifold;
  return count === 2 && n[g.S0]! <= SPECULATIVE_MARGIN && n[g.S1]! <= SPECULATIVE_MARGIN;
}

function packTwo(data: SolverData, index: number): void {
  const batch = data.two;
  const at = index * d.TWO_STRIDE;
  const pair = batch.arbiters[index]!;
  const n = pair.manifold.numbers;
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
    const shallow = n[g.S0]! <= n[g.S1]! ? d.SECOND : 0;
    records[at + shallow + d.START1] = d.NEVER;
    records[at + d.K12] = 0;
    records[at + d.INV_DET] = 1 / (k11 * k22);
  }
  const elasticity = n[c.ELASTICITY]!;
  if (elasticity > 0) {
    data.bounces.add(true, at, 0, elasticity);
    data.bounces.add(true, at, d.SECOND, elasticity);
  }
}

function packOne(data: SolverData, index: number): void {
  const batch = data.one;
  const at = index * d.ONE_STRIDE;
  const pair = batch.arbiters[index]!;
  const { count, numbers: n } = pair.manifold;
  const records = batch.records;
  const second = count === 2 && n[g.S1]! < n[g.S0]!;
  batch.point[index] = second ? 1 : 0;
  packPair(data, batch, index, pair);
  packPoint(data, batch, index, 0, second ? 1 : 0);
  const { velocity } = data;
  const a = batch.bodies[2 * index]!;
  const b = batch.bodies[2 * index + 1]!;
  const k = velocity[a + d.INV_INERTIA]! + velocity[b + d.INV_INERTIA]!;
  const rolls = count === 1 && k > MIN_INVERSE_MASS;
  records[at + d.ROLL_MASS] = rolls ? 1 / k : 0;
  records[at + d.ROLL_FRICTION] = rolls ? n[c.ROLLING_FRICTION]! : 0;
  records[at + d.ROLL] = n[c.ROLL]! * data.impulseScale;
  records[at + d.ROLL_SUM] = 0;
  const elasticity = n[c.ELASTICITY]!;
  if (elasticity > 0) {
    data.bounces.add(false, at, 0, elasticity);
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
  const n = pair.manifold.numbers;
  records[at + d.NX] = n[g.NX]!;
  records[at + d.NY] = n[g.NY]!;
  const bothMove = data.velocity[a + d.INV_MASS]! > 0 && data.velocity[b + d.INV_MASS]! > 0;
  records[at + d.SHARE] = bothMove ? PUSH_SHARE_DYNAMIC : PUSH_SHARE_STATIC;
  records[at + d.SURFACE_T] = -(bodyA.surfaceX + bodyB.surfaceX);
  records[at + d.SURFACE_N] = -(bodyA.surfaceY + bodyB.surfaceY);
  data.drive[a + d.TOUCHED] = 1;
  data.drive[b + d.TOUCHED] = 1;
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
  const n = pair.manifold.numbers;
  const x = n[g.X0 + g.POINT * which]!;
  const y = n[g.Y0 + g.POINT * which]!;
  const bx = x - n[g.DX]!;
  const by = y - n[g.DY]!;
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
  records[at + d.FRICTION1] = vt * vt > STATIC_FRICTION_SPEED_SQUARED ? n[c.DYNAMIC_FRICTION]! : n[c.STATIC_FRICTION]!;
  records[at + d.START1] = n[g.S0 + g.POINT * which]!;
  records[at + d.NORMAL_SUM1] = 0;
  records[at + d.TANGENT_SUM1] = 0;
  records[at + d.NORMAL1] = n[c.NORMAL + c.IMPULSES * which]! * data.impulseScale;
  records[at + d.TANGENT1] = n[c.TANGENT + c.IMPULSES * which]! * data.impulseScale;
}
