import { COINCIDENT, SPECULATIVE_MARGIN } from '../config.js';
import { EDGE_STRIDE } from '../geometry/layout.js';
import type { Circle } from '../shape/circle.js';
import type { Polygon } from '../shape/polygon.js';
import * as g from './layout.js';
import type { Manifold } from './manifold.js';

/** Stores the single point half-way between two surfaces that face each other: from `(x, y)` by the separation along n. */
export function setPoint(m: Manifold, nx: number, ny: number, x: number, y: number, separation: number): void {
  m.count = 1;
  const n = m.numbers;
  n[g.NX] = nx;
  n[g.NY] = ny;
  n[g.X0] = x + nx * separation * 0.5;
  n[g.Y0] = y + ny * separation * 0.5;
  n[g.S0] = separation;
  m.id0 = 0;
}

/** Two circles. Centres that coincide are pushed apart along x. */
export function collideCircles(a: Circle, b: Circle, m: Manifold): void {
  const cx = m.numbers[g.DX]! + b.centreX - a.centreX;
  const cy = m.numbers[g.DY]! + b.centreY - a.centreY;
  const reach = a.radius + b.radius;
  const limit = reach + SPECULATIVE_MARGIN;
  const squared = cx * cx + cy * cy;
  m.count = 0;
  if (squared > limit * limit) {
    return;
  }
  const distance = Math.sqrt(squared);
  const apart = distance > COINCIDENT;
  const nx = apart ? cx / distance : 1;
  const ny = apart ? cy / distance : 0;
  setPoint(m, nx, ny, a.centreX + nx * a.radius, a.centreY + ny * a.radius, distance - reach);
}

/** A polygon and a circle. */
export function collidePolygonCircle(a: Polygon, b: Circle, m: Manifold): void {
  faceCircle(a, b, m, 1);
}

/** A circle and a polygon: the polygon's view of it, turned round. */
export function collideCirclePolygon(a: Circle, b: Polygon, m: Manifold): void {
  faceCircle(b, a, m, -1);
  const n = m.numbers;
  n[g.NX] = -n[g.NX]!;
  n[g.NY] = -n[g.NY]!;
  n[g.X0] = n[g.X0]! + n[g.DX]!;
  n[g.Y0] = n[g.Y0]! + n[g.DY]!;
}

/**
 * The circle as the polygon sees it; `side` is 1 if the polygon is A, else −1. The edge farthest from the
 * centre decides; beyond its ends the nearer corner does (Ericson, Real-Time Collision Detection, 5.1).
 */
function faceCircle(a: Polygon, b: Circle, m: Manifold, side: number): void {
  const cx = side * m.numbers[g.DX]! + b.centreX;
  const cy = side * m.numbers[g.DY]! + b.centreY;
  const edges = a.edges;
  const offsets = a.offsets;
  const limit = b.radius + SPECULATIVE_MARGIN;
  m.count = 0;
  let separation = -Infinity;
  let best = 0;
  for (let i = 0; i < offsets.length; i += 1) {
    const s = edges[EDGE_STRIDE * i + 2]! * cx + edges[EDGE_STRIDE * i + 3]! * cy - offsets[i]!;
    if (s > limit) {
      return;
    }
    if (s > separation) {
      separation = s;
      best = i;
    }
  }
  let nx = edges[EDGE_STRIDE * best + 2]!;
  let ny = edges[EDGE_STRIDE * best + 3]!;
  if (separation > 0) {
    const next = best + 1 === offsets.length ? 0 : best + 1;
    const along = nx * cy - ny * cx;
    const corner =
      along < nx * edges[EDGE_STRIDE * best + 1]! - ny * edges[EDGE_STRIDE * best]!
        ? best
        : along > nx * edges[EDGE_STRIDE * next + 1]! - ny * edges[EDGE_STRIDE * next]!
          ? next
          : -1;
    if (corner >= 0) {
      const vx = cx - edges[EDGE_STRIDE * corner]!;
      const vy = cy - edges[EDGE_STRIDE * corner + 1]!;
      const squared = vx * vx + vy * vy;
      if (squared > limit * limit) {
        return;
      }
      separation = Math.sqrt(squared);
      nx = vx / separation;
      ny = vy / separation;
    }
  }
  setPoint(m, nx, ny, cx - nx * separation, cy - ny * separation, separation - b.radius);
}
