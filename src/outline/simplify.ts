import { Grid } from './grid.js';
import { orient } from './orient.js';
import type { Ring } from './ring.js';

/**
 * A list of numbers whose least is always known, as in a tournament: of each two the lesser, of each two of those the lesser, and so on.
 */
class Least {
  /** The places of the lesser numbers, from index 1 on, laid out as a binary heap: the parent of `i` is at `i / 2`. */
  private readonly places: number[];

  constructor(private readonly values: number[]) {
    const { length } = values;
    this.places = Array.from({ length: 2 * length }, (_, i) => i - length);
    for (let i = length - 1; i >= 1; i -= 1) {
      this.compare(i);
    }
  }

  /** The place of the least number, the first of several, if it is at most `most`; else −1. */
  find(most: number): number {
    return this.values[this.places[1]!]! <= most ? this.places[1]! : -1;
  }

  set(place: number, value: number): void {
    this.values[place] = value;
    for (let i = (place + this.values.length) >> 1; i >= 1; i >>= 1) {
      this.compare(i);
    }
  }

  private compare(i: number): void {
    const a = this.places[2 * i]!;
    const b = this.places[2 * i + 1]!;
    const ahead = this.values[a]! - this.values[b]! || a - b;
    this.places[i] = ahead < 0 ? a : b;
  }
}

/** What is left of a ring. */
class Left {
  private readonly next: number[];
  private readonly before: number[];
  /** How far the outline would be off without a vertex; infinite for vertices that are gone. */
  private readonly cost: number[];
  private readonly least: Least;
  /** The places of all vertices, those that are gone included. */
  private readonly grid: Grid<number>;
  count: number;

  constructor(private readonly ring: Ring) {
    const { x, y } = ring;
    this.count = x.length;
    this.next = x.map((_, i) => (i + 1) % this.count);
    this.before = x.map((_, i) => (i + this.count - 1) % this.count);
    this.cost = x.map((_, i) => this.costOf(i));
    this.least = new Least([...this.cost]);
    this.grid = new Grid(x, y);
    x.forEach((_, i) => void this.grid.at(x[i]!, y[i]!).push(i));
  }

  /** The vertex without which the outline is off the least, if that is at most `most`; else −1. */
  find(most: number): number {
    const refused: number[] = [];
    let found = this.least.find(most);
    while (found >= 0 && !this.isFree(found)) {
      this.least.set(found, Infinity);
      refused.push(found);
      found = this.least.find(most);
    }
    for (const i of refused) {
      this.least.set(i, this.cost[i]!);
    }
    return found;
  }

  drop(i: number): void {
    const before = this.before[i]!;
    const next = this.next[i]!;
    this.next[before] = next;
    this.before[next] = before;
    this.count -= 1;
    this.price(i, Infinity);
    this.price(before, this.costOf(before));
    this.price(next, this.costOf(next));
  }

  private price(i: number, cost: number): void {
    this.cost[i] = cost;
    this.least.set(i, cost);
  }

  kept(): number[] {
    return this.cost.map((_, i) => i).filter((i) => this.cost[i] !== Infinity);
  }

  /**
   * How far the outline would be off without a vertex: the largest distance of it, and of those already gone beside it, from the edge in
   * their place.
   */
  private costOf(i: number): number {
    const from = this.before[i]!;
    const to = this.next[i]!;
    let most = 0;
    for (let k = (from + 1) % this.ring.x.length; k !== to; k = (k + 1) % this.ring.x.length) {
      most = Math.max(most, this.distance(k, from, to));
    }
    return most;
  }

  /** The distance of a vertex from the edge between two others. */
  private distance(i: number, from: number, to: number): number {
    const { x, y } = this.ring;
    const dx = x[to]! - x[from]!;
    const dy = y[to]! - y[from]!;
    const px = x[i]! - x[from]!;
    const py = y[i]! - y[from]!;
    const square = dx * dx + dy * dy;
    const share = square > 0 ? Math.max(0, Math.min(1, (px * dx + py * dy) / square)) : 0;
    const offX = px - share * dx;
    const offY = py - share * dy;
    return Math.sqrt(offX * offX + offY * offY);
  }

  /** Whether a vertex may go: no other vertex that is left is within the triangle that is cut off, else the outline would cross itself. */
  private isFree(i: number): boolean {
    const a = this.before[i]!;
    const c = this.next[i]!;
    const { x, y } = this.ring;
    const side = (p: number, q: number, k: number) => orient(x[p]!, y[p]!, x[q]!, y[q]!, x[k]!, y[k]!);
    const turn = Math.sign(side(a, i, c)) || 1;
    const isWithin = (k: number) =>
      this.cost[k] !== Infinity &&
      k !== a &&
      k !== i &&
      k !== c &&
      turn * side(a, i, k) >= 0 &&
      turn * side(i, c, k) >= 0 &&
      turn * side(c, a, k) >= 0;
    return !this.grid.within(
      Math.min(x[a]!, x[i]!, x[c]!),
      Math.min(y[a]!, y[i]!, y[c]!),
      Math.max(x[a]!, x[i]!, x[c]!),
      Math.max(y[a]!, y[i]!, y[c]!),
      (cell) => cell.some(isWithin),
    );
  }
}

/** The indices of the vertices of a ring that are left, if it may be off by `tolerance`. */
export function simplified(ring: Ring, tolerance: number): number[] {
  const left = new Left(ring);
  for (let i = left.find(tolerance); i >= 0 && left.count > 3; i = left.find(tolerance)) {
    left.drop(i);
  }
  return left.kept();
}
