import type { Circle } from '../shape/circle.js';
import type { Polygon } from '../shape/polygon.js';
import type { Shape } from '../shape/shape.js';
import { collideCirclePolygon, collideCircles, collidePolygonCircle } from './circles.js';
import type { Manifold } from './manifold.js';
import { collidePolygons, polygonsIntersect } from './polygons.js';

/** Reads the placement from the manifold and writes the rest; `count` 0 means that the shapes are apart. */
type Kernel<A extends Shape, B extends Shape> = (a: A, b: B, m: Manifold) => void;

const KINDS = 2;
/** `kind` of polygons. */
export const POLYGON = 1;

/** Which kernel serves which pair, at `kindOfA · KINDS + kindOfB`. */
const KERNELS: readonly [
  Kernel<Circle, Circle>,
  Kernel<Circle, Polygon>,
  Kernel<Polygon, Circle>,
  Kernel<Polygon, Polygon>,
] = [collideCircles, collideCirclePolygon, collidePolygonCircle, collidePolygons];

/** Collides two placed shapes; the manifold says how their bodies lie to each other. */
export function collide(a: Shape, b: Shape, m: Manifold): void {
  (KERNELS[a.kind * KINDS + b.kind] as Kernel<Shape, Shape>)(a, b, m);
}

/** Whether two placed shapes intersect; touching counts. The manifold, which says how their bodies lie, stays empty. */
export function intersect(a: Shape, b: Shape, m: Manifold): boolean {
  if (a.kind === POLYGON && b.kind === POLYGON) {
    return polygonsIntersect(a, b, m);
  }
  collide(a, b, m);
  const found = m.overlaps();
  m.empty();
  return found;
}
