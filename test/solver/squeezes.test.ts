import { describe, expect, it } from 'vitest';
import { phys2D, type RigidBody, type World } from '../../src/index.js';
import { add, box, DT, heavy, steps } from '../conformance/setting.js';
import { Chance } from '../geometry/forms.js';

// What is pressed between kinematic bodies and others that do not give way.

const friction = (of: number) => phys2D.createMaterial({ staticFriction: of, dynamicFriction: of });
const rough = friction(0.5);

/** Rows of crates of 0.8 m on a floor, before a wall, and a piston that goes on at 0.5 m/s until they are in each other by so much, m, and stops. */
function press(
  columns: number,
  rows: number,
  over: number,
  seed: number,
): { world: World; crates: RigidBody[]; end: number; piston: RigidBody } {
  const chance = new Chance(seed);
  const world = heavy();
  const fixed = (x: number, y: number, width: number, height: number, type: 'static' | 'kinematic'): RigidBody =>
    phys2D.createRigidBody({ type, position: [x, y], shapes: [box(width, height, { material: rough })] });
  const room = columns * 0.9;
  const piston = fixed(-room - 1, -1.5, 1, 3, 'kinematic');
  add(world, fixed(0, 5, 80, 10, 'static'), fixed(0.5, -3, 1, 6, 'static'), piston);
  const crates = Array.from({ length: columns * rows }, (_, i) =>
    phys2D.createRigidBody({
      position: [-0.9 * ((i % columns) + 0.5) + chance.span(-0.025, 0.025), -0.4 - 0.8 * Math.floor(i / columns)],
      shapes: [box(0.8, 0.8, { material: rough })],
    }),
  );
  add(world, ...crates);
  steps(world, 100);
  piston.setVelocity([0.5, 0]);
  return { world, crates, piston, end: Math.round(((room + 0.5 - columns * 0.8 + over) / 0.5) * 60) };
}

/** N·s: the most that a contact of a body gave in the last step. */
function hardest(body: RigidBody): number {
  const { arbiters } = body.shapes[0]!;
  return Math.max(0, ...arbiters.map((arbiter) => Math.hypot(...arbiter.getImpulseForBody(body).slice(0, 2))));
}

describe('a press', () => {
  it.each([
    [5, 2, 0.2],
    [5, 3, 0.3],
    [8, 3, 0.3],
  ])('of %i columns of %i crates, by more than there is room, throws none of them', (columns, rows, over) => {
    for (let seed = 1; seed <= 4; seed += 1) {
      const { world, crates, piston, end } = press(columns, rows, over, seed);
      let fastest = 0;
      let most = 0;
      for (let i = 0; i < end + 120; i += 1) {
        if (i === end) piston.setVelocity([0, 0]);
        world.step(DT);
        fastest = Math.max(fastest, ...crates.map((crate) => -crate.getVelocity()[1]));
        most = Math.max(...crates.map(hardest));
      }
      // Up to 37 m/s and 313 N·s before.
      expect(fastest).toBeLessThan(0.5);
      expect(most).toBeLessThan(20);
    }
  });
});

// They made its contacts start with twenty times as much, as if they held the crates: 6 m/s instead of 0.2.
it('constraints that are disabled change nothing in a press', () => {
  const run = (areTied: boolean): string[] => {
    const { world, crates, piston, end } = press(5, 3, 0.3, 1);
    const tied = areTied ? crates.slice(1) : [];
    for (const bodyB of tied) {
      world.addConstraint(phys2D.createMotorConstraint({ bodyA: crates[0]!, bodyB, maxForce: 1, disabled: true }));
    }
    const places: string[] = [];
    for (let i = 0; i < end + 60; i += 1) {
      if (i === end) piston.setVelocity([0, 0]);
      world.step(DT);
      places.push(crates.map((crate) => [...crate.getPosition(), crate.getRotation()].join()).join());
    }
    return places;
  };
  expect(run(true)).toEqual(run(false));
});

/** Two kinematic jaws close on something 0.5 m wide, to so much less than that, wait, and go up by 2 m. @returns how far that came along. */
function lift(
  shape: () => ReturnType<typeof box> | ReturnType<typeof phys2D.createCircleShape>,
  less: number,
  wait: number,
): number {
  const world = heavy();
  add(world, phys2D.createRigidBody({ type: 'static', position: [0, 1], shapes: [box(20, 2)] }));
  const jaws = [-1, 1].map((side) =>
    phys2D.createRigidBody({
      type: 'kinematic',
      position: [side * 0.6, -0.5],
      shapes: [box(0.4, 0.8, { material: friction(0.6) })],
    }),
  );
  const thing = phys2D.createRigidBody({ position: [0, -0.25], shapes: [shape()] });
  add(world, ...jaws, thing);
  steps(world, 30);
  const time = (0.15 + less / 2) / 0.25;
  jaws.forEach((jaw, i) => void jaw.setVelocity([i === 0 ? 0.25 : -0.25, 0]));
  steps(world, Math.round(time / DT));
  jaws.forEach((jaw) => void jaw.setVelocity([0, 0]));
  steps(world, wait);
  const before = thing.getPosition()[1];
  jaws.forEach((jaw) => void jaw.setVelocity([0, -1]));
  steps(world, 120);
  jaws.forEach((jaw) => void jaw.setVelocity([0, 0]));
  steps(world, 120);
  return before - thing.getPosition()[1];
}

describe('a claw', () => {
  it.each([0.02, 0.05, 0.1])('that is %f m too narrow lifts what it grips, and holds it', (less) => {
    const material = friction(0.6);
    for (const wait of [0, 60]) {
      expect(lift(() => box(0.5, 0.5, { material }), less, wait)).toBeCloseTo(2, 2);
      expect(lift(() => phys2D.createCircleShape({ radius: 0.25, material }), less, wait)).toBeCloseTo(2, 2);
    }
  });
});

describe('a lift', () => {
  it('carries a heavy lid on light crates up and down, and neither comes into what it lies on', () => {
    const world = heavy();
    const floor = phys2D.createRigidBody({ type: 'kinematic', position: [0, 0.5], shapes: [box(6, 1)] });
    const crates = Array.from({ length: 15 }, (_, i) =>
      phys2D.createRigidBody({
        position: [0.6 * ((i % 5) - 2), -0.25 - 0.5 * Math.floor(i / 5)],
        shapes: [box(0.5, 0.5)],
      }),
    );
    const lid = phys2D.createRigidBody({ position: [0, -2.25], mass: 100, shapes: [box(4, 0.5)] });
    add(world, floor, ...crates, lid);
    for (let i = 0; i < 600; i += 1) {
      floor.setVelocity([0, 2 * Math.sin(i / 30)]);
      world.step(DT);
    }
    floor.setVelocity([0, 0]);
    steps(world, 200);
    const top = floor.getPosition()[1] - 0.5;
    crates.forEach((crate) => void expect(top - crate.getPosition()[1]).toBeGreaterThan(0.24));
    expect(top - lid.getPosition()[1]).toBeGreaterThan(1.73);
  });
});

it.each([0.1, 0.2])('what overlaps two walls by %f m each falls asleep', (deep) => {
  const world = heavy();
  const wall = (x: number) => phys2D.createRigidBody({ type: 'static', position: [x, 0], shapes: [box(1, 4)] });
  const ball = phys2D.createRigidBody({ shapes: [phys2D.createCircleShape({ radius: 0.25 })] });
  const floor = phys2D.createRigidBody({ type: 'static', position: [0, 2], shapes: [box(4, 1)] });
  add(world, wall(-0.75 + deep), wall(0.75 - deep), floor, ball);
  steps(world, 300);
  expect(ball.sleeping).toBe(true);
});

it('a pusher without gravity does not go into light boxes before a heavy one', () => {
  const world = phys2D.createWorld({ gravity: [0, 0] });
  const pusher = phys2D.createRigidBody({ type: 'kinematic', position: [-2, -0.5], shapes: [box(1, 1.9)] });
  const boxes = Array.from({ length: 5 }, (_, i) =>
    phys2D.createRigidBody({ position: [0.5 * i - 1.2, 0.25], mass: 1, shapes: [box(0.5, 0.5)] }),
  );
  const heavyOne = phys2D.createRigidBody({
    position: [1.8, -0.5],
    mass: 200,
    inertia: Infinity,
    shapes: [box(1, 2)],
  });
  add(world, pusher, ...boxes, heavyOne);
  pusher.setVelocity([5, 0]);
  let least = Infinity;
  for (let i = 0; i < 180; i += 1) {
    world.step(DT);
    least = Math.min(least, heavyOne.getPosition()[0] - pusher.getPosition()[0] - 1);
  }
  // Of 2.5 m; 1.98 if only gravity counts as a weight.
  expect(least).toBeGreaterThan(2.3);
});

it('a seesaw of infinite mass holds a load on a light crate, as what turns gives way', () => {
  const world = heavy();
  const seesaw = phys2D.createRigidBody({ mass: Infinity, inertia: 5, shapes: [box(5, 0.2)] });
  const block = phys2D.createRigidBody({ type: 'static', position: [1, 1.1], shapes: [box(1, 1)] });
  const crate = phys2D.createRigidBody({ position: [1, 0.35], mass: 0.25, shapes: [box(0.5, 0.5)] });
  const load = phys2D.createRigidBody({ position: [2.2, -0.35], mass: 100, shapes: [box(0.5, 0.5)] });
  add(world, seesaw, block, crate, load);
  steps(world, 240);
  expect(seesaw.getRotation()).toBeLessThan(0.05);
  expect(load.getPosition()[1]).toBeCloseTo(-0.34, 1);
});
