import { worstGap } from '../../scenes/joint-grid.js';
import { buildChain } from './chain.js';
import { type Claim, type Figure, run } from './claim.js';

export const heavyChain: Claim = {
  scene: 'chain of ten links with a ball of 100 times the mass of one, falling from level',
  measure(phys2D): Figure[] {
    const world = phys2D.createWorld({ gravity: [0, 10], allowSleeping: false });
    const { joints } = buildChain(phys2D, world, 10, 1, 20);
    let early = 0;
    let late = 0;
    run(world, 10, (step) => {
      const gap = worstGap(joints);
      early = Math.max(early, step <= 300 ? gap : 0);
      late = Math.max(late, step > 300 ? gap : 0);
    });
    return [
      { what: 'widest gap, 5 s to 10 s', value: late, unit: 'm', limit: 0.015 },
      { what: 'widest gap in the first 5 s', value: early, unit: 'm' },
    ];
  },
};
