import { describe, expect, it } from 'vitest';
import { phys2D } from '../../src/index.js';
import { Ways } from '../../src/solver/ways.js';
import { generator } from '../scenes/mixed.js';

// The bounds of what moves, looked up from the left: as if each were compared with all.

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
      for (const count of [0, 1, 2, 17, 200, 5]) {
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
});
