import { describe, expect, it } from 'vitest';
import { Sweep, timeOfImpact } from '../../src/geometry/sweep.js';
import { phys2D, type Shape } from '../../src/index.js';
import { near } from '../conformance/setting.js';
import { measure as measureSweeps } from './random-sweeps.js';
import { run } from './run.js';

const SWEEPS = 30_000;
const FEW = 100;

type Measured = ReturnType<typeof measureSweeps>;

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

describe('time of impact', () => {
  function holds({ worst, counts }: Measured, sweeps: number): void {
    expect(counts.hits).toBeGreaterThan(sweeps / 4);
    expect(counts['close misses']).toBeGreaterThan(sweeps / 30);
    expect(counts.unfinished).toBeLessThan(Math.max(1, sweeps / 1000));
    expect(worst.iterations!.error).toBeLessThan(10_000);
    expect(worst['missed, s before the end']!.error).toBe(0);
    expect(worst['too late, s']!.error).toBe(0);
    expect(worst['not within the time']!.error).toBe(0);
    expect(worst['too deep']!.error).toBeLessThan(1e-12);
    expect(worst['told wrong distance']!.error, 'told wrong distance').toBeLessThan(1e-9);
    expect(worst['too early']!.error, 'too early').toBeLessThan(1e-12);
  }

  it(`of ${SWEEPS.toLocaleString('en')} random sweeps against their distances in between`, {
    timeout: 120_000,
  }, async () => {
    const measured = await run<Measured>('random-sweeps.ts', SWEEPS, 1);
    const { worst, counts } = measured;
    console.log(`${SWEEPS} sweeps (${JSON.stringify(counts)}), worst errors over the size where not in s:`);
    for (const [kind, { error, sweep }] of Object.entries(worst)) {
      console.log(`  ${kind.padEnd(26)} ${kind === 'iterations' ? error : error.toExponential(1)}  (sweep ${sweep})`);
    }
    holds(measured, SWEEPS);
  });

  it('of a few random sweeps, as vitest loads the engine: what coverage and mutations see', () => {
    const measured = measureSweeps(FEW, 2);
    holds(measured, FEW);
    // Steps by a bound of first order would take several times as many.
    expect(measured.counts.iterations / FEW).toBeLessThan(40);
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
      near(timeOfImpact(sweep, 0, 1e-9, 0, 10), time, 1e-5);
    }
  });

  it('is the start of the interval if they touch by then, and −1 if they only do at its end', () => {
    const sweep = sweepOf(box(1, 1), box(1, 1), { vx: 1 }, { x: 2 });
    expect(timeOfImpact(sweep, 0, 1e-9, 0.25, 10)).toBeCloseTo(1, 8);
    expect(timeOfImpact(sweep, 0, 1e-9, 1.5, 10)).toBe(1.5);
    expect(timeOfImpact(sweep, 0, 1e-9, 0, 0.999)).toBe(-1);
    expect(timeOfImpact(sweep, -0.25, 1e-9, 0, 10)).toBeCloseTo(1.25, 8);
  });

  it('finds nothing where a spinning polygon never gets to, however often it turns', () => {
    for (const gap of [0.1, 0.03, 0.01, 0.001]) {
      const at = 0.5 + Math.SQRT1_2 * (1 + gap);
      const sweep = sweepOf(polygon(12), box(1, 1), { w: 50 }, { x: at, y: at });
      expect(timeOfImpact(sweep, 0, 1e-9, 0, 5), `gap ${gap}, left ${sweep.distance.value}`).toBe(-1);
    }
  });
});
