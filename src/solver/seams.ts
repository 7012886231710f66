import { DYNAMIC, KINEMATIC, STATIC } from '../body-kind.js';
import { Along, reachAlong, separationAlong } from '../collide/along.js';
import { polygonContains } from '../collide/contains.js';
import * as g from '../collide/layout.js';
import { findLeastSeparation, leastSeparation } from '../collide/manifold.js';
import { endOfEdges } from '../collide/polygons.js';
import { FACE_ALIGNMENT, FLUSH_TOLERANCE, IMPACT_DEPTH, SPECULATIVE_MARGIN } from '../config.js';
import type { Arbiter } from '../contact/arbiter.js';
import { NEAR } from '../contact/bits.js';
import { touch, touchAlong } from '../contact/touch.js';
import { EDGE_STRIDE, EDGES } from '../geometry/layout.js';
import type { Polygon } from '../shape/polygon.js';
import { halfWidthOf, type Shape } from '../shape/shape.js';
import { POLYGON } from '../shape/shape-kind.js';
import type { World } from '../world.js';
import { findNearby } from './nearby.js';

// What slides over a floor of tiles must not catch on the joints ("ghost collisions" at internal edges). The side of the next tile
// may be the nearest way out of it, but it is no surface of the floor.

/** Normals that differ by less than this cosine are different. */
const SAME_DIRECTION = 1 - 1e-10;

/** m. How far an edge is followed to see whether it comes into the open. */
const OPEN_WAY = 4 * FLUSH_TOLERANCE;

/** m. And how far above it: faces that lie in each other carry as one. */
const CLEAR = 2 * FLUSH_TOLERANCE;

/** A class of its own: a literal would be boxed into once any other one with these names holds something else. */
class Spot {
  x = 0.5;
  y = 0.5;
  /** m. How deep below a face around it may lie. */
  depth = 0.5;
}

/** The direction that was found for a contact, from the ground to the body: scratch. */
const up = new Along();
/** A point on the surface of the ground, relative to its body, and one that is asked for: scratch. */
const point = new Spot();
const asked = new Float64Array(2);
const bounds = new Float64Array(4);
/** All grounds that the shape that is looked at lies on or near: three and more may meet at one point. What lies beyond the count is old. */
const around: Shape[] = [];
let aroundCount = 0;

/** Remembers which static or kinematic shapes a dynamic one lies on or near in this step. */
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

/** Looks at all contacts of shapes that lie on or near more than one static shape. */
export function smoothSeams(world: World): void {
  const { straddling } = world;
  for (let i = 0; i < straddling.count; i += 1) {
    const { grounds } = straddling.items[i]!;
    aroundCount = 0;
    for (let pair = grounds; pair !== null; pair = pair.next) {
      around[aroundCount] = groundOf(pair);
      aroundCount += 1;
    }
    for (let pair = grounds; pair !== null; pair = pair.next) {
      smooth(pair);
    }
  }
  straddling.clear();
}

/**
 * Turns a contact to the direction in which the other grounds carry its shape, if they hide the face or corner that it is with. What is only near is let go where
 * they carry the shape already: turned, it would meet a surface that it does not touch, and part from it in the next step.
 */
function smooth(pair: Arbiter): void {
  const shape = dynamicOf(pair);
  const ground = groundOf(pair);
  for (let other = shape.grounds; other !== null && pair.count > 0; other = other.next) {
    if (other === pair || other.count === 0) {
      continue;
    }
    const below = isBelow(pair, other);
    if (below && pair.is(NEAR) && other.isSolved() && moveAlike(ground, groundOf(other))) {
      pair.unmark(NEAR);
      return;
    }
    if (below || isHidden(pair, ground as Polygon, groundOf(other) as Polygon)) {
      turn(pair);
      if (pair.count === 0) pair.unmark(NEAR);
      return;
    }
  }
}

/** Whether neither moves against the other in this step, as far as is told at once. */
function moveAlike(a: Shape, b: Shape): boolean {
  return a.owner === b.owner || (standsStill(a) && standsStill(b));
}

/** The same for a contact that was just found where a body is in the course of the step, with all shapes there that stand still. */
export function smoothMeeting(world: World, pair: Arbiter): void {
  const ground = groundOf(pair);
  if (ground.kind !== POLYGON || !standsStill(ground)) {
    return;
  }
  const { numbers: n, at: o } = pair;
  const x = n[o + g.X0]! + pair.bodyA.x;
  const y = n[o + g.Y0]! + pair.bodyA.y;
  bounds[0] = x;
  bounds[1] = y;
  bounds[2] = x;
  bounds[3] = y;
  const size = findNearby(world, bounds, ground.owner!.kind !== STATIC);
  aroundCount = 0;
  for (let i = 0; i < size; i += 1) {
    const other = world.movers.nearby.shapes[i]!;
    if (standsStill(other)) {
      around[aroundCount] = other;
      aroundCount += 1;
    }
  }
  for (let i = 0; i < aroundCount; i += 1) {
    const other = around[i]!;
    if (other !== ground && isHidden(pair, ground as Polygon, other as Polygon)) {
      turn(pair);
      if (pair.count === 0) {
        touch(pair);
      }
      return;
    }
  }
}

/** Whether a shape is where the step began, all the time. */
function standsStill({ owner }: Shape): boolean {
  const { kind, vx, vy, w } = owner!;
  return kind === STATIC || (kind === KINEMATIC && vx === 0 && vy === 0 && w === 0);
}

function dynamicOf(pair: Arbiter): Shape {
  return pair.bodyA.kind === DYNAMIC ? pair.shapeA : pair.shapeB;
}

function groundOf(pair: Arbiter): Shape {
  return pair.bodyA.kind === DYNAMIC ? pair.shapeB : pair.shapeA;
}

/** 1 if the normal of a pair points from the ground to the body, else −1. */
function signOf(pair: Arbiter): number {
  return pair.bodyA.kind === DYNAMIC ? -1 : 1;
}

function turn(pair: Arbiter): void {
  const sign = signOf(pair);
  touchAlong(pair, sign * up.x, sign * up.y);
}

/**
 * Whether a ground does not stand out of the face of another that the same shape lies on. Then it can only carry the shape in the same direction:
 * all that the two overlap by lies beyond that face, and is no deeper.
 */
function isBelow(pair: Arbiter, other: Arbiter): boolean {
  findFace(other);
  return !carriesUp(pair) && !standsOut(groundOf(other), groundOf(pair));
}

/** Whether a contact has the direction that was found. */
function carriesUp(pair: Arbiter): boolean {
  const { numbers: n, at: o } = pair;
  return signOf(pair) * (up.x * n[o + g.NX]! + up.y * n[o + g.NY]!) >= SAME_DIRECTION;
}

/** The direction in which a ground carries a shape: that of the face that it lies on, even if not perfectly flat. */
function findFace(pair: Arbiter): void {
  const { numbers: n, at: o } = pair;
  const sign = signOf(pair);
  const ground = groundOf(pair);
  up.x = sign * n[o + g.NX]!;
  up.y = sign * n[o + g.NY]!;
  if (ground.kind === POLYGON && dynamicOf(pair).kind === POLYGON) {
    const { numbers: edges, at } = ground;
    const end = endOfEdges(ground);
    for (let k = at + EDGES; k < end; k += EDGE_STRIDE) {
      if (edges[k + 2]! * up.x + edges[k + 3]! * up.y > FACE_ALIGNMENT) {
        up.x = edges[k + 2]!;
        up.y = edges[k + 3]!;
        return;
      }
    }
  }
}

/** Whether a static shape stands out of another, upwards. */
function standsOut(from: Shape, to: Shape): boolean {
  const dx = to.owner!.x - from.owner!.x;
  const dy = to.owner!.y - from.owner!.y;
  reachAlong(from, up, 1);
  const { found } = up;
  reachAlong(to, up, 1);
  return up.found + up.x * dx + up.y * dy - found > FLUSH_TOLERANCE;
}

/**
 * Whether a contact is with a side or corner of a polygon that lies within another one, and so is no surface. Then what carries the body is
 * the face that goes on from there in the open. Where two such faces meet, all directions between theirs are right.
 */
function isHidden(pair: Arbiter, ground: Polygon, other: Polygon): boolean {
  if (ground.kind !== POLYGON || other.kind !== POLYGON || !liesWithin(pair, ground, other)) {
    return false;
  }
  const shape = dynamicOf(pair);
  point.depth = Math.min(halfWidthOf(ground), halfWidthOf(other));
  const { x, y } = point;
  const { numbers: n, at: o } = pair;
  const nx = signOf(pair) * n[o + g.NX]!;
  const ny = signOf(pair) * n[o + g.NY]!;
  let side = 0;
  point.x += ground.owner!.x - other.owner!.x;
  point.y += ground.owner!.y - other.owner!.y;
  if (findOpenFace(shape, other)) {
    side = up.x * ny - up.y * nx;
  }
  point.x = x;
  point.y = y;
  return findOpenFace(shape, ground) && !carriesUp(pair) && side * (up.x * ny - up.y * nx) >= 0;
}

/**
 * Finds a face of a ground that a shape lies on, or else the one that it reaches the least below, no deeper than `point` says, of those that near that are not within another ground.
 */
function findOpenFace(shape: Shape, ground: Polygon): boolean {
  const { numbers: edges, at } = ground;
  const end = endOfEdges(ground);
  up.dx = shape.owner!.x - ground.owner!.x;
  up.dy = shape.owner!.y - ground.owner!.y;
  let face = -1;
  let separation = -point.depth;
  const lies = -Math.min(IMPACT_DEPTH, halfWidthOf(shape) / 2);
  for (let k = at + EDGES; k < end && separation <= lies; k += EDGE_STRIDE) {
    up.x = edges[k + 2]!;
    up.y = edges[k + 3]!;
    separationAlong(ground, shape, up);
    if (up.found > separation && up.found < SPECULATIVE_MARGIN && isOpen(ground, k)) {
      face = k;
      separation = up.found;
    }
  }
  if (face >= 0) {
    up.x = edges[face + 2]!;
    up.y = edges[face + 3]!;
  }
  return face >= 0;
}

/** Whether all points at which the surfaces overlap are within another polygon, or the one that is nearest to it. Leaves the last in `point`. */
function liesWithin({ count, numbers: n, at: o, bodyA }: Arbiter, ground: Polygon, other: Polygon): boolean {
  const isSecond = bodyA.kind === DYNAMIC;
  findLeastSeparation(n, o);
  const least = leastSeparation[0]!;
  for (let at = o; at < o + count * g.POINT; at += g.POINT) {
    const separation = n[g.S0 + at]!;
    if (separation < 0 || separation === least) {
      const half = (isSecond ? 0.5 : -0.5) * separation;
      point.x = n[g.X0 + at]! + half * n[o + g.NX]! - (isSecond ? n[o + g.DX]! : 0);
      point.y = n[g.Y0 + at]! + half * n[o + g.NY]! - (isSecond ? n[o + g.DY]! : 0);
      asked[0] = point.x;
      asked[1] = point.y;
      if (!isWithin(other, ground)) {
        return false;
      }
    }
  }
  return true;
}

/** Whether an edge of a ground, from its end near `point` on, is not within any other polygon. */
function isOpen(ground: Polygon, edge: number): boolean {
  const { numbers: edges, at } = ground;
  const next = edge + EDGE_STRIDE === endOfEdges(ground) ? at + EDGES : edge + EDGE_STRIDE;
  const isNext = isNearer(edges, next, edge);
  const from = isNext ? next : edge;
  const way = (isNext ? -1 : 1) * OPEN_WAY;
  const x = edges[from]! - way * up.y + CLEAR * up.x;
  const y = edges[from + 1]! + way * up.x + CLEAR * up.y;
  for (let i = 0; i < aroundCount; i += 1) {
    const other = around[i]!;
    asked[0] = x;
    asked[1] = y;
    if (other !== ground && other.kind === POLYGON && isWithin(other, ground)) {
      return false;
    }
  }
  return true;
}

/** Whether one corner is nearer to `point` than another. */
function isNearer(edges: Float64Array, one: number, other: number): boolean {
  const oneX = edges[one]! - point.x;
  const oneY = edges[one + 1]! - point.y;
  const otherX = edges[other]! - point.x;
  const otherY = edges[other + 1]! - point.y;
  return oneX * oneX + oneY * oneY < otherX * otherX + otherY * otherY;
}

/** Whether a polygon contains the point that is asked for, given relative to the body of a ground, or nearly. */
function isWithin(polygon: Polygon, ground: Shape): boolean {
  const { owner } = polygon;
  asked[0] = asked[0]! + ground.owner!.x - owner!.x;
  asked[1] = asked[1]! + ground.owner!.y - owner!.y;
  return polygonContains(polygon, asked, FLUSH_TOLERANCE);
}
