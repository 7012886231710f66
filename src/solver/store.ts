import type { RigidBody } from '../body.js';
import { DYNAMIC } from '../body-kind.js';
import type { Arbiter } from '../contact/arbiter.js';
import type { Contact } from '../contact/contact.js';
import { FOUND_LATE } from '../events/events.js';
import type { World } from '../world.js';
import type { ContactBatch, SolverData } from './data.js';
import * as d from './data.js';

/** Writes the outcome of a step back to bodies, contacts and arbiters. */
export function store(world: World): void {
  const data = world.solver;
  for (const body of world.liveDynamics) {
    storeBody(data, body);
  }
  for (const body of world.liveKinematics) {
    storeBody(data, body);
  }
  storeContacts(world, data, data.two);
  storeContacts(world, data, data.one);
}

function storeBody(data: SolverData, body: RigidBody): void {
  const at = body.slot * d.BODY_STRIDE;
  const { velocity: v, motion: q } = data;
  if (body.kind === DYNAMIC) {
    body.vx = v[at + d.VX]!;
    body.vy = v[at + d.VY]!;
    body.w = v[at + d.W]!;
  }
  const dx = q[at + d.DX]!;
  const dy = q[at + d.DY]!;
  const turn = q[at + d.DW]!;
  body.lastDx = dx;
  body.lastDy = dy;
  body.lastTurn = turn;
  if (dx !== 0 || dy !== 0 || turn !== 0) {
    body.x += dx;
    body.y += dy;
    if (turn !== 0) {
      body.angle += turn;
      body.refreshTurn();
    }
    body.moved();
  }
}

function storeContacts(world: World, data: SolverData, batch: ContactBatch): void {
  const r = batch.records;
  const two = batch === data.two;
  for (let k = 0; k < batch.count; k += 1) {
    const at = k * batch.stride;
    const pair = batch.arbiters[k]!;
    if (two) {
      storePoint(batch, k, 0, 0);
      storePoint(batch, k, d.SECOND, 1);
    } else {
      const index = batch.point[k]!;
      storePoint(batch, k, 0, index);
      pair.rolling = r[at + d.ROLL]!;
      pair.stepRolling = r[at + d.ROLL_SUM]! + pair.rolling;
      if (pair.manifold.count === 2) {
        leaveOut(pair.points[1 - index]!);
      }
    }
    if (pair.near) {
      meet(world, pair);
    }
  }
}

/** Surfaces that were apart when the step began and met during it: the interaction begins late in the step. */
function meet(world: World, pair: Arbiter): void {
  if (!pair.contacts.some((point) => point.stepNormal > 0)) {
    return;
  }
  if (!pair.listed) {
    world.pairs.list(pair);
    const dynamic = pair.bodyA.kind === DYNAMIC && pair.bodyB.kind === DYNAMIC;
    pair.listIndex = (dynamic ? world.dynamicArbiters : world.staticArbiters).push(pair) - 1;
  }
  for (const point of pair.contacts) {
    point.active = true;
  }
  pair.persistent = false;
  pair.accepted = true;
  pair.active = true;
  pair.lastInteraction = world.timeStamp;
  world.events.interaction('begin', pair, FOUND_LATE);
}

/** A point that the solver did not see. */
function leaveOut(point: Contact): void {
  point.virtual = true;
  point.fresh = false;
  point.normal = 0;
  point.tangent = 0;
  point.stepNormal = 0;
  point.stepTangent = 0;
}

/** A collision that a handler has rejected: its contacts are listed, and do nothing. */
export function leaveOutAll(pair: Arbiter): void {
  pair.rolling = 0;
  pair.stepRolling = 0;
  for (const point of pair.contacts) {
    leaveOut(point);
  }
}

/** The impulses of point 0 or 1. */
function storePoint(batch: ContactBatch, index: number, shift: number, which: number): void {
  const r = batch.records;
  const i = index * batch.stride + shift;
  const pair = batch.arbiters[index]!;
  const point = pair.points[which]!;
  const apart = (which === 0 ? pair.manifold.separation0 : pair.manifold.separation1) > 0;
  const normal = r[i + d.NORMAL1]!;
  const tangent = r[i + d.TANGENT1]!;
  const total = r[i + d.NORMAL_SUM1]! + normal;
  point.normal = normal;
  point.tangent = tangent;
  point.stepNormal = total;
  point.stepTangent = r[i + d.TANGENT_SUM1]! + tangent;
  const wasVirtual = point.virtual;
  const isVirtual = apart && total === 0;
  point.virtual = isVirtual;
  point.fresh = wasVirtual && !isVirtual;
}
