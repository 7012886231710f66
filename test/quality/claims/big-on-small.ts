import { buildBigOnSmall } from '../../scenes/stacks.js';
import { type Claim, type Figure, run } from './claim.js';

export const bigOnSmall: Claim = {
  scene: 'box of 20 m on two of 1 m, 400 : 1, 20 s',
  measure(phys2D): Figure[] {
    const world = phys2D.createWorld({ gravity: [0, 10], allowSleeping: false });
    const big = buildBigOnSmall(phys2D, world);
    run(world, 20);
    return [
      { what: 'sinks', value: big.getPosition()[1] + 11, unit: 'm', limit: 0.005 },
      { what: 'tilts', value: Math.abs(big.getRotation()), unit: 'rad', limit: 1e-3 },
    ];
  },
};
