import { Distance, measureDistance } from '../../src/geometry/distance.js';
import { Outline } from '../../src/geometry/outline.js';
import type { Shape } from '../../src/index.js';
import { Chance, formOf, randomShape } from './forms.js';
import { exactDistance, type Form, gapAlong, signedDistance } from './reference.js';

// Measures random pairs of outlines and compares with the references, for distance.test.ts and many.test.ts.

let chance = new Chance(1);
const a = new Outline();
const b = new Outline();
const out = new Distance();

/** One in this many is compared with the exact reference as well. */
const EXACT_SHARE = 100;

/** The worst of each kind of error, relative to the extent of the pair, and the pair's number. */
let worst: Record<string, { error: number; pair: string }> = {};
let counts: Record<string, number> = {};

function note(kind: string, error: number, pair: string): void {
  const seen = worst[kind];
  if (seen === undefined || !(error <= seen.error)) {
    worst[kind] = { error, pair };
  }
}

/** A shape and where it is put. */
interface Placed {
  shape: Shape;
  x: number;
  y: number;
  angle: number;
}

function place({ shape, x, y, angle }: Placed, outline: Outline): Form {
  shape.outline(outline.put(x, y, Math.cos(angle), Math.sin(angle)));
  return formOf(outline);
}

/** Moves the form of `q` so that some point of it lies on some point of the form of `p`: corners, or points of edges. */
function touch(p: Placed, q: Placed): void {
  const own = place(p, a).corners;
  const other = place(q, b).corners;
  const i = 2 * chance.index(own.length / 2);
  const j = i + 2 === own.length ? 0 : i + 2;
  const k = 2 * chance.index(other.length / 2);
  const share = chance.next() < 0.4 ? 0 : chance.next();
  q.x += own[i]! + share * (own[j]! - own[i]!) - other[k]!;
  q.y += own[i + 1]! + share * (own[j + 1]! - own[i + 1]!) - other[k + 1]!;
}

/** Moves `q` along the axis of least distance until there is only a gap of `rest`. */
function approach(p: Placed, q: Placed, rest: number): void {
  place(p, a);
  place(q, b);
  measureDistance(a, b, out);
  q.x -= out.axisX * (out.value - rest);
  q.y -= out.axisY * (out.value - rest);
}

const WAYS: Record<string, (p: Placed, q: Placed, size: number) => void> = {
  'anywhere near': () => {},
  'far apart': (_, q, size) => {
    q.x += size * chance.size(3, 1000);
  },
  'deep in each other': (p, q) => {
    q.x = p.x + 0.1 * q.x;
    q.y = p.y + 0.1 * q.y;
  },
  'a point on a point': touch,
  'just touching': (p, q) => approach(p, q, 0),
  'almost touching': (p, q, size) => approach(p, q, (chance.next() < 0.5 ? 1 : -1) * size * chance.size(1e-15, 1e-3)),
  'upright, on a grid': (p, q, size) => {
    for (const one of [p, q]) {
      one.x = (size / 4) * (chance.index(9) - 4);
      one.y = (size / 4) * (chance.index(9) - 4);
      one.angle = 0;
    }
  },
  'turned alike, a corner on an edge': (p, q) => {
    q.angle = p.angle + (Math.PI / 2) * chance.index(4);
    touch(p, q);
  },
  'the same twice': (p, q, size) => {
    q.shape = p.shape;
    q.angle = p.angle;
    q.x = p.x + (chance.next() < 0.5 ? 0 : size * chance.size(1e-12, 1));
    q.y = p.y;
  },
};
const NAMES = Object.keys(WAYS);

function extent(...forms: Form[]): number {
  let [minX, minY, maxX, maxY] = [Infinity, Infinity, -Infinity, -Infinity] as [number, number, number, number];
  for (const { corners, radius } of forms) {
    for (let i = 0; i < corners.length; i += 2) {
      minX = Math.min(minX, corners[i]! - radius);
      maxX = Math.max(maxX, corners[i]! + radius);
      minY = Math.min(minY, corners[i + 1]! - radius);
      maxY = Math.max(maxY, corners[i + 1]! + radius);
    }
  }
  return Math.max(maxX - minX, maxY - minY);
}

/** How far a point lies outside a form. */
function outside(x: number, y: number, form: Form): number {
  return Math.max(0, signedDistance(form, { corners: Float64Array.of(x, y), radius: 0 }));
}

function check(p: Placed, q: Placed, pair: string, exactly: boolean): void {
  const formA = place(p, a);
  const formB = place(q, b);
  measureDistance(a, b, out);
  const { value, axisX, axisY, ax, ay, bx, by } = out;
  const size = extent(formA, formB);
  const truth = signedDistance(formA, formB);
  counts[Math.abs(truth) < 1e-12 * size ? 'touching' : truth > 0 ? 'apart' : 'overlapping']! += 1;
  note('distance', Math.abs(value - truth) / size, pair);
  if (exactly) {
    const exact = exactDistance(formA, formB);
    counts.exact! += 1;
    note('reference', Math.abs(truth - exact) / size, pair);
    note('exact', Math.abs(value - exact) / size, pair);
  }
  note('unit axis', Math.abs(axisX * axisX + axisY * axisY - 1), pair);
  const radii = formA.radius + formB.radius;
  note('best axis', Math.abs(gapAlong(formA.corners, formB.corners, axisX, axisY) - radii - value) / size, pair);
  note('witnesses', Math.max(Math.abs(ax + axisX * value - bx), Math.abs(ay + axisY * value - by)) / size, pair);
  note('witness A', outside(ax, ay, formA) / size, pair);
  note('witness B', outside(bx, by, formB) / size, pair);
}

/** The worst of each kind of error, relative to the extent of the pair, and how many pairs there were of each kind. */
export function measure(pairs: number, seed: number): { worst: typeof worst; counts: typeof counts } {
  chance = new Chance(seed);
  worst = {};
  counts = { exact: 0, apart: 0, overlapping: 0, touching: 0 };
  const pool = Array.from({ length: Math.min(pairs, 20_000) }, () => {
    const size = chance.size(0.01, 30);
    return { shape: randomShape(chance, size), size };
  });
  for (let i = 0; i < pairs; i += 1) {
    const first = pool[chance.index(pool.length)]!;
    const second = pool[chance.index(pool.length)]!;
    const size = Math.max(first.size, second.size);
    const [p, q] = [first, second].map(({ shape }) => ({
      shape,
      x: chance.span(-size, size),
      y: chance.span(-size, size),
      angle: chance.span(-4, 4),
    })) as [Placed, Placed];
    const name = NAMES[i % NAMES.length]!;
    WAYS[name]!(p, q, size);
    check(p, q, `${i}: ${name}`, chance.index(EXACT_SHARE) === 0);
  }
  return { worst, counts };
}
