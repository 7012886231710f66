import type { Shape } from '../shape/shape.js';
import type { Arbiter } from './arbiter.js';

/** Spreads two ids over 32 bits by odd multipliers (Knuth, The Art of Computer Programming 3, 6.4). */
function hash(idA: number, idB: number): number {
  const h = Math.imul(idA, 0x9e3779b1) ^ Math.imul(idB, 0x85ebca6b);
  return h ^ (h >>> 15);
}

/** Numbers of a place: the ids of both shapes, and the last step in which the broadphase reported them. */
const ID_A = 0;
const ID_B = 1;
const SEEN = 2;
const PLACE = 3;

/** What marks a place without an arbiter: no shape has it as its id. */
const FREE = -1;

/** In place of a step: brought back with its world. */
const CLAIMED = -2;

/**
 * Arbiters by their two shapes: open addressing, linear probing, no tombstones, at most half full. What a lookup needs lies in one array of integers: the
 * broadphase reports all pairs in each step in an order of its own, and would have to wait for each arbiter otherwise.
 */
export class PairTable {
  /** @internal */
  arbiters: (Arbiter | null)[] = new Array(64).fill(null);
  private places = new Int32Array(64 * PLACE).fill(FREE);
  private mask = 63;
  /** @internal how many there are */
  size = 0;

  find({ id: idA }: Shape, { id: idB }: Shape): Arbiter | null {
    const at = this.placeOf(idA, idB);
    return at < 0 ? null : this.arbiters[at]!;
  }

  /** Adds an arbiter that is not in the table. */
  add(arbiter: Arbiter, seen: number = FREE): void {
    if (2 * (this.size + 1) > this.mask) {
      this.grow();
    }
    this.put(arbiter, seen);
    this.size += 1;
  }

  /** Notes that a pair is reported in a step, if it was in the one before, too. */
  seeAgain(idA: number, idB: number, stamp: number): boolean {
    const at = this.placeOf(idA, idB);
    const isKnown = at >= 0 && this.places[at * PLACE + SEEN] === stamp - 1;
    if (isKnown) {
      this.places[at * PLACE + SEEN] = stamp;
    }
    return isKnown;
  }

  /** Notes that a pair in the table is reported. */
  see({ place }: Arbiter, stamp: number): void {
    this.places[place * PLACE + SEEN] = stamp;
  }

  /** Whether a pair in the table was reported in a step. */
  saw({ place }: Arbiter, stamp: number): boolean {
    return this.places[place * PLACE + SEEN] === stamp;
  }

  /** Removes an arbiter that is in the table, and moves up those that had to probe past it. */
  remove({ place }: Arbiter): void {
    const { arbiters, places, mask } = this;
    let hole = place;
    for (let i = (place + 1) & mask; arbiters[i] !== null; i = (i + 1) & mask) {
      const from = i * PLACE;
      const home = hash(places[from + ID_A]!, places[from + ID_B]!) & mask;
      if (((i - home) & mask) >= ((i - hole) & mask)) {
        const moved = arbiters[i]!;
        arbiters[hole] = moved;
        moved.place = hole;
        places.copyWithin(hole * PLACE, from, from + PLACE);
        hole = i;
      }
    }
    arbiters[hole] = null;
    places.fill(FREE, hole * PLACE, hole * PLACE + PLACE);
    this.size -= 1;
  }

  clear(): void {
    this.arbiters.fill(null);
    this.places.fill(FREE);
    this.size = 0;
  }

  /** For a world that is restored: all arbiters are to be claimed, and it is forgotten when they were reported. */
  release(): void {
    const { places } = this;
    for (let at = SEEN; at < places.length; at += PLACE) {
      places[at] = FREE;
    }
  }

  /** … finds one that has not been claimed. */
  claim({ id: idA }: Shape, { id: idB }: Shape): Arbiter | null {
    const at = this.placeOf(idA, idB);
    const isThere = at >= 0 && this.places[at * PLACE + SEEN] === FREE;
    if (isThere) {
      this.places[at * PLACE + SEEN] = CLAIMED;
    }
    return isThere ? this.arbiters[at]! : null;
  }

  /** … adds one that was not there. */
  addClaimed(arbiter: Arbiter): void {
    this.add(arbiter, CLAIMED);
  }

  /** … those that have not been, once all others are. */
  unclaimed(): Arbiter[] {
    const { arbiters, places } = this;
    const found: Arbiter[] = [];
    for (let i = 0; i < arbiters.length; i += 1) {
      const at = i * PLACE;
      if (places[at + ID_A] !== FREE && places[at + SEEN] === FREE) {
        found.push(arbiters[i]!);
      }
      places[at + SEEN] = FREE;
    }
    return found;
  }

  private placeOf(idA: number, idB: number): number {
    const { places, mask } = this;
    let i = hash(idA, idB) & mask;
    for (let id = places[i * PLACE + ID_A]!; id !== FREE; id = places[i * PLACE + ID_A]!) {
      if (id === idA && places[i * PLACE + ID_B] === idB) {
        return i;
      }
      i = (i + 1) & mask;
    }
    return -1;
  }

  private put(arbiter: Arbiter, seen: number): void {
    const { arbiters, places, mask } = this;
    const idA = arbiter.shapeA.id;
    const idB = arbiter.shapeB.id;
    let i = hash(idA, idB) & mask;
    while (arbiters[i] !== null) {
      i = (i + 1) & mask;
    }
    arbiters[i] = arbiter;
    arbiter.place = i;
    places[i * PLACE + ID_A] = idA;
    places[i * PLACE + ID_B] = idB;
    places[i * PLACE + SEEN] = seen;
  }

  private grow(): void {
    const { arbiters, places } = this;
    this.arbiters = new Array(arbiters.length * 2).fill(null);
    this.places = new Int32Array(places.length * 2).fill(FREE);
    this.mask = this.arbiters.length - 1;
    for (let i = 0; i < arbiters.length; i += 1) {
      const arbiter = arbiters[i]!;
      if (arbiter !== null) {
        this.put(arbiter, places[i * PLACE + SEEN]!);
      }
    }
  }
}
