import type { BroadphaseHandle } from '../broadphase/broadphase.js';
import { sortFirst } from '../math/sort.js';
import { isOlder, type Shape } from '../shape/shape.js';
import type { World } from '../world.js';

/** Shapes of a world that were found near something. */
export class Nearby {
  /** What was found last. What lies beyond the count is left from before: shortening the list would cost its storage. */
  readonly shapes: Shape[] = [];
  count = 0;
  /** Of the movers so many, the first ones, are left out. */
  passed = 0;

  readonly gather = ({ data }: BroadphaseHandle): void => {
    const shape = data as Shape;
    const { mover } = shape.owner!;
    if (mover < 0 || mover >= this.passed) {
      this.shapes[this.count] = shape;
      this.count += 1;
    }
  };

  readonly gatherStatic = (handle: BroadphaseHandle): void => {
    if (handle.isStatic) {
      this.gather(handle);
    }
  };
}

/**
 * Lists the shapes that have something to do with `bounds`, by their ids, as broadphases differ in the order in which they find them: all,
 * or the static and sleeping ones; but for the first `passed` movers and, of all, those of the body of a shape. @returns how many.
 */
export function findNearby(
  { broadphase, movers }: World,
  bounds: Float64Array,
  all: boolean,
  passed = 0,
  own: Shape | null = null,
): number {
  const { nearby } = movers;
  nearby.count = 0;
  nearby.passed = passed;
  if (all) {
    broadphase.sample(bounds, nearby.gather, undefined, own?.handle ?? undefined);
  } else if (broadphase.sampleStatic === undefined) {
    broadphase.sample(bounds, nearby.gatherStatic);
  } else {
    broadphase.sampleStatic(bounds, nearby.gather);
  }
  sortFirst(nearby.shapes, nearby.count, isOlder);
  return nearby.count;
}
