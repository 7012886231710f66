import { generator } from '../../scenes/mixed.js';
import { add, buildTower, plainMaterial } from '../../scenes/stacks.js';
import { type Claim, type Figure, run } from './claim.js';

/** What stands beside a tower is solved with it: that must not take from it what it needs. */
export const heavyTopInHeap: Claim = {
  scene: 'tower of 10 boxes with a dense one on top, between heaps of 50 boxes, 20 s',
  measure(phys2D): Figure[] {
    return [50, 100, 200].map((topDensity) => {
      const world = phys2D.createWorld({ gravity: [0, 10], allowSleeping: false });
      const tower = buildTower(phys2D, world, { count: 10, offset: 0, friction: 0.6, topDensity });
      const random = generator(1);
      const material = plainMaterial(phys2D, 0.6);
      for (let i = 0; i < 100; i += 1) {
        const column = Math.floor(i / 2) % 8;
        const x = (i % 2 === 0 ? -1 : 1) * (2.5 + column + 0.3 * random());
        const shape = phys2D.createPolygonShape({ vertices: phys2D.createBoxVertices(1, 1), material });
        add(phys2D, world, shape, [x, -0.5 - 1.05 * Math.floor(i / 16)]);
      }
      run(world, 20);
      const value = tower.at(-1)!.getPosition()[1] + 9.5;
      return { what: `top of ${topDensity} × the density too low by`, value, unit: 'm', limit: 0.07 };
    });
  },
};
