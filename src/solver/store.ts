import type { RigidBody } from '../body.js';
import { DYNAMIC } from '../body-kind.js';
import * as g from '../collide/layout.js';
import {
  COLUMN_PART,
  FAR,
  IMPULSE_MEMORY,
  ROCK_SPIN,
  SPECULATIVE_MARGIN,
  STRAIN_DELAY,
  STRAIN_PART,
  STRAIN_SPEED,
  STRAIN_UNLIKE,
  STRAIN_UNLIKE_ONE,
  TUMBLE_SPIN,
} from '../config.js';
import type { Arbiter } from '../contact/arbiter.js';
import * as c from '../contact/layout.js';
import { FOUND_LATE } from '../events/events.js';
import type { World } from '../world.js';
import type { ContactBatch, SolverData } from './data.js';
import * as d from './data.js';
import { endForesight } from './foresee.js';
import { settleFrozen } from './freeze.js';
import { beginLate, solveImpact } from './impact.js';

/** Writes the outcome of a step back to bodies, contacts and arbiters. */
export function store(world: World): void {
  const data = world.solver;
  storeBodies(world, world.liveDynamics);
  storeBodies(world, world.liveKinematics);
  storeContacts(world, data, data.two);
  storeContacts(world, data, data.one);
  if (world.frozen.size > 0) {
    settleFrozen(world);
  }
}

function storeBodies(world: World, bodies: readonly RigidBody[]): void {
  for (let i = 0; i < bodies.length; i += 1) {
    storeBody(world, bodies[i]!);
  }
}

/** A body that a callback woke while the step was being solved has no slot: it joins in the next. */
function storeBody(world: World, body: RigidBody): void {
  if (body.slot === 0) {
    return;
  }
  const at = body.slot * d.BODY_STRIDE;
  const { velocity: v, motion: q } = world.solver;
  const dx = q[at + d.DX]!;
  const dy = q[at + d.DY]!;
  const turn = q[at + d.DW]!;
  const sum = Math.abs(v[at + d.VX]!) + Math.abs(v[at + d.VY]!) + Math.abs(v[at + d.W]!);
  if (!(sum + Math.abs(body.x + dx) + Math.abs(body.y + dy) + Math.abs(body.angle + turn) <= FAR)) {
    world.frozen.add(body);
    return;
  }
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
    // As `goesFar`, which called from here would have to box its numbers.
    if (Math.abs(dx) + Math.abs(dy) + Math.abs(turn) * body.radius > Math.max(body.clearance, SPECULATIVE_MARGIN / 2)) {
      world.movers.add(body).look(body, true);
    }
  }
  body.clearance = 0;
  if (body.kind === DYNAMIC) {
    body.vx = v[at + d.VX]!;
    body.vy = v[at + d.VY]!;
    body.w = v[at + d.W]!;
  }
}

function storeContacts(world: World, data: SolverData, batch: ContactBatch): void {
  const two = batch === data.two;
  for (let k = 0; k < batch.count; k += 1) {
    const pair = batch.arbiters[k]!;
    if (world.frozen.size > 0 && (world.frozen.has(pair.bodyA) || world.frozen.has(pair.bodyB))) {
      pair.near = false;
      continue;
    }
    const used = pair.usedPoints;
    if (two) {
      storePoint(data, batch, k, 0, 0);
      storePoint(data, batch, k, d.SECOND, 1);
    } else {
      storeOne(data, batch, k);
    }
    pair.strain = isStrained(data, batch, k) ? pair.strain + 1 : 0;
    pair.rocks = two && isRocking(data, k);
    if (pair.strain >= STRAIN_DELAY) {
      pair.strained = world.timeStamp;
    }
    pair.freshPoints = pair.usedPoints & ~used;
    if (pair.near) {
      meet(world, pair);
    }
  }
}

/** Whether a contact bears far more than its bodies weigh, and they are unlike or, if it is of two points, it bears much of what either of them does. */
function isStrained({ two, velocity: v, drive }: SolverData, batch: ContactBatch, index: number): boolean {
  const { records: r, bodies } = batch;
  const i = index * batch.stride;
  const a = bodies[2 * index]!;
  const b = bodies[2 * index + 1]!;
  const mA = v[a + d.INV_MASS]!;
  const mB = v[b + d.INV_MASS]!;
  const p1 = r[i + d.NORMAL1]!;
  if (batch !== two) {
    return p1 > STRAIN_SPEED * r[i + d.NORMAL_MASS]! && Math.abs(mA - mB) > STRAIN_UNLIKE_ONE * (mA + mB);
  }
  const p2 = r[i + d.NORMAL2]!;
  return (
    p1 * r[i + d.K11]! + p2 * r[i + d.K22]! > STRAIN_SPEED &&
    (Math.abs(mA - mB) > STRAIN_UNLIKE * (mA + mB) ||
      p1 + p2 > STRAIN_PART * Math.min(drive[a + d.LOAD]!, drive[b + d.LOAD]!))
  );
}

/** Whether two edges turn against each other, slowly, and bear about half of all that either body does: as in a column that sways. */
function isRocking({ two, velocity: v, drive }: SolverData, index: number): boolean {
  const { records: r, bodies } = two;
  const i = index * d.TWO_STRIDE;
  const a = bodies[2 * index]!;
  const b = bodies[2 * index + 1]!;
  const spin = Math.abs(v[b + d.W]! - v[a + d.W]!);
  const load = r[i + d.NORMAL1]! + r[i + d.NORMAL2]!;
  const loadA = drive[a + d.LOAD]!;
  const loadB = drive[b + d.LOAD]!;
  return (
    spin > ROCK_SPIN &&
    spin < TUMBLE_SPIN &&
    load > COLUMN_PART * Math.min(a === 0 ? Infinity : loadA, b === 0 ? Infinity : loadB) &&
    load < (1 - COLUMN_PART) * Math.max(a === 0 ? 0 : loadA, b === 0 ? 0 : loadB)
  );
}

/** A contact of one point; a second point that the solver did not see has no impulse. */
function storeOne(data: SolverData, batch: ContactBatch, index: number): void {
  const pair = batch.arbiters[index]!;
  const { numbers: n, at: o } = pair;
  const at = index * batch.stride;
  const point = batch.point[index]!;
  const which = point & 1;
  if ((point & d.ONE_OF_TWO) !== 0) {
    pair.dropPoint(which === 0 ? 1 : 0);
  }
  storePoint(data, batch, index, 0, which);
  const roll = batch.records[at + d.ROLL]! + 0;
  n[o + c.ROLL] = roll;
  n[o + c.STEP_ROLL] = batch.records[at + d.ROLL_SUM]! + roll;
}

/**
 * The impulses of point 0 or 1; a zero is never negative, as users and snapshots read them. A point that was apart from the start and met nothing was not used.
 * The next step does not start from all that this one changed: see IMPULSE_MEMORY.
 */
function storePoint(data: SolverData, batch: ContactBatch, index: number, shift: number, which: number): void {
  const r = batch.records;
  const record = index * batch.stride;
  const i = record + shift;
  const pair = batch.arbiters[index]!;
  const { numbers: n, at: o } = pair;
  const to = c.IMPULSES * which;
  const part = batch.stride === d.ONE_STRIDE ? 1 : Math.abs(r[record + d.PART]! - which);
  const normal = r[i + d.NORMAL1]!;
  const tangent = r[record + d.TANGENT]!;
  const total = r[i + d.NORMAL_SUM1]! + normal;
  const before = n[o + c.NORMAL + to]! * data.impulseScale;
  // Of an impact, which is over, nothing is to be left.
  n[o + c.NORMAL + to] = Math.min(before + IMPULSE_MEMORY * (normal - before), 2 * normal);
  n[o + c.TANGENT + to] = part * tangent + 0;
  n[o + c.STEP_NORMAL + to] = total;
  const both =
    r[record + d.NORMAL_SUM1]! + r[record + d.NORMAL1]! + r[record + d.NORMAL_SUM2]! + r[record + d.NORMAL2]!;
  const told = batch.stride === d.TWO_STRIDE && both > 0 ? total / both : part;
  const slid = told * (r[record + d.TANGENT_SUM]! + tangent) + 0;
  n[o + c.STEP_TANGENT + to] = slid;
  const bit = 1 << which;
  // What the record tells is asked first: the pair would be waited for.
  const unused = total === 0 && slid === 0 && n[o + g.S0 + g.POINT * which]! > 0;
  pair.usedPoints = unused ? pair.usedPoints & ~bit : pair.usedPoints | bit;
}

/**
 * Surfaces that were apart when the step began and met during it: the interaction begins late in the step. If it was in the last sub-step
 * they still have the speed that brought them together by the end of it.
 */
function meet(world: World, pair: Arbiter): void {
  const { numbers: n, at: o } = pair;
  if (n[o + c.STEP_NORMAL] === 0 && (pair.count === 1 || n[o + c.STEP_NORMAL + c.IMPULSES] === 0)) {
    return;
  }
  pair.near = false;
  pair.accepted = true;
  if (pair.foreseen) {
    endForesight(pair);
  }
  solveImpact(world, pair);
  beginLate(world, pair);
  world.events.hit(pair, FOUND_LATE);
}
