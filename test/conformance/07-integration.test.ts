import { describe, expect, it } from 'vitest';
import type { World } from '../../src/index.js';
import { add, heavy, near, plainBody, steps, weightless } from './setting.js';

// Closed-form numbers are stated for one sub-step; with more, results lie between them and the analytic truth.

/** `value` lies between two bounds given in any order, up to rounding. */
function between(value: number, a: number, b: number): void {
  expect(value).toBeGreaterThanOrEqual(Math.min(a, b) - 1e-9);
  expect(value).toBeLessThanOrEqual(Math.max(a, b) + 1e-9);
}

describe('integration', () => {
  it('C-078 a body falls by semi-implicit Euler steps', () => {
    const fall = (world: World): { vy: number; y: number } => {
      const body = plainBody();
      add(world, body);
      steps(world, 60);
      return { vy: body.getVelocity()[1], y: body.getPosition()[1] };
    };
    const single = fall(heavy({ substeps: 1 }));
    near(single.vy, 10, 1e-4);
    near(single.y, 5.083333, 1e-4);
    const parts = fall(heavy());
    near(parts.vy, 10, 1e-4);
    between(parts.y, 5.0833334, 5);
  });

  it('C-079 drag is the share of velocity lost per second', () => {
    for (const substeps of [1, 4]) {
      const world = weightless({ substeps });
      const body = plainBody({ linearDrag: 0.5, angularDrag: 0.5, velocity: [8, 0], angularVelocity: 8 });
      add(world, body);
      steps(world, 60);
      near(body.getVelocity(), [4, 0], 1e-4);
      near(body.getAngularVelocity(), 4, 1e-4);
    }
  });

  it('C-080 force and torque act in every step until changed', () => {
    for (const substeps of [1, 4]) {
      const world = weightless({ substeps });
      const body = plainBody({ mass: 2, inertia: 2, force: [6, 0], torque: 6 });
      add(world, body);
      steps(world, 60);
      near(body.getVelocity(), [3, 0], 1e-4);
      near(body.getAngularVelocity(), 3, 1e-4);
      expect(body.getForce()).toEqual([6, 0]);
    }
  });

  it('C-081 gravity does not act on infinite mass', () => {
    const world = heavy();
    const body = plainBody({ mass: Number.POSITIVE_INFINITY, velocity: [1, 0] });
    add(world, body);
    steps(world, 60);
    expect(body.getVelocity()).toEqual([1, 0]);
  });

  it('C-082 a kinematic body moves as its velocity says', () => {
    const world = heavy();
    const body = plainBody({
      type: 'kinematic',
      velocity: [1, 0],
      angularVelocity: 2,
      linearDrag: 0.5,
      angularDrag: 0.5,
      force: [9, 9],
    });
    add(world, body);
    steps(world, 60);
    near(body.getPosition(), [1, 0], 1e-4);
    near(body.getRotation(), 2, 1e-4);
    expect(body.getVelocity()).toEqual([1, 0]);
    expect(body.getAngularVelocity()).toBe(2);
  });

  it('C-083 a drag of 1 stops the body in each step', () => {
    const world = weightless();
    const body = plainBody({ linearDrag: 1, velocity: [5, 0] });
    add(world, body);
    steps(world, 1);
    near(body.getVelocity(), [0, 0]);
  });
});
