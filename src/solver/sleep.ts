import type { RigidBody } from '../body.js';
import { DYNAMIC, STATIC } from '../body-kind.js';
import type { Arbiter } from '../contact/arbiter.js';
import { IN_STEP } from '../events/events.js';
import type { World } from '../world.js';

/** Bodies that fell asleep together, and wake together. */
export interface Island {
  readonly bodies: RigidBody[];
}

/** The step that a wake counts for: the running one, or the next. */
function wakeStamp(world: World): number {
  return world.stepping ? world.timeStamp : world.timeStamp + 1;
}

/** Puts an awake body into the live list of its type, and its shapes among the moving ones. */
export function enliven(world: World, body: RigidBody): void {
  body.asleep = false;
  body.wakeTime = wakeStamp(world);
  const live = body.kind === DYNAMIC ? world.liveDynamics : world.liveKinematics;
  body.liveIndex = live.push(body) - 1;
  world.setHandlesStatic(body, false);
}

/** Takes a body out of its live list and its shapes from among the moving ones. */
export function quieten(world: World, body: RigidBody): void {
  const live = body.kind === DYNAMIC ? world.liveDynamics : world.liveKinematics;
  const last = live.pop()!;
  if (last !== body) {
    live[body.liveIndex] = last;
    last.liveIndex = body.liveIndex;
  }
  body.liveIndex = -1;
  body.slot = 0;
  body.lastDx = 0;
  body.lastDy = 0;
  body.lastTurn = 0;
  body.asleep = true;
  world.setHandlesStatic(body, true);
}

/** Wakes a body and what must wake with it. `silent`: no `wake` event for this very body. */
export function wakeBody(world: World, body: RigidBody, silent: boolean): void {
  if (body.kind !== STATIC && !body.asleep) {
    body.wakeTime = wakeStamp(world);
    return;
  }
  const island = body.island;
  if (island !== null) {
    for (const member of island.bodies) {
      member.island = null;
      rise(world, member, silent && member === body);
    }
    return;
  }
  const resting = restingOn(body);
  if (body.kind !== STATIC) {
    rise(world, body, silent);
  }
  for (const other of resting) {
    if (other.asleep && other.owner === world) {
      wakeBody(world, other, false);
    }
  }
}

function rise(world: World, body: RigidBody, silent: boolean): void {
  enliven(world, body);
  for (const shape of body.shapes) {
    for (const pair of shape.arbiters) {
      if (pair.sleeping) {
        wakePair(world, pair);
      }
    }
  }
  if (!silent && body.kind === DYNAMIC) {
    world.events.body('wake', body);
  }
}

/** Dynamic bodies in accepted contact with a body when they fell asleep. */
function restingOn(body: RigidBody): RigidBody[] {
  const found: RigidBody[] = [];
  for (const shape of body.shapes) {
    for (const pair of shape.arbiters) {
      if (pair.sleeping && pair.accepted) {
        const other = pair.shapeA === shape ? pair.bodyB : pair.bodyA;
        if (other.kind === DYNAMIC) {
          found.push(other);
        }
      }
    }
  }
  return found;
}

/** The interaction goes on where it was: the time asleep is no gap. Inside a step nothing has moved, so it holds for that step. */
function wakePair(world: World, pair: Arbiter): void {
  pair.sleeping = false;
  pair.active = true;
  pair.lastInteraction = world.timeStamp;
  world.pairs.arrive(pair);
  if (world.stepping) {
    pair.seen = world.timeStamp;
    world.events.interaction('progress', pair, IN_STEP);
  } else {
    joinLists(world, pair);
  }
}

/** `RigidBody.sleep` in a world: this one dynamic body, silently, keeping its velocity. */
export function sleepBody(world: World, body: RigidBody): void {
  if (body.kind === DYNAMIC && !body.asleep) {
    quieten(world, body);
    sleepPairs(world, body);
  }
}

/** An island at rest falls asleep: velocities end, events are queued. */
export function sleepIsland(world: World, bodies: RigidBody[]): void {
  const island: Island = { bodies };
  for (const body of bodies) {
    body.vx = 0;
    body.vy = 0;
    body.w = 0;
    body.island = island;
    quieten(world, body);
    world.events.body('sleep', body);
  }
  for (const body of bodies) {
    sleepPairs(world, body);
  }
}

/** Running interactions with something that sleeps as well stop costing anything. */
export function sleepPairs(world: World, body: RigidBody): void {
  for (const shape of body.shapes) {
    for (const pair of shape.arbiters) {
      if (pair.active && pair.bodyA.asleep && pair.bodyB.asleep) {
        pair.sleeping = true;
        pair.active = false;
        leaveLists(world, pair);
      }
    }
  }
}

/** Kinematic bodies that did not move in this step fall asleep, without an event. */
export function sleepKinematics(world: World): void {
  const live = world.liveKinematics;
  for (let i = live.length - 1; i >= 0; i -= 1) {
    const body = live[i]!;
    if (body.lastDx === 0 && body.lastDy === 0 && body.lastTurn === 0) {
      quieten(world, body);
      sleepPairs(world, body);
    }
  }
}

/** Puts an arbiter into the world's list that it belongs to. */
export function joinLists(world: World, pair: Arbiter): void {
  const dynamic = pair.bodyA.kind === DYNAMIC && pair.bodyB.kind === DYNAMIC;
  pair.listIndex = (dynamic ? world.dynamicArbiters : world.staticArbiters).push(pair) - 1;
}

/** Takes an arbiter out of the world's list that it is in. */
export function leaveLists(world: World, pair: Arbiter): void {
  removeFrom(world.dynamicArbiters, pair);
  removeFrom(world.staticArbiters, pair);
}

function removeFrom(list: Arbiter[], pair: Arbiter): void {
  const at = pair.listIndex;
  if (list[at] !== pair) {
    return;
  }
  const last = list.pop()!;
  if (last !== pair) {
    list[at] = last;
    last.listIndex = at;
  }
}
