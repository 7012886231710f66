import type { Physics2DDevice, RigidBody } from '../../../src/index.js';
import { buildPyramid } from '../../scenes/pyramid.js';
import { buildBigOnSmall, buildHeavyPyramids, buildTower, type TowerParams } from '../../scenes/stacks.js';
import { type Claim, type Figure, fastest, run, SLOP, watch } from './claim.js';
import { deepestOverlap } from './overlap.js';

interface Stood {
  /** m. How much lower the topmost box is than in a tower of rigid boxes. */
  readonly top: number;
  /** m. How much farther from the axis the worst box is than at the start. */
  readonly sideways: number;
  /** m/s. The fastest box at the end. */
  readonly speed: number;
  readonly fell: number;
}

/** A tower, without sleep, after some seconds. */
function stand(phys2D: Physics2DDevice, params: TowerParams, seconds: number): Stood {
  const world = phys2D.createWorld({ gravity: [0, 10], allowSleeping: false });
  const boxes = buildTower(phys2D, world, params);
  const starts = boxes.map((body) => body.getPosition()[0]);
  run(world, seconds);
  const drift = (body: RigidBody, i: number): number => Math.abs(body.getPosition()[0]) - Math.abs(starts[i]!);
  const top = boxes.at(-1)!.getPosition()[1] + params.count - 0.5;
  return {
    top,
    sideways: Math.max(...boxes.map(drift)),
    speed: fastest(boxes),
    fell: Math.abs(top) < 0.9 ? 0 : 1,
  };
}

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

export const heavyPyramids: Claim = {
  scene: 'three pyramids of ten rows, tops of 100, 200 and 300 times the density, 20 s',
  measure(phys2D): Figure[] {
    const world = phys2D.createWorld({ gravity: [0, 10], allowSleeping: false });
    const tops = buildHeavyPyramids(phys2D, world);
    run(world, 20);
    const fell = tops.filter((top) => top.getPosition()[1] > -9).length;
    return [{ what: 'pyramids that fell', value: fell, unit: '', limit: 0 }];
  },
};

export const bigOnSmall: Claim = {
  scene: 'box of 20 m on two of 1 m, 400 : 1, 20 s',
  measure(phys2D): Figure[] {
    const world = phys2D.createWorld({ gravity: [0, 10], allowSleeping: false });
    const big = buildBigOnSmall(phys2D, world);
    run(world, 20);
    return [
      { what: 'sinks', value: big.getPosition()[1] + 11, unit: 'm', limit: 0.005 },
      { what: 'tilts', value: Math.abs(big.getRotation()), unit: 'rad', limit: 1e-3 },
    ];
  },
};

export const pyramid: Claim = {
  scene: 'pyramid of 1 m boxes, base 20, 20 s',
  measure(phys2D): Figure[] {
    const world = phys2D.createWorld({ gravity: [0, 10], allowSleeping: false });
    const boxes = buildPyramid(phys2D, world, 20);
    const moved = watch(boxes);
    run(world, 20);
    return [
      { what: 'farthest move', value: moved(), unit: 'm', limit: 0.01 },
      { what: 'deepest overlap', value: deepestOverlap(boxes, () => ({ size: 1 })), unit: 'm', limit: 2 * SLOP },
      { what: 'fastest box', value: fastest(boxes), unit: 'm/s' },
    ];
  },
};

export const largePyramid: Claim = {
  scene: 'pyramid of 1 m boxes, base 100, 500 steps',
  measure(phys2D): Figure[] {
    const world = phys2D.createWorld({ gravity: [0, 10], allowSleeping: false });
    const boxes = buildPyramid(phys2D, world, 100);
    const moved = watch(boxes);
    run(world, 500 / 60);
    return [
      { what: 'farthest move', value: moved(), unit: 'm' },
      { what: 'deepest overlap', value: deepestOverlap(boxes, () => ({ size: 1 })), unit: 'm', limit: 2 * SLOP },
    ];
  },
};
