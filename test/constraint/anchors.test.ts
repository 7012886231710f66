import { expect, it } from 'vitest';
import { phys2D } from '../../src/index.js';
import { add, near, plainBody, staticBody, steps, tie } from '../conformance/setting.js';

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

it.each(['POINT', 'WELD', 'DISTANCE'])(
  'a %s turns what cannot be moved about the origin of that, wherever it is',
  (kind) => {
    for (const type of ['static', 'kinematic'] as const) {
      const world = phys2D.createWorld({ gravity: [0, 6] });
      const wall = staticBody({ type, position: [10, 3], rotation: 1 });
      const body = plainBody({ position: [10.5, 4], mass: 2 });
      const anchorA = wall.transformWorldPointToLocal([10.5, 3]);
      const both = { bodyA: wall, bodyB: body, anchorA, anchorB: [0, -1] as const };
      add(world, wall, body);
      tie(
        world,
        kind === 'POINT'
          ? phys2D.createPointConstraint(both)
          : kind === 'WELD'
            ? phys2D.createWeldConstraint({ ...both, phase: -1 })
            : phys2D.createDistanceConstraint({ ...both, anchorB: [0, 0], lowerBound: 1, upperBound: 1 }),
      );
      steps(world, 30);
      near(world.constraints[0]!.getImpulseForBody(wall), [0, 12 / 60, 0.5 * (12 / 60)], 1e-9);
      near(world.constraints[0]!.getImpulseForBody(body), [0, -12 / 60, 0], 1e-9);
    }
  },
);

it.each(['static', 'kinematic'] as const)(
  'what a point gave to something %s is told about where that was, whenever it is asked',
  (type) => {
    const outcome = (looks: boolean) => {
      const world = phys2D.createWorld({ gravity: [0, 10] });
      const held = staticBody({ type, position: [100, 50] });
      const body = plainBody({ position: [102, 50], mass: 2 });
      const pin = phys2D.createPointConstraint({ bodyA: held, bodyB: body, anchorA: [1, 0], anchorB: [-1, 0] });
      add(world, body, ...(type === 'static' ? [] : [held]));
      tie(world, pin);
      steps(world, 5);
      if (looks) pin.getImpulseForBody(held);
      held.setPosition([0, 50]);
      return { impulse: pin.getImpulseForBody(held), hash: world.hash() };
    };
    expect(outcome(false)).toEqual(outcome(true));
    expect(Math.abs(outcome(false).impulse[2])).toBeLessThan(1);
  },
);
