import { collideAlong } from '../collide/along.js';
import { gapBetween } from '../collide/gap.js';
import * as g from '../collide/layout.js';
import { overlaps } from '../collide/manifold.js';
import { collide, intersect } from '../collide/table.js';
import type { Arbiter } from './arbiter.js';
import { LISTED } from './bits.js';

/** Writes the relative placement of the two bodies to the record, for the kernels. */
function placePair({ numbers: n, at: o, bodyA, bodyB }: Arbiter): void {
  n[o + g.DX] = bodyB.x - bodyA.x;
  n[o + g.DY] = bodyB.y - bodyA.y;
  n[o + g.ANGLE_A] = bodyA.angle;
  n[o + g.ANGLE_B] = bodyB.angle;
}

/** Whether a sensor and another shape intersect; no contacts are made. */
export function sensorIntersects(pair: Arbiter): boolean {
  placePair(pair);
  return intersect(pair.shapeA, pair.shapeB, pair.numbers, pair.at);
}

/** The corners and edges of the points found last time, if there were two: scratch. */
const last = { id0: 0, id1: 0, edgeA: 0, edgeB: 0 };

function rememberFeatures({ shown, numbers: n, at: o }: Arbiter): void {
  if (shown < 2) {
    return;
  }
  last.id0 = n[o + g.ID0]! | 0;
  last.id1 = n[o + g.ID1]! | 0;
  last.edgeA = n[o + g.EDGE_A]! | 0;
  last.edgeB = n[o + g.EDGE_B]! | 0;
}

/** Collides the shapes anew, and carries the impulses of the points over. @returns whether the shapes collide. */
export function updateManifold(pair: Arbiter): boolean {
  const { shapeA, shapeB, numbers: n, at: o } = pair;
  placePair(pair);
  rememberFeatures(pair);
  collide(shapeA, shapeB, n, o);
  keepPoints(pair);
  return overlaps(n, o);
}

/** As `updateManifold`, along a known direction: the normal in the record, a unit vector from A to B. It is not passed as numbers, as these would be boxed. */
export function updateManifoldAlong(pair: Arbiter): void {
  rememberFeatures(pair);
  collideAlong(pair.shapeA, pair.shapeB, pair.numbers, pair.at);
  keepPoints(pair);
}

/** Lists the points that were found. Points that were there before keep their impulses. */
function keepPoints(pair: Arbiter): void {
  const { shown, count, numbers: n, at: o } = pair;
  if (count === 0) {
    if (!pair.is(LISTED) && shown > 0) {
      pair.forget();
    }
  } else if (shown !== count) {
    pair.showPoints();
  } else if (count === 2 && (n[o + g.EDGE_A] !== last.edgeA || n[o + g.EDGE_B] !== last.edgeB)) {
    matchPoints(pair);
  }
}

/** With other edges than last time, points are recognised by the corners that limit them. */
function matchPoints(pair: Arbiter): void {
  const { numbers: n, at: o } = pair;
  const id0 = n[o + g.ID0];
  const id1 = n[o + g.ID1];
  if (id0 === last.id1) {
    pair.shiftPoint(0);
  } else if (id1 === last.id0) {
    pair.shiftPoint(1);
  } else {
    if (id0 !== last.id0) {
      pair.dropPoint(0);
    }
    if (id1 !== last.id1) {
      pair.dropPoint(1);
    }
  }
}

/** Makes the one point where the shapes are nearest. For corners that meet corners, where no edges face each other. */
export function makeNearestPoint(pair: Arbiter): void {
  const { numbers: n, at: o } = pair;
  const distance = gapBetween(pair.shapeA, pair.shapeB);
  n[o + g.COUNT] = 1;
  n[o + g.FACE] = -1;
  n[o + g.NX] = distance.axisX;
  n[o + g.NY] = distance.axisY;
  n[o + g.X0] = 0.5 * (distance.ax + distance.bx);
  n[o + g.Y0] = 0.5 * (distance.ay + distance.by);
  n[o + g.S0] = distance.value;
  pair.showPoints();
}
