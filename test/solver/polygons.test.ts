import { expect, it } from 'vitest';
import { works } from '../../src/collide/polygon-works.js';
import {
  createBoxVertices,
  createCircleShape,
  createDistanceConstraint,
  createMaterial,
  createPolygonShape,
  createRigidBody,
  createWorld,
} from '../../src/index.js';
import { stateHash } from '../scenes/hash.js';
import { generator } from '../scenes/mixed.js';

/** Circles of all kinds on others that move: they bounce, roll, hang on rods, are fast, meet sensors, and lie on several grounds at once. */
function simulate(): string {
  const world = createWorld();
  const random = generator(7);
  const between = (low: number, high: number): number => low + (high - low) * random();
  const bouncy = createMaterial({ elasticity: 0.8 });
  for (let i = 0; i < 12; i += 1) {
    const ground = createRigidBody({
      type: i % 2 === 0 ? 'static' : 'kinematic',
      position: [i, 6 + 0.1 * (i % 3)],
      angularVelocity: i % 2,
      shapes: [createCircleShape({ radius: 1, sensor: i === 5 })],
    });
    world.addRigidBody(ground);
  }
  let last = null;
  for (let i = 0; i < 60; i += 1) {
    const body = createRigidBody({
      position: [between(0, 11), between(-4, 4)],
      velocity: [between(-5, 5), i % 7 === 0 ? 200 : 0],
      bullet: i % 7 === 0,
      shapes: [createCircleShape({ radius: between(0.1, 0.4), ...(i % 3 === 0 ? { material: bouncy } : {}) })],
    });
    world.addRigidBody(body);
    if (last !== null && i % 10 === 0) {
      world.addConstraint(createDistanceConstraint({ bodyA: last, bodyB: body, lowerBound: 0, upperBound: 1 }));
    }
    last = body;
  }
  for (let i = 0; i < 300; i += 1) {
    world.step(1 / 60);
  }
  return stateHash(world);
}

it('a world of circles goes to the bit as it does where polygons have brought along what they need', () => {
  expect(works).toBeNull();
  const alone = simulate();
  createPolygonShape({ vertices: createBoxVertices(1, 1) });
  expect(works).not.toBeNull();
  expect(simulate()).toBe(alone);
});
