import { buildArch, buildCardHouse, buildDominoes } from '../../scenes/standing.js';
import { type Claim, type Figure, fastest, run, watch } from './claim.js';

export const arch: Claim = {
  scene: 'arch of 17 wedges with four boxes on it, friction 0.6, 60 s',
  measure(phys2D): Figure[] {
    const world = phys2D.createWorld({ gravity: [0, 10], allowSleeping: false });
    const moved = watch(buildArch(phys2D, world));
    run(world, 60);
    return [{ what: 'farthest move', value: moved(), unit: 'm', limit: 0.05 }];
  },
};

export const cardHouse: Claim = {
  scene: 'house of cards of 2 mm, five storeys, friction 0.7, 30 s',
  measure(phys2D): Figure[] {
    const world = phys2D.createWorld({ gravity: [0, 10], allowSleeping: false });
    const cards = buildCardHouse(phys2D, world);
    const moved = watch(cards);
    run(world, 30);
    return [
      { what: 'farthest move', value: moved(), unit: 'm', limit: 0.1 },
      { what: 'fastest card', value: fastest(cards), unit: 'm/s' },
    ];
  },
};

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
