import type { RigidBody } from '../../../src/index.js';
import { generator } from '../../scenes/mixed.js';
import { add, addGround, addWalls, plainMaterial } from '../../scenes/stacks.js';
import { type Claim, type Figure, meanSpeed, run } from './claim.js';

const COLUMNS = 39;
const ROWS = 77;

/** Without friction a heap carries its load by normal impulses alone. If it is pushed apart as fast as it falls, it never does. */
export const slipperyHeap: Claim = {
  scene: '3,003 mixed shapes without friction that fall into a bucket, after 9 s',
  measure(phys2D): Figure[] {
    const world = phys2D.createWorld({ gravity: [0, 10], allowSleeping: false });
    const material = plainMaterial(phys2D, 0);
    addGround(phys2D, world, 0);
    addWalls(phys2D, world, 0, { x: 26, width: 2, height: 300, below: 10 });
    const random = generator(1);
    const bodies: RigidBody[] = [];
    for (let i = 0; i < COLUMNS * ROWS; i += 1) {
      const radius = 0.25 + 0.25 * random();
      const sides = 2 + Math.floor(7 * random());
      const vertices = phys2D.createRegularPolygonVertices(2 * radius, 2 * radius, Math.max(sides, 3));
      const shape =
        sides < 3 ? phys2D.createCircleShape({ radius, material }) : phys2D.createPolygonShape({ vertices, material });
      const x = 1.2 * ((i % COLUMNS) - 0.5 * (COLUMNS - 1)) + 0.1 * (random() - 0.5);
      bodies.push(add(phys2D, world, shape, [x, -0.7 - 1.2 * Math.floor(i / COLUMNS)], { rotation: 6 * random() }));
    }
    run(world, 9);
    const sunk = bodies.reduce((sum, body) => sum + body.getPosition()[1], 0) / bodies.length;
    return [
      { what: 'speed, root of the mean square', value: meanSpeed(bodies), unit: 'm/s', limit: 0.2 },
      { what: 'middle of the heap, under a height of 12 m', value: 12 + sunk, unit: 'm', limit: 1.5 },
    ];
  },
};
