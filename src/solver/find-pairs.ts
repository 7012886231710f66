import { DYNAMIC } from '../body-kind.js';
import type { BroadphaseHandle } from '../broadphase/broadphase.js';
import * as g from '../collide/layout.js';
import { works } from '../collide/polygon-works.js';
import { SOLVED_TURN, WEDGED_DEPTH } from '../config.js';
import type { Arbiter } from '../contact/arbiter.js';
import { ACTIVE, AWAKE, DEAD, LISTED, NEAR, PERSISTENT } from '../contact/bits.js';
import { noteApproach } from '../contact/hit.js';
import * as c from '../contact/layout.js';
import { sensorIntersects, updateManifold } from '../contact/update.js';
import { IN_STEP } from '../events/events.js';
import { asksFirst, preSolve } from '../events/pre-solve.js';
import { BEGIN, END, PROGRESS } from '../listeners.js';
import type { List } from '../math/list.js';
import type { Shape } from '../shape/shape.js';
import type { World } from '../world.js';
import { noteGround } from './contacts/seams.js';
import { noteDeep, partWedged } from './contacts/wedged.js';
import { goesFar } from './impacts/movers.js';
import { passes } from './impacts/passing.js';
import { areApart, canGiveWay, canInteract, mayInteract } from './interaction.js';
import { sleepPair, wakeBody } from './sleep.js';

/**
 * Called by the broadphase with `this` = the world. @returns what `reportAgain` is asked in the next step: the number of the pair, if there
 * is one, or minus `World.filters` where they keep the shapes apart.
 */
function report(this: World, first: BroadphaseHandle, second: BroadphaseHandle): number {
  const a = first.data as Shape;
  const b = second.data as Shape;
  if (areApart(a, b)) {
    return -this.filters;
  }
  if (!canInteract(a, b)) {
    return 0;
  }
  return this.pairs.report(a, b, this.timeStamp);
}

function reportAgain(this: World, note: number): boolean {
  return note < 0 ? -note === this.filters : this.pairs.reportAgain(note, this.timeStamp);
}

/**
 * Finds what collides: broadphase → pairs → manifolds → begin, progress, end and `preSolve`. Sleeping bodies that were hit wake once all
 * pairs have been seen, with the manifolds with which they fell asleep.
 */
export function findPairs(world: World, dt: number): void {
  const pairs = world.pairs;
  world.filtersChanged = false;
  pairs.recycle();
  world.broadphase.perform(report, world, reportAgain);
  pairs.makeReported(world.timeStamp);
  pairs.merge();
  pairs.arrange(world.timeStamp);
  pairs.sorted.count = renewAll(world, pairs.sorted, dt);
  works?.smoothSeams(world);
  world.straddling.clear();
  partWedged(world);
  world.deep.clear();
  wakeHit(world);
}

/** @returns how many pairs are kept. Nothing follows the loop, see `refreshMoved`. */
function renewAll(world: World, { items, count }: List<Arbiter>, dt: number): number {
  let kept = 0;
  for (let i = 0; i < count; i += 1) {
    const pair = items[i]!;
    if (pair.is(DEAD) || pair.sleeping || !renew(world, pair, dt)) {
      pair.unmark(AWAKE);
      continue;
    }
    items[kept] = pair;
    kept += 1;
  }
  return kept;
}

/**
 * To be called before filters or joints change that decide which shapes may interact. Pairs that they keep apart at the first such change
 * in a step count as not reported in it, whether the broadphase reported them or not: some report pairs that they know.
 */
export function changeFilters(world: World): void {
  world.filters += 1;
  const { pairs, stepping, timeStamp } = world;
  if (!stepping || world.filtersChanged) {
    return;
  }
  world.filtersChanged = true;
  const { items, count } = pairs.sorted;
  for (let i = 0; i < count; i += 1) {
    const pair = items[i]!;
    if (pairs.isReported(pair, timeStamp) && areApart(pair.shapeA, pair.shapeB)) {
      pairs.overlook(pair);
    }
  }
}

/** Renews a pair: collides its shapes, and starts, continues or ends their interaction. @returns whether the pair is kept. */
function renew(world: World, pair: Arbiter, dt: number): boolean {
  const stamp = world.timeStamp;
  pair.unmark(NEAR);
  pair.foreseen = 0;
  if (pair.active && pair.bodyA.asleep && pair.bodyB.asleep) {
    sleepPair(world, pair);
    return false;
  }
  if (world.pairs.isExpired(pair, stamp)) {
    world.pairs.unlist(pair);
  }
  if (world.pairs.isReported(pair, stamp) && mayInteract(pair.shapeA, pair.shapeB)) {
    forgetLeft(pair);
    pair.seen = stamp;
  }
  const isReported = pair.seen === stamp;
  if (isReported && (pair.sensor ? sensorIntersects(pair) : updateManifold(pair))) {
    interact(world, pair);
    return true;
  }
  part(world, pair);
  if (isReported && pair.count > 0) {
    approach(world, pair, dt);
  }
  if (!isReported && !pair.is(LISTED)) {
    world.pairs.retire(pair);
    return false;
  }
  return true;
}

/** If a shape left its world and came back within a step, the pair forgets everything from before. */
function forgetLeft(pair: Arbiter): void {
  const { shapeA, shapeB, seen } = pair;
  if (!pair.is(LISTED) && seen >= 0 && seen <= Math.max(shapeA.entered, shapeB.entered)) {
    pair.reuse(shapeA, shapeB);
    pair.mark(AWAKE);
  }
}

function interact(world: World, pair: Arbiter): void {
  const stamp = world.timeStamp;
  const begins = pair.lastInteraction !== stamp - 1;
  if (!pair.is(LISTED)) {
    world.pairs.list(pair);
  }
  if (begins) {
    pair.unmark(PERSISTENT);
    pair.began = stamp;
  }
  pair.lastInteraction = stamp;
  pair.mark(ACTIVE);
  world.events.interaction(begins ? BEGIN : PROGRESS, pair, IN_STEP);
  if (pair.sensor) {
    return;
  }
  if (!preSolve(world, pair)) {
    return;
  }
  const a = pair.bodyA;
  const b = pair.bodyB;
  if (a.asleep && a.kind === DYNAMIC) {
    world.toWake.add(a);
  }
  if (b.asleep && b.kind === DYNAMIC) {
    world.toWake.add(b);
  }
  const { numbers: n, at: o } = pair;
  // Told here first: a call for each pair would take 2 to 4 % of a step.
  if (Math.min(n[o + g.S0]!, n[o + g.S1]!) < -WEDGED_DEPTH) noteDeep(world, pair);
  noteGround(world, pair);
  if (begins && world.events.isHitHeard(pair)) {
    noteApproach(pair);
    world.events.hit(pair, IN_STEP);
  }
}

/**
 * Gives shapes that are near each other to the solver, as a speculative contact. Not if one belongs to a sleeping dynamic body, which could
 * not give way, nor if `preSolve` handlers have to be asked first. What passes a static or kinematic body fast is given to it only if it
 * will meet it, see `foresee`: the nearest face may be one that it slides past.
 */
function approach(world: World, pair: Arbiter, dt: number): void {
  if (canGiveWay(pair.bodyA) && canGiveWay(pair.bodyB) && !asksFirst(pair)) {
    pair.mixMaterials();
    if (isForeseen(pair, dt)) {
      world.closing.add(pair);
    } else if (!passes(pair, dt)) {
      pair.mark(NEAR);
    }
    noteGround(world, pair);
    if (world.events.isHitHeard(pair)) {
      noteApproach(pair);
    }
  }
}

/**
 * Whether `foresee` is to find out if the bodies of a pair will meet: it does for a dynamic body and one that is not, if either goes far,
 * they hardly turn, and they do not bounce.
 */
function isForeseen({ shapeA, shapeB, numbers, at }: Arbiter, dt: number): boolean {
  const a = shapeA.owner!;
  const b = shapeB.owner!;
  return (
    (a.kind !== DYNAMIC || b.kind !== DYNAMIC) &&
    numbers[at + c.ELASTICITY]! <= 0 &&
    ((shapeA.isRound() ? 0 : Math.abs(a.w)) + (shapeB.isRound() ? 0 : Math.abs(b.w))) * dt <= SOLVED_TURN &&
    (goesFar(a, dt) || goesFar(b, dt))
  );
}

/** Ends the interaction of the shapes, if they interacted until now. */
function part(world: World, pair: Arbiter): void {
  if (pair.active) {
    pair.unmark(ACTIVE);
    pair.idle();
    world.events.interaction(END, pair, IN_STEP);
  }
}

function wakeHit(world: World): void {
  const { toWake } = world;
  for (let i = 0; i < toWake.count; i += 1) {
    wakeBody(world, toWake.items[i]!, false);
  }
  toWake.clear();
  world.pairs.merge();
  world.events.noteWoken(world);
}
