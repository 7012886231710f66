import { areBeside, misses } from './boxes.js';
import { BOX, NONE, STRANGER } from './layout.js';
import { TreeShape } from './tree-shape.js';

/**
 * 1 − 2⁻⁵⁰. The factor at which a ray enters a box is reckoned too small, by more than rounding can make it too large: a ray must not miss
 * a corner that it touches.
 */
const EARLY = 1 - 4 * Number.EPSILON;

/**
 * A dynamic bounding volume tree over packed arrays. Nodes are numbered; freed numbers are reused. `margin` is by how much leaves are
 * larger than their bounds on all sides, m. Changes take effect when the tree is next asked, see {@link TreeShape}.
 */
export class PackedTree<T> extends TreeShape<T> {
  private stack = new Int32Array(64);
  /** The box of a query: scratch. */
  private readonly asked = new Float64Array(BOX);
  /** The stack for the next cast; `null` during one. */
  private castStack: Int32Array | null = null;

  constructor(private readonly margin: number) {
    super();
  }

  /** The root node, −1 for an empty tree. */
  get root(): number {
    this.mend();
    return this.top;
  }

  /**
   * Adds a leaf with the box `[minX, minY, maxX, maxY]`, grown by the margin on all sides. `tag` is a number for whoever needs no more of
   * the item; see `kins` for `kin`. @returns the node.
   */
  insert(item: T, bounds: ArrayLike<number>, tag = NONE, kin = NONE): number {
    const leaf = this.allocate();
    this.items[leaf] = item;
    this.right[leaf] = tag;
    this.kins[leaf] = kin;
    this.setBox(leaf, bounds);
    this.queue(leaf);
    return leaf;
  }

  /**
   * Gives a leaf another box. It stays where it is in the tree while the box around it and its sibling has no larger perimeter than both
   * together: exchanges above it do the rest. If it moved on its own and stayed, it would enlarge the boxes of those it was once next to.
   */
  move(leaf: number, bounds: ArrayLike<number>): void {
    this.setBox(leaf, bounds);
    if (this.isQueued(leaf)) {
      return;
    }
    const sibling = this.siblingOf(leaf);
    if (sibling === NONE || areBeside(this.boxes, leaf, sibling)) {
      this.age(this.parent[leaf]!);
    } else {
      this.detach(leaf);
      this.queue(leaf);
    }
  }

  remove(leaf: number): void {
    if (this.isQueued(leaf)) {
      this.unqueue(leaf);
    } else {
      this.detach(leaf);
    }
    this.release(leaf);
  }

  isLeaf(node: number): boolean {
    return this.left[node] === NONE;
  }

  /**
   * Writes the leaves whose boxes overlap `bounds` to `out` from `count` on, except those of a kin: each shape of a body of many lies amid
   * the others. It descends as a cast does. @returns the new count.
   */
  query(bounds: ArrayLike<number>, out: number[], count: number, kin = STRANGER): number {
    let node = this.root;
    const { boxes, left, right, kins, asked } = this;
    for (let i = 0; i < BOX; i += 1) {
      asked[i] = bounds[i]!;
    }
    let found = count;
    let top = 0;
    if (node === NONE || misses(boxes, node, asked) !== 0) {
      return found;
    }
    const stack = this.readyStack();
    for (;;) {
      const a = left[node]!;
      if (a === NONE) {
        out[found] = node;
        found += 1;
      } else {
        const b = right[node]!;
        const missesA = misses(boxes, a, asked) | +(kins[a] === kin);
        const missesB = misses(boxes, b, asked) | +(kins[b] === kin);
        if ((missesA | missesB) === 0) {
          stack[top] = b;
          top += 1;
          node = a;
          continue;
        }
        if ((missesA & missesB) === 0) {
          node = missesA === 0 ? a : b;
          continue;
        }
      }
      if (top === 0) return found;
      top -= 1;
      node = stack[top]!;
    }
  }

  /**
   * Visits the items of the leaves whose boxes meet a box that moves by d · f, 0 ≤ f ≤ limit, and some that it just misses. Of two subtrees
   * the one nearer along the way comes first. A ray is a box without width and height. `visit` returns the new limit, and the last one is
   * returned in the end.
   *
   * Along x both overlap from f = (near − head) / d to (far − tail) / d; they meet where it is so along both axes at once (slabs; Kay &
   * Kajiya 1986). With d = 0 that is from −∞ to ∞, or to −∞ or from ∞ if one passes the other by; and NaN for sides that coincide, for
   * which no comparison holds: so what is asked is whether they miss each other. The answers are combined as numbers, as branches that go
   * either way half of the time would cost more than all the rest. The children are asked, rather than the node itself, so that a walk goes
   * straight down to the one that is met.
   */
  cast(start: ArrayLike<number>, direction: ArrayLike<number>, limit: number, visit: (item: T) => number): number {
    let node = this.root;
    if (node === NONE) {
      return limit;
    }
    const dx = direction[0]!;
    const dy = direction[1]!;
    const outX = 1 / dx;
    const outY = 1 / dy;
    const inX = outX * EARLY;
    const inY = outY * EARLY;
    // Where in a box the near sides are, which the ray comes to first, and the far ones.
    const nearX = outX < 0 ? 2 : 0;
    const nearY = outY < 0 ? 3 : 1;
    const farX = 2 - nearX;
    const farY = 4 - nearY;
    // The leading and the trailing sides of the box that is cast.
    const headX = start[farX]!;
    const headY = start[farY]!;
    const tailX = start[nearX]!;
    const tailY = start[nearY]!;
    const { boxes, left, right } = this;
    const stack = this.takeStack();
    let end = limit;
    let top = 0;
    for (;;) {
      const a = left[node]!;
      if (a === NONE) {
        // A visit may have taken others out of the tree.
        const item = this.items[node];
        if (item !== null && item !== undefined) end = visit(item);
      } else {
        const b = right[node]!;
        const i = BOX * a;
        const j = BOX * b;
        const inAX = (boxes[i + nearX]! - headX) * inX;
        const inAY = (boxes[i + nearY]! - headY) * inY;
        const outAX = (boxes[i + farX]! - tailX) * outX;
        const outAY = (boxes[i + farY]! - tailY) * outY;
        const missesA = +(inAX > outAY) | +(inAY > outAX) | +(inAX > end) | +(inAY > end) | +(outAX < 0) | +(outAY < 0);
        const inBX = (boxes[j + nearX]! - headX) * inX;
        const inBY = (boxes[j + nearY]! - headY) * inY;
        const outBX = (boxes[j + farX]! - tailX) * outX;
        const outBY = (boxes[j + farY]! - tailY) * outY;
        const missesB = +(inBX > outBY) | +(inBY > outBX) | +(inBX > end) | +(inBY > end) | +(outBX < 0) | +(outBY < 0);
        if ((missesA | missesB) === 0) {
          const x = boxes[i]! + boxes[i + 2]! - boxes[j]! - boxes[j + 2]!;
          const y = boxes[i + 1]! + boxes[i + 3]! - boxes[j + 1]! - boxes[j + 3]!;
          // All bits if B is the nearer one, else none.
          const swapped = (a ^ b) & -(x * dx + y * dy > 0);
          stack[top] = b ^ swapped;
          top += 1;
          node = a ^ swapped;
          continue;
        }
        if ((missesA & missesB) === 0) {
          node = missesA === 0 ? a : b;
          continue;
        }
      }
      // Back to what was left for later. The limit may have become smaller since then.
      do {
        if (top === 0) {
          this.castStack = stack;
          return end;
        }
        top -= 1;
        node = stack[top]!;
      } while ((boxes[BOX * node + nearX]! - headX) * inX > end || (boxes[BOX * node + nearY]! - headY) * inY > end);
    }
  }

  /** A stack for a cast; a cast within the `visit` of another takes a new one. */
  private takeStack(): Int32Array {
    const { castStack } = this;
    this.castStack = null;
    const needed = this.level[this.top]! + 3;
    return castStack !== null && castStack.length >= needed ? castStack : new Int32Array(2 * needed);
  }

  /** Whether the box of a node contains `bounds`. */
  contains(node: number, bounds: ArrayLike<number>): boolean {
    const { boxes } = this;
    const at = BOX * node;
    return (
      boxes[at]! <= bounds[0]! &&
      boxes[at + 1]! <= bounds[1]! &&
      boxes[at + 2]! >= bounds[2]! &&
      boxes[at + 3]! >= bounds[3]!
    );
  }

  /** Whether the box of a node and that of a node of another tree overlap. */
  overlaps(node: number, other: PackedTree<T>, otherNode: number): boolean {
    const a = this.boxes;
    const b = other.boxes;
    const i = BOX * node;
    const j = BOX * otherNode;
    return a[i]! <= b[j + 2]! && a[i + 2]! >= b[j]! && a[i + 1]! <= b[j + 3]! && a[i + 3]! >= b[j + 1]!;
  }

  /** A stack that is deep enough: a walk holds at most one node a level besides its own. */
  private readyStack(): Int32Array {
    const needed = this.level[this.top]! + 2;
    if (this.stack.length < needed) {
      this.stack = new Int32Array(2 * needed);
    }
    return this.stack;
  }

  private setBox(leaf: number, bounds: ArrayLike<number>): void {
    const at = BOX * leaf;
    this.boxes[at] = bounds[0]! - this.margin;
    this.boxes[at + 1] = bounds[1]! - this.margin;
    this.boxes[at + 2] = bounds[2]! + this.margin;
    this.boxes[at + 3] = bounds[3]! + this.margin;
  }
}
