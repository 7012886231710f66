import type { RectLike, Vec2Like } from '../math/vectors.js';
import { boolean, notNaN, rangeError, typeError } from '../validate.js';

/** A thing in a broadphase. */
export interface BroadphaseHandle<T = unknown> {
  /** What was inserted. */
  data: T;
  /** Two static handles never make a pair. */
  readonly isStatic: boolean;
}

/** Which things make pairs: those of which each one's `group` has a bit in common with the other one's `mask`. */
export interface BroadphaseFilter {
  /** Bits that say what it is. */
  readonly group: number;
  /** Bits of the groups that it meets. */
  readonly mask: number;
}

/** Whether two filters let things make a pair. */
export function letsMeet(a: BroadphaseFilter, b: BroadphaseFilter): boolean {
  return (a.group & b.mask) !== 0 && (b.group & a.mask) !== 0;
}

/** Of things without a filter. */
export const UNFILTERED: BroadphaseFilter = { group: -1, mask: -1 };

/**
 * Finds things whose bounds overlap; knows nothing of shapes. Usable on its own, with any data; the same data may be
 * inserted many times. Bounds are `[minX, minY, maxX, maxY]`, copied, may be infinite; bounds that touch overlap. Any object
 * with these methods may be given to `createWorld`: the choice does not change results, only their cost.
 *
 * Callbacks of `perform` and `sample` may query, but must not modify.
 */
export interface Broadphase<T = unknown> {
  /**
   * Adds a thing. Things of the same `group`, whatever that is, never make a pair: the world gives shapes their body as theirs. What the filters of two
   * keep apart need make no pair either: the world gives shapes themselves as theirs. A filter may change, which `refilter` tells.
   * @throws TypeError or RangeError unless `bounds` is a rectangle, and `filter` has its numbers.
   */
  insert(data: T, bounds: RectLike, isStatic: boolean, group?: unknown, filter?: BroadphaseFilter): BroadphaseHandle<T>;

  /** Gives a handle new bounds, and another kind if `isStatic` is given. */
  update(handle: BroadphaseHandle<T>, bounds: RectLike, isStatic?: boolean): void;

  /** Removes a handle; it may be reused by a later `insert`. */
  remove(handle: BroadphaseHandle<T>): void;

  /** Removes everything, after calling back once per handle; also if a callback throws. */
  clear(callback?: (handle: BroadphaseHandle<T>) => void, thisObject?: unknown): void;

  /**
   * Reports each pair of overlapping handles once, in any order, except pairs of static ones and of one group. Given `isKnown`, a broadphase may
   * keep the integer that `callback` returns for a pair, other than 0, as long as the pair is reported in every call, and then ask
   * `isKnown(integer)` first: if that is `true` the pair is not reported.
   */
  perform(
    callback: (a: BroadphaseHandle<T>, b: BroadphaseHandle<T>) => unknown,
    thisObject?: unknown,
    isKnown?: (note: number) => boolean,
  ): void;

  /** Reports each handle that overlaps `bounds` once, static or not. Those of the group of `like`, if given, need not be reported. */
  sample(
    bounds: RectLike,
    callback: (handle: BroadphaseHandle<T>, bounds: RectLike) => void,
    thisObject?: unknown,
    like?: BroadphaseHandle<T>,
  ): void;

  /** Needed if pairs are left out for their filters: that of a handle has changed. */
  refilter?(handle: BroadphaseHandle<T>): void;

  /** Not needed, but makes continuous collision fast: as `sample`, static handles only. Called by the engine; checks nothing. */
  sampleStatic?(bounds: RectLike, callback: (handle: BroadphaseHandle<T>, bounds: RectLike) => void): void;

  /**
   * Not needed, but makes ray and shape casts fast: visits each handle whose bounds may meet the bounds `start` + direction · f, 0 ≤ f ≤ `limit`, nearer ones
   * as early as is cheap. `visit` returns up to where the way matters from then on. Called by the engine; checks nothing.
   */
  cast?(start: RectLike, direction: Vec2Like, limit: number, visit: (handle: BroadphaseHandle<T>) => number): void;
}

/** Refuses what no broadphase can insert: bounds as `checkRect` does, a filter that has not both numbers. */
export function checkInsert(where: string, bounds: RectLike, isStatic: boolean, filter: BroadphaseFilter): void {
  checkRect(where, bounds);
  boolean(where, 'isStatic', isStatic);
  const { group, mask } = (filter ?? {}) as Partial<BroadphaseFilter>;
  if (typeof group !== 'number' || typeof mask !== 'number') {
    throw typeError(where, 'filter', 'an object with the numbers group and mask', filter);
  }
}

/** Refuses what is not four numbers that are a rectangle. */
export function checkRect(where: string, bounds: RectLike, name = 'bounds'): void {
  if (!isRect(bounds)) {
    throw badBounds(where, name, bounds);
  }
}

/** False for NaN. */
function isRect(bounds: RectLike): boolean {
  return (
    typeof bounds === 'object' &&
    bounds !== null &&
    typeof bounds[0] === 'number' &&
    typeof bounds[1] === 'number' &&
    typeof bounds[2] === 'number' &&
    typeof bounds[3] === 'number' &&
    bounds[0] <= bounds[2] &&
    bounds[1] <= bounds[3]
  );
}

/** The error for what is no rectangle. */
function badBounds(where: string, name: string, bounds: unknown): Error {
  const list = bounds as RectLike | null | undefined;
  if (typeof list !== 'object' || list === null || !(list.length >= 4)) {
    return typeError(where, name, 'four numbers [minX, minY, maxX, maxY]', bounds);
  }
  for (let i = 0; i < 4; i += 1) {
    notNaN(where, `${name}[${i}]`, list[i]);
  }
  const axis = list[0]! <= list[2]! ? 1 : 0;
  return rangeError(where, `${name}[${axis + 2}]`, `>= ${name}[${axis}] = ${list[axis]}`, list[axis + 2]);
}
