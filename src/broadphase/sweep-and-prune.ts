import type { RectLike } from '../math/vectors.js';
import { type Broadphase, type BroadphaseHandle, badBounds, isRect } from './broadphase.js';

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
  /** The longest extent along x, which bounds how far back a search has to begin. */
  width = 0;
  private sorted = true;

  add(handle: SweepHandle<T>): void {
    handle.index = this.handles.push(handle) - 1;
    this.changed(handle);
  }

  remove(handle: SweepHandle<T>): void {
    const last = this.handles.pop()!;
    if (last !== handle) {
      this.handles[handle.index] = last;
      last.index = handle.index;
      this.sorted = false;
    }
  }

  changed(handle: SweepHandle<T>): void {
    this.width = Math.max(this.width, handle.maxX - handle.minX);
    this.sorted = false;
  }

  clear(): void {
    this.handles.length = 0;
    this.width = 0;
    this.sorted = true;
  }

  /** Insertion sort while the list is nearly sorted; a list that turns out not to be is handed to the library. */
  sort(): void {
    if (this.sorted) {
      return;
    }
    const list = this.handles;
    let budget = 8 * list.length + 64;
    let width = 0;
    for (let i = 0; i < list.length; i += 1) {
      const handle = list[i]!;
      width = Math.max(width, handle.maxX - handle.minX);
      let j = i - 1;
      while (j >= 0 && list[j]!.minX > handle.minX && budget > 0) {
        list[j + 1] = list[j]!;
        j -= 1;
        budget -= 1;
      }
      list[j + 1] = handle;
    }
    if (budget === 0) {
      list.sort((a, b) => (a.minX < b.minX ? -1 : a.minX > b.minX ? 1 : 0));
    }
    for (let i = 0; i < list.length; i += 1) {
      list[i]!.index = i;
      width = Math.max(width, list[i]!.maxX - list[i]!.minX);
    }
    this.width = width;
    this.sorted = true;
  }

  /** Index of the first handle with `minX` >= x, in a sorted list. */
  firstFrom(x: number): number {
    let low = 0;
    let high = this.handles.length;
    while (low < high) {
      const middle = (low + high) >> 1;
      if (this.handles[middle]!.minX >= x) {
        high = middle;
      } else {
        low = middle + 1;
      }
    }
    return low;
  }
}

/**
 * Sweep and prune along x (Baraff 1992): moving and static handles in a list each, sorted by `minX`. At its best where things
 * are spread out along x and of similar width; one very wide static handle makes all static ones be looked at.
 */
export class SweepAndPrune<T = unknown> implements Broadphase<T> {
  static readonly version = 1;

  private readonly moving = new SweepList<T>();
  private readonly still = new SweepList<T>();

  insert(data: T, bounds: RectLike, isStatic: boolean): BroadphaseHandle<T> {
    if (!isRect(bounds)) {
      throw badBounds('SweepAndPrune.insert', bounds);
    }
    const handle = new SweepHandle(data, isStatic);
    handle.set(bounds);
    this.listOf(handle).add(handle);
    return handle;
  }

  update(handle: BroadphaseHandle<T>, bounds: RectLike, isStatic: boolean = handle.isStatic): void {
    if (!isRect(bounds)) {
      throw badBounds('SweepAndPrune.update', bounds);
    }
    const own = this.owned('SweepAndPrune.update', handle);
    own.set(bounds);
    if (isStatic === own.isStatic) {
      this.listOf(own).changed(own);
      return;
    }
    this.listOf(own).remove(own);
    own.isStatic = isStatic;
    this.listOf(own).add(own);
  }

  remove(handle: BroadphaseHandle<T>): void {
    const own = this.owned('SweepAndPrune.remove', handle);
    this.listOf(own).remove(own);
    own.index = -1;
  }

  clear(callback?: (handle: BroadphaseHandle<T>) => void, thisObject?: unknown): void {
    for (const list of [this.moving, this.still]) {
      for (const handle of list.handles) {
        handle.index = -1;
        callback?.call(thisObject, handle);
      }
      list.clear();
    }
  }

  perform(callback: (a: BroadphaseHandle<T>, b: BroadphaseHandle<T>) => void, thisObject?: unknown): void {
    this.moving.sort();
    this.still.sort();
    const list = this.moving.handles;
    for (let i = 0; i < list.length; i += 1) {
      const a = list[i]!;
      for (let j = i + 1; j < list.length; j += 1) {
        const b = list[j]!;
        if (b.minX > a.maxX) break;
        if (b.minY <= a.maxY && b.maxY >= a.minY) {
          callback.call(thisObject, a, b);
        }
      }
      this.performStill(a, callback, thisObject);
    }
  }

  sample(
    bounds: RectLike,
    callback: (handle: BroadphaseHandle<T>, bounds: RectLike) => void,
    thisObject?: unknown,
  ): void {
    if (!isRect(bounds)) {
      throw badBounds('SweepAndPrune.sample', bounds);
    }
    for (const list of [this.moving, this.still]) {
      list.sort();
      for (let i = list.firstFrom(bounds[0]! - list.width); i < list.handles.length; i += 1) {
        const b = list.handles[i]!;
        if (b.minX > bounds[2]!) break;
        if (b.maxX >= bounds[0]! && b.minY <= bounds[3]! && b.maxY >= bounds[1]!) {
          callback.call(thisObject, b, bounds);
        }
      }
    }
  }

  private performStill(
    a: SweepHandle<T>,
    callback: (a: BroadphaseHandle<T>, b: BroadphaseHandle<T>) => void,
    thisObject: unknown,
  ): void {
    const list = this.still.handles;
    for (let i = this.still.firstFrom(a.minX - this.still.width); i < list.length; i += 1) {
      const b = list[i]!;
      if (b.minX > a.maxX) break;
      if (b.maxX >= a.minX && b.minY <= a.maxY && b.maxY >= a.minY) {
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
