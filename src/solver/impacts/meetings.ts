import type { RigidBody } from '../../body.js';
import { DYNAMIC, KINEMATIC, STATIC } from '../../body-kind.js';
import * as g from '../../collide/layout.js';
import { findLeastSeparation, leastSeparation } from '../../collide/manifold.js';
import { works } from '../../collide/polygon-works.js';
import { CONTACT_SLOP, SAME_TIME } from '../../config.js';
import type { Arbiter } from '../../contact/arbiter.js';
import { ACCEPTED, NEAR } from '../../contact/bits.js';
import * as c from '../../contact/layout.js';
import { crossing, REACHED } from '../../geometry/crossing.js';
import { materials } from '../../material.js';
import type { Shape } from '../../shape/shape.js';
import { POLYGON } from '../../shape/shape-kind.js';
import type { World } from '../../world.js';
import { growBounds } from '../bounds.js';
import { mayInteract } from '../interaction.js';
import { findNearby } from '../nearby.js';
import type { Meeting } from './meeting-queue.js';
import { findTime, isSensed, meets } from './meeting-time.js';
import type { Mover, Movers } from './movers.js';
import { areElastic, findRequiredDepth, mayBeRefused, required } from './required-depth.js';
import { mayMeet, squareOfWay, sweepBounds, widenBounds } from './swept-bounds.js';

const bounds = /* @__PURE__ */ new Float64Array(4);
const around = /* @__PURE__ */ new Float64Array(4);

/**
 * Finds everything that meets, and would get deep into each other, if nothing else met before. Kinematic bodies that are awake have movers;
 * while a step is foreseen, the ways are listed.
 */
export function findMeetings(world: World): void {
  const { movers } = world;
  const { count } = movers;
  // Then no two of the bodies that move far are foreseen to meet, as what bounces never is.
  const isBouncy = movers.bouncy && world.liveKinematics.length === 0;
  movers.meetings.clear();
  for (let i = 0; i < count; i += 1) {
    const mover = movers.all[i]!;
    if (mover.looks && (!isBouncy || materials.someDeaden || !meetsMovers(mover))) {
      meetStill(world, mover, count);
      if (movers.ahead === 0 && world.liveKinematics.length === 0) shorten(world, mover);
    }
  }
  if (movers.ahead === 0) listWays(movers, count);
  for (let i = 0; i < count && movers.ways.count > 0 && !isBouncy; i += 1) {
    meetWays(world, i);
  }
}

/** Lists the ways of those of the first `count` movers against which moving bodies are swept: kinematic bodies and fast bullets. */
export function listWays(movers: Movers, count: number): void {
  const { ways } = movers;
  ways.clear();
  for (let i = 0; i < count; i += 1) {
    const mover = movers.all[i]!;
    if (!meetsMovers(mover)) {
      continue;
    }
    const { shapes } = mover.body;
    for (let k = 0; k < shapes.length; k += 1) {
      sweepBounds(mover, shapes[k]!, bounds);
      ways.add(shapes[k]!, i, bounds);
    }
  }
}

/**
 * Whether nothing against which a body that is no bullet might be swept is near it, wherever it goes in this step, which is no farther than
 * `reach` of the clear space. Then it need not be looked at, now or at the end of the step. Bullets that reach it all the same are swept
 * themselves.
 */
export function isClear(world: World, body: RigidBody): boolean {
  const { alone, space } = world.movers;
  if (!(alone && space.holds(body))) {
    if (alone) space.search(world, body);
    for (let i = 0; i < body.shapes.length; i += 1) {
      growBounds(body.shapes[i]!, space, bounds);
      if (comesNear(world.movers) || !isAmidSensors(world, body.shapes[i]!)) {
        return false;
      }
    }
  }
  body.clearance = space.reach;
  return true;
}

/**
 * Whether everything that is still and may come into `bounds` is a sensor that the shape is in already: zones, which take no notice of its
 * way.
 */
function isAmidSensors(world: World, shape: Shape): boolean {
  const { nearby } = world.movers;
  for (let k = findNearby(world, bounds, false) - 1; k >= 0; k -= 1) {
    const other = nearby.shapes[k]!;
    if (!other.sensor || !world.pairs.find(shape, other)?.active) {
      return false;
    }
  }
  return true;
}

/** Whether bounds lie beyond an edge of a shape all the time that it is on its way. */
function liesBeyond(mover: Mover, shape: Shape, there: Float64Array): boolean {
  return shape.kind === POLYGON && works!.isBeyondEdge(mover, shape, there);
}

/** Whether a kinematic shape or a bullet may come into `bounds` on its way. */
function comesNear({ all, ways }: Movers): boolean {
  const size = ways.find(bounds);
  for (let i = 0; i < size; i += 1) {
    const way = ways.found[i]!;
    if (!liesBeyond(all[ways.movers[way]!]!, ways.shapes[way]!, bounds)) {
      return true;
    }
  }
  return false;
}

/**
 * Notes what a mover may meet that has no way: static and sleeping bodies, and other bodies that do not look, if it is swept against those.
 */
function meetStill(world: World, mover: Mover, count: number): void {
  const { movers } = world;
  const { shapes, kind } = mover.body;
  const areAllMovers = count === world.liveDynamics.length + world.liveKinematics.length;
  for (let i = 0; i < shapes.length; i += 1) {
    const shape = shapes[i]!;
    if (isUnforeseen(movers, shape)) continue;
    sweepBounds(mover, shape, bounds);
    const size = findNearby(world, bounds, !areAllMovers && meetsMovers(mover), count, shape);
    for (let k = 0; k < size; k += 1) {
      const other = movers.nearby.shapes[k]!;
      if (kind === DYNAMIC || !isPassed(world, mover, shape, other)) {
        note(world, shape, other);
      }
    }
  }
}

/**
 * Shortens the search of a mover. What meets something static stops there for the rest of the step, unless something stops it before, and
 * where nothing is kinematic nothing carries it on. So two bullets in rooms of their own cannot reach each other, and of several walls in a
 * row only the first is met.
 */
function shorten(world: World, mover: Mover): void {
  const { meetings } = world.movers;
  let first = mover.earliestMeeting();
  while (first?.isEstimate && first.time < Infinity) {
    findTime(world, first);
    first = mover.earliestMeeting();
  }
  // Not `first?.time`: a number that may be undefined is boxed.
  if (first !== null && first.time === Infinity) {
    findApart(world, mover);
    first = mover.earliestMeeting();
  }
  if (first === null || first.time === Infinity || !stops(world, first)) {
    return;
  }
  mover.until = first.time;
  for (let other = mover.newestMeeting; other !== null; other = other.nextOf(mover)) {
    if (other.slot >= 0 && other.time > first.time + SAME_TIME && isWithStatic(other)) {
      meetings.remove(other);
    }
  }
}

/**
 * Finds the times of those meetings with shapes that the solver kept apart, and that were farther away as the step began: they may meet
 * from another side than the solver assumed. What touched is left to the solver, which knows everything that touches.
 */
function findApart(world: World, mover: Mover): void {
  for (let meeting = mover.newestMeeting; meeting !== null; meeting = meeting.nextOf(mover)) {
    const pair = meeting.isEstimate ? world.pairs.find(meeting.a, meeting.b) : null;
    if (pair !== null) {
      findLeastSeparation(pair.numbers, pair.at);
      if (leastSeparation[0]! > CONTACT_SLOP) findTime(world, meeting);
    }
  }
}

/** Whether a meeting is with something static, begins in this step, and no handler is asked about it. */
function stops(world: World, meeting: Meeting): boolean {
  const { a, b } = meeting;
  return isWithStatic(meeting) && !mayBeRefused(a, b) && world.pairs.find(a, b)?.active !== true;
}

function isWithStatic({ a, b }: Meeting): boolean {
  return a.owner!.kind === STATIC || b.owner!.kind === STATIC;
}

/** Whether a shape is not looked ahead for: what will cross a sensor is not foreseen. */
function isUnforeseen({ ahead }: Movers, { sensor }: Shape): boolean {
  return sensor && ahead > 0;
}

/** Whether a kinematic shape certainly misses one that does not look. */
function isPassed({ movers }: World, mover: Mover, shape: Shape, other: Shape): boolean {
  widenBounds(other, movers.ahead > 0, around);
  return liesBeyond(mover, shape, around);
}

/**
 * Notes what a mover may meet of all ways that were listed, if one of the two is swept. A meeting of a kinematic body with another one is
 * noted by the other; of its own kind it only senses.
 */
function meetWays(world: World, index: number): void {
  const { movers } = world;
  const { ways } = movers;
  const mover = movers.all[index]!;
  const isKinematic = mover.body.kind === KINEMATIC;
  if (isKinematic && (movers.ahead > 0 || !ways.hasSensors)) return;
  const isListed = meetsMovers(mover);
  const { shapes } = mover.body;
  if (shapes.length > 1) {
    squareOfWay(mover, bounds);
    if (ways.find(bounds, index) === 0) return;
  }
  for (let i = 0; i < shapes.length; i += 1) {
    if (isUnforeseen(movers, shapes[i]!)) continue;
    sweepBounds(mover, shapes[i]!, bounds);
    const size = ways.find(bounds, index);
    for (let k = 0; k < size; k += 1) {
      const way = ways.found[k]!;
      const place = ways.movers[way]!;
      const other = movers.all[place]!;
      const isToKinematic = other.body.kind === KINEMATIC;
      const isOnce = isKinematic === isToKinematic ? place < index || !isListed : isToKinematic;
      const isFar = movers.ahead > 0 && liesBeyond(other, ways.shapes[way]!, bounds);
      if (isOnce && !isFar && (mover.looks || other.looks)) {
        note(world, ways.shapes[way]!, shapes[i]!);
      }
    }
  }
}

/** Whether a mover is swept against dynamic bodies: a fast bullet, or a kinematic one. */
function meetsMovers({ body, sweeps }: Mover): boolean {
  return (body.isBullet && sweeps) || body.kind !== DYNAMIC;
}

/** Notes a meeting of two shapes, if they may interact, do not yet in this step, and meet. What will bounce is not foreseen. */
function note(world: World, one: Shape, two: Shape): void {
  const { movers, pairs } = world;
  const meeting = movers.meetings.draft(one, two);
  const { a, b } = meeting;
  if ((movers.ahead > 0 && isSensed(a, b)) || !mayInteract(a, b)) {
    return;
  }
  if (!(meetsMovers(movers.of(a.owner!)) || meetsMovers(movers.of(b.owner!)))) {
    return;
  }
  const pair = pairs.find(a, b);
  const waits = isKnown(pair, movers);
  if ((waits && !pair!.is(ACCEPTED)) || !(isSensed(a, b) || a.owner!.canBePushed() || b.owner!.canBePushed())) {
    return;
  }
  if (movers.ahead === 0 || waits || !bounces(pair, a, b)) {
    meeting.lands = isSeen(pair) || !(isGrounded(world, a) || isGrounded(world, b));
    list(world, meeting, waits);
  }
}

/**
 * Lists a meeting. At the end of a step exact times are found only when a meeting is the next: most are behind the first of a body, and
 * never come. Others wait for something to stop one of the two bodies: those that would pass each other, and those that the solver kept
 * apart on the assumption that nothing would.
 */
function list(world: World, meeting: Meeting, waits: boolean): void {
  const { movers } = world;
  const { a, b } = meeting;
  const one = movers.of(a.owner!);
  const two = movers.of(b.owner!);
  const isSensing = isSensed(a, b);
  const comes = !waits && mayMeet(one, a, two, b);
  meeting.isEstimate = movers.ahead === 0 && !isSensing;
  if (!comes && (!meeting.isEstimate || isWithStatic(meeting))) {
    return;
  }
  meeting.time = comes ? crossing[REACHED]! : Infinity;
  if (meeting.isEstimate || meets(world, meeting)) {
    movers.meetings.add(meeting, one, two, !isSensing);
  }
}

function bounces(pair: Arbiter | null, a: Shape, b: Shape): boolean {
  if (pair === null) {
    return areElastic(a, b);
  }
  pair.mixMaterials();
  return pair.numbers[pair.at + c.ELASTICITY]! > 0;
}

/**
 * Whether the solver has dealt with a pair, or need not. A contact keeps its normal for the whole step: where bodies turn meanwhile,
 * surfaces get as deep as they go sideways, times the turn.
 */
function isKnown(pair: Arbiter | null, movers: Movers): boolean {
  if (!isSeen(pair)) {
    return false;
  }
  if (!pair.is(ACCEPTED) || movers.ahead > 0) {
    return true;
  }
  const a = movers.of(pair.bodyA);
  const b = movers.of(pair.bodyB);
  const way = Math.abs(b.dx - a.dx) + Math.abs(b.dy - a.dy) + Math.min(a.body.radius, b.body.radius);
  findRequiredDepth(movers, pair.shapeA, pair.shapeB, false, true);
  return pair.foreseen === 0 && required.turn * way < required.depth && holds(pair, a, b);
}

/** Whether shapes touch as the step begins, or almost do. */
function isSeen(pair: Arbiter | null): pair is Arbiter {
  return pair !== null && (pair.active || pair.is(NEAR));
}

/** Whether a dynamic shape lies on or near anything static or kinematic. */
function isGrounded({ timeStamp }: World, { groundStamp }: Shape): boolean {
  return groundStamp === timeStamp;
}

/**
 * Whether the bodies of a contact approached by no more than the gap between its surfaces plus the `required` depth: what is hit hard
 * towards a wall may not stop there.
 */
function holds({ count, numbers: n, at: o }: Arbiter, a: Mover, b: Mover): boolean {
  const came = n[o + g.NX]! * (a.dx - b.dx) + n[o + g.NY]! * (a.dy - b.dy);
  findLeastSeparation(n, o);
  return count === 0 || came - Math.max(leastSeparation[0]!, 0) < required.depth;
}
