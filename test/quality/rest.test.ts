import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { describe, expect, it } from 'vitest';
import type * as source from '../../src/index.js';
import { buildPyramid } from '../scenes/pyramid.js';
import { buildRagdoll } from '../scenes/ragdoll.js';

// High heaps, and heaps of what is jointed, come to rest, and sleep. From the bundle as built: much is stepped.

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

describe('thirty ragdolls that fall into a bin of twelve metres', () => {
  // In eight other falls they sleep after 9 to 40 s; in none of four of these within 40 s as long as joints in contact made momentum of their corrections.
  it.each([1, 2, 3])('sleep within a minute, fall %i', (fall) => {
    const world = phys2D.createWorld({ gravity: [0, 10] });
    for (const [left, top, right, bottom] of [
      [-8, 0, 8, 1],
      [-7, -60, -6, 0],
      [6, -60, 7, 0],
    ] as const) {
      const shapes = [
        phys2D.createPolygonShape({ vertices: phys2D.createRectangleVertices(left, top, right, bottom) }),
      ];
      world.addRigidBody(phys2D.createRigidBody({ type: 'static', shapes }));
    }
    for (let i = 0; i < 30; i += 1) {
      const aside = 0.05 * ((7 * i + 3 * fall) % 6);
      buildRagdoll(phys2D, world, [2.6 * ((i % 4) - 1.5) + aside, -3 - 3.5 * Math.floor(i / 4)]);
    }
    while (world.simulatedTime < 60 && world.liveDynamics.length > 0) {
      world.step(1 / 60);
    }
    console.log(`fall ${fall}: thirty ragdolls sleep after ${world.simulatedTime.toFixed(1)} s`);
    expect(world.liveDynamics).toHaveLength(0);
  });
});
