import type { Shape } from '../shape/shape.js';
import type { Arbiter } from './arbiter.js';

/** Spreads two ids over 32 bits with odd multipliers (Knuth, The Art of Computer Programming 3, 6.4). */
function hash({ id: idA }: Shape, { id: idB }: Shape): number {
  const h = Math.imul(idA, 0x9e3779b1) ^ Math.imul(idB, 0x85ebca6b);
  return h ^ (h >>> 15);
}

/** Arbiters by their two shapes: open addressing, linear probing, no tombstones, at most half full. */
export class PairTable {
  /** @internal */
  arbiters: (Arbiter | null)[] = new Array(64).fill(null);
  /** @internal how many there are */
  size = 0;

  find(shapeA: Shape, shapeB: Shape): Arbiter | null {
    const { arbiters } = this;
    const mask = arbiters.length - 1;
    let i = hash(shapeA, shapeB) & mask;
    let arbiter = arbiters[i]!;
    while (arbiter !== null && (arbiter.shapeA !== shapeA || arbiter.shapeB !== shapeB)) {
      i = (i + 1) & mask;
      arbiter = arbiters[i]!;
    }
    return arbiter;
  }

  /** Adds an arbiter that is not in the table. */
  add(arbiter: Arbiter): void {
    if (2 * this.size + 3 > this.arbiters.length) {
      this.grow();
    }
    this.put(arbiter);
    this.size += 1;
  }

  /** Removes an arbiter that is in the table, and moves up those that were probed past it. */
  remove(arbiter: Arbiter): void {
    const { arbiters } = this;
    const mask = arbiters.length - 1;
    let hole = hash(arbiter.shapeA, arbiter.shapeB) & mask;
    while (arbiters[hole] !== arbiter) {
      hole = (hole + 1) & mask;
    }
    for (let i = (hole + 1) & mask; arbiters[i] !== null; i = (i + 1) & mask) {
      const { shapeA, shapeB } = arbiters[i]!;
      if (((i - hash(shapeA, shapeB)) & mask) >= ((i - hole) & mask)) {
        arbiters[hole] = arbiters[i]!;
        hole = i;
      }
    }
    arbiters[hole] = null;
    this.size -= 1;
  }

  clear(): void {
    this.arbiters.fill(null);
    this.size = 0;
  }

  private put(arbiter: Arbiter): void {
    const { arbiters } = this;
    const mask = arbiters.length - 1;
    let i = hash(arbiter.shapeA, arbiter.shapeB) & mask;
    while (arbiters[i] !== null) {
      i = (i + 1) & mask;
    }
    arbiters[i] = arbiter;
  }

  private grow(): void {
    const { arbiters } = this;
    this.arbiters = new Array(2 * arbiters.length).fill(null);
    for (const arbiter of arbiters) {
      if (arbiter !== null) {
        this.put(arbiter);
      }
    }
  }
}
