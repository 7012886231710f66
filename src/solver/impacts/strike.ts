import type { RigidBody } from '../../body.js';
import { DYNAMIC } from '../../body-kind.js';
import * as g from '../../collide/layout.js';
import { works } from '../../collide/polygon-works.js';
import type { Arbiter } from '../../contact/arbiter.js';
import { ACTIVE, LISTED, PERSISTENT } from '../../contact/bits.js';
import { noteApproach } from '../../contact/hit.js';
import * as c from '../../contact/layout.js';
import { makeNearestPoint, updateManifold } from '../../contact/update.js';
import { FOUND_LATE } from '../../events/events.js';
import { preSolve } from '../../events/pre-solve.js';
import { BEGIN } from '../../listeners.js';
import type { List } from '../../math/list.js';
import type { World } from '../../world.js';
import { joinLists } from '../arbiter-lists.js';
import { wakeBody } from '../sleep.js';
import { solveImpacts } from './impact.js';
import type { Meeting } from './meeting-queue.js';

/** Begins an interaction in the course of a step. */
export function beginLate(world: World, pair: Arbiter): void {
  if (!pair.is(LISTED)) {
    world.pairs.list(pair);
    joinLists(world, pair);
  }
  pair.unmark(PERSISTENT);
  pair.mark(ACTIVE);
  pair.began = world.timeStamp;
  pair.lastInteraction = world.timeStamp;
  world.events.interaction(BEGIN, pair, FOUND_LATE);
}

/**
 * Solves the impacts of shapes that meet on their ways, all at once, where their bodies are now, or that get too deep into each other.
 * @returns the pairs, without those that were refused; the list is used again by the next call.
 */
export function strike(world: World, meetings: List<Meeting>): List<Arbiter> {
  const { struck } = world.movers;
  struck.clear();
  for (let i = 0; i < meetings.count; i += 1) {
    findContact(world, meetings.items[i]!);
  }
  for (let i = 0; i < struck.count; i += 1) {
    const pair = struck.items[i]!;
    const isFirst = !pair.metAgain();
    rouse(world, pair.bodyA, isFirst);
    rouse(world, pair.bodyB, isFirst);
    if (isFirst) noteApproach(pair);
  }
  if (world.profile !== null) {
    world.profile.impacts += struck.count;
  }
  solveImpacts(world, struck);
  for (let i = 0; i < struck.count; i += 1) {
    const pair = struck.items[i]!;
    pair.noteImpact();
    if (!pair.metAgain()) {
      world.events.hit(pair, FOUND_LATE);
    } else if (pair.bodyA.kind !== DYNAMIC || pair.bodyB.kind !== DYNAMIC) {
      stopComing(pair);
    }
  }
  return struck;
}

/** Finds the contact of two shapes that meet; it is struck unless a handler refuses it. */
function findContact(world: World, { a, b }: Meeting): void {
  const pair = world.pairs.obtain(a, b);
  const isNew = !pair.active;
  a.place(pair.bodyA);
  b.place(pair.bodyB);
  if (!isNew) {
    pair.meetAgain(world.pairs.spare);
  }
  if (!updateManifold(pair)) {
    makeNearestPoint(pair);
  }
  works?.smoothMeeting(world, pair);
  if (isNew) {
    beginLate(world, pair);
    pair.dropPoints();
  }
  if (preSolve(world, pair)) world.movers.struck.add(pair);
}

/** Wakes a dynamic body that is struck. At the first impact of a pair in a step it gets the velocity of that time. */
function rouse(world: World, body: RigidBody, isFirst: boolean): void {
  if (body.kind === DYNAMIC) {
    if (body.asleep) wakeBody(world, body, false);
    if (isFirst) world.movers.of(body).rewindVelocity(world);
  }
}

/**
 * A body that touched before may turn so fast that the point which touches is leaving, and so gets no impulse, while the rest of the body
 * approaches. Many impacts in a step would stop that; here the velocity of its origin into the surface is taken from it.
 */
function stopComing(pair: Arbiter): void {
  const { numbers: n, at: o } = pair;
  const { bodyA: a, bodyB: b, before } = pair;
  if (n[o + c.STEP_NORMAL]! + n[o + c.STEP_NORMAL + c.IMPULSES]! > 0 || before === null) {
    return;
  }
  const nx = n[o + g.NX]!;
  const ny = n[o + g.NY]!;
  const across = n[o + g.DX]! * ny - n[o + g.DY]! * nx;
  const turning = a.kind === DYNAMIC ? across * b.w : across * a.w;
  const coming = nx * (a.vx - b.vx) + ny * (a.vy - b.vy) + turning;
  const inverseA = a.inverseMass();
  const inverseB = b.inverseMass();
  if (coming > 0 && inverseA + inverseB > 0) {
    const share = inverseB / (inverseA + inverseB);
    const x = nx * coming;
    const y = ny * coming;
    a.vx -= x * (1 - share);
    a.vy -= y * (1 - share);
    b.vx += x * share;
    b.vy += y * share;
    before.x += x / (inverseA + inverseB);
    before.y += y / (inverseA + inverseB);
  }
}
