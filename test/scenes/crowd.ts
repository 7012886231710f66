import type { Physics2DDevice, RigidBody, World } from '../../src/index.js';
import { generator } from './mixed.js';
import { addBucket, mixedOutline } from './speed/piles.js';
import { Heap } from './speed/scene.js';

/** m. Side of the bucket. */
export const CROWD_SIDE = 56;

/** So many circles and polygons that fall into a bucket, over pegs. @returns them. */
export function buildCrowd(phys2D: Physics2DDevice, world: World, count = 5000): RigidBody[] {
  addBucket(new Heap(phys2D, world), CROWD_SIDE);
  const pegs = new Heap(phys2D, world);
  for (let i = 0; i < 26; i += 1) {
    const row = Math.floor(i / 13);
    pegs.add([{ radius: 0.9 }], [4 * ((i % 13) - 6) + 2 * (row % 2), -26 - 6 * row], { type: 'static' });
  }
  const heap = new Heap(phys2D, world, { friction: 0.4, elasticity: 0.1 });
  const random = generator(9);
  const columns = 66;
  for (let i = 0; i < count; i += 1) {
    const x = 0.8 * ((i % columns) - (columns - 1) / 2) + 0.1 * random();
    heap.add([mixedOutline(random)], [x, -37 - 0.8 * Math.floor(i / columns)], { rotation: 6 * random() });
  }
  return heap.bodies;
}
