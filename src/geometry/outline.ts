import { EDGE_STRIDE } from './layout.js';

/**
 * A convex outline somewhere in the plane: corners, and a radius around them. A polygon has radius 0, a circle is one corner with a radius.
 * Outlines are scratch space for queries and sweeps: filled in for a placement, used, filled in again.
 */
export class Outline {
  /** [x, y, nx, ny] per corner: the corner, and the outward normal of the edge that starts there. */
  corners = new Float64Array(8 * EDGE_STRIDE);
  /** n · p of each edge. */
  offsets = new Float64Array(8);
  /** Number of corners. */
  count = 0;
  /** Number of edges: as many as corners, or 0 for a single corner. */
  edges = 0;
  radius = 0;
  /** The placement to write an outline for: the origin of the shape's body, and its rotation. */
  x = 0.5;
  y = 0.5;
  cos = 0.5;
  sin = 0.5;

  put(x: number, y: number, cos: number, sin: number): this {
    this.x = x;
    this.y = y;
    this.cos = cos;
    this.sin = sin;
    return this;
  }

  /** Makes it a circle. The caller writes the centre to the start of `corners`: passed as arguments, its numbers might be boxed. */
  setCircle(radius: number): void {
    this.count = 1;
    this.edges = 0;
    this.radius = radius;
  }

  /** Makes it an axis-aligned rectangle, which may have no width or height. */
  setRectangle(minX: number, minY: number, maxX: number, maxY: number): void {
    this.count = 4;
    this.edges = 4;
    this.radius = 0;
    this.corners.set([minX, minY, 0, -1, maxX, minY, 1, 0, maxX, maxY, 0, 1, minX, maxY, -1, 0]);
    this.offsets.set([-minY, maxX, maxY, -minX]);
  }
}

/** Writes the outline of a polygon at the placement in `out`, from its corners, normals and offsets in body coordinates. */
export function outlinePolygon(out: Outline, local: Float64Array, offsets: Float64Array): void {
  const { x, y, cos, sin } = out;
  const count = offsets.length;
  if (out.offsets.length < count) {
    out.corners = new Float64Array(2 * count * EDGE_STRIDE);
    out.offsets = new Float64Array(2 * count);
  }
  out.count = count;
  out.edges = count;
  out.radius = 0;
  const to = out.corners;
  for (let i = 0; i < count * EDGE_STRIDE; i += EDGE_STRIDE) {
    const px = local[i]!;
    const py = local[i + 1]!;
    const nx = cos * local[i + 2]! - sin * local[i + 3]!;
    const ny = sin * local[i + 2]! + cos * local[i + 3]!;
    to[i] = x + cos * px - sin * py;
    to[i + 1] = y + sin * px + cos * py;
    to[i + 2] = nx;
    to[i + 3] = ny;
  }
  for (let i = 0; i < count; i += 1) {
    out.offsets[i] = offsets[i]! + x * to[EDGE_STRIDE * i + 2]! + y * to[EDGE_STRIDE * i + 3]!;
  }
}
