import { CENTRE_X, CENTRE_Y, EDGE_STRIDE, EDGES } from '../geometry/layout.js';
import type { Shape } from '../shape/shape.js';
import { POLYGON } from '../shape/shape-kind.js';
import { setPoint } from './circles.js';
import * as g from './layout.js';
import { works } from './polygon-works.js';
import { endOfEdges } from './polygons.js';

/** A question about shapes along a unit vector, and the answer. An object, as numbers passed from function to function would be boxed. */
export class Along {
  /** The unit vector. */
  x = 0.5;
  y = 0.5;
  /** From the origin of A's body to that of B's, m. */
  dx = 0.5;
  dy = 0.5;
  /** The answer, m. */
  found = 0.5;
}

const between = /* @__PURE__ */ new Along();

/** Writes to `along.found` how far a placed shape reaches from the origin of its body along the unit vector, or with `sign` −1 against it. */
export function reachAlong(shape: Shape, along: Along, sign: number): void {
  const nx = sign * along.x;
  const ny = sign * along.y;
  const { numbers: n, at } = shape;
  if (shape.kind !== POLYGON) {
    along.found = nx * n[at + CENTRE_X]! + ny * n[at + CENTRE_Y]! + shape.radius;
    return;
  }
  const end = endOfEdges(shape);
  let most = -Infinity;
  for (let k = at + EDGES; k < end; k += EDGE_STRIDE) {
    most = Math.max(most, nx * n[k]! + ny * n[k + 1]!);
  }
  along.found = most;
}

/** Writes to `along.found` the separation of two placed shapes along the unit vector. */
export function separationAlong(a: Shape, b: Shape, along: Along): void {
  reachAlong(b, along, -1);
  const rest = along.x * along.dx + along.y * along.dy - along.found;
  reachAlong(a, along, 1);
  along.found = rest - along.found;
}

/**
 * The length of that part of a contact's arm that does not turn with the body, m: on a circle the way from its centre to the contact point,
 * half-way into the overlap; on a polygon 0.
 */
export function roundness(shape: Shape, separation: number): number {
  return shape.kind === POLYGON ? 0 : shape.radius + 0.5 * separation;
}

/** Collides two placed shapes along a known direction: the normal in the record, a unit vector from A to B. */
export function collideAlong(a: Shape, b: Shape, n: Float64Array, o: number): void {
  if (a.kind === POLYGON && b.kind === POLYGON) {
    works!.collidePolygonsAlong(a, b, n, o);
    return;
  }
  const nx = n[o + g.NX]!;
  const ny = n[o + g.NY]!;
  const dx = n[o + g.DX]!;
  const dy = n[o + g.DY]!;
  between.x = nx;
  between.y = ny;
  between.dx = dx;
  between.dy = dy;
  separationAlong(a, b, between);
  const separation = between.found;
  const { numbers: s, at, radius } = a.kind === POLYGON ? b : a;
  const x = s[at + CENTRE_X]!;
  const y = s[at + CENTRE_Y]!;
  if (a.kind === POLYGON) {
    const reach = radius + separation;
    setPoint(n, o, nx, ny, x + dx - nx * reach, y + dy - ny * reach, separation);
  } else {
    setPoint(n, o, nx, ny, x + nx * radius, y + ny * radius, separation);
  }
}
