import { describe, expect, it } from 'vitest';
import { phys2D } from '../../src/index.js';
import { Ways } from '../../src/solver/impacts/ways.js';
import { bestTime } from '../best-time.js';
import { generator } from '../scenes/mixed.js';

// The bounds of what moves: found as if each were compared with all, but sooner.

const shape = phys2D.createCircleShape({ radius: 1 });

function overlap(a: Float64Array, b: Float64Array): boolean {
  return a[0]! <= b[2]! && a[2]! >= b[0]! && a[1]! <= b[3]! && a[3]! >= b[1]!;
}

describe('ways', () => {
  const kinds: Record<string, (random: () => number) => number> = {
    'spread evenly': (random) => 20 * random(),
    'at few places, so that they coincide and touch': (random) => Math.floor(4 * random()),
    'of which some are everywhere or nowhere': (random) =>
      random() < 0.1 ? Infinity * (random() - 0.5) : 10 * random(),
  };
  for (const [kind, place] of Object.entries(kinds)) {
    it(`${kind}: finds what overlaps, in the order in which it was added`, () => {
      const random = generator(11);
      const box = (): Float64Array => {
        const [x, y] = [place(random), place(random)];
        return Float64Array.of(x, y, x + Math.floor(3 * random()), y + Math.floor(3 * random()));
      };
      const ways = new Ways();
      let found = 0;
      for (const count of [0, 1, 2, 4, 5, 16, 17, 65, 200, 5]) {
        const boxes = Array.from({ length: count }, box);
        ways.clear();
        for (const [i, bounds] of boxes.entries()) {
          ways.add(shape, i, bounds);
        }
        for (let k = 0; k < 100; k += 1) {
          const bounds = box();
          const expected = boxes.flatMap((other, i) => (overlap(bounds, other) ? [i] : []));
          expect(ways.found.slice(0, ways.find(bounds))).toEqual(expected);
          found += expected.length;
        }
      }
      expect(found).toBeGreaterThan(100);
    });
  }

  const layouts: Record<string, (i: number) => [number, number, number]> = {
    'side by side': (i) => [2 * i, 0, 1],
    'above each other': (i) => [0, 2 * i, 1],
    'beside one that reaches over all of them': (i) => [2 * i, 0, i === 0 ? 1e6 : 1],
  };
  it.each(Object.entries(layouts))('many %s: 8 times as many take no more than 24 times as long', (_, layout) => {
    /** ms. To find what overlaps each, at best. */
    const timeOf = (count: number): number => {
      const ways = new Ways();
      const boxes = Array.from({ length: count }, (__, i) => {
        const [x, y, width] = layout(i);
        return Float64Array.of(x, y, x + width, y + 1);
      });
      return bestTime(() => {
        ways.clear();
        for (let i = 0; i < count; i += 1) {
          ways.add(shape, i, boxes[i]!);
        }
        let found = 0;
        for (const bounds of boxes.slice(1)) {
          found += ways.find(bounds);
        }
        expect(found).toBeGreaterThanOrEqual(count - 1);
      });
    };
    timeOf(2000);
    // The least of three: another process may slow down either. If each were compared with each it would be 64 always.
    const ratios = [1, 2, 3].map(() => timeOf(16000) / timeOf(2000));
    expect(Math.min(...ratios)).toBeLessThan(24);
  });
});
