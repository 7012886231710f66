import type { Shape } from '../shape/shape.js';

/**
 * Shapes on their ways, by the bounds of all places that each has on it: sorted into columns by where their bounds begin, about one for each.
 */
export class Ways {
  count = 0;
  /** What lies beyond the count is for later. */
  readonly shapes: Shape[] = [];
  /** Index of the mover of each shape. */
  movers = new Int32Array(16);
  /** Of the last search: which, in the order in which they were added. */
  found = new Int32Array(16);
  /** minX, minY, maxX, maxY of each. */
  private boxes = new Float64Array(16 * BOX);
  /** Column by column: which are in it. */
  private order = new Int32Array(16);
  /** Where the column of each begins in `order`, and where the last one ends. */
  private starts = new Int32Array(17);
  private left = 0.5;
  /** Columns per metre. */
  private scale = 0.5;
  /** The largest width, m. */
  private widest = 0.5;
  /** m. Where a column is asked for: an argument would be boxed. */
  private x = 0.5;

  clear(): void {
    this.count = 0;
  }

  /** Adds a shape with its bounds. */
  add(shape: Shape, mover: number, bounds: Float64Array): void {
    const { count } = this;
    if (count === this.movers.length) {
      this.grow();
    }
    this.shapes[count] = shape;
    this.movers[count] = mover;
    this.boxes.set(bounds, count * BOX);
    this.count += 1;
  }

  /** To be called when all are added, before any is looked for. */
  sort(): void {
    const { boxes, count, order, starts } = this;
    let left = Infinity;
    let right = -Infinity;
    let widest = 0;
    for (let at = 0; at < count * BOX; at += BOX) {
      left = Math.min(left, boxes[at]!);
      right = Math.max(right, boxes[at]!);
      widest = Math.max(widest, boxes[at + 2]! - boxes[at]!);
    }
    this.left = left;
    this.scale = count / (right - left);
    this.widest = widest;
    starts.fill(0, 0, count + 1);
    for (let i = 0; i < count; i += 1) {
      this.x = boxes[i * BOX]!;
      const column = this.column();
      starts[column] = starts[column]! + 1;
    }
    for (let column = 1; column <= count; column += 1) {
      starts[column] = starts[column]! + starts[column - 1]!;
    }
    for (let i = count - 1; i >= 0; i -= 1) {
      this.x = boxes[i * BOX]!;
      const column = this.column();
      starts[column] = starts[column]! - 1;
      order[starts[column]!] = i;
    }
  }

  /** Looks for those whose bounds overlap others. @returns how many were found. */
  find(bounds: Float64Array): number {
    const { boxes, order, starts, found } = this;
    const minX = bounds[0]!;
    const minY = bounds[1]!;
    const maxX = bounds[2]!;
    const maxY = bounds[3]!;
    if (this.count === 0) {
      return 0;
    }
    this.x = maxX;
    const end = starts[this.column() + 1]!;
    this.x = minX - this.widest;
    let size = 0;
    for (let i = starts[this.column()]!; i < end; i += 1) {
      const which = order[i]!;
      const at = which * BOX;
      if (boxes[at]! <= maxX && boxes[at + 2]! >= minX && boxes[at + 1]! <= maxY && boxes[at + 3]! >= minY) {
        let k = size;
        while (k > 0 && found[k - 1]! > which) {
          found[k] = found[k - 1]!;
          k -= 1;
        }
        found[k] = which;
        size += 1;
      }
    }
    return size;
  }

  /** That of `x`: the first column for what is farther left or nowhere, the last one for what is farther right. */
  private column(): number {
    return Math.max(0, Math.min(this.count - 1, (this.x - this.left) * this.scale)) | 0;
  }

  private grow(): void {
    const size = 2 * this.movers.length;
    const { movers, boxes } = this;
    this.movers = new Int32Array(size);
    this.movers.set(movers);
    this.boxes = new Float64Array(size * BOX);
    this.boxes.set(boxes);
    this.found = new Int32Array(size);
    this.order = new Int32Array(size);
    this.starts = new Int32Array(size + 1);
  }
}

/** Numbers per shape in `boxes`. */
const BOX = 4;
