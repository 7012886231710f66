import { afterEach, describe, expect, it, vi } from 'vitest';
import { PAIR_STRIDE } from '../../src/collide/layout.js';
import { ARRANGE_FROM, ARRANGE_STEPS } from '../../src/config.js';
import type { Arbiter } from '../../src/contact/arbiter.js';
import { Places } from '../../src/contact/places.js';
import { phys2D, type RigidBody, type World } from '../../src/index.js';
import { add, box, DT, disc, heavy, plainBody } from '../conformance/setting.js';
import { generator } from '../scenes/mixed.js';

// Where the records of pairs lie in memory is nobody's business but the processor's.

afterEach(() => vi.restoreAllMocks());

/** A bucket of mixed shapes of which some are taken away and come anew in each step. */
class Bucket {
  readonly world = heavy();
  private readonly random = generator(7);
  private readonly bodies: RigidBody[] = [];

  constructor() {
    for (const [x, y, width, height] of [
      [0, 0.5, 22, 1],
      [-10.5, -15, 1, 30],
      [10.5, -15, 1, 30],
    ] as const) {
      add(this.world, phys2D.createRigidBody({ type: 'static', position: [x, y], shapes: [box(width, height)] }));
    }
    for (let i = 0; i < 400; i += 1) {
      this.drop(-1 - 0.05 * i);
    }
  }

  step(): void {
    for (let i = 0; i < 3; i += 1) {
      const at = Math.floor(this.random() * this.bodies.length);
      this.world.removeRigidBody(this.bodies[at]!);
      this.bodies.splice(at, 1);
      this.drop(-15 - 5 * this.random());
    }
    this.world.step(DT);
  }

  private drop(y: number): void {
    const size = 0.4 + 0.4 * this.random();
    const shapes = [this.random() < 0.5 ? disc(size / 2) : box(size, size)];
    const body = phys2D.createRigidBody({ position: [18 * (this.random() - 0.5), y], shapes });
    this.bodies.push(body);
    add(this.world, body);
  }
}

/** How many awake pairs have their record right behind that of the one before. */
function shareInOrder({ pairs }: World): number {
  const { items, count } = pairs.sorted;
  let found = 0;
  for (let i = 1; i < count; i += 1) {
    const [before, pair] = [items[i - 1]!, items[i]!];
    found += pair.numbers === before.numbers && pair.at === before.at + PAIR_STRIDE ? 1 : 0;
  }
  return found / count;
}

function places(pairs: readonly Arbiter[]): Set<string> {
  const slabs = [...new Set(pairs.map(({ numbers }) => numbers))];
  return new Set(pairs.map(({ numbers, at }) => `${slabs.indexOf(numbers)} ${at}`));
}

describe('records of pairs', () => {
  it('are brought into the order of the pairs, and no two share one', () => {
    const bucket = new Bucket();
    const { pairs } = bucket.world;
    const shares: number[] = [];
    for (let i = 0; i < 6 * ARRANGE_STEPS; i += 1) {
      bucket.step();
      if (bucket.world.timeStamp % ARRANGE_STEPS === 0 && pairs.sorted.count > ARRANGE_FROM) {
        shares.push(shareInOrder(bucket.world));
      }
    }
    expect(shares.length).toBeGreaterThan(2);
    expect(Math.min(...shares)).toBeGreaterThan(0.9);
    const all: Arbiter[] = pairs.table.arbiters.filter((pair) => pair !== null);
    for (let free = pairs.pool; free !== null; free = free.next) {
      all.push(free);
    }
    expect(all.length).toBeGreaterThan(pairs.sorted.count);
    expect(places(all).size).toBe(all.length);
  });

  it('are the same wherever they are', () => {
    const hashes = [true, false].map((isArranged) => {
      const arrange = vi.spyOn(Places.prototype, 'arrange');
      if (!isArranged) {
        arrange.mockImplementation(() => undefined);
      }
      const bucket = new Bucket();
      const seen: string[] = [];
      for (let i = 0; i < 6 * ARRANGE_STEPS; i += 1) {
        bucket.step();
        seen.push(bucket.world.hash());
        if (i === 150) {
          bucket.world.restore(bucket.world.snapshot());
        }
      }
      expect(arrange).toHaveBeenCalledTimes(6 * ARRANGE_STEPS);
      expect(shareInOrder(bucket.world) > 0.9).toBe(isArranged);
      vi.restoreAllMocks();
      return seen;
    });
    expect(hashes[0]).toEqual(hashes[1]);
  });
});

it('arbiters of a world that was cleared are used again', () => {
  const world = heavy();
  const numbers = Array.from({ length: 20 }, () => {
    const [a, b] = [disc(1), disc(1)];
    add(world, plainBody({ shapes: [a] }), plainBody({ shapes: [b], position: [0.5, 0] }));
    world.step(DT);
    const { number } = a.arbiters[0]!;
    world.clear();
    return number;
  });
  expect(Math.max(...numbers)).toBe(1);
});
