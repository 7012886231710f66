import type { Claim, Figure } from './claim.js';
import { stand } from './stand.js';

export const heavyTop: Claim = {
  scene: 'tower of 10 boxes with a dense one on top, 30 s',
  measure(phys2D): Figure[] {
    return [
      [10, 0.015],
      [100, 0.07],
    ].map(([topDensity, limit]) => {
      const { top } = stand(phys2D, { count: 10, offset: 0, friction: 0.6, topDensity: topDensity! }, 30);
      return { what: `top of ${topDensity} × the density too low by`, value: top, unit: 'm', limit: limit! };
    });
  },
};
