import { orient } from './orient.js';
import type { Ring } from './ring.js';

/** What is left of a ring. */
class Left {
  private readonly next: number[];
  private readonly before: number[];
  /** How far the outline would be off without a vertex; infinite for those that are gone. */
  private readonly cost: number[];
  count: number;

  constructor(private readonly ring: Ring) {
    this.count = ring.x.length;
    this.next = ring.x.map((_, i) => (i + 1) % this.count);
    this.before = ring.x.map((_, i) => (i + this.count - 1) % this.count);
    this.cost = ring.x.map((_, i) => this.costOf(i));
  }

  /** The vertex that is missed the least, if that is by no more than `most`; else −1. */
  find(most: number): number {
    let found = -1;
    let least = most;
    for (let i = 0; i < this.cost.length; i += 1) {
      if (this.cost[i]! <= least && (found < 0 || this.cost[i]! < least) && this.isFree(i)) {
        found = i;
        least = this.cost[i]!;
      }
    }
    return found;
  }

  drop(i: number): void {
    const before = this.before[i]!;
    const next = this.next[i]!;
    this.next[before] = next;
    this.before[next] = before;
    this.cost[i] = Infinity;
    this.count -= 1;
    this.cost[before] = this.costOf(before);
    this.cost[next] = this.costOf(next);
  }

  kept(): number[] {
    return this.cost.map((_, i) => i).filter((i) => this.cost[i] !== Infinity);
  }

  /** How far vertices, those that are gone included, are from the edge that would be there without this one. */
  private costOf(i: number): number {
    const from = this.before[i]!;
    const to = this.next[i]!;
    let most = 0;
    for (let k = (from + 1) % this.ring.x.length; k !== to; k = (k + 1) % this.ring.x.length) {
      most = Math.max(most, this.distance(k, from, to));
    }
    return most;
  }

  /** From a vertex to the edge between two others. */
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

  /** Whether no other vertex that is left is within the triangle that is cut off: else the outline would cross itself. */
  private isFree(i: number): boolean {
    const a = this.before[i]!;
    const c = this.next[i]!;
    const { x, y } = this.ring;
    const side = (p: number, q: number, k: number) => orient(x[p]!, y[p]!, x[q]!, y[q]!, x[k]!, y[k]!);
    const turn = Math.sign(side(a, i, c)) || 1;
    for (let k = this.next[c]!; k !== a; k = this.next[k]!) {
      if (turn * side(a, i, k) >= 0 && turn * side(i, c, k) >= 0 && turn * side(c, a, k) >= 0) {
        return false;
      }
    }
    return true;
  }
}

/** The numbers of the vertices that are left of a ring if it may be off by `tolerance`. */
export function simplified(ring: Ring, tolerance: number): number[] {
  const left = new Left(ring);
  for (let i = left.find(tolerance); i >= 0 && left.count > 3; i = left.find(tolerance)) {
    left.drop(i);
  }
  return left.kept();
}
