import type { BroadphaseHandle } from '../broadphase/broadphase.js';
import type { Shape } from '../shape/shape.js';
import type { World } from '../world.js';

/** What was found last. What lies beyond the count is left from before: shortening the list would cost its storage. */
export const nearby: Shape[] = [];
let count = 0;

/** More are sorted by the library, which needs room for that. */
const FEW = 64;

function gather(handle: BroadphaseHandle): void {
  nearby[count] = handle.data as Shape;
  count += 1;
}

/**
 * Puts into `nearby` the shapes that have something to do with `bounds`, by their ids, as broadphases differ in the order in which they find them: all,
 * or at least the static and sleeping ones. @returns how many.
 */
export function findNearby({ broadphase }: World, bounds: Float64Array, all: boolean): number {
  count = 0;
  if (all || broadphase.sampleStatic === undefined) {
    broadphase.sample(bounds, gather);
  } else {
    broadphase.sampleStatic(bounds, gather);
  }
  if (count > FEW) {
    nearby.length = count;
    nearby.sort(compare);
  } else {
    sortFew();
  }
  return count;
}

function compare(a: Shape, b: Shape): number {
  return a.id - b.id;
}

function sortFew(): void {
  for (let i = 1; i < count; i += 1) {
    const shape = nearby[i]!;
    let k = i;
    while (k > 0 && nearby[k - 1]!.id > shape.id) {
      nearby[k] = nearby[k - 1]!;
      k -= 1;
    }
    nearby[k] = shape;
  }
}
