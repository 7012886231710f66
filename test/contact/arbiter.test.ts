import { expect, it } from 'vitest';
import { phys2D } from '../../src/index.js';

it.each([
  [Infinity, 1],
  [-Infinity, 0],
  [2, 2],
  [0.5, 0.5],
])('an arbiter whose elasticity is set to %d has %d, and its bodies go on', (given, kept) => {
  const world = phys2D.createWorld({ gravity: [0, 0] });
  const bodies = [0, 0.9].map((x) => {
    const shapes = [phys2D.createCircleShape({ radius: 0.5 })];
    const body = phys2D.createRigidBody({ position: [x, 0], velocity: [-2 * x, 0], shapes });
    world.addRigidBody(body);
    return body;
  });
  bodies[0]!.shapes[0]!.addEventListener('preSolve', (arbiter) => arbiter.setElasticity(given));
  world.step(1 / 60);
  expect(bodies[0]!.shapes[0]!.arbiters[0]!.getElasticity()).toBe(kept);
  for (let i = 0; i < 10; i += 1) {
    world.step(1 / 60);
  }
  expect(bodies.flatMap((body) => [...body.getPosition(), ...body.getVelocity()]).every(Number.isFinite)).toBe(true);
});
