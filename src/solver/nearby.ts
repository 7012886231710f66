import type { BroadphaseHandle } from '../broadphase/broadphase.js';
import { sortFirst } from '../math/sort.js';
import { isOlder, type Shape } from '../shape/shape.js';
import type { World } from '../world.js';

/** Shapes of a world that were found near something. */
export class Nearby {
  /** What was found last. What lies beyond the count is left from before: shortening the list would cost its storage. */
  readonly shapes: Shape[] = [];
  count = 0;

  readonly gather = (handle: BroadphaseHandle): void => {
    this.shapes[this.count] = handle.data as Shape;
    this.count += 1;
  };

  readonly gatherStatic = (handle: BroadphaseHandle): void => {
    if (handle.isStatic) {
      this.gather(handle);
    }
  };
}

/**
 * Lists the shapes that have something to do with `bounds`, by their ids, as broadphases differ in the order in which they find them: all,
 * or the static and sleeping ones. @returns how many.
 */
export function findNearby({ broadphase, movers }: World, bounds: Float64Array, all: boolean): number {
  const { nearby } = movers;
  nearby.count = 0;
  if (all) {
    broadphase.sample(bounds, nearby.gather);
  } else if (broadphase.sampleStatic === undefined) {
    broadphase.sample(bounds, nearby.gatherStatic);
  } else {
    broadphase.sampleStatic(bounds, nearby.gather);
  }
  sortFirst(nearby.shapes, nearby.count, isOlder);
  return nearby.count;
}
