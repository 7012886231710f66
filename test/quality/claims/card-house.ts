import { buildCardHouse } from '../../scenes/standing.js';
import { type Claim, type Figure, fastest, run, watch } from './claim.js';

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
