import { describe, expect, it } from 'vitest';
import { findImpact, Sweep, type Swept } from '../../src/geometry/sweep.js';
import { phys2D, type Shape } from '../../src/index.js';
import { near } from '../conformance/setting.js';
import { measure } from './random-sweeps.js';
import { expectInTime } from './right.js';

/** Few, in this process; many.test.ts takes thirty thousand. */
const SWEEPS = 100;

const polygon = (sides: number): Shape =>
  phys2D.createPolygonShape({ vertices: phys2D.createRegularPolygonVertices(2, 2, sides) });
const box = (width: number, height: number): Shape =>
  phys2D.createPolygonShape({ vertices: phys2D.createBoxVertices(width, height) });

type Motion = Partial<Record<'x' | 'y' | 'angle' | 'vx' | 'vy' | 'w', number>>;

function sweepOf(a: Shape, b: Shape, motionA: Motion, motionB: Motion): Sweep {
  const sweep = new Sweep();
  Object.assign(sweep.a, { shape: a, ...motionA });
  Object.assign(sweep.b, { shape: b, ...motionB });
  return sweep;
}

/** From time `from` on, −1 if they do not come as near as `target` before `most`. */
function firstTime(sweep: Sweep, target: number, from: number, most: number): number {
  Object.assign(sweep, { target, tolerance: 1e-9, time: from, most });
  return findImpact(sweep) ? sweep.time : -1;
}

/** Counts how often a sweep is looked at. */
function countLooks({ a }: Sweep): { count: number } {
  const looks = { count: 0 };
  const { shape } = a;
  const counting: Swept = {
    outline(into) {
      looks.count += 1;
      shape!.outline(into);
    },
  };
  a.shape = counting;
  return looks;
}

describe('time of impact', () => {
  it(`of ${SWEEPS} random sweeps against their distances in between`, () => {
    expectInTime(measure(SWEEPS, 2), SWEEPS);
  });

  it('is exact where it can be told in closed form', () => {
    const cases: [Sweep, number][] = [
      [sweepOf(box(1, 1), box(1, 1), { vx: 400 }, { x: 3 }), 0.005],
      [sweepOf(box(1, 1), box(1, 1), { vx: 1, vy: 0.5 }, { x: 3, vx: -1 }), 1],
      [sweepOf(phys2D.createCircleShape({ radius: 1 }), box(2, 2), { w: 50 }, { x: 4, vx: -0.5 }), 4],
      // The end of a bar sweeps to the ground below, which is as far off as sin(π/6) of its half length.
      [sweepOf(box(4, 1e-5), box(9, 1), { w: 0.5 }, { y: 1.5 }), Math.PI / 3],
    ];
    for (const [sweep, time] of cases) {
      near(firstTime(sweep, 0, 0, 10), time, 1e-5);
    }
  });

  it('is the start of the interval if they touch by then, and −1 if they only do at its end', () => {
    const sweep = sweepOf(box(1, 1), box(1, 1), { vx: 1 }, { x: 2 });
    expect(firstTime(sweep, 0, 0.25, 10)).toBeCloseTo(1, 8);
    expect(firstTime(sweep, 0, 1.5, 10)).toBe(1.5);
    expect(firstTime(sweep, 0, 0, 0.999)).toBe(-1);
    expect(firstTime(sweep, -0.25, 0, 10)).toBeCloseTo(1.25, 8);
  });

  it('takes two looks where nothing turns: at the start, and where they meet', () => {
    for (const speed of [0.01, 1, 400]) {
      const sweep = sweepOf(box(1, 1), box(1, 1), { y: -7, vx: speed }, { x: 3, y: -7 });
      const looks = countLooks(sweep);
      near(firstTime(sweep, 0, 0, 1000), 2 / speed, 1e-6);
      expect(looks.count).toBe(2);
    }
  });

  it('takes few looks where something flies along a long bar that turns, whichever is A', () => {
    const length = 20_000;
    const gap = 1e-3;
    const bar = { w: 0.5 };
    for (const coming of [-1, 0, 1]) {
      const ball = { x: 100, y: 0.6 + gap, vx: -400, vy: 0.5 * 100 - coming };
      /** The distance from what is above the middle of the bar. */
      const apart = (t: number): number =>
        (ball.y + ball.vy * t) * Math.cos(0.5 * t) - (ball.x + ball.vx * t) * Math.sin(0.5 * t) - 0.6;
      const disc = phys2D.createCircleShape({ radius: 0.5 });
      for (const sweep of [
        sweepOf(disc, box(length, 0.2), ball, bar),
        sweepOf(box(length, 0.2), disc, bar, ball),
        sweepOf(disc, box(length, 0.2), { ...ball, w: -300 }, bar),
      ]) {
        const looks = countLooks(sweep);
        const time = firstTime(sweep, 0, 0, 1 / 60);
        expect(looks.count).toBeLessThan(400);
        if (coming > 0) {
          near(apart(time), 0, 2e-9);
          expect(time).toBeLessThan(0.002);
        } else {
          expect(time).toBe(-1);
        }
      }
    }
  });

  it('takes the reach of a shape from where its origin is', () => {
    const { a } = sweepOf(box(6, 8), box(1, 1), { x: 3, y: 7, vx: 2, vy: -1 }, {});
    a.at = 3;
    a.place(true);
    a.measureReach();
    near(a.reach, 5, 1e-12);
  });

  it('finds nothing where a spinning polygon never gets to, however often it turns', () => {
    for (const gap of [0.1, 0.03, 0.01, 0.001]) {
      const at = 0.5 + Math.SQRT1_2 * (1 + gap);
      const sweep = sweepOf(polygon(12), box(1, 1), { w: 50 }, { x: at, y: at });
      expect(firstTime(sweep, 0, 0, 5), `gap ${gap}, left ${sweep.distance.value}`).toBe(-1);
    }
  });
});
