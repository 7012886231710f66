import { describe, expect, it } from 'vitest';
import { validate } from '../../src/audit/index.js';
import {
  type Broadphase,
  phys2D,
  type RigidBody,
  type RigidBodyParams,
  type Shape,
  type World,
} from '../../src/index.js';
import { deserialize, serialize } from '../../src/state/index.js';
import { generator } from '../scenes/mixed.js';

// What goes on must follow from what hash and snapshots tell: nothing that is only remembered may have a say in it.

const box = (width: number, height: number) =>
  phys2D.createPolygonShape({ vertices: phys2D.createBoxVertices(width, height) });
const disc = (radius: number) => phys2D.createCircleShape({ radius });

/** Whirling slats and balls between three walls: wide walls, as it is their radius that is asked for. */
function whirl(broadphase: Broadphase = phys2D.createBoxTreeBroadphase()): World {
  const world = phys2D.createWorld({ broadphase });
  const walls: [number, number, number, number][] = [
    [0, 5, 20, 1],
    [-5, 0, 1, 20],
    [5, 0, 1, 20],
  ];
  for (const [x, y, width, height] of walls) {
    world.addRigidBody(phys2D.createRigidBody({ type: 'static', position: [x, y], shapes: [box(width, height)] }));
  }
  for (let i = 0; i < 8; i += 1) {
    world.addRigidBody(
      phys2D.createRigidBody({
        position: [i - 3.5, (i * 3) % 4],
        velocity: [(i % 3) * 12 - 12, (i % 4) * 8 - 10],
        angularVelocity: (i % 5) * 14 - 28,
        shapes: [i % 3 === 0 ? disc(0.3) : box(0.4 + 0.15 * i, 0.1 + 0.06 * i)],
      }),
    );
  }
  return world;
}

describe('what hash and snapshots do not tell', () => {
  it('is not whether somebody asked for masses', () => {
    const [quiet, asked] = [whirl(), whirl()];
    for (const body of asked.rigidBodies) {
      body.getMass();
    }
    // A static body overlaps a paddle that is far too heavy to be pushed out at once, so that it whirls where it touches.
    const heavy = [quiet, asked].map((world) => {
      const block = phys2D.createRigidBody({
        type: 'static',
        position: [20, 0],
        rotation: -4.3,
        shapes: [box(0.852, 1.11)],
      });
      const paddle = phys2D.createRigidBody({
        position: [20.267, -0.526],
        mass: 1e9,
        angularVelocity: 20,
        shapes: [phys2D.createPolygonShape({ vertices: phys2D.createRectangleVertices(-0.564, -0.814, 0.466, 0.256) })],
      });
      world.addRigidBody(block);
      world.addRigidBody(paddle);
      return { block, paddle };
    });
    expect(heavy[1]!.block.getMass()).toBeGreaterThan(0);
    for (let i = 0; i < 200; i += 1) {
      quiet.step(1 / 60);
      asked.step(1 / 60);
    }
    expect(asked.hash()).toBe(quiet.hash());
    expect(heavy[1]!.paddle.getPosition()).toEqual(heavy[0]!.paddle.getPosition());
  });

  it('is not how large static bodies are, in a copy by serialize', () => {
    const world = whirl();
    for (let i = 0; i < 80; i += 1) {
      world.step(1 / 60);
    }
    const copy = deserialize(phys2D, serialize(world));
    const radii = ({ rigidBodies }: World) => rigidBodies.map(({ radius }) => radius);
    expect(radii(copy)).toEqual(radii(world));
    for (let i = 0; i < 60; i += 1) {
      world.step(1 / 60);
      copy.step(1 / 60);
    }
    expect(copy.hash()).toBe(world.hash());
  });

  it('is not what joints had that are gone', () => {
    const run = (steps: number) => {
      const world = phys2D.createWorld({ gravity: [0, 0] });
      const [a, b] = [1, -1].map((x) => {
        const body = phys2D.createRigidBody({
          position: [x, 0],
          velocity: [3, 0],
          angularVelocity: x,
          shapes: [disc(0.2)],
        });
        world.addRigidBody(body);
        return body;
      }) as [RigidBody, RigidBody];
      world.addConstraint(phys2D.createDistanceConstraint({ bodyA: a, bodyB: b, anchorA: [0.3, 0], upperBound: 2 }));
      world.step(1 / 30);
      const snapshot = world.snapshot();
      for (let i = 0; i < steps; i += 1) {
        world.step(1 / 60);
      }
      world.restore(snapshot);
      const still = phys2D.createRigidBody({ type: 'static' });
      const motor = phys2D.createMotorConstraint({ bodyA: still, bodyB: a, rate: 2 });
      world.addConstraint(motor);
      // Shorter than the one before: of errors that were left only a part makes momentum, of which a motor has none.
      world.step(1 / 60);
      return world.hash();
    };
    expect(run(3)).toBe(run(0));
  });

  it('is not that there once was a constraint', () => {
    const world = phys2D.createWorld({ velocityIterations: 10, substeps: 3 });
    world.addRigidBody(phys2D.createRigidBody({ type: 'static', position: [0, 1], shapes: [box(60, 1)] }));
    const balls = [-8, -4, 0, 4, 8].map((x, i) => {
      const shapes = [phys2D.createCircleShape({ radius: 0.5, origin: [0.1 * i, 0] })];
      const ball = phys2D.createRigidBody({ position: [x, -0.1 * i], velocity: [i - 2, 0], shapes });
      world.addRigidBody(ball);
      return ball;
    });
    const rod = phys2D.createDistanceConstraint({ bodyA: balls[0]!, bodyB: balls[1]!, lowerBound: 4, upperBound: 4 });
    world.addConstraint(rod);
    world.step(1 / 60);
    world.removeConstraint(rod);
    const copy = deserialize(phys2D, serialize(world));
    for (let i = 0; i < 120; i += 1) {
      expect(copy.hash(), `step ${i}`).toBe(world.hash());
      world.step(1 / 60);
      copy.step(1 / 60);
    }
  });

  it('is not in which order things woke of which nobody was to be told', () => {
    const run = (rollsBack: boolean) => {
      const world = phys2D.createWorld();
      const told: string[] = [];
      const [a, b] = ['a', 'b'].map((name) => {
        const body = phys2D.createRigidBody({});
        body.addEventListener('wake', () => {
          told.push(name);
        });
        world.addRigidBody(body);
        return body;
      }) as [RigidBody, RigidBody];
      world.step(1 / 60);
      a.sleep();
      a.wake();
      if (rollsBack) {
        world.restore(world.snapshot());
      }
      b.sleep();
      b.setVelocity([1, 0]);
      a.sleep();
      a.setVelocity([1, 0]);
      const hash = world.hash();
      world.step(1 / 60);
      return { hash, told };
    };
    expect(run(false).told).toEqual(['b', 'a']);
    expect(run(true)).toEqual(run(false));
  });

  it('is not what another world does with an anchor that both use', () => {
    const scene = () => {
      const worlds = [phys2D.createWorld(), phys2D.createWorld()] as const;
      const anchor = phys2D.createRigidBody({ type: 'static' });
      const ropes = worlds.map((world) =>
        [0, 0.5].map((x) => {
          const body = phys2D.createRigidBody({ position: [x, 1], shapes: [disc(0.2)] });
          const rope = phys2D.createDistanceConstraint({ bodyA: anchor, bodyB: body, upperBound: 1 });
          world.addRigidBody(body);
          world.addConstraint(rope);
          return rope;
        }),
      );
      for (let i = 0; i < 10; i += 1) {
        worlds.forEach((world) => {
          world.step(1 / 60);
        });
      }
      return { one: worlds[0], other: worlds[1], rope: ropes[0]![0]! };
    };
    const restored = scene();
    const removed = scene();
    const before = restored.other.hash();
    restored.one.restore(restored.one.snapshot());
    removed.one.removeConstraint(removed.rope);
    expect(restored.other.hash()).toBe(before);
    expect(removed.other.hash()).toBe(before);
  });
});

/** Sets every number and every flag of an object to something else. */
function scramble(object: object): void {
  const fields = object as Record<string, unknown>;
  for (const [name, value] of Object.entries(fields)) {
    if (typeof value === 'number') {
      fields[name] = -3.7 * value + 0.9;
    } else if (typeof value === 'boolean') {
      fields[name] = !value;
    }
  }
}

/** Bullets and others in a room, between boards that fly about. */
function bustle(seed: number, speed: number): World {
  const random = generator(seed);
  const around = (most: number) => most * (2 * random() - 1);
  const world = phys2D.createWorld();
  const add = (params: RigidBodyParams) => world.addRigidBody(phys2D.createRigidBody(params));
  for (const [x, y, width, height] of [
    [0, 6, 24, 1],
    [0, -6, 24, 1],
    [-9, 0, 1, 14],
    [9, 0, 1, 14],
    [-3, 2, 4, 0.3],
    [4, 0, 3, 0.2],
  ] as const) {
    add({ type: 'static', position: [x, y], shapes: [box(width, height)] });
  }
  for (let i = 0; i < 3; i += 1) {
    const velocity: [number, number] = [around(speed / 2), around(speed / 2)];
    const position: [number, number] = [5 * i - 5, 2 * i - 2];
    add({ type: 'kinematic', position, velocity, angularVelocity: around(10), shapes: [box(3, 0.3)] });
  }
  for (let i = 0; i < 25; i += 1) {
    const size = 0.1 + 0.5 * random();
    const shape = random() < 0.4 ? disc(size / 2) : box(size, size * (0.2 + 0.8 * random()));
    add({
      bullet: random() < 0.6,
      position: [around(7), around(4)],
      velocity: [around(speed), around(speed)],
      angularVelocity: around(20),
      shapes: [shape],
    });
  }
  return world;
}

describe('what is used again', () => {
  it.each([20, 60, 150])('says nothing of what it was used for before, at %d m/s', (speed) => {
    for (let seed = 1; seed <= 10; seed += 1) {
      const [tidy, untidy] = [bustle(seed, speed), bustle(seed, speed)];
      for (let i = 0; i < 30; i += 1) {
        tidy.step(1 / 60);
        untidy.step(1 / 60);
        [...untidy.movers.all, ...untidy.movers.meetings.all].forEach(scramble);
        expect(untidy.hash(), `seed ${seed}, step ${i}`).toBe(tidy.hash());
      }
    }
  });
});

describe('queries', () => {
  it('of worlds of the same hash find the same in the same order', () => {
    const world = whirl();
    const apart = whirl(phys2D.createSweepAndPruneBroadphase());
    const asked = (on: World) => {
      const shapes: Shape[] = [];
      const bodies: RigidBody[] = [];
      const results: string[] = [];
      const ranks = new Map(on.rigidBodies.map((body, i) => [body, i]));
      const note = (count: number) =>
        results.push([...bodies.slice(0, count)].map((body) => ranks.get(body)).join(' '));
      on.shapeCircleQuery([0, 0], 9, shapes);
      results.push(shapes.map(({ owner }) => ranks.get(owner!)).join(' '));
      note(on.bodyCircleQuery([0, 0], 9, bodies));
      note(on.bodyRectangleQuery([-3, -3, 3, 5], bodies));
      note(on.bodyPointQuery([0, 5], bodies));
      return results;
    };
    for (let i = 0; i < 60; i += 1) {
      world.step(1 / 60);
      apart.step(1 / 60);
    }
    const found = asked(world);
    expect(found[0]!.split(' ').length).toBeGreaterThan(5);
    expect(asked(apart)).toEqual(found);
    expect(asked(deserialize(phys2D, serialize(world)))).toEqual(found);
    const snapshot = world.snapshot();
    for (let i = 0; i < 100; i += 1) {
      world.step(1 / 60);
    }
    world.restore(snapshot);
    expect(asked(world)).toEqual(found);
  });
});

describe('a constraint with a body of another world', () => {
  it('does not keep that awake', () => {
    const [one, other] = [phys2D.createWorld(), phys2D.createWorld({ gravity: [0, 0] })];
    const driver = phys2D.createRigidBody({ type: 'kinematic', velocity: [2, 0] });
    const idle = phys2D.createRigidBody({ position: [1, 0], shapes: [disc(0.5)] });
    one.addRigidBody(driver);
    other.addRigidBody(idle);
    for (let i = 0; i < 5; i += 1) {
      one.step(1 / 60);
    }
    one.addConstraint(phys2D.createAngleConstraint({ bodyA: driver, bodyB: idle, upperBound: 1 }));
    const before = other.hash();
    one.step(1 / 60);
    expect(other.hash()).toBe(before);
  });
});

describe('a constraint that does nothing', () => {
  it.each(['elsewhere', 'disabled'])('does not change how deep things get where they are fast: %s', (which) => {
    const run = (isTied: boolean) => {
      const [world, other] = [phys2D.createWorld({ gravity: [0, 0] }), phys2D.createWorld()];
      const wall = phys2D.createRigidBody({
        type: 'static',
        shapes: [phys2D.createPolygonShape({ vertices: phys2D.createRectangleVertices(0, -50, 0.3, 50) })],
      });
      const material = phys2D.createMaterial({ elasticity: 0.5 });
      const slat = phys2D.createRigidBody({
        shapes: [phys2D.createPolygonShape({ vertices: phys2D.createBoxVertices(0.4, 0.1), material })],
        position: [-3, 0],
        velocity: [86, 10],
        angularVelocity: 20,
      });
      const far = phys2D.createRigidBody({ position: [5, 30], shapes: [disc(0.1)] });
      world.addRigidBody(wall);
      world.addRigidBody(slat);
      if (isTied) {
        const owner = which === 'disabled' ? world : other;
        const disabled = which === 'disabled';
        owner.addRigidBody(far);
        owner.addConstraint(phys2D.createDistanceConstraint({ bodyA: wall, bodyB: far, upperBound: 1000, disabled }));
      }
      for (let i = 0; i < 6; i += 1) {
        world.step(1 / 60);
      }
      return slat.getPosition();
    };
    expect(run(true)).toEqual(run(false));
  });
});

describe('a world that is restored', () => {
  it('is consistent although what sleeps is another set', () => {
    const world = phys2D.createWorld();
    world.addRigidBody(phys2D.createRigidBody({ type: 'static', position: [0, 2], shapes: [box(20, 1)] }));
    const crate = phys2D.createRigidBody({ shapes: [box(1, 1)] });
    world.addRigidBody(crate);
    for (let i = 0; i < 30; i += 1) {
      world.step(1 / 60);
    }
    const snapshot = world.snapshot();
    for (let i = 0; i < 200; i += 1) {
      world.step(1 / 60);
    }
    expect(crate.sleeping).toBe(true);
    world.restore(snapshot);
    expect(crate.sleeping).toBe(false);
    validate(world);
  });

  it('lets go of an anchor that was added since', () => {
    const world = phys2D.createWorld();
    const anchor = phys2D.createRigidBody({ type: 'static', position: [0, -3] });
    const body = phys2D.createRigidBody({ shapes: [disc(0.5)] });
    world.addRigidBody(body);
    world.addConstraint(phys2D.createDistanceConstraint({ bodyA: anchor, bodyB: body, upperBound: 3 }));
    world.step(1 / 60);
    const snapshot = world.snapshot();
    const hash = world.hash();
    world.addRigidBody(anchor);
    world.step(1 / 60);
    world.restore(snapshot);
    expect(anchor.world).toBe(null);
    expect(world.hash()).toBe(hash);
    validate(world);
  });

  it('from a copy tells of the removed shape that is held that it was parted from', () => {
    const world = phys2D.createWorld({ gravity: [0, 0] });
    const [a, b] = [0, 0.8].map((x) => {
      const body = phys2D.createRigidBody({ position: [x, 0], shapes: [disc(0.5)] });
      world.addRigidBody(body);
      return body;
    }) as [RigidBody, RigidBody];
    const told: Shape[] = [];
    b.shapes[0]!.addEventListener('end', (_, other) => {
      told.push(other);
    });
    world.step(1 / 60);
    const shape = a.shapes[0]!;
    a.removeShape(shape);
    const hash = world.hash();
    const copy = world.snapshot().slice(0);
    world.restore(copy);
    expect(world.hash()).toBe(hash);
    world.restore(copy, [shape]);
    expect(world.hash()).toBe(hash);
    world.step(1 / 60);
    expect(told).toEqual([shape]);
  });
});
