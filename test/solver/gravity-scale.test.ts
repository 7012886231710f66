import { describe, expect, it } from 'vitest';
import { phys2D, type RigidBody, type RigidBodyParams, worldState } from '../../src/index.js';
import { add, addFloor, boxBody, DT, heavy, steps } from '../conformance/setting.js';

// How much of the gravity of its world a body feels.

const motion = (body: RigidBody) => [
  ...body.getPosition(),
  body.getRotation(),
  ...body.getVelocity(),
  body.getAngularVelocity(),
];

/** A heap that falls on a floor in a world with a gravity, of bodies that feel so much of it. */
function heap(gravity: number, gravityScale: number): RigidBody[] {
  const world = phys2D.createWorld({ gravity: [0, gravity] });
  addFloor(world);
  const bodies = Array.from({ length: 12 }, (_, i) =>
    boxBody(0.5, 0.4, { position: [0.1 * (i % 3), -0.6 * i - 0.5], rotation: 0.1 * i, gravityScale }),
  );
  add(world, ...bodies);
  steps(world, 150);
  return bodies;
}

describe('the gravity scale of a body', () => {
  it('is 1 unless given, and may be any finite number', () => {
    expect(phys2D.createRigidBody().getGravityScale()).toBe(1);
    const body = phys2D.createRigidBody({ gravityScale: -0.5 });
    expect(body.getGravityScale()).toBe(-0.5);
    body.setGravityScale(0);
    expect(body.getGravityScale()).toBe(0);
  });

  it.each([0.5, 2, 4])('of %f is as that much gravity, to the bit', (scale) => {
    expect(heap(10, scale).map(motion)).toEqual(heap(10 * scale, 1).map(motion));
  });

  it('is of each body its own, and of static and kinematic ones nothing', () => {
    const world = heavy();
    const scales = [1, 0, -0.1];
    const free = { linearDrag: 0, angularDrag: 0 };
    const bodies = scales.map((gravityScale, i) => boxBody(1, 1, { position: [3 * i, 0], gravityScale, ...free }));
    const others = (['static', 'kinematic'] as const).map((type, i) =>
      boxBody(1, 1, { type, position: [3 * i, 50], gravityScale: 3 }),
    );
    add(world, ...bodies, ...others);
    steps(world, 60);
    const gravity = world.getGravity()[1];
    bodies.forEach((body, i) => void expect(body.getVelocity()[1]).toBeCloseTo(gravity * scales[i]!, 9));
    expect(others.map((body) => body.getPosition())).toEqual([
      [0, 50],
      [3, 50],
    ]);
  });

  it('lets what feels none fall asleep where it is, and wakes it when it changes, and only then', () => {
    const world = heavy();
    const body = boxBody(1, 1, { gravityScale: 0 });
    add(world, body);
    steps(world, 70);
    expect([body.sleeping, ...body.getPosition()]).toEqual([true, 0, 0]);
    body.setGravityScale(0);
    expect(body.sleeping).toBe(true);
    body.setGravityScale(1);
    expect(body.sleeping).toBe(false);
    steps(world, 10);
    expect(body.getPosition()[1]).toBeGreaterThan(0.1);
  });

  it('is looked ahead by: what falls sixty times as fast lands in the step in which it comes, and passes nothing', () => {
    const run = (height: number, params: RigidBodyParams, gravity: number): number[] => {
      const world = phys2D.createWorld({ gravity: [0, gravity] });
      add(world, boxBody(10, 0.02, { type: 'static' }));
      const body = boxBody(0.5, 0.5, { position: [0, -0.26 - height], ...params });
      add(world, body);
      return Array.from({ length: 30 }, () => {
        world.step(DT);
        return body.getPosition()[1];
      });
    };
    for (const height of [0.05, 0.1, 0.5]) {
      const places = run(height, { gravityScale: 64 }, 10);
      expect(places).toEqual(run(height, {}, 640));
      expect(Math.max(...places)).toBeLessThan(-0.25);
    }
  });

  it('is part of snapshots and hashes', () => {
    const world = phys2D.createWorld({ state: worldState });
    const body = boxBody(1, 1, { gravityScale: 0.5 });
    add(world, body);
    steps(world, 3);
    const hash = world.hash();
    const saved = world.snapshot();
    body.setGravityScale(-2);
    expect(world.hash()).not.toBe(hash);
    world.restore(saved);
    expect([body.getGravityScale(), world.hash()]).toEqual([0.5, hash]);
  });
});
