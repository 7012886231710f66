import { expect, it } from 'vitest';
import { crosses, crossing, REACHED } from '../../src/geometry/crossing.js';
import { generator } from '../scenes/mixed.js';

// Bounds on a straight way: whether they meet others, and when at first.

function overlap(a: readonly number[], b: readonly number[], slack: number): boolean {
  return [0, 1].every((axis) => a[axis]! - slack <= b[axis + 2]! && a[axis + 2]! + slack >= b[axis]!);
}

it('meets what a walk along the way in small steps meets, no later, and where the bounds just touch', () => {
  const random = generator(5);
  const place = (): number => Math.floor(9 * random()) - 4;
  const box = (): number[] => {
    const [x, y] = [place(), place()];
    return [x, y, x + Math.floor(3 * random()), y + Math.floor(3 * random())];
  };
  const met = { early: 0, late: 0, never: 0 };
  for (let i = 0; i < 3000; i += 1) {
    const [a, b] = [box(), box()];
    const [x, y, slack] = [place(), place(), random()];
    const at = (share: number): number[] => a.map((side, k) => side + share * (k % 2 === 0 ? x : y));
    const walk = Array.from({ length: 65 }, (_, k) => k / 64).find((share) => overlap(at(share), b, slack));
    crossing.set([x, y, slack]);
    if (!crosses(Float64Array.of(9, ...a), 1, b, 0)) {
      expect(walk).toBeUndefined();
      met.never += 1;
      continue;
    }
    const reached = crossing[REACHED]!;
    expect(overlap(at(reached), b, slack + 1e-12)).toBe(true);
    expect(reached).toBeGreaterThanOrEqual(0);
    expect(reached).toBeLessThanOrEqual(walk ?? 1);
    expect(overlap(at(reached - 1e-6), b, slack) && reached > 0).toBe(false);
    met[reached > 0 ? 'late' : 'early'] += 1;
  }
  expect(Math.min(met.early, met.late, met.never)).toBeGreaterThan(100);
});
