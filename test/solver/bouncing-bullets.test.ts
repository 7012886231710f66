import { describe, expect, it } from 'vitest';
import { phys2D } from '../../src/index.js';
import { add, box, disc, steps, weightless } from '../conformance/setting.js';
import { stateHash } from '../scenes/hash.js';
import { generator } from '../scenes/mixed.js';

// What bounces off everything is not looked ahead for, unless some material of the program takes others their bounces.

/** Bullets that bounce between walls, off each other and off sleeping bodies. */
function shoot(count: number): string {
  const world = weightless();
  const random = generator(11);
  const material = phys2D.createMaterial({ elasticity: 0.8 });
  for (const [x, y, w, h] of [
    [0, 5, 20, 0.1],
    [0, -5, 20, 0.1],
    [10, 0, 0.1, 10],
    [-10, 0, 0.1, 10],
    [2, 0, 0.1, 6],
  ] as const) {
    add(world, phys2D.createRigidBody({ type: 'static', shapes: [box(w, h)], position: [x, y] }));
  }
  for (let i = 0; i < count; i += 1) {
    const shape = i % 2 === 0 ? disc(0.1) : box(0.2, 0.2);
    shape.setMaterial(material);
    const isStill = i % 5 === 0;
    const body = phys2D.createRigidBody({
      shapes: [shape],
      position: [18 * random() - 9, 9 * random() - 4.5],
      velocity: isStill ? [0, 0] : [300 * random() - 150, 300 * random() - 150],
      bullet: !isStill,
      sleeping: isStill,
    });
    add(world, body);
  }
  steps(world, 40);
  return stateHash(world);
}

describe('bullets that bounce', () => {
  it('go the same ways whether they were looked ahead for or not', () => {
    const before = shoot(40);
    phys2D.createMaterial({ elasticity: -1 });
    expect(shoot(40)).toBe(before);
  });

  it('land within the step on what takes their bounces, and slide on', () => {
    const dead = phys2D.createMaterial({ elasticity: -Infinity, staticFriction: 0, dynamicFriction: 0 });
    const lively = phys2D.createMaterial({ elasticity: 1, staticFriction: 0, dynamicFriction: 0 });
    const world = weightless();
    const floor = box(200, 1);
    floor.setMaterial(dead);
    add(world, phys2D.createRigidBody({ type: 'static', shapes: [floor], position: [50, 5] }));
    const ball = disc(0.1);
    ball.setMaterial(lively);
    const bullet = phys2D.createRigidBody({ shapes: [ball], velocity: [120, 120], bullet: true, linearDrag: 0 });
    add(world, bullet);
    steps(world, 10);
    expect(bullet.getVelocity()[1]).toBeCloseTo(0, 6);
    expect(bullet.getPosition()[0]).toBeCloseTo(20, 3);
  });
});
