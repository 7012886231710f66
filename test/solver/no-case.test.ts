import { describe, expect, it } from 'vitest';
import { phys2D } from '../../src/index.js';
import { add, box, DT, steps, weightless } from '../conformance/setting.js';

// Two points are solved by trying which of them push. Where exactly neither has to, rounding may deny all four cases.

const slick = phys2D.createMaterial({ staticFriction: 0, dynamicFriction: 0 });

describe('a crate that a rigid point presses into a wall', () => {
  it.each([
    [1, 0],
    [4, 0.8],
    [8, 0.4],
    [8, 0.8],
  ])('stays as it is let go of: %i sub-steps, drawn at %f rad to it', (substeps, angle) => {
    for (let seconds = 8; seconds <= 14; seconds += 1) {
      const world = weightless({ substeps });
      const wall = phys2D.createRigidBody({
        type: 'static',
        position: [-0.91, 0],
        shapes: [box(1, 40, { material: slick })],
      });
      const crate = phys2D.createRigidBody({ shapes: [box(0.8, 0.8, { material: slick })] });
      const velocity = [-0.3 * Math.cos(angle), -0.3 * Math.sin(angle)];
      const hand = phys2D.createRigidBody({ type: 'kinematic', velocity });
      const grip = phys2D.createPointConstraint({ bodyA: hand, bodyB: crate });
      add(world, wall, crate, hand);
      world.addConstraint(grip);
      steps(world, 60 * seconds);
      world.removeConstraint(grip);
      world.step(DT);
      // At most 0.3 m/s along the wall; up to 1521 m/s away from it before.
      expect(Math.hypot(...crate.getVelocity())).toBeLessThan(0.31);
    }
  });
});
