import { expect } from 'vitest';
import type { measure as measurePairs } from './random-pairs.js';
import type { measure as measureSweeps } from './random-sweeps.js';

// What has to hold for random pairs and sweeps, however many.

export type Pairs = ReturnType<typeof measurePairs>;
export type Sweeps = ReturnType<typeof measureSweeps>;

export function expectRight({ worst, counts }: Pairs, pairs: number): void {
  expect(counts.apart! + counts.overlapping! + counts.touching!).toBe(pairs);
  expect(Math.min(...Object.values(counts))).toBeGreaterThan(pairs / 200);
  for (const kind of ['distance', 'reference', 'exact', 'unit axis', 'witnesses', 'witness A', 'witness B']) {
    expect(worst[kind]!.error, kind).toBeLessThan(1e-10);
  }
  expect(worst['best axis']!.error, 'along the axis the gap is the distance').toBeLessThan(1e-10);
}

export function expectInTime({ worst, counts }: Sweeps, sweeps: number): void {
  expect(counts.hits).toBeGreaterThan(sweeps / 4);
  expect(counts['close misses']).toBeGreaterThan(sweeps / 30);
  expect(counts.unfinished).toBeLessThan(Math.max(1, sweeps / 1000));
  // Some 22: a looser bound on what is safe takes more.
  expect(counts.iterations / sweeps).toBeLessThan(40);
  expect(worst.iterations!.error).toBeLessThan(5000);
  expect(worst['missed, s before the end']!.error).toBe(0);
  expect(worst['too late, s']!.error).toBe(0);
  expect(worst['not within the time']!.error).toBe(0);
  expect(worst['too deep']!.error).toBeLessThan(1e-12);
  expect(worst['told wrong distance']!.error, 'told wrong distance').toBeLessThan(1e-9);
  expect(worst['too early']!.error, 'too early').toBeLessThan(1e-12);
}
