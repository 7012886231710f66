import type { RectLike, Vec2Like } from '../math/vectors.js';
import { boolean, notNaN, rangeError, typeError } from '../validate.js';

/** An item in a broadphase: a proxy for your data. */
export interface BroadphaseHandle<T = unknown> {
  /** What was inserted. */
  data: T;
  /** Two static handles never make a pair. */
  readonly isStatic: boolean;
}

/** Decides which items make pairs: two do if the `group` of each has a bit in common with the `mask` of the other. */
export interface BroadphaseFilter {
  /** The groups it is in, as bits. */
  readonly group: number;
  /** The groups it meets, as bits. */
  readonly mask: number;
}

/** Whether two filters allow a pair. */
export function letsMeet(a: BroadphaseFilter, b: BroadphaseFilter): boolean {
  return (a.group & b.mask) !== 0 && (b.group & a.mask) !== 0;
}

/** The filter of items without one. */
export const UNFILTERED: BroadphaseFilter = { group: -1, mask: -1 };

/**
 * Finds items whose bounds overlap; knows nothing of shapes. It can be used on its own, with any data; the same data may be inserted many
 * times. Bounds are `[minX, minY, maxX, maxY]`, are copied, and may be infinite; bounds that touch overlap. Any object with these methods
 * can be given to `createWorld`: the choice does not change results, only their cost.
 *
 * Callbacks of `perform` and `sample` may query, but must not modify.
 */
export interface Broadphase<T = unknown> {
  /**
   * Adds an item. Items of the same `group`, which may be any value, never make a pair: the world passes the body of each shape. Items
   * whose filters keep them apart need not make a pair, either: the world passes each shape as its own filter. A filter may change later,
   * which `refilter` reports.
   * @throws TypeError or RangeError unless `bounds` is a rectangle and `filter` has both its numbers.
   */
  insert(data: T, bounds: RectLike, isStatic: boolean, group?: unknown, filter?: BroadphaseFilter): BroadphaseHandle<T>;

  /** Gives a handle new bounds, and makes it static or moving if `isStatic` is given. */
  update(handle: BroadphaseHandle<T>, bounds: RectLike, isStatic?: boolean): void;

  /** Removes a handle; it may be reused by a later `insert`. */
  remove(handle: BroadphaseHandle<T>): void;

  /** Removes everything, after calling back once per handle; also if a callback throws. */
  clear(callback?: (handle: BroadphaseHandle<T>) => void, thisObject?: unknown): void;

  /**
   * Reports each pair of overlapping handles once, in any order, except pairs of two static handles and pairs within a group. With
   * `isKnown`, a broadphase may keep the integer other than 0 that `callback` returns for a pair, as long as the pair is reported in every
   * call, and then call `isKnown(integer)` first: if that returns `true`, the pair is not reported.
   */
  perform(
    callback: (a: BroadphaseHandle<T>, b: BroadphaseHandle<T>) => unknown,
    thisObject?: unknown,
    isKnown?: (note: number) => boolean,
  ): void;

  /** Reports each handle that overlaps `bounds` once, static or not. Handles of the same group as `like`, if given, need not be reported. */
  sample(
    bounds: RectLike,
    callback: (handle: BroadphaseHandle<T>, bounds: RectLike) => void,
    thisObject?: unknown,
    like?: BroadphaseHandle<T>,
  ): void;

  /** Called when the filter of a handle has changed. Needed if the broadphase leaves out pairs because of filters. */
  refilter?(handle: BroadphaseHandle<T>): void;

  /** Optional; makes continuous collision fast. As `sample`, for static handles only. Called by the engine; checks nothing. */
  sampleStatic?(bounds: RectLike, callback: (handle: BroadphaseHandle<T>, bounds: RectLike) => void): void;

  /**
   * Optional; makes ray and shape casts fast. Visits each handle whose bounds may meet the bounds `start` + direction · f, 0 ≤ f ≤ `limit`,
   * nearer ones as early as is cheap. `visit` returns the f up to which handles still matter. Called by the engine; checks nothing.
   */
  cast?(start: RectLike, direction: Vec2Like, limit: number, visit: (handle: BroadphaseHandle<T>) => number): void;
}

/** Throws for what no broadphase can insert: bounds as in `checkRect`, a filter without both numbers. */
export function checkInsert(where: string, bounds: RectLike, isStatic: boolean, filter: BroadphaseFilter): void {
  checkRect(where, bounds);
  boolean(where, 'isStatic', isStatic);
  const { group, mask } = (filter ?? {}) as Partial<BroadphaseFilter>;
  if (typeof group !== 'number' || typeof mask !== 'number') {
    throw typeError(where, 'filter', 'an object with the numbers group and mask', filter);
  }
}

/** Throws unless bounds are four numbers that make a rectangle. */
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

/** The error for bounds that are no rectangle. */
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
