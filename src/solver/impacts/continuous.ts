import type { RigidBody } from '../../body.js';
import { DYNAMIC, KINEMATIC, STATIC } from '../../body-kind.js';
import * as g from '../../collide/layout.js';
import { findLeastSeparation, leastSeparation } from '../../collide/manifold.js';
import { CONTACT_SLOP, PUSH_SHARE_STATIC, SAME_TIME } from '../../config.js';
import type { Arbiter } from '../../contact/arbiter.js';
import { ACCEPTED } from '../../contact/bits.js';
import * as c from '../../contact/layout.js';
import { cos, sin } from '../../math/trig.js';
import type { Shape } from '../../shape/shape.js';
import type { World } from '../../world.js';
import { findImpactDepth, impactDepth } from '../impact-depth.js';
import { mayInteract } from '../interaction.js';
import { findNearby } from '../nearby.js';
import type { Meeting } from './meeting-queue.js';
import { carries, findTime, isSensed, meets } from './meeting-time.js';
import { findMeetings } from './meetings.js';
import type { Mover } from './movers.js';
import { beginLate, strike } from './strike.js';
import { squareOfWay } from './swept-bounds.js';

const bounds = /* @__PURE__ */ new Float64Array(4);

/**
 * Continuous collision at the end of a step. What moved so far that it may have passed something is swept from where the step began to
 * where it ended, against everything that was not in contact with it and so not known to the solver: dynamic bodies against static and
 * kinematic ones, bullets against all. The first impact stops a dynamic body there for the rest of the step, with its impulse; a kinematic
 * partner that goes on carries it along.
 */
export function continuous(world: World, dt: number): void {
  const { movers } = world;
  if (movers.count === 0) {
    return;
  }
  movers.duration = dt;
  for (let i = 0; i < world.liveKinematics.length; i += 1) {
    movers.of(world.liveKinematics[i]!);
  }
  findMeetings(world);
  strikeInOrder(world);
  const { meetings } = movers;
  for (let i = 0; i < meetings.count; i += 1) {
    const { a, b, time } = meetings.all[i]!;
    if (isSensed(a, b) && comesTo(world, a, time) && comesTo(world, b, time)) {
      beginLate(world, world.pairs.obtain(a, b));
    }
  }
  movers.clear();
}

/** Whether no impact stopped the shape before that time. */
function comesTo(world: World, shape: Shape, time: number): boolean {
  const mover = world.movers.of(shape.owner!);
  return !mover.stopped || time <= mover.from;
}

/** Solves the impacts in the order of their times; each changes those that come after it. */
function strikeInOrder(world: World): void {
  const { movers } = world;
  const { meetings } = movers;
  for (let next = meetings.first(); next !== null && next.time < Infinity; next = meetings.first()) {
    if (next.isEstimate) {
      findTime(world, next);
      continue;
    }
    takeTogether(world, next);
    const struck = strike(world, movers.together);
    for (let i = 0; i < struck.count; i += 1) {
      const { bodyA, bodyB } = struck.items[i]!;
      halt(world, movers.of(bodyA), movers.of(bodyB), struck.items[i]!);
      halt(world, movers.of(bodyB), movers.of(bodyA), struck.items[i]!);
    }
    for (let i = 0; i < struck.count; i += 1) {
      lookAgain(world, movers.of(struck.items[i]!.bodyA));
      lookAgain(world, movers.of(struck.items[i]!.bodyB));
    }
  }
  for (let i = 0; i < movers.count; i += 1) {
    if (movers.all[i]!.met) {
      movers.all[i]!.finish();
    }
  }
}

/**
 * Takes a meeting, and those of its dynamic bodies that come at once with it, from the queue to `together`, and moves all their bodies to
 * where they are then.
 */
function takeTogether(world: World, first: Meeting): void {
  world.movers.together.clear();
  take(world, first, first);
  addThoseOf(world, first.a.owner!, first);
  addThoseOf(world, first.b.owner!, first);
}

function addThoseOf(world: World, body: RigidBody, first: Meeting): void {
  const mover = world.movers.of(body);
  for (let other = mover.newestMeeting; other !== null; other = other.nextOf(mover)) {
    if (isDue(world, other, first)) take(world, other, first);
  }
}

/** Whether a meeting is in the queue and comes at once with the first: its surfaces are then as close as those that touch. */
function isDue(world: World, meeting: Meeting, first: Meeting): boolean {
  if (meeting.slot >= 0 && meeting.isEstimate && meeting.time <= first.time + SAME_TIME) {
    findTime(world, meeting);
  }
  const wait = meeting.time - first.time;
  return (
    meeting.slot >= 0 && !meeting.isEstimate && wait <= SAME_TIME && wait * mostApproach(world, meeting) <= CONTACT_SLOP
  );
}

/** By how much two shapes may approach each other in the step at most, m. */
function mostApproach({ movers }: World, { a, b }: Meeting): number {
  const one = movers.of(a.owner!);
  const two = movers.of(b.owner!);
  const turning = Math.abs(one.turn) * one.body.radius + Math.abs(two.turn) * two.body.radius;
  return Math.abs(one.dx - two.dx) + Math.abs(one.dy - two.dy) + turning;
}

function take({ movers }: World, meeting: Meeting, first: Meeting): void {
  movers.meetings.remove(meeting);
  movers.together.add(meeting);
  moveToMeeting(movers.of(meeting.a.owner!), first);
  moveToMeeting(movers.of(meeting.b.owner!), first);
}

/** Takes the meeting, as its time would be boxed. */
function moveToMeeting(mover: Mover, { time }: Meeting): void {
  mover.moveBodyTo(time);
  mover.met = mover.body.kind !== STATIC;
}

/**
 * Stops a dynamic body at an impact for the rest of the step. A kinematic partner that goes on carries it along, also after something else
 * met it.
 */
function halt(world: World, mover: Mover, partner: Mover, pair: Arbiter): void {
  if (mover.body.kind !== DYNAMIC) {
    return;
  }
  const isDeeper = partner.body.kind !== DYNAMIC && pair.metAgain();
  if (isDeeper && mover.body.mass === Infinity) {
    // Nothing moves it, but it may be turned out of what it is in.
    mover.resume();
    return;
  }
  const carrier = carries(partner) ? partner : mover.carrier;
  mover.stop();
  if (carrier !== null) {
    mover.ride(carrier);
  }
  if (isDeeper) {
    slide(world, mover, partner, pair);
    stopShort(world, mover, mover.body === pair.bodyA ? pair.shapeB : pair.shapeA);
    const bounces = pair.numbers[pair.at + c.ELASTICITY]! > 0;
    if (bounces && partner.body.kind === STATIC) mover.settle(world);
  }
}

/**
 * Lets a body go on along a surface that it touched before and only got too deep in as it turned, and out of it, without turning: else it
 * would never get away. The surface itself may turn until the end of the step: so the body goes no farther than to where half-way, on the
 * straight, it would come to the other side of the surface.
 */
function slide({ movers }: World, mover: Mover, under: Mover, pair: Arbiter): void {
  const { numbers: n, at: o, bodyA } = pair;
  const { body } = mover;
  const { body: base } = under;
  const rest = 1 - mover.from;
  const sign = body === bodyA ? -1 : 1;
  const nx = sign * n[o + g.NX]!;
  const ny = sign * n[o + g.NY]!;
  const vx = body.vx - (base.vx - base.w * (body.y - base.y));
  const vy = body.vy - (base.vy + base.w * (body.x - base.x));
  const turn = under.turn * rest;
  const far = (nx * vy - ny * vx) * rest * movers.duration;
  findImpactDepth(pair.shapeA, pair.shapeB);
  const bend = Math.abs(far * turn) / (4 * impactDepth[0]!);
  const way = far / Math.max(1, bend);
  findLeastSeparation(n, o);
  const out = PUSH_SHARE_STATIC * Math.max(-leastSeparation[0]! - CONTACT_SLOP, 0);
  const x = out * nx - way * ny;
  const y = out * ny + way * nx;
  mover.dx += cos(turn) * x - sin(turn) * y;
  mover.dy += sin(turn) * x + cos(turn) * y;
}

/**
 * Ends such a way at the next thing on it that is not on its own way: the contact with that is for the next step. A body that is carried
 * along does not even begin such a way.
 */
function stopShort(world: World, mover: Mover, under: Shape): void {
  const { carrier } = mover;
  let end = findEnd(world, mover, under, null);
  if (end < 1 && carrier !== null) {
    mover.stop();
    mover.ride(carrier);
    end = findEnd(world, mover, under, carrier.body);
  }
  if (end < 1) {
    mover.scale((end - mover.from) / (1 - mover.from));
  }
}

/**
 * Finds when a body first meets a static, sleeping or kinematic shape on its way, except `under` and the shapes of `not`; 1 if it meets
 * none.
 */
function findEnd(world: World, mover: Mover, under: Shape, not: RigidBody | null): number {
  const { ways, nearby } = world.movers;
  const { body } = mover;
  squareOfWay(mover, bounds);
  let end = 1;
  for (let i = findNearby(world, bounds, false) - 1; i >= 0; i -= 1) {
    end = Math.min(end, timeToMeet(world, body, nearby.shapes[i]!, under));
  }
  for (let i = ways.find(bounds) - 1; i >= 0; i -= 1) {
    const other = ways.shapes[ways.found[i]!]!;
    if (other.owner!.kind === KINEMATIC && other.owner !== not) {
      end = Math.min(end, timeToMeet(world, body, other, under));
    }
  }
  return end;
}

/** Finds when a body meets a shape; 1 if they do not meet, or do not interact. */
function timeToMeet(world: World, { shapes }: RigidBody, other: Shape, under: Shape): number {
  let time = 1;
  for (let i = 0; i < shapes.length && other !== under; i += 1) {
    const meeting = world.movers.meetings.draft(shapes[i]!, other);
    const { a, b } = meeting;
    const pair = world.pairs.find(a, b);
    const isRejected = pair?.active && !pair.is(ACCEPTED);
    if (!isRejected && !isSensed(a, b) && mayInteract(a, b) && meets(world, meeting)) {
      time = Math.min(time, meeting.time);
    }
  }
  return time;
}

/** Finds the times of the meetings of a body that has stopped once more: some come at another time now, and some not at all. */
function lookAgain(world: World, mover: Mover): void {
  for (let meeting = mover.newestMeeting; meeting !== null; meeting = meeting.nextOf(mover)) {
    if (meeting.slot >= 0) {
      findTime(world, meeting);
    }
  }
}
