import { describe, expect, it } from 'vitest';
import { sortFirst } from '../../src/math/sort.js';
import { generator } from '../scenes/mixed.js';

const isLess = (a: number, b: number) => a < b;

describe('sortFirst', () => {
  it('sorts lists of any length', () => {
    const random = generator(3);
    for (let count = 0; count < 200; count += 1) {
      const list = Array.from({ length: count }, () => Math.floor(100 * random()));
      const sorted = [...list].sort((a, b) => a - b);
      sortFirst(list, count, isLess);
      expect(list).toEqual(sorted);
    }
  });

  it('leaves what lies beyond the count', () => {
    const list = [5, 3, 4, 1, 2];
    sortFirst(list, 3, isLess);
    expect(list).toEqual([3, 4, 5, 1, 2]);
  });
});
