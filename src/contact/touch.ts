import { collideAlong } from '../collide/along.js';
import { gapBetween } from '../collide/gap.js';
import * as g from '../collide/layout.js';
import { overlaps } from '../collide/manifold.js';
import { collide, intersect } from '../collide/table.js';
import type { Arbiter } from './arbiter.js';
import { LISTED } from './bits.js';

/** Tells the kernels how the bodies of a pair lie to each other. */
function placePair({ numbers: n, at: o, bodyA, bodyB }: Arbiter): void {
  n[o + g.DX] = bodyB.x - bodyA.x;
  n[o + g.DY] = bodyB.y - bodyA.y;
  n[o + g.ANGLE_A] = bodyA.angle;
  n[o + g.ANGLE_B] = bodyB.angle;
}

/** A sensor meets something: no more than whether the shapes intersect. */
export function overlap(pair: Arbiter): boolean {
  placePair(pair);
  return intersect(pair.shapeA, pair.shapeB, pair.numbers, pair.at);
}

/** Which corners and edges were found the last time, if it has two points: scratch. */
const found = { id0: 0, id1: 0, edgeA: 0, edgeB: 0 };

function noteFeatures({ shown, numbers: n, at: o }: Arbiter): void {
  if (shown < 2) {
    return;
  }
  found.id0 = n[o + g.ID0]! | 0;
  found.id1 = n[o + g.ID1]! | 0;
  found.edgeA = n[o + g.EDGE_A]! | 0;
  found.edgeB = n[o + g.EDGE_B]! | 0;
}

/** Renews what is known of the collision and carries the impulses of its points over. @returns whether the shapes collide. */
export function touch(pair: Arbiter): boolean {
  const { shapeA, shapeB, numbers: n, at: o } = pair;
  placePair(pair);
  noteFeatures(pair);
  collide(shapeA, shapeB, n, o);
  keepPoints(pair);
  return overlaps(n, o);
}

/** As `touch`, along a direction that is known: the unit vector from A to B that is the normal in the record. As arguments its numbers would be boxed. */
export function touchAlong(pair: Arbiter): void {
  noteFeatures(pair);
  collideAlong(pair.shapeA, pair.shapeB, pair.numbers, pair.at);
  keepPoints(pair);
}

/** Lists the points that were found. Those that were there before keep their impulses. */
function keepPoints(pair: Arbiter): void {
  const { shown, count, numbers: n, at: o } = pair;
  if (count === 0) {
    if (!pair.is(LISTED) && shown > 0) {
      pair.forget();
    }
  } else if (shown !== count) {
    pair.showPoints();
  } else if (count === 2 && (n[o + g.EDGE_A] !== found.edgeA || n[o + g.EDGE_B] !== found.edgeB)) {
    matchPoints(pair);
  }
}

/** Other edges than in the last step: points are recognised by the corner that limits them. */
function matchPoints(pair: Arbiter): void {
  const { numbers: n, at: o } = pair;
  const id0 = n[o + g.ID0];
  const id1 = n[o + g.ID1];
  if (id0 === found.id1) {
    pair.takePoint(0);
  } else if (id1 === found.id0) {
    pair.takePoint(1);
  } else {
    if (id0 !== found.id0) {
      pair.dropPoint(0);
    }
    if (id1 !== found.id1) {
      pair.dropPoint(1);
    }
  }
}

/** For corners that meet corners, where no edges face each other: the one point where they do. */
export function touchAtPoint(pair: Arbiter): void {
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
