import { describe, expect, it } from 'vitest';
import { phys2D, type RigidBody, type Vec2, type World } from '../../src/index.js';
import { add, box, heavy, pinAt, staticBody, steps, weightless } from '../conformance/setting.js';
import { generator as random } from '../scenes/mixed.js';
import { dense, free, turn, weld } from './welded.js';

// Things of several bodies that welds hold together: they stand under loads as if they were one.

describe('a table of a top and two legs', () => {
  type Load = readonly [x: number, level: number, mass: number];
  const tables: readonly [string, boolean, readonly Load[]][] = [
    ['a box of ten times its weight', true, [[-0.2, 0, 20]]],
    [
      'two of them on each other',
      true,
      [
        [-0.3, 0, 20],
        [-0.3, 1, 20],
      ],
    ],
    [
      'two boxes side by side, one leg on a hinge',
      false,
      [
        [-0.3, 0, 10],
        [0.3, 0, 2.5],
      ],
    ],
    [
      'two stacks, one leg on a hinge',
      false,
      [
        [-0.3101, 0, 0.83],
        [0.3627, 0, 10.5],
        [-0.3647, 1, 11.8],
        [0.3328, 1, 0.645],
      ],
    ],
  ];

  it.each(tables)('bears %s, and rests', (_name, isWelded, loads) => {
    const world = heavy();
    add(world, staticBody({ position: [0, 0.5], shapes: [dense(30, 1, 1)] }));
    const top = free({ position: [0, -1.1], shapes: [dense(3, 0.2, 2)] });
    const legs = [-1.2, 1.2].map((x) => free({ position: [x, -0.5], shapes: [dense(0.2, 1, 2)] }));
    const boxes = loads.map(([x, level, mass]) =>
      free({ position: [x, -1.45 - 0.5 * level], shapes: [dense(0.5, 0.5, 4 * mass)] }),
    );
    add(world, top, ...legs, ...boxes);
    weld(world, top, legs[1]!, [1.2, -1]);
    if (isWelded) {
      weld(world, top, legs[0]!, [-1.2, -1]);
    } else {
      const hinge = { bodyA: top, bodyB: legs[0]!, ignoreInteractions: true };
      world.addConstraint(phys2D.createPointConstraint({ ...hinge, anchorA: [-1.2, 0.1], anchorB: [0, -0.5] }));
      world.addConstraint(phys2D.createAngleConstraint({ ...hinge, lowerBound: -0.02, upperBound: 0.02 }));
    }
    steps(world, 240);
    const places = boxes.map((body) => body.getPosition());
    expect(world.liveDynamics.length).toBe(0);
    boxes.forEach((body, i) => {
      const [x, y] = places[i]!;
      expect(Math.abs(x - loads[i]![0])).toBeLessThan(0.02);
      expect(Math.abs(y + 1.45 + 0.5 * loads[i]![1])).toBeLessThan(0.02);
      expect(body.sleeping).toBe(true);
    });
  });
});

describe('towers of frames', () => {
  /** A rod between two points. */
  function bar(world: World, from: Vec2, to: Vec2): RigidBody {
    const [x, y] = [to[0] - from[0], to[1] - from[1]];
    const rod = phys2D.createRigidBody({
      position: [(from[0] + to[0]) / 2, (from[1] + to[1]) / 2],
      rotation: Math.atan2(y, x),
      shapes: [box(Math.hypot(x, y), 0.1)],
    });
    add(world, rod);
    return rod;
  }

  it.each([5, 8, 10])('%d tables on each other stand, and rest', (count) => {
    const world = heavy();
    add(world, staticBody({ position: [0, 0.5], shapes: [box(30, 1)] }));
    for (let i = 0; i < count; i += 1) {
      const foot = -1.55 * i;
      const top = bar(world, [-1, foot - 1.5], [1, foot - 1.5]);
      for (const x of [-0.9, 0.9]) {
        weld(world, top, bar(world, [x, foot - 1.45], [x, foot]), [x, foot - 1.45]);
      }
    }
    const tops = world.rigidBodies.slice(1).map((body) => body.getPosition());
    steps(world, 600);
    world.rigidBodies.slice(1).forEach((body, i) => {
      const [x, y] = body.getPosition();
      expect(Math.hypot(x - tops[i]![0], y - tops[i]![1])).toBeLessThan(0.1);
    });
    expect(world.liveDynamics.length).toBe(0);
  });

  it('five squares on each other', () => {
    const world = heavy();
    add(world, staticBody({ position: [0, 0.5], shapes: [box(30, 1)] }));
    for (let i = 0; i < 5; i += 1) {
      const foot = -1.1 * i;
      const low = bar(world, [-0.5, foot - 0.05], [0.5, foot - 0.05]);
      const high = bar(world, [-0.5, foot - 1.05], [0.5, foot - 1.05]);
      for (const x of [-0.45, 0.45]) {
        const side = bar(world, [x, foot - 0.1], [x, foot - 1]);
        weld(world, low, side, [x, foot - 0.1]);
        weld(world, high, side, [x, foot - 1]);
      }
    }
    const places = world.rigidBodies.slice(1).map((body) => body.getPosition());
    steps(world, 600);
    world.rigidBodies.slice(1).forEach((body, i) => {
      const [x, y] = body.getPosition();
      expect(Math.hypot(x - places[i]![0], y - places[i]![1])).toBeLessThan(0.1);
    });
  });
});

it('a plate of welded blocks that a box hits keeps its momentum', () => {
  for (let seed = 1; seed <= 40; seed += 1) {
    const next = random(seed);
    const world = weightless();
    const blocks = Array.from({ length: 16 }, (_, i) => {
      const position: Vec2 = [0.5 * (i % 4), 0.5 * Math.floor(i / 4) - 1];
      return turn(free({ position, shapes: [dense(0.5, 0.5, 10 ** (2 * next() - 1))] }), 4 * next() - 2);
    });
    add(world, ...blocks);
    blocks.forEach((block, i) => {
      const [x, y] = block.getPosition();
      if (i % 4 < 3) weld(world, block, blocks[i + 1]!, [x + 0.25, y]);
      if (i < 12 && i % 3 === 0) weld(world, block, blocks[i + 4]!, [x, y + 0.25]);
    });
    const shot = free({ position: [-6, next() - 0.5], velocity: [20, 0], shapes: [dense(0.6, 0.5, 20)] });
    add(world, shot);
    const momentum = () =>
      world.rigidBodies.reduce(
        ([x, y], body): Vec2 => {
          const [vx, vy] = body.getVelocity();
          return [x + body.getMass() * vx, y + body.getMass() * vy];
        },
        [0, 0] as Vec2,
      );
    const [x, y] = momentum();
    steps(world, 90);
    const [nextX, nextY] = momentum();
    expect(Math.hypot(nextX - x, nextY - y), `ship ${seed}`).toBeLessThan(1e-4);
  }
});

describe('a hinged bridge under a box', () => {
  it.each([
    [4, 0.8, 0.2, 24, 0.9],
    [3, 0.99, 0.14, 6.2, 0.75],
  ])('of %d planks of %f × %f m comes to rest under %f kg', (count, length, height, mass, size) => {
    const world = heavy();
    const banks = [-1, count * length + 1].map((x) => staticBody({ position: [x, 0], shapes: [dense(2, 0.3, 1)] }));
    const planks = Array.from({ length: count }, (_, i) =>
      free({ position: [(i + 0.5) * length, 0], shapes: [dense(length, height, 2)] }),
    );
    const load = free({
      position: [0.5 * count * length, -0.5 * (height + size) - 0.3],
      shapes: [dense(size, size, mass / size ** 2)],
    });
    add(world, ...banks, ...planks, load);
    const parts = [banks[0]!, ...planks, banks[1]!];
    for (let i = 0; i <= count; i += 1) {
      pinAt(world, parts[i]!, parts[i + 1]!, [i * length, 0], false);
    }
    steps(world, 720);
    expect(world.liveDynamics.length).toBe(0);
  });
});
