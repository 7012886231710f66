import { DYNAMIC } from '../../body-kind.js';
import * as g from '../../collide/layout.js';
import { findLeastSeparation, leastSeparation } from '../../collide/manifold.js';
import type { Arbiter } from '../../contact/arbiter.js';
import { NEAR } from '../../contact/bits.js';
import { updateManifold, updateManifoldAlong } from '../../contact/update.js';
import { EDGE_STRIDE, EDGES } from '../../geometry/layout.js';
import type { Polygon } from '../../shape/polygon.js';
import { POLYGON } from '../../shape/shape-kind.js';
import type { World } from '../../world.js';
import { BURIED, FreeDirections, RIGHT, WRONG } from './free-directions.js';
import {
  addNearby,
  areAllKnown,
  around,
  CORNER,
  dynamicOf,
  endMeeting,
  groundOf,
  listAtMeeting,
  listGrounds,
  local,
  mayHold,
  moveAlike,
  Spot,
} from './grounds.js';
import { findOpenFace, isInReach, up } from './open-faces.js';
import { noteDeep } from './wedged.js';

// What slides over a floor of tiles must not catch on the seams ("ghost collisions" at internal edges). The side of the next tile may be
// the nearest way out of it, but it is no surface of the floor. So a contact that others hide is turned to a direction in which the surface
// may carry, `up`, which points from the ground to the body.

/** The least cosine of the angle between normals that count as one direction. */
const SAME_DIRECTION = 1 - 1e-10;

const free = /* @__PURE__ */ new FreeDirections();
/** A point on the surface of the ground, relative to its body: scratch. */
const point = /* @__PURE__ */ new Spot();

/** Notes that a dynamic shape lies on or near a static or kinematic one in this step. */
export function noteGround(world: World, pair: Arbiter): void {
  if (pair.bodyA.kind === DYNAMIC && pair.bodyB.kind === DYNAMIC) {
    return;
  }
  const shape = dynamicOf(pair);
  if (shape.groundStamp !== world.timeStamp) {
    shape.groundStamp = world.timeStamp;
    shape.grounds = null;
  } else if (shape.grounds!.next === null) {
    world.straddling.add(shape);
  }
  pair.next = shape.grounds;
  shape.grounds = pair;
}

/** Smooths all contacts of shapes that lie on or near more than one static or kinematic shape. */
export function smoothSeams(world: World): void {
  const { straddling } = world;
  for (let i = 0; i < straddling.count; i += 1) {
    const { grounds } = straddling.items[i]!;
    listGrounds(grounds);
    for (let pair = grounds; pair !== null; pair = pair.next) {
      if (isHidden(world, pair)) {
        smooth(pair);
        if (pair.isSolid()) noteDeep(world, pair);
      }
    }
  }
}

/**
 * Turns a contact to the direction `up`. A speculative contact is dropped where another ground carries the shape in that direction already:
 * turned, it would meet a surface that it does not touch, and leave it in the next step.
 */
function smooth(pair: Arbiter): void {
  const ground = groundOf(pair);
  for (let other = dynamicOf(pair).grounds; other !== null && pair.is(NEAR); other = other.next) {
    const helps = other !== pair && other.count > 0 && other.isSolved() && moveAlike(ground, groundOf(other));
    if (helps && carriesUp(other)) {
      pair.unmark(NEAR);
      // Else foresight would take it for a known contact.
      pair.numbers[pair.at + g.COUNT] = 0;
      return;
    }
  }
  turn(pair);
  if (pair.count === 0) pair.unmark(NEAR);
}

/**
 * As `smoothSeams`, for a contact that was just found during the step, where its bodies are then, with all shapes nearby that move as its
 * ground does.
 */
export function smoothMeeting(world: World, pair: Arbiter): void {
  if (!listAtMeeting(world, pair)) {
    return;
  }
  if (isHidden(world, pair)) {
    turn(pair);
    if (pair.count === 0) updateManifold(pair);
  }
  endMeeting();
}

/** 1 if the normal of a pair points from the ground to the body, else −1. */
function signOf(pair: Arbiter): number {
  return pair.bodyA.kind === DYNAMIC ? -1 : 1;
}

function turn(pair: Arbiter): void {
  const sign = signOf(pair);
  const { numbers: n, at: o } = pair;
  n[o + g.NX] = sign * up.x;
  n[o + g.NY] = sign * up.y;
  updateManifoldAlong(pair);
}

/** Whether a contact has the direction that was found. */
function carriesUp(pair: Arbiter): boolean {
  const { numbers: n, at: o } = pair;
  return signOf(pair) * (up.x * n[o + g.NX]! + up.y * n[o + g.NY]!) >= SAME_DIRECTION;
}

/**
 * Whether a contact is not with the common surface of grounds that lie side by side, but with a side or corner that others hide. Then finds
 * in `up` what carries the body instead: a face beside it; or, if all of it lies within others, the face that the shape lies on.
 */
function isHidden(world: World, pair: Arbiter): boolean {
  const ground = groundOf(pair);
  if (pair.count === 0 || ground.kind !== POLYGON) {
    return false;
  }
  let found = judge(pair, ground);
  if (found !== RIGHT && !areAllKnown) {
    addNearby(world, pair);
    found = judge(pair, ground);
  }
  const shape = dynamicOf(pair);
  const isCarried =
    found === WRONG
      ? isInReach(shape, ground, up)
      : found === BURIED && findOpenFace(shape, ground, free, leastSeparation[0]! > 0);
  return isCarried && !carriesUp(pair);
}

/**
 * What the direction of a contact is, as `FreeDirections.judge` tells; it is right if it is at one of its points. If it is wrong, `up` is
 * the next right one.
 */
function judge(pair: Arbiter, ground: Polygon): number {
  const { count, numbers: n, at: o } = pair;
  const sign = signOf(pair);
  let found = BURIED;
  findLeastSeparation(n, o);
  const least = leastSeparation[0]!;
  for (let at = o; at < o + count * g.POINT && found !== RIGHT; at += g.POINT) {
    const separation = n[g.S0 + at]!;
    findPoint(pair, at);
    if (separation < 0 || separation === least) {
      goToCorner(ground);
      free.x = sign * n[o + g.NX]!;
      free.y = sign * n[o + g.NY]!;
      free.begin();
      addAround(ground);
      const there = free.judge();
      if (there < found) {
        found = there;
        up.x = free.x;
        up.y = free.y;
      }
    }
  }
  return found;
}

/** Moves `point` to the corner of a ground that it is near, if there is one. */
function goToCorner({ numbers: edges, at, offsets }: Polygon): void {
  for (let k = at + EDGES + EDGE_STRIDE * (offsets.length - 1); k >= at + EDGES; k -= EDGE_STRIDE) {
    const dx = edges[k]! - point.x;
    const dy = edges[k + 1]! - point.y;
    if (dx * dx + dy * dy < CORNER * CORNER) {
      point.x = edges[k]!;
      point.y = edges[k + 1]!;
      return;
    }
  }
}

/** Adds what the grounds around fill at `point`. */
function addAround(ground: Polygon): void {
  for (let i = 0; i < around.count; i += 1) {
    const other = around.items[i]!;
    if (mayHold(other, ground, point)) free.add(other, local);
  }
}

/** Finds the surface of the ground at a point of a contact: `at` is the record, plus POINT for the second. */
function findPoint({ numbers: n, at: o, bodyA }: Arbiter, at: number): void {
  const isB = bodyA.kind === DYNAMIC;
  const half = (isB ? 0.5 : -0.5) * n[g.S0 + at]!;
  point.x = n[g.X0 + at]! + half * n[o + g.NX]! - (isB ? n[o + g.DX]! : 0);
  point.y = n[g.Y0 + at]! + half * n[o + g.NY]! - (isB ? n[o + g.DY]! : 0);
}
