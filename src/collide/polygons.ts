import { FACE_TIE, SPECULATIVE_MARGIN } from '../config.js';
import { EDGE_NX, EDGE_NY, EDGE_STRIDE, EDGES } from '../geometry/layout.js';
import type { Polygon } from '../shape/polygon.js';
import * as g from './layout.js';
import { keepsFace, noteFace } from './manifold.js';

/**
 * The result of `deepestEdge`: the edge with the largest separation so far. Scratch that is dead when the kernel returns; an object, so
 * that nothing is boxed.
 */
const best = { separation: -Infinity, edge: 0 };

/** The index after the last edge of a polygon in its numbers. */
export function endOfEdges({ at, offsets }: Polygon): number {
  return at + EDGES + EDGE_STRIDE * offsets.length;
}

/**
 * Whether edge `i` of P separates Q by more than the speculative margin: the separation is min over Q's corners q of n · q − offset. `side`
 * is 1 if P is A, else −1.
 */
function isBeyond(p: Polygon, i: number, q: Polygon, n: Float64Array, o: number, side: number): boolean {
  const ox = side * n[o + g.DX]!;
  const oy = side * n[o + g.DY]!;
  const edges = q.numbers;
  const nx = p.numbers[p.at + EDGES + EDGE_STRIDE * i + EDGE_NX]!;
  const ny = p.numbers[p.at + EDGES + EDGE_STRIDE * i + EDGE_NY]!;
  const end = endOfEdges(q);
  let least = Infinity;
  for (let k = q.at + EDGES; k < end; k += EDGE_STRIDE) {
    const s = nx * edges[k]! + ny * edges[k + 1]!;
    if (s < least) least = s;
  }
  return least + nx * ox + ny * oy - p.offsets[i]! > SPECULATIVE_MARGIN;
}

/**
 * Finds the edge of P with the largest separation from Q, and writes it to `best` if that is larger than what is there; `side` is 1 if P is
 * A, else −1. Starts with a likely edge, gives an edge up at the first corner that makes it no better, and stops at one that separates the
 * shapes.
 */
function deepestEdge(p: Polygon, q: Polygon, n: Float64Array, o: number, side: number, likely: number): void {
  const pe = p.numbers;
  const qe = q.numbers;
  const from = p.at + EDGES;
  const first = q.at + EDGES;
  const end = endOfEdges(q);
  const offsets = p.offsets;
  const count = offsets.length;
  const ox = side * n[o + g.DX]!;
  const oy = side * n[o + g.DY]!;
  let deepest = best.separation;
  let i = likely >= 0 && likely < count ? likely : 0;
  for (let tried = 0; tried < count; tried += 1) {
    const nx = pe[from + EDGE_STRIDE * i + 2]!;
    const ny = pe[from + EDGE_STRIDE * i + 3]!;
    const base = nx * ox + ny * oy - offsets[i]!;
    let least = Infinity;
    for (let k = first; k < end; k += EDGE_STRIDE) {
      const s = base + nx * qe[k]! + ny * qe[k + 1]!;
      if (s < least) {
        least = s;
        if (s <= deepest) break;
      }
    }
    if (least > deepest) {
      deepest = least;
      best.edge = i;
      if (least > SPECULATIVE_MARGIN) break;
    }
    i = i + 1 === count ? 0 : i + 1;
  }
  best.separation = deepest;
}

/** The edge of Q whose normal is most opposed to `(nx, ny)`. */
function opposedEdge(q: Polygon, nx: number, ny: number): number {
  const edges = q.numbers;
  const first = q.at + EDGES;
  const end = endOfEdges(q);
  let least = Infinity;
  let found = first;
  for (let k = first; k < end; k += EDGE_STRIDE) {
    const d = nx * edges[k + EDGE_NX]! + ny * edges[k + EDGE_NY]!;
    if (d < least) {
      least = d;
      found = k;
    }
  }
  return (found - first) / EDGE_STRIDE;
}

/**
 * Collides two polygons. Among the normals of all edges, the axis of largest separation gives the reference edge (ties go to A), and the
 * opposed edge of the other polygon is clipped to its width (Catto, "Contact Manifolds", GDC 2007). The last separating axis is tried
 * first, and the choice of edges is kept while it can hardly change.
 */
export function collidePolygons(a: Polygon, b: Polygon, n: Float64Array, o: number): void {
  n[o + g.COUNT] = 0;
  locateB(a, n, o);
  const stamp = a.geometryStamp + b.geometryStamp;
  if (keepsFace(n, o, stamp, b.owner!.radius) && clipToFace(a, b, n, o)) {
    return;
  }
  n[o + g.COUNT] = 0;
  n[o + g.FACE] = -1;
  if (!isStillApart(a, b, n, o) && chooseFace(a, b, n, o)) {
    noteFace(n, o, stamp);
    clipToFace(a, b, n, o);
  }
}

/** Writes the origin of B in the coordinates of A to the record. */
function locateB({ owner }: Polygon, n: Float64Array, o: number): void {
  const { cos, sin } = owner!;
  const dx = n[o + g.DX]!;
  const dy = n[o + g.DY]!;
  n[o + g.LOCAL_X] = cos * dx + sin * dy;
  n[o + g.LOCAL_Y] = cos * dy - sin * dx;
}

/** @returns as `clip`. */
function clipToFace(a: Polygon, b: Polygon, n: Float64Array, o: number): boolean {
  if (n[o + g.FACE] === 0) {
    return clip(a, n[o + g.EDGE_A]! | 0, b, n, o, 1);
  }
  const isRight = clip(b, n[o + g.EDGE_B]! | 0, a, n, o, -1);
  if (n[o + g.COUNT]! > 0) exchangeSides(n, o);
  return isRight;
}

/** Chooses the reference edge. @returns whether the shapes are within the speculative margin of each other. */
function chooseFace(a: Polygon, b: Polygon, n: Float64Array, o: number): boolean {
  best.separation = -Infinity;
  deepestEdge(a, b, n, o, 1, n[o + g.EDGE_A]! | 0);
  if (best.separation > SPECULATIVE_MARGIN) {
    n[o + g.AXIS] = 2 * best.edge;
    return false;
  }
  const edgeA = best.edge;
  best.separation += FACE_TIE;
  best.edge = -1;
  deepestEdge(b, a, n, o, -1, n[o + g.EDGE_B]! | 0);
  const edgeB = best.edge;
  if (edgeB < 0) {
    n[o + g.FACE] = 0;
    n[o + g.EDGE_A] = edgeA;
    return true;
  }
  if (best.separation > SPECULATIVE_MARGIN) {
    n[o + g.AXIS] = 2 * edgeB + 1;
    return false;
  }
  n[o + g.FACE] = 1;
  n[o + g.EDGE_B] = edgeB;
  return true;
}

/**
 * Whether two polygons intersect, that is no edge of either separates them; touching counts. Keeps the separating edge in the record, to
 * start there next time.
 */
export function polygonsIntersect(a: Polygon, b: Polygon, n: Float64Array, o: number): boolean {
  best.separation = -Infinity;
  deepestEdge(a, b, n, o, 1, n[o + g.EDGE_A]! | 0);
  n[o + g.EDGE_A] = best.edge;
  if (best.separation > 0) {
    return false;
  }
  best.separation = -Infinity;
  deepestEdge(b, a, n, o, -1, n[o + g.EDGE_B]! | 0);
  n[o + g.EDGE_B] = best.edge;
  return best.separation <= 0;
}

/**
 * As `collidePolygons`, but the reference edge is the one whose normal is closest to the direction in the record, the normal from A to B,
 * or to its opposite.
 */
export function collidePolygonsAlong(a: Polygon, b: Polygon, n: Float64Array, o: number): void {
  const nx = n[o + g.NX]!;
  const ny = n[o + g.NY]!;
  n[o + g.COUNT] = 0;
  const edgeA = opposedEdge(a, -nx, -ny);
  const edgeB = opposedEdge(b, nx, ny);
  n[o + g.EDGE_A] = edgeA;
  n[o + g.EDGE_B] = edgeB;
  locateB(a, n, o);
  const atA = a.at + EDGES + EDGE_STRIDE * edgeA;
  const atB = b.at + EDGES + EDGE_STRIDE * edgeB;
  const alongA = a.numbers[atA + EDGE_NX]! * nx + a.numbers[atA + EDGE_NY]! * ny;
  const alongB = b.numbers[atB + EDGE_NX]! * nx + b.numbers[atB + EDGE_NY]! * ny;
  n[o + g.FACE] = alongA >= -alongB - FACE_TIE ? 0 : 1;
  noteFace(n, o, a.geometryStamp + b.geometryStamp);
  clipToFace(a, b, n, o);
}

/** Whether the axis that separated the shapes last time still does. */
function isStillApart(a: Polygon, b: Polygon, n: Float64Array, o: number): boolean {
  const axis = n[o + g.AXIS]! | 0;
  const edge = axis >> 1;
  if (axis < 0) {
    return false;
  }
  return (axis & 1) === 0
    ? edge < a.offsets.length && isBeyond(a, edge, b, n, o, 1)
    : edge < b.offsets.length && isBeyond(b, edge, a, n, o, -1);
}

/**
 * Clips the edge of Q that faces edge `i` of P to the width of that edge, with P as A and Q as B:
 *
 *     Q   w1 <──────────── w2        the ends are sorted by t = (−ny, nx), along which P's edges run
 *     P        v1 ──────> v2         low = max(v1, w2), high = min(v2, w1)
 *
 * Edges that are apart and side by side do not face each other: no points.
 *
 * @returns `false` if the edges are side by side though one end is below the other's line. If the edge was not chosen for the present
 * placement, there may be a gap between the shapes then.
 */
function clip(p: Polygon, i: number, q: Polygon, n: Float64Array, o: number, side: number): boolean {
  const ox = side * n[o + g.DX]!;
  const oy = side * n[o + g.DY]!;
  const pe = p.numbers;
  const qe = q.numbers;
  const from = p.at + EDGES;
  const other = q.at + EDGES;
  const next = i + 1 === p.offsets.length ? 0 : i + 1;
  const nx = pe[from + EDGE_STRIDE * i + 2]!;
  const ny = pe[from + EDGE_STRIDE * i + 3]!;
  const j = opposedEdge(q, nx, ny);
  const after = j + 1 === q.offsets.length ? 0 : j + 1;
  const v1 = nx * pe[from + EDGE_STRIDE * i + 1]! - ny * pe[from + EDGE_STRIDE * i]!;
  const v2 = nx * pe[from + EDGE_STRIDE * next + 1]! - ny * pe[from + EDGE_STRIDE * next]!;
  const x1 = qe[other + EDGE_STRIDE * j]! + ox;
  const y1 = qe[other + EDGE_STRIDE * j + 1]! + oy;
  const x2 = qe[other + EDGE_STRIDE * after]! + ox;
  const y2 = qe[other + EDGE_STRIDE * after + 1]! + oy;
  const w1 = nx * y1 - ny * x1;
  const w2 = nx * y2 - ny * x2;
  const d1 = nx * x1 + ny * y1 - p.offsets[i]!;
  const d2 = nx * x2 + ny * y2 - p.offsets[i]!;
  const areBeside = w1 <= v1 || w2 >= v2;
  if (d1 >= 0 && d2 >= 0 && areBeside) {
    return true;
  }
  const width = w1 - w2;
  const scale = width > 0 ? 1 / width : 0;
  const low = v1 > w2 && v1 < w1 ? (v1 - w2) * scale : 0;
  const high = v2 < w1 && v2 > w2 ? (v2 - w2) * scale : 1;
  const lowDepth = d2 + (d1 - d2) * low;
  const highDepth = d2 + (d1 - d2) * high;
  n[o + g.COUNT] = 2;
  n[o + g.NX] = nx;
  n[o + g.NY] = ny;
  n[o + g.X0] = x2 + (x1 - x2) * low - nx * lowDepth * 0.5;
  n[o + g.Y0] = y2 + (y1 - y2) * low - ny * lowDepth * 0.5;
  n[o + g.S0] = lowDepth;
  n[o + g.X1] = x2 + (x1 - x2) * high - nx * highDepth * 0.5;
  n[o + g.Y1] = y2 + (y1 - y2) * high - ny * highDepth * 0.5;
  n[o + g.S1] = highDepth;
  n[o + g.ID0] = low > 0 ? 2 * i : 2 * after + 1;
  n[o + g.ID1] = high < 1 ? 2 * next : 2 * j + 1;
  if (side > 0) {
    n[o + g.EDGE_B] = j;
  } else {
    n[o + g.EDGE_A] = j;
  }
  // An end below the line, but nothing above the edge: if the edge was not chosen for this placement, the corner may have entered P through
  // another one.
  return !areBeside && (lowDepth < 0 || highDepth < 0 || (d1 >= 0 && d2 >= 0));
}

/** Turns a manifold with B as the reference into one from A to B: the normal is reversed, and with it the order of the points. */
function exchangeSides(n: Float64Array, o: number): void {
  const x0 = n[o + g.X0]!;
  const y0 = n[o + g.Y0]!;
  const s0 = n[o + g.S0]!;
  const id0 = n[o + g.ID0]!;
  n[o + g.NX] = -n[o + g.NX]!;
  n[o + g.NY] = -n[o + g.NY]!;
  n[o + g.X0] = n[o + g.X1]! + n[o + g.DX]!;
  n[o + g.Y0] = n[o + g.Y1]! + n[o + g.DY]!;
  n[o + g.S0] = n[o + g.S1]!;
  n[o + g.X1] = x0 + n[o + g.DX]!;
  n[o + g.Y1] = y0 + n[o + g.DY]!;
  n[o + g.S1] = s0;
  n[o + g.ID0] = n[o + g.ID1]! ^ 1;
  n[o + g.ID1] = id0 ^ 1;
}
