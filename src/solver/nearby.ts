import type { BroadphaseHandle } from '../broadphase/broadphase.js';
import { sortFirst } from '../math/sort.js';
import { isOlder, type Shape } from '../shape/shape.js';
import type { World } from '../world.js';

/** The result of `findNearby`. */
export class Nearby {
  /** What lies beyond the count is left from before: shortening the list would cost its storage. */
  readonly shapes: Shape[] = [];
  count = 0;
  /** The shapes of so many movers, the first ones, are left out. */
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
 * Lists the shapes that overlap `bounds`, in the order of their ids, as broadphases differ in the order in which they find them. All
 * shapes, or only the static and sleeping ones; without those of the first `passed` movers, and, if all, without those of the body of
 * `own`. @returns how many.
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
