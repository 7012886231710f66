import { BOX } from '../../broadphase/layout.js';
import { widened } from '../../math/doubles.js';
import { sortFirst } from '../../math/sort.js';
import type { Shape } from '../../shape/shape.js';

/** How many boxes are put into a larger one. */
const FAN = 4;
/** Largest coordinate of the grid along each axis. */
const PLACES = 0x7fff;

/**
 * Shapes on their ways, with the bounds of all places that each has on it. Once all are added, at the first search, they are sorted in
 * Morton order, by the interleaved bits of their centres' coordinates (Morton 1966), so that neighbours in the order are near each other.
 * Every `FAN` of them are put into a larger box, and every `FAN` of these, up to one (a packed tree; Roussopoulos & Leifker 1985). Refused:
 * sorting from left to right, where a wide one, or many above each other, would make each search go through all of them.
 */
export class Ways {
  count = 0;
  /** What lies beyond the count is used again, here and in the other lists. */
  readonly shapes: Shape[] = [];
  /** Index of the mover of each shape. */
  readonly movers: number[] = [];
  /** The result of the last search: indices, in the order in which the shapes were added. */
  readonly found: number[] = [];
  /** minX, minY, maxX, maxY of each. */
  private boxes = new Float64Array(0);
  /** The indices in Morton order, and the Morton code of each. */
  private readonly order: number[] = [];
  private readonly codes: number[] = [];
  /** The boxes in that order, then those around each group of them, and so on; the last are those of one group. */
  private tree = new Float64Array(0);
  /** For each box in the tree the first of the group that it encloses, or for a single way minus its index, minus 1. */
  private below = new Int32Array(0);
  private top = 0;
  private isBuilt = false;
  /** Whether one of them is a sensor. */
  hasSensors = false;
  private readonly stack: number[] = [];
  private readonly comesBefore = (a: number, b: number): boolean => this.codes[a]! < this.codes[b]!;

  clear(): void {
    this.count = 0;
    this.isBuilt = false;
    this.hasSensors = false;
  }

  /** Adds a shape with its bounds. */
  add(shape: Shape, mover: number, bounds: Float64Array): void {
    const { count } = this;
    const at = BOX * count;
    if (at === this.boxes.length) {
      this.grow();
    }
    this.shapes[count] = shape;
    this.movers[count] = mover;
    this.hasSensors ||= shape.sensor;
    for (let i = 0; i < BOX; i += 1) {
      this.boxes[at + i] = bounds[i]!;
    }
    this.count += 1;
  }

  private grow(): void {
    const room = 2 * this.count + 16;
    this.boxes = widened(this.boxes, new Float64Array(BOX * room));
    this.tree = new Float64Array(BOX * (2 * room + 64));
    this.below = new Int32Array(2 * room + 64);
  }

  /**
   * Finds the ways whose bounds overlap these, without those of one mover; to be called when all are added. @returns how many were found.
   */
  find(bounds: Float64Array, not = -1): number {
    if (this.count === 0) {
      return 0;
    }
    if (!this.isBuilt) {
      this.build();
    }
    const { tree, below, stack, found, movers } = this;
    const minX = bounds[0]!;
    const minY = bounds[1]!;
    const maxX = bounds[2]!;
    const maxY = bounds[3]!;
    let size = 0;
    stack[0] = this.top;
    for (let height = 1; height > 0; ) {
      height -= 1;
      const first = stack[height]!;
      for (let i = first; i < first + FAN; i += 1) {
        const at = BOX * i;
        // Combined as numbers: branches that may go either way would cost more than the comparisons.
        if (+(tree[at]! <= maxX) & +(tree[at + 1]! <= maxY) & +(tree[at + 2]! >= minX) & +(tree[at + 3]! >= minY)) {
          const next = below[i]!;
          if (next >= 0) {
            stack[height] = next;
            height += 1;
          } else if (movers[~next] !== not) {
            found[size] = ~next;
            size += 1;
          }
        }
      }
    }
    sortFirst(found, size, isLess);
    return size;
  }

  private build(): void {
    const { count, boxes, order, tree, below } = this;
    this.encode();
    sortFirst(order, count, this.comesBefore);
    for (let i = 0; i < count; i += 1) {
      const which = order[i]!;
      below[i] = ~which;
      for (let k = 0; k < BOX; k += 1) {
        tree[BOX * i + k] = boxes[BOX * which + k]!;
      }
    }
    let from = 0;
    let to = this.fill(count);
    while (to - from > FAN) {
      let next = to;
      for (let i = from; i < to; i += FAN, next += 1) {
        this.enclose(i, next);
      }
      from = to;
      to = this.fill(next);
    }
    this.top = from;
    this.isBuilt = true;
  }

  /** Fills up a group with boxes that overlap nothing. @returns where it ends. */
  private fill(from: number): number {
    const to = FAN * Math.ceil(from / FAN);
    this.tree.fill(NaN, BOX * from, BOX * to);
    return to;
  }

  /** Puts a box around a group. */
  private enclose(first: number, into: number): void {
    const { tree } = this;
    this.below[into] = first;
    for (let k = 0; k < BOX; k += 1) {
      let most = k < 2 ? Infinity : -Infinity;
      for (let i = first; i < first + FAN; i += 1) {
        const value = tree[BOX * i + k]!;
        if (k < 2 ? value < most : value > most) most = value;
      }
      tree[BOX * into + k] = most;
    }
  }

  /** Finds the Morton code of each: from the place of its centre among those of all. */
  private encode(): void {
    const { count, boxes, order, codes } = this;
    let minX = Infinity;
    let minY = Infinity;
    let maxX = -Infinity;
    let maxY = -Infinity;
    for (let at = 0; at < BOX * count; at += BOX) {
      const x = boxes[at]! + boxes[at + 2]!;
      const y = boxes[at + 1]! + boxes[at + 3]!;
      minX = x < minX ? x : minX;
      minY = y < minY ? y : minY;
      maxX = x > maxX ? x : maxX;
      maxY = y > maxY ? y : maxY;
    }
    const scaleX = maxX > minX ? PLACES / (maxX - minX) : 0;
    const scaleY = maxY > minY ? PLACES / (maxY - minY) : 0;
    for (let i = 0; i < count; i += 1) {
      const at = BOX * i;
      const x = spread((boxes[at]! + boxes[at + 2]! - minX) * scaleX);
      const y = spread((boxes[at + 1]! + boxes[at + 3]! - minY) * scaleY);
      order[i] = i;
      codes[i] = x | (y << 1);
    }
  }
}

function isLess(a: number, b: number): boolean {
  return a < b;
}

/** The lower 15 bits of a number, with a zero between each two. */
function spread(value: number): number {
  let bits = value & PLACES;
  bits = (bits | (bits << 8)) & 0x00ff00ff;
  bits = (bits | (bits << 4)) & 0x0f0f0f0f;
  bits = (bits | (bits << 2)) & 0x33333333;
  return (bits | (bits << 1)) & 0x55555555;
}
