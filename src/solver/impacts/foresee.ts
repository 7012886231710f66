import type { RigidBody } from '../../body.js';
import { STATIC } from '../../body-kind.js';
import { roundness } from '../../collide/along.js';
import * as g from '../../collide/layout.js';
import { findLeastSeparation, leastSeparation } from '../../collide/manifold.js';
import { works } from '../../collide/polygon-works.js';
import { CLEARANCE, SOLVED_TURN, SPECULATIVE_MARGIN } from '../../config.js';
import type { Arbiter } from '../../contact/arbiter.js';
import { NEAR } from '../../contact/bits.js';
import { noteApproach } from '../../contact/hit.js';
import * as c from '../../contact/layout.js';
import { makeNearestPoint, updateManifold } from '../../contact/update.js';
import { asksFirst } from '../../events/pre-solve.js';
import { cos, sin } from '../../math/trig.js';
import type { Shape } from '../../shape/shape.js';
import type { World } from '../../world.js';
import { findForces, forces } from '../forces.js';
import { canGiveWay } from '../interaction.js';
import type { Meeting } from './meeting-queue.js';
import { findMeetings, isClear, listWays } from './meetings.js';
import { goesFar, type Mover, type Movers } from './movers.js';

/**
 * Looks ahead before the step is solved. Where a fast body would first meet something, if nothing else happened, the contact is given to
 * the solver as a speculative one. So the body lands within the step, together with whatever it is joined to or carries, and no part of the
 * step is lost. What bounces, turns fast or needs a handler's consent, and whatever this misses, is left to the sweep of the true motion at
 * the end of the step, see `continuous.ts`.
 */
export function foresee(world: World, dt: number): void {
  const { movers, closing } = world;
  if (world.liveDynamics.length + world.liveKinematics.length === 0) {
    return;
  }
  movers.ahead = dt;
  movers.foreseenCount = 0;
  movers.bouncy = true;
  movers.alone = world.liveKinematics.length === 0;
  movers.space.begin();
  const average = (world.solver.substeps + 1) / (2 * world.solver.substeps);
  movers.forceTime = average * dt;
  movers.gravityGain = (Math.abs(world.gravityX) + Math.abs(world.gravityY)) * average * dt;
  foreseeBullets(world);
  foreseeKinematics(world, dt);
  listWays(movers, movers.count);
  for (let i = 0; i < world.liveDynamics.length; i += 1) {
    foreseeDynamic(world, world.liveDynamics[i]!);
  }
  if (movers.looking + closing.count > 0) {
    findMeetings(world);
    const { meetings } = movers;
    for (let next = meetings.first(); next !== null; next = meetings.first()) {
      meetings.remove(next);
      if (isFirst(world, next)) {
        open(world, next);
      }
    }
    for (let i = 0; i < closing.count; i += 1) {
      if (!closing.items[i]!.is(NEAR)) {
        // It slides onto something in which it will not get deep: the contact is that of the end of the step, when it lies on it.
        openAt(world, closing.items[i]!, 1);
      }
    }
    world.pairs.merge();
  }
  closing.clear();
  movers.clear();
}

/** Adds the bullets first, as others are swept against them: most bodies are clear of them. */
function foreseeBullets(world: World): void {
  const { movers, liveDynamics } = world;
  for (let i = 0; i < liveDynamics.length; i += 1) {
    const body = liveDynamics[i]!;
    if (body.isBullet) {
      movers.alone = false;
      foreseeFalling(world, body);
    }
  }
}

/**
 * Looks where a dynamic body is going. A function of its own: one that is called for each body is soon compiled, and one that loops over
 * them again and again is not.
 */
function foreseeDynamic(world: World, body: RigidBody): void {
  const { ahead, gravityGain } = world.movers;
  if (body.isBullet) {
    return;
  }
  const speed = Math.abs(body.vx) + Math.abs(body.vy) + Math.abs(body.w) * body.radius + gravityGain;
  if (speed * ahead > SPECULATIVE_MARGIN / 2 || body.hasForce()) {
    foreseeFalling(world, body);
  }
}

function foreseeKinematics({ movers, liveKinematics }: World, dt: number): void {
  for (let i = 0; i < liveKinematics.length; i += 1) {
    const body = liveKinematics[i]!;
    movers.add(body, goesFar(body, dt)).aim(movers);
  }
}

/** Adds a dynamic body that goes far, with what forces add on the average of the step. */
function foreseeFalling(world: World, body: RigidBody): void {
  const { movers } = world;
  const { ahead, forceTime } = movers;
  body.refreshMass();
  // As `inverseMass` and `inverseInertia`, which would have to box their results if they were called from here; below as `goesFar`.
  const inverseMass = body.mass > 0 ? 1 / body.mass : 0;
  const inverseInertia = body.inertia > 0 ? 1 / body.inertia : 0;
  findForces(body);
  const vx =
    body.vx + (inverseMass > 0 ? world.gravityX * body.gravityScale + forces[0]! * inverseMass : 0) * forceTime;
  const vy =
    body.vy + (inverseMass > 0 ? world.gravityY * body.gravityScale + forces[1]! * inverseMass : 0) * forceTime;
  const w = body.w + forces[2]! * inverseInertia * forceTime;
  const way = Math.abs(vx * ahead) + Math.abs(vy * ahead) + Math.abs(w * ahead) * body.radius;
  movers.space.reach = way + CLEARANCE;
  if (way > SPECULATIVE_MARGIN / 2 && (body.isBullet || !isClear(world, body))) {
    const mover = movers.add(body, true);
    mover.dx = vx;
    mover.dy = vy;
    mover.turn = w;
    goAlongContacts(world, mover, body);
    mover.foresee(movers);
  }
}

/**
 * Takes from the velocity of a mover what goes into the static bodies that it touches. Also sets `bouncy` to false if some of its shapes do
 * not bounce, or if it is a bullet and a handler may have set the elasticity of one of its contacts.
 */
function goAlongContacts({ movers, timeStamp }: World, mover: Mover, { shapes, isBullet }: RigidBody): void {
  for (let i = 0; i < shapes.length; i += 1) {
    const { material, arbiters, groundStamp, grounds } = shapes[i]!;
    movers.bouncy &&= material.elasticity > 0;
    for (let k = 0; k < arbiters.length && isBullet && movers.bouncy; k += 1) {
      movers.bouncy = arbiters[k]!.fixed === 0;
    }
    for (let pair = groundStamp === timeStamp ? grounds : null; pair !== null; pair = pair.next) {
      const sign = pair.bodyB.kind === STATIC ? 1 : -1;
      if (pair.isSolid() && (sign > 0 || pair.bodyA.kind === STATIC)) {
        const { numbers: n, at: o } = pair;
        // The normal points into the static body.
        const nx = sign * n[o + g.NX]!;
        const ny = sign * n[o + g.NY]!;
        const into = mover.dx * nx + mover.dy * ny;
        if (into > 0) {
          mover.dx -= into * nx;
          mover.dy -= into * ny;
        }
      }
    }
  }
}

/**
 * Whether a meeting, in the order of their times, is the first of each of its dynamic bodies, or is of shapes that are close already. What
 * lies behind the first, such as the next tile of a floor, the body may never get to.
 */
function isFirst(world: World, { a, b, time }: Meeting): boolean {
  const { movers } = world;
  // Both are asked in any case, as they note the time.
  const isFirstOfA = movers.of(a.owner!).comesFirst(time);
  const isFirstOfB = movers.of(b.owner!).comesFirst(time);
  return ((isFirstOfA && isFirstOfB) || isClose(world, a, b)) && canGiveWay(a.owner!) && canGiveWay(b.owner!);
}

/** Whether two shapes were found within the speculative margin in this step. */
function isClose(world: World, a: Shape, b: Shape): boolean {
  const pair = world.pairs.find(a, b);
  return pair !== null && pair.seen === world.timeStamp && pair.count > 0;
}

/** Opens a contact as it will be when the shapes meet, with the separation that they have before. */
function open(world: World, { a, b, time }: Meeting): void {
  const pair = world.pairs.obtain(a, b);
  pair.mixMaterials();
  if (asksFirst(pair) || pair.numbers[pair.at + c.ELASTICITY]! > 0) {
    return;
  }
  if (isClose(world, a, b)) {
    pair.mark(NEAR);
    return;
  }
  const one = world.movers.of(a.owner!);
  const two = world.movers.of(b.owner!);
  if ((a.isRound() ? 0 : one.spin) + (b.isRound() ? 0 : two.spin) > SOLVED_TURN) {
    return;
  }
  openAt(world, pair, time);
}

function openAt(world: World, pair: Arbiter, time: number): void {
  const { shapeA: a, shapeB: b } = pair;
  const one = world.movers.of(a.owner!);
  const two = world.movers.of(b.owner!);
  one.moveBodyTo(time);
  two.moveBodyTo(time);
  a.place(one.body);
  b.place(two.body);
  const isApart = !updateManifold(pair);
  if (isApart && time < 1) {
    makeNearestPoint(pair);
  }
  works?.smoothMeeting(world, pair);
  // If `smoothMeeting` turned the contact, it would meet a surface that it does not touch.
  findLeastSeparation(pair.numbers, pair.at);
  const isLost = isApart && time === 1 && leastSeparation[0]! <= 0;
  if (world.events.isHitHeard(pair)) {
    noteApproach(pair);
  }
  pair.foreseen = world.movers.foreseeContact();
  moveBack(world.movers, pair, one, two, time);
  one.moveBodyTo(0);
  two.moveBodyTo(0);
  a.place(one.body);
  b.place(two.body);
  works?.putGroundsBack(world, pair);
  pair.put(NEAR, pair.count > 0 && !isLost);
  if (!pair.is(NEAR)) pair.foreseen = 0;
}

/**
 * Gives the points of a contact the separation with which they meet at that time, as the solver follows them from the start of the step.
 */
function moveBack(
  { foresight }: Movers,
  { shapeA, shapeB, count, numbers: n, at: o, foreseen }: Arbiter,
  a: Mover,
  b: Mover,
  time: number,
): void {
  const nx = n[o + g.NX]!;
  const ny = n[o + g.NY]!;
  const way = time * (nx * (b.dx - a.dx) + ny * (b.dy - a.dy));
  const turnA = time * a.turn;
  const turnB = time * b.turn;
  for (let i = 0; i < count; i += 1) {
    const ax = n[o + g.X0 + g.POINT * i]!;
    const ay = n[o + g.Y0 + g.POINT * i]!;
    const separation = n[o + g.S0 + g.POINT * i]!;
    const bx = ax - n[o + g.DX]!;
    const by = ay - n[o + g.DY]!;
    const swingA = swing(turnA, ax * nx + ay * ny - roundness(shapeA, separation), ax * ny - ay * nx);
    const swingB = swing(turnB, bx * nx + by * ny + roundness(shapeB, separation), bx * ny - by * nx);
    const turned = swingB - swingA;
    foresight[2 * foreseen + i] = way + turned;
    n[o + g.S0 + g.POINT * i] = separation - way - turned;
  }
}

/** How far a turn moves the end of an arm along a direction. `length` and `across` are the components of the arm along and across it. */
function swing(turn: number, length: number, across: number): number {
  return (cos(turn) - 1) * length + sin(turn) * across;
}

/** Of shapes that have met: restores the separations of the placement for which the points were found. */
export function endForesight({ foresight }: Movers, { count, numbers: n, at: o, foreseen }: Arbiter): void {
  for (let i = 0; i < count; i += 1) {
    n[o + g.S0 + g.POINT * i] = n[o + g.S0 + g.POINT * i]! + foresight[2 * foreseen + i]!;
  }
}
