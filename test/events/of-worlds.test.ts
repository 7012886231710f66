import { describe, expect, it, vi } from 'vitest';
import { type Arbiter, type Hit, phys2D, type Shape, type World, type WorldEventType } from '../../src/index.js';
import { add, addFloor, boxBody, disc, heavy, plainBody, steps, weightless } from '../conformance/setting.js';
import { generator } from '../scenes/mixed.js';

// A world tells of what happens between any two of its shapes.

const CONTACTS = ['begin', 'progress', 'end', 'hit'] as const;

/** What a world tells, each event once: type, ids of the shapes. */
function listenTo(world: World): string[] {
  const log: string[] = [];
  for (const type of CONTACTS) {
    world.addEventListener(type, ({ shapeA, shapeB }: Arbiter) => void log.push(`${type} ${shapeA.id} ${shapeB.id}`));
  }
  return log;
}

/** The same, of all shapes; each event is told by both, and counts where the first one tells. */
function listenToShapes(shapes: readonly Shape[]): string[] {
  const log: string[] = [];
  for (const shape of shapes) {
    for (const type of ['begin', 'progress', 'end'] as const) {
      shape.addEventListener(type, ({ shapeA, shapeB }) => {
        if (shape === shapeA) log.push(`${type} ${shapeA.id} ${shapeB.id}`);
      });
    }
    shape.addEventListener('hit', ({ shapeA, shapeB }) => {
      if (shape === shapeA) log.push(`hit ${shapeA.id} ${shapeB.id}`);
    });
  }
  return log;
}

describe('a world', () => {
  it('tells what all shapes would tell, in the same order, whether those are listened to or not', () => {
    const logs = [false, true].map((byShapes) => {
      const random = generator(11);
      const world = heavy();
      addFloor(world);
      const bodies = Array.from({ length: 30 }, (_, i) =>
        i % 3 === 0
          ? boxBody(0.8, 0.6, { position: [8 * random() - 4, -1 - i / 4] })
          : plainBody({ position: [8 * random() - 4, -1 - i / 4], bullet: i % 5 === 0, shapes: [disc(0.4)] }),
      );
      add(world, ...bodies);
      const zone = disc(2, { sensor: true });
      add(world, phys2D.createRigidBody({ type: 'static', position: [0, -1], shapes: [zone] }));
      const ids = new Map(world.rigidBodies.flatMap(({ shapes }) => shapes).map(({ id }, i) => [String(id), i]));
      const log = byShapes ? listenToShapes(world.rigidBodies.flatMap(({ shapes }) => shapes)) : listenTo(world);
      for (let i = 0; i < 200; i += 1) {
        if (i % 25 === 24) world.removeRigidBody(bodies[(i / 25) | 0]!);
        if (i === 120) bodies[20]!.removeShape(bodies[20]!.shapes[0]!);
        world.step(1 / 60);
      }
      return log.map((entry) => entry.replace(/\d+/g, (id) => String(ids.get(id))));
    });
    expect(logs[0]).toEqual(logs[1]);
    for (const type of CONTACTS) {
      expect(logs[0]!.filter((entry) => entry.startsWith(type)).length).toBeGreaterThan(20);
    }
  });

  it('is told after the shapes, with the arbiter, and `this` is the world', () => {
    const world = weightless();
    const [a, b] = [plainBody({ velocity: [2, 0] }), plainBody({ position: [1.01, 0] })];
    add(world, a, b);
    const log: string[] = [];
    a.shapes[0]!.addEventListener('begin', () => log.push('A'));
    b.shapes[0]!.addEventListener('begin', () => log.push('B'));
    world.addEventListener('begin', function (...given) {
      expect(this).toBe(world);
      expect(given).toHaveLength(1);
      expect([given[0].bodyA, given[0].bodyB]).toEqual([a, b]);
      log.push('world');
    });
    steps(world, 3);
    expect(log).toEqual(['A', 'B', 'world']);
  });

  it('tells how hard shapes meet that nobody else listens to', () => {
    const world = weightless();
    const [a, b] = [plainBody({ velocity: [3, 0] }), plainBody({ position: [1.2, 0] })];
    add(world, a, b);
    const told = vi.fn((arbiter: Arbiter, hit: Hit) => [arbiter.shapeA, hit.approachSpeed, hit.impulse]);
    world.addEventListener('hit', told);
    steps(world, 10);
    expect(told.mock.results.map(({ value }) => value)).toEqual([
      [a.shapes[0], expect.closeTo(3, 9), expect.closeTo(1.5, 9)],
    ]);
  });

  it('tells the `end` of what is removed, and of one of its shapes, with the bodies that met', () => {
    const world = weightless();
    const [a, b, c] = [plainBody(), plainBody({ position: [0.9, 0] }), plainBody({ position: [-0.9, 0] })];
    add(world, a, b, c);
    const ends: unknown[] = [];
    world.addEventListener('end', ({ bodyA, bodyB }) => void ends.push([bodyA, bodyB]));
    steps(world, 1);
    world.removeRigidBody(b);
    c.removeShape(c.shapes[0]!);
    steps(world, 1);
    expect(ends).toEqual([
      [a, b],
      [a, c],
    ]);
  });

  it('does not wake for a new listener, and tells no `progress` of what sleeps', () => {
    const world = heavy();
    addFloor(world);
    const body = boxBody(1, 1);
    add(world, body);
    steps(world, 120);
    expect(body.sleeping).toBe(true);
    const told = vi.fn();
    world.addEventListener('progress', told);
    steps(world, 2);
    expect([body.sleeping, told.mock.calls.length]).toEqual([true, 0]);
    body.wake();
    steps(world, 2);
    expect(told.mock.calls.length).toBe(2);
  });

  it('goes on when a handler throws, and throws that when all is told; after `clear` it tells no more', () => {
    const world = weightless();
    add(world, plainBody(), plainBody({ position: [0.9, 0] }), plainBody({ position: [1.8, 0] }));
    const log: string[] = [];
    const fails = () => {
      throw new Error('a handler');
    };
    world.addEventListener('begin', fails);
    world.addEventListener('begin', () => void log.push('begin'));
    expect(() => world.step(1 / 60)).toThrow('a handler');
    expect(log).toEqual(['begin', 'begin']);
    expect(world.removeEventListener('begin', fails)).toBe(true);
    world.addEventListener('progress', () => {
      log.push('progress');
      world.clear();
    });
    world.step(1 / 60);
    expect(log).toEqual(['begin', 'begin', 'progress']);
  });

  it('has each handler once, and none of unknown types', () => {
    const world = weightless();
    const told = vi.fn();
    for (const type of [...CONTACTS, 'nonfinite'] as WorldEventType[]) {
      expect(world.addEventListener(type, told)).toBe(true);
      expect(world.addEventListener(type, told)).toBe(false);
      expect(world.removeEventListener(type, told)).toBe(true);
      expect(world.removeEventListener(type, told)).toBe(false);
    }
    for (const type of ['preSolve', 'wake', 'sleep', 'break', 'other', 7]) {
      expect(world.addEventListener(type as WorldEventType, told)).toBe(false);
    }
    expect(() => world.addEventListener('begin', 5 as never)).toThrow(
      /World\.addEventListener: handler must be a function/,
    );
  });
});
