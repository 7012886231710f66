/** Items that are each at a place of one of several lists; the places of a list have to be 0, 1, 2 … Used again and again. */
export class Order {
  private entries = new Int32Array(192);
  private count = 0;
  private starts = new Int32Array(64);
  private sorted = new Int32Array(64);

  clear(): void {
    this.count = 0;
  }

  add(list: number, place: number, item: number): void {
    const at = 3 * this.count;
    if (at === this.entries.length) {
      const wider = new Int32Array(2 * at);
      wider.set(this.entries);
      this.entries = wider;
    }
    this.entries[at] = list;
    this.entries[at + 1] = place;
    this.entries[at + 2] = item;
    this.count += 1;
  }

  /** Sorts the items. @returns whether their places are right. */
  sort(listCount: number): boolean {
    const { entries, count } = this;
    if (this.starts.length <= listCount) {
      this.starts = new Int32Array(2 * listCount + 2);
    }
    if (this.sorted.length < count) {
      this.sorted = new Int32Array(2 * count);
    }
    const { starts, sorted } = this;
    starts.fill(0, 0, listCount + 1);
    sorted.fill(-1, 0, count);
    for (let at = 0; at < 3 * count; at += 3) {
      starts[entries[at]! + 1]! += 1;
    }
    for (let list = 0; list < listCount; list += 1) {
      starts[list + 1]! += starts[list]!;
    }
    for (let at = 0; at < 3 * count; at += 3) {
      const to = starts[entries[at]!]! + entries[at + 1]!;
      if (entries[at + 1]! < 0 || to >= starts[entries[at]! + 1]! || sorted[to] !== -1) {
        return false;
      }
      sorted[to] = entries[at + 2]!;
    }
    return true;
  }

  /** Of sorted items: where those of a list begin. */
  start(list: number): number {
    return this.starts[list]!;
  }

  item(at: number): number {
    return this.sorted[at]!;
  }
}
