import { describe, expect, it } from 'vitest';
import {
  type Constraint,
  type PointConstraint,
  phys2D,
  type RigidBody,
  type Vec2,
  type World,
} from '../../src/index.js';
import { add, box, disc, energyOf, heavy, kineticOf, staticBody, tie } from '../conformance/setting.js';
import { generator } from '../scenes/mixed.js';

// What hangs and swings without anything that drives it has no more energy than before; and what is joined while it is apart comes together without making any.

function point(bodyA: RigidBody, anchorA: Vec2, bodyB: RigidBody, anchorB: Vec2): Constraint {
  return phys2D.createPointConstraint({ bodyA, anchorA, bodyB, anchorB });
}

/** Links of a length below each other, turned by an angle, from the origin on. @returns them, the first one being what it hangs on. */
function hang(world: World, count: number, length: number, angle: number, free = false): RigidBody[] {
  const [sin, cos] = [Math.sin(angle), Math.cos(angle)];
  const bodies = [staticBody()];
  for (let i = 0; i < count; i += 1) {
    const along = (i + 0.5) * length;
    const body = phys2D.createRigidBody({
      shapes: [box(0.05, length, { mask: 0 })],
      position: [sin * along, cos * along],
      rotation: -angle,
      ...(free ? { linearDrag: 0, angularDrag: 0 } : {}),
    });
    add(world, body);
    tie(world, point(bodies[i]!, i === 0 ? [0, 0] : [0, length / 2], body, [0, -length / 2]));
    bodies.push(body);
  }
  return bodies;
}

function widestGap(world: World): number {
  return Math.max(
    ...world.constraints.map((constraint) => {
      const joint = constraint as PointConstraint;
      const [ax, ay] = joint.bodyA.transformLocalPointToWorld(joint.getAnchorA());
      const [bx, by] = joint.bodyB.transformLocalPointToWorld(joint.getAnchorB());
      return Math.hypot(ax - bx, ay - by);
    }),
  );
}

function fastest(world: World): number {
  return Math.max(...world.rigidBodies.map((body) => Math.hypot(...body.getVelocity())));
}

describe('a rope whose end is tied to a point that it reaches', () => {
  it.each([
    { links: 10, x: 2, rate: 60 },
    { links: 10, x: 2, rate: 144 },
    { links: 10, x: 4, rate: 60 },
    { links: 20, x: 8, rate: 60 },
    { links: 4, x: 1.5, rate: 60 },
  ])('$links links, $x m aside, steps of 1/$rate s', ({ links, x, rate }) => {
    const world = heavy();
    const last = hang(world, links, 0.5, 0).at(-1)!;
    for (let i = 0; i < rate; i += 1) world.step(1 / rate);
    tie(world, point(staticBody(), [x, 0], last, [0, 0.25]));
    let speed = 0;
    for (let i = 0; i < 5 * rate; i += 1) {
      world.step(1 / rate);
      speed = Math.max(speed, fastest(world));
      if (i === 8) expect(widestGap(world)).toBeLessThan(0.01);
    }
    // What its middle gains in falling is some metres.
    expect(speed).toBeLessThan(12);
  });
});

describe('a hinged bridge whose middle joint is off for a second', () => {
  it.each([30, 60, 144])('steps of 1/%i s', (rate) => {
    for (const slack of [0.3, 1]) {
      const world = heavy();
      const width = 5 - slack;
      const left = staticBody();
      let last = left;
      for (let i = 0; i <= 20; i += 1) {
        const isEnd = i === 20;
        const body = isEnd
          ? left
          : phys2D.createRigidBody({
              shapes: [box(0.5, 0.15, { mask: 0 })],
              position: [-width + ((i + 0.5) * width) / 10, 0],
            });
        if (!isEnd) add(world, body);
        tie(world, point(last, i === 0 ? [-width, 0] : [0.25, 0], body, isEnd ? [width, 0] : [-0.25, 0]));
        last = body;
      }
      for (let i = 0; i < 5 * rate; i += 1) world.step(1 / rate);
      const middle = world.constraints[10]!;
      middle.disable();
      for (let i = 0; i < rate; i += 1) world.step(1 / rate);
      middle.enable();
      let speed = 0;
      for (let i = 0; i < 3 * rate; i += 1) {
        world.step(1 / rate);
        speed = Math.max(speed, fastest(world));
      }
      expect(widestGap(world)).toBeLessThan(0.02);
      expect(speed).toBeLessThan(25);
    }
  });
});

describe('a thin rope of 3 m with a heavy load, which swings from 40°', () => {
  it.each([
    { links: 10, load: 100, rate: 60 },
    { links: 10, load: 200, rate: 60 },
    { links: 20, load: 100, rate: 60 },
    { links: 20, load: 250, rate: 144 },
    { links: 10, load: 1000, rate: 144 },
  ])('$links links, a load of $load of their masses, steps of 1/$rate s', ({ links, load, rate }) => {
    const world = heavy();
    const angle = 0.7;
    const last = hang(world, links, 3 / links, angle).at(-1)!;
    const mass = load * last.getMass();
    const position: Vec2 = [3 * Math.sin(angle), 3 * Math.cos(angle)];
    const ball = phys2D.createRigidBody({ shapes: [disc(0.2, { mask: 0 })], mass, position });
    add(world, ball);
    tie(world, point(last, [0, 1.5 / links], ball, [0, 0]));
    const start = energyOf(world);
    const swing = 10 * mass * 3 * (1 - Math.cos(angle));
    let gain = 0;
    for (let i = 0; i < 10 * rate; i += 1) {
      world.step(1 / rate);
      gain = Math.max(gain, energyOf(world) - start);
    }
    expect(gain).toBeLessThan(0.03 * swing);
    expect(widestGap(world)).toBeLessThan(0.01);
  });
});

describe('a ball that swings on a rope', () => {
  it.each([0.3, 1, 2])(
    'keeps its swing when the hook is moved up by %d m, as the rope is drawn up without momentum',
    (up) => {
      const world = heavy();
      const hook = phys2D.createRigidBody({ type: 'kinematic' });
      const free = { linearDrag: 0, angularDrag: 0 };
      add(world, hook);
      let last = hook;
      for (let i = 0; i < 6; i += 1) {
        const link = phys2D.createRigidBody({
          ...free,
          shapes: [box(0.3, 0.1, { mask: 0 })],
          position: [0.15 + 0.3 * i, 0],
        });
        add(world, link);
        tie(world, point(last, i === 0 ? [0, 0] : [0.15, 0], link, [-0.15, 0]));
        last = link;
      }
      const ball = phys2D.createRigidBody({
        ...free,
        shapes: [disc(0.1, { mask: 0 })],
        mass: 2,
        inertia: 0.01,
        position: [1.8, 0],
      });
      add(world, ball);
      tie(world, point(last, [0.15, 0], ball, [0, 0]));
      while (ball.getPosition()[0] > 0) {
        world.step(1 / 60);
      }
      hook.setPosition([0, -up]);
      let highest = Infinity;
      for (let i = 0; i < 300; i += 1) {
        world.step(1 / 60);
        highest = Math.min(highest, ball.getPosition()[1] + up);
      }
      expect(highest).toBeLessThan(0.12);
    },
  );
});

describe('a pendulum of several rods without drag, let go level', () => {
  it.each([3, 4, 5, 6, 8])('%i rods never have more energy than at first', (count) => {
    for (const rate of [30, 60, 120]) {
      const world = heavy();
      hang(world, count, 1, Math.PI / 2, true);
      const start = energyOf(world);
      const mass = world.rigidBodies[0]!.getMass();
      for (let i = 0; i < 100 * rate; i += 1) {
        world.step(1 / rate);
        if (i % rate === 0) {
          expect(energyOf(world) - start, `steps of 1/${rate} s, after ${i / rate} s`).toBeLessThan(
            0.02 * 5 * mass * count * count,
          );
        }
      }
    }
  });
});

it('a wrecking ball that its last link reaches into hangs still', () => {
  for (const rate of [60, 144]) {
    const world = heavy();
    const bodies = [staticBody()];
    for (let i = 0; i < 3; i += 1) {
      const link = phys2D.createRigidBody({ shapes: [box(0.1, 0.5)], position: [0, 0.25 + 0.5 * i] });
      add(world, link);
      const bodyA = bodies[i]!;
      const anchorA: Vec2 = i === 0 ? [0, 0] : [0, 0.25];
      tie(
        world,
        phys2D.createPointConstraint({ bodyA, anchorA, bodyB: link, anchorB: [0, -0.25], ignoreInteractions: true }),
      );
      bodies.push(link);
    }
    const material = phys2D.createMaterial({ density: 5 });
    const ball = phys2D.createRigidBody({ shapes: [disc(1, { material })], position: [0, 1.5] });
    add(world, ball);
    tie(
      world,
      phys2D.createPointConstraint({ bodyA: bodies[3]!, anchorA: [0, 0.25], bodyB: ball, ignoreInteractions: true }),
    );
    for (let i = 0; i < 20 * rate; i += 1) world.step(1 / rate);
    expect(fastest(world)).toBeLessThan(0.5);
  }
});

/** Boxes of 1 m in so many columns and rows, each welded to its neighbours, which it overlaps. */
function weldTogether(world: World, columns: number, rows: number, overlap: number, [left, top]: Vec2): RigidBody[] {
  const pitch = 1 - overlap;
  const modules = Array.from({ length: columns * rows }, (_, i) => {
    const position: Vec2 = [left + pitch * (i % columns), top + pitch * Math.floor(i / columns)];
    const free = { linearDrag: 0, angularDrag: 0 };
    return phys2D.createRigidBody({ shapes: [box(1, 1)], position, ...free });
  });
  add(world, ...modules);
  const weld = (a: number, b: number, half: Vec2) => {
    const ends = { bodyA: modules[a]!, bodyB: modules[b]!, anchorA: half, anchorB: [-half[0], -half[1]] } as const;
    tie(world, phys2D.createWeldConstraint(ends));
  };
  for (let i = 0; i < modules.length; i += 1) {
    if (i % columns > 0) weld(i - 1, i, [pitch / 2, 0]);
    if (i >= columns) weld(i - columns, i, [0, pitch / 2]);
  }
  return modules;
}

describe.each([0.005, 0.02, 0.05, 0.2])('modules that are welded while they overlap by %f m', (overlap) => {
  it.each([
    [2, 1],
    [5, 1],
    [3, 3],
  ])('%i × %i drift on with the energy that they were given', (columns, rows) => {
    const world = phys2D.createWorld({ gravity: [0, 0], allowSleeping: false });
    const [first] = weldTogether(world, columns, rows, overlap, [0, 0]);
    first!.setVelocity([0.1, 0]);
    const start = kineticOf(world);
    for (let i = 0; i < 600; i += 1) {
      world.step(1 / 60);
      expect(kineticOf(world)).toBeLessThanOrEqual(start);
    }
  });

  it('lie still on the ground, where something lies on them too', () => {
    const world = heavy();
    add(world, staticBody({ shapes: [box(60, 1)], position: [0, 0.5] }));
    const modules = weldTogether(world, 3, 3, overlap, [0, -2.6]);
    const crate = phys2D.createRigidBody({ shapes: [box(0.5, 0.5)], position: [1, -4] });
    add(world, crate);
    for (let i = 0; i < 600; i += 1) {
      world.step(1 / 60);
    }
    expect(kineticOf(world)).toBeLessThan(1e-6);
    expect(Math.abs(modules[4]!.getPosition()[0] - (1 - overlap))).toBeLessThan(0.05);
  });
});

/** J. The most that a world has more than at first, in so many seconds. */
function mostGained(world: World, seconds: number, dt = 1 / 60): number {
  const first = energyOf(world);
  let most = 0;
  for (let i = 0; i < seconds / dt; i += 1) {
    world.step(dt);
    most = Math.max(most, energyOf(world) - first);
  }
  return most;
}

const FREE = { linearDrag: 0, angularDrag: 0 };

describe('planks that stand as an arch between two points nearly as far apart as they are long', () => {
  it.each([
    { count: 3, length: 1, width: 2.9 },
    { count: 4, length: 3, width: 11.64 },
    { count: 4, length: 1, width: 3.6 },
  ])('$count of $length m over $width m, pushed over, gain less than a seventh of what they fall by', (made) => {
    const { count, length, width } = made;
    const world = phys2D.createWorld({ allowSleeping: false });
    const bank = staticBody();
    const half = Math.floor(count / 2);
    const angle = Math.acos((width - (count % 2) * length) / (2 * half * length));
    const planks: RigidBody[] = [];
    let [x, y] = [0, 0];
    for (let i = 0; i < count; i += 1) {
      const rotation = count % 2 === 1 && i === half ? 0 : i < half ? -angle : angle;
      const [dx, dy] = [length * Math.cos(rotation), length * Math.sin(rotation)];
      const shapes = [box(length, 0.2, { mask: 0 })];
      planks.push(phys2D.createRigidBody({ shapes, position: [x + dx / 2, y + dy / 2], rotation, ...FREE }));
      add(world, planks[i]!);
      tie(world, point(planks[i - 1] ?? bank, i === 0 ? [0, 0] : [length / 2, 0], planks[i]!, [-length / 2, 0]));
      [x, y] = [x + dx, y + dy];
    }
    tie(world, point(planks.at(-1)!, [length / 2, 0], bank, [x, y]));
    const fall = planks.reduce((sum, plank) => sum - 20 * plank.getMass() * plank.getPosition()[1], 0);
    planks[half]!.setVelocity([0.3, 0]);
    expect(mostGained(world, 60)).toBeLessThan(fall / 7);
  });
});

describe('what has a mass without the inertia that goes with it', () => {
  it.each([1 / 30, 1 / 60, 1 / 120])('a hinged bridge of planks of 2 kg, steps of %f s', (dt) => {
    const world = phys2D.createWorld({ allowSleeping: false });
    const bank = staticBody();
    let last = bank;
    for (let i = 0; i < 12; i += 1) {
      const plank = phys2D.createRigidBody({ shapes: [box(1, 0.15, { mask: 0 })], position: [0.5 + i, 0], mass: 2 });
      add(world, plank);
      tie(world, point(last, i === 0 ? [0, 0] : [0.5, 0], plank, [-0.5, 0]));
      last = plank;
    }
    tie(world, point(last, [0.5, 0], bank, [12, 0]));
    let most = 0;
    for (let i = 0; i < 20 / dt; i += 1) {
      world.step(dt);
      most = Math.max(most, fastest(world));
    }
    expect(most).toBeLessThan(6);
    expect(widestGap(world)).toBeLessThan(0.02);
  });

  it.each([
    [4, 0.2, 1 / 30, 1],
    [100, 1, 1 / 30, 1],
  ])('a crate of %f kg and %f m on a rope from its corner, steps of %f s in %i', (mass, size, dt, substeps) => {
    const world = phys2D.createWorld({ allowSleeping: false, substeps });
    const crate = phys2D.createRigidBody({ shapes: [box(size, size)], position: [2 * size, size], mass, ...FREE });
    add(world, crate);
    const anchorB: Vec2 = [-size / 2, -size / 2];
    const length = Math.hypot(1.5 * size, 0.5 * size);
    const bounds = { lowerBound: 0, upperBound: length };
    tie(
      world,
      phys2D.createDistanceConstraint({ bodyA: staticBody(), bodyB: crate, anchorA: [0, 0], anchorB, ...bounds }),
    );
    expect(mostGained(world, 20, dt)).toBeLessThan(6 * mass * 10 * size);
  });
});

it.each([
  [0.01, 4],
  [0.1, 1],
])('a pulley whose load of %f of the other comes up to its wheel, in %i sub-steps', (load, substeps) => {
  const world = phys2D.createWorld({ allowSleeping: false, substeps });
  const heavySide = phys2D.createRigidBody({
    shapes: [box(0.3, 0.3, { mask: 0 })],
    position: [1, 3],
    mass: 1,
    ...FREE,
  });
  const light = phys2D.createRigidBody({
    shapes: [box(0.3, 0.3, { mask: 0 })],
    position: [-1, 3],
    mass: load,
    ...FREE,
  });
  add(world, heavySide, light);
  const wheels = staticBody();
  tie(
    world,
    phys2D.createPulleyConstraint({
      bodyA: wheels,
      bodyB: light,
      bodyC: wheels,
      bodyD: heavySide,
      anchorA: [-1, 0],
      anchorC: [1, 0],
      lowerBound: 6,
      upperBound: 6,
    }),
  );
  expect(mostGained(world, 10)).toBeLessThan(10);
});

describe('springs that are hard for the sub-steps', () => {
  it.each([
    { count: 2, frequency: 20, dt: 1 / 60, substeps: 1 },
    { count: 3, frequency: 60, dt: 1 / 30, substeps: 4 },
    { count: 10, frequency: 120, dt: 1 / 60, substeps: 4 },
  ])('$count welds of $frequency Hz, $dt s in $substeps', ({ count, frequency, dt, substeps }) => {
    const world = phys2D.createWorld({ allowSleeping: false, substeps });
    let last = staticBody();
    for (let i = 0; i < count; i += 1) {
      const part = phys2D.createRigidBody({ shapes: [box(1, 0.5, { mask: 0 })], position: [1 + i, 0], ...FREE });
      add(world, part);
      const anchors = { anchorA: [0.5, 0], anchorB: [-0.5, 0] } as const;
      tie(
        world,
        phys2D.createWeldConstraint({ bodyA: last, bodyB: part, ...anchors, stiff: false, frequency, damping: 0.3 }),
      );
      last = part;
    }
    last.setVelocity([0, 1]);
    expect(mostGained(world, 10, dt)).toBeLessThan(0.5);
  });
});

describe('what swings on something that stands on the ground', () => {
  it('a bar on a heavy tower comes up as high after a minute', () => {
    const world = phys2D.createWorld({ allowSleeping: false });
    add(world, staticBody({ shapes: [box(40, 2)], position: [0, 1] }));
    const tower = phys2D.createRigidBody({
      shapes: [box(6, 3, { material: phys2D.createMaterial({ density: 30 }), group: 2, mask: 1 })],
      position: [0, -1.5],
    });
    const bar = phys2D.createRigidBody({
      shapes: [box(0.2, 2, { mask: 0 })],
      position: [1, -3],
      rotation: -Math.PI / 2,
      ...FREE,
    });
    add(world, tower, bar);
    tie(world, point(tower, [0, -1.5], bar, [0, -1]));
    let highest = 0;
    for (let i = 0; i < 3600; i += 1) {
      world.step(1 / 60);
      if (i >= 3300) highest = Math.min(highest, bar.getPosition()[1] + 2);
    }
    // Of 1 m at first.
    expect(-highest).toBeGreaterThan(0.99);
  });

  it('an unbalanced wheel in a heavy frame keeps its energy', () => {
    const world = phys2D.createWorld({ allowSleeping: false });
    add(world, staticBody({ shapes: [box(40, 2)], position: [0, 1] }));
    const frame = phys2D.createRigidBody({
      shapes: [box(8, 3, { material: phys2D.createMaterial({ density: 100 }), group: 2, mask: 1 })],
      position: [0, -1.5],
    });
    const wheel = phys2D.createRigidBody({
      shapes: [box(1, 0.2, { mask: 0 })],
      position: [0.5, -3],
      velocity: [0, 5],
      angularVelocity: 10,
      ...FREE,
    });
    add(world, frame, wheel);
    tie(world, point(frame, [0, -1.5], wheel, [-0.5, 0]));
    // The frame is so heavy that what it sinks by counts for more.
    const energy = (): number => {
      const [vx, vy] = wheel.getVelocity();
      const w = wheel.getAngularVelocity();
      const m = wheel.getMass();
      return 0.5 * m * (vx * vx + vy * vy) + 0.5 * wheel.getInertia() * w * w - 10 * m * (wheel.getPosition()[1] + 3);
    };
    const first = energy();
    for (let i = 0; i < 600; i += 1) {
      world.step(1 / 60);
    }
    expect(Math.abs(energy() / first - 1)).toBeLessThan(0.02);
  });
});

it.each([
  [5.5, 45],
  [6, 75],
])('a chain of 5 m whose ends were pulled %f m apart and let go cracks with %i m/s at most', (far, most) => {
  const world = heavy();
  const wall = staticBody();
  const hand = phys2D.createRigidBody({ type: 'kinematic', position: [5, 0] });
  add(world, wall, hand);
  const links = Array.from({ length: 10 }, (_, i) =>
    phys2D.createRigidBody({ shapes: [box(0.5, 0.1)], position: [0.5 * i + 0.25, 0] }),
  );
  add(world, ...links);
  for (let i = 0; i <= 10; i += 1) {
    const bodyA = links[i - 1] ?? wall;
    const bodyB = links[i] ?? hand;
    const anchors = { anchorA: [i > 0 ? 0.25 : 0, 0] as Vec2, anchorB: [i < 10 ? -0.25 : 0, 0] as Vec2 };
    tie(world, phys2D.createPointConstraint({ bodyA, bodyB, ...anchors, ignoreInteractions: true }));
  }
  const fastestOf = (steps: number) => {
    let speed = 0;
    for (let i = 0; i < steps; i += 1) {
      world.step(1 / 60);
      speed = Math.max(speed, ...links.map((link) => Math.hypot(...link.getVelocity())));
    }
    return speed;
  };
  hand.setVelocity([0.5, 0]);
  fastestOf(Math.round((far - 5) * 120));
  hand.setVelocity([0, 0]);
  expect(fastestOf(240)).toBeLessThan(5);
  world.removeRigidBody(hand);
  expect(fastestOf(60)).toBeLessThan(most);
});

describe('what lies on a hinged bridge', () => {
  /** Planks of 1 m between two banks, as long together as `slack` times the way, straightened by springs of a frequency, if any. @returns its planks. */
  function bridge(world: World, count: number, slack: number, frequency = 0): RigidBody[] {
    const material = phys2D.createMaterial({ staticFriction: 1, dynamicFriction: 1 });
    const banks = phys2D.createRigidBody({ type: 'static' });
    add(world, banks);
    const planks = Array.from({ length: count }, (_, i) => {
      const plank = phys2D.createRigidBody({ shapes: [box(1, 0.2, { material })], position: [(i + 0.5) / slack, 0] });
      add(world, plank);
      return plank;
    });
    for (let i = 0; i <= count; i += 1) {
      const bodyA = planks[i - 1] ?? banks;
      const bodyB = planks[i] ?? banks;
      const anchorA: Vec2 = i > 0 ? [0.5, 0] : [0, 0];
      const anchorB: Vec2 = i < count ? [-0.5, 0] : [count / slack, 0];
      tie(world, phys2D.createPointConstraint({ bodyA, bodyB, anchorA, anchorB, ignoreInteractions: true }));
      if (frequency > 0) {
        tie(world, phys2D.createAngleConstraint({ bodyA, bodyB, stiff: false, frequency, damping: 0.5 }));
      }
    }
    for (let i = 0; i < 120; i += 1) {
      world.step(1 / 60);
    }
    return planks;
  }

  function secondsToRest(world: World, most: number): number {
    for (let i = 0; i < most * 60; i += 1) {
      if (world.liveDynamics.length === 0) {
        return i / 60;
      }
      world.step(1 / 60);
    }
    return Infinity;
  }

  /** Rough, of so many kg/m². */
  const rough = (density: number) => phys2D.createMaterial({ staticFriction: 1, dynamicFriction: 1, density });

  /** Until a bridge rests, 40 s at most, on whose middle a crate of `ratio` times a plank is put. */
  function secondsUnderCrate(count: number, slack: number, ratio: number, frequency = 0): number {
    const world = heavy();
    const planks = bridge(world, count, slack, frequency);
    const y = planks[count / 2]!.getPosition()[1] - 0.55;
    const crate = box(0.8, 0.8, { material: rough((0.2 * ratio) / 0.64) });
    add(world, phys2D.createRigidBody({ shapes: [crate], position: [count / slack / 2, y] }));
    return secondsToRest(world, 40);
  }

  it.each([
    [8, 1, 20],
    [8, 1.01, 5],
    [8, 1.01, 20],
    [8, 1.05, 50],
    [16, 1, 5],
    [16, 1.01, 20],
    [16, 1.01, 50],
    [16, 1.05, 20],
  ])('comes to rest within 40 s: %i planks, %f of the way, a crate of %i times a plank', (count, slack, ratio) => {
    expect(secondsUnderCrate(count, slack, ratio)).toBeLessThan(40);
  });

  it('comes to rest within 20 s without slack, too, 27 of 30', () => {
    let restless = 0;
    for (const count of [8, 12]) {
      for (const slack of [1, 1.001, 1.002]) {
        for (const ratio of [16, 18, 20, 22, 24]) {
          restless += secondsUnderCrate(count, slack, ratio) > 20 ? 1 : 0;
        }
      }
    }
    console.log(`bridges without slack under crates: ${restless} of 30 do not rest`);
    expect(restless).toBeLessThanOrEqual(3);
  });

  it.each([
    [8, 1, 2, 20],
    [8, 1.01, 15, 50],
    [12, 1, 15, 10],
    [12, 1, 30, 10],
    [12, 1.01, 15, 10],
    [12, 1.01, 2, 20],
    [16, 1, 15, 10],
    [16, 1.01, 30, 50],
  ])(
    'springs at all joints: %i planks, %f of the way, %i Hz, a crate of %i times a plank',
    (count, slack, frequency, ratio) => {
      expect(secondsUnderCrate(count, slack, ratio, frequency)).toBeLessThan(40);
    },
  );

  it('comes to rest where it is a cart whose wheels are braked', () => {
    const world = heavy();
    const planks = bridge(world, 16, 1.02);
    const top = planks[8]!.getPosition()[1] - 0.1;
    const middle = 8 / 1.02;
    const chassis = phys2D.createRigidBody({
      shapes: [box(2.4, 0.5, { material: rough(1.7) })],
      position: [middle, top - 0.8],
    });
    add(world, chassis);
    for (const side of [-0.8, 0.8]) {
      const tyre = phys2D.createCircleShape({ radius: 0.35, material: rough(1.3) });
      const wheel = phys2D.createRigidBody({ shapes: [tyre], position: [middle + side, top - 0.36] });
      add(world, wheel);
      const bodies = { bodyA: chassis, bodyB: wheel };
      tie(world, phys2D.createPointConstraint({ ...bodies, anchorA: [side, 0.44], ignoreInteractions: true }));
      tie(world, phys2D.createMotorConstraint({ ...bodies, maxForce: 30 }));
    }
    expect(secondsToRest(world, 60)).toBeLessThan(60);
  });

  it('on two ropes, a seat of a swing with a child of 200 times a link, hangs still', () => {
    const world = heavy();
    const beam = phys2D.createRigidBody({ type: 'static' });
    const seat = phys2D.createRigidBody({ shapes: [box(0.6, 0.1, { material: rough(8) })], position: [0, 3] });
    add(world, beam, seat);
    for (const side of [-0.25, 0.25]) {
      let last = beam;
      for (let i = 0; i <= 12; i += 1) {
        const next =
          i === 12
            ? seat
            : phys2D.createRigidBody({
                shapes: [box(0.05, 0.25, { material: rough(2) })],
                position: [side, 0.25 * (i + 0.5)],
              });
        if (i < 12) add(world, next);
        const anchorA: Vec2 = i === 0 ? [side, 0] : [0, 0.125];
        const anchorB: Vec2 = i === 12 ? [side, 0] : [0, -0.125];
        const ends = { bodyA: last, bodyB: next, anchorA, anchorB };
        tie(world, phys2D.createPointConstraint({ ...ends, ignoreInteractions: true }));
        last = next;
      }
    }
    const child = box(0.4, 0.6, { material: rough(20), group: 2, mask: 2 });
    seat.shapes[0]!.setGroup(2);
    seat.shapes[0]!.setMask(2);
    add(world, phys2D.createRigidBody({ shapes: [child], position: [0, 2.645] }));
    let farthest = 0;
    for (let i = 0; i < 1800; i += 1) {
      world.step(1 / 60);
      farthest = Math.max(farthest, Math.abs(seat.getPosition()[0]));
    }
    expect(farthest).toBeLessThan(0.02);
    expect(secondsToRest(world, 20)).toBeLessThan(20);
  });
});

describe('a plank that hangs by a spring on a crank that turns freely', () => {
  /** J. The most that there is more than at rest, as it begins, within 12 s: the spring is not tight then. Both weigh 80 N, so that 10 J in one sub-step are what rigid joints may make. */
  function gainOf(spring: (bodyA: RigidBody, bodyB: RigidBody) => Constraint, substeps: number): number {
    const world = phys2D.createWorld({ gravity: [0, 10], substeps, allowSleeping: false });
    const arm = (mass: number, length: number, rotation: number, [x, y]: Vec2, middle: number) => {
      const shapes = [box(length, 0.2, { mask: 0 })];
      const inertia = (mass * (length * length + 0.04)) / 12;
      const position: Vec2 = [x + middle * Math.cos(rotation), y + middle * Math.sin(rotation)];
      return phys2D.createRigidBody({ shapes, mass, inertia, rotation, position });
    };
    const crank = arm(2, 0.8, 3.1, [0, 0], 0.4);
    const plank = arm(6, 0.9, 2.7, crank.transformLocalPointToWorld([0.4, 0.2]), 0.3);
    add(world, crank, plank);
    tie(world, point(staticBody(), [0, 0], crank, [-0.4, 0]), spring(crank, plank));
    const before = energyOf(world);
    let most = 0;
    for (let i = 0; i < 720; i += 1) {
      world.step(1 / 60);
      most = Math.max(most, energyOf(world) - before);
    }
    return most;
  }

  const soft = { stiff: false, damping: 0.1, anchorA: [0.4, 0.2], anchorB: [-0.3, 0] } as const;
  const springs: Record<string, (bodyA: RigidBody, bodyB: RigidBody, frequency: number) => Constraint> = {
    point: (bodyA, bodyB, frequency) => phys2D.createPointConstraint({ bodyA, bodyB, frequency, ...soft }),
    weld: (bodyA, bodyB, frequency) => phys2D.createWeldConstraint({ bodyA, bodyB, frequency, phase: -0.4, ...soft }),
    distance: (bodyA, bodyB, frequency) => {
      const [ax, ay] = bodyA.transformLocalPointToWorld([-0.4, 0.8]);
      const [bx, by] = bodyB.transformLocalPointToWorld([-0.3, 0]);
      const length = Math.hypot(bx - ax, by - ay);
      const bounds = { lowerBound: length, upperBound: length };
      return phys2D.createDistanceConstraint({ bodyA, bodyB, frequency, ...soft, anchorA: [-0.4, 0.8], ...bounds });
    },
    line: (bodyA, bodyB, frequency) =>
      phys2D.createLineConstraint({ bodyA, bodyB, frequency, ...soft, axis: [1, 1], lowerBound: 0, upperBound: 0 }),
  };

  it.each(Object.keys(springs))('is given no energy: %s', (name) => {
    for (const frequency of [1, 2, 5]) {
      for (const substeps of [1, 4, 8]) {
        const gain = gainOf((bodyA, bodyB) => springs[name]!(bodyA, bodyB, frequency), substeps);
        expect(gain, `${frequency} Hz, ${substeps} sub-steps`).toBeLessThan(substeps > 1 ? 2 : 10);
      }
    }
  });
});

it('pendulums of three rods from level on, of 1 to 10 kg each, do not gain a tenth of what they fall by within 20 s', () => {
  const gains = Array.from({ length: 40 }, (_, seed) => {
    const random = generator(seed + 1);
    const world = heavy({ gravity: [0, 10], allowSleeping: false });
    let before = staticBody();
    for (let i = 0; i < 3; i += 1) {
      const mass = 10 ** random();
      const body = phys2D.createRigidBody({
        mass,
        inertia: mass / 12,
        position: [i + 0.5, 0],
        linearDrag: 0,
        angularDrag: 0,
      });
      add(world, body);
      tie(world, point(before, i === 0 ? [0, 0] : [0.5, 0], body, [-0.5, 0]));
      before = body;
    }
    const fall = world.rigidBodies.reduce((sum, body) => sum + 10 * body.getMass(), 0);
    const start = energyOf(world);
    let most = 0;
    for (let i = 0; i < 1200; i += 1) {
      world.step(1 / 60);
      most = Math.max(most, energyOf(world) - start);
    }
    return most / fall;
  });
  expect(Math.max(...gains)).toBeLessThan(0.1);
});
