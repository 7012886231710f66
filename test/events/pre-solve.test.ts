import { describe, expect, it } from 'vitest';
import { asksFirst } from '../../src/events/pre-solve.js';
import type { Circle } from '../../src/index.js';
import { add, disc, plainBody, steps, weightless } from '../conformance/setting.js';

// Whether someone wants to decide about a pair is asked before it is known that the pair collides.

const ignore = (): void => {};

/** Two discs that touch, of groups 1 and 2, and their arbiter. */
function pair(listen: (a: Circle, b: Circle) => void) {
  const [a, b] = [disc(0.5), disc(0.5, { group: 2 })];
  listen(a, b);
  const world = weightless();
  add(world, plainBody({ shapes: [a] }), plainBody({ shapes: [b], position: [0.9, 0] }));
  steps(world, 1);
  return a.arbiters[0]!;
}

describe('a preSolve handler asks first', () => {
  it.each<[string, boolean, (a: Circle, b: Circle) => void]>([
    ['of neither', false, () => {}],
    ['of A', true, (a) => a.addEventListener('preSolve', ignore)],
    ['of B', true, (_, b) => b.addEventListener('preSolve', ignore)],
    ['for the group of the other', true, (a) => a.addEventListener('preSolve', ignore, 2)],
    ['for other groups only', false, (a) => a.addEventListener('preSolve', ignore, 1 | 4)],
    [
      'for other groups, while the other event is for all',
      false,
      (a) => {
        a.addEventListener('begin', ignore);
        a.addEventListener('preSolve', ignore, 1);
      },
    ],
    [
      'for other groups, and one more for this group',
      true,
      (a) => {
        a.addEventListener('preSolve', ignore, 1);
        a.addEventListener('preSolve', ignore, 2);
      },
    ],
    ['that is another event', false, (a, b) => [a, b].map((shape) => shape.addEventListener('begin', ignore))],
  ])('%s: %s', (_, asks, listen) => {
    expect(asksFirst(pair(listen))).toBe(asks);
  });
});
