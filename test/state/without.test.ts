import { expect, it } from 'vitest';
import { createCircleShape, createRigidBody, createWorld, phys2D, type World, worldState } from '../../src/index.js';

/** A ball that falls for a while. */
function fallen(world: World): World {
  world.addRigidBody(createRigidBody({ shapes: [createCircleShape({ radius: 1 })] }));
  for (let i = 0; i < 10; i += 1) {
    world.step(1 / 60);
  }
  return world;
}

it.each(['hash', 'snapshot', 'restore'] as const)('%s says what a world lacks that was made without state', (name) => {
  const world = fallen(createWorld());
  const snapshot = fallen(phys2D.createWorld()).snapshot();
  const message = `World.${name}: the world was made without state: pass { state: worldState } to createWorld`;
  expect(() => world[name](snapshot)).toThrow(message);
});

it('with state it is as one that phys2D made', () => {
  const world = fallen(createWorld({ state: worldState }));
  const other = fallen(phys2D.createWorld());
  expect(world.hash()).toBe(other.hash());
  const snapshot = world.snapshot();
  world.step(1 / 60);
  expect(world.hash()).not.toBe(other.hash());
  world.restore(snapshot);
  expect(world.hash()).toBe(other.hash());
});

it('state can be nothing else', () => {
  // @ts-expect-error a wrong type
  expect(() => createWorld({ state: true })).toThrow(
    'createWorld: state must be worldState of the same bundle, got true',
  );
});
