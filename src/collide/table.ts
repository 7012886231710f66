import type { Circle } from '../shape/circle.js';
import type { Polygon } from '../shape/polygon.js';
import type { Shape } from '../shape/shape.js';
import { collideCirclePolygon, collideCircles, collidePolygonCircle } from './circles.js';
import type { Manifold } from './manifold.js';
import { collidePolygons } from './polygons.js';

/** `(dx, dy)` leads from body A's origin to body B's. Writes the manifold; `count` 0 means no collision. */
type Kernel<A extends Shape, B extends Shape> = (a: A, b: B, dx: number, dy: number, m: Manifold) => void;

const KINDS = 2;

/** Which kernel serves which pair, at `kindOfA · KINDS + kindOfB`. */
const KERNELS: readonly [
  Kernel<Circle, Circle>,
  Kernel<Circle, Polygon>,
  Kernel<Polygon, Circle>,
  Kernel<Polygon, Polygon>,
] = [collideCircles, collideCirclePolygon, collidePolygonCircle, collidePolygons];

/** Collides two placed shapes. */
export function collide(a: Shape, b: Shape, dx: number, dy: number, m: Manifold): void {
  (KERNELS[a.kind * KINDS + b.kind] as Kernel<Shape, Shape>)(a, b, dx, dy, m);
}
