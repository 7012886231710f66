import { describe, expect, it, vi } from 'vitest';
import { validate } from '../../src/audit/index.js';
import { FAR } from '../../src/config.js';
import { phys2D, type RigidBody, type World } from '../../src/index.js';
import { add, addChain, addFloor, addTower, box, circle } from './things.js';

// A body whose numbers would not be finite is left where it is for the step.

describe('what becomes not finite all the same is frozen, told, and touches nothing else', () => {
  const causes: [string, (body: RigidBody) => void, number?][] = [
    ['a torque of 1.7e308', (body) => body.setTorque(1.7e308)],
    ['a force of 1e300', (body) => body.setForce([1e300, 0])],
    ['a force on next to no mass', (body) => body.setForce([1, 0]), 1e-300],
    ['a mass whose inverse is infinite', () => undefined, 1e-320],
    ['a velocity of 1e308', (body) => body.setVelocity([1e308, 0])],
    ['a spin of 1e308', (body) => body.setAngularVelocity(1e308)],
  ];

  /** Three boxes side by side on a floor, two on top, and one far away: at rest, each touches others. */
  function makePile(): World {
    const world = phys2D.createWorld({ allowSleeping: false });
    addFloor(world);
    for (const [x, y] of [
      [-1, -0.5],
      [0, -0.5],
      [1, -0.5],
      [-0.5, -1.5],
      [0.5, -1.5],
      [30, -9],
    ] as const) {
      add(world, box(1), { position: [x, y] });
    }
    for (let i = 0; i < 60; i += 1) {
      world.step(1 / 60);
    }
    return world;
  }

  it.each(causes)('%s', (_, disturb, mass = 1) => {
    const [bad, good] = [makePile(), makePile()];
    const [one, other] = [bad.rigidBodies[2]!, good.rigidBodies[2]!];
    // For the others it is as if it could not be moved in that step.
    other.setVelocity([0, 0]);
    other.setAngularVelocity(0);
    const told: [unknown, RigidBody, number][] = [];
    expect(
      bad.addEventListener('nonfinite', function (body) {
        told.push([this, body, bad.timeStamp]);
      }),
    ).toBe(true);
    const place = [...one.getPosition(), one.getRotation()];
    one.setMass(mass);
    disturb(one);
    bad.step(1 / 60);
    validate(bad);
    expect(told).toEqual([[bad, one, 61]]);
    expect([...one.getPosition(), one.getRotation()]).toEqual(place);
    expect([...one.getVelocity(), one.getAngularVelocity(), ...one.getForce(), one.getTorque()]).toEqual([
      0, 0, 0, 0, 0, 0,
    ]);
    good.step(1 / 60);
    const free = [bad, good].map((world) => world.rigidBodies[6]!);
    expect(free[0]!.getPosition()).toEqual(free[1]!.getPosition());
    one.setMassFromShapes();
    for (let i = 0; i < 60; i += 1) {
      bad.step(1 / 60);
      good.step(1 / 60);
      validate(bad);
    }
    expect(told.length).toBe(1);
    bad.rigidBodies.forEach((body, i) => {
      const [x, y] = good.rigidBodies[i]!.getPosition();
      expect(Math.hypot(body.getPosition()[0] - x, body.getPosition()[1] - y)).toBeLessThan(0.005);
    });
  });

  /** What of it is as large as it may be as the step begins, and too large at its end. */
  it.each<[string, (body: RigidBody) => void]>([
    ['falls too fast', (body) => body.setForce([0, 3 * FAR * body.getMass()])],
    ['flies too fast', (body) => body.setForce([-3 * FAR * body.getMass(), 0])],
    ['spins too fast', (body) => body.setTorque(3 * FAR * body.getInertia())],
    ['gets too far', (body) => body.setVelocity([0.6 * FAR, 0])],
  ])('what %s in the course of the step', (_, disturb) => {
    const world = phys2D.createWorld({ gravity: [0, 0], substeps: 4 });
    const body = add(world, circle(1), { position: [0.5 * FAR, 3], velocity: [0, 1] });
    const other = add(world, circle(1), { velocity: [0, 1] });
    const told = vi.fn();
    world.addEventListener('nonfinite', told);
    // Steps are of a second, sub-steps of a quarter: what is gained in one is less than may be.
    disturb(body);
    world.step(1);
    expect(told.mock.calls).toEqual([[body]]);
    expect([...body.getPosition(), body.getRotation()]).toEqual([0.5 * FAR, 3, 0]);
    expect([...body.getVelocity(), body.getAngularVelocity(), ...body.getForce(), body.getTorque()]).toEqual([
      0, 0, 0, 0, 0, 0,
    ]);
    expect(other.getPosition()[1]).toBeGreaterThan(0.9);
    validate(world);
  });

  it('a force that overflows in the middle of a jointed heap: joints and contacts go on', () => {
    const world = phys2D.createWorld();
    addFloor(world);
    addChain(world, 6);
    addTower(world, 4);
    const [, , , link] = world.rigidBodies;
    const told: RigidBody[] = [];
    const listen = (body: RigidBody): void => void told.push(body);
    world.addEventListener('nonfinite', listen);
    expect(world.addEventListener('nonfinite', listen)).toBe(false);
    for (let i = 0; i < 120; i += 1) {
      if (i === 60) {
        link!.setForce([0, 1e200]);
      }
      world.step(1 / 60);
      validate(world);
    }
    expect(told).toEqual([link]);
    expect(world.removeEventListener('nonfinite', listen)).toBe(true);
    expect(world.addEventListener('wake' as 'nonfinite', listen)).toBe(false);
  });

  it('nothing is left of the way that it would have gone: put elsewhere, it passes no wall', () => {
    const material = phys2D.createMaterial({ elasticity: 1 });
    const world = phys2D.createWorld({ gravity: [0, 0] });
    const wall = phys2D.createPolygonShape({ vertices: phys2D.createBoxVertices(0.01, 10), material });
    world.addRigidBody(phys2D.createRigidBody({ type: 'static', position: [10, 0], shapes: [wall] }));
    const shapes = [phys2D.createCircleShape({ radius: 0.05, material })];
    const place = [0.99 * FAR, 0];
    const body = phys2D.createRigidBody({ position: place, velocity: place, linearDrag: 0, shapes });
    world.addRigidBody(body);
    const told = vi.fn();
    world.addEventListener('nonfinite', told);
    world.step(1 / 60);
    expect(told).toHaveBeenCalledOnce();
    body.setPosition([0, 0]);
    body.setVelocity([3000, 0]);
    world.step(1 / 60);
    expect(body.getPosition()[0]).toBeLessThan(10);
  });

  it('what throws in its handler reaches the caller, and the next step works', () => {
    const world = makePile();
    world.addEventListener('nonfinite', () => {
      throw new Error('mine');
    });
    world.rigidBodies[1]!.setTorque(1.7e308);
    expect(() => world.step(1 / 60)).toThrow('mine');
    validate(world);
    world.step(1 / 60);
  });
});

describe('a custom constraint that fails is left out, and told, and nothing else is touched', () => {
  const fails = {
    'writes NaN': (data: Record<number, number>, index: number) => {
      data[index] = NaN;
    },
    throws: () => {
      throw new Error('mine');
    },
  };
  // Before it could have any effect. One that fails later does nothing more in that step.
  const names = ['jacobian', 'velocityClamp'] as const;

  it.each(Object.entries(fails).flatMap(([how, fail]) => names.map((name) => [how, name, fail] as const)))(
    'one that %s in %s',
    (_, name, fail) => {
      const [bad, good] = [phys2D.createWorld(), phys2D.createWorld()];
      for (const world of [bad, good]) {
        addFloor(world);
        addTower(world, 3);
      }
      const bodies = [bad.rigidBodies[1]!, bad.rigidBodies[2]!];
      const callbacks = {
        jacobian(data: Record<number, number>, index: number) {
          data[index + 1] = 1;
        },
        position(data: Record<number, number>, index: number) {
          data[index] = 0.1;
        },
        [name]: fail,
      };
      bad.addConstraint(phys2D.createCustomConstraint({ dimension: 1, bodies, ...callbacks }));
      for (let i = 0; i < 30; i += 1) {
        expect(() => bad.step(1 / 60)).toThrow(
          new RegExp(`mine|^CustomConstraint\\.${name} of world\\.constraints\\[0\\]: `),
        );
        good.step(1 / 60);
        validate(bad);
      }
      const places = (world: World) => world.rigidBodies.map((body) => body.getPosition());
      expect(places(bad)).toEqual(places(good));
    },
  );
});
