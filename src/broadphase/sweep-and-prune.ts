import type { RectLike } from '../math/vectors.js';
import { boolean, callable, callbackOf } from '../validate.js';
import {
  type Broadphase,
  type BroadphaseFilter,
  type BroadphaseHandle,
  checkInsert,
  checkRect,
  UNFILTERED,
} from './broadphase.js';

/** A handle of {@link SweepAndPrune}. */
class SweepHandle<T> implements BroadphaseHandle<T> {
  minX = 0;
  minY = 0;
  maxX = 0;
  maxY = 0;
  /** Index in the list of its kind; −1 once removed. */
  index = -1;

  constructor(
    public data: T,
    public isStatic: boolean,
    readonly group: unknown,
  ) {}

  set(bounds: RectLike): void {
    this.minX = bounds[0]!;
    this.minY = bounds[1]!;
    this.maxX = bounds[2]!;
    this.maxY = bounds[3]!;
  }
}

/** Handles sorted by `minX` when asked for. */
class SweepList<T> {
  readonly handles: SweepHandle<T>[] = [];
  /** Of the sorted list: the largest `maxX` of each handle and all before it. */
  private readonly reach: number[] = [];
  sorted = true;

  add(handle: SweepHandle<T>): void {
    handle.index = this.handles.push(handle) - 1;
    this.sorted = false;
  }

  remove(handle: SweepHandle<T>): void {
    const last = this.handles.pop()!;
    if (last !== handle) {
      this.handles[handle.index] = last;
      last.index = handle.index;
      this.sorted = false;
    }
  }

  clear(): void {
    for (const handle of this.handles) {
      handle.index = -1;
    }
    this.handles.length = 0;
    this.sorted = true;
  }

  /** Insertion sort, as the list is nearly sorted; if it turns out not to be, the sort of the library. */
  sort(): void {
    if (this.sorted) {
      return;
    }
    const list = this.handles;
    let budget = 8 * list.length + 64;
    for (let i = 0; i < list.length; i += 1) {
      const handle = list[i]!;
      let j = i - 1;
      while (j >= 0 && list[j]!.minX > handle.minX && budget > 0) {
        list[j + 1] = list[j]!;
        j -= 1;
        budget -= 1;
      }
      list[j + 1] = handle;
    }
    if (budget === 0) {
      // Of two infinite ones the difference is NaN.
      list.sort((a, b) => a.minX - b.minX || 0);
    }
    let reach = -Infinity;
    for (let i = 0; i < list.length; i += 1) {
      list[i]!.index = i;
      reach = Math.max(reach, list[i]!.maxX);
      this.reach[i] = reach;
    }
    this.sorted = true;
  }

  /** Index of the first handle in the sorted list that reaches x: none before it can overlap what begins there. */
  firstThatReaches(x: number): number {
    let low = 0;
    let high = this.handles.length;
    while (low < high) {
      const middle = (low + high) >> 1;
      if (this.reach[middle]! >= x) {
        high = middle;
      } else {
        low = middle + 1;
      }
    }
    return low;
  }
}

/**
 * Sweep and prune along x (Baraff 1992): a list of moving and a list of static handles, each sorted by `minX`. At its best where items are
 * spread out along x and of similar width; one very wide static handle makes all static ones behind its start be looked at.
 */
export class SweepAndPrune<T = unknown> implements Broadphase<T> {
  /** Of the class, as in Turbulenz. */
  static get version(): number {
    return 1;
  }

  private readonly moving = new SweepList<T>();
  private readonly still = new SweepList<T>();

  insert(
    data: T,
    bounds: RectLike,
    isStatic: boolean,
    group: unknown = {},
    filter: BroadphaseFilter = UNFILTERED,
  ): BroadphaseHandle<T> {
    checkInsert('SweepAndPrune.insert', bounds, isStatic, filter);
    const handle = new SweepHandle(data, isStatic, group);
    handle.set(bounds);
    this.listOf(handle).add(handle);
    return handle;
  }

  update(handle: BroadphaseHandle<T>, bounds: RectLike, isStatic?: boolean): void {
    checkRect('SweepAndPrune.update', bounds);
    const own = this.owned('SweepAndPrune.update', handle);
    const becomesStatic = isStatic === undefined ? own.isStatic : boolean('SweepAndPrune.update', 'isStatic', isStatic);
    own.set(bounds);
    if (becomesStatic === own.isStatic) {
      this.listOf(own).sorted = false;
      return;
    }
    this.listOf(own).remove(own);
    own.isStatic = becomesStatic;
    this.listOf(own).add(own);
  }

  remove(handle: BroadphaseHandle<T>): void {
    const own = this.owned('SweepAndPrune.remove', handle);
    this.listOf(own).remove(own);
    own.index = -1;
  }

  clear(callback?: (handle: BroadphaseHandle<T>) => void, thisObject?: unknown): void {
    const call = callbackOf('SweepAndPrune.clear', callback);
    try {
      for (const handle of [...this.moving.handles, ...this.still.handles]) {
        call?.call(thisObject, handle);
      }
    } finally {
      this.moving.clear();
      this.still.clear();
    }
  }

  perform(callback: (a: BroadphaseHandle<T>, b: BroadphaseHandle<T>) => unknown, thisObject?: unknown): void {
    callable('SweepAndPrune.perform', 'callback', callback);
    this.moving.sort();
    this.still.sort();
    const list = this.moving.handles;
    for (let i = 0; i < list.length; i += 1) {
      const a = list[i]!;
      this.report(a, list, i + 1, callback, thisObject);
      this.report(a, this.still.handles, this.still.firstThatReaches(a.minX), callback, thisObject);
    }
  }

  sample(
    bounds: RectLike,
    callback: (handle: BroadphaseHandle<T>, bounds: RectLike) => void,
    thisObject?: unknown,
  ): void {
    checkRect('SweepAndPrune.sample', bounds);
    callable('SweepAndPrune.sample', 'callback', callback);
    // Read before any callback, which may write to it.
    const minX = bounds[0]!;
    const minY = bounds[1]!;
    const maxX = bounds[2]!;
    const maxY = bounds[3]!;
    for (let kind = 0; kind < 2; kind += 1) {
      const list = kind === 0 ? this.moving : this.still;
      list.sort();
      // What a callback inserts comes after those that were there.
      const count = list.handles.length;
      for (let i = list.firstThatReaches(minX); i < count && i < list.handles.length; i += 1) {
        const b = list.handles[i]!;
        if (b.minX > maxX) break;
        if (b.maxX >= minX && b.minY <= maxY && b.maxY >= minY) {
          callback.call(thisObject, b, bounds);
        }
      }
    }
  }

  /** Reports a handle with each handle of a sorted list, from an index on, that overlaps it. */
  private report(
    a: SweepHandle<T>,
    list: readonly SweepHandle<T>[],
    from: number,
    callback: (a: BroadphaseHandle<T>, b: BroadphaseHandle<T>) => unknown,
    thisObject: unknown,
  ): void {
    for (let i = from; i < list.length; i += 1) {
      const b = list[i]!;
      if (b.minX > a.maxX) break;
      if (b.maxX >= a.minX && b.minY <= a.maxY && b.maxY >= a.minY && b.group !== a.group) {
        callback.call(thisObject, a, b);
      }
    }
  }

  private listOf(handle: SweepHandle<T>): SweepList<T> {
    return handle.isStatic ? this.still : this.moving;
  }

  private owned(where: string, handle: BroadphaseHandle<T>): SweepHandle<T> {
    const own = handle as SweepHandle<T>;
    if (!(own instanceof SweepHandle) || this.listOf(own).handles[own.index] !== own) {
      throw new TypeError(`${where}: handle must be one of this broadphase, and not removed`);
    }
    return own;
  }
}
