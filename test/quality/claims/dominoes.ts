import { buildDominoes } from '../../scenes/standing.js';
import { type Claim, type Figure, run } from './claim.js';

export const dominoes: Claim = {
  scene: 'row of 15 dominoes',
  measure(phys2D): Figure[] {
    const world = phys2D.createWorld({ gravity: [0, 10], allowSleeping: false });
    const row = buildDominoes(phys2D, world);
    const order: number[] = [];
    run(world, 8, () => {
      row.forEach((domino, i) => {
        if (Math.abs(domino.getRotation()) > 0.5 && !order.includes(i)) {
          order.push(i);
        }
      });
    });
    const wrong = row.filter((_, i) => order[i] !== i).length;
    return [{ what: 'dominoes that do not fall in turn', value: wrong, unit: '', limit: 0 }];
  },
};
