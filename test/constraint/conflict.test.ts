import { describe, expect, it } from 'vitest';
import { phys2D } from '../../src/index.js';
import { add, boxBody, DT, heavy, near, staticBody, steps, tie } from '../conformance/setting.js';

// Joints that cannot both be met move their bodies to somewhere between, and make no momentum of it.

describe('joints against each other', () => {
  it('a body torn between two anchors, near or far, stands still', () => {
    for (const apart of [0.001, 0.03, 0.8, 3]) {
      const world = heavy();
      const body = boxBody(1, 1);
      add(world, body);
      for (const x of [0, apart]) {
        tie(world, phys2D.createWeldConstraint({ bodyA: staticBody({ position: [x, 0] }), bodyB: body }));
      }
      steps(world, 120);
      near(body.getVelocity(), [0, 0], 1e-3);
      near(body.getAngularVelocity(), 0, 1e-3);
      expect(body.getPosition()[0]).toBeGreaterThanOrEqual(-1e-6);
      expect(body.getPosition()[0]).toBeLessThanOrEqual(apart + 1e-6);
    }
  });

  it('a welded crate that a rope tears away follows the rope, as fast as that', () => {
    const world = heavy();
    const crate = boxBody(1, 1);
    const lift = phys2D.createRigidBody({ type: 'kinematic', position: [0, -3], velocity: [0, -1] });
    add(world, crate, lift);
    tie(
      world,
      phys2D.createWeldConstraint({ bodyA: staticBody(), bodyB: crate }),
      phys2D.createDistanceConstraint({ bodyA: lift, bodyB: crate, upperBound: 3 }),
    );
    for (let i = 0; i < 600; i += 1) {
      world.step(DT);
      const [, vy] = crate.getVelocity();
      expect(Math.abs(vy)).toBeLessThan(1.5);
    }
  });

  it('two angles that cannot both be met leave no spin', () => {
    const world = heavy();
    const body = boxBody(1, 1);
    add(world, body);
    for (const angle of [0, 0.8]) {
      const bounds = { lowerBound: angle, upperBound: angle };
      tie(world, phys2D.createAngleConstraint({ bodyA: staticBody(), bodyB: body, ...bounds }));
    }
    steps(world, 20);
    near(body.getAngularVelocity(), 0, 1e-3);
  });
});
