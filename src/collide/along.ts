import { EDGE_STRIDE, EDGES } from '../geometry/layout.js';
import type { Circle } from '../shape/circle.js';
import type { Shape } from '../shape/shape.js';
import { setPoint } from './circles.js';
import * as g from './layout.js';
import { collidePolygonsAlong } from './polygons.js';
import { POLYGON } from './table.js';

/** How far a placed shape reaches along a unit vector, from the origin of its body. */
export function reachAlong(shape: Shape, nx: number, ny: number): number {
  if (shape.kind !== POLYGON) {
    const { centreX, centreY, radius } = shape;
    return nx * centreX + ny * centreY + radius;
  }
  const { numbers: n, at, offsets } = shape;
  const end = at + EDGES + EDGE_STRIDE * offsets.length;
  let most = -Infinity;
  for (let k = at + EDGES; k < end; k += EDGE_STRIDE) {
    most = Math.max(most, nx * n[k]! + ny * n[k + 1]!);
  }
  return most;
}

/** How far two placed shapes are apart along a unit vector, B's body being at `(dx, dy)` from A's. */
export function separationAlong(a: Shape, b: Shape, dx: number, dy: number, nx: number, ny: number): number {
  return nx * dx + ny * dy - reachAlong(b, -nx, -ny) - reachAlong(a, nx, ny);
}

/**
 * The part of a contact's arm that does not turn with the body: on a circle all from its centre to the contact point, half-way into the overlap;
 * on a polygon nothing.
 */
export function roundness(shape: Shape, separation: number): number {
  return shape.kind === POLYGON ? 0 : shape.radius + 0.5 * separation;
}

/** Collides two placed shapes along a direction that is known: the unit vector `(nx, ny)` from A to B. */
export function collideAlong(a: Shape, b: Shape, n: Float64Array, o: number, nx: number, ny: number): void {
  if (a.kind === POLYGON && b.kind === POLYGON) {
    collidePolygonsAlong(a, b, n, o, nx, ny);
    return;
  }
  const dx = n[o + g.DX]!;
  const dy = n[o + g.DY]!;
  const separation = separationAlong(a, b, dx, dy, nx, ny);
  const { centreX, centreY, radius } = (a.kind === POLYGON ? b : a) as Circle;
  if (a.kind === POLYGON) {
    const reach = radius + separation;
    setPoint(n, o, nx, ny, centreX + dx - nx * reach, centreY + dy - ny * reach, separation);
  } else {
    setPoint(n, o, nx, ny, centreX + nx * radius, centreY + ny * radius, separation);
  }
}
