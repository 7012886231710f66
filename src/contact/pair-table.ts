import type { Shape } from '../shape/shape.js';
import type { Arbiter } from './arbiter.js';

/** Spreads two ids over 32 bits by odd multipliers (Knuth, The Art of Computer Programming 3, 6.4). */
function hash(idA: number, idB: number): number {
  const h = Math.imul(idA, 0x9e3779b1) ^ Math.imul(idB, 0x85ebca6b);
  return h ^ (h >>> 15);
}

/** Numbers of a place: the ids of both shapes. */
const ID_A = 0;
const ID_B = 1;
const PLACE = 2;

/** What marks a place without an arbiter: no shape has it as its id. */
const FREE = -1;

/** Arbiters by their two shapes: open addressing, linear probing, no tombstones, at most half full. What a lookup needs lies in one array of integers. */
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
  add(arbiter: Arbiter): void {
    if (2 * (this.size + 1) > this.mask) {
      this.grow();
    }
    this.put(arbiter);
    this.size += 1;
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

  private put(arbiter: Arbiter): void {
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
  }

  private grow(): void {
    const { arbiters, places } = this;
    this.arbiters = new Array(arbiters.length * 2).fill(null);
    this.places = new Int32Array(places.length * 2).fill(FREE);
    this.mask = this.arbiters.length - 1;
    for (let i = 0; i < arbiters.length; i += 1) {
      const arbiter = arbiters[i]!;
      if (arbiter !== null) {
        this.put(arbiter);
      }
    }
  }
}
