import type { Shape } from '../shape/shape.js';
import { POLYGON } from '../shape/shape-kind.js';
import { collideCircles } from './circles.js';
import { empty, overlaps } from './manifold.js';
import { works } from './polygon-works.js';

/** A collision function: reads the relative placement from the record of a pair and writes the manifold there; no points if the shapes are apart. */
export type Kernel<A extends Shape, B extends Shape> = (a: A, b: B, n: Float64Array, o: number) => void;

/** Collides two placed shapes, whose relative placement is in the record. */
export function collide(a: Shape, b: Shape, n: Float64Array, o: number): void {
  if (a.kind === POLYGON) {
    if (b.kind === POLYGON) works!.collidePolygons(a, b, n, o);
    else works!.collidePolygonCircle(a, b, n, o);
  } else if (b.kind === POLYGON) {
    works!.collideCirclePolygon(a, b, n, o);
  } else {
    collideCircles(a, b, n, o);
  }
}

/** Whether two placed shapes intersect; touching counts. Their relative placement is in the record, which gets no points. */
export function intersect(a: Shape, b: Shape, n: Float64Array, o: number): boolean {
  if (a.kind === POLYGON && b.kind === POLYGON) {
    return works!.polygonsIntersect(a, b, n, o);
  }
  collide(a, b, n, o);
  const found = overlaps(n, o);
  empty(n, o);
  return found;
}
