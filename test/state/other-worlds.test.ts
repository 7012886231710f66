import { expect, it } from 'vitest';
import { phys2D } from '../../src/index.js';
import { add, heavy, plainBody, staticBody, steps, tie } from '../conformance/setting.js';

it('goes on to the bit after a restore, whatever constraints of other worlds are between its bodies', () => {
  const [world, other] = [heavy(), heavy()];
  const ground = staticBody();
  const [first, second] = [plainBody({ position: [1, 0] }), plainBody({ position: [2, 0] })];
  add(world, first, second);
  for (const [bodyA, bodyB] of [
    [ground, first],
    [first, second],
  ] as const) {
    tie(world, phys2D.createPointConstraint({ bodyA, bodyB, anchorB: [-1, 0] }));
  }
  steps(world, 30);
  tie(other, phys2D.createWeldConstraint({ bodyA: first, bodyB: second }));
  const snapshot = world.snapshot();
  steps(world, 60);
  const hash = world.hash();
  world.restore(snapshot);
  steps(world, 60);
  expect(world.hash()).toBe(hash);
});
