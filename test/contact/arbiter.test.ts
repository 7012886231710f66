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

it('each of two contacts is told no more friction than its normal impulse allows, also in the first step', () => {
  const world = phys2D.createWorld({ gravity: [0, 10], substeps: 1 });
  const material = phys2D.createMaterial({ staticFriction: 0.3, dynamicFriction: 0.2 });
  const box = (width: number) => phys2D.createPolygonShape({ vertices: phys2D.createBoxVertices(width, 1), material });
  world.addRigidBody(phys2D.createRigidBody({ type: 'static', position: [0, 1], shapes: [box(20)] }));
  world.addRigidBody(phys2D.createRigidBody({ position: [0, 0.004], velocity: [3, 0], shapes: [box(1)] }));
  for (let i = 0; i < 5; i += 1) {
    world.step(1 / 60);
    const { contacts } = world.staticArbiters[0]!;
    expect(contacts).toHaveLength(2);
    for (const contact of contacts) {
      expect(contact.getTangentImpulse() / contact.getNormalImpulse()).toBeCloseTo(-0.2, 9);
    }
  }
});
