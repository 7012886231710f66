import { describe, expect, it } from 'vitest';
import { type PointConstraint, phys2D, type RigidBody, simdKernels, type World } from '../../src/index.js';
import { plainKernels } from '../../src/kernels.js';
import { add, box, DT, disc } from '../conformance/setting.js';
import { generator } from '../scenes/mixed.js';

// Chains of as many joints are solved two at a time, each joint beside one of another chain. They may not feel that.

/** What befalls a chain that is made at x. */
type Fate = (world: World, links: RigidBody[], x: number) => void;

/** A chain of `count` links that hangs from a point, or is free; built `stretch` m too long at each joint, at an angle. */
function chain(world: World, x: number, count: number, stretch = 0, isHeld = true, angle = 0): RigidBody[] {
  const links: RigidBody[] = [];
  const way = 0.5 + stretch;
  for (let i = 0; i <= count; i += 1) {
    const link = phys2D.createRigidBody({
      type: isHeld && i === 0 ? 'static' : 'dynamic',
      position: [x + way * i * Math.cos(angle), way * i * Math.sin(angle)],
      rotation: angle,
      shapes: [box(0.5, 0.1, { group: 2, mask: 1 })],
      linearDrag: 0,
      angularDrag: 0,
    });
    add(world, link);
    if (i > 0) {
      const shared = { bodyA: links[i - 1]!, bodyB: link, ignoreInteractions: true };
      world.addConstraint(phys2D.createPointConstraint({ ...shared, anchorA: [0.25, 0], anchorB: [-0.25, 0] }));
    }
    links.push(link);
  }
  return links;
}

const fates: Record<string, Fate> = {
  'that only swings': () => {},
  'of which a link spins too fast for small turns': (_world, links) => links[3]!.setAngularVelocity(150),
  'that is torn along': (_world, links) => links[5]!.setVelocity([40, -300]),
  'with a heavy ball at its end': (world, links, x) => {
    const ball = disc(0.5);
    const bodyB = phys2D.createRigidBody({ position: [x + 6, 0], mass: 500, shapes: [ball] });
    add(world, bodyB);
    const shared = { bodyA: links[links.length - 1]!, bodyB, ignoreInteractions: true };
    world.addConstraint(phys2D.createPointConstraint({ ...shared, anchorA: [0.25, 0], anchorB: [-0.5, 0] }));
  },
  'that falls onto the ground': (world, _links, x) => {
    const ground = phys2D.createRigidBody({ type: 'static', position: [x, 2], shapes: [box(30, 1)] });
    add(world, ground);
  },
  'of which a joint is moved': (_world, links) => {
    const [joint] = links[4]!.constraints;
    if (joint!.type === 'POINT') (joint as PointConstraint).setAnchorA([0.4, 0.3]);
  },
};

/**
 * Chains of these fates, far from each other, and as many pendulums at rest: where all links are after each step, and how many chains lay beside another one. With a
 * pendulum before each chain none does.
 */
function run(
  names: readonly string[],
  kernels: typeof simdKernels,
  areApart: boolean,
): { places: number[][]; beside: number } {
  const world = phys2D.createWorld({ gravity: [0, 10], kernels, allowSleeping: false });
  const all: RigidBody[] = [];
  const pendulums = names.map((_, i) => () => chain(world, -1000 - 10 * i, 1, 0, true, Math.PI / 2));
  for (const [i, name] of names.entries()) {
    if (areApart) pendulums[i]!();
    const x = 1000 * i;
    // The ball is one more.
    const count = name.includes('heavy') ? 9 : 10;
    const links = chain(world, x, count, name.includes('swings') ? 0.01 : 0, !name.includes('falls'));
    all.push(...links);
    fates[name]!(world, links, x);
  }
  for (const pendulum of areApart ? [] : pendulums) pendulum();
  const places: number[][] = [];
  let beside = 0;
  for (let step = 0; step < 150; step += 1) {
    world.step(DT);
    beside += world.solver.joints.groups.filter((group) => group.isBeside).length;
    places.push(all.flatMap((link) => [...link.getPosition(), link.getRotation(), ...link.getVelocity()]));
  }
  return { places, beside: beside / 150 };
}

describe.each([
  ['in TypeScript', plainKernels],
  ['in WebAssembly', simdKernels],
])('two chains side by side, %s', (_, kernels) => {
  const names = Object.keys(fates);

  it.each(names)('one %s and any other move as they do one after the other, to the bit', (name) => {
    for (const other of names) {
      const [both, apart] = [false, true].map((areApart) => run([name, other], kernels, areApart));
      expect([both!.beside, apart!.beside]).toEqual([2, 0]);
      expect(both!.places).toEqual(apart!.places);
    }
  });

  it('are found by twos, in the order in which they were added', () => {
    const all = [...names, ...names.slice(1, 4)];
    const found = run(all, kernels, false);
    expect(found.beside).toBe(8);
    expect(found.places).toEqual(run(all, kernels, true).places);
  });
});

describe('chains', () => {
  it.each([
    ['of as many joints', [6, 6], 1],
    ['of which three are as long', [6, 6, 6], 1],
    ['of other lengths', [6, 7], 0],
    ['of a few joints', [3, 3], 0],
    ['with another one in between', [6, 7, 6], 0],
    ['longer than a run', [130, 130], 0],
  ])('%s', (_, counts, beside) => {
    const world = phys2D.createWorld();
    for (const [i, count] of counts.entries()) chain(world, 1000 * i, count);
    world.step(DT);
    const { groups } = world.solver.joints;
    expect(groups.filter((group) => group.beside !== null)).toHaveLength(beside);
    expect(groups.filter((group) => group.isBeside)).toHaveLength(2 * beside);
  });

  it('do not lie beside each other if other constraints hang on them', () => {
    const world = phys2D.createWorld();
    const links = [chain(world, 0, 6), chain(world, 1000, 6)];
    world.addConstraint(
      phys2D.createAngleConstraint({ bodyA: links[1]![2]!, bodyB: links[1]![3]!, lowerBound: -1, upperBound: 1 }),
    );
    world.step(DT);
    expect(world.solver.joints.groups.some((group) => group.isBeside)).toBe(false);
  });

  it('hang on one static body, but not on one that is kinematic', () => {
    const besides = (['static', 'kinematic'] as const).map((type) => {
      const world = phys2D.createWorld();
      const bodyA = phys2D.createRigidBody({ type, position: [0, -1], shapes: [box(1, 1, { group: 2, mask: 1 })] });
      add(world, bodyA);
      for (const x of [-10, 10]) {
        const bodyB = chain(world, x, 6, 0, false)[0]!;
        world.addConstraint(phys2D.createPointConstraint({ bodyA, bodyB, anchorA: [x, 1], anchorB: [0, 0] }));
      }
      world.step(DT);
      return world.solver.joints.groups.map((group) => group.isBeside);
    });
    expect(besides).toEqual([
      [true, true],
      [false, false],
    ]);
  });

  it('are as they were after others came and went', () => {
    const random = generator(5);
    const world = phys2D.createWorld({ kernels: simdKernels });
    const other = phys2D.createWorld({ kernels: plainKernels });
    const chains = [world, other].map((each) => [0, 1, 2, 3].map((i) => chain(each, 1000 * i, 8)));
    for (let step = 0; step < 120; step += 1) {
      if (step % 20 === 10) {
        const which = Math.floor(4 * random());
        for (const [i, each] of [world, other].entries()) {
          const [held] = chains[i]![which]!;
          if (held!.world === null) each.addRigidBody(held!);
          else each.removeRigidBody(held!);
        }
      }
      world.step(DT);
      other.step(DT);
      expect(world.hash()).toBe(other.hash());
    }
  });
});
