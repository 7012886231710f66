import { expect, it } from 'vitest';
import { phys2D } from '../../src/index.js';

it('what hangs asleep on an anchor that is in no world wakes when that is moved, and follows', () => {
  const world = phys2D.createWorld();
  const hand = phys2D.createRigidBody({ type: 'static' });
  const shapes = [phys2D.createCircleShape({ radius: 0.3 })];
  const body = phys2D.createRigidBody({ position: [0, 1], linearDrag: 0.9, angularDrag: 0.9, shapes });
  world.addRigidBody(body);
  world.addConstraint(phys2D.createPointConstraint({ bodyA: hand, bodyB: body, anchorB: [0, -1] }));
  for (let i = 0; i < 120; i += 1) {
    world.step(1 / 60);
  }
  expect(body.sleeping).toBe(true);
  hand.setPosition([0, 0]);
  expect(body.sleeping).toBe(true);
  hand.setPosition([3, 0]);
  expect(body.sleeping).toBe(false);
  world.step(1 / 60);
  const [x, y] = body.transformLocalPointToWorld([0, -1]);
  expect(Math.hypot(x - 3, y)).toBeLessThan(0.05);
});
