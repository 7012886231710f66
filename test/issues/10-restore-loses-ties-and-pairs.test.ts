import { expect, it } from 'vitest';
import { validate } from '../../src/audit/index.js';
import { phys2D } from '../../src/index.js';

// A world that was restored lost its constraints on bodies of other worlds from the lists of those bodies; and what it threw away of pairs went on to
// count as awake. Both were found by random programs.

const disc = (x: number) =>
  phys2D.createRigidBody({ position: [x, 0], shapes: [phys2D.createCircleShape({ radius: 0.5 })] });

it('a body of another world keeps the constraints of one that is restored', () => {
  const [world, other] = [phys2D.createWorld(), phys2D.createWorld()];
  const [bodyA, bodyB] = [disc(0), disc(2)];
  other.addRigidBody(bodyB);
  const rod = phys2D.createDistanceConstraint({ bodyA, bodyB, lowerBound: 2, upperBound: 2 });
  world.addConstraint(rod);
  world.restore(world.snapshot());
  validate(world);
  expect(bodyA.constraints).toEqual([rod]);
  expect(bodyB.constraints).toEqual([rod]);
});

it('pairs that a restore has no use for are free', () => {
  const world = phys2D.createWorld({ gravity: [0, 0] });
  const bodies = [disc(0), disc(0.9), disc(1.8)];
  bodies.forEach((body) => void world.addRigidBody(body));
  const before = world.snapshot();
  world.step(1 / 60);
  world.removeRigidBody(bodies[1]!);
  world.restore(world.snapshot());
  validate(world);
  world.restore(before);
  validate(world);
  world.step(1 / 60);
  validate(world);
  expect(world.dynamicArbiters).toHaveLength(2);
});
