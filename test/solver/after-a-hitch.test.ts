import { expect, it } from 'vitest';
import { phys2D } from '../../src/index.js';
import { add, box, boxBody, heavy, speed, staticBody, steps } from '../conformance/setting.js';

// A step that is more than twice as long as those before counts by itself, and is soon forgotten. Taken for as many as there were steps
// before, it held impulses back for seconds: a tower that was loaded meanwhile fell.
it.each([1 / 25, 1 / 15, 1 / 8])('after a step of %f s a tower that stood for 3 s takes a load', (hitch) => {
  const world = heavy();
  add(world, staticBody({ position: [0, 1], shapes: [box(20, 2)] }));
  const tower = Array.from({ length: 10 }, (_, i) =>
    boxBody(0.5, 0.5, { position: [0.002 * (i % 2), -0.25 - 0.5 * i], allowSleeping: false }),
  );
  add(world, ...tower);
  steps(world, 180);
  world.step(hitch);
  const material = phys2D.createMaterial({ density: 10 });
  add(world, boxBody(1, 1, { position: [0, -6.5] }, { material }));
  steps(world, 120);
  let fastest = 0;
  for (let i = 0; i < 600; i += 1) {
    steps(world, 1);
    fastest = Math.max(fastest, ...tower.map(speed));
  }
  expect(fastest).toBeLessThan(0.05);
});
