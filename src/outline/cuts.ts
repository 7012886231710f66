import { VERTEX_TOLERANCE } from '../config.js';
import type { Vec2 } from '../math/vectors.js';
import { Grid } from './grid.js';
import { orient } from './orient.js';
import { bend, isOn, LEFT, RIGHT, type Ring, segmentsTouch } from './ring.js';

// A corner that bends inwards, a notch (Chazelle and Dobkin, "Optimal Convex Decompositions", 1985), needs a cut from there to another
// corner; a short one from notch to notch may serve both. Which lines cross is decided by exact signs, so there is always such a cut, but
// beside needles that are as thin as rounding errors.

/** The indices of the corners at its ends. */
type Line = readonly [number, number];

/** The inside of an outline with holes, and cuts through it from corner to corner. */
export class Cuts {
  private readonly x: number[];
  private readonly y: number[];
  /**
   * For each corner, the corners to which edges and cuts lead from there: first along the outline, then in the order of their angles, to
   * the side of the y-axis for an edge along the x-axis, and last back along the outline.
   */
  private readonly ways: number[][] = [];
  private readonly cuts: Line[] = [];
  private readonly corners: Grid<number>;
  /** Edges and cuts. */
  private readonly lines: Grid<Line>;

  /** Takes an outline that goes around from the x- to the y-axis, and holes that go around the other way. */
  constructor(outline: Ring, holes: readonly Ring[]) {
    const rings = [outline, ...holes];
    this.x = rings.flatMap(({ x }) => x);
    this.y = rings.flatMap(({ y }) => y);
    for (const { x } of rings) {
      const first = this.ways.length;
      const count = x.length;
      for (let i = 0; i < count; i += 1) {
        this.ways.push([first + ((i + 1) % count), first + ((i + count - 1) % count)]);
      }
    }
    const { x, y } = this;
    this.corners = new Grid(x, y);
    this.lines = new Grid(x, y);
    this.ways.forEach(([next], v) => {
      this.corners.at(x[v]!, y[v]!).push(v);
      this.draw([v, next!]);
    });
  }

  /** Cuts until nothing bends inwards, and removes cuts that are not needed. */
  cut(): void {
    const inward = this.ways.map((_, v) => v).filter((v) => this.gapOf(v) >= 0);
    // Pairs far from each other come last: by then, few corners still bend inwards.
    for (const ring of this.corners.rings) {
      const bends = this.ways.map((_, v) => this.gapOf(v) >= 0);
      const pairs = inward
        .filter((v) => bends[v])
        .flatMap((v) => this.around(v, ring, (w) => w > v && bends[w]! && this.sees(v, w)).map((w): Line => [v, w]));
      pairs.sort((a, b) => this.length(a) - this.length(b));
      for (const [v, w] of pairs) {
        if (this.gapOf(v) >= 0 && this.gapOf(w) >= 0 && this.serves(v, w) && this.serves(w, v) && this.sees(v, w)) {
          this.add(v, w);
        }
      }
    }
    for (const v of inward) {
      while (this.gapOf(v) >= 0) {
        this.add(v, this.next(v));
      }
    }
    this.cuts.sort((a, b) => this.length(b) - this.length(a));
    for (const [v, w] of this.cuts) {
      if (this.isSpare(v, w) && this.isSpare(w, v)) {
        this.ways[v]!.splice(this.ways[v]!.indexOf(w), 1);
        this.ways[w]!.splice(this.ways[w]!.indexOf(v), 1);
      }
    }
  }

  /** The nearest corner for a cut from a notch after which it bends inwards no more; if there is none, one that leaves it bending less. */
  private next(v: number): number {
    const ways = this.ways[v]!;
    const gap = this.gapOf(v);
    for (const ring of this.corners.rings) {
      const served = this.around(v, ring, (w) => this.serves(v, w)).find((w) => this.sees(v, w));
      if (served !== undefined) {
        return served;
      }
    }
    const within = this.corners.rings.flatMap((ring) => this.around(v, ring, (w) => this.placeOf(v, w) === gap + 1));
    const firstSeen = (parts: boolean) =>
      within
        .filter((w) => parts !== this.isNotch(w, v, ways[gap]!))
        // The one that leaves the least bend; of those on one line the nearest.
        .sort((a, b) => this.side(v, a, b))
        .find((w) => this.sees(v, w));
    const found = firstSeen(true) ?? firstSeen(false);
    if (found === undefined) {
      throw new RangeError(
        `decomposeOutline: there must be room for a cut, got none at vertex [${this.x[v]}, ${this.y[v]}]`,
      );
    }
    return found;
  }

  /** The wanted corners between two distances from a corner, the nearest first. */
  private around(v: number, [from, to]: readonly [number, number], isWanted: (w: number) => boolean): number[] {
    const x = this.x[v]!;
    const y = this.y[v]!;
    const found: number[] = [];
    this.corners.within(x - to, y - to, x + to, y + to, (cell) => {
      for (const w of cell) {
        const square = this.square(v, w);
        if (square >= from * from && square < to * to && w !== v && isWanted(w)) found.push(w);
      }
    });
    return found.sort((a, b) => this.square(v, a) - this.square(v, b) || a - b);
  }

  /** The index of the first of two neighbouring ways from a corner between which the inside bends inwards; −1 if there are none. */
  private gapOf(v: number): number {
    const ways = this.ways[v]!;
    for (let k = 0; k + 1 < ways.length; k += 1) {
      if (this.isNotch(ways[k + 1]!, v, ways[k]!)) {
        return k;
      }
    }
    return -1;
  }

  /** The index that a way to another corner has, or would have, among those from a corner. */
  private placeOf(v: number, w: number): number {
    const ways = this.ways[v]!;
    let place = 1;
    while (place + 1 < ways.length && this.comesBefore(v, ways[place]!, w)) {
      place += 1;
    }
    return place;
  }

  private comesBefore(v: number, a: number, b: number): boolean {
    const isLateA = this.isLate(v, a);
    const isLateB = this.isLate(v, b);
    return isLateA === isLateB ? this.side(v, a, b) > 0 : isLateB;
  }

  /** Whether a way is half a turn or more away from the one along the outline. */
  private isLate(v: number, w: number): boolean {
    const first = this.ways[v]![0]!;
    const side = this.side(v, first, w);
    return side < 0 || (side === 0 && this.dot(v, first, w) < 0);
  }

  /** Whether a cut from one corner to another would leave nothing beside it there that bends inwards. */
  private serves(v: number, w: number): boolean {
    const ways = this.ways[v]!;
    const place = this.placeOf(v, w);
    return !this.isNotch(ways[place]!, v, w) && !this.isNotch(w, v, ways[place - 1]!);
  }

  /** Whether a cut is not needed at its first end. */
  private isSpare(v: number, w: number): boolean {
    const ways = this.ways[v]!;
    const place = ways.indexOf(w);
    return !this.isNotch(ways[place + 1]!, v, ways[place - 1]!);
  }

  private add(v: number, w: number): void {
    this.ways[v]!.splice(this.placeOf(v, w), 0, w);
    this.ways[w]!.splice(this.placeOf(w, v), 0, v);
    this.cuts.push([v, w]);
    this.draw([v, w]);
  }

  private draw(line: Line): void {
    this.along(line, (cell) => void cell.push(line));
  }

  /** Visits the edges and cuts near a line, cell by cell. */
  private along([v, w]: Line, visit: (cell: Line[]) => unknown): boolean {
    return this.lines.along(this.x[v]!, this.y[v]!, this.x[w]!, this.y[w]!, visit);
  }

  /** Whether the straight line between two corners goes through the inside alone. */
  private sees(v: number, w: number): boolean {
    return (
      this.opensTo(v, w) &&
      this.opensTo(w, v) &&
      !this.along([v, w], (cell) => cell.some(([a, b]) => this.isBetween(v, w, a, b)))
    );
  }

  /** Whether the line from a corner to another begins in the inside. */
  private opensTo(v: number, w: number): boolean {
    const ways = this.ways[v]!;
    const after = ways[0]!;
    const before = ways.at(-1)!;
    return this.side(before, v, after) > 0
      ? this.side(v, after, w) > 0 && this.side(v, w, before) > 0
      : !(this.side(v, before, w) >= 0 && this.side(v, w, after) >= 0);
  }

  /** Whether an edge touches the line between two corners, other than by a common end. */
  private isBetween(v: number, w: number, a: number, b: number): boolean {
    const { x, y } = this;
    const isEnd = a === v || a === w;
    if (isEnd || b === v || b === w) {
      const other = isEnd ? b : a;
      return other === v || other === w || isOn(x[v]!, y[v]!, x[w]!, y[w]!, x[other]!, y[other]!);
    }
    return segmentsTouch(x[v]!, y[v]!, x[w]!, y[w]!, x[a]!, y[a]!, x[b]!, y[b]!);
  }

  /** The parts that edges and cuts enclose. */
  parts(): Vec2[][] {
    const isDone = this.ways.map((ways) => ways.map(() => false));
    const parts: Vec2[][] = [];
    for (let start = 0; start < this.ways.length; start += 1) {
      // The last way from a corner goes back along the outline: beside it is the outside.
      for (let k = 0; k + 1 < this.ways[start]!.length; k += 1) {
        const part: number[] = [];
        let v = start;
        for (let way = k; !isDone[v]![way]; ) {
          isDone[v]![way] = true;
          part.push(v);
          const to = this.ways[v]![way]!;
          way = this.ways[to]!.indexOf(v, 1) - 1;
          v = to;
        }
        const corners = this.distinct(part);
        if (this.isSolid(corners)) parts.push(corners.map((at): Vec2 => [this.x[at]!, this.y[at]!]));
      }
    }
    return parts;
  }

  /**
   * A part without corners that no polygon may have: those at the place of a neighbour, of which the same one is kept in all parts, and
   * tips of needles.
   */
  private distinct(part: readonly number[]): readonly number[] {
    const { length } = part;
    const isRepeat = (v: number, i: number) =>
      [part[(i + 1) % length]!, part[(i + length - 1) % length]!].some(
        (w) => w < v && this.square(v, w) <= VERTEX_TOLERANCE * VERTEX_TOLERANCE,
      );
    const isTip = (v: number, i: number) =>
      length > 3 && this.bendAt(part[(i + length - 1) % length]!, v, part[(i + 1) % length]!) === LEFT;
    const repeat = part.findIndex(isRepeat);
    const dropped = repeat < 0 ? part.findIndex(isTip) : repeat;
    return dropped < 0 ? part : this.distinct(part.filter((_, i) => i !== dropped));
  }

  /** Whether a part is more than a line. */
  private isSolid(part: readonly number[]): boolean {
    const { length } = part;
    const isCorner = (v: number, i: number) =>
      this.bendAt(part[(i + length - 1) % length]!, v, part[(i + 1) % length]!) === RIGHT;
    return part.filter(isCorner).length >= 3;
  }

  private side(a: number, b: number, c: number): number {
    const { x, y } = this;
    return orient(x[a]!, y[a]!, x[b]!, y[b]!, x[c]!, y[c]!);
  }

  /**
   * Whether the inside bends inwards at the second of three corners. A needle does not count, however thin it is: a cut to an edge that is
   * nearly straight may leave one.
   */
  private isNotch(a: number, b: number, c: number): boolean {
    return this.bendAt(a, b, c) === LEFT && !(this.dot(b, a, c) > 0 && this.side(a, b, c) > 0);
  }

  private bendAt(a: number, b: number, c: number): number {
    const { x, y } = this;
    return bend(x[a]!, y[a]!, x[b]!, y[b]!, x[c]!, y[c]!);
  }

  private dot(at: number, a: number, b: number): number {
    const { x, y } = this;
    return (x[a]! - x[at]!) * (x[b]! - x[at]!) + (y[a]! - y[at]!) * (y[b]! - y[at]!);
  }

  private length([a, b]: Line): number {
    return this.square(a, b);
  }

  private square(a: number, b: number): number {
    return this.dot(a, b, b);
  }
}
