/** Items that are each at a place of one of several lists; the places of a list have to be 0, 1, 2 … */
export class Order {
  private readonly lists: number[] = [];
  private readonly places: number[] = [];
  private readonly items: number[] = [];

  add(list: number, place: number, item: number): void {
    this.lists.push(list);
    this.places.push(place);
    this.items.push(item);
  }

  /** Calls back for each list and item in order. @returns whether the places are right; if not, calls nothing. */
  visit(listCount: number, action: ((list: number, item: number) => void) | null): boolean {
    const { lists, places, items } = this;
    const starts = new Int32Array(listCount + 1);
    for (const list of lists) {
      starts[list + 1]! += 1;
    }
    for (let list = 0; list < listCount; list += 1) {
      starts[list + 1]! += starts[list]!;
    }
    const sorted = new Int32Array(lists.length).fill(-1);
    for (let i = 0; i < lists.length; i += 1) {
      const at = starts[lists[i]!]! + places[i]!;
      if (places[i]! < 0 || at >= starts[lists[i]! + 1]! || sorted[at] !== -1) {
        return false;
      }
      sorted[at] = items[i]!;
    }
    for (let list = 0; list < listCount && action !== null; list += 1) {
      for (let at = starts[list]!; at < starts[list + 1]!; at += 1) {
        action(list, sorted[at]!);
      }
    }
    return true;
  }
}
