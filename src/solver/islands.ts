import type { RigidBody } from '../body.js';
import { DYNAMIC } from '../body-kind.js';
import { SLEEP_DELAY, SLEEP_RIM_SPEED_SQUARED, SLEEP_SPEED_SQUARED } from '../config.js';
import type { World } from '../world.js';
import { sleepIsland } from './sleep.js';

/** Where the islands of a step are worked out: arrays by index in `liveDynamics`, kept from step to step. */
export class IslandWork {
  /** Union-find: the way to the root, which is the lowest index of its island. */
  parent = new Int32Array(64);
  /** By root: the latest wake time of the island. */
  wakeTime = new Float64Array(64);
  /** By root: 1 if all its bodies have rested long enough. */
  ready = new Uint8Array(64);

  ensure(count: number): void {
    if (this.parent.length < count) {
      const size = Math.max(count, this.parent.length * 2);
      this.parent = new Int32Array(size);
      this.wakeTime = new Float64Array(size);
      this.ready = new Uint8Array(size);
    }
  }

  /** The root of an index, halving the path on the way (Tarjan & van Leeuwen 1984). */
  root(index: number): number {
    const parent = this.parent;
    let i = index;
    while (parent[i] !== i) {
      parent[i] = parent[parent[i]!]!;
      i = parent[i]!;
    }
    return i;
  }

  join(a: number, b: number): void {
    const rootA = this.root(a);
    const rootB = this.root(b);
    if (rootA < rootB) {
      this.parent[rootB] = rootA;
    } else {
      this.parent[rootA] = rootB;
    }
  }
}

/** All four: slow, and hardly moved in the last step, in place and at the rim. Without shapes the spin itself is judged. */
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
 * Joins the live dynamic bodies that touch into islands; those whose bodies have all rested for longer than the delay fall
 * asleep, the others share the latest wake time of their members.
 */
export function sleepIslands(world: World, dt: number): void {
  const live = world.liveDynamics;
  const count = live.length;
  const stamp = world.timeStamp;
  if (!world.allowSleeping || count === 0) {
    return;
  }
  for (const body of live) {
    body.refreshMass();
    if (!isAtRest(body, dt)) {
      body.wakeTime = stamp;
    }
  }
  const work = world.islandWork;
  work.ensure(count);
  const { parent, wakeTime, ready } = work;
  for (let i = 0; i < count; i += 1) {
    parent[i] = i;
    wakeTime[i] = 0;
    ready[i] = 1;
  }
  joinTouching(world, work);
  let someReady = false;
  for (let i = 0; i < count; i += 1) {
    const root = work.root(i);
    const woken = live[i]!.wakeTime;
    if (woken > wakeTime[root]!) wakeTime[root] = woken;
    if (stamp <= woken + SLEEP_DELAY) ready[root] = 0;
    else someReady = true;
  }
  for (let i = 0; i < count; i += 1) {
    live[i]!.wakeTime = wakeTime[work.root(i)]!;
  }
  if (someReady) {
    sleepReady(world, work);
  }
}

function joinTouching(world: World, work: IslandWork): void {
  for (const pair of world.pairs.sorted) {
    if (pair.isSolid()) {
      const a = pair.bodyA;
      const b = pair.bodyB;
      if (a.kind === DYNAMIC && b.kind === DYNAMIC && a.liveIndex >= 0 && b.liveIndex >= 0) {
        work.join(a.liveIndex, b.liveIndex);
      }
    }
  }
}

function sleepReady(world: World, work: IslandWork): void {
  const islands = new Map<number, RigidBody[]>();
  world.liveDynamics.forEach((body, i) => {
    const root = work.root(i);
    if (work.ready[root] === 1) {
      const members = islands.get(root);
      if (members === undefined) {
        islands.set(root, [body]);
      } else {
        members.push(body);
      }
    }
  });
  for (const members of islands.values()) {
    sleepIsland(world, members);
  }
}
