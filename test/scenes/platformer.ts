import type { Physics2DDevice, RigidBody, Shape, Vec2, World } from '../../src/index.js';
import { cos } from '../../src/math/trig.js';
import { Builder, type Controls, friction, type Play } from './play.js';

export interface Platformer extends Play {
  readonly player: RigidBody;
  readonly platforms: readonly RigidBody[];
  /** How many coins are taken. */
  readonly coins: () => number;
}

/** m/s, and m/s². Of the player: running, jumping, getting up to speed on the ground and in the air. */
const [RUN, JUMP, GRIP, STEER] = [6, 9, 60, 25];

interface Mover {
  readonly body: RigidBody;
  readonly from: Vec2;
  readonly to: Vec2;
  /** s, there and back. */
  readonly period: number;
}

/** A player on tiles, with platforms that move, one-way ledges, crates and coins. */
export function buildPlatformer(phys2D: Physics2DDevice, world: World): Platformer {
  const yard = new Builder(phys2D, world);
  for (let x = -9; x < 27; x += 1) {
    const isPit = x > 4 && x < 11;
    yard.wall(x, isPit ? 3 : 0, x + 1, isPit ? 4 : 1, { surface: friction(0.6) });
  }
  yard.wall(-10, -8, -9, 1);
  yard.wall(27, -8, 28, 1);
  yard.wall(4.7, 0, 5, 3);
  yard.wall(11, 0, 11.3, 3);
  const player = yard.box(-8.2, -0.8, 0.7, 1.4, { inertia: Infinity, linearDrag: 0, surface: friction(0) });
  const ledge = (x: number, y: number): RigidBody => {
    const body = yard.wall(x, y, x + 3, y + 0.25, { surface: friction(0.6) });
    makeOneWay(body.shapes[0]!);
    return body;
  };
  ledge(-3, -1.8);
  ledge(-7, -3.6);
  ledge(17, -2);
  const movers = buildMovers(yard);
  for (const [x, y] of [
    [1, -0.35],
    [1, -1.05],
    [14, -0.35],
    [15, -0.35],
    [14.5, -1.05],
  ] as const) {
    yard.box(x, y, 0.7, 0.7, { surface: { ...friction(0.5), density: 0.5 } });
  }
  const coins = buildCoins(yard, player);
  const beforeStep = (controls: Readonly<Controls>): void => {
    const time = world.simulatedTime + 1 / 60;
    for (const { body, from, to, period } of movers) {
      const share = (1 - cos((2 * Math.PI * time) / period)) / 2;
      const target: Vec2 = [from[0] + share * (to[0] - from[0]), from[1] + share * (to[1] - from[1])];
      body.setVelocityFromPosition(target, 0, 1 / 60);
    }
    move(world, player, controls);
  };
  return { player, platforms: movers.map(({ body }) => body), coins, beforeStep, follow: player };
}

function buildMovers(yard: Builder): Mover[] {
  const mover = (from: Vec2, to: Vec2, period: number): Mover => {
    const body = yard.box(...from, 2, 0.3, { type: 'kinematic', surface: friction(0.9) });
    return { body, from, to, period };
  };
  return [mover([6.2, -0.2], [9.8, -0.2], 6), mover([22, 0], [22, -4.4], 7), mover([12.4, -2.4], [7, -3.6], 8)];
}

function buildCoins(yard: Builder, player: RigidBody): () => number {
  let coins = 0;
  for (const [x, y] of [
    [-5.5, -4.3],
    [-1.5, -2.5],
    [6.5, -1.2],
    [8, -1.6],
    [9.5, -1.2],
    [18.5, -2.8],
    [22, -5.6],
  ] as const) {
    const coin = yard.disc(x, y, 0.22, { type: 'static', shape: { sensor: true } });
    coin.shapes[0]!.addEventListener('begin', (_arbiter, other) => {
      coins += other.body === player && yard.world.removeRigidBody(coin) ? 1 : 0;
    });
  }
  return () => coins;
}

/** What was above it a step ago is borne until it leaves, all else may pass. */
function makeOneWay(ledge: Shape): void {
  const top = ledge.body!.computeWorldBounds()[1];
  ledge.addEventListener('preSolve', (arbiter, other) => {
    const body = other.body!;
    const [x] = body.getPosition();
    const [, speed] = body.getVelocity();
    const falls = arbiter.contacts.map((contact) => speed + body.getAngularVelocity() * (contact.getPosition()[0] - x));
    arbiter.setAcceptedState(body.computeWorldBounds()[3] - Math.max(0, ...falls) / 60 <= top + 0.03);
    arbiter.setPersistentState(true);
  });
}

/** What the player stands on, or `null`: the nearest below either foot. */
function groundOf(world: World, player: RigidBody): RigidBody | null {
  const [x, y] = player.getPosition();
  for (const side of [-0.3, 0.3]) {
    const ray = { origin: [x + side, y + 0.6], direction: [0, 1], maxFactor: 0.18 };
    const found = world.rayCast(ray, false, (_, { shape }) => shape.body !== player && !shape.sensor);
    if (found !== null) {
      return found.shape.body;
    }
  }
  return null;
}

/** Runs as fast as is held down, against what it stands on; jumps from the ground only. */
function move(world: World, player: RigidBody, { left, right, up }: Readonly<Controls>): void {
  const ground = groundOf(world, player);
  const [vx, vy] = player.getVelocity();
  const base = ground === null ? [vx, vy] : ground.getVelocity();
  const wanted = (right ? RUN : 0) - (left ? RUN : 0);
  const change = (ground === null ? STEER : GRIP) / 60;
  const target = ground === null ? (wanted === 0 ? vx : wanted) : base[0]! + wanted;
  const next = vx + Math.min(change, Math.max(-change, target - vx));
  const jumps = up && ground !== null && vy > base[1]! - 1;
  if (next !== vx || jumps) {
    player.setVelocity([next, jumps ? base[1]! - JUMP : vy]);
  }
}
