const NONE = -1;

/** Numbers per node in `boxes`. */
const BOX = 4;

/**
 * A dynamic bounding box tree over packed arrays. A new leaf goes where it adds the least perimeter, by branch and descent; on the way
 * up every node whose subtrees differ by more than one in height is rotated, so that the height stays logarithmic (Catto, "Dynamic
 * Bounding Volume Hierarchies", GDC 2019; Adelson-Velsky & Landis 1962). Nodes are numbered; freed numbers are reused.
 */
export class PackedTree<T> {
  /** minX, minY, maxX, maxY of each node. */
  boxes = new Float64Array(16 * BOX);
  /** The two subtrees of an inner node; `left` is −1 in a leaf. */
  left = new Int32Array(16);
  right = new Int32Array(16);
  root = NONE;
  /** What each leaf holds. */
  readonly items: (T | null)[] = [];

  private parent = new Int32Array(16);
  private level = new Int32Array(16);
  private used = 0;
  private free = NONE;
  private stack = new Int32Array(64);
  /** The box that is being inserted. */
  private readonly box = new Float64Array(BOX);

  /** Number of levels above the leaves; 0 for one leaf and for none. */
  get height(): number {
    return this.root === NONE ? 0 : this.level[this.root]!;
  }

  /** Adds a leaf with the box `[minX, minY, maxX, maxY]`, grown by `margin` on all sides. @returns its number. */
  insert(item: T, bounds: ArrayLike<number>, margin: number): number {
    const leaf = this.allocate();
    this.items[leaf] = item;
    this.setBox(leaf, bounds, margin);
    this.attach(leaf);
    return leaf;
  }

  /** Gives a leaf another box. */
  move(leaf: number, bounds: ArrayLike<number>, margin: number): void {
    this.detach(leaf);
    this.setBox(leaf, bounds, margin);
    this.attach(leaf);
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

  /** Writes what the leaves hold whose boxes overlap `bounds` to `out` from `count` on. @returns the new count. */
  query(bounds: ArrayLike<number>, out: T[], count: number): number {
    if (this.root === NONE) {
      return count;
    }
    const minX = bounds[0]!;
    const minY = bounds[1]!;
    const maxX = bounds[2]!;
    const maxY = bounds[3]!;
    const { boxes, left, right, stack } = this.ready();
    let found = count;
    let top = 1;
    stack[0] = this.root;
    while (top > 0) {
      top -= 1;
      const node = stack[top]!;
      const at = BOX * node;
      if (boxes[at]! > maxX || boxes[at + 2]! < minX || boxes[at + 1]! > maxY || boxes[at + 3]! < minY) {
        continue;
      }
      if (left[node] === NONE) {
        out[found] = this.items[node]!;
        found += 1;
      } else {
        stack[top] = left[node]!;
        stack[top + 1] = right[node]!;
        top += 2;
      }
    }
    return found;
  }

  /**
   * Visits what the leaves hold whose boxes the ray o + d · f, 0 ≤ f ≤ limit, meets; of two subtrees the one that lies nearer along the ray comes
   * first. `visit` returns the new limit, which is returned in the end.
   */
  cast(origin: ArrayLike<number>, direction: ArrayLike<number>, limit: number, visit: (item: T) => number): number {
    const ox = origin[0]!;
    const oy = origin[1]!;
    const dx = direction[0]!;
    const dy = direction[1]!;
    const ix = inverse(dx);
    const iy = inverse(dy);
    const { boxes, left, right } = this;
    const stack = this.root === NONE ? [] : [this.root];
    let end = limit;
    for (let node = stack.pop(); node !== undefined; node = stack.pop()) {
      const at = BOX * node;
      const x1 = (boxes[at]! - ox) * ix;
      const x2 = (boxes[at + 2]! - ox) * ix;
      const y1 = (boxes[at + 1]! - oy) * iy;
      const y2 = (boxes[at + 3]! - oy) * iy;
      const enter = Math.max(0, Math.min(x1, x2), Math.min(y1, y2));
      if (enter > Math.min(end, Math.max(x1, x2), Math.max(y1, y2))) {
        continue;
      }
      if (left[node] === NONE) {
        end = visit(this.items[node]!);
        continue;
      }
      const a = left[node]!;
      const b = right[node]!;
      const i = BOX * a;
      const j = BOX * b;
      const x = boxes[i]! + boxes[i + 2]! - boxes[j]! - boxes[j + 2]!;
      const y = boxes[i + 1]! + boxes[i + 3]! - boxes[j + 1]! - boxes[j + 3]!;
      if (x * dx + y * dy > 0) {
        stack.push(a, b);
      } else {
        stack.push(b, a);
      }
    }
    return end;
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

  /** A stack that is deep enough: a walk holds at most one node a level beside the one it goes down. */
  private ready(): this {
    if (this.stack.length < this.height + 2) {
      this.stack = new Int32Array(2 * (this.height + 2));
    }
    return this;
  }

  private setBox(leaf: number, bounds: ArrayLike<number>, margin: number): void {
    const at = BOX * leaf;
    this.boxes[at] = bounds[0]! - margin;
    this.boxes[at + 1] = bounds[1]! - margin;
    this.boxes[at + 2] = bounds[2]! + margin;
    this.boxes[at + 3] = bounds[3]! + margin;
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
    const size = this.left.length * 2;
    const wider = (from: Int32Array): Int32Array<ArrayBuffer> => {
      const to = new Int32Array(size);
      to.set(from);
      return to;
    };
    const boxes = new Float64Array(size * BOX);
    boxes.set(this.boxes);
    this.boxes = boxes;
    this.left = wider(this.left);
    this.right = wider(this.right);
    this.parent = wider(this.parent);
    this.level = wider(this.level);
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
    const sibling = this.left[joint] === leaf ? this.right[joint]! : this.left[joint]!;
    const above = this.parent[joint]!;
    this.parent[sibling] = above;
    this.replaceChild(above, joint, sibling);
    this.release(joint);
    this.refit(above);
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
    const { boxes, box } = this;
    box.set(boxes.subarray(BOX * leaf, BOX * leaf + BOX));
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
    const { boxes } = this;
    const at = BOX * node;
    return boxes[at + 2]! - boxes[at]! + (boxes[at + 3]! - boxes[at + 1]!);
  }

  /** Perimeter of the union of a node and the box that is being inserted. */
  private joinedPerimeter(node: number): number {
    const { boxes, box } = this;
    const at = BOX * node;
    const x = Math.max(boxes[at + 2]!, box[2]!) - Math.min(boxes[at]!, box[0]!);
    const y = Math.max(boxes[at + 3]!, box[3]!) - Math.min(boxes[at + 1]!, box[1]!);
    return x + y;
  }

  /** Restores heights, balance and boxes from a node up to the root. */
  private refit(from: number): void {
    for (let node = from; node !== NONE; node = this.parent[node]!) {
      const lean = this.level[this.left[node]!]! - this.level[this.right[node]!]!;
      if (lean > 1) {
        this.rotate(node, this.left[node]!);
      } else if (lean < -1) {
        this.rotate(node, this.right[node]!);
      }
      this.join(node);
    }
  }

  /** Lifts the lower of the grandchildren's levels: `high`, the taller child, hands its shorter child to `node` and takes its place there. */
  private rotate(node: number, high: number): void {
    const { left, right, level, parent } = this;
    const low = left[node] === high ? right[node]! : left[node]!;
    const first = left[high]!;
    const second = right[high]!;
    const keep = level[first]! > level[second]! ? first : second;
    const give = keep === first ? second : first;
    // node: (high: (keep, give), low)  →  node: (keep, high: (give, low))
    left[high] = give;
    right[high] = low;
    parent[low] = high;
    left[node] = keep;
    right[node] = high;
    parent[keep] = node;
    this.join(high);
  }

  /** Box and height of an inner node from its children. */
  private join(node: number): void {
    const { boxes, level } = this;
    const a = this.left[node]!;
    const b = this.right[node]!;
    const at = BOX * node;
    const i = BOX * a;
    const j = BOX * b;
    boxes[at] = Math.min(boxes[i]!, boxes[j]!);
    boxes[at + 1] = Math.min(boxes[i + 1]!, boxes[j + 1]!);
    boxes[at + 2] = Math.max(boxes[i + 2]!, boxes[j + 2]!);
    boxes[at + 3] = Math.max(boxes[i + 3]!, boxes[j + 3]!);
    level[node] = 1 + Math.max(level[a]!, level[b]!);
  }
}

/** 1 / d, but never infinite: a box side that a parallel ray starts on is then reached at 0, not at NaN. */
function inverse(d: number): number {
  const most = 1e300;
  return d === 0 ? most : Math.max(-most, Math.min(most, 1 / d));
}
