import { PAIR_NUMBERS } from '../collide/layout.js';
import { ARRANGE_FROM, ARRANGE_STEPS } from '../config.js';
import { widened } from '../math/doubles.js';
import type { List } from '../math/list.js';
import type { Arbiter } from './arbiter.js';

/**
 * Keeps the records of pairs in memory in the order in which steps walk through them. A new pair takes over the record of one that ended;
 * where records lie anywhere, the processor waits for each instead of fetching it ahead.
 */
export class Places {
  /** By place: the pair whose record is there. Places are numbered as the records lie in memory. */
  private readonly owners: Arbiter[] = [];
  /** By the number of a pair: the place of its record. */
  private places = new Int32Array(64);
  /** How many pairs have become awake since `arrange` last did anything. */
  arrived = 0;

  /** Notes the record of a new arbiter object. */
  add(pair: Arbiter): void {
    if (pair.number >= this.places.length) {
      this.places = widened(this.places, new Int32Array(2 * pair.number));
    }
    this.places[pair.number] = this.owners.length;
    this.owners.push(pair);
  }

  /** Every now and then, if enough pairs have arrived: gives awake pairs the first places, exchanging records with whoever has them. */
  arrange({ items, count }: List<Arbiter>, stamp: number): void {
    if (count < ARRANGE_FROM || 16 * this.arrived < count || stamp % ARRANGE_STEPS !== 0) {
      return;
    }
    this.arrived = 0;
    const { owners, places } = this;
    for (let i = 0; i < count; i += 1) {
      const pair = items[i]!;
      const owner = owners[i]!;
      if (pair !== owner) {
        const from = places[pair.number]!;
        exchange(pair, owner);
        owners[i] = pair;
        owners[from] = owner;
        places[pair.number] = i;
        places[owner.number] = from;
      }
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
