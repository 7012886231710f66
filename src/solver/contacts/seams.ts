import { DYNAMIC, STATIC } from '../../body-kind.js';
import { letsMeet } from '../../broadphase/broadphase.js';
import { Along, reachAlong, separationAlong } from '../../collide/along.js';
import { polygonContains } from '../../collide/contains.js';
import * as g from '../../collide/layout.js';
import { findLeastSeparation, leastSeparation } from '../../collide/manifold.js';
import { endOfEdges } from '../../collide/polygons.js';
import { FACE_GAP, FACE_LOOKS, FLUSH_TOLERANCE, IMPACT_DEPTH, SPECULATIVE_MARGIN } from '../../config.js';
import type { Arbiter } from '../../contact/arbiter.js';
import { ACCEPTED, NEAR } from '../../contact/bits.js';
import { touch, touchAlong } from '../../contact/touch.js';
import { EDGE_NX, EDGE_NY, EDGE_STRIDE, EDGES } from '../../geometry/layout.js';
import { List } from '../../math/list.js';
import { cosSin } from '../../math/trig.js';
import type { Polygon } from '../../shape/polygon.js';
import { halfWidthOf, type Shape } from '../../shape/shape.js';
import { POLYGON } from '../../shape/shape-kind.js';
import type { World } from '../../world.js';
import { growBounds } from '../bounds.js';
import { findNearby } from '../nearby.js';
import { BURIED, FreeDirections, RIGHT, WRONG } from './free-directions.js';

// What slides over a floor of tiles must not catch on the seams ("ghost collisions" at internal edges). The side of the next tile may be
// the nearest way out of it, but it is no surface of the floor. A ground is a static or kinematic shape; "up" is from the ground to the
// body.

/** The least cosine of the angle between normals that count as one direction. */
const SAME_DIRECTION = 1 - 1e-10;

/** m. A contact point this near to a corner of a ground is at that corner. */
const CORNER = 4 * FLUSH_TOLERANCE;

/** m/s. Bodies whose velocities differ by no more move alike: velocities that are to bring bodies somewhere differ by rounding. */
const ALIKE_SPEED = 1e-6;

/** m. An edge is open only if a point this far above it is: faces that lie in each other carry as one. */
const CLEAR = 2 * FLUSH_TOLERANCE;

/** A class of its own: V8 would box the fields of a literal as soon as another one with these names holds something else. */
class Spot {
  x = 0.5;
  y = 0.5;
}

class Face {
  separation = 0.5;
}

/** The direction that was found for a contact, from the ground to the body: scratch. */
const up = /* @__PURE__ */ new Along();
/** The direction along which something is measured: scratch. */
const along = /* @__PURE__ */ new Along();
/** The separation of a shape from the face that was found: scratch. */
const face = /* @__PURE__ */ new Face();
const free = /* @__PURE__ */ new FreeDirections();
/** A point on the surface of the ground, relative to its body, and another one that is asked about: scratch. */
const point = /* @__PURE__ */ new Spot();
const place = /* @__PURE__ */ new Spot();
const asked = /* @__PURE__ */ new Float64Array(2);
/**
 * How far the grounds have come since the step began, x and y, and by how much the shape has to be widened for them, as they turn: scratch.
 */
const came = /* @__PURE__ */ new Float64Array(3);
/** Angle, cosine, sine: scratch. */
const turned = /* @__PURE__ */ new Float64Array(3);
const bounds = /* @__PURE__ */ new Float64Array(4);
const near = { reach: 0.5 };
/** All grounds that the present shape lies on or near: three and more may meet at one point. */
const around = /* @__PURE__ */ new List<Shape>();
let areAllKnown = false;

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
    around.clear();
    areAllKnown = false;
    for (let pair = grounds; pair !== null; pair = pair.next) {
      around.add(groundOf(pair));
    }
    for (let pair = grounds; pair !== null; pair = pair.next) {
      if (isHidden(world, pair)) smooth(pair);
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
    const carrier = groundOf(other);
    const helps = other !== pair && other.count > 0 && other.isSolved() && moveAlike(ground, carrier);
    if (helps && carriesUp(other) && !standsOut(carrier, ground)) {
      pair.unmark(NEAR);
      // Else foresight would take it for a known contact.
      pair.numbers[pair.at + g.COUNT] = 0;
      return;
    }
  }
  turn(pair);
  if (pair.count === 0) pair.unmark(NEAR);
}

/** Whether two grounds do not move relative to each other in this step. */
function moveAlike({ owner: a }: Shape, { owner: b }: Shape): boolean {
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

/**
 * As `smoothSeams`, for a contact that was just found during the step, where its bodies are then, with all shapes nearby that move as its
 * ground does.
 */
export function smoothMeeting(world: World, pair: Arbiter): void {
  const ground = groundOf(pair);
  around.clear();
  if (ground.kind !== POLYGON || ground.owner!.kind === DYNAMIC) {
    return;
  }
  const isGoing = ground.owner!.isGoing();
  if (isGoing) findWay(world, ground, dynamicOf(pair));
  addNearby(world, pair);
  if (isGoing) putAround(world, ground, world.movers.of(ground.owner!).at);
  if (isHidden(world, pair)) {
    turn(pair);
    if (pair.count === 0) touch(pair);
  }
  came.fill(0);
}

/** Finds how far a ground has carried the place where a shape is since the step began. */
function findWay({ movers }: World, { owner }: Shape, { numbers: n, at }: Shape): void {
  const { x, y, cos, sin } = owner!;
  const { startX, startY, startAngle } = movers.of(owner!);
  const armX = (n[at]! + n[at + 2]!) / 2 - x;
  const armY = (n[at + 1]! + n[at + 3]!) / 2 - y;
  turned[0] = startAngle;
  cosSin(turned);
  const turnCos = turned[1]! * cos + turned[2]! * sin;
  const turnSin = turned[2]! * cos - turned[1]! * sin;
  came[0] = x + armX - startX - (turnCos * armX - turnSin * armY);
  came[1] = y + armY - startY - (turnSin * armX + turnCos * armY);
  came[2] = Math.abs(turnSin) * Math.max(n[at + 2]! - n[at]!, n[at + 3]! - n[at + 1]!);
}

/** Releases the grounds of earlier contacts. */
export function releaseAround(): void {
  around.clear();
  around.release();
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

/** After `smoothMeeting`: puts the grounds around back to where they began the step, as is done with the pair. */
export function putGroundsBack(world: World, pair: Arbiter): void {
  const ground = groundOf(pair);
  if (around.count > 0 && ground.owner!.isGoing()) putAround(world, ground, 0);
}

/**
 * Adds the grounds that the shape of a contact is near but need not touch: no pair tells of them where it has left a face over a corner.
 */
function addNearby(world: World, pair: Arbiter): void {
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

/** Whether another shape may carry this one: not if it is a sensor, or filters or a handler let them pass through each other. */
function bears(world: World, shape: Shape, other: Shape): boolean {
  if (other.sensor || !letsMeet(shape, other)) {
    return false;
  }
  const pair = world.pairs.find(shape, other);
  return !pair?.active || pair.is(ACCEPTED);
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
  const { numbers: n, at: o } = pair;
  n[o + g.NX] = sign * up.x;
  n[o + g.NY] = sign * up.y;
  touchAlong(pair);
}

/** Whether a contact has the direction that was found. */
function carriesUp(pair: Arbiter): boolean {
  const { numbers: n, at: o } = pair;
  return signOf(pair) * (up.x * n[o + g.NX]! + up.y * n[o + g.NY]!) >= SAME_DIRECTION;
}

/** Whether `to` stands out of `from` along `up`. */
function standsOut(from: Shape, to: Shape): boolean {
  const dx = to.owner!.x - from.owner!.x;
  const dy = to.owner!.y - from.owner!.y;
  reachAlong(from, up, 1);
  const { found } = up;
  reachAlong(to, up, 1);
  return up.found + up.x * dx + up.y * dy - found > FLUSH_TOLERANCE;
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
  return (
    (found === WRONG ? isInReach(dynamicOf(pair), ground, up) : found === BURIED && findOpenFace(pair, ground)) &&
    !carriesUp(pair)
  );
}

/** Whether a shape is no deeper in a ground along a direction than half of the ground; or it lies on it. */
function isInReach(shape: Shape, ground: Polygon, direction: Along): boolean {
  measureFrom(ground, shape, direction);
  return direction.found > -Math.max(lyingDepth(shape), halfWidthOf(ground));
}

/** Finds the separation of a shape from a ground along a direction that points out of the ground. */
function measureFrom(ground: Polygon, shape: Shape, direction: Along): void {
  direction.dx = shape.owner!.x - ground.owner!.x;
  direction.dy = shape.owner!.y - ground.owner!.y;
  separationAlong(ground, shape, direction);
}

/** How deep below a face a shape that lies on it may be, m. */
function lyingDepth(shape: Shape): number {
  return Math.min(IMPACT_DEPTH, halfWidthOf(shape) / 2);
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
    if (mayHold(other, ground, point)) free.add(other, asked);
  }
}

/**
 * Finds the face of a ground below which a shape reaches least, but not deeper than half the ground. If the ground has none that is open,
 * as what lies below the surface: a face of those around that the shape lies on, that the direction of the contact in `free` does not turn
 * away from, and above which this ground does not reach far. So an underside above the shape is no such face.
 */
function findOpenFace(pair: Arbiter, ground: Polygon): boolean {
  const shape = dynamicOf(pair);
  const lying = lyingDepth(shape);
  face.separation = -(leastSeparation[0]! > 0 ? lying : halfWidthOf(ground));
  if (findFaceOf(shape, ground, ground, -1)) {
    return true;
  }
  face.separation = -lying;
  let isFound = false;
  for (let i = 0; i < around.count; i += 1) {
    const other = around.items[i]!;
    if (other !== ground && other.kind === POLYGON) {
      isFound = findFaceOf(shape, other, ground, FACE_LOOKS) || isFound;
    }
  }
  return isFound;
}

/** Finds the surface of the ground at a point of a contact: `at` is the record, plus POINT for the second. */
function findPoint({ numbers: n, at: o, bodyA }: Arbiter, at: number): void {
  const isSecond = bodyA.kind === DYNAMIC;
  const half = (isSecond ? 0.5 : -0.5) * n[g.S0 + at]!;
  point.x = n[g.X0 + at]! + half * n[o + g.NX]! - (isSecond ? n[o + g.DX]! : 0);
  point.y = n[g.Y0 + at]! + half * n[o + g.NY]! - (isSecond ? n[o + g.DY]! : 0);
}

/**
 * Takes a face of a ground that a shape lies on, or below which it reaches least, if it reaches less deep there than below the face before,
 * and is in reach of the ground that is to carry it there.
 */
function findFaceOf(shape: Shape, ground: Polygon, carrier: Polygon, least: number): boolean {
  const { numbers: edges, at } = ground;
  const end = endOfEdges(ground);
  let isFound = false;
  for (let k = at + EDGES; k < end; k += EDGE_STRIDE) {
    along.x = edges[k + EDGE_NX]!;
    along.y = edges[k + EDGE_NY]!;
    measureFrom(ground, shape, along);
    const { found } = along;
    const looks = free.x * edges[k + EDGE_NX]! + free.y * edges[k + EDGE_NY]!;
    if (
      looks >= least &&
      found > face.separation &&
      found < SPECULATIVE_MARGIN &&
      isInReach(shape, carrier, along) &&
      isOpen(shape, ground, k)
    ) {
      face.separation = found;
      up.x = edges[k + EDGE_NX]!;
      up.y = edges[k + EDGE_NY]!;
      isFound = true;
    }
  }
  return isFound;
}

/** Whether an edge of a ground is not within any other polygon, about where the shape is above or below it. */
function isOpen(shape: Shape, ground: Polygon, edge: number): boolean {
  const { numbers: edges, at } = ground;
  const next = edge + EDGE_STRIDE === endOfEdges(ground) ? at + EDGES : edge + EDGE_STRIDE;
  const nx = edges[edge + EDGE_NX]!;
  const ny = edges[edge + EDGE_NY]!;
  // Coordinates along the edge, from one end to the other: as far as the shape reaches, but not so near to an end that what hides the edge
  // is no thicker than the surface there.
  along.x = -ny;
  along.y = nx;
  const from = along.x * edges[edge]! + along.y * edges[edge + 1]!;
  const length = along.x * edges[next]! + along.y * edges[next + 1]! - from;
  const middle = along.x * (shape.owner!.x - ground.owner!.x) + along.y * (shape.owner!.y - ground.owner!.y) - from;
  reachAlong(shape, along, 1);
  const high = Math.min(middle + along.found, length);
  reachAlong(shape, along, -1);
  const low = Math.max(middle - along.found, 0);
  const margin = Math.min(halfWidthOf(shape), length / 2);
  const way = Math.max(margin, Math.min((low + high) / 2, length - margin));
  const gap = FACE_GAP * Math.min(way, length - way);
  place.x = edges[edge]! - way * ny + CLEAR * nx;
  place.y = edges[edge + 1]! + way * nx + CLEAR * ny;
  if (isInAnother(ground)) {
    return false;
  }
  place.x = edges[edge]! - way * ny + gap * nx;
  place.y = edges[edge + 1]! + way * nx + gap * ny;
  return !isInAnother(ground);
}

/** Whether `place` is within another ground than the one to whose body it is relative. */
function isInAnother(ground: Polygon): boolean {
  for (let i = 0; i < around.count; i += 1) {
    const other = around.items[i]!;
    if (other !== ground && mayHold(other, ground, place) && polygonContains(other, asked, FLUSH_TOLERANCE)) {
      return true;
    }
  }
  return false;
}

/**
 * Whether a point, given relative to the body of one ground, may be in another one, which is placed: bounds exclude most. If so, writes to
 * `asked` where the point is relative to the body of the other.
 */
function mayHold(ground: Shape, from: Polygon, spot: Spot): ground is Polygon {
  const { numbers: n, at } = ground;
  const x = spot.x + from.owner!.x;
  const y = spot.y + from.owner!.y;
  const isOut = x < n[at]! - CORNER || x > n[at + 2]! + CORNER || y < n[at + 1]! - CORNER || y > n[at + 3]! + CORNER;
  // What has moved from where the step began has left its bounds behind.
  if (ground.kind !== POLYGON || (isOut && came[0] === 0 && came[1] === 0)) {
    return false;
  }
  asked[0] = x - ground.owner!.x;
  asked[1] = y - ground.owner!.y;
  return true;
}
