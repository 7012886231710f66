import { collideAlong } from '../collide/along.js';
import { gapBetween } from '../collide/gap.js';
import * as g from '../collide/layout.js';
import { overlaps } from '../collide/manifold.js';
import { works } from '../collide/polygon-works.js';
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

/** Collides the shapes anew, and carries the impulses of the points over. @returns whether the shapes collide. */
export function updateManifold(pair: Arbiter): boolean {
  const { shapeA, shapeB, numbers: n, at: o } = pair;
  placePair(pair);
  if (pair.shown === 2) works!.rememberFeatures(pair);
  collide(shapeA, shapeB, n, o);
  keepPoints(pair);
  return overlaps(n, o);
}

/** As `updateManifold`, along a known direction: the normal in the record, a unit vector from A to B. It is not passed as numbers, as these would be boxed. */
export function updateManifoldAlong(pair: Arbiter): void {
  if (pair.shown === 2) works!.rememberFeatures(pair);
  collideAlong(pair.shapeA, pair.shapeB, pair.numbers, pair.at);
  keepPoints(pair);
}

/** Lists the points that were found. Points that were there before keep their impulses. */
function keepPoints(pair: Arbiter): void {
  const { shown, count } = pair;
  if (count === 0) {
    if (!pair.is(LISTED) && shown > 0) {
      pair.forget();
    }
  } else if (shown !== count) {
    pair.showPoints();
  } else if (count === 2) {
    works!.matchPoints(pair);
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
