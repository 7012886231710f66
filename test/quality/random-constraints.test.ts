import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { describe, expect, it } from 'vitest';
import type * as source from '../../src/index.js';
import { Tangle } from '../scenes/tangle.js';

// From the bundle as built: unbundled, a thousand steps of a thousand constraints take a minute.

const { phys2D } = (await import(
  /* @vite-ignore */ pathToFileURL(join(import.meta.dirname, '../../dist/phys2d.js')).href
)) as typeof source;

const STEPS = 1000;

/** Steps a tangle; every number that a body or a constraint tells stays finite. @returns m/s, the fastest body. */
function fastest(seed: number, bodies: number, constraints: number): number {
  const tangle = new Tangle(phys2D, phys2D.createWorld({ substeps: 1 + (seed % 4) }), seed, bodies, constraints);
  const { world } = tangle;
  let most = 0;
  for (let i = 0; i < STEPS; i += 1) {
    world.step(1 / 60);
    for (const body of tangle.bodies) {
      const [x, y] = body.getPosition();
      const [vx, vy] = body.getVelocity();
      const sum = x + y + vx + vy + body.getRotation() + body.getAngularVelocity();
      if (!Number.isFinite(sum)) {
        expect.fail(`seed ${seed}, step ${i}: a body is at ${x}, ${y}`);
      }
      most = Math.max(most, Math.abs(vx), Math.abs(vy));
    }
  }
  for (const constraint of tangle.constraints) {
    for (const body of tangle.bodies) {
      const [x, y, w] = constraint.getImpulseForBody(body);
      expect(Number.isFinite(x + y + w), `seed ${seed}, ${constraint.type}`).toBe(true);
    }
  }
  return most;
}

describe('random constraints of all kinds between random bodies', () => {
  it('1,000 in 100 worlds: a thousand steps, all numbers finite, nothing thrown', { timeout: 120_000 }, () => {
    const speeds = Array.from({ length: 100 }, (_, seed) => fastest(seed, 10, 10)).sort((a, b) => a - b);
    const show = (share: number): string => speeds[Math.floor(share * (speeds.length - 1))]!.toPrecision(3);
    console.log(`100 tangles of 10: all finite; fastest body ${show(0.5)} m/s in the median, ${show(1)} in the worst`);
  });

  it('1,000 in one world', { timeout: 120_000 }, () => {
    console.log(`tangle of 1,000: all finite; fastest body ${fastest(1, 300, 1000).toPrecision(3)} m/s`);
  });
});
