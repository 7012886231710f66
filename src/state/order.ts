import { widened } from '../math/doubles.js';

/** Checks that things in several lists have the places 0, 1, 2 … of each list. Reused for each check. */
export class Order {
  private entries = new Int32Array(128);
  private count = 0;

  clear(): void {
    this.count = 0;
  }

  add(list: number, place: number): void {
    const at = 2 * this.count;
    if (at === this.entries.length) {
      this.entries = widened(this.entries, new Int32Array(2 * at));
    }
    this.entries[at] = list;
    this.entries[at + 1] = place;
    this.count += 1;
  }

  /** Whether the places are right, of `listCount` lists. */
  isRight(listCount: number): boolean {
    const { entries, count } = this;
    const starts = new Int32Array(listCount + 1);
    for (let at = 0; at < 2 * count; at += 2) {
      starts[entries[at]! + 1]! += 1;
    }
    for (let list = 0; list < listCount; list += 1) {
      starts[list + 1]! += starts[list]!;
    }
    const taken = new Uint8Array(count);
    for (let at = 0; at < 2 * count; at += 2) {
      const place = entries[at + 1]!;
      const to = starts[entries[at]!]! + place;
      if (place < 0 || to >= starts[entries[at]! + 1]! || taken[to] !== 0) {
        return false;
      }
      taken[to] = 1;
    }
    return true;
  }
}
