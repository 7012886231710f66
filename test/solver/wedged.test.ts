import { describe, expect, it } from 'vitest';
import { phys2D, type RigidBody, type RigidBodyParams, type Shape, type Vec2, type World } from '../../src/index.js';
import { decomposeOutline } from '../../src/outline/index.js';
import { add, addFloor, heavy, staticBody, steps, weightless } from '../conformance/setting.js';
import { generator } from '../scenes/mixed.js';

// Bodies of several shapes that are in each other: each contact asks for the way out of one shape, which may lead into the next.

function star(points: number, outer: number, inner: number): Vec2[] {
  return Array.from({ length: 2 * points }, (_, i) => {
    const [angle, radius] = [(Math.PI * i) / points, i % 2 === 0 ? outer : inner];
    return [radius * Math.cos(angle), radius * Math.sin(angle)];
  });
}

const rectangle = (left: number, top: number, right: number, bottom: number): Vec2[] =>
  phys2D.createRectangleVertices(left, top, right, bottom);

const polygons = (outlines: readonly Vec2[][]) => () =>
  outlines.map((vertices) => phys2D.createPolygonShape({ vertices }));

const kinds: Record<string, () => Shape[]> = {
  L: polygons([rectangle(-0.55, 0.05, 0.95, 0.55), rectangle(-0.55, -0.95, -0.05, 0.05)]),
  plus: polygons([rectangle(-0.75, -0.25, 0.75, 0.25), rectangle(-0.25, -0.75, 0.25, 0.75)]),
  U: polygons([rectangle(-0.75, 0.3, 0.75, 0.7), rectangle(-0.75, -0.8, -0.35, 0.3), rectangle(0.35, -0.8, 0.75, 0.3)]),
  gear: polygons(decomposeOutline(star(8, 0.9, 0.6))),
  box: polygons([rectangle(-0.5, -0.3, 0.5, 0.3)]),
  dumbbell: () => [-0.5, 0.5].map((x) => phys2D.createCircleShape({ radius: 0.4, origin: [x, 0] })),
};

function deepest({ dynamicArbiters }: World): number {
  const active = dynamicArbiters.filter(({ active }) => active);
  return Math.max(0, ...active.flatMap(({ contacts }) => contacts.map((contact) => contact.getPenetration())));
}

function make(kind: string, params: RigidBodyParams): RigidBody {
  return phys2D.createRigidBody({ shapes: kinds[kind]!(), ...params });
}

describe('two bodies that were created in each other', () => {
  const names = Object.keys(kinds);
  const pairs = names.flatMap((one, i) => names.slice(i).map((two) => [one, two] as const));

  // Of these 210 pairs 18 stayed in each other.
  it.each(pairs)('%s and %s come apart within 2 s, at rest', (one, two) => {
    const random = generator(5);
    const within = (most: number) => most * (2 * random() - 1);
    for (let i = 0; i < 10; i += 1) {
      const world = weightless();
      const a = make(one, { rotation: within(Math.PI), mass: 1 });
      const b = make(two, { position: [within(0.8), within(0.8)], rotation: within(Math.PI), mass: 2 });
      const middle = (a.getPosition()[0] + 2 * b.getPosition()[0]) / 3;
      add(world, a);
      add(world, b);
      steps(world, 120);
      expect(deepest(world), `${i}`).toBeLessThan(0.02);
      expect((a.getPosition()[0] + 2 * b.getPosition()[0]) / 3).toBeCloseTo(middle, 9);
      expect(Math.hypot(...a.getVelocity(), ...b.getVelocity())).toBeLessThan(1e-6);
    }
  });
});

it('bodies that were created in a static one mostly get out of it within 2 s', () => {
  const random = generator(6);
  const within = (most: number) => most * (2 * random() - 1);
  let stuck = 0;
  for (const one of Object.keys(kinds)) {
    for (const two of Object.keys(kinds)) {
      for (let i = 0; i < 10; i += 1) {
        const world = weightless();
        add(world, make(one, { type: 'static', rotation: within(Math.PI) }));
        add(world, make(two, { position: [within(0.8), within(0.8)], rotation: within(Math.PI) }));
        steps(world, 120);
        const deep = world.staticArbiters.some((pair) => pair.contacts.some((it) => it.getPenetration() > 0.02));
        stuck += deep ? 1 : 0;
      }
    }
  }
  // Of 360. It was 58.
  expect(stuck).toBeLessThan(30);
});

it('gears that fall onto each other at up to 57 m/s are not left in each other', () => {
  // Of these 200, 10 were.
  const random = generator(2);
  const world = heavy();
  addFloor(world);
  for (const x of [-8, 8]) {
    add(
      world,
      staticBody({
        position: [x, -50],
        shapes: [phys2D.createPolygonShape({ vertices: rectangle(-0.5, -51, 0.5, 51) })],
      }),
    );
  }
  for (let i = 0; i < 200; i += 1) {
    const position: Vec2 = [2.4 * ((i % 6) - 2.5) + 0.2 * random(), -1 - 4.8 * Math.floor(i / 6)];
    add(world, make('gear', { position, rotation: 6 * random() }));
  }
  steps(world, 720);
  expect(deepest(world)).toBeLessThan(0.02);
});

it('a load of a thousand times their mass presses few bodies of several shapes into each other', () => {
  const random = generator(7);
  const names = ['L', 'L', 'plus', 'gear', 'U'];
  let deep = 0;
  for (let i = 0; i < 16; i += 1) {
    const world = heavy();
    const walls = [rectangle(-8, 0, 8, 2), rectangle(-8, -60, -2, 0), rectangle(2, -60, 8, 0)];
    add(world, staticBody({ shapes: polygons(walls)() }));
    for (let k = 0; k < 8; k += 1) {
      const kind = names[Math.floor(names.length * random())]!;
      add(world, make(kind, { position: [random() - 0.5, -1 - 1.6 * k], rotation: 6 * random(), mass: 1 }));
    }
    steps(world, 200);
    const top = Math.min(...world.rigidBodies.slice(1).map((body) => body.getPosition()[1]));
    const shapes = polygons([rectangle(-1.9, -1, 1.9, 1)])();
    add(world, phys2D.createRigidBody({ position: [0, top - 8], mass: 1000, shapes }));
    steps(world, 500);
    deep += deepest(world) > 0.02 ? 1 : 0;
  }
  // It was 8.
  expect(deep).toBeLessThan(7);
});

it('what joints hold in each other comes to rest', () => {
  const world = heavy();
  addFloor(world);
  const links = Array.from({ length: 4 }, (_, i) =>
    make('plus', { position: [i, -0.8 - 0.01 * i], rotation: 0.1 * i }),
  );
  add(world, ...links);
  links.slice(1).forEach((bodyB, i) => {
    const bodyA = links[i]!;
    world.addConstraint(phys2D.createPointConstraint({ bodyA, bodyB, anchorA: [0.5, 0], anchorB: [-0.5, 0] }));
  });
  steps(world, 900);
  // Half a metre deep, they did not come to rest.
  expect(deepest(world)).toBeLessThan(0.02);
  expect(links.every((body) => body.asleep)).toBe(true);
});
