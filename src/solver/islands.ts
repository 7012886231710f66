import type { RigidBody } from '../body.js';
import { DYNAMIC } from '../body-kind.js';
import { findLeastSeparation, leastSeparation } from '../collide/manifold.js';
import { CONTACT_SLOP, REST_RATE, SLEEP_DELAY, SLEEP_RIM_SPEED_SQUARED, SLEEP_SPEED_SQUARED } from '../config.js';
import type { Arbiter } from '../contact/arbiter.js';
import { NEAR } from '../contact/bits.js';
import { grown } from '../math/doubles.js';
import { rootOf, unite } from '../math/sets.js';
import type { World } from '../world.js';
import { isPushedAnew } from './forces.js';
import { acts } from './joints/order/order.js';
import { type Island, isLiveDynamic, sleepIsland } from './sleep.js';

/** Where the islands of a step are worked out: arrays by index in `liveDynamics`, kept from step to step. */
export class IslandWork {
  /** Sets of `math/sets.ts`: the root of an island is its lowest index. */
  parent = new Int32Array(64);
  /** By root: the latest wake time of the island. Integers: other numbers would be boxed, here and in the bodies that get them. */
  wakeTime = new Int32Array(64);
  /** By root: 1 if all its bodies have rested long enough. */
  ready = new Uint8Array(64);
  /** How many islands of the step stay awake. */
  awake = 0;

  ensure(count: number): void {
    if (this.parent.length < count) {
      const size = grown(count);
      this.parent = new Int32Array(size);
      this.wakeTime = new Int32Array(size);
      this.ready = new Uint8Array(size);
    }
  }
}

/**
 * Whether a body is at rest: its velocity and its motion in the last step are both small, at the centre and at the rim. Without shapes the
 * angular velocity itself counts.
 */
function isAtRest(body: RigidBody, dt: number): boolean {
  const rim = body.radius > 0 ? body.radius : 1;
  const w = body.w * rim;
  const turn = body.lastTurn * rim;
  return (
    body.vx * body.vx + body.vy * body.vy <= SLEEP_SPEED_SQUARED &&
    body.lastDx * body.lastDx + body.lastDy * body.lastDy <= SLEEP_SPEED_SQUARED * dt * dt &&
    w * w <= SLEEP_RIM_SPEED_SQUARED &&
    turn * turn <= SLEEP_RIM_SPEED_SQUARED * dt * dt
  );
}

/**
 * Whether a step counts towards the rest of bodies. Of steps shorter than 1 / REST_RATE only as many count as there would be of that
 * length: in slow motion what swings is slow for many steps where it turns back.
 */
function countsAsRest(time: number, dt: number): boolean {
  return REST_RATE * dt >= 1 || Math.floor(REST_RATE * time) > Math.floor(REST_RATE * (time - dt));
}

/**
 * Joins the live dynamic bodies that touch into islands. Those whose bodies have all rested for longer than the delay fall asleep, the
 * others share the latest wake time of their members.
 */
export function sleepIslands(world: World, dt: number): void {
  const live = world.liveDynamics;
  const count = live.length;
  const stamp = world.timeStamp;
  const work = world.islandWork;
  work.awake = 0;
  if (!world.allowSleeping || count + world.liveConstraints.length === 0) {
    return;
  }
  const waits = !countsAsRest(world.simulatedTime, dt);
  for (let i = 0; i < live.length; i += 1) {
    const body = live[i]!;
    body.refreshMass();
    if (!body.mayRest || !isAtRest(body, dt) || isPushedAnew(body, dt)) {
      body.wakeTime = stamp;
    } else if (waits && body.wakeTime < stamp) {
      body.wakeTime += 1;
    }
  }
  world.jointSolver?.keepDriven(world);
  work.ensure(count);
  const { parent, wakeTime, ready } = work;
  for (let i = 0; i < count; i += 1) {
    parent[i] = i;
    wakeTime[i] = 0;
    ready[i] = 1;
  }
  joinTouching(world, parent);
  world.jointSolver?.joinTied(world, parent);
  let someReady = false;
  for (let i = 0; i < count; i += 1) {
    const root = rootOf(parent, i);
    const woken = live[i]!.wakeTime;
    if (woken > wakeTime[root]!) wakeTime[root] = woken;
    if (stamp <= woken + SLEEP_DELAY) ready[root] = 0;
    else someReady = true;
  }
  for (let i = 0; i < count; i += 1) {
    live[i]!.wakeTime = wakeTime[rootOf(parent, i)]!;
    work.awake += parent[i] === i && ready[i] === 0 ? 1 : 0;
  }
  if (someReady) {
    sleepReady(world, work);
  }
  world.jointSolver?.sleepIdle(world);
}

/**
 * Whether bodies touch, or are closer than half the contact slop. What trembles is apart for a step now and then; a ball that lies on it
 * would fall asleep by itself, and hang in the air once it goes.
 */
function areTogether(pair: Arbiter): boolean {
  const isSolid = pair.isSolid();
  if (isSolid || !pair.is(NEAR)) {
    return isSolid;
  }
  findLeastSeparation(pair.numbers, pair.at);
  return leastSeparation[0]! < CONTACT_SLOP / 2;
}

/** Joins what touches. What touches a kinematic body that moves, or was just put there, is not at rest. */
function joinTouching(world: World, parent: Int32Array): void {
  const stamp = world.timeStamp;
  const { sorted } = world.pairs;
  for (let i = 0; i < sorted.count; i += 1) {
    const pair = sorted.items[i]!;
    if (areTogether(pair)) {
      const a = pair.bodyA;
      const b = pair.bodyB;
      if (a.liveIndex < 0 || b.liveIndex < 0) {
        continue;
      }
      if (a.kind !== DYNAMIC) {
        b.wakeTime = stamp;
      } else if (b.kind !== DYNAMIC) {
        a.wakeTime = stamp;
      } else {
        unite(parent, a.liveIndex, b.liveIndex);
      }
    }
  }
}

function sleepReady(world: World, { parent, ready }: IslandWork): void {
  const islands = new Map<number, Island>();
  world.liveDynamics.forEach((body, i) => {
    const root = rootOf(parent, i);
    if (ready[root] === 1) {
      const island = islands.get(root);
      if (island === undefined) {
        islands.set(root, { number: -1, bodies: [body], constraints: [] });
      } else {
        island.bodies.push(body);
      }
    }
  });
  for (const constraint of world.liveConstraints) {
    const body = constraint.members.find(isLiveDynamic);
    if (body !== undefined && acts(world, constraint)) {
      islands.get(rootOf(parent, body.liveIndex))?.constraints.push(constraint);
    }
  }
  for (const island of islands.values()) {
    sleepIsland(world, island);
  }
}
