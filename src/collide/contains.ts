import { CIRCLE_POINT_TOLERANCE, POLYGON_POINT_TOLERANCE } from '../config.js';
import { CENTRE_X, CENTRE_Y, EDGE_NX, EDGE_NY, EDGE_STRIDE, EDGES } from '../geometry/layout.js';
import type { Polygon } from '../shape/polygon.js';
import type { Shape } from '../shape/shape.js';
import { POLYGON } from '../shape/shape-kind.js';
import { works } from './polygon-works.js';

const asked = /* @__PURE__ */ new Float64Array(2);

/** Whether a placed shape contains a point, given relative to the origin of its body; the boundary counts. */
export function containsPoint(shape: Shape, x: number, y: number): boolean {
  if (shape.kind !== POLYGON) {
    const { numbers: n, at, radius } = shape;
    const dx = x - n[at + CENTRE_X]!;
    const dy = y - n[at + CENTRE_Y]!;
    return dx * dx + dy * dy - radius * radius <= CIRCLE_POINT_TOLERANCE;
  }
  asked[0] = x;
  asked[1] = y;
  return works!.polygonContains(shape, asked, POLYGON_POINT_TOLERANCE);
}

/**
 * Whether a point, given relative to the origin of the body, is at most a tolerance beyond every edge of a placed polygon. With 0, whether
 * the polygon contains it.
 */
export function polygonContains({ numbers: n, at, offsets }: Polygon, point: Float64Array, tolerance: number): boolean {
  const x = point[0]!;
  const y = point[1]!;
  for (let i = 0; i < offsets.length; i += 1) {
    const edge = at + EDGES + EDGE_STRIDE * i;
    const height = n[edge + EDGE_NX]! * x + n[edge + EDGE_NY]! * y - offsets[i]!;
    if (height > tolerance) {
      return false;
    }
  }
  return true;
}
