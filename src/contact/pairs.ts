import { ARBITER_CACHE, SENSOR_CACHE } from '../config.js';
import { List, takeOut } from '../math/list.js';
import { sortFirst } from '../math/sort.js';
import { isOlder, type Shape } from '../shape/shape.js';
import { Arbiter, type Before } from './arbiter.js';
import { ACTIVE, AWAKE, DEAD, LISTED, SHOWN, SLEEPING } from './bits.js';
import { Crowd } from './crowd.js';
import { PairTable } from './pair-table.js';
import { Places } from './places.js';

/** Whether a pair comes before that of two shapes. */
export function isBefore({ shapeA, shapeB }: Report, nextA: Shape, nextB: Shape): boolean {
  return shapeA === nextA ? shapeB.id < nextB.id : shapeA.id < nextA.id;
}

function before(a: Report, b: Report): boolean {
  return isBefore(a, b.shapeA, b.shapeB);
}

/** In place of a step in which the broadphase reported a pair: it never did. */
export const NOT_REPORTED = -1;

/** Two shapes that the broadphase reported for the first time. Used again and again. */
interface Report {
  shapeA: Shape;
  shapeB: Shape;
}

/**
 * Every pair of shapes whose bounds overlap, or that interacted a short while ago. A pair is made when the broadphase first
 * reports it and becomes visible as an arbiter (LISTED) when its shapes first touch.
 *
 * `sorted` holds the pairs with something awake, ordered by the ids of their shapes, so that the order in which the
 * broadphase reports them cannot matter. Pairs that sleep are only in the table, and cost nothing.
 */
export class Pairs {
  readonly sorted = new List<Arbiter>();

  /** @internal */
  readonly table = new PairTable();
  /** @internal the awake pairs that there were, while a world is restored */
  readonly earlier = new List<Arbiter>();
  /** @internal */
  readonly arriving = new List<Arbiter>();
  /** What lies beyond the count is old. */
  private readonly reported: Report[] = [];
  /** @internal */
  reportedCount = 0;
  private readonly crowd = new Crowd();
  private readonly places = new Places();
  /**
   * By the numbers of pairs: the last step in which the broadphase reported it. It does so in an order of its own, and would have to wait for each arbiter
   * otherwise.
   * @internal
   */
  sightings = new Int32Array(64).fill(NOT_REPORTED);
  /** How many arbiters were made: their numbers begin with 1. */
  private made = 0;
  /** @internal the first of those that are free; each knows the next, as a list would grow when many pairs end */
  pool: Arbiter | null = null;
  /** @internal for pairs that meet again: kept with those in the pool it would be one more object in every arbiter, in the end */
  readonly spare: Before[] = [];
  /** @internal cut from an interaction: still named by an `end` event that is delivered with the next step, or the one before */
  cut: Arbiter[] = [];
  /** @internal */
  cutBefore: Arbiter[] = [];

  /** The pair of two shapes, in any order, if there is one. */
  find(one: Shape, two: Shape): Arbiter | null {
    return isOlder(one, two) ? this.table.find(one, two) : this.table.find(two, one);
  }

  /** The same, made if needed. */
  obtain(one: Shape, two: Shape): Arbiter {
    let pair = this.find(one, two);
    if (pair === null) {
      pair = isOlder(one, two) ? this.make(one, two) : this.make(two, one);
      this.table.add(pair);
      this.arrive(pair);
    }
    return pair;
  }

  /** @internal */
  make(shapeA: Shape, shapeB: Shape): Arbiter {
    const pair = this.pool ?? this.makeNew(shapeA, shapeB);
    this.pool = pair.next;
    pair.next = null;
    pair.reuse(shapeA, shapeB);
    this.sightings[pair.number] = NOT_REPORTED;
    return pair;
  }

  private makeNew(shapeA: Shape, shapeB: Shape): Arbiter {
    this.made += 1;
    if (this.made === this.sightings.length) {
      const { sightings } = this;
      this.sightings = new Int32Array(2 * this.made).fill(NOT_REPORTED);
      this.sightings.set(sightings);
    }
    const pair = new Arbiter(shapeA, shapeB, this.made);
    this.places.add(pair);
    return pair;
  }

  /** The broadphase reports a pair by its number. @returns whether it did in the last step too; if not, the number may be that of another pair by now. */
  reportAgain(number: number, stamp: number): boolean {
    const isKnown = this.sightings[number] === stamp - 1;
    if (isKnown) {
      this.sightings[number] = stamp;
    }
    return isKnown;
  }

  /** The broadphase reports two shapes that may interact, in any order. @returns the number of the pair, 0 if it is yet to be made. */
  report(one: Shape, two: Shape, stamp: number): number {
    const pair = this.find(one, two);
    if (pair !== null) {
      this.sightings[pair.number] = stamp;
      this.arrive(pair);
      return pair.number;
    }
    if (!this.crowd.take(one, two)) {
      this.note(one, two);
    }
    return 0;
  }

  /** @internal the pair of two shapes, in any order, is to be made */
  note(one: Shape, two: Shape): void {
    const isFirst = isOlder(one, two);
    const shapeA = isFirst ? one : two;
    const shapeB = isFirst ? two : one;
    if (this.reportedCount === this.reported.length) {
      this.reported.push({ shapeA, shapeB });
    }
    const report = this.reported[this.reportedCount]!;
    report.shapeA = shapeA;
    report.shapeB = shapeB;
    this.reportedCount += 1;
  }

  /** Whether the broadphase reported a pair in a step. */
  isReported(pair: Arbiter, stamp: number): boolean {
    return this.sightings[pair.number] === stamp;
  }

  /** As if the broadphase had not reported the pair. */
  overlook(pair: Arbiter): void {
    this.sightings[pair.number] = NOT_REPORTED;
  }

  /** Makes the pairs that were reported for the first time, in order: then they lie in memory as they are walked through. */
  makeReported(stamp: number): void {
    this.crowd.drainTo(this);
    const { reported, reportedCount } = this;
    sortFirst(reported, reportedCount, before);
    for (let i = 0; i < reportedCount; i += 1) {
      const { shapeA, shapeB } = reported[i]!;
      const { number } = this.obtain(shapeA, shapeB);
      this.sightings[number] = stamp;
    }
    this.reportedCount = 0;
  }

  /** Puts a pair among the awake ones, at the next `merge`. */
  arrive(pair: Arbiter): void {
    if (!pair.is(AWAKE)) {
      pair.mark(AWAKE);
      this.arriving.add(pair);
    }
  }

  /** Merges the pairs that arrived into the sorted list, from the back, in place: they are few, and all the others need not be looked at. */
  merge(): void {
    const { sorted, arriving } = this;
    if (arriving.count === 0) {
      return;
    }
    const { items } = sorted;
    sortFirst(arriving.items, arriving.count, before);
    let rest = sorted.count;
    for (let n = 0; n < arriving.count; n += 1) {
      sorted.add(arriving.items[n]!);
    }
    for (let n = arriving.count - 1; n >= 0; n -= 1) {
      const pair = arriving.items[n]!;
      let low = 0;
      for (let high = rest; low < high; ) {
        const middle = (low + high) >> 1;
        if (before(pair, items[middle]!)) {
          high = middle;
        } else {
          low = middle + 1;
        }
      }
      for (; rest > low; rest -= 1) {
        items[rest + n] = items[rest - 1]!;
      }
      items[low + n] = pair;
    }
    this.places.arrived += arriving.count;
    arriving.clear();
  }

  /** Lays the records of awake pairs out in their order again, now and then. For a moment when nobody holds on to where one is. */
  arrange(stamp: number): void {
    this.places.arrange(this.sorted, stamp);
  }

  /** Makes the pair visible to both shapes. */
  list(pair: Arbiter): void {
    pair.mark(LISTED);
    pair.indexA = pair.shapeA.arbiters.push(pair) - 1;
    pair.indexB = pair.shapeB.arbiters.push(pair) - 1;
    pair.mixMaterials();
  }

  /** Takes the pair from both shapes; nothing is remembered of its interaction. */
  unlist(pair: Arbiter): void {
    removeAt(pair.shapeA, pair.indexA);
    removeAt(pair.shapeB, pair.indexB);
    pair.unmark(LISTED);
    pair.forget();
  }

  /** The cache of an interaction that is over has run out. */
  isExpired(pair: Arbiter, stamp: number): boolean {
    return pair.is(LISTED) && pair.lastInteraction + (pair.sensor ? SENSOR_CACHE : ARBITER_CACHE) < stamp;
  }

  /** Drops a pair that is not listed and is leaving the sorted list. */
  retire(pair: Arbiter): void {
    this.drop(pair);
    this.free(pair);
  }

  /**
   * Takes a listed pair out of everything because a shape or body goes. The object is reused only after the `end` event that
   * names it.
   */
  cutOff(pair: Arbiter): void {
    removeAt(pair.shapeA, pair.indexA);
    removeAt(pair.shapeB, pair.indexB);
    pair.unmark(LISTED | ACTIVE | SLEEPING | (3 << SHOWN));
    pair.mark(DEAD);
    this.drop(pair);
    this.cut.push(pair);
  }

  private drop(pair: Arbiter): void {
    this.table.remove(pair);
    this.sightings[pair.number] = NOT_REPORTED;
  }

  /** @internal */
  free(pair: Arbiter): void {
    pair.unmark(AWAKE);
    if (pair.before !== null) {
      this.spare.push(pair.before);
      pair.before = null;
    }
    pair.next = this.pool;
    this.pool = pair;
  }

  /** At the start of a step: frees what was cut before the last one. */
  recycle(): void {
    const free = this.cutBefore;
    for (let i = 0; i < free.length; i += 1) {
      const pair = free[i]!;
      if (pair.is(AWAKE)) {
        this.cut.push(pair);
      } else {
        this.free(pair);
      }
    }
    if (free.length > 0) free.length = 0;
    this.cutBefore = this.cut;
    this.cut = free;
  }

  /** Lets go of shapes of earlier steps. */
  release(): void {
    this.crowd.release();
    for (let i = this.reportedCount; i < this.reported.length; i += 1) {
      nameNone(this.reported[i]!);
    }
    // Those below were let go of before.
    for (let pair = this.pool; pair !== null && pair.shapeA !== null; pair = pair.next) {
      nameNone(pair);
    }
  }

  clear(): void {
    this.merge();
    for (let i = 0; i < this.sorted.count; i += 1) {
      this.sorted.items[i]!.unmark(AWAKE);
    }
    for (const pair of this.table.arbiters) {
      if (pair !== null) this.free(pair);
    }
    this.table.clear();
    this.freeCut();
    this.sightings.fill(NOT_REPORTED);
    this.sorted.clear();
    this.arriving.clear();
  }

  /** @internal frees what was cut at once: no event names it any more */
  freeCut(): void {
    for (const list of [this.cut, this.cutBefore]) {
      for (const pair of list) {
        this.free(pair);
      }
      list.length = 0;
    }
  }
}

/** Holds on to no shapes: they, and what is bound to them, may be gone. */
function nameNone(report: Report): void {
  report.shapeA = null!;
  report.shapeB = null!;
}

/** Removes an entry of `shape.arbiters`; the last one takes its place. */
function removeAt(shape: Shape, index: number): void {
  const moved = takeOut(shape.arbiters, index);
  if (moved?.shapeA === shape) {
    moved.indexA = index;
  } else if (moved !== null) {
    moved.indexB = index;
  }
}
