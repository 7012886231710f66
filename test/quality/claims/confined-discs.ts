import type { RigidBody, Vec2 } from '../../../src/index.js';
import { add, plainMaterial } from '../../scenes/stacks.js';
import { type Claim, type Figure, fastest, LEFT, run } from './claim.js';
import { deepestOverlap } from './overlap.js';

export const confinedDiscs: Claim = {
  scene: '625 overlapping discs confined by walls, no gravity',
  measure(phys2D): Figure[] {
    const world = phys2D.createWorld({ gravity: [0, 0], allowSleeping: false });
    const material = plainMaterial(phys2D, 0.6);
    const wall = (width: number, height: number, position: Vec2): void => {
      const shape = phys2D.createPolygonShape({ vertices: phys2D.createBoxVertices(width, height), material });
      add(phys2D, world, shape, position, { type: 'static' });
    };
    // 25 × 25 discs of 1 m in a box of 26 m, created 0.75 m apart.
    wall(30, 2, [0, -14]);
    wall(30, 2, [0, 14]);
    wall(2, 30, [-14, 0]);
    wall(2, 30, [14, 0]);
    const discs: RigidBody[] = [];
    for (let row = 0; row < 25; row += 1) {
      for (let i = 0; i < 25; i += 1) {
        const shape = phys2D.createCircleShape({ radius: 0.5, material });
        discs.push(add(phys2D, world, shape, [(i - 12) * 0.75, (row - 12) * 0.75]));
      }
    }
    let peak = 0;
    run(world, 2, () => {
      peak = Math.max(peak, fastest(discs));
    });
    const overlap = deepestOverlap(discs, () => ({ radius: 0.5 }), false);
    return [
      { what: 'fastest disc ever', value: peak, unit: 'm/s', limit: 1 },
      { what: 'overlap after 2 s', value: overlap, unit: 'm', limit: LEFT },
    ];
  },
};
