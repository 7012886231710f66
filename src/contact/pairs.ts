import { ARBITER_CACHE, SENSOR_CACHE } from '../config.js';
import { List, takeOut } from '../math/list.js';
import { sortFirst } from '../math/sort.js';
import { isOlder, type Shape } from '../shape/shape.js';
import { Arbiter, type EarlierImpulses } from './arbiter.js';
import { ACTIVE, AWAKE, DEAD, LISTED, SHOWN, SLEEPING } from './bits.js';
import { Crowd } from './crowd.js';
import { PairTable } from './pair-table.js';
import { Places } from './places.js';

/** Whether a pair comes before that of two other shapes in the order of `Pairs.sorted`. */
export function isBefore({ shapeA, shapeB }: Report, nextA: Shape, nextB: Shape): boolean {
  return shapeA === nextA ? shapeB.id < nextB.id : shapeA.id < nextA.id;
}

function comesBefore(a: Report, b: Report): boolean {
  return isBefore(a, b.shapeA, b.shapeB);
}

/** In place of the number of a step: the broadphase has not reported the pair. */
export const NOT_REPORTED = -1;

/** Two shapes that the broadphase has reported and that have no pair yet. Used again and again. */
interface Report {
  shapeA: Shape;
  shapeB: Shape;
}

/**
 * Every pair of shapes whose bounds overlap, or that interacted a short while ago. A pair is made when the broadphase first reports it, and
 * becomes visible as an arbiter (LISTED) when its shapes first touch.
 *
 * `sorted` holds the pairs with at least one awake body, ordered by the ids of their shapes, so that the order in which the broadphase
 * reports them cannot matter. Pairs that sleep are only in the table, and cost nothing.
 */
export class Pairs {
  readonly sorted = new List<Arbiter>();

  /** @internal */
  readonly table = new PairTable();
  /** @internal while a world is restored: the pairs that were awake before */
  readonly earlier = new List<Arbiter>();
  /** @internal */
  readonly arriving = new List<Arbiter>();
  /** The first `reportedCount` are of this step; the rest are for reuse. */
  private readonly reported: Report[] = [];
  /** @internal */
  reportedCount = 0;
  private readonly crowd = new Crowd();
  private readonly places = new Places();
  /**
   * By the number of a pair: the last step in which the broadphase reported it. Apart from the arbiters, as the broadphase reports in an
   * order of its own, and each arbiter would have to be waited for.
   * @internal
   */
  sightings = new Int32Array(64).fill(NOT_REPORTED);
  /** How many arbiters have been made: their numbers begin with 1. */
  private made = 0;
  /** @internal the first free arbiter; each links the next one, as an array would grow when many pairs end */
  pool: Arbiter | null = null;
  /** @internal objects for `Arbiter.before`: left in the arbiters in the pool, there would be one in every arbiter in the end */
  readonly spare: EarlierImpulses[] = [];
  /**
   * @internal pairs that were cut off since the last step began, and those from before: an `end` event that is yet to be delivered may
   * still name them
   */
  cut: Arbiter[] = [];
  /** @internal */
  cutBefore: Arbiter[] = [];

  /** The pair of two shapes, given in any order, or `null`. */
  find(one: Shape, two: Shape): Arbiter | null {
    return isOlder(one, two) ? this.table.find(one, two) : this.table.find(two, one);
  }

  /** The pair of two shapes, given in any order; made if there is none. */
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

  /**
   * Takes a report of the broadphase by the number of the pair. @returns whether the pair was reported in the last step too; if not, the
   * number may be that of another pair by now.
   */
  reportAgain(number: number, stamp: number): boolean {
    const isKnown = this.sightings[number] === stamp - 1;
    if (isKnown) {
      this.sightings[number] = stamp;
    }
    return isKnown;
  }

  /**
   * Takes a report of the broadphase by the two shapes, in any order, which may interact. @returns the number of the pair, 0 if it is yet
   * to be made.
   */
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

  /** @internal notes two shapes, in any order, whose pair `makeReported` will make */
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

  /** Whether the broadphase reported a pair in the step `stamp`. */
  isReported(pair: Arbiter, stamp: number): boolean {
    return this.sightings[pair.number] === stamp;
  }

  /** Forgets that the broadphase reported the pair. */
  overlook(pair: Arbiter): void {
    this.sightings[pair.number] = NOT_REPORTED;
  }

  /** Makes the pairs that were reported for the first time, in order, so that they lie in memory in the order in which steps walk through them. */
  makeReported(stamp: number): void {
    this.crowd.drainTo(this);
    const { reported, reportedCount } = this;
    sortFirst(reported, reportedCount, comesBefore);
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

  /** Merges the pairs that arrived into `sorted`, in place, from the back: they are few, and most others are moved without being compared. */
  merge(): void {
    const { sorted, arriving } = this;
    if (arriving.count === 0) {
      return;
    }
    const { items } = sorted;
    sortFirst(arriving.items, arriving.count, comesBefore);
    let rest = sorted.count;
    for (let n = 0; n < arriving.count; n += 1) {
      sorted.add(arriving.items[n]!);
    }
    for (let n = arriving.count - 1; n >= 0; n -= 1) {
      const pair = arriving.items[n]!;
      let low = 0;
      for (let high = rest; low < high; ) {
        const middle = (low + high) >> 1;
        if (comesBefore(pair, items[middle]!)) {
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

  /** Every now and then lays the records of awake pairs out in their order again. Only to be called when nobody holds on to where a record is. */
  arrange(stamp: number): void {
    this.places.arrange(this.sorted, stamp);
  }

  /** Makes the pair visible as an arbiter of both shapes. */
  list(pair: Arbiter): void {
    pair.mark(LISTED);
    pair.indexA = pair.shapeA.arbiters.push(pair) - 1;
    pair.indexB = pair.shapeB.arbiters.push(pair) - 1;
    pair.mixMaterials();
  }

  /** Takes the arbiter from both shapes, and forgets its interaction. */
  unlist(pair: Arbiter): void {
    removeAt(pair.shapeA, pair.indexA);
    removeAt(pair.shapeB, pair.indexB);
    pair.unmark(LISTED);
    pair.forget();
  }

  /** Whether the interaction has been over for so long that its cache has expired. */
  isExpired(pair: Arbiter, stamp: number): boolean {
    return pair.is(LISTED) && pair.lastInteraction + (pair.sensor ? SENSOR_CACHE : ARBITER_CACHE) < stamp;
  }

  /** Frees a pair that is not listed and is leaving `sorted`. */
  retire(pair: Arbiter): void {
    this.drop(pair);
    this.free(pair);
  }

  /**
   * Takes a listed pair out of everything, because one of its shapes or bodies goes. The object is reused only after the `end` event that
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

  /** At the start of a step: frees the pairs that were cut off before the last one. */
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

  /** Lets go of shapes of earlier steps, so that they can be collected. */
  release(): void {
    this.crowd.release();
    for (let i = this.reportedCount; i < this.reported.length; i += 1) {
      dropShapes(this.reported[i]!);
    }
    // The rest of the pool was let go of before.
    for (let pair = this.pool; pair !== null && pair.shapeA !== null; pair = pair.next) {
      dropShapes(pair);
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

  /** @internal frees the pairs that were cut off at once: no event names them any more */
  freeCut(): void {
    for (const list of [this.cut, this.cutBefore]) {
      for (const pair of list) {
        this.free(pair);
      }
      list.length = 0;
    }
  }
}

/** Lets go of the shapes of a report, so that they and what they refer to can be collected. */
function dropShapes(report: Report): void {
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
