import { PAIR_NUMBERS } from '../collide/layout.js';
import { ARRANGE_FROM, ARRANGE_STEPS } from '../config.js';
import { grown, widened } from '../math/doubles.js';
import { List } from '../math/list.js';
import type { Arbiter } from './arbiter.js';

/**
 * Keeps the records of pairs in memory in the order in which steps walk through them. As pairs come and go they get the records of others that went; where these lie
 * anywhere, a processor waits for each instead of fetching it ahead. A place is told by the number of the pair whose record was made there.
 */
export class Places {
  /** By the number of a pair: how far from its own place its record is. */
  private shifts = new Int32Array(0);
  /** By places: which of the pairs at hand has its record there. */
  private holders = new Int32Array(0);
  /** Of the pairs at hand, in order. */
  private places = new Int32Array(0);
  /** The pairs at hand: awake ones, then those that are free. */
  private readonly all = new List<Arbiter>();
  /** How many pairs came among the awake ones since these were last arranged. */
  arrived = 0;

  /** Now and then, if enough came. `pool` is the first of the pairs that are free, `made` how many there are in all. */
  arrange({ items, count }: List<Arbiter>, pool: Arbiter | null, made: number, stamp: number): void {
    if (count < ARRANGE_FROM || 16 * this.arrived < count || stamp % ARRANGE_STEPS !== 0) {
      return;
    }
    const { all } = this;
    this.arrived = 0;
    all.clear();
    for (let i = 0; i < count; i += 1) {
      all.add(items[i]!);
    }
    for (let free = pool; free !== null; free = free.next) {
      all.add(free);
    }
    this.list(made);
    for (let i = 0; i < count; i += 1) {
      this.put(i);
    }
  }

  /** Finds out where the records of the pairs at hand are. */
  private list(made: number): void {
    if (this.shifts.length <= made) {
      const length = grown(made + 1);
      this.shifts = widened(this.shifts, new Int32Array(length));
      this.holders = new Int32Array(length);
      this.places = new Int32Array(length);
    }
    const { shifts, holders, places } = this;
    const { items, count } = this.all;
    for (let i = 0; i < count; i += 1) {
      const { number } = items[i]!;
      places[i] = number + shifts[number]!;
      holders[places[i]!] = i;
    }
    places.subarray(0, count).sort();
  }

  /** Gives one of them the place that is its in order; what was there goes where it was. */
  private put(index: number): void {
    const { shifts, holders, places, all } = this;
    const pair = all.items[index]!;
    const from = pair.number + shifts[pair.number]!;
    const to = places[index]!;
    if (from !== to) {
      const other = all.items[holders[to]!]!;
      exchange(pair, other);
      shifts[pair.number] = to - pair.number;
      shifts[other.number] = from - other.number;
      holders[from] = holders[to]!;
    }
  }
}

function exchange(pair: Arbiter, other: Arbiter): void {
  const { numbers: n, at: o } = pair;
  const { numbers: m, at: p } = other;
  for (let k = 0; k < PAIR_NUMBERS; k += 1) {
    const number = n[o + k]!;
    n[o + k] = m[p + k]!;
    m[p + k] = number;
  }
  pair.numbers = m;
  pair.at = p;
  other.numbers = n;
  other.at = o;
}
