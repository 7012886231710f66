import { buildJointGrid, worstGap } from '../../scenes/joint-grid.js';
import { type Claim, type Figure, run } from './claim.js';

export const jointGrid: Claim = {
  scene: 'net of 40 × 40 and of 100 × 100 discs, 10 s and 5 s',
  measure(phys2D): Figure[] {
    return [
      [40, 10, 0.01],
      [100, 5, 0.05],
    ].map(([size, seconds, limit]) => {
      const world = phys2D.createWorld({ gravity: [0, 10], allowSleeping: false });
      const { joints } = buildJointGrid(phys2D, world, size!);
      let gap = 0;
      run(world, seconds!, () => {
        gap = Math.max(gap, worstGap(joints));
      });
      return { what: `widest gap, ${size} × ${size}`, value: gap, unit: 'm', limit: limit! };
    });
  },
};
