import { describe, expect, it } from 'vitest';
import { phys2D } from '../../src/index.js';
import { add, box, heavy, staticBody, steps } from '../conformance/setting.js';

// What slides over flush tiles, falls over meanwhile and tumbles on touches them with one part after the other, each of which lies near the joints.

/** How far a capsule of so many metres gets above the tiles, which it begins on upright. */
function tumble(size: number, speed: number, tile: number, start: number): number {
  const world = heavy();
  const material = phys2D.createMaterial({ staticFriction: 0.3, dynamicFriction: 0.3, rollingFriction: 0 });
  const shapes = Array.from({ length: (4 + 1.5 * speed) / tile }, (_, i) => {
    const vertices = phys2D.createRectangleVertices(tile * i, 0, tile * (i + 1), 1);
    return phys2D.createPolygonShape({ vertices, material });
  });
  add(world, staticBody({ shapes }));
  const ends = [-size / 2, size / 2].map((y) =>
    phys2D.createCircleShape({ radius: size / 2, origin: [0, y], material }),
  );
  const capsule = phys2D.createRigidBody({
    position: [start, -size],
    velocity: [speed, 0],
    linearDrag: 0,
    angularDrag: 0,
    shapes: [box(size, size, { material }), ...ends],
  });
  add(world, capsule);
  let most = 0;
  for (let i = 0; i < 90; i += 1) {
    steps(world, 1);
    most = Math.max(most, -capsule.computeWorldBounds()[3]!);
  }
  return most;
}

describe('a capsule that tumbles over flush tiles', () => {
  it.each([
    [5, 0.25],
    [10, 0.25],
    [20, 0.25],
    [20, 1],
    [60, 1],
  ])('at %d m/s over tiles of %f m stays on them', (speed, tile) => {
    for (let k = 0; k < 60; k += 1) {
      const start = 1 + ((7919 * k) % 1000) / 1000;
      expect(tumble(0.1 + 0.003 * k, speed, tile, start), `capsule ${k}`).toBeLessThan(0.05);
    }
  });
});
