import { describe, expect, it } from 'vitest';
import { phys2D, type Vec2 } from '../../src/index.js';
import {
  add,
  box,
  boxBody,
  DT,
  heavy,
  near,
  speed,
  staticBody,
  steps,
  tie,
  weightless,
} from '../conformance/setting.js';

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

describe('joints against contacts', () => {
  it('boxes that overlap where they are joined lie still', () => {
    for (const overlap of [0.05, 0.2, 0.5]) {
      const world = weightless();
      const boxes = [0, 1, 2, 3].map((i) => boxBody(1, 1, { position: [i * (1 - overlap), 0] }));
      add(world, ...boxes);
      boxes.slice(1).forEach((bodyB, i) => {
        const half = (1 - overlap) / 2;
        tie(world, phys2D.createPointConstraint({ bodyA: boxes[i]!, bodyB, anchorA: [half, 0], anchorB: [-half, 0] }));
      });
      for (let i = 0; i < 120; i += 1) {
        world.step(DT);
        for (const box of boxes) {
          near(box.getVelocity(), [0, 0], 1e-6);
        }
      }
      expect(world.liveDynamics).toEqual([]);
    }
  });

  it('a chain that is pulled against a wall is not thrown about', () => {
    for (const gravity of [0, 10]) {
      const world = phys2D.createWorld({ gravity: [0, gravity] });
      const lift = phys2D.createRigidBody({ type: 'kinematic', position: [-4, 0], velocity: [-1, 0] });
      const ball = boxBody(1, 1, { position: [2, 0] });
      const links = [-3.5, -2.5, -1.5, -0.5, 0.5].map((x) => boxBody(1, 0.2, { position: [x, 0] }, { mask: 0 }));
      add(world, staticBody({ shapes: [box(0.5, 5)] }), lift, ...links, ball);
      [...links, ball].forEach((bodyB, i) => {
        const ends = i === 0 ? ([lift, [0, 0]] as const) : ([links[i - 1]!, [0.5, 0]] as const);
        const params = { bodyA: ends[0], bodyB, anchorA: [...ends[1]] as Vec2, anchorB: [-0.5, 0] as Vec2 };
        tie(world, phys2D.createPointConstraint(params));
      });
      for (let i = 0; i < 600; i += 1) {
        world.step(DT);
        for (const body of world.rigidBodies) {
          expect(speed(body)).toBeLessThan(40);
        }
      }
    }
  });
});
