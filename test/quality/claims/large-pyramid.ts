import { buildPyramid } from '../../scenes/pyramid.js';
import { type Claim, type Figure, run, SLOP, watch } from './claim.js';
import { deepestOverlap } from './overlap.js';

export const largePyramid: Claim = {
  scene: 'pyramid of 1 m boxes, base 100, 500 steps',
  measure(phys2D): Figure[] {
    const world = phys2D.createWorld({ gravity: [0, 10], allowSleeping: false });
    const boxes = buildPyramid(phys2D, world, 100);
    const moved = watch(boxes);
    run(world, 500 / 60);
    return [
      { what: 'farthest move', value: moved(), unit: 'm' },
      { what: 'deepest overlap', value: deepestOverlap(boxes, () => ({ size: 1 })), unit: 'm', limit: 2 * SLOP },
    ];
  },
};
