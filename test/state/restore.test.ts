import { describe, expect, it } from 'vitest';
import { generator } from '../scenes/mixed.js';
import { GAMES } from '../scenes/states.js';
import { phys2D } from './built.js';

const MOMENTS = 50;
const STEPS = 300;
/** Steps from one comparison to the next. */
const EVERY = 10;

describe.each(Object.entries(GAMES))('%s', (_, build) => {
  it(`goes on to the bit for ${STEPS} steps after restores at ${MOMENTS} random moments`, () => {
    const game = build(phys2D);
    const random = generator(77);
    const moments = new Set(Array.from({ length: MOMENTS }, () => Math.floor(600 * random())));
    const hashes: string[] = [];
    const snapshots: [number, ArrayBuffer][] = [];
    for (let i = 0; i <= 600 + STEPS; i += 1) {
      if (moments.has(i)) {
        snapshots.push([i, game.world.snapshot()]);
      }
      hashes[i] = game.world.hash();
      game.step();
    }
    for (const [moment, snapshot] of snapshots) {
      game.world.restore(snapshot);
      for (let i = moment; i < moment + STEPS; i += 1) {
        if ((i - moment) % EVERY === 0) {
          expect(game.world.hash(), `step ${i} of the run from ${moment}`).toBe(hashes[i]);
        }
        game.step();
      }
      expect(game.world.hash(), `the end of the run from ${moment}`).toBe(hashes[moment + STEPS]);
    }
  }, 300_000);
});

describe('a shape that only an event names', () => {
  /** Two discs that touched, of which one was removed from its body. */
  function parted() {
    const world = phys2D.createWorld();
    const [gone, other] = [0.5, 0.5].map((radius) => phys2D.createCircleShape({ radius }));
    const [a, b] = [gone!, other!].map((shape, i) => {
      const body = phys2D.createRigidBody({ shapes: [shape], position: [0.8 * i, 0] });
      world.addRigidBody(body);
      return body;
    });
    const told: unknown[] = [];
    other!.addEventListener('end', (arbiter) => told.push(arbiter.bodyA?.getPosition(), arbiter.bodyB === b));
    world.step(1 / 60);
    a!.removeShape(gone!);
    return { world, gone: gone!, told };
  }

  it('gives the body that it is on by now the mass of what it was', () => {
    const { world, gone } = parted();
    const snapshot = world.snapshot();
    gone.setRadius(2);
    const body = phys2D.createRigidBody({ shapes: [gone] });
    expect(body.getMass()).toBeCloseTo(4 * Math.PI);
    world.restore(snapshot);
    expect(gone.getRadius()).toBe(0.5);
    expect(body.getMass()).toBeCloseTo(Math.PI / 4);
  });

  it('is on a body for handlers, also after a restore of a copy, which cannot name it', () => {
    const { world, told } = parted();
    world.restore(world.snapshot().slice(0));
    world.step(1 / 60);
    expect(told).toEqual([[0, 0], true]);
  });
});
