import type { RigidBody } from '../body.js';
import { DYNAMIC } from '../body-kind.js';
import { works } from '../collide/polygon-works.js';
import { FAR, SPECULATIVE_MARGIN } from '../config.js';
import type { Arbiter } from '../contact/arbiter.js';
import { ACCEPTED, NEAR } from '../contact/bits.js';
import * as c from '../contact/layout.js';
import type { World } from '../world.js';
import { storeOne } from './contacts/store-contacts.js';
import type { ContactBatch, SolverData } from './data.js';
import { restFrozen } from './freeze.js';
import { endForesight } from './impacts/foresee.js';
import { noteMet, strikeMet } from './impacts/late.js';
import * as d from './layout.js';

/** Writes the outcome of a step back to bodies, contacts and arbiters. */
export function store(world: World): void {
  const data = world.solver;
  storeBodies(world, world.liveDynamics);
  storeBodies(world, world.liveKinematics);
  storeContacts(world, data, data.two);
  storeContacts(world, data, data.one);
  strikeMet(world);
  if (world.frozen.size > 0) {
    restFrozen(world);
  }
}

function storeBodies(world: World, bodies: readonly RigidBody[]): void {
  for (let i = 0; i < bodies.length; i += 1) {
    storeBody(world, bodies[i]!);
  }
}

/** Writes the outcome back to a body. One that a callback woke while the step was being solved has no slot: it joins in the next step. */
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
    // As `goesFar`, which would have to box its numbers if it were called from here.
    if (Math.abs(dx) + Math.abs(dy) + Math.abs(turn) * body.radius > Math.max(body.clearance, SPECULATIVE_MARGIN / 2)) {
      world.movers.add(body, true).retrace();
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
  const isTwo = batch === data.two;
  const { timeStamp, frozen } = world;
  for (let k = 0; k < batch.count; k += 1) {
    if (frozen.size > 0 && holdsFrozen(frozen, batch.arbiters[k]!)) {
      batch.arbiters[k]!.unmark(NEAR);
      continue;
    }
    if (isTwo) works!.storeTwo(data, k, timeStamp);
    else storeOne(data, k, timeStamp);
    if ((batch.bits[k]! & NEAR) !== 0) {
      noteIfMet(world, batch.arbiters[k]!);
    }
  }
}

function holdsFrozen(frozen: Set<RigidBody>, { bodyA, bodyB }: Arbiter): boolean {
  return frozen.has(bodyA) || frozen.has(bodyB);
}

/** Of surfaces that were apart when the step began: notes that they met during it, if they did. */
function noteIfMet(world: World, pair: Arbiter): void {
  const { numbers: n, at: o } = pair;
  if (n[o + c.STEP_NORMAL] === 0 && (pair.count === 1 || n[o + c.STEP_NORMAL + c.IMPULSES] === 0)) {
    return;
  }
  pair.unmark(NEAR);
  pair.mark(ACCEPTED);
  if (pair.foreseen > 0) {
    endForesight(world.movers, pair);
  }
  noteMet(pair);
}
