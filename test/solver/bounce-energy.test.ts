import { describe, expect, it } from 'vitest';
import { phys2D } from '../../src/index.js';
import { add, box, disc, energyOf, heavy, kineticOf, staticBody, weightless } from '../conformance/setting.js';
import { generator } from '../scenes/mixed.js';

// Bounces with friction: where one has to end as fast as it came, friction must not ask for more than there is energy for. Boxes left with up to half as much again.

const FREE = { linearDrag: 0, angularDrag: 0 };

describe('a box that bounces off a floor', () => {
  it.each([
    { elasticity: 1, friction: 0.3 },
    { elasticity: 1, friction: 2 },
    { elasticity: 0.9, friction: 1 },
  ])('elasticity $elasticity, friction $friction', ({ elasticity, friction }) => {
    const random = generator(3);
    const within = (from: number, to: number) => from + (to - from) * random();
    const of = { elasticity, staticFriction: friction, dynamicFriction: friction, rollingFriction: 0 };
    const material = phys2D.createMaterial(of);
    for (const rate of [60, 240]) {
      for (let i = 0; i < 500; i += 1) {
        const world = weightless();
        add(world, staticBody({ position: [0, 1], shapes: [box(400, 2, { material })] }));
        const shapes = [box(within(0.1, 0.6), within(0.05, 0.6), { material })];
        const velocity: [number, number] = [within(-8, 8), within(2, 15)];
        const [rotation, angularVelocity] = [within(0, 6), within(-40, 40)];
        add(world, phys2D.createRigidBody({ position: [0, -1], velocity, rotation, angularVelocity, shapes, ...FREE }));
        const before = kineticOf(world);
        for (let k = 0; k < rate; k += 1) world.step(1 / rate);
        expect(kineticOf(world) / before, `${i}, steps of 1/${rate} s`).toBeLessThan(1.001);
      }
    }
  });
});

describe('a small box of elasticity 1 that falls on a floor', () => {
  // It had 1.08 to 1.17 times its energy: put back to where its next corner was too deep, and pushed out of there, it kept the speed that
  // it had got on the way on from there.
  it.each([0.1, 0.2, 0.5, 0.7, 0.84])('and turns, from %f rad: keeps its energy for a minute', (rotation) => {
    const of = { elasticity: 1, staticFriction: 0, dynamicFriction: 0, rollingFriction: 0 };
    const material = phys2D.createMaterial(of);
    const world = heavy();
    const vertices = phys2D.createRectangleVertices(-200, 0, 200, 2);
    add(world, staticBody({ shapes: [phys2D.createPolygonShape({ vertices, material })] }));
    add(
      world,
      phys2D.createRigidBody({ position: [0, -1], rotation, shapes: [box(0.25, 0.25, { material })], ...FREE }),
    );
    const before = energyOf(world);
    for (let i = 0; i < 3600; i += 1) world.step(1 / 60);
    const share = energyOf(world) / before;
    expect(share).toBeGreaterThan(0.98);
    expect(share).toBeLessThan(1.01);
  });
});

describe('boxes and balls that bounce off each other in a room', () => {
  it.each([0.2, 1])('friction %f: have no more energy than at first', (friction) => {
    const random = generator(9);
    const of = { elasticity: 1, staticFriction: friction, dynamicFriction: friction, rollingFriction: 0 };
    const material = phys2D.createMaterial(of);
    const world = weightless();
    for (const [x, y, w, h] of [
      [0, 5.5, 12, 1],
      [0, -5.5, 12, 1],
      [5.5, 0, 1, 12],
      [-5.5, 0, 1, 12],
    ] as const) {
      add(world, staticBody({ position: [x, y], shapes: [box(w, h, { material })] }));
    }
    for (let i = 0; i < 49; i += 1) {
      const shapes = [i % 3 === 0 ? disc(0.25, { material }) : box(0.4, 0.3 + 0.2 * random(), { material })];
      const velocity: [number, number] = [8 * random() - 4, 8 * random() - 4];
      const position: [number, number] = [(i % 7) * 1.3 - 3.9, Math.floor(i / 7) * 1.3 - 3.9];
      add(world, phys2D.createRigidBody({ position, velocity, angularVelocity: 6 * random() - 3, shapes, ...FREE }));
    }
    const before = kineticOf(world);
    for (let i = 0; i < 1200; i += 1) {
      world.step(1 / 60);
      expect(kineticOf(world) / before, `after ${i} steps`).toBeLessThan(1.02);
    }
  });
});

// Of what turned it back within a step, a part was taken back again where it then met the next wall: in the smallest rooms it lost half of
// its speed within two seconds.
it('a bullet of elasticity 1 keeps its speed in small rooms, where it meets several walls in a step', () => {
  const of = { elasticity: 1, staticFriction: 0, dynamicFriction: 0, rollingFriction: 0 };
  const material = phys2D.createMaterial(of);
  const random = generator(5);
  for (let room = 0; room < 40; room += 1) {
    const world = weightless();
    const [width, height] = [0.8 + 2 * random(), 0.8 + 2 * random()];
    for (const side of [-1, 1]) {
      const [x, y] = [side * (width / 2 + 1), side * (height / 2 + 1)];
      add(world, staticBody({ position: [x, 0], shapes: [box(2, height + 4, { material })] }));
      add(world, staticBody({ position: [0, y], shapes: [box(width + 4, 2, { material })] }));
    }
    const velocity: [number, number] = [60 * random() - 30, 180 * random() - 90];
    const shapes = [disc(0.05 + 0.12 * random(), { material })];
    add(world, phys2D.createRigidBody({ bullet: true, velocity, shapes, ...FREE }));
    const before = kineticOf(world);
    for (let i = 0; i < 120; i += 1) {
      world.step(1 / 60);
      expect(Math.abs(kineticOf(world) / before - 1), `room ${room}`).toBeLessThan(1e-6);
    }
  }
});
