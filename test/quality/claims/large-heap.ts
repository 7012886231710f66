import type { RigidBody, Vec2 } from '../../../src/index.js';
import { generator } from '../../scenes/mixed.js';
import { add, addGround, addWalls, plainMaterial } from '../../scenes/stacks.js';
import { type Claim, type Figure, meanSpeed, run } from './claim.js';
import { deepestOverlap } from './overlap.js';

const COLUMNS = 45;
const ROWS = 90;

/** So many circles that those below carry 50 layers, and that what is pushed apart has all of them to lift. */
export const largeHeap: Claim = {
  scene: '4,050 circles that fall into a bucket from up to 90 m, after 10 s',
  measure(phys2D): Figure[] {
    const world = phys2D.createWorld({ gravity: [0, 10], allowSleeping: false });
    const material = plainMaterial(phys2D, 0.6);
    addGround(phys2D, world, 0.6);
    addWalls(phys2D, world, 0.6, { x: 29, width: 2, height: 200, below: 10 });
    const random = generator(1);
    const circles: RigidBody[] = [];
    const radii: number[] = [];
    for (let i = 0; i < COLUMNS * ROWS; i += 1) {
      const radius = 0.3 + 0.2 * random();
      const x = 1.2 * ((i % COLUMNS) - 0.5 * (COLUMNS - 1)) + 0.2 * (random() - 0.5);
      const position: Vec2 = [x, -0.6 - Math.floor(i / COLUMNS)];
      circles.push(add(phys2D, world, phys2D.createCircleShape({ radius, material }), position));
      radii.push(radius);
    }
    run(world, 10);
    const overlap = deepestOverlap(circles, (_, i) => ({ radius: radii[i]! }));
    return [
      { what: 'deepest overlap', value: overlap, unit: 'm', limit: 0.01 },
      { what: 'speed, root of the mean square', value: meanSpeed(circles), unit: 'm/s', limit: 0.2 },
    ];
  },
};
