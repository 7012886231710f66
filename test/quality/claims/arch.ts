import { buildArch } from '../../scenes/standing.js';
import { type Claim, type Figure, run, watch } from './claim.js';

export const arch: Claim = {
  scene: 'arch of 17 wedges with four boxes on it, friction 0.6, 60 s',
  measure(phys2D): Figure[] {
    const world = phys2D.createWorld({ gravity: [0, 10], allowSleeping: false });
    const moved = watch(buildArch(phys2D, world));
    run(world, 60);
    return [{ what: 'farthest move', value: moved(), unit: 'm', limit: 0.05 }];
  },
};
