import { grown, widened } from '../math/doubles.js';
import { perimeterOf } from './boxes.js';
import { BOX, FREE, MAX_LEAN, NONE, WAITING } from './layout.js';
import { split } from './split.js';

/** States of a node: FRESH, nothing changed; AGED, something changed below one of its children; CHANGED, one of its children did. */
const FRESH = 0;
const AGED = 1;
const CHANGED = 2;

/**
 * How a tree of boxes keeps its shape. A new leaf goes where it adds the least perimeter, by branch and descent (Catto, "Dynamic Bounding
 * Volume Hierarchies", GDC 2019). Every node above a change exchanges a child for a grandchild where that makes a box smaller (Kopta et
 * al., "Fast, effective BVH updates for animated scenes", 2012) or keeps the height logarithmic (Adelson-Velsky & Landis 1962).
 *
 * All that waits until somebody asks: then each node above the changes is brought up to date once, from below; and if more leaves are new
 * than old, the tree is rebuilt.
 */
export class TreeShape<T> {
  /** minX, minY, maxX, maxY of each node. */
  boxes = new Float64Array(16 * BOX);
  /** The children of an inner node; for a leaf, `left` is −1 and `right` is its tag. */
  left = new Int32Array(16);
  right = new Int32Array(16);
  /** The item of each leaf. */
  readonly items: (T | null)[] = [];
  /** The kin of each leaf, a number, or NONE; for an inner node, the kin of all leaves below it, or NONE if they have several. */
  protected kins = new Float64Array(16);

  /** The node above, or NONE. For a waiting leaf: its index in `waiting`. For a free node: the next free one. */
  protected parent = new Int32Array(16);
  /** How many levels are below a node; or FREE or WAITING. */
  protected level = new Uint8Array(16);
  /** The root; up to date only if nothing waits and it is FRESH. */
  protected top = NONE;
  /** What changed at or below each node: FRESH, AGED or CHANGED. */
  private stale = new Uint8Array(16);
  private used = 0;
  private free = NONE;
  /** How many leaves have a place in the tree. */
  private placed = 0;
  /** The leaves that wait for one: the first `waitingCount`. */
  private readonly waiting: number[] = [];
  private waitingCount = 0;
  /** The best exchange found so far: the perimeter it saves, the child whose own child is given away, and which of those is kept. */
  private saved = 0.5;
  private high = NONE;
  private keep = NONE;
  /** The box that is being inserted. */
  private readonly box = new Float64Array(BOX);

  clear(): void {
    this.items.length = 0;
    this.used = 0;
    this.free = NONE;
    this.top = NONE;
    this.placed = 0;
    this.waitingCount = 0;
  }

  protected allocate(): number {
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
    this.stale[node] = FRESH;
    this.items[node] = null;
    this.kins[node] = NONE;
    return node;
  }

  protected release(node: number): void {
    this.items[node] = null;
    this.level[node] = FREE;
    this.parent[node] = this.free;
    this.free = node;
  }

  private grow(): void {
    const size = grown(this.left.length);
    this.boxes = widened(this.boxes, new Float64Array(size * BOX));
    this.left = widened(this.left, new Int32Array(size));
    this.right = widened(this.right, new Int32Array(size));
    this.kins = widened(this.kins, new Float64Array(size));
    this.parent = widened(this.parent, new Int32Array(size));
    this.level = widened(this.level, new Uint8Array(size));
    this.stale = widened(this.stale, new Uint8Array(size));
  }

  /** Has a leaf wait for a place. */
  protected queue(leaf: number): void {
    this.level[leaf] = WAITING;
    this.parent[leaf] = this.waitingCount;
    this.waiting[this.waitingCount] = leaf;
    this.waitingCount += 1;
  }

  protected isQueued(leaf: number): boolean {
    return this.level[leaf] === WAITING;
  }

  /** Takes a leaf from those that wait. */
  protected unqueue(leaf: number): void {
    this.waitingCount -= 1;
    const last = this.waiting[this.waitingCount]!;
    this.waiting[this.parent[leaf]!] = last;
    this.parent[last] = this.parent[leaf]!;
  }

  /** Notes that a child of a node changed. */
  protected age(node: number): void {
    for (let k = node; k !== NONE && this.stale[k] === FRESH; k = this.parent[k]!) {
      this.stale[k] = AGED;
    }
    if (node !== NONE) this.stale[node] = CHANGED;
  }

  /** Brings the tree up to date. */
  protected mend(): void {
    const { waiting, waitingCount: count } = this;
    if (count > this.placed) {
      this.rebuild();
      return;
    }
    if (this.top !== NONE) this.freshen(this.top);
    this.waitingCount = 0;
    for (let i = 0; i < count; i += 1) {
      this.attach(waiting[i]!);
    }
  }

  /** Brings a node and all below it up to date. @returns whether its box or height changed. */
  private freshen(node: number): boolean {
    const stale = this.stale[node];
    if (stale === FRESH) {
      return false;
    }
    this.stale[node] = FRESH;
    const changed = this.freshen(this.left[node]!);
    return this.freshen(this.right[node]!) || changed || stale === CHANGED ? this.shape(node) : false;
  }

  /** Rebuilds the tree from all leaves, top down. */
  private rebuild(): void {
    const { level, waiting } = this;
    let count = 0;
    for (let node = 0; node < this.used; node += 1) {
      if (level[node] === 0 || level[node] === WAITING) {
        level[node] = 0;
        waiting[count] = node;
        count += 1;
      } else if (level[node] !== FREE) {
        this.release(node);
      }
    }
    this.waitingCount = 0;
    this.placed = count;
    this.top = this.build(waiting, 0, count);
    this.parent[this.top] = NONE;
  }

  /** Builds a tree of part of a list of leaves. @returns its root. */
  private build(leaves: number[], from: number, to: number): number {
    if (to - from === 1) {
      return leaves[from]!;
    }
    const middle = split(this.boxes, leaves, from, to);
    const node = this.unite(this.build(leaves, from, middle), this.build(leaves, middle, to));
    this.shape(node);
    return node;
  }

  /** Makes a node above two others. @returns the new node. */
  private unite(a: number, b: number): number {
    const node = this.allocate();
    this.left[node] = a;
    this.right[node] = b;
    this.parent[a] = node;
    this.parent[b] = node;
    return node;
  }

  /** Gives a leaf a place in a tree that has some: an empty one is rebuilt instead. */
  private attach(leaf: number): void {
    this.level[leaf] = 0;
    this.placed += 1;
    const sibling = this.bestSibling(leaf);
    const above = this.parent[sibling]!;
    const joint = this.unite(sibling, leaf);
    this.parent[joint] = above;
    this.replaceChild(above, sibling, joint);
    for (let node = joint; node !== NONE && this.shape(node); ) {
      node = this.parent[node]!;
    }
  }

  protected detach(leaf: number): void {
    this.placed -= 1;
    const joint = this.parent[leaf]!;
    if (joint === NONE) {
      this.top = NONE;
      return;
    }
    const sibling = this.otherChild(joint, leaf);
    const above = this.parent[joint]!;
    this.parent[sibling] = above;
    this.replaceChild(above, joint, sibling);
    this.release(joint);
    this.age(above);
  }

  /** The sibling of a node, −1 for none. */
  protected siblingOf(node: number): number {
    const above = this.parent[node]!;
    return above === NONE ? NONE : this.otherChild(above, node);
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

  private otherChild(node: number, child: number): number {
    return this.left[node] === child ? this.right[node]! : this.left[node]!;
  }

  private replaceChild(parent: number, before: number, after: number): void {
    if (parent === NONE) {
      this.top = after;
    } else if (this.left[parent] === before) {
      this.left[parent] = after;
    } else {
      this.right[parent] = after;
    }
  }

  /** Descends to the node that is the cheapest sibling for the leaf, as long as going down can be cheaper than stopping. */
  private bestSibling(leaf: number): number {
    this.boxOf(leaf, this.box);
    let node = this.top;
    while (this.left[node] !== NONE) {
      const joined = this.joinedPerimeter(node);
      const stop = 2 * joined;
      const inherited = 2 * (joined - perimeterOf(this.boxes, node));
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
    return this.left[node] === NONE ? joined : joined - perimeterOf(this.boxes, node);
  }

  /** Half the perimeter of the union of a node's box and the box that is being inserted. */
  private joinedPerimeter(node: number): number {
    const { boxes, box } = this;
    const at = BOX * node;
    const x = Math.max(boxes[at + 2]!, box[2]!) - Math.min(boxes[at]!, box[0]!);
    const y = Math.max(boxes[at + 3]!, box[3]!) - Math.min(boxes[at + 1]!, box[1]!);
    return x + y;
  }

  /** Restores balance, box and height of a node, and exchanges children below it if that saves perimeter. @returns whether box or height changed. */
  private shape(node: number): boolean {
    if (!this.balance(node)) this.tighten(node);
    return this.join(node);
  }

  /**
   * If one child of a node is too much taller than the other, exchanges its taller child for the other. What remains of it may still be too
   * tall, but by less than before. @returns whether it did so.
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

  /** Does the exchange of a child for a grandchild below the other child that saves most perimeter, if any saves some. */
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

  /** Notes an exchange of `low` for a child of `high`, if it saves more than the best so far. */
  private weighExchanges(high: number, low: number): void {
    const first = this.left[high]!;
    if (first !== NONE) {
      const second = this.right[high]!;
      this.weigh(high, first, second, low);
      this.weigh(high, second, first, low);
    }
  }

  /**
   * Notes the exchange of `give`, a child of `high`, for `low`, while its other child `keep` stays, if that makes the perimeter of `high`
   * smaller by more than the best so far, and the tree does not lean too much.
   */
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
    const saving = perimeterOf(this.boxes, high) - (x + y);
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

  /** Recomputes box, height and kin of an inner node from its children. @returns whether they changed. */
  private join(node: number): boolean {
    const { boxes, level, kins } = this;
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
    const kin = kins[a] === kins[b] ? kins[a]! : NONE;
    if (
      height === level[node] &&
      kin === kins[node] &&
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
    kins[node] = kin;
    return true;
  }
}
