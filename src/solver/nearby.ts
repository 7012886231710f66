import type { BroadphaseHandle } from '../broadphase/broadphase.js';
import type { Shape } from '../shape/shape.js';
import type { World } from '../world.js';

let nearby: Shape[] = [];

function gather(handle: BroadphaseHandle): void {
  nearby.push(handle.data as Shape);
}

/**
 * The shapes that have something to do with `bounds`, by their ids, as broadphases differ in the order in which they find them: all, or at least the
 * static and sleeping ones. Empty lists are all the same.
 */
export function shapesWithin({ broadphase }: World, bounds: Float64Array, all: boolean): Shape[] {
  nearby.length = 0;
  if (all || broadphase.sampleStatic === undefined) {
    broadphase.sample(bounds, gather);
  } else {
    broadphase.sampleStatic(bounds, gather);
  }
  if (nearby.length === 0) {
    return nearby;
  }
  const found = nearby;
  nearby = [];
  return found.sort((a, b) => a.id - b.id);
}
