/**
 * Sorts the first `count` entries of a list in place, with Shell's method, each gap 5/11 of the one before (Gonnet & Baeza-Yates, Handbook
 * of Algorithms and Data Structures, 1991). The library's sort would allocate a copy, and sort all entries. Not stable: entries of which
 * neither comes before the other may end up in either order.
 */
export function sortFirst<T>(list: T[], count: number, comesBefore: (a: T, b: T) => boolean): void {
  for (let gap = count >> 1; gap > 0; gap = gap === 2 ? 1 : Math.floor((5 * gap) / 11)) {
    for (let i = gap; i < count; i += 1) {
      const entry = list[i]!;
      let k = i;
      while (k >= gap && comesBefore(entry, list[k - gap]!)) {
        list[k] = list[k - gap]!;
        k -= gap;
      }
      list[k] = entry;
    }
  }
}
