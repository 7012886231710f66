import { EDGE_STRIDE } from './layout.js';
import type { Outline } from './outline.js';

/** The signed distance of two outlines, and where it is measured. */
export class Distance {
  /** m; if they overlap, minus the shortest translation that separates them. */
  value = 0;
  /** Unit vector from A towards B: the witness point of B is that of A plus this times the distance. */
  axisX = 1;
  axisY = 0;
  /** The witness points, one on each outline: the distance is between them. */
  ax = 0;
  ay = 0;
  bx = 0;
  by = 0;
}

/** Relative to the size of the outlines: a corner that is as deep as the deepest but for this counts as level with it. */
const LEVEL = 1e-12;

/** Of both outlines, the edge with the largest separation from the other outline: scratch. */
const best = { separation: 0.5, edge: 0, corner: 0, ofB: false };

/**
 * The best edge: its normal, its ends along (−ny, nx), n · p of the nearest corner of the other outline, and where along the edge that is
 * nearest. Scratch; numbers passed from function to function would be boxed.
 */
const span = { nx: 0.5, ny: 0.5, start: 0.5, end: 0.5, height: 0.5, along: 0.5 };

/**
 * The signed distance of two convex outlines. The edge with the largest separation, of both outlines, gives the depth if they overlap, and
 * the distance if the nearest corner lies above that edge. Otherwise two corners are nearest to each other, or a corner and another edge:
 * only then are all pairs compared. So nothing iterates, and the result is exact to rounding (Ericson, Real-Time Collision Detection, 5.1
 * and 9.5; an iterative method such as GJK would be faster for outlines of more than some twenty corners).
 */
export function measureDistance(a: Outline, b: Outline, out: Distance): void {
  best.separation = -Infinity;
  findEdge(a, b, false);
  findEdge(b, a, true);
  if (!meetEdge(a, b, out)) {
    meetNearest(a, b, out);
  }
  out.value -= a.radius + b.radius;
  out.ax += out.axisX * a.radius;
  out.ay += out.axisY * a.radius;
  out.bx -= out.axisX * b.radius;
  out.by -= out.axisY * b.radius;
}

/** Finds the edge of P with the largest separation from Q, and writes it to `best` if that is larger than what is there. */
function findEdge(p: Outline, q: Outline, ofB: boolean): void {
  const { corners: pc, offsets } = p;
  const qc = q.corners;
  const end = q.count * EDGE_STRIDE;
  for (let i = 0; i < p.edges; i += 1) {
    const nx = pc[EDGE_STRIDE * i + 2]!;
    const ny = pc[EDGE_STRIDE * i + 3]!;
    const offset = offsets[i]!;
    let least = Infinity;
    let corner = 0;
    for (let k = 0; k < end; k += EDGE_STRIDE) {
      const s = nx * qc[k]! + ny * qc[k + 1]! - offset;
      if (s < least) {
        least = s;
        corner = k;
        if (s <= best.separation) break;
      }
    }
    if (least > best.separation) {
      best.separation = least;
      best.edge = i;
      best.corner = corner / EDGE_STRIDE;
      best.ofB = ofB;
    }
  }
}

/**
 * Measures the distance from the best edge, if that is right: always if the outlines overlap, else if the nearest corner, or some point
 * between it and another one that is level with it, lies above the edge. @returns whether it is.
 */
function meetEdge(a: Outline, b: Outline, out: Distance): boolean {
  const { separation, edge, ofB } = best;
  if (separation === -Infinity) {
    return false;
  }
  const p = ofB ? b : a;
  const q = ofB ? a : b;
  const { corners: pc } = p;
  const i = EDGE_STRIDE * edge;
  const j = edge + 1 === p.count ? 0 : i + EDGE_STRIDE;
  const nx = pc[i + 2]!;
  const ny = pc[i + 3]!;
  const start = nx * pc[i + 1]! - ny * pc[i]!;
  const end = nx * pc[j + 1]! - ny * pc[j]!;
  span.nx = nx;
  span.ny = ny;
  span.start = start;
  span.end = end;
  span.height = separation + p.offsets[edge]!;
  findLevel(q);
  const { along } = span;
  const level = LEVEL * (Math.abs(start) + Math.abs(end) + Math.abs(p.offsets[edge]!));
  // The tips of long needles may be far apart where one lies hardly above the line of the other's edge.
  const slack = separation > level ? 0 : separation > 0 ? level : Infinity;
  if (along < start - slack || along > end + slack) {
    return false;
  }
  const side = ofB ? -1 : 1;
  const footX = nx * p.offsets[edge]! - ny * along;
  const footY = ny * p.offsets[edge]! + nx * along;
  const cornerX = footX + nx * separation;
  const cornerY = footY + ny * separation;
  out.value = separation;
  out.axisX = side * nx;
  out.axisY = side * ny;
  out.ax = ofB ? cornerX : footX;
  out.ay = ofB ? cornerY : footY;
  out.bx = ofB ? footX : cornerX;
  out.by = ofB ? footY : cornerY;
  return true;
}

/**
 * Finds where along the edge the other outline is nearest: at its nearest corner, or, if an edge is parallel, in the middle of what the two
 * edges share.
 */
function findLevel(q: Outline): void {
  const { nx, ny, start, end, height } = span;
  const qc = q.corners;
  const first = EDGE_STRIDE * best.corner;
  const tolerance = LEVEL * (Math.abs(start) + Math.abs(end) + Math.abs(height));
  let low = nx * qc[first + 1]! - ny * qc[first]!;
  let high = low;
  for (let k = 0; k < q.count * EDGE_STRIDE; k += EDGE_STRIDE) {
    if (nx * qc[k]! + ny * qc[k + 1]! - height <= tolerance) {
      const along = nx * qc[k + 1]! - ny * qc[k]!;
      if (along < low) low = along;
      if (along > high) high = along;
    }
  }
  const from = Math.max(low, start);
  const to = Math.min(high, end);
  span.along = from <= to ? 0.5 * (from + to) : low > end ? low : high;
}

/** Compares all corners with all corners, and all edges with the corners above them. */
function meetNearest(a: Outline, b: Outline, out: Distance): void {
  let least = Infinity;
  const { corners: ac } = a;
  const { corners: bc } = b;
  for (let i = 0; i < a.count * EDGE_STRIDE; i += EDGE_STRIDE) {
    for (let k = 0; k < b.count * EDGE_STRIDE; k += EDGE_STRIDE) {
      const x = bc[k]! - ac[i]!;
      const y = bc[k + 1]! - ac[i + 1]!;
      const squared = x * x + y * y;
      if (squared < least) {
        least = squared;
        out.ax = ac[i]!;
        out.ay = ac[i + 1]!;
        out.bx = bc[k]!;
        out.by = bc[k + 1]!;
      }
    }
  }
  const x = out.bx - out.ax;
  const y = out.by - out.ay;
  const length = Math.sqrt(x * x + y * y);
  out.value = length;
  out.axisX = length > 0 ? x / length : 1;
  out.axisY = length > 0 ? y / length : 0;
  compareEdges(a, b, out, 1);
  compareEdges(b, a, out, -1);
}

/** Takes any corner of Q above an edge of P that is nearer to it than `out` says; `side` is 1 if P is A, else −1. */
function compareEdges(p: Outline, q: Outline, out: Distance, side: number): void {
  const { corners: pc, offsets } = p;
  const qc = q.corners;
  for (let e = 0; e < p.edges; e += 1) {
    const i = EDGE_STRIDE * e;
    const j = e + 1 === p.count ? 0 : i + EDGE_STRIDE;
    const nx = pc[i + 2]!;
    const ny = pc[i + 3]!;
    const offset = offsets[e]!;
    const start = nx * pc[i + 1]! - ny * pc[i]!;
    const end = nx * pc[j + 1]! - ny * pc[j]!;
    for (let k = 0; k < q.count * EDGE_STRIDE; k += EDGE_STRIDE) {
      const x = qc[k]!;
      const y = qc[k + 1]!;
      const height = nx * x + ny * y - offset;
      const along = nx * y - ny * x;
      if (height > 0 && height < out.value && along > start && along < end) {
        out.value = height;
        out.axisX = side * nx;
        out.axisY = side * ny;
        const footX = x - nx * height;
        const footY = y - ny * height;
        out.ax = side > 0 ? footX : x;
        out.ay = side > 0 ? footY : y;
        out.bx = side > 0 ? x : footX;
        out.by = side > 0 ? y : footY;
      }
    }
  }
}
