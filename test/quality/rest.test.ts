import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { describe, expect, it } from 'vitest';
import type * as source from '../../src/index.js';
import { buildPyramid } from '../scenes/pyramid.js';

// High heaps come to rest, and sleep. From the bundle as built: much is stepped.

const { phys2D } = (await import(
  /* @vite-ignore */ pathToFileURL(join(import.meta.dirname, '../../dist/phys2d.js')).href
)) as typeof source;

describe('a pyramid that is as wide as it is high', () => {
  it.each([
    { base: 20, within: 2 },
    { base: 40, within: 6 },
    { base: 50, within: 18 },
  ])('of base $base sleeps within $within s', ({ base, within }) => {
    const world = phys2D.createWorld({ gravity: [0, 10] });
    const boxes = buildPyramid(phys2D, world, base);
    for (let time = 0; time < within && !boxes.every((box) => box.sleeping); time += 1 / 60) {
      world.step(1 / 60);
    }
    console.log(`pyramid of base ${base}: sleeps after ${world.simulatedTime.toFixed(1)} s`);
    expect(boxes.every((box) => box.sleeping)).toBe(true);
  });
});
