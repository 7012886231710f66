/** A list that is filled and emptied in each step. What lies beyond the count is old: shortening an array would cost its storage. */
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

  /** Lets go of what is old. */
  release(): void {
    release(this.items, this.count);
  }
}

/** Lets go of what lies in a list from some place on, and is for later: nothing reads it. */
export function release(items: unknown[], from: number): void {
  items.fill(null, from);
}

/** Empties a list that will soon be as long again: setting its length would give its memory back. */
export function drop(list: unknown[]): void {
  while (list.length > 0) {
    list.pop();
  }
}

/** Takes an entry out of a list whose order does not matter. @returns the last one, which takes its place; `null` if it was that itself. */
export function takeOut<T>(list: T[], at: number): T | null {
  const last = list.pop()!;
  if (at === list.length) {
    return null;
  }
  list[at] = last;
  return last;
}
