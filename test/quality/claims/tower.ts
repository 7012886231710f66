import type { Claim, Figure } from './claim.js';
import { stand } from './stand.js';

export const tower: Claim = {
  scene: 'tower of 15 boxes, offsets ±1 cm, friction 0.3, dropped from 1.1 m spacing, 30 s',
  measure(phys2D): Figure[] {
    const { top, sideways, speed, fell } = stand(phys2D, { count: 15, offset: 0.01, friction: 0.3, spacing: 1.1 }, 30);
    return [
      { what: 'towers that fell', value: fell, unit: '', limit: 0 },
      { what: 'top too low by', value: top, unit: 'm', limit: 0.035 },
      { what: 'moved sideways', value: sideways, unit: 'm', limit: 0.02 },
      { what: 'fastest box', value: speed, unit: 'm/s', limit: 1e-4 },
    ];
  },
};
