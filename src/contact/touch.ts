import { collideAlong } from '../collide/along.js';
import { gapBetween } from '../collide/gap.js';
import * as g from '../collide/layout.js';
import { collide, intersect } from '../collide/table.js';
import type { Arbiter } from './arbiter.js';

/** Tells the kernels how the bodies of a pair lie to each other. */
function placePair({ manifold: { numbers }, bodyA, bodyB }: Arbiter): void {
  numbers[g.DX] = bodyB.x - bodyA.x;
  numbers[g.DY] = bodyB.y - bodyA.y;
  numbers[g.ANGLE_A] = bodyA.angle;
  numbers[g.ANGLE_B] = bodyB.angle;
}

/** A sensor meets something: no more than whether the shapes intersect. */
export function overlap(pair: Arbiter): boolean {
  placePair(pair);
  return intersect(pair.shapeA, pair.shapeB, pair.manifold);
}

/** Renews the manifold and carries the impulses of its points over. @returns whether the shapes collide. */
export function touch(pair: Arbiter): boolean {
  const { shapeA, shapeB, manifold: m } = pair;
  const { id0, id1, edgeA, edgeB } = m;
  placePair(pair);
  collide(shapeA, shapeB, m);
  keepPoints(pair, id0, id1, edgeA, edgeB);
  return m.overlaps();
}

/** As `touch`, along a direction that is known: the unit vector `(nx, ny)` from A to B. */
export function touchAlong(pair: Arbiter, nx: number, ny: number): void {
  const { shapeA, shapeB, manifold: m } = pair;
  const { id0, id1, edgeA, edgeB } = m;
  collideAlong(shapeA, shapeB, m, nx, ny);
  keepPoints(pair, id0, id1, edgeA, edgeB);
}

/** Lists the points that were found. Those that were there before keep their impulses. */
function keepPoints(pair: Arbiter, id0: number, id1: number, edgeA: number, edgeB: number): void {
  const { shown, manifold: m } = pair;
  if (m.count === 0) {
    if (!pair.listed && shown > 0) {
      pair.forget();
    }
  } else if (shown !== m.count) {
    pair.showPoints();
  } else if (m.count === 2 && (m.edgeA !== edgeA || m.edgeB !== edgeB)) {
    matchPoints(pair, id0, id1);
  }
}

/** Other edges than in the last step: points are recognised by the corner that limits them. */
function matchPoints(pair: Arbiter, oldId0: number, oldId1: number): void {
  const { id0, id1 } = pair.manifold;
  if (id0 === oldId1) {
    pair.takePoint(0);
  } else if (id1 === oldId0) {
    pair.takePoint(1);
  } else {
    if (id0 !== oldId0) {
      pair.dropPoint(0);
    }
    if (id1 !== oldId1) {
      pair.dropPoint(1);
    }
  }
}

/** For corners that meet corners, where no edges face each other: the one point where they do. */
export function touchAtPoint(pair: Arbiter): void {
  const { manifold: m } = pair;
  const n = m.numbers;
  const distance = gapBetween(pair.shapeA, pair.shapeB);
  m.count = 1;
  m.face = -1;
  n[g.NX] = distance.axisX;
  n[g.NY] = distance.axisY;
  n[g.X0] = 0.5 * (distance.ax + distance.bx);
  n[g.Y0] = 0.5 * (distance.ay + distance.by);
  n[g.S0] = distance.value;
  pair.showPoints();
}
