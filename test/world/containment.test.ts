import { describe, expect, it } from 'vitest';
import { validate } from '../../src/audit/index.js';
import { phys2D, type RigidBody, type RigidBodyParams, type World } from '../../src/index.js';
import { add, addChain, addFloor, addTower, box, circle } from './things.js';

// Extreme but legal input: all stays finite and consistent. How fast it is, is not asked here.

function stays(build: (world: World) => void, steps = 90, dt = 1 / 60, disturb?: (world: World) => void): void {
  const world = phys2D.createWorld();
  build(world);
  for (let i = 0; i < steps; i += 1) {
    disturb?.(world);
    world.step(dt);
    validate(world);
  }
  expect(world.timeStamp).toBe(steps);
}

describe('all stays finite and consistent', () => {
  it.each([1e-3, 1e-2, 1e3, 1e6])('with sizes of %d m', (size) => {
    stays((world) => {
      addFloor(world, size);
      addTower(world, 8, size);
    });
  });

  it('with sizes of 1 mm and 1000 km in one world', () => {
    stays((world) => {
      add(world, box(1e6), { type: 'static', position: [0, 5e5] });
      addTower(world, 8, 1e-3);
      addTower(world, 4, 1e6);
    });
  });

  it.each([1e3, 1e5])('with speeds of %d m/s', (speed) => {
    stays((world) => {
      addFloor(world);
      add(world, box(1, 100), { type: 'static', position: [20, -40] });
      addTower(world, 20, 1, (i) => ({
        velocity: [speed, (i - 10) * 0.1 * speed],
        angularVelocity: i % 3 === 0 ? speed : 0,
        bullet: i % 4 === 0,
      }));
    });
  });

  it.each([
    [1e-6, 1e9],
    [1e9, 1e-6],
    [1e-6, 1e-6],
    [1e9, 1e9],
  ])('with masses of %d kg and %d kg by turns, in towers and chains', (even, odd) => {
    stays((world) => {
      addFloor(world);
      const params = (i: number): RigidBodyParams => ({ mass: i % 2 === 0 ? even : odd });
      addTower(world, 10, 1, params);
      addChain(world, 10, params);
    });
  });

  it.each([1e-5, 1e-3, 0.1, 1])('with steps of %d s', (dt) => {
    stays(
      (world) => {
        addFloor(world);
        addTower(world, 12);
        addChain(world, 10);
      },
      90,
      dt,
    );
  });

  it('with steps of 1e-5 s and 1 s by turns', () => {
    const world = phys2D.createWorld();
    addFloor(world);
    addTower(world, 12);
    addChain(world, 10);
    for (let i = 0; i < 60; i += 1) {
      world.step(i % 2 === 0 ? 1e-5 : 1);
      validate(world);
    }
    expect(world.simulatedTime).toBeCloseTo(30.0003, 9);
  });

  it.each([
    ['boxes', () => box(1)],
    ['circles', () => circle(0.5)],
  ] as const)('with 80 %s at one point', (_, make) => {
    stays((world) => {
      for (let i = 0; i < 80; i += 1) {
        add(world, make());
      }
    }, 3);
  });

  it.each([1e6, 1e20, 1e150, 1e300])('with forces, velocities and gravity of %d', (size) => {
    for (const disturb of [
      (_: World, body: RigidBody) => body.setForce([size, -size]),
      (_: World, body: RigidBody) => body.setTorque(size),
      (_: World, body: RigidBody) => body.setVelocity([size, size]),
      (_: World, body: RigidBody) => body.setPosition([size, 0]),
      (_: World, body: RigidBody) => body.setSurfaceVelocity([size, size]),
      (world: World) => world.setGravity([0, size]),
    ]) {
      stays((world) => {
        addFloor(world);
        addTower(world, 3);
        disturb(world, world.rigidBodies[1]!);
      }, 10);
    }
  });

  it.each([1e-300, 1e-160, 1e30, 1e160, 1e300])('with a custom constraint that writes %d', (value) => {
    for (const name of ['jacobian', 'position', 'velocityClamp', 'positionClamp']) {
      stays((world) => {
        addFloor(world);
        addTower(world, 3);
        const constraint = phys2D.createCustomConstraint({
          dimension: 1,
          bodies: [world.rigidBodies[1]!, world.rigidBodies[2]!],
          jacobian(data, index) {
            data[index] = 1;
            data[index + 3] = -1;
          },
          position(data, index) {
            data[index] = 0.1;
          },
          [name](data: Record<number, number>, index: number) {
            data[index] = value;
          },
        });
        world.addConstraint(constraint);
      }, 10);
    }
  });
});

describe('what would lead to numbers that are not finite is refused', () => {
  const far: [string, (body: RigidBody) => void][] = [
    ['RigidBody.applyImpulse: impulse', (body) => body.applyImpulse([1e308, 0], [0, 1e10])],
    ['RigidBody.integrate: deltaTime', (body) => body.integrate(1e300)],
    ['RigidBody.setVelocityFromPosition: deltaTime', (body) => body.setVelocityFromPosition([1e10, 0], 0, 1e-300)],
    ['Shape.scale: scaleX', (body) => body.shapes[0]!.scale(1e-200)],
    ['Shape.scale: scaleX', (body) => body.shapes[0]!.scale(1e200)],
    ['Shape.translate: translation', (body) => body.shapes[0]!.translate([1e100, 0])],
    ['Shape.transform: matrix', (body) => body.shapes[0]!.transform([1e200, 0, 0, 1e200, 0, 0])],
    ['Circle.setRadius: radius', () => circle(1).setRadius(1e80)],
    ['createCircleShape: radius', () => circle(1e80)],
    ['createPolygonShape: vertices[0][0]', () => box(1e80)],
  ];
  it.each(far)('%s', (name, call) => {
    for (const shape of [box(1), circle(0.5)]) {
      const world = phys2D.createWorld();
      addFloor(world);
      const body = add(world, shape, { position: [0, -2], velocity: [1e10, 0] });
      const before = world.hash();
      expect(() => call(body)).toThrow(RangeError);
      expect(() => call(body)).toThrow(`${name} must be`);
      expect(world.hash()).toBe(before);
    }
  });
});
