import { measureDistance } from '../../src/geometry/distance.js';
import { Outline } from '../../src/geometry/outline.js';
import { findImpact, Sweep, type Swept, type Travel } from '../../src/geometry/sweep.js';
import type { Shape } from '../../src/index.js';
import { Chance, formOf, randomShape } from './forms.js';
import { type Form, signedDistance } from './reference.js';

// Sweeps random pairs and looks at their distance at many times between, for sweep.test.ts and many.test.ts.

let chance = new Chance(1);
const scratch = new Outline();

/** The worst of each kind of error, and the number of its sweep. */
let worst: Record<string, { error: number; sweep: string }> = {};
/** Relative to the size: dips below the target that are no deeper are not looked for between the samples. */
const SLACK = 1e-6;

/** In one search. */
const MAX_SAMPLES = 5000;

const NONE = { unfinished: 0, hits: 0, misses: 0, 'at once': 0, 'close misses': 0, iterations: 0 };
let counts = NONE;

function note(kind: string, error: number, sweep: string): void {
  const seen = worst[kind];
  if (seen === undefined || !(error <= seen.error)) {
    worst[kind] = { error, sweep };
  }
}

/** A shape that counts how often it is placed. */
class Counting implements Swept {
  placed = 0;

  constructor(readonly shape: Shape) {}

  outline(into: Outline): void {
    this.placed += 1;
    this.shape.outline(into);
  }
}

function formAt(shape: Shape, travel: Travel, t: number): Form {
  const angle = travel.angle + travel.w * t;
  shape.outline(scratch.put(travel.x + travel.vx * t, travel.y + travel.vy * t, Math.cos(angle), Math.sin(angle)));
  return formOf(scratch);
}

/** One sweep, as seen from outside. */
class Trial {
  readonly sweep = new Sweep();
  readonly shapes: readonly [Shape, Shape];
  readonly size: number;
  most = 0;

  constructor() {
    const size = chance.size(0.02, 10);
    this.size = size;
    this.shapes = [randomShape(chance, size), randomShape(chance, size * chance.size(0.05, 1))];
    const speed = chance.size(0.1, 400);
    const way = chance.span(0, 2 * Math.PI);
    const start = size * chance.size(0.5, 20);
    // They aim at each other, more or less, so that many pass by closely.
    const off = size * chance.span(-1.5, 1.5);
    const { a, b } = this.sweep;
    for (const [i, travel] of [a, b].entries()) {
      const side = i === 0 ? -0.5 : 0.5;
      const share = chance.next() < 0.2 ? 0 : chance.span(0.3, 1);
      travel.x = side * (start * Math.cos(way) + off * Math.sin(way));
      travel.y = side * (start * Math.sin(way) - off * Math.cos(way));
      travel.vx = -2 * side * speed * Math.cos(way) * share;
      travel.vy = -2 * side * speed * Math.sin(way) * share;
      travel.angle = chance.span(-4, 4);
      travel.w = chance.next() < 0.3 ? 0 : chance.span(-50, 50);
    }
    this.most = Math.min(5, (chance.size(0.3, 30) * start) / speed);
    if (chance.next() < 0.4) {
      this.graze();
    }
  }

  /** Moves B so that where they are nearest to each other they just touch, or just do not. */
  private graze(): void {
    const { a, b, distance } = this.sweep;
    [a.shape, b.shape] = this.shapes;
    let least = Infinity;
    let at = 0;
    for (let i = 0; i <= 200; i += 1) {
      const d = this.at((i / 200) * this.most);
      if (d < least) {
        least = d;
        at = (i / 200) * this.most;
      }
    }
    a.at = at;
    b.at = at;
    a.place(true);
    b.place(true);
    measureDistance(a.outline, b.outline, distance);
    const rest = (chance.next() < 0.5 ? -1 : 1) * this.size * chance.size(1e-12, 1e-2);
    b.x -= distance.axisX * (distance.value - rest);
    b.y -= distance.axisY * (distance.value - rest);
  }

  at(t: number): number {
    return signedDistance(formAt(this.shapes[0], this.sweep.a, t), formAt(this.shapes[1], this.sweep.b, t));
  }

  /** m/s, the most that the distance can change: how fast B moves against A, and how fast their corners turn. */
  rate(): number {
    const { a, b } = this.sweep;
    const [x, y] = [a.vx - b.vx, a.vy - b.vy];
    a.at = 0;
    b.at = 0;
    a.place(true);
    b.place(true);
    a.measureReach();
    b.measureReach();
    return Math.sqrt(x * x + y * y) + Math.abs(a.w) * a.reach + Math.abs(b.w) * b.reach;
  }

  /**
   * The first time up to `end` with a distance below `limit`, or −1: samples, and between two of them more unless even at the highest rate
   * the distance could not have been that small in between. After too many samples it is left at those.
   */
  firstBelow(limit: number, end: number): number {
    const rate = this.rate();
    let samples = 0;
    const search = (from: number, d: number, to: number, e: number): number => {
      if (d < limit) {
        return from;
      }
      if (0.5 * (d + e - rate * (to - from)) >= limit || to - from < 1e-12 * end || samples >= MAX_SAMPLES) {
        return e < limit ? to : -1;
      }
      const middle = 0.5 * (from + to);
      const f = this.at(middle);
      samples += 1;
      counts.unfinished += samples === MAX_SAMPLES ? 1 : 0;
      const first = search(from, d, middle, f);
      return first >= 0 ? first : search(middle, f, to, e);
    };
    return search(0, this.at(0), end, this.at(end));
  }
}

function check(trial: Trial, name: string): void {
  const { sweep, shapes, most, size } = trial;
  const { a, b, distance } = sweep;
  const target = chance.next() < 0.3 ? -0.1 * size * chance.next() : 0;
  const tolerance = chance.next() < 0.5 ? 1e-9 : size * chance.size(1e-7, 1e-3);
  const counting = [new Counting(shapes[0]), new Counting(shapes[1])] as const;
  [a.shape, b.shape] = counting;
  Object.assign(sweep, { target, tolerance, time: 0, most });
  const time = findImpact(sweep) ? sweep.time : -1;

  note('iterations', counting[0].placed, name);
  counts.iterations += counting[0].placed;
  const first = trial.firstBelow(target - SLACK * size, time < 0 ? most : time);
  if (time < 0) {
    counts.misses += 1;
    note('missed, s before the end', first < 0 ? 0 : most - first, name);
    counts['close misses'] += trial.firstBelow(target + 0.01 * size, most) < 0 ? 0 : 1;
    return;
  }
  counts[time === 0 ? 'at once' : 'hits'] += 1;
  const found = trial.at(time);
  note('told wrong distance', Math.abs(found - distance.value) / size, name);
  note('too early', Math.max(0, found - target - tolerance) / size, name);
  if (time > 0) {
    note('too deep', Math.max(0, target - found) / size, name);
    note('too late, s', first < 0 ? 0 : time - first, name);
    note('not within the time', Math.max(0, time - most), name);
  }
}

/** The worst of each kind of error, and how many sweeps ended in which way. */
export function measure(sweeps: number, seed: number): { worst: typeof worst; counts: typeof counts } {
  chance = new Chance(seed);
  worst = {};
  counts = { ...NONE };
  for (let i = 0; i < sweeps; i += 1) {
    check(new Trial(), `${i}`);
  }
  return { worst, counts };
}
