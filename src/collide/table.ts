import type { Circle } from '../shape/circle.js';
import type { Polygon } from '../shape/polygon.js';
import type { Shape } from '../shape/shape.js';
import { POLYGON } from '../shape/shape-kind.js';
import { collideCirclePolygon, collideCircles, collidePolygonCircle } from './circles.js';
import { empty, overlaps } from './manifold.js';
import { collidePolygons, polygonsIntersect } from './polygons.js';

/** Reads the placement from the record of a pair and writes the rest; a count of 0 means that the shapes are apart. */
type Kernel<A extends Shape, B extends Shape> = (a: A, b: B, n: Float64Array, o: number) => void;

const KINDS = 2;

/** Which kernel serves which pair, at `kindOfA · KINDS + kindOfB`. */
const KERNELS: readonly [
  Kernel<Circle, Circle>,
  Kernel<Circle, Polygon>,
  Kernel<Polygon, Circle>,
  Kernel<Polygon, Polygon>,
] = [collideCircles, collideCirclePolygon, collidePolygonCircle, collidePolygons];

/** Collides two placed shapes; the manifold says how their bodies lie to each other. */
export function collide(a: Shape, b: Shape, n: Float64Array, o: number): void {
  (KERNELS[a.kind * KINDS + b.kind] as Kernel<Shape, Shape>)(a, b, n, o);
}

/** Whether two placed shapes intersect; touching counts. The record, which says how their bodies lie, gets no points. */
export function intersect(a: Shape, b: Shape, n: Float64Array, o: number): boolean {
  if (a.kind === POLYGON && b.kind === POLYGON) {
    return polygonsIntersect(a, b, n, o);
  }
  collide(a, b, n, o);
  const found = overlaps(n, o);
  empty(n, o);
  return found;
}
