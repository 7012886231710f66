import { describe, expect, it } from 'vitest';
import { type Constraint, phys2D, type RigidBody, type Vec2, type World } from '../../src/index.js';
import { add, box, disc, heavy, staticBody, steps, weightless } from '../conformance/setting.js';
import { generator as random } from '../scenes/mixed.js';

// Things of several bodies that welds hold together: they stand under loads as if they were one, and turn as one.

function dense(width: number, height: number, density: number) {
  const material = phys2D.createMaterial({ density, staticFriction: 0.7, dynamicFriction: 0.7 });
  return box(width, height, { material });
}

function free(params: Parameters<typeof phys2D.createRigidBody>[0]): RigidBody {
  return phys2D.createRigidBody({ linearDrag: 0, angularDrag: 0, ...params });
}

/** Welds a body to another one where a point of it is. */
function weld(world: World, bodyA: RigidBody, bodyB: RigidBody, point: Vec2): Constraint {
  const constraint = phys2D.createWeldConstraint({
    bodyA,
    bodyB,
    anchorA: bodyA.transformWorldPointToLocal(point),
    anchorB: bodyB.transformWorldPointToLocal(point),
    phase: bodyB.getRotation() - bodyA.getRotation(),
    ignoreInteractions: true,
  });
  world.addConstraint(constraint);
  return constraint;
}

/** N·m·s, about the origin. */
function angularMomentum(world: World): number {
  let sum = 0;
  for (const body of world.rigidBodies) {
    const [x, y] = body.getPosition();
    const [vx, vy] = body.getVelocity();
    sum += body.getMass() * (x * vy - y * vx) + body.getInertia() * body.getAngularVelocity();
  }
  return sum;
}

/** Lets a body turn with others about the origin. */
function turn(body: RigidBody, rate: number): RigidBody {
  const [x, y] = body.getPosition();
  body.setVelocity([-rate * y, rate * x]);
  body.setAngularVelocity(rate);
  return body;
}

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

describe('frames of welds that turn', () => {
  it.each([4, 6])('%d rods in a ring keep turning', (count) => {
    const world = weightless();
    const radius = 1 / Math.tan(Math.PI / count);
    const rods = Array.from({ length: count }, (_, i) => {
      const angle = (2 * Math.PI * i) / count;
      const position: Vec2 = [radius * Math.cos(angle), radius * Math.sin(angle)];
      return turn(free({ position, rotation: angle + Math.PI / 2, shapes: [box(2, 0.08, { mask: 0 })] }), 3);
    });
    add(world, ...rods);
    rods.forEach((rod, i) => {
      weld(world, rod, rods[(i + 1) % count]!, rod.transformLocalPointToWorld([1, 0]));
    });
    const before = angularMomentum(world);
    steps(world, 1800);
    const kept = angularMomentum(world) / before;
    console.log(`${count} rods in a ring, 30 s: angular momentum × ${kept.toFixed(4)}`);
    expect(Math.abs(kept - 1)).toBeLessThan(0.05);
  });

  it('a plate of 6 × 6 blocks', () => {
    const world = weightless();
    const blocks = Array.from({ length: 36 }, (_, i) => {
      const position: Vec2 = [0.5 * ((i % 6) - 2.5), 0.5 * (Math.floor(i / 6) - 2.5)];
      return turn(free({ position, shapes: [box(0.44, 0.44)] }), 3);
    });
    add(world, ...blocks);
    blocks.forEach((block, i) => {
      const [x, y] = block.getPosition();
      if (i % 6 < 5) weld(world, block, blocks[i + 1]!, [x + 0.25, y]);
      if (i < 30) weld(world, block, blocks[i + 6]!, [x, y + 0.25]);
    });
    const before = angularMomentum(world);
    steps(world, 1800);
    const [x, y] = blocks[0]!.getPosition();
    expect(Math.abs(angularMomentum(world) / before - 1)).toBeLessThan(0.05);
    expect(Math.abs(Math.hypot(x, y) - Math.hypot(1.25, 1.25))).toBeLessThan(0.01);
  });

  it.each([4, 12])('a wheel of %d spokes that a motor drives under gravity', (count) => {
    const world = heavy();
    const post = staticBody();
    const hub = free({ shapes: [disc(0.3, { mask: 0 })] });
    add(world, hub);
    world.addConstraint(phys2D.createPointConstraint({ bodyA: post, bodyB: hub }));
    world.addConstraint(phys2D.createMotorConstraint({ bodyA: post, bodyB: hub, rate: 2, maxForce: 3000 }));
    const length = 6 * Math.sin(Math.PI / count);
    const spokes: RigidBody[] = [];
    const rim: RigidBody[] = [];
    for (let i = 0; i < count; i += 1) {
      const angle = (2 * Math.PI * i) / count;
      const half = angle + Math.PI / count;
      const far = 3 * Math.cos(Math.PI / count);
      const middle: Vec2 = [1.5 * Math.cos(angle), 1.5 * Math.sin(angle)];
      const edge: Vec2 = [far * Math.cos(half), far * Math.sin(half)];
      spokes.push(turn(free({ position: middle, rotation: angle, shapes: [box(3, 0.08, { mask: 0 })] }), 2));
      rim.push(
        turn(free({ position: edge, rotation: half + Math.PI / 2, shapes: [box(length, 0.08, { mask: 0 })] }), 2),
      );
    }
    hub.setAngularVelocity(2);
    add(world, ...spokes, ...rim);
    spokes.forEach((spoke, i) => {
      weld(world, hub, spoke, [0, 0]);
      weld(world, spoke, rim[i]!, spoke.transformLocalPointToWorld([1.5, 0]));
    });
    spokes.forEach((spoke, i) => {
      weld(world, spoke, rim[(i + count - 1) % count]!, spoke.transformLocalPointToWorld([1.5, 0]));
    });
    let fastest = 0;
    for (let i = 0; i < 1500; i += 1) {
      steps(world, 1);
      fastest = Math.max(fastest, ...world.rigidBodies.map((body) => Math.hypot(...body.getVelocity())));
    }
    console.log(`wheel of ${count} spokes, 25 s: at most ${fastest.toFixed(2)} m/s, a rim goes 6`);
    expect(fastest).toBeLessThan(7);
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
      const [bodyA, bodyB] = [parts[i]!, parts[i + 1]!];
      const point: Vec2 = [i * length, 0];
      const anchorA = bodyA.transformWorldPointToLocal(point);
      world.addConstraint(
        phys2D.createPointConstraint({ bodyA, bodyB, anchorA, anchorB: bodyB.transformWorldPointToLocal(point) }),
      );
    }
    steps(world, 720);
    expect(world.liveDynamics.length).toBe(0);
  });
});
