import { exact } from '../math/exact.js';

// Signed distances by other ways than the engine's: a quick one in doubles, and an exact one in integers that it is checked with.

/** A convex form: corners [x, y, …], clockwise, and a radius around them. One corner with a radius is a disc. */
export interface Form {
  readonly corners: Float64Array;
  readonly radius: number;
}

/** How far B's corners lie beyond A's along a unit vector; gives up once that is below `enough`. */
export function gapAlong(a: Float64Array, b: Float64Array, nx: number, ny: number, enough = -Infinity): number {
  let most = -Infinity;
  for (let i = 0; i < a.length; i += 2) {
    most = Math.max(most, nx * a[i]! + ny * a[i + 1]!);
  }
  let least = Infinity;
  for (let i = 0; i < b.length; i += 2) {
    const height = nx * b[i]! + ny * b[i + 1]!;
    if (height < least) {
      least = height;
      if (least - most < enough) {
        break;
      }
    }
  }
  return least - most;
}

/**
 * Along no direction is the gap larger than the distance, and along the best it is just that. The best is the normal of an edge of either, or
 * leads from a corner of one to a corner of the other: so the largest gap along any of those is the distance, whatever is rounded.
 */
export function signedDistance(a: Form, b: Form): number {
  const ac = a.corners;
  const bc = b.corners;
  let best = Math.max(alongEdges(ac, ac, bc, 1), alongEdges(bc, ac, bc, -1));
  for (let i = 0; i < ac.length; i += 2) {
    for (let k = 0; k < bc.length; k += 2) {
      const x = bc[k]! - ac[i]!;
      const y = bc[k + 1]! - ac[i + 1]!;
      const length = Math.sqrt(x * x + y * y);
      if (length > best && length > 0) {
        best = Math.max(best, gapAlong(ac, bc, x / length, y / length, best));
      }
    }
  }
  return (best === -Infinity ? 0 : best) - a.radius - b.radius;
}

/** The largest gap along the normals of the edges of `from`, which are outward times `side`. */
function alongEdges(from: Float64Array, a: Float64Array, b: Float64Array, side: number): number {
  let best = -Infinity;
  for (let i = 0; from.length > 2 && i < from.length; i += 2) {
    const j = i + 2 === from.length ? 0 : i + 2;
    const x = from[j]! - from[i]!;
    const y = from[j + 1]! - from[i + 1]!;
    const scale = side / Math.sqrt(x * x + y * y);
    best = Math.max(best, gapAlong(a, b, y * scale, -x * scale, best));
  }
  return best;
}

type Point = readonly [x: bigint, y: bigint];

const minus = ([ax, ay]: Point, [bx, by]: Point): Point => [ax - bx, ay - by];
const cross = ([ax, ay]: Point, [bx, by]: Point): bigint => ax * by - ay * bx;
const dot = ([ax, ay]: Point, [bx, by]: Point): bigint => ax * bx + ay * by;
const sign = (x: bigint): number => (x < 0n ? -1 : x > 0n ? 1 : 0);

/**
 * The same without rounding: doubles are integers of 2⁻³²⁰, the differences of B's points and A's are a convex polygon, and what is asked is
 * how far the origin lies from its boundary. Only the square root at the end is rounded, to 2⁻³²⁰.
 */
export function exactDistance(a: Form, b: Form): number {
  const differences: Point[] = points(b).flatMap((q) => points(a).map((p) => minus(q, p)));
  const hull = convexHull(differences);
  const inside = hull.length > 2 && hull.every((p, i) => cross(p, hull[(i + 1) % hull.length]!) >= 0n);
  let numerator = -1n;
  let denominator = 1n;
  hull.forEach((p, i) => {
    const [n, d] = squaredToSide(p, hull[(i + 1) % hull.length]!, inside);
    if (numerator < 0n || n * denominator < numerator * d) {
      numerator = n;
      denominator = d;
    }
  });
  const root = squareRoot(numerator / denominator);
  return Number((inside ? -root : root) - exact(a.radius) - exact(b.radius)) / 2 ** 320;
}

function points({ corners }: Form): Point[] {
  return Array.from({ length: corners.length / 2 }, (_, i) => [exact(corners[2 * i]!), exact(corners[2 * i + 1]!)]);
}

/** Squared distance of the origin from a segment, or from its whole line, as a fraction. */
function squaredToSide(p: Point, q: Point, line: boolean): Point {
  const side = minus(q, p);
  const length = dot(side, side);
  const along = -dot(p, side);
  if (length === 0n || (!line && along <= 0n)) {
    return [dot(p, p), 1n];
  }
  if (!line && along >= length) {
    return [dot(q, q), 1n];
  }
  const area = cross(p, q);
  return [area * area, length];
}

/** Andrew's monotone chain. */
function convexHull(all: Point[]): Point[] {
  const sorted = [...all].sort((p, q) => sign(p[0] - q[0]) || sign(p[1] - q[1]));
  const chain = (list: Point[]): Point[] => {
    const kept: Point[] = [];
    for (const p of list) {
      while (kept.length > 1 && cross(minus(kept.at(-1)!, kept.at(-2)!), minus(p, kept.at(-1)!)) <= 0n) {
        kept.pop();
      }
      kept.push(p);
    }
    return kept.slice(0, -1);
  };
  const hull = [...chain(sorted), ...chain(sorted.reverse())];
  return hull.length > 0 ? hull : [all[0]!];
}

function squareRoot(x: bigint): bigint {
  if (x === 0n) {
    return 0n;
  }
  let root = 1n << BigInt((x.toString(2).length + 1) >> 1);
  for (;;) {
    const next = (root + x / root) >> 1n;
    if (next >= root) {
      return root;
    }
    root = next;
  }
}
