import { describe, expect, it } from 'vitest';
import { phys2D, type World } from '../../src/index.js';
import { buildPyramid } from '../scenes/pyramid.js';

const PHASES = [
  'pairs',
  'foresight',
  'islands',
  'prepare',
  'velocities',
  'positions',
  'store',
  'continuous',
  'events',
] as const;

/** A clock that counts how often it was asked. */
function counter(): () => number {
  let time = 0;
  return () => {
    time += 1;
    return time;
  };
}

function sum(world: World): number {
  return PHASES.reduce((total, phase) => total + world.profile![phase], 0);
}

describe('World.profile', () => {
  it('is null without a clock', () => {
    const world = phys2D.createWorld();
    expect(world.clock).toBeNull();
    expect(world.profile).toBeNull();
    world.clock = counter();
    expect(world.profile).not.toBeNull();
    world.clock = null;
    world.step(1 / 60);
    expect(world.profile).toBeNull();
  });

  it('has the times of the latest step, and they add up to it', () => {
    const world = phys2D.createWorld({ substeps: 3 });
    world.addRigidBody(phys2D.createRigidBody({ shapes: [phys2D.createCircleShape({ radius: 1 })] }));
    world.clock = counter();
    const { profile } = world;
    for (let i = 0; i < 3; i += 1) {
      world.step(1 / 60);
      // One tick each: five phases, two in each sub-step, and three at the end.
      expect(PHASES.map((phase) => profile![phase])).toEqual([1, 1, 1, 1, 3, 3, 1, 1, 1]);
      expect(sum(world)).toBe(13);
    }
    expect(world.profile).toBe(profile);
  });

  it('has no sub-steps where nothing is awake', () => {
    const world = phys2D.createWorld();
    world.clock = counter();
    world.step(1 / 60);
    expect(PHASES.map((phase) => world.profile![phase])).toEqual([1, 1, 1, 1, 0, 0, 0, 0, 1]);
  });

  it('measures with a real clock', () => {
    const world = phys2D.createWorld({ allowSleeping: false });
    buildPyramid(phys2D, world, 20);
    world.clock = () => performance.now();
    const start = performance.now();
    world.step(1 / 60);
    const whole = performance.now() - start;
    expect(sum(world)).toBeLessThanOrEqual(whole);
    expect(sum(world)).toBeGreaterThan(0.5 * whole);
    expect(world.profile!.velocities).toBeGreaterThan(0);
  });

  it('counts what there is to do', () => {
    const world = phys2D.createWorld();
    const box = (): ReturnType<typeof phys2D.createPolygonShape> =>
      phys2D.createPolygonShape({ vertices: phys2D.createBoxVertices(1, 1) });
    const floor = phys2D.createPolygonShape({ vertices: phys2D.createBoxVertices(40, 1) });
    world.addRigidBody(phys2D.createRigidBody({ type: 'static', position: [0, 1], shapes: [floor] }));
    const boxes = [0, 4, 5.002].map((x) => phys2D.createRigidBody({ position: [x, 0], shapes: [box()] }));
    for (const body of boxes) {
      world.addRigidBody(body);
    }
    const sensor = phys2D.createCircleShape({ radius: 1, sensor: true });
    world.addRigidBody(phys2D.createRigidBody({ type: 'static', position: [0, 0], shapes: [sensor] }));
    world.clock = counter();
    world.step(1 / 60);
    const { profile } = world;
    expect(profile).toMatchObject({ awakeBodies: 3, activePairs: 5, manifolds: 4, contacts: 4, joints: 0, impacts: 0 });
    expect(profile!.awakeIslands).toBe(3);
    world.addConstraint(phys2D.createPointConstraint({ bodyA: boxes[0]!, bodyB: boxes[1]! }));
    world.step(1 / 60);
    expect(profile).toMatchObject({ joints: 1, awakeIslands: 2 });
  });

  it('counts the islands that stay awake, also as one falls asleep', () => {
    const world = phys2D.createWorld();
    const add = (type: 'static' | 'dynamic', position: [number, number], width: number) => {
      const shapes = [phys2D.createPolygonShape({ vertices: phys2D.createBoxVertices(width, 1) })];
      const body = phys2D.createRigidBody({ type, position, shapes });
      world.addRigidBody(body);
      return body;
    };
    add('static', [0, 1], 40);
    add('dynamic', [-10, 0], 1);
    add('dynamic', [5, 0], 1);
    const top = add('dynamic', [5, -1], 1);
    world.clock = counter();
    const counted = new Set<number>();
    for (let i = 0; i < 100; i += 1) {
      if (i % 20 === 10) {
        top.setVelocity([0, -0.01]);
      }
      world.step(1 / 60);
      const sides = new Set(world.liveDynamics.map((body) => body.getPosition()[0] > 0)).size;
      if (i > 1) {
        expect(world.profile!.awakeIslands).toBe(sides);
      }
      counted.add(sides);
    }
    expect([...counted]).toEqual([2, 1]);
  });

  it('counts impacts', () => {
    const world = phys2D.createWorld({ gravity: [0, 0] });
    const wall = phys2D.createPolygonShape({ vertices: phys2D.createBoxVertices(0.1, 10) });
    world.addRigidBody(phys2D.createRigidBody({ type: 'static', position: [5, 0], shapes: [wall] }));
    const ball = phys2D.createCircleShape({
      radius: 0.1,
      material: phys2D.createMaterial({ elasticity: 1 }),
    });
    const shot = phys2D.createRigidBody({ position: [-3, 0], velocity: [500, 0], shapes: [ball] });
    world.addRigidBody(shot);
    world.clock = counter();
    world.step(1 / 60);
    expect(world.profile!.impacts).toBe(1);
    world.step(1 / 60);
    expect(world.profile!.impacts).toBe(0);
  });

  it('changes nothing', () => {
    const poses = [false, true].map((timed) => {
      const world = phys2D.createWorld();
      const boxes = buildPyramid(phys2D, world, 6);
      world.clock = timed ? counter() : null;
      for (let i = 0; i < 60; i += 1) {
        world.step(1 / 60);
      }
      return boxes.flatMap((body) => [...body.getPosition(), body.getRotation()]);
    });
    expect(poses[1]).toEqual(poses[0]);
  });

  it('a clock is a function or null', () => {
    const world = phys2D.createWorld();
    for (const clock of [undefined, 1, 'now', {}]) {
      expect(() => {
        world.clock = clock as never;
      }).toThrow(/World: clock/);
    }
    expect(world.clock).toBeNull();
  });
});
