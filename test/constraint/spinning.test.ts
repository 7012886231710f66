import { describe, expect, it } from 'vitest';
import { phys2D, type RigidBody, type Vec2, type World } from '../../src/index.js';
import { add, box, disc, heavy, kineticOf, pin, staticBody, steps, weightless } from '../conformance/setting.js';
import { generator as random } from '../scenes/mixed.js';
import { angularMomentum, free, turn, weld } from './welded.js';

// Things of several bodies that turn as one, and go on with it where nothing stops them.

/** Square blocks in a grid, which are welded to their neighbours and turn about the origin. */
function plate(
  world: World,
  columns: number,
  rows: number,
  rate: number,
  { pitch = 1, size = 1, ignores = true },
): RigidBody[] {
  const blocks = Array.from({ length: columns * rows }, (_, i) => {
    const x = (i % columns) - (columns - 1) / 2;
    const y = Math.floor(i / columns) - (rows - 1) / 2;
    return turn(free({ position: [pitch * x, pitch * y], shapes: [box(size, size)] }), rate);
  });
  add(world, ...blocks);
  blocks.forEach((block, i) => {
    const [x, y] = block.getPosition();
    if (i % columns < columns - 1) weld(world, block, blocks[i + 1]!, [x + pitch / 2, y], ignores);
    if (i < columns * (rows - 1)) weld(world, block, blocks[i + columns]!, [x, y + pitch / 2], ignores);
  });
  return blocks;
}

describe('frames', () => {
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

  const holdings = {
    welds: (world, a, b, at) => weld(world, a, b, at),
    'two pins': (world, a, b, [x, y]) => {
      for (const at of [[x, y] as const, [0.95 * x, 0.95 * y] as const]) {
        pin(world, a, a.transformWorldPointToLocal(at), b, b.transformWorldPointToLocal(at));
      }
    },
    'pins and angles': (world, a, b, at) => {
      pin(world, a, a.transformWorldPointToLocal(at), b, b.transformWorldPointToLocal(at));
      const bound = b.getRotation() - a.getRotation();
      world.addConstraint(phys2D.createAngleConstraint({ bodyA: a, bodyB: b, lowerBound: bound, upperBound: bound }));
    },
  } satisfies Record<string, (world: World, a: RigidBody, b: RigidBody, at: Vec2) => void>;

  it.each([
    ['welds', 4, 30, 8, 0.04],
    ['welds', 4, 60, 8, 0.02],
    ['two pins', 4, 60, 3, 0.06],
    ['two pins', 6, 60, 8, 0.3],
    ['two pins', 9, 60, 0.1, 0.001],
    ['two pins', 16, 60, 3, 0.06],
    ['pins and angles', 4, 60, 3, 0.06],
    ['pins and angles', 12, 60, 1, 0.01],
  ] as const)(
    'held by %s, %d rods in a ring at %d steps a second turn on at %f rad/s',
    (kind, count, rate, spin, most) => {
      const world = weightless();
      const radius = 2 * Math.cos(Math.PI / count);
      const rods = Array.from({ length: count }, (_, i) => {
        const angle = (2 * Math.PI * (i + 0.5)) / count;
        const position: Vec2 = [radius * Math.cos(angle), radius * Math.sin(angle)];
        const length = 3.6 * Math.sin(Math.PI / count);
        return turn(free({ position, rotation: angle + Math.PI / 2, shapes: [box(length, 0.2, { mask: 0 })] }), spin);
      });
      add(world, ...rods);
      rods.forEach((rod, i) => {
        const angle = (2 * Math.PI * (i + 1)) / count;
        holdings[kind](world, rod, rods[(i + 1) % count]!, [2 * Math.cos(angle), 2 * Math.sin(angle)]);
      });
      const before = [kineticOf(world), angularMomentum(world)];
      for (let i = 0; i < 60 * rate; i += 1) world.step(1 / rate);
      const kept = [kineticOf(world) / before[0]!, angularMomentum(world) / before[1]!];
      const what = `${count} rods held by ${kind}, a minute at ${rate} steps a second and ${spin} rad/s`;
      console.log(`${what}: energy and angular momentum × ${kept.map((share) => share.toFixed(4))}`);
      for (const share of kept) expect(Math.abs(share - 1)).toBeLessThan(most);
    },
  );

  it.each([3, 8])('a bar of %d welded blocks', (count) => {
    const world = weightless();
    const blocks = plate(world, count, 1, 8, { size: 0.9 });
    const before = kineticOf(world);
    for (let i = 0; i < 900; i += 1) world.step(1 / 30);
    expect(blocks).toHaveLength(count);
    expect(kineticOf(world) / before).toBeGreaterThan(0.95);
    expect(kineticOf(world) / before).toBeLessThan(1);
  });

  it('a plate of 6 × 6 blocks', () => {
    const world = weightless();
    const blocks = plate(world, 6, 6, 3, { pitch: 0.5, size: 0.44 });
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

describe.each([0.3, 0.4, 1])('what touches and turns by %d rad a step gains nothing', (angle) => {
  it.each([30, 60])('a plate of 3 × 1 welded blocks, at %d steps a second', (rate) => {
    const world = weightless();
    const blocks = plate(world, 3, 1, angle * rate, { ignores: false });
    expectNoGain(world, rate);
    expect(blocks[0]!.getAngularVelocity()).toBeGreaterThan(0.75 * angle * rate);
  });

  it('three welded discs', () => {
    const world = weightless();
    const discs = [-1, 0, 1].map((x) => turn(free({ position: [x, 0], shapes: [disc(0.5)] }), 60 * angle));
    add(world, ...discs);
    weld(world, discs[0]!, discs[1]!, [-0.5, 0], false);
    weld(world, discs[1]!, discs[2]!, [0.5, 0], false);
    expectNoGain(world, 60);
  });

  it('a net of 4 × 4 discs', () => {
    const world = weightless();
    const discs = Array.from({ length: 16 }, (_, i) =>
      turn(free({ position: [(i % 4) - 1.5, Math.floor(i / 4) - 1.5], shapes: [disc(0.5)] }), 60 * angle),
    );
    add(world, ...discs);
    discs.forEach((one, i) => {
      if (i % 4 < 3) pin(world, one, [0.5, 0], discs[i + 1]!, [-0.5, 0], false);
      if (i < 12) pin(world, one, [0, 0.5], discs[i + 4]!, [0, -0.5], false);
    });
    expectNoGain(world, 60);
  });

  function expectNoGain(world: World, rate: number): void {
    const before = kineticOf(world);
    for (let i = 0; i < 300; i += 1) {
      world.step(1 / rate);
      expect(kineticOf(world) / before).toBeLessThan(1.001);
    }
    expect(kineticOf(world) / before).toBeGreaterThan(0.75);
  }
});

it.each([30, 60])('a disc and a box that are pinned to each other twice gain nothing at %d steps a second', (rate) => {
  const world = weightless();
  const [disk, block] = [
    free({ shapes: [disc(0.2, { mask: 0 })] }),
    free({ position: [0.5, 0], shapes: [box(0.4, 0.4, { mask: 0 })] }),
  ];
  const middle = (0.5 * block!.getMass()) / (disk!.getMass() + block!.getMass());
  for (const body of [disk!, block!]) {
    body.setVelocity([0, 15 * (body.getPosition()[0] - middle)]);
    body.setAngularVelocity(15);
  }
  add(world, disk!, block!);
  for (const y of [-0.1, 0.1]) pin(world, disk!, [0.25, y], block!, [-0.25, y]);
  const before = kineticOf(world);
  for (let i = 0; i < 120 * rate; i += 1) {
    world.step(1 / rate);
    expect(kineticOf(world) / before).toBeLessThan(1.02);
  }
});

it('a square of pinned rods with rods across turns on', () => {
  const world = weightless();
  const corners = [0, 1, 2, 3].map(
    (i): Vec2 =>
      [
        [2, 0],
        [0, 2],
        [-2, 0],
        [0, -2],
      ][i] as Vec2,
  );
  const rods = corners.map(([x, y], i) => {
    const [u, v] = corners[(i + 1) % 4]!;
    const rotation = Math.PI / 4 + ((i + 1) * Math.PI) / 2;
    return turn(free({ position: [(x + u) / 2, (y + v) / 2], rotation, shapes: [box(2.5, 0.2, { mask: 0 })] }), 8);
  });
  add(world, ...rods);
  const local = (body: RigidBody, point: Vec2) => body.transformWorldPointToLocal(point);
  rods.forEach((rod, i) => {
    const [next, at] = [rods[(i + 1) % 4]!, corners[(i + 1) % 4]!];
    pin(world, rod, local(rod, at), next, local(next, at));
  });
  for (const i of [0, 1]) {
    const [bodyA, bodyB] = [rods[i]!, rods[i + 2]!];
    const anchors = { anchorA: local(bodyA, corners[i]!), anchorB: local(bodyB, corners[i + 2]!) };
    world.addConstraint(phys2D.createDistanceConstraint({ bodyA, bodyB, ...anchors, lowerBound: 4, upperBound: 4 }));
  }
  const before = kineticOf(world);
  steps(world, 3600);
  const kept = kineticOf(world) / before;
  console.log(`square with rods across, a minute at 8 rad/s: energy × ${kept.toFixed(4)}`);
  expect(kept).toBeGreaterThan(0.6);
  expect(kept).toBeLessThan(1);
});

it.each([
  [60, 2, 2],
  [60, 6, 2],
  [240, 2, 3],
])(
  'at %d steps a second, what a body that turns at %f rad/s carries on %d welds has its velocity',
  (rate, spin, count) => {
    const world = weightless();
    const bodies = Array.from({ length: count + 1 }, (_, i) => {
      const type = i === 0 ? 'kinematic' : 'dynamic';
      return turn(free({ type, position: [0.7 * i, 0.4 * i], shapes: [disc(0.25, { mask: 0 })] }), spin);
    });
    add(world, ...bodies);
    for (let i = 1; i <= count; i += 1) weld(world, bodies[i - 1]!, bodies[i]!, [0.7 * i - 0.35, 0.4 * i - 0.2]);
    for (let i = 0; i < 2 * rate; i += 1) world.step(1 / rate);
    for (const body of bodies.slice(1)) {
      const speed = Math.hypot(...body.getVelocity()) / Math.hypot(...body.getPosition());
      expect(Math.abs(body.getAngularVelocity() / spin - 1)).toBeLessThan(0.02);
      expect(Math.abs(speed / spin - 1)).toBeLessThan(0.02);
    }
  },
);

describe('blocks that touch, and are welded to their neighbours', () => {
  it.each([
    [2, 2, 3, false],
    [2, 2, 3, true],
    [3, 3, 3, false],
    [3, 3, 3, true],
    [6, 4, 2, false],
    [6, 4, 2, true],
    [5, 1, 3, false],
    [3, 3, 0.5, false],
  ])('%d × %d at %f rad/s keep turning; ignoring each other: %s', (columns, rows, rate, ignores) => {
    const world = weightless();
    plate(world, columns, rows, rate, { ignores });
    const before = angularMomentum(world);
    steps(world, 600);
    const kept = angularMomentum(world) / before;
    console.log(`${columns} × ${rows} blocks at ${rate} rad/s, 10 s: angular momentum × ${kept.toFixed(4)}`);
    expect(kept).toBeGreaterThan(0.998);
    expect(kept).toBeLessThan(1.0001);
  });
});

describe('what is joined, and touches itself', () => {
  /** Bars one behind the other, which take notice of each other. */
  function chain(world: World, kind: 'weld' | 'point', length: number): RigidBody[] {
    const bars = Array.from({ length: 10 }, (_, i) => {
      const position: Vec2 = [0.3 * (i - 4.5), 0];
      return turn(free({ position, shapes: [box(length, 0.1)] }), 3);
    });
    add(world, ...bars);
    for (let i = 1; i < bars.length; i += 1) {
      if (kind === 'weld') {
        weld(world, bars[i - 1]!, bars[i]!, [0.3 * (i - 5), 0], false);
      } else {
        pin(world, bars[i - 1]!, [0.15, 0], bars[i]!, [-0.15, 0], false);
      }
    }
    return bars;
  }

  it.each([
    ['weld', 0.3],
    ['point', 0.3],
    ['point', 0.28],
  ] as const)('a chain of %s constraints between bars of %f m keeps turning', (kind, length) => {
    const world = weightless();
    chain(world, kind, length);
    const before = angularMomentum(world);
    steps(world, 600);
    const kept = angularMomentum(world) / before;
    console.log(`chain by ${kind}, bars of ${length} m, 10 s: angular momentum × ${kept.toFixed(4)}`);
    expect(Math.abs(kept - 1)).toBeLessThan(0.002);
  });

  it('a ring of six welded rods, whose ends are pushed apart, does not drive itself', () => {
    const world = weightless();
    const side = 2 * Math.tan(Math.PI / 6);
    const rods = Array.from({ length: 6 }, (_, i) => {
      const angle = (Math.PI * i) / 3;
      const position: Vec2 = [Math.cos(angle), Math.sin(angle)];
      return turn(free({ position, rotation: angle + Math.PI / 2, shapes: [box(0.98 * side, 0.08)] }), 3);
    });
    add(world, ...rods);
    rods.forEach((rod, i) => {
      weld(world, rod, rods[(i + 1) % 6]!, rod.transformLocalPointToWorld([side / 2, 0]), false);
    });
    const before = angularMomentum(world);
    const energy = kineticOf(world);
    for (let i = 0; i < 10; i += 1) {
      steps(world, 60);
      expect(kineticOf(world) / energy).toBeLessThan(1);
    }
    const kept = angularMomentum(world) / before;
    console.log(`ring of six rods whose ends overlap, 10 s: angular momentum × ${kept.toFixed(4)}`);
    expect(kept).toBeGreaterThan(0.6);
    expect(kept).toBeLessThan(1);
  });
});

describe('what is joined, and touches itself with its circles', () => {
  /** How much of the energy and of the angular momentum is left after 10 s, and the most energy there was, of that at the start. */
  function kept(world: World): { energy: number; momentum: number; most: number } {
    const start = { energy: kineticOf(world), momentum: angularMomentum(world) };
    let most = 0;
    for (let i = 0; i < 10; i += 1) {
      steps(world, 60);
      most = Math.max(most, kineticOf(world) / start.energy);
    }
    const left = { energy: kineticOf(world) / start.energy, momentum: angularMomentum(world) / start.momentum, most };
    console.log(`10 s: energy × ${left.energy.toFixed(4)}, angular momentum × ${left.momentum.toFixed(4)}`);
    return left;
  }

  function expectToTurnOn(world: World): void {
    const { energy, momentum, most } = kept(world);
    expect(energy).toBeGreaterThan(0.99);
    expect(momentum).toBeGreaterThan(0.99);
    expect(most).toBeLessThan(1);
  }

  it.each([1, 3, 6])('three welded discs turn on at %d rad/s', (rate) => {
    const world = weightless();
    const [one, two, three] = [-1, 0, 1].map((x) => turn(free({ position: [x, 0], shapes: [disc(0.5)] }), rate));
    add(world, one!, two!, three!);
    weld(world, one!, two!, [-0.5, 0], false);
    weld(world, two!, three!, [0.5, 0], false);
    expectToTurnOn(world);
  });

  it.each([1, 3, 6])('a net of 4 × 4 discs that touch turns on at %d rad/s', (rate) => {
    const world = weightless();
    const discs = Array.from({ length: 16 }, (_, i) =>
      turn(free({ position: [(i % 4) - 1.5, Math.floor(i / 4) - 1.5], shapes: [disc(0.5)] }), rate),
    );
    add(world, ...discs);
    discs.forEach((body, i) => {
      if (i % 4 < 3) pin(world, body, [0.5, 0], discs[i + 1]!, [-0.5, 0], false);
      if (i < 12) pin(world, body, [0, 0.5], discs[i + 4]!, [0, -0.5], false);
    });
    expectToTurnOn(world);
  });

  it.each([1, 3, 6])('chains of boxes and discs gain nothing at %d rad/s', (rate) => {
    const world = weightless();
    const links = Array.from({ length: 10 }, (_, i) =>
      turn(free({ position: [0.3 * (i - 4.5), 0], shapes: [i % 2 === 0 ? box(0.3, 0.1) : disc(0.15)] }), rate),
    );
    add(world, ...links);
    for (let i = 1; i < 10; i += 1) pin(world, links[i - 1]!, [0.15, 0], links[i]!, [-0.15, 0], false);
    expectToTurnOn(world);
  });

  it('a car whose wheels overlap it turns on, but for what its wheels that are pushed apart take', () => {
    const world = weightless();
    const car = turn(free({ shapes: [box(3, 0.6)] }), 3);
    const wheels = [-1, 1].map((x) => turn(free({ position: [x, 0.4], shapes: [disc(0.4)] }), 3));
    add(world, car, ...wheels);
    wheels.forEach((wheel, i) => {
      pin(world, car, [2 * i - 1, 0.4], wheel, [0, 0], false);
    });
    const { energy, momentum, most } = kept(world);
    expect(energy).toBeGreaterThan(0.8);
    expect(momentum).toBeGreaterThan(0.9);
    expect(most).toBeLessThan(1);
  });
});

describe('soft joints', () => {
  it.each([
    [30, 80, 0.5, 0],
    [60, 20, 1, 0.5],
  ])(
    'at %d steps a second and %f rad/s, a disc on a weld of %f Hz in the middle of another stays there: damping %f',
    (rate, spin, frequency, damping) => {
      const world = weightless();
      const large = turn(free({ shapes: [disc(1, { mask: 0 })] }), spin);
      const small = free({ velocity: [1e-3, 0], shapes: [disc(0.2, { mask: 0 })] });
      add(world, large, small);
      pin(world, staticBody(), [0, 0], large, [0, 0]);
      world.addConstraint(
        phys2D.createWeldConstraint({ bodyA: large, bodyB: small, stiff: false, frequency, damping }),
      );
      let farthest = 0;
      for (let i = 0; i < 15 * rate; i += 1) {
        world.step(1 / rate);
        farthest = Math.max(farthest, Math.hypot(...small.getPosition()));
      }
      expect(farthest).toBeLessThan(0.01);
    },
  );

  it('of a chain that they let hang apart keep its angular momentum', () => {
    const world = weightless();
    const bars = Array.from({ length: 10 }, (_, i) =>
      turn(free({ position: [0.3 * (i - 4.5), 0], shapes: [box(0.3, 0.1, { mask: 0 })] }), 3),
    );
    add(world, ...bars);
    for (let i = 1; i < bars.length; i += 1) {
      const joint = { bodyA: bars[i - 1]!, bodyB: bars[i]!, anchorA: [0.15, 0], anchorB: [-0.15, 0] } as const;
      world.addConstraint(phys2D.createPointConstraint({ ...joint, stiff: false, frequency: 5, damping: 1 }));
    }
    const before = angularMomentum(world);
    steps(world, 600);
    expect(Math.abs(angularMomentum(world) / before - 1)).toBeLessThan(1e-9);
  });

  it.each([0, 0.5])('one that starts stretched, of two bodies that turn at %f rad/s, sets nothing turning', (rate) => {
    const world = weightless();
    const bodyA = turn(free({ position: [-1, 0], shapes: [box(0.6, 0.3, { mask: 0 })] }), rate);
    const bodyB = turn(free({ position: [1, 0], shapes: [box(0.4, 0.6, { mask: 0 })] }), rate);
    add(world, bodyA, bodyB);
    const anchors = { anchorA: [0.3, 0.15], anchorB: [-0.2, -0.3] } as const;
    world.addConstraint(
      phys2D.createPointConstraint({ bodyA, bodyB, ...anchors, stiff: false, frequency: 4, damping: 1 }),
    );
    const before = angularMomentum(world);
    steps(world, 600);
    expect(Math.abs(angularMomentum(world) - before)).toBeLessThan(1e-9);
  });
});

describe('more points than are needed', () => {
  it('rods that are hinged twice make no energy', () => {
    let most = 0;
    for (let seed = 1; seed <= 60; seed += 1) {
      const next = random(seed);
      const world = weightless();
      const rods = Array.from({ length: 2 + Math.floor(7 * next()) }, (_, i) =>
        free({ position: [0.4 * i, 0], shapes: [box(0.4, 0.1, { mask: 0 })] }),
      );
      const middle = 0.2 * (rods.length - 1);
      const rate = 1 + 9 * next();
      for (const rod of rods) {
        rod.setVelocity([1, rate * (rod.getPosition()[0] - middle)]);
        rod.setAngularVelocity(rate);
      }
      add(world, ...rods);
      for (let i = 1; i < rods.length; i += 1) {
        pin(world, rods[i - 1]!, [0.2, 0], rods[i]!, [-0.2, 0]);
        if (next() < 0.6) {
          const [x, y] = [0.6 * next() - 0.3, 0.6 * next() - 0.3];
          pin(world, rods[i - 1]!, [x, y], rods[i]!, [x - 0.4, y]);
        }
      }
      const before = kineticOf(world);
      for (let i = 0; i < 180; i += 1) {
        steps(world, 1);
        most = Math.max(most, kineticOf(world) / before);
      }
    }
    console.log(`rods hinged twice, 3 s: at most ${most.toFixed(4)} of the energy at the start`);
    expect(most).toBeLessThan(1.02);
  });

  it.each([
    [8, 8],
    [20, 3],
  ])('a net of %d discs a side turns at %d rad/s', (side, rate) => {
    const world = weightless();
    const discs = Array.from({ length: side * side }, (_, i) => {
      const position: Vec2 = [(i % side) - (side - 1) / 2, Math.floor(i / side) - (side - 1) / 2];
      return turn(free({ position, shapes: [disc(0.4, { mask: 0 })] }), rate);
    });
    add(world, ...discs);
    discs.forEach((body, i) => {
      if (i % side < side - 1) pin(world, body, [0.5, 0], discs[i + 1]!, [-0.5, 0]);
      if (i < side * (side - 1)) pin(world, body, [0, 0.5], discs[i + side]!, [0, -0.5]);
    });
    const before = kineticOf(world);
    steps(world, 600);
    const kept = kineticOf(world) / before;
    console.log(`net of ${side} × ${side} at ${rate} rad/s, 10 s: energy × ${kept.toFixed(4)}`);
    expect(kept).toBeGreaterThan(0.85);
    expect(kept).toBeLessThan(1);
  });
});

describe('a ring of many shapes with boxes at rest inside it', () => {
  it.each([1, 3])('turns on at %d rad/s', (rate) => {
    const world = weightless();
    const sides = 24;
    const at = (i: number, radius: number): Vec2 => {
      const angle = (2 * Math.PI * i) / sides;
      return [radius * Math.cos(angle), radius * Math.sin(angle)];
    };
    const material = phys2D.createMaterial({ staticFriction: 0.8, dynamicFriction: 0.6 });
    const walls = Array.from({ length: sides }, (_, i) =>
      phys2D.createPolygonShape({ vertices: [at(i, 5), at(i, 5.5), at(i + 1, 5.5), at(i + 1, 5)], material }),
    );
    const inside = 5 * Math.cos(Math.PI / sides) - 0.31;
    const boxes = Array.from({ length: sides }, (_, i) =>
      free({
        position: at(i + 0.5, inside),
        rotation: (2 * Math.PI * (i + 0.5)) / sides,
        shapes: [box(0.6, 0.6, { material })],
      }),
    );
    add(world, free({ shapes: walls }), ...boxes);
    for (const body of world.rigidBodies) turn(body, rate);
    const before = angularMomentum(world);
    const energy = kineticOf(world);
    steps(world, 600);
    const kept = angularMomentum(world) / before;
    const keptEnergy = kineticOf(world) / energy;
    console.log(
      `ring with ${boxes.length} boxes at ${rate} rad/s, 10 s: angular momentum × ${kept}, energy × ${keptEnergy}`,
    );
    expect(Math.abs(kept - 1)).toBeLessThan(1e-4);
    expect(keptEnergy).toBeGreaterThan(0.99);
    expect(keptEnergy).toBeLessThan(1);
  });
});
