import { Along, reachAlong, separationAlong } from '../../collide/along.js';
import { polygonContains } from '../../collide/contains.js';
import { endOfEdges } from '../../collide/polygons.js';
import { FACE_GAP, FACE_LOOKS, FLUSH_TOLERANCE, IMPACT_DEPTH, SPECULATIVE_MARGIN } from '../../config.js';
import { EDGE_NX, EDGE_NY, EDGE_STRIDE, EDGES } from '../../geometry/layout.js';
import type { Polygon } from '../../shape/polygon.js';
import { halfWidthOf, type Shape } from '../../shape/shape.js';
import { POLYGON } from '../../shape/shape-kind.js';
import type { FreeDirections } from './free-directions.js';
import { around, local, mayHold, Spot } from './grounds.js';

// Where a contact lies within the grounds around, below their common surface, what carries the shape is a face beside it that is open: one
// that no other ground hides.

/** m. An edge is open only if a point this far above it is: faces that lie in each other carry as one. */
const CLEAR = 2 * FLUSH_TOLERANCE;

/** The direction that was found for a contact, from the ground to the body. */
export const up = /* @__PURE__ */ new Along();
/** The direction along which something is measured, and a point above a face, relative to the body of its ground: scratch. */
const along = /* @__PURE__ */ new Along();
const spot = /* @__PURE__ */ new Spot();

/** Whether a shape is no deeper in a ground along a direction than half of the ground. */
export function isInReach(shape: Shape, ground: Polygon, direction: Along): boolean {
  measureFrom(ground, shape, direction);
  return direction.found > -halfWidthOf(ground);
}

/** Finds the separation of a shape from a ground along a direction that points out of the ground. */
function measureFrom(ground: Polygon, shape: Shape, direction: Along): void {
  direction.dx = shape.owner!.x - ground.owner!.x;
  direction.dy = shape.owner!.y - ground.owner!.y;
  separationAlong(ground, shape, direction);
}

/**
 * Finds in `up` the normal of the face of a ground below which a shape reaches least: no deeper than half the ground, or where they are
 * apart than what lies on it. If the ground has none that is open, as what lies below the surface: a face of those around that the shape
 * lies on, that the normal of the contact does not turn away from, and above which this ground does not reach far. So an underside above
 * the shape is no such face.
 */
export function findOpenFace(shape: Shape, ground: Polygon, normal: FreeDirections, areApart: boolean): boolean {
  // How deep a shape that lies on a face may be below it.
  const lying = Math.min(IMPACT_DEPTH, halfWidthOf(shape) / 2);
  up.found = -(areApart ? lying : halfWidthOf(ground));
  if (findFaceOf(shape, ground, ground, normal, -1)) {
    return true;
  }
  up.found = -lying;
  let isFound = false;
  for (let i = 0; i < around.count; i += 1) {
    const other = around.items[i]!;
    if (other !== ground && other.kind === POLYGON) {
      isFound = findFaceOf(shape, other, ground, normal, FACE_LOOKS) || isFound;
    }
  }
  return isFound;
}

/**
 * Takes a face of a ground that a shape lies on, or below which it reaches least, if it reaches less deep there than `up.found`, and is in
 * reach of the ground that is to carry it there.
 */
function findFaceOf(shape: Shape, ground: Polygon, carrier: Polygon, normal: FreeDirections, least: number): boolean {
  const { numbers: edges, at } = ground;
  const end = endOfEdges(ground);
  let isFound = false;
  for (let k = at + EDGES; k < end; k += EDGE_STRIDE) {
    along.x = edges[k + EDGE_NX]!;
    along.y = edges[k + EDGE_NY]!;
    measureFrom(ground, shape, along);
    const { found } = along;
    const looks = normal.x * edges[k + EDGE_NX]! + normal.y * edges[k + EDGE_NY]!;
    if (
      looks >= least &&
      found > up.found &&
      found < SPECULATIVE_MARGIN &&
      isInReach(shape, carrier, along) &&
      isOpen(shape, ground, k)
    ) {
      up.found = found;
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
  spot.x = edges[edge]! - way * ny + CLEAR * nx;
  spot.y = edges[edge + 1]! + way * nx + CLEAR * ny;
  if (isInAnother(ground)) {
    return false;
  }
  spot.x = edges[edge]! - way * ny + gap * nx;
  spot.y = edges[edge + 1]! + way * nx + gap * ny;
  return !isInAnother(ground);
}

/** Whether `spot` is within another ground than the one to whose body it is relative. */
function isInAnother(ground: Polygon): boolean {
  for (let i = 0; i < around.count; i += 1) {
    const other = around.items[i]!;
    if (other !== ground && mayHold(other, ground, spot) && polygonContains(other, local, FLUSH_TOLERANCE)) {
      return true;
    }
  }
  return false;
}
