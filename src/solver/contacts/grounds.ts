import { DYNAMIC, STATIC } from '../../body-kind.js';
import { letsMeet } from '../../broadphase/broadphase.js';
import { FLUSH_TOLERANCE, SPECULATIVE_MARGIN } from '../../config.js';
import type { Arbiter } from '../../contact/arbiter.js';
import { ACCEPTED } from '../../contact/bits.js';
import { MAX_X, MAX_Y, MIN_X, MIN_Y } from '../../geometry/layout.js';
import { List } from '../../math/list.js';
import { cosSin } from '../../math/trig.js';
import type { Polygon } from '../../shape/polygon.js';
import { halfWidthOf, type Shape } from '../../shape/shape.js';
import { POLYGON } from '../../shape/shape-kind.js';
import type { World } from '../../world.js';
import { growBounds } from '../bounds.js';
import { findNearby } from '../nearby.js';

// The grounds around one shape, for `seams.ts`: which they are, and where they are by now. A ground is a static or kinematic shape.

/** m. A point this near to a corner of a ground is at that corner. */
export const CORNER = 4 * FLUSH_TOLERANCE;

/** m/s. Bodies whose velocities differ by no more move alike: velocities that are to bring bodies somewhere differ by rounding. */
const ALIKE_SPEED = 1e-6;

/** A class of its own: V8 would box the fields of a literal as soon as another one with these names holds something else. */
export class Spot {
  x = 0.5;
  y = 0.5;
}

/** The grounds that the present shape lies on or near: three and more may meet at one point. */
export const around = /* @__PURE__ */ new List<Shape>();
/** Whether these are all that there are, or only those that the shape has pairs with. */
export let areAllKnown = false;

/** The result of `mayHold`. */
export const local = /* @__PURE__ */ new Float64Array(2);

/**
 * How far the grounds have come since the step began, x and y, and by how much the shape has to be widened for them, as they turn: scratch,
 * as what follows. All 0 but between `listAtMeeting` and `endMeeting`.
 */
const came = /* @__PURE__ */ new Float64Array(3);
/** Angle, cosine, sine. */
const turned = /* @__PURE__ */ new Float64Array(3);
const bounds = /* @__PURE__ */ new Float64Array(4);
const near = { reach: 0.5 };

export function dynamicOf(pair: Arbiter): Shape {
  return pair.bodyA.kind === DYNAMIC ? pair.shapeA : pair.shapeB;
}

export function groundOf(pair: Arbiter): Shape {
  return pair.bodyA.kind === DYNAMIC ? pair.shapeB : pair.shapeA;
}

/** Lists the grounds that a shape has pairs with, given the first of these. */
export function listGrounds(first: Arbiter | null): void {
  around.clear();
  areAllKnown = false;
  for (let pair = first; pair !== null; pair = pair.next) {
    around.add(groundOf(pair));
  }
}

/**
 * Lists all grounds near the shape of a pair that was just found during the step, and moves them to where they are then. @returns whether
 * the pair may be at a seam.
 */
export function listAtMeeting(world: World, pair: Arbiter): boolean {
  const ground = groundOf(pair);
  around.clear();
  if (ground.kind !== POLYGON || ground.owner!.kind === DYNAMIC) {
    return false;
  }
  const isGoing = ground.owner!.isGoing();
  if (isGoing) findWay(world, ground, dynamicOf(pair));
  addNearby(world, pair);
  if (isGoing) putAround(world, ground, world.movers.of(ground.owner!).at);
  return true;
}

export function endMeeting(): void {
  // Not by `fill`, which takes longer for so few.
  came[0] = 0;
  came[1] = 0;
  came[2] = 0;
}

/** After `smoothMeeting`: puts the grounds around back to where they began the step, as is done with the pair. */
export function putGroundsBack(world: World, pair: Arbiter): void {
  const ground = groundOf(pair);
  if (around.count > 0 && ground.owner!.isGoing()) putAround(world, ground, 0);
}

/** Releases the grounds of earlier contacts. */
export function releaseAround(): void {
  around.clear();
  around.release();
}

/** Finds how far a ground has carried the place where a shape is since the step began. */
function findWay({ movers }: World, { owner }: Shape, { numbers: n, at }: Shape): void {
  const { x, y, cos, sin } = owner!;
  const { startX, startY, startAngle } = movers.of(owner!);
  const armX = (n[at + MIN_X]! + n[at + MAX_X]!) / 2 - x;
  const armY = (n[at + MIN_Y]! + n[at + MAX_Y]!) / 2 - y;
  turned[0] = startAngle;
  cosSin(turned);
  const turnCos = turned[1]! * cos + turned[2]! * sin;
  const turnSin = turned[2]! * cos - turned[1]! * sin;
  came[0] = x + armX - startX - (turnCos * armX - turnSin * armY);
  came[1] = y + armY - startY - (turnSin * armX + turnCos * armY);
  came[2] = Math.abs(turnSin) * Math.max(n[at + MAX_X]! - n[at + MIN_X]!, n[at + MAX_Y]! - n[at + MIN_Y]!);
}

/** Moves the other grounds around, which go as this one does, to where they are at a time in the step. */
function putAround({ movers }: World, ground: Shape, time: number): void {
  for (let i = 0; i < around.count; i += 1) {
    const other = around.items[i]!;
    if (other.owner !== ground.owner) {
      const mover = movers.of(other.owner!);
      mover.moveBodyTo(time);
      // So that the step moves it to its end together with what was met.
      mover.met = true;
    } else if (other !== ground && other.owner!.w !== 0) {
      other.place(other.owner!);
    }
  }
}

/**
 * Adds the grounds that the shape of a contact is near but need not touch: no pair tells of them where it has left a face over a corner.
 */
export function addNearby(world: World, pair: Arbiter): void {
  const shape = dynamicOf(pair);
  const ground = groundOf(pair);
  near.reach = SPECULATIVE_MARGIN + halfWidthOf(shape) + came[2]!;
  growBounds(shape, near, bounds);
  // Grounds that move are in the broadphase where the step began.
  for (let i = 0; i < 4; i += 1) {
    bounds[i] = bounds[i]! - came[i & 1]!;
  }
  const size = findNearby(world, bounds, ground.owner!.kind !== STATIC);
  for (let i = 0; i < size; i += 1) {
    const other = world.movers.nearby.shapes[i]!;
    if (moveAlike(ground, other) && bears(world, shape, other) && !around.has(other)) {
      around.add(other);
    }
  }
  areAllKnown = true;
}

/** Whether two grounds do not move relative to each other in this step. */
export function moveAlike({ owner: a }: Shape, { owner: b }: Shape): boolean {
  return (
    a === b ||
    (a!.kind !== DYNAMIC &&
      b!.kind !== DYNAMIC &&
      Math.abs(a!.vx - b!.vx) <= ALIKE_SPEED &&
      Math.abs(a!.vy - b!.vy) <= ALIKE_SPEED &&
      a!.w === 0 &&
      b!.w === 0)
  );
}

/** Whether another shape may carry this one: not if it is a sensor, or filters or a handler let them pass through each other. */
function bears(world: World, shape: Shape, other: Shape): boolean {
  if (other.sensor || !letsMeet(shape, other)) {
    return false;
  }
  const pair = world.pairs.find(shape, other);
  return !pair?.active || pair.is(ACCEPTED);
}

/**
 * Whether a point, given relative to the body of one ground, may be in another one, which is placed: bounds exclude most. If so, writes to
 * `local` where the point is relative to the body of the other.
 */
export function mayHold(ground: Shape, from: Polygon, spot: Spot): ground is Polygon {
  const { numbers: n, at } = ground;
  const x = spot.x + from.owner!.x;
  const y = spot.y + from.owner!.y;
  const isOut =
    x < n[at + MIN_X]! - CORNER ||
    x > n[at + MAX_X]! + CORNER ||
    y < n[at + MIN_Y]! - CORNER ||
    y > n[at + MAX_Y]! + CORNER;
  // What has moved from where the step began has left its bounds behind.
  if (ground.kind !== POLYGON || (isOut && came[0] === 0 && came[1] === 0)) {
    return false;
  }
  local[0] = x - ground.owner!.x;
  local[1] = y - ground.owner!.y;
  return true;
}
