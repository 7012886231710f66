import { buildHeavyPyramids } from '../../scenes/stacks.js';
import { type Claim, type Figure, run } from './claim.js';

export const heavyPyramids: Claim = {
  scene: 'three pyramids of ten rows, tops of 100, 200 and 300 times the density, 20 s',
  measure(phys2D): Figure[] {
    const world = phys2D.createWorld({ gravity: [0, 10], allowSleeping: false });
    const tops = buildHeavyPyramids(phys2D, world);
    run(world, 20);
    const fell = tops.filter((top) => top.getPosition()[1] > -9).length;
    return [{ what: 'pyramids that fell', value: fell, unit: '', limit: 0 }];
  },
};
