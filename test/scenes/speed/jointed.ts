import type { Physics2DDevice, World } from '../../../src/index.js';
import { buildChains, buildJointGrid, type Jointed, worstGap } from '../joint-grid.js';
import type { SpeedScene } from './scene.js';

function jointed(title: string, build: (phys2D: Physics2DDevice, world: World) => Jointed): SpeedScene {
  return {
    title,
    figure: 'widest gap, mm',
    warmUp: 60,
    steps: 240,
    steady: true,
    start(phys2D) {
      const world = phys2D.createWorld({ gravity: [0, 10], allowSleeping: false });
      const { joints } = build(phys2D, world);
      return { world, quality: () => 1000 * worstGap(joints) };
    },
  };
}

export function gridOf(size: number): SpeedScene {
  return jointed(`net of ${size} × ${size} discs`, (phys2D, world) => buildJointGrid(phys2D, world, size));
}

export const chains = jointed('100 chains of 20 links', (phys2D, world) => buildChains(phys2D, world, 100, 20));
