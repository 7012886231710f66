import { buildPyramid } from '../../scenes/pyramid.js';
import { type Claim, type Figure, fastest, run, SLOP, watch } from './claim.js';
import { deepestOverlap } from './overlap.js';

export const pyramid: Claim = {
  scene: 'pyramid of 1 m boxes, base 20, 20 s',
  measure(phys2D): Figure[] {
    const world = phys2D.createWorld({ gravity: [0, 10], allowSleeping: false });
    const boxes = buildPyramid(phys2D, world, 20);
    const moved = watch(boxes);
    run(world, 20);
    return [
      { what: 'farthest move', value: moved(), unit: 'm', limit: 0.01 },
      { what: 'deepest overlap', value: deepestOverlap(boxes, () => ({ size: 1 })), unit: 'm', limit: 2 * SLOP },
      { what: 'fastest box', value: fastest(boxes), unit: 'm/s' },
    ];
  },
};
