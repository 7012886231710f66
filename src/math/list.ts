/**
 * A list that is filled and emptied in each step. Its array is not shortened, which would give the memory back: what lies beyond the count
 * is old.
 */
export class List<T> {
  readonly items: T[] = [];
  count = 0;

  add(item: T): void {
    this.items[this.count] = item;
    this.count += 1;
  }

  has(item: T): boolean {
    for (let i = 0; i < this.count; i += 1) {
      if (this.items[i] === item) return true;
    }
    return false;
  }

  clear(): void {
    this.count = 0;
  }

  /** Lets go of what lies beyond the count, so that it can be collected. */
  release(): void {
    release(this.items, this.count);
  }
}

/** Overwrites what lies in a list from an index on and is not read any more, so that it can be collected. */
export function release(items: unknown[], from: number): void {
  items.fill(null, from);
}

/** Empties a list that will soon be as long again: setting its length to 0 would give its memory back. */
export function drop(list: unknown[]): void {
  while (list.length > 0) {
    list.pop();
  }
}

/** Removes an entry from a list whose order does not matter. @returns the last entry, which takes its place; `null` if it was itself the last. */
export function takeOut<T>(list: T[], at: number): T | null {
  const last = list.pop()!;
  if (at === list.length) {
    return null;
  }
  list[at] = last;
  return last;
}
