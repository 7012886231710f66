import * as g from '../collide/layout.js';
import type { Arbiter } from './arbiter.js';
import { clearPoint } from './arbiter.js';
import { USED, USED_BEFORE } from './bits.js';
import * as c from './layout.js';

// Points of two polygons keep their impulses from step to step. With other edges than last time, they are recognised by the corners that
// limit them.

/** Which steps used the first point; of the second one, the bits are one higher. */
const USES = (1 << USED) | (1 << USED_BEFORE);

/** The corners and edges of the two points found last time: scratch. */
const last = { id0: 0, id1: 0, edgeA: 0, edgeB: 0 };

/** To be called before a pair that shows two points is collided again. */
export function rememberFeatures({ numbers: n, at: o }: Arbiter): void {
  last.id0 = n[o + g.ID0]! | 0;
  last.id1 = n[o + g.ID1]! | 0;
  last.edgeA = n[o + g.EDGE_A]! | 0;
  last.edgeB = n[o + g.EDGE_B]! | 0;
}

/** Drops the impulses of points that are not those of last time. */
export function matchPoints(pair: Arbiter): void {
  const { numbers: n, at: o } = pair;
  if (n[o + g.EDGE_A] === last.edgeA && n[o + g.EDGE_B] === last.edgeB) {
    return;
  }
  const id0 = n[o + g.ID0];
  const id1 = n[o + g.ID1];
  if (id0 === last.id1) {
    shiftPoint(pair, 0);
  } else if (id1 === last.id0) {
    shiftPoint(pair, 1);
  } else {
    if (id0 !== last.id0) dropPoint(pair, 0);
    if (id1 !== last.id1) dropPoint(pair, 1);
  }
}

/** Drops the impulses of one point: it is new. */
function dropPoint(pair: Arbiter, which: number): void {
  clearPoint(pair.numbers, pair.at, which);
  pair.unmark(USES << which);
}

/** Point `which` is the one that used to be the other: takes over its impulses, and the other one is new. */
function shiftPoint(pair: Arbiter, which: number): void {
  const other = 1 - which;
  const to = pair.at + c.NORMAL + c.IMPULSES * which;
  const from = pair.at + c.NORMAL + c.IMPULSES * other;
  pair.numbers.copyWithin(to, from, from + c.IMPULSES);
  pair.unmark(USES << which);
  pair.mark(((pair.bits >> other) & USES) << which);
  dropPoint(pair, other);
}
