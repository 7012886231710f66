import type { RigidBody } from '../../../src/index.js';
import { add, addGround, plainMaterial } from '../../scenes/stacks.js';
import { type Claim, type Figure, fastest, LEFT, run } from './claim.js';
import { deepestOverlap } from './overlap.js';

export const overlappingPyramid: Claim = {
  scene: 'pyramid of four rows created 25 % overlapped',
  measure(phys2D): Figure[] {
    const world = phys2D.createWorld({ gravity: [0, 10], allowSleeping: false });
    addGround(phys2D, world, 0.6);
    const boxes: RigidBody[] = [];
    for (let row = 0; row < 4; row += 1) {
      for (let i = 0; i < 4 - row; i += 1) {
        const vertices = phys2D.createBoxVertices(1, 1);
        const shape = phys2D.createPolygonShape({ vertices, material: plainMaterial(phys2D, 0.6) });
        boxes.push(add(phys2D, world, shape, [(i - (3 - row) / 2) * 0.75, -0.25 - 0.75 * row]));
      }
    }
    let peak = 0;
    run(world, 2, () => {
      peak = Math.max(peak, fastest(boxes));
    });
    return [
      { what: 'fastest box ever', value: peak, unit: 'm/s', limit: 0.1 },
      { what: 'overlap after 2 s', value: deepestOverlap(boxes, () => ({ size: 1 })), unit: 'm', limit: LEFT },
    ];
  },
};
