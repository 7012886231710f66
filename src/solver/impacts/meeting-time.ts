import { KINEMATIC, STATIC } from '../../body-kind.js';
import {
  DEEPER_CARRIED,
  DEEPER_SHARE,
  IMPACT_TURN,
  MEET_PATIENCE,
  SPECULATIVE_MARGIN,
  SWEEP_TOLERANCE,
  TOUCH_DEPTH,
} from '../../config.js';
import { Middle } from '../../geometry/middle.js';
import { findImpact, findNext, Sweep } from '../../geometry/sweep.js';
import { halfWidthOf, type Shape } from '../../shape/shape.js';
import type { World } from '../../world.js';
import type { Meeting } from './meeting-queue.js';
import type { Mover } from './movers.js';
import { findRequiredDepth, lessenRequiredDepth, required } from './required-depth.js';
import { sweepBounds } from './swept-bounds.js';

// When exactly two shapes meet on their ways, if they do.

const sweep = /* @__PURE__ */ new Sweep(MEET_PATIENCE, true);
const middle = /* @__PURE__ */ new Middle();
const around = /* @__PURE__ */ new Float64Array(4);

/** Releases the shapes that were swept last. */
export function releaseMeetings(): void {
  sweep.release();
  middle.shape = null;
}

export function isSensed(a: Shape, b: Shape): boolean {
  return a.sensor || b.sensor;
}

/** Finds the exact time of a meeting in the heap; infinite if it does not come as things are. */
export function findTime(world: World, meeting: Meeting): void {
  const { movers } = world;
  const { a, b } = meeting;
  const one = movers.of(a.owner!);
  const two = movers.of(b.owner!);
  const { time } = meeting;
  meeting.isEstimate = false;
  const isNever = (isStill(one) && isStill(two)) || isElsewhere(one, a, two) || isElsewhere(two, b, one);
  if (isNever || !meets(world, meeting)) {
    meeting.time = Infinity;
  }
  if (meeting.time !== time) {
    movers.meetings.put(meeting);
  }
}

/** Whether a mover is kinematic, and goes on whatever it meets. */
export function carries(mover: Mover): boolean {
  return mover.body.kind === KINEMATIC && !isStill(mover);
}

/** Whether a mover is stopped, and not carried along. */
function isStill({ dx, dy, turn }: Mover): boolean {
  return dx === 0 && dy === 0 && turn === 0;
}

/**
 * Whether a shape, if nothing met it, does not come to where another body may be, from where that was stopped. The body of a static shape
 * has no radius.
 */
function isElsewhere(mover: Mover, shape: Shape, { x, y, dx, dy, body }: Mover): boolean {
  if (mover.met || body.kind === STATIC) {
    return false;
  }
  const reach = Math.abs(dx) + Math.abs(dy) + body.radius + SPECULATIVE_MARGIN / 2;
  sweepBounds(mover, shape, around);
  return around[0]! > x + reach || around[1]! > y + reach || around[2]! < x - reach || around[3]! < y - reach;
}

/**
 * Sweeps the middle of the thinner of two shapes from a time on. What turns fast may get deep with its corners again and again; but where
 * it could slip into the seam of two tiles, of which it is not deep in either, its middle gets there, too.
 */
function middleMeets(a: Shape, b: Shape, time: number): boolean {
  const isA = halfWidthOf(a) < halfWidthOf(b);
  middle.shape = isA ? a : b;
  (isA ? sweep.a : sweep.b).shape = middle;
  sweep.time = time;
  sweep.target = 0;
  return findImpact(sweep) && sweep.time > time;
}

/**
 * Finds when two shapes first touch, not before they were last stopped, if they do, and will get deeper than contacts leave: what slides
 * over the seam of two tiles meets the second one, but no deeper than it lies on the first. If they touch already, or have joints, which
 * would open by as much as they are put back, finds when they are that deep.
 */
export function meets({ movers }: World, meeting: Meeting): boolean {
  const { a, b } = meeting;
  const one = movers.of(a.owner!);
  const two = movers.of(b.owner!);
  one.follow(sweep.a, a, one);
  two.follow(sweep.b, b, one);
  const from = Math.max(one.from, two.from);
  sweep.time = from;
  sweep.tolerance = SWEEP_TOLERANCE;
  sweep.most = 1;
  if (isSensed(a, b)) {
    // What leaves may still be as near as rounding: it has to overlap by as much.
    sweep.target = -2 * SWEEP_TOLERANCE;
    const isMet = findImpact(sweep);
    meeting.time = sweep.time;
    return isMet;
  }
  findRequiredDepth(movers, a, b, true, meeting.lands);
  sweep.target = -Math.min(TOUCH_DEPTH, required.depth / 2);
  if (!findImpact(sweep)) {
    return false;
  }
  const { time } = sweep;
  if (time > from) lessenRequiredDepth(a, b, one, two);
  const isCarried = carries(one) || carries(two);
  const more = isCarried ? DEEPER_CARRIED : DEEPER_SHARE * required.depth;
  sweep.target = Math.min(-required.depth, sweep.distance.value - more);
  const isDeep = findNext(sweep) || (required.turn >= IMPACT_TURN && middleMeets(a, b, time));
  meeting.time = time > from && !required.isInTrain ? time : sweep.time;
  return isDeep;
}
