import type { Shape } from '../shape/shape.js';
import type { Arbiter } from './arbiter.js';

/** Spreads two ids over 32 bits by odd multipliers (Knuth, The Art of Computer Programming 3, 6.4). */
function hash(idA: number, idB: number): number {
  const h = Math.imul(idA, 0x9e3779b1) ^ Math.imul(idB, 0x85ebca6b);
  return h ^ (h >>> 15);
}

/** Arbiters by their two shapes: open addressing, linear probing, no tombstones, at most half full. */
export class PairTable {
  private slots: (Arbiter | null)[] = new Array(64).fill(null);
  private mask = 63;
  private size = 0;

  find(shapeA: Shape, shapeB: Shape): Arbiter | null {
    const { slots, mask } = this;
    let i = hash(shapeA.id, shapeB.id) & mask;
    for (let entry = slots[i]!; entry !== null; entry = slots[i]!) {
      if (entry.shapeA === shapeA && entry.shapeB === shapeB) {
        return entry;
      }
      i = (i + 1) & mask;
    }
    return null;
  }

  /** Adds an arbiter that is not in the table. */
  add(arbiter: Arbiter): void {
    if (2 * (this.size + 1) > this.mask) {
      this.grow();
    }
    this.place(arbiter);
    this.size += 1;
  }

  /** Removes an arbiter that is in the table, and moves up those that had to probe past it. */
  remove(arbiter: Arbiter): void {
    const { slots, mask } = this;
    let hole = hash(arbiter.shapeA.id, arbiter.shapeB.id) & mask;
    while (slots[hole] !== arbiter) {
      hole = (hole + 1) & mask;
    }
    for (let i = (hole + 1) & mask; slots[i] !== null; i = (i + 1) & mask) {
      const entry = slots[i]!;
      const home = hash(entry.shapeA.id, entry.shapeB.id) & mask;
      if (((i - home) & mask) >= ((i - hole) & mask)) {
        slots[hole] = entry;
        hole = i;
      }
    }
    slots[hole] = null;
    this.size -= 1;
  }

  clear(): void {
    this.slots.fill(null);
    this.size = 0;
  }

  /** Moves all arbiters to the end of a list. */
  drainTo(list: Arbiter[]): void {
    for (const entry of this.slots) {
      if (entry !== null) {
        list.push(entry);
      }
    }
    this.clear();
  }

  private place(arbiter: Arbiter): void {
    const { slots, mask } = this;
    let i = hash(arbiter.shapeA.id, arbiter.shapeB.id) & mask;
    while (slots[i] !== null) {
      i = (i + 1) & mask;
    }
    slots[i] = arbiter;
  }

  private grow(): void {
    const old = this.slots;
    this.slots = new Array(old.length * 2).fill(null);
    this.mask = this.slots.length - 1;
    for (const entry of old) {
      if (entry !== null) {
        this.place(entry);
      }
    }
  }
}
