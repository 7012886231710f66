import type { TowerParams } from '../../scenes/stacks.js';
import type { Claim, Figure } from './claim.js';
import { stand } from './stand.js';

const OTHERS: readonly (readonly [string, TowerParams])[] = [
  ['25 boxes, ±5 mm', { count: 25, offset: 0.005, friction: 0.6 }],
  ['20 boxes, ±1 cm', { count: 20, offset: 0.01, friction: 0.6 }],
  ['15 boxes, ±2 cm', { count: 15, offset: 0.02, friction: 0.6 }],
  ['12 boxes, ±1 cm', { count: 12, offset: 0.01, friction: 0.6 }],
  ['10 boxes, ±3 cm, friction 0.4', { count: 10, offset: 0.03, friction: 0.4 }],
  ['15 boxes, exact', { count: 15, offset: 0, friction: 0.6 }],
  ['15 boxes, ±5 mm, friction 0.3', { count: 15, offset: 0.005, friction: 0.3 }],
];

export const otherTowers: Claim = {
  scene: 'seven other towers, dropped from 1.1 m spacing, 60 s',
  measure(phys2D): Figure[] {
    return OTHERS.flatMap(([what, params]) => {
      const { sideways, speed, fell } = stand(phys2D, { ...params, spacing: 1.1 }, 60);
      return [
        { what: `${what}: moved sideways`, value: fell === 0 ? sideways : Infinity, unit: 'm', limit: 0.02 },
        { what: `${what}: fastest box`, value: speed, unit: 'm/s', limit: 1e-3 },
      ];
    });
  },
};
