import { grown, widened } from '../math/doubles.js';
import { areBeside, misses } from './boxes.js';
import { BOX, MAX_LEAN, NONE } from './layout.js';

/** 1 − 2⁻⁵⁰. Where a ray enters a box is reckoned early by more than rounding can make it late, as it must not miss a corner that it touches. */
const EARLY = 1 - 4 * Number.EPSILON;

/**
 * A dynamic bounding box tree over packed arrays. A new leaf goes where it adds the least perimeter, by branch and descent (Catto, "Dynamic Bounding
 * Volume Hierarchies", GDC 2019). On the way up every node exchanges a child for a grandchild where that makes a box smaller (Kopta et al., "Fast,
 * effective BVH updates for animated scenes", 2012) or keeps the height logarithmic (Adelson-Velsky & Landis 1962). Nodes are numbered; freed
 * numbers are reused. `margin`, m, is by how much leaves are larger on all sides.
 */
export class PackedTree<T> {
  /** minX, minY, maxX, maxY of each node. */
  boxes = new Float64Array(16 * BOX);
  /** The two subtrees of an inner node; in a leaf `left` is −1, and `right` the number that it was given. */
  left = new Int32Array(16);
  right = new Int32Array(16);
  root = NONE;
  /** What each leaf holds. */
  readonly items: (T | null)[] = [];

  private parent = new Int32Array(16);
  private level = new Uint8Array(16);
  private used = 0;
  private free = NONE;
  private stack = new Int32Array(64);
  /** For the next cast; `null` during one. */
  private castStack: Int32Array | null = null;
  /** The best exchange that was found: what it saves, whose child is given, and which one is kept. */
  private saved = 0.5;
  private high = NONE;
  private keep = NONE;
  /** The box that is being inserted. */
  private readonly box = new Float64Array(BOX);

  constructor(private readonly margin: number) {}

  /** Number of levels above the leaves; 0 for one leaf and for none. */
  get height(): number {
    return this.root === NONE ? 0 : this.level[this.root]!;
  }

  /** Adds a leaf with the box `[minX, minY, maxX, maxY]`, grown by the margin on all sides, and a number for whoever looks no further. @returns the node. */
  insert(item: T, bounds: ArrayLike<number>, tag = NONE): number {
    const leaf = this.allocate();
    this.items[leaf] = item;
    this.right[leaf] = tag;
    this.setBox(leaf, bounds);
    this.attach(leaf);
    return leaf;
  }

  /**
   * Gives a leaf another box. It stays where it is in the tree while the box around it and its sibling has no larger perimeter than both together: the
   * exchanges on the way up see to the rest. What goes its own way would drag along the boxes of those that it once was next to.
   */
  move(leaf: number, bounds: ArrayLike<number>): void {
    this.setBox(leaf, bounds);
    const joint = this.parent[leaf]!;
    const sibling = joint === NONE ? leaf : this.otherChild(joint, leaf);
    if (areBeside(this.boxes, leaf, sibling)) {
      this.refit(joint);
    } else {
      this.detach(leaf);
      this.attach(leaf);
    }
  }

  remove(leaf: number): void {
    this.detach(leaf);
    this.release(leaf);
  }

  clear(): void {
    this.items.length = 0;
    this.used = 0;
    this.free = NONE;
    this.root = NONE;
  }

  isLeaf(node: number): boolean {
    return this.left[node] === NONE;
  }

  /** Writes the leaves whose boxes overlap `bounds` to `out` from `count` on. It goes straight down as a cast does. @returns the new count. */
  query(bounds: ArrayLike<number>, out: number[], count: number): number {
    const minX = bounds[0]!;
    const minY = bounds[1]!;
    const maxX = bounds[2]!;
    const maxY = bounds[3]!;
    const { boxes, left, right, stack } = this.ready();
    let found = count;
    let top = 0;
    let node = this.root;
    if (node === NONE || misses(boxes, node, minX, minY, maxX, maxY) !== 0) {
      return found;
    }
    for (;;) {
      const a = left[node]!;
      if (a === NONE) {
        out[found] = node;
        found += 1;
      } else {
        const b = right[node]!;
        const missesA = misses(boxes, a, minX, minY, maxX, maxY);
        const missesB = misses(boxes, b, minX, minY, maxX, maxY);
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
   * Visits what the leaves hold whose boxes the ray o + d · f, 0 ≤ f ≤ limit, meets, and some that it just misses; of two subtrees the one that
   * lies nearer along the ray comes first. `visit` returns the new limit, which is returned in the end.
   *
   * Along x the ray is between the sides of a box from f = (near − o) / d to (far − o) / d; it meets the box where it is so along both axes
   * at once (slabs; Kay & Kajiya 1986). With d = 0 that is from −∞ to ∞, or to −∞ or from ∞ if it passes by; and NaN for a side that it
   * lies in, for which no comparison holds: so what is asked is whether the ray misses. The answers are combined as numbers, as branches that
   * go either way half of the time would cost more than all the rest; it is the children that are asked, so that a walk goes straight down to one that is met.
   */
  cast(origin: ArrayLike<number>, direction: ArrayLike<number>, limit: number, visit: (item: T) => number): number {
    if (this.root === NONE) {
      return limit;
    }
    const ox = origin[0]!;
    const oy = origin[1]!;
    const dx = direction[0]!;
    const dy = direction[1]!;
    const outX = 1 / dx;
    const outY = 1 / dy;
    const inX = outX * EARLY;
    const inY = outY * EARLY;
    // Where in a box the sides are that the ray comes to first, and the opposite ones.
    const nearX = outX < 0 ? 2 : 0;
    const nearY = outY < 0 ? 3 : 1;
    const farX = 2 - nearX;
    const farY = 4 - nearY;
    const { boxes, left, right } = this;
    const stack = this.takeStack();
    let end = limit;
    let top = 0;
    let node = this.root;
    for (;;) {
      const a = left[node]!;
      if (a === NONE) {
        end = visit(this.items[node]!);
      } else {
        const b = right[node]!;
        const i = BOX * a;
        const j = BOX * b;
        const inAX = (boxes[i + nearX]! - ox) * inX;
        const inAY = (boxes[i + nearY]! - oy) * inY;
        const outAX = (boxes[i + farX]! - ox) * outX;
        const outAY = (boxes[i + farY]! - oy) * outY;
        const missesA = +(inAX > outAY) | +(inAY > outAX) | +(inAX > end) | +(inAY > end) | +(outAX < 0) | +(outAY < 0);
        const inBX = (boxes[j + nearX]! - ox) * inX;
        const inBY = (boxes[j + nearY]! - oy) * inY;
        const outBX = (boxes[j + farX]! - ox) * outX;
        const outBY = (boxes[j + farY]! - oy) * outY;
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
      // Back to what was left for later. The limit may have come nearer since then.
      do {
        if (top === 0) {
          this.castStack = stack;
          return end;
        }
        top -= 1;
        node = stack[top]!;
      } while ((boxes[BOX * node + nearX]! - ox) * inX > end || (boxes[BOX * node + nearY]! - oy) * inY > end);
    }
  }

  /** A stack for a cast; one that is made within the `visit` of another takes a new one. */
  private takeStack(): Int32Array {
    const { castStack } = this;
    this.castStack = null;
    const needed = this.height + 3;
    return castStack !== null && castStack.length >= needed ? castStack : new Int32Array(2 * needed);
  }

  /** Copies the box of a node to `box`, and returns that. */
  boxOf(node: number, box: Float64Array = new Float64Array(BOX)): Float64Array {
    const { boxes } = this;
    const at = BOX * node;
    box[0] = boxes[at]!;
    box[1] = boxes[at + 1]!;
    box[2] = boxes[at + 2]!;
    box[3] = boxes[at + 3]!;
    return box;
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

  /** A stack that is deep enough: a walk holds at most one node a level beside its own. */
  private ready(): this {
    if (this.stack.length < this.height + 2) {
      this.stack = new Int32Array(2 * (this.height + 2));
    }
    return this;
  }

  private setBox(leaf: number, bounds: ArrayLike<number>): void {
    const at = BOX * leaf;
    this.boxes[at] = bounds[0]! - this.margin;
    this.boxes[at + 1] = bounds[1]! - this.margin;
    this.boxes[at + 2] = bounds[2]! + this.margin;
    this.boxes[at + 3] = bounds[3]! + this.margin;
  }

  private allocate(): number {
    let node = this.free;
    if (node !== NONE) {
      this.free = this.parent[node]!;
    } else {
      node = this.used;
      this.used += 1;
      if (node === this.left.length) {
        this.grow();
      }
    }
    this.left[node] = NONE;
    this.right[node] = NONE;
    this.parent[node] = NONE;
    this.level[node] = 0;
    this.items[node] = null;
    return node;
  }

  private release(node: number): void {
    this.items[node] = null;
    this.parent[node] = this.free;
    this.free = node;
  }

  private grow(): void {
    const size = grown(this.left.length);
    this.boxes = widened(this.boxes, new Float64Array(size * BOX));
    this.left = widened(this.left, new Int32Array(size));
    this.right = widened(this.right, new Int32Array(size));
    this.parent = widened(this.parent, new Int32Array(size));
    this.level = widened(this.level, new Uint8Array(size));
  }

  private attach(leaf: number): void {
    if (this.root === NONE) {
      this.root = leaf;
      this.parent[leaf] = NONE;
      return;
    }
    const sibling = this.bestSibling(leaf);
    const above = this.parent[sibling]!;
    const joint = this.allocate();
    this.left[joint] = sibling;
    this.right[joint] = leaf;
    this.parent[joint] = above;
    this.parent[sibling] = joint;
    this.parent[leaf] = joint;
    this.replaceChild(above, sibling, joint);
    this.refit(joint);
  }

  private detach(leaf: number): void {
    const joint = this.parent[leaf]!;
    if (joint === NONE) {
      this.root = NONE;
      return;
    }
    const sibling = this.otherChild(joint, leaf);
    const above = this.parent[joint]!;
    this.parent[sibling] = above;
    this.replaceChild(above, joint, sibling);
    this.release(joint);
    this.refit(above);
  }

  private otherChild(node: number, child: number): number {
    return this.left[node] === child ? this.right[node]! : this.left[node]!;
  }

  private replaceChild(parent: number, before: number, after: number): void {
    if (parent === NONE) {
      this.root = after;
    } else if (this.left[parent] === before) {
      this.left[parent] = after;
    } else {
      this.right[parent] = after;
    }
  }

  /** Walks down to where pairing with the leaf costs the least perimeter, as long as going down can be cheaper than stopping. */
  private bestSibling(leaf: number): number {
    this.boxOf(leaf, this.box);
    let node = this.root;
    while (this.left[node] !== NONE) {
      const joined = this.joinedPerimeter(node);
      const stop = 2 * joined;
      const inherited = 2 * (joined - this.perimeter(node));
      const viaLeft = this.descentCost(this.left[node]!) + inherited;
      const viaRight = this.descentCost(this.right[node]!) + inherited;
      if (stop < viaLeft && stop < viaRight) {
        break;
      }
      node = viaLeft < viaRight ? this.left[node]! : this.right[node]!;
    }
    return node;
  }

  private descentCost(node: number): number {
    const joined = this.joinedPerimeter(node);
    return this.left[node] === NONE ? joined : joined - this.perimeter(node);
  }

  private perimeter(node: number): number {
    const at = BOX * node;
    return this.boxes[at + 2]! - this.boxes[at]! + (this.boxes[at + 3]! - this.boxes[at + 1]!);
  }

  /** Perimeter of the union of a node and the box that is being inserted. */
  private joinedPerimeter(node: number): number {
    const { boxes, box } = this;
    const at = BOX * node;
    const x = Math.max(boxes[at + 2]!, box[2]!) - Math.min(boxes[at]!, box[0]!);
    const y = Math.max(boxes[at + 3]!, box[3]!) - Math.min(boxes[at + 1]!, box[1]!);
    return x + y;
  }

  /** Restores boxes, heights and balance from a node up to where nothing changes any more. */
  private refit(from: number): void {
    for (let node = from; node !== NONE; node = this.parent[node]!) {
      if (!this.balance(node)) this.tighten(node);
      if (!this.join(node)) break;
    }
  }

  /**
   * If one child of a node is too much taller than the other, exchanges its taller child for the other. What remains of it may still
   * be too tall for that, but by less than before. @returns whether it did so.
   */
  private balance(node: number): boolean {
    const { left, right, level } = this;
    const a = left[node]!;
    const b = right[node]!;
    if (Math.abs(level[a]! - level[b]!) <= MAX_LEAN) {
      return false;
    }
    const high = level[a]! > level[b]! ? a : b;
    const first = left[high]!;
    const second = right[high]!;
    this.exchange(node, high, level[first]! > level[second]! ? second : first);
    if (this.balance(high)) {
      this.join(high);
    }
    return true;
  }

  /** Of the exchanges of a child for a grandchild below the other one, does that which saves most perimeter, if any does. */
  private tighten(node: number): void {
    const { left, right } = this;
    const a = left[node]!;
    const b = right[node]!;
    this.saved = 0;
    this.high = NONE;
    this.weighExchanges(a, b);
    this.weighExchanges(b, a);
    if (this.high !== NONE) {
      this.exchange(node, this.high, this.keep);
    }
  }

  /** Remembers an exchange of `low` for a child of `high`, if it saves more than what was found so far. */
  private weighExchanges(high: number, low: number): void {
    const first = this.left[high]!;
    if (first !== NONE) {
      const second = this.right[high]!;
      this.weigh(high, first, second, low);
      this.weigh(high, second, first, low);
    }
  }

  /** What counts is what the box of `high` loses in perimeter if its child `keep` stays and `give` is exchanged for `low`. The tree must not lean too much. */
  private weigh(high: number, keep: number, give: number, low: number): void {
    const { boxes, level } = this;
    const a = level[keep]!;
    const b = level[low]!;
    if (Math.abs(a - b) > MAX_LEAN || Math.abs(1 + Math.max(a, b) - level[give]!) > MAX_LEAN) {
      return;
    }
    const i = BOX * keep;
    const j = BOX * low;
    const x = Math.max(boxes[i + 2]!, boxes[j + 2]!) - Math.min(boxes[i]!, boxes[j]!);
    const y = Math.max(boxes[i + 3]!, boxes[j + 3]!) - Math.min(boxes[i + 1]!, boxes[j + 1]!);
    const saving = this.perimeter(high) - (x + y);
    if (saving > this.saved) {
      this.saved = saving;
      this.high = high;
      this.keep = keep;
    }
  }

  /** node: (high: (keep, give), low)  →  node: (give, high: (keep, low)) */
  private exchange(node: number, high: number, keep: number): void {
    const { left, right, parent } = this;
    const give = this.otherChild(high, keep);
    const low = this.otherChild(node, high);
    left[high] = keep;
    right[high] = low;
    parent[low] = high;
    left[node] = give;
    right[node] = high;
    parent[give] = node;
    this.join(high);
  }

  /** Box and height of an inner node from its children. @returns whether they changed. */
  private join(node: number): boolean {
    const { boxes, level } = this;
    const a = this.left[node]!;
    const b = this.right[node]!;
    const at = BOX * node;
    const i = BOX * a;
    const j = BOX * b;
    const minX = Math.min(boxes[i]!, boxes[j]!);
    const minY = Math.min(boxes[i + 1]!, boxes[j + 1]!);
    const maxX = Math.max(boxes[i + 2]!, boxes[j + 2]!);
    const maxY = Math.max(boxes[i + 3]!, boxes[j + 3]!);
    const height = 1 + Math.max(level[a]!, level[b]!);
    if (
      height === level[node] &&
      minX === boxes[at] &&
      minY === boxes[at + 1] &&
      maxX === boxes[at + 2] &&
      maxY === boxes[at + 3]
    ) {
      return false;
    }
    boxes[at] = minX;
    boxes[at + 1] = minY;
    boxes[at + 2] = maxX;
    boxes[at + 3] = maxY;
    level[node] = height;
    return true;
  }
}
