import { COINCIDENT, SPECULATIVE_MARGIN } from '../config.js';
import { CENTRE_X, CENTRE_Y, EDGE_NX, EDGE_NY, EDGE_STRIDE, EDGES } from '../geometry/layout.js';
import type { Circle } from '../shape/circle.js';
import type { Polygon } from '../shape/polygon.js';
import * as g from './layout.js';

/**
 * Writes a manifold of one point, half-way between two surfaces that face each other. `(x, y)` is on the surface of A, and the separation
 * leads from there along n to that of B.
 */
export function setPoint(
  n: Float64Array,
  o: number,
  nx: number,
  ny: number,
  x: number,
  y: number,
  separation: number,
): void {
  n[o + g.COUNT] = 1;
  n[o + g.NX] = nx;
  n[o + g.NY] = ny;
  n[o + g.X0] = x + nx * separation * 0.5;
  n[o + g.Y0] = y + ny * separation * 0.5;
  n[o + g.S0] = separation;
  n[o + g.ID0] = 0;
}

/** Collides two circles. If their centres coincide, the normal is the x-axis. */
export function collideCircles(a: Circle, b: Circle, n: Float64Array, o: number): void {
  const ax = a.numbers[a.at + CENTRE_X]!;
  const ay = a.numbers[a.at + CENTRE_Y]!;
  const cx = n[o + g.DX]! + b.numbers[b.at + CENTRE_X]! - ax;
  const cy = n[o + g.DY]! + b.numbers[b.at + CENTRE_Y]! - ay;
  const reach = a.radius + b.radius;
  const limit = reach + SPECULATIVE_MARGIN;
  const squared = cx * cx + cy * cy;
  n[o + g.COUNT] = 0;
  if (squared > limit * limit) {
    return;
  }
  const distance = Math.sqrt(squared);
  const apart = distance > COINCIDENT;
  const nx = apart ? cx / distance : 1;
  const ny = apart ? cy / distance : 0;
  setPoint(n, o, nx, ny, ax + nx * a.radius, ay + ny * a.radius, distance - reach);
}

/** Collides a polygon and a circle. */
export function collidePolygonCircle(a: Polygon, b: Circle, n: Float64Array, o: number): void {
  faceCircle(a, b, n, o, 1);
}

/** Collides a circle and a polygon: as `collidePolygonCircle`, with A and B exchanged. */
export function collideCirclePolygon(a: Circle, b: Polygon, n: Float64Array, o: number): void {
  faceCircle(b, a, n, o, -1);
  n[o + g.NX] = -n[o + g.NX]!;
  n[o + g.NY] = -n[o + g.NY]!;
  n[o + g.X0] = n[o + g.X0]! + n[o + g.DX]!;
  n[o + g.Y0] = n[o + g.Y0]! + n[o + g.DY]!;
}

/**
 * Collides a circle with a polygon, as if the polygon were A; `side` is 1 if it is, else −1. The edge with the largest separation from the
 * centre decides; beyond its ends, the nearer corner does (Ericson, Real-Time Collision Detection, 5.1).
 */
function faceCircle(a: Polygon, b: Circle, n: Float64Array, o: number, side: number): void {
  const cx = side * n[o + g.DX]! + b.numbers[b.at + CENTRE_X]!;
  const cy = side * n[o + g.DY]! + b.numbers[b.at + CENTRE_Y]!;
  const edges = a.numbers;
  const from = a.at + EDGES;
  const offsets = a.offsets;
  const limit = b.radius + SPECULATIVE_MARGIN;
  n[o + g.COUNT] = 0;
  let separation = -Infinity;
  let best = 0;
  for (let i = 0; i < offsets.length; i += 1) {
    const s =
      edges[from + EDGE_STRIDE * i + EDGE_NX]! * cx + edges[from + EDGE_STRIDE * i + EDGE_NY]! * cy - offsets[i]!;
    if (s > limit) {
      return;
    }
    if (s > separation) {
      separation = s;
      best = i;
    }
  }
  let nx = edges[from + EDGE_STRIDE * best + EDGE_NX]!;
  let ny = edges[from + EDGE_STRIDE * best + EDGE_NY]!;
  if (separation > 0) {
    const next = best + 1 === offsets.length ? 0 : best + 1;
    const along = nx * cy - ny * cx;
    const corner =
      along < nx * edges[from + EDGE_STRIDE * best + 1]! - ny * edges[from + EDGE_STRIDE * best]!
        ? best
        : along > nx * edges[from + EDGE_STRIDE * next + 1]! - ny * edges[from + EDGE_STRIDE * next]!
          ? next
          : -1;
    if (corner >= 0) {
      const vx = cx - edges[from + EDGE_STRIDE * corner]!;
      const vy = cy - edges[from + EDGE_STRIDE * corner + 1]!;
      const squared = vx * vx + vy * vy;
      if (squared > limit * limit) {
        return;
      }
      separation = Math.sqrt(squared);
      // A centre so near to the corner that the square of the distance is 0 keeps the normal of the edge.
      if (separation > 0) {
        nx = vx / separation;
        ny = vy / separation;
      }
    }
  }
  setPoint(n, o, nx, ny, cx - nx * separation, cy - ny * separation, separation - b.radius);
}
