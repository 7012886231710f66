import { endOfEdges } from '../../collide/polygons.js';
import { SPECULATIVE_MARGIN } from '../../config.js';
import { crosses, crossing } from '../../geometry/crossing.js';
import { EDGE_NX, EDGE_NY, EDGE_STRIDE, EDGES } from '../../geometry/layout.js';
import type { Polygon } from '../../shape/polygon.js';
import type { Shape } from '../../shape/shape.js';
import { growBounds, HALF_MARGIN, squareAround } from '../bounds.js';
import type { Mover } from './movers.js';

// Shapes are placed where the step began; from there their bodies move straight on and turn.

/** Writes the bounds of all places that a shape can have on the way of its body. */
export function sweepBounds({ body, dx, dy, turn, until }: Mover, { numbers: n, at }: Shape, out: Float64Array): void {
  const swing = Math.abs(turn) * body.radius;
  const x = dx * until;
  const y = dy * until;
  out[0] = n[at]! + Math.min(x, 0) - swing;
  out[1] = n[at + 1]! + Math.min(y, 0) - swing;
  out[2] = n[at + 2]! + Math.max(x, 0) + swing;
  out[3] = n[at + 3]! + Math.max(y, 0) + swing;
}

/**
 * Whether the bounds of two shapes may meet at one time, and when at the earliest: seen from B, the bounds of A move by the difference of
 * both ways.
 */
export function mayMeet(one: Mover, { numbers: a, at: i }: Shape, two: Mover, { numbers: b, at: j }: Shape): boolean {
  // As for the bounds in the broadphase: more than the distance at which shapes still count as meeting, and than rounding.
  crossing[0] = one.dx - two.dx;
  crossing[1] = one.dy - two.dy;
  crossing[2] = Math.abs(one.turn) * one.body.radius + Math.abs(two.turn) * two.body.radius + SPECULATIVE_MARGIN / 2;
  return crosses(a, i, b, j);
}

const way = { reach: 0.5 };

/** Writes a square that holds all places of a body on the rest of its way, however it turns. */
export function squareOfWay({ body, x, y, dx, dy }: Mover, out: Float64Array): void {
  squareAround(x, y, Math.abs(dx) + Math.abs(dy) + body.radius, out);
}

/** Writes the bounds of all places that a shape without a mover can have in this step. */
export function widenBounds(shape: Shape, ahead: boolean, out: Float64Array): void {
  const { lastDx, lastDy, lastTurn, radius } = shape.owner!;
  way.reach = Math.abs(lastDx) + Math.abs(lastDy) + Math.abs(lastTurn) * radius;
  growBounds(shape, ahead ? HALF_MARGIN : way, out);
}

/**
 * Whether bounds lie beyond an edge of a polygon all the time that it is on its way: the bounds of a long one that is turned are much
 * larger than it.
 */
export function isBeyondEdge(mover: Mover, shape: Polygon, bounds: Float64Array): boolean {
  const { body, dx, dy } = mover;
  const { numbers: edges, at } = shape;
  const end = endOfEdges(shape);
  const slack = Math.abs(mover.turn) * body.radius + SPECULATIVE_MARGIN / 2;
  const x = 0.5 * (bounds[0]! + bounds[2]!) - mover.startX;
  const y = 0.5 * (bounds[1]! + bounds[3]!) - mover.startY;
  const halfX = 0.5 * (bounds[2]! - bounds[0]!);
  const halfY = 0.5 * (bounds[3]! - bounds[1]!);
  for (let k = at + EDGES; k < end; k += EDGE_STRIDE) {
    const nx = edges[k + EDGE_NX]!;
    const ny = edges[k + EDGE_NY]!;
    const height = nx * (x - edges[k]!) + ny * (y - edges[k + 1]!) - Math.abs(nx) * halfX - Math.abs(ny) * halfY;
    if (height > Math.max(0, nx * dx + ny * dy) + slack) {
      return true;
    }
  }
  return false;
}
