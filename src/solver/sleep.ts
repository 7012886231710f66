import type { RigidBody } from '../body.js';
import { DYNAMIC, STATIC } from '../body-kind.js';
import type { Constraint } from '../constraint/constraint.js';
import type { Arbiter } from '../contact/arbiter.js';
import { ACCEPTED, ACTIVE, SLEEPING } from '../contact/bits.js';
import { IN_STEP } from '../events/events.js';
import { PROGRESS, SLEEP } from '../listeners.js';
import { takeOut } from '../math/list.js';
import type { World } from '../world.js';
import { joinLists } from './arbiter-lists.js';
import { updateHandles } from './refresh.js';

/** Bodies and constraints that fell asleep together, and wake together. */
export interface Island {
  /** Scratch: its number while the state of the world is saved. */
  number: number;
  readonly bodies: RigidBody[];
  readonly constraints: Constraint[];
}

/** Whether a body is dynamic and awake in its world. */
export function isLiveDynamic({ kind, liveIndex }: RigidBody): boolean {
  return kind === DYNAMIC && liveIndex >= 0;
}

/** The step that a wake counts for: the running one, or the next. */
function wakeStamp(world: World): number {
  return world.stepping ? world.timeStamp : world.timeStamp + 1;
}

/** Wakes a body: puts it into the live list of its type, tells the broadphase, and continues its interactions. */
export function enliven(world: World, body: RigidBody): void {
  body.asleep = false;
  body.wakeTime = wakeStamp(world);
  const live = body.kind === DYNAMIC ? world.liveDynamics : world.liveKinematics;
  body.liveIndex = live.push(body) - 1;
  world.jointsTouched = true;
  updateHandles(world, body);
  for (const shape of body.shapes) {
    for (const pair of shape.arbiters) {
      if (pair.sleeping) {
        wakePair(world, pair);
      } else if (world.stepping && pair.active && (pair.bodyA.asleep || pair.bodyB.asleep)) {
        // It was not reported, as both were asleep when the step began.
        pair.seen = world.timeStamp;
      }
    }
  }
}

/** Takes a body out of its live list, and tells the broadphase that its shapes rest. */
export function quieten(world: World, body: RigidBody): void {
  const live = body.kind === DYNAMIC ? world.liveDynamics : world.liveKinematics;
  const moved = takeOut(live, body.liveIndex);
  if (moved !== null) moved.liveIndex = body.liveIndex;
  body.liveIndex = -1;
  world.jointsTouched = true;
  body.slot = 0;
  body.forgetMotion();
  body.asleep = true;
  updateHandles(world, body);
}

/** Puts a constraint into the live list. */
export function enlivenConstraint(world: World, constraint: Constraint): void {
  constraint.asleep = false;
  constraint.liveIndex = world.liveConstraints.push(constraint) - 1;
  world.jointsStale = true;
}

/** Takes a constraint out of the live list. */
export function quietenConstraint(world: World, constraint: Constraint): void {
  const moved = takeOut(world.liveConstraints, constraint.liveIndex);
  if (moved !== null) moved.liveIndex = constraint.liveIndex;
  constraint.liveIndex = -1;
  constraint.asleep = true;
  constraint.given.fill(0);
  world.jointsStale = true;
}

/** Wakes a body and what must wake with it. `silent`: no `wake` event for this very body. */
export function wakeBody(world: World, body: RigidBody, silent: boolean): void {
  if (body.asleep) spreadWake(world, body, silent);
  else stir(world, body);
}

/**
 * Keeps an awake body awake, and what touches it. That may be without support from now on, and nothing else notices if the body is lowered
 * so slowly that what lies on it rests meanwhile.
 */
function stir(world: World, body: RigidBody): void {
  const stamp = wakeStamp(world);
  body.wakeTime = stamp;
  const { shapes } = body;
  for (let i = 0; i < shapes.length; i += 1) {
    const { arbiters } = shapes[i]!;
    for (let k = 0; k < arbiters.length; k += 1) {
      const pair = arbiters[k]!;
      // Tested first: most interactions are over, and then the memory of nothing else has to be waited for.
      if (!pair.isSolid()) continue;
      const other = pair.bodyA === body ? pair.bodyB : pair.bodyA;
      if (other.kind === DYNAMIC && !other.asleep) other.wakeTime = stamp;
    }
  }
}

/** Wakes everything that can move, and whatever sleeps. */
export function wakeAll(world: World): void {
  for (const body of world.rigidBodies) {
    if (body.kind === DYNAMIC || body.asleep) wakeBody(world, body, false);
  }
  for (const constraint of world.constraints) {
    if (constraint.asleep) wakeConstraint(world, constraint, false);
  }
}

/** Wakes the bodies of an arbiter, without events for either. */
export function wakeBoth(world: World, { bodyA, bodyB }: Arbiter): void {
  const { woken } = bodyB;
  spreadWake(world, bodyA, true);
  spreadWake(world, bodyB, true);
  bodyB.woken = woken;
}

/** Wakes a constraint and its dynamic bodies. `silent`: no `wake` event for the constraint itself. */
export function wakeConstraint(world: World, constraint: Constraint, silent: boolean): void {
  if (constraint.enabled) {
    spreadWake(world, constraint, silent);
  }
}

/** Wakes something, what must wake with it, what must wake with that, and so on. A list and no recursion, as the chain can be long. */
function spreadWake(world: World, start: RigidBody | Constraint, silent: boolean): void {
  const { woken } = start;
  const found: (RigidBody | Constraint)[] = [start];
  for (const next of found) {
    if ('shapes' in next) {
      spreadFromBody(world, next, found);
    } else {
      spreadFromConstraint(world, next, found);
    }
  }
  if (silent) {
    start.woken = woken;
  }
}

function spreadFromBody(world: World, body: RigidBody, found: (RigidBody | Constraint)[]): void {
  if (!body.asleep) {
    body.wakeTime = wakeStamp(world);
    return;
  }
  if (body.island !== null) {
    raiseIsland(world, body.island, found);
    return;
  }
  for (const other of neighboursOf(body)) {
    if (other.asleep) {
      found.push(other);
    } else {
      other.wakeTime = wakeStamp(world);
    }
  }
  if (body.kind !== STATIC) {
    rise(world, body, found);
  } else {
    pushSleepingTies(world, body, found);
  }
}

function spreadFromConstraint(world: World, constraint: Constraint, found: (RigidBody | Constraint)[]): void {
  if (constraint.island !== null) {
    raiseIsland(world, constraint.island, found);
    return;
  }
  if (constraint.asleep) {
    riseConstraint(world, constraint);
  }
  for (const body of constraint.members) {
    if (body.kind === DYNAMIC && body.owner === world) {
      found.push(body);
    }
  }
}

/** Wakes an island as a whole, and with it what was put to sleep by hand: constraints on its bodies, bodies of its constraints. */
function raiseIsland(world: World, island: Island, found: (RigidBody | Constraint)[]): void {
  for (const constraint of island.constraints) {
    if (constraint.island === island) {
      constraint.island = null;
      riseConstraint(world, constraint);
      found.push(constraint);
    }
  }
  for (const body of island.bodies) {
    if (body.island === island) {
      body.island = null;
      rise(world, body, found);
    }
  }
}

function riseConstraint(world: World, constraint: Constraint): void {
  enlivenConstraint(world, constraint);
  world.events.woke(constraint);
}

function rise(world: World, body: RigidBody, found: (RigidBody | Constraint)[]): void {
  enliven(world, body);
  world.events.woke(body);
  pushSleepingTies(world, body, found);
}

function pushSleepingTies(world: World, body: RigidBody, found: (RigidBody | Constraint)[]): void {
  for (const constraint of body.constraints) {
    if (constraint.asleep && constraint.enabled && constraint.owner === world) {
      found.push(constraint);
    }
  }
}

/** Dynamic bodies that touch a body, in contacts that were accepted. */
export function neighboursOf({ shapes }: RigidBody): RigidBody[] {
  const found: RigidBody[] = [];
  for (const shape of shapes) {
    for (const pair of shape.arbiters) {
      const other = pair.shapeA === shape ? pair.bodyB : pair.bodyA;
      if (other.kind === DYNAMIC && (pair.active || pair.sleeping) && pair.is(ACCEPTED)) {
        found.push(other);
      }
    }
  }
  return found;
}

/** Continues an interaction that slept: the time asleep is no gap. Within a step nothing has moved yet, so it holds for that step. */
function wakePair(world: World, pair: Arbiter): void {
  pair.unmark(SLEEPING);
  pair.mark(ACTIVE);
  world.pairs.arrive(pair);
  joinLists(world, pair);
  if (world.stepping) {
    pair.seen = world.timeStamp;
    tellProgress(world, pair);
  } else {
    const isHeld = pair.isHeld();
    pair.lastInteraction = world.timeStamp;
    if (isHeld) pair.hold();
  }
}

/** Tells `progress` of a pair that was woken or falls asleep, unless it had its event in this step. */
function tellProgress(world: World, pair: Arbiter): void {
  if (pair.lastInteraction !== world.timeStamp) {
    pair.lastInteraction = world.timeStamp;
    world.events.interaction(PROGRESS, pair, IN_STEP);
  }
}

/** `RigidBody.sleep` in a world: this one dynamic body, without an event, keeping its velocity. */
export function sleepBody(world: World, body: RigidBody): void {
  if (body.kind === DYNAMIC && !body.asleep) {
    body.applied?.clear();
    quieten(world, body);
  }
}

/** `Constraint.sleep` in a world: this one constraint, without an event. */
export function sleepConstraint(world: World, constraint: Constraint): void {
  if (constraint.enabled && !constraint.asleep) {
    quietenConstraint(world, constraint);
  }
}

/** An island at rest falls asleep: velocities end, events are queued. */
export function sleepIsland(world: World, island: Island): void {
  const { bodies, constraints } = island;
  for (const constraint of constraints) {
    constraint.island = island;
    quietenConstraint(world, constraint);
    world.events.constraint(SLEEP, constraint);
  }
  for (const body of bodies) {
    body.vx = 0;
    body.vy = 0;
    body.w = 0;
    body.island = island;
    body.applied?.pass();
    quieten(world, body);
    world.events.body(SLEEP, body);
  }
  for (const body of bodies) {
    sleepPairs(world, body);
  }
}

/** Puts interactions to sleep whose bodies both sleep: they cost nothing from then on. */
function sleepPairs(world: World, body: RigidBody): void {
  for (const shape of body.shapes) {
    for (const pair of shape.arbiters) {
      if (pair.active && pair.bodyA.asleep && pair.bodyB.asleep) {
        sleepPair(world, pair);
      }
    }
  }
}

/** Puts an interaction to sleep with its bodies, in the step in which they fall asleep or in the next, with a last `progress`. */
export function sleepPair(world: World, pair: Arbiter): void {
  pair.mark(SLEEPING);
  pair.unmark(ACTIVE);
  pair.idle();
  tellProgress(world, pair);
}

/** Puts kinematic bodies to sleep that did not move in this step, without an event. Not those that a handler set in motion meanwhile. */
export function sleepKinematics(world: World): void {
  const live = world.liveKinematics;
  for (let i = live.length - 1; i >= 0 && world.allowSleeping; i -= 1) {
    const body = live[i]!;
    if (body.mayRest && !body.isGoing() && body.lastDx === 0 && body.lastDy === 0 && body.lastTurn === 0) {
      quieten(world, body);
    }
  }
}
