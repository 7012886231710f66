import { BOX } from '../broadphase/layout.js';
import { sortFirst } from '../math/sort.js';
import type { Shape } from '../shape/shape.js';

/** Shapes on their ways, by the bounds of all places that each has on it: sorted by where these begin. */
export class Ways {
  count = 0;
  /** What lies beyond the count is for later, here and in the other lists. */
  readonly shapes: Shape[] = [];
  /** Index of the mover of each shape. */
  readonly movers: number[] = [];
  /** Of the last search: which, in the order in which they were added. */
  readonly found: number[] = [];
  /** minX, minY, maxX, maxY of each. */
  private readonly boxes: number[] = [];
  /** Which, from the left to the right once the first is looked for: often none is. */
  private readonly order: number[] = [];
  private isSorted = false;
  /** The largest width, m. */
  private widest = 0.5;
  private readonly isFartherLeft = (a: number, b: number): boolean => this.boxes[a * BOX]! < this.boxes[b * BOX]!;

  clear(): void {
    this.count = 0;
    this.widest = 0;
    this.isSorted = false;
  }

  /** Adds a shape with its bounds. */
  add(shape: Shape, mover: number, bounds: Float64Array): void {
    const { count } = this;
    this.shapes[count] = shape;
    this.movers[count] = mover;
    this.order[count] = count;
    for (let i = 0; i < BOX; i += 1) {
      this.boxes[count * BOX + i] = bounds[i]!;
    }
    this.widest = Math.max(this.widest, bounds[2]! - bounds[0]!);
    this.count += 1;
  }

  /** Looks for those whose bounds overlap others, when all are added. @returns how many were found. */
  find(bounds: Float64Array): number {
    if (!this.isSorted) {
      sortFirst(this.order, this.count, this.isFartherLeft);
      this.isSorted = true;
    }
    const { boxes, count, order, found } = this;
    const minX = bounds[0]!;
    const minY = bounds[1]!;
    const maxX = bounds[2]!;
    const maxY = bounds[3]!;
    const left = minX - this.widest;
    let first = 0;
    for (let end = count; first < end; ) {
      const middle = (first + end) >> 1;
      if (boxes[order[middle]! * BOX]! < left) {
        first = middle + 1;
      } else {
        end = middle;
      }
    }
    let size = 0;
    for (; first < count; first += 1) {
      const which = order[first]!;
      const at = which * BOX;
      if (boxes[at]! > maxX) {
        break;
      }
      // Combined as numbers: branches that go either way would cost more than the comparisons.
      if (+(boxes[at + 2]! >= minX) & +(boxes[at + 1]! <= maxY) & +(boxes[at + 3]! >= minY)) {
        let k = size;
        for (; k > 0 && found[k - 1]! > which; k -= 1) {
          found[k] = found[k - 1]!;
        }
        found[k] = which;
        size += 1;
      }
    }
    return size;
  }
}
