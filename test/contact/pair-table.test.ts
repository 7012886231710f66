import { expect, it } from 'vitest';
import { Arbiter } from '../../src/contact/arbiter.js';
import { PairTable } from '../../src/contact/pair-table.js';
import { phys2D } from '../../src/index.js';
import { generator } from '../scenes/mixed.js';

it('the pair table agrees with a map through thousands of additions and removals', () => {
  const random = generator(1);
  const shapes = Array.from({ length: 60 }, () => phys2D.createCircleShape({ radius: 1 }));
  const table = new PairTable();
  const model = new Map<string, Arbiter>();
  for (let i = 0; i < 20_000; i += 1) {
    const [a, b] = [Math.floor(60 * random()), Math.floor(60 * random())].sort((p, q) => p - q) as [number, number];
    if (a === b) {
      continue;
    }
    const key = `${a}-${b}`;
    const known = model.get(key) ?? null;
    expect(table.find(shapes[a]!, shapes[b]!)).toBe(known);
    if (known === null) {
      const arbiter = new Arbiter(shapes[a]!, shapes[b]!, 0);
      model.set(key, arbiter);
      table.add(arbiter);
    } else if (random() < 0.7) {
      table.remove(known);
      model.delete(key);
    }
  }
  expect(model.size).toBeGreaterThan(200);
  table.clear();
  for (const arbiter of model.values()) {
    expect(table.find(arbiter.shapeA, arbiter.shapeB)).toBe(null);
  }
});
