import type { BroadphaseHandle } from '../broadphase/broadphase.js';
import { sortFirst } from '../math/sort.js';
import { isOlder, type Shape } from '../shape/shape.js';
import type { World } from '../world.js';

/** What was found last. What lies beyond the count is left from before: shortening the list would cost its storage. */
export const nearby: Shape[] = [];
let count = 0;

function gather(handle: BroadphaseHandle): void {
  nearby[count] = handle.data as Shape;
  count += 1;
}

function gatherStatic(handle: BroadphaseHandle): void {
  if (handle.isStatic) {
    gather(handle);
  }
}

/**
 * Puts into `nearby` the shapes that have something to do with `bounds`, by their ids, as broadphases differ in the order in which they find them: all,
 * or the static and sleeping ones. @returns how many.
 */
export function findNearby({ broadphase }: World, bounds: Float64Array, all: boolean): number {
  count = 0;
  if (all) {
    broadphase.sample(bounds, gather);
  } else if (broadphase.sampleStatic === undefined) {
    broadphase.sample(bounds, gatherStatic);
  } else {
    broadphase.sampleStatic(bounds, gather);
  }
  sortFirst(nearby, count, isOlder);
  return count;
}
