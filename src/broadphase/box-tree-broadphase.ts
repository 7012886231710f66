import type { RectLike, Vec2Like } from '../math/vectors.js';
import { boolean, callable } from '../validate.js';
import { type Broadphase, type BroadphaseHandle, badBounds, isRect } from './broadphase.js';
import { BOX, grown, NONE, PackedTree } from './packed-tree.js';

/** m. How far a moving thing may go before its leaf is looked at again; more means fewer updates and more pairs to test. */
const MARGIN = 0.1;

/** Steps that the leaf of a fast thing is ahead of it, and how far at most, m. */
const AHEAD = 4;
const MAX_AHEAD = 1;

/** Of a pair: where the bounds of its handles are, and its note, see `perform`; 0: none. */
const END_A = 0;
const END_B = 1;
const NOTE = 2;
const ENDS = 3;

/** A handle of {@link BoxTreeBroadphase}. */
class TreeHandle<T> implements BroadphaseHandle<T> {
  /** Leaf in the tree of its kind; −1 once removed. */
  leaf = NONE;
  /** If its pairs may have changed, its place in the list of `perform`, else −1. */
  movedSlot = NONE;
  /** The last search in which it was met. */
  mark = 0;
  /** Its own when it first has one: most that are static never do. What lies beyond the count is old: shortening the list would cost its storage. */
  pairs: TreePair<T>[] | null = null;
  pairCount = 0;

  constructor(
    public data: T,
    public isStatic: boolean,
    readonly owner: object,
    /** Where its bounds are in `boxes`. */
    readonly at: number,
  ) {}
}

/** Two handles, not both static, whose leaves overlap; none while it waits for its next use. Knows its place in three lists, so that it is taken out at once. */
class TreePair<T> {
  slot = 0;
  slotA = 0;
  slotB = 0;

  constructor(
    public a: TreeHandle<T> | null,
    public b: TreeHandle<T> | null,
  ) {}
}

/**
 * Two box trees, for static and for moving handles. Leaves are larger than their handles, and the pairs of overlapping leaves are kept
 * from call to call: only handles that left their leaf are looked up again, so what rests costs one comparison a pair, and what is
 * static costs nothing.
 */
export class BoxTreeBroadphase<T = unknown> implements Broadphase<T> {
  /** Of the class, as in Turbulenz. */
  static get version(): number {
    return 1;
  }

  private readonly moving = new PackedTree<TreeHandle<T>>(MARGIN);
  private readonly still = new PackedTree<TreeHandle<T>>(0);
  /** The first `movedCount` are handles. As `met` and `samples` not shortened, which would cost the storage, but filled up with `null`. */
  private readonly movedHandles: (TreeHandle<T> | null)[] = [];
  private movedCount = 0;
  /** Bounds of all handles, and where those of handles that were removed are. Side by side, as `perform` goes through all of them. */
  private boxes = new Float64Array(16 * BOX);
  private boxCount = 0;
  private readonly freeBoxes: number[] = [];
  /** What lies beyond the count is for later. */
  private readonly pairs: TreePair<T>[] = [];
  private pairCount = 0;
  /** A record for each pair, side by side, as `perform` goes through all of them. */
  private ends = new Int32Array(16 * ENDS);
  private search = 0;
  private readonly met: (TreeHandle<T> | null)[] = [];
  private readonly box = new Float64Array(BOX);
  /** Bounds that a handle will not leave for a while. */
  private readonly reach = new Float64Array(BOX);
  /** Results of `sample`, one list for each call that is inside another. */
  private readonly samples: (TreeHandle<T> | null)[][] = [];
  private depth = 0;

  insert(data: T, bounds: RectLike, isStatic: boolean): BroadphaseHandle<T> {
    if (!isRect(bounds)) {
      throw badBounds('BoxTreeBroadphase.insert', 'bounds', bounds);
    }
    boolean('BoxTreeBroadphase.insert', 'isStatic', isStatic);
    const handle = new TreeHandle<T>(data, isStatic, this, this.takeBox());
    this.setBox(handle.at, bounds);
    handle.leaf = this.treeOf(handle).insert(handle, bounds);
    this.noteMoved(handle);
    return handle;
  }

  update(handle: BroadphaseHandle<T>, bounds: RectLike, isStatic?: boolean): void {
    if (!isRect(bounds)) {
      throw badBounds('BoxTreeBroadphase.update', 'bounds', bounds);
    }
    const own = this.owned('BoxTreeBroadphase.update', handle);
    const becomesStatic =
      isStatic === undefined ? own.isStatic : boolean('BoxTreeBroadphase.update', 'isStatic', isStatic);
    const { boxes } = this;
    const { at } = own;
    const dx = (bounds[0]! - boxes[at]! + bounds[2]! - boxes[at + 2]!) / 2;
    const dy = (bounds[1]! - boxes[at + 1]! + bounds[3]! - boxes[at + 3]!) / 2;
    this.setBox(at, bounds);
    if (becomesStatic !== own.isStatic) {
      this.treeOf(own).remove(own.leaf);
      own.isStatic = becomesStatic;
      own.leaf = this.treeOf(own).insert(own, bounds);
      this.noteMoved(own);
    } else if (!this.treeOf(own).contains(own.leaf, bounds)) {
      // Not left for a while by what goes on as in the last step.
      const x = Math.max(-MAX_AHEAD, Math.min(MAX_AHEAD, AHEAD * dx));
      const y = Math.max(-MAX_AHEAD, Math.min(MAX_AHEAD, AHEAD * dy));
      const { reach } = this;
      reach[0] = bounds[0]! + Math.min(x, 0);
      reach[1] = bounds[1]! + Math.min(y, 0);
      reach[2] = bounds[2]! + Math.max(x, 0);
      reach[3] = bounds[3]! + Math.max(y, 0);
      this.treeOf(own).move(own.leaf, becomesStatic ? bounds : reach);
      this.noteMoved(own);
    }
  }

  remove(handle: BroadphaseHandle<T>): void {
    const own = this.owned('BoxTreeBroadphase.remove', handle);
    while (own.pairCount > 0) {
      this.dropPair(own.pairs![own.pairCount - 1]!);
    }
    this.treeOf(own).remove(own.leaf);
    own.leaf = NONE;
    this.freeBoxes.push(own.at);
    this.forgetMoved(own);
  }

  clear(callback?: (handle: BroadphaseHandle<T>) => void, thisObject?: unknown): void {
    if (callback !== undefined) {
      callable('BoxTreeBroadphase.clear', 'callback', callback);
    }
    try {
      if (callback !== undefined) {
        for (const handle of this.handles()) {
          callback.call(thisObject, handle);
        }
      }
    } finally {
      this.empty();
    }
  }

  perform(
    callback: (a: BroadphaseHandle<T>, b: BroadphaseHandle<T>) => unknown,
    thisObject?: unknown,
    isKnown?: (note: number) => boolean,
  ): void {
    callable('BoxTreeBroadphase.perform', 'callback', callback);
    if (isKnown !== undefined) {
      callable('BoxTreeBroadphase.perform', 'isKnown', isKnown);
    }
    this.renewMoved();
    this.reportPairs(callback, thisObject, isKnown);
  }

  private renewMoved(): void {
    const moved = this.movedHandles;
    for (let i = 0; i < this.movedCount; i += 1) {
      const handle = moved[i]!;
      moved[i] = null;
      handle.movedSlot = NONE;
      this.renewPairs(handle);
    }
    this.movedCount = 0;
  }

  private reportPairs(
    callback: (a: BroadphaseHandle<T>, b: BroadphaseHandle<T>) => unknown,
    thisObject: unknown,
    isKnown: ((note: number) => boolean) | undefined,
  ): void {
    const { pairs, ends, boxes } = this;
    for (let i = 0; i < this.pairCount; i += 1) {
      const at = i * ENDS;
      const a = ends[at + END_A]!;
      const b = ends[at + END_B]!;
      const note = ends[at + NOTE]!;
      if (
        boxes[a]! <= boxes[b + 2]! &&
        boxes[a + 2]! >= boxes[b]! &&
        boxes[a + 1]! <= boxes[b + 3]! &&
        boxes[a + 3]! >= boxes[b + 1]!
      ) {
        if (isKnown === undefined) {
          callback.call(thisObject, pairs[i]!.a!, pairs[i]!.b!);
        } else if (note === 0 || !isKnown.call(thisObject, note)) {
          ends[at + NOTE] = callback.call(thisObject, pairs[i]!.a!, pairs[i]!.b!) as number;
        }
      } else if (note !== 0) {
        ends[at + NOTE] = 0;
      }
    }
  }

  sample(
    bounds: RectLike,
    callback: (handle: BroadphaseHandle<T>, bounds: RectLike) => void,
    thisObject?: unknown,
  ): void {
    if (!isRect(bounds)) {
      throw badBounds('BoxTreeBroadphase.sample', 'bounds', bounds);
    }
    callable('BoxTreeBroadphase.sample', 'callback', callback);
    this.report(bounds, true, callback, thisObject);
  }

  sampleStatic(bounds: RectLike, callback: (handle: BroadphaseHandle<T>, bounds: RectLike) => void): void {
    this.report(bounds, false, callback, undefined);
  }

  private report(
    bounds: RectLike,
    alsoMoving: boolean,
    callback: (handle: BroadphaseHandle<T>, bounds: RectLike) => void,
    thisObject: unknown,
  ): void {
    // Read before any callback, which may write to it.
    const minX = bounds[0]!;
    const minY = bounds[1]!;
    const maxX = bounds[2]!;
    const maxY = bounds[3]!;
    this.samples[this.depth] ??= [];
    const found = this.samples[this.depth]!;
    const count = this.still.query(bounds, found, alsoMoving ? this.moving.query(bounds, found, 0) : 0);
    const { boxes } = this;
    this.depth += 1;
    try {
      for (let i = 0; i < count; i += 1) {
        const { at } = found[i]!;
        if (boxes[at]! <= maxX && boxes[at + 2]! >= minX && boxes[at + 1]! <= maxY && boxes[at + 3]! >= minY) {
          callback.call(thisObject, found[i]!, bounds);
        }
      }
    } finally {
      this.depth -= 1;
      for (let i = 0; i < count; i += 1) {
        found[i] = null;
      }
    }
  }

  castRay(origin: Vec2Like, direction: Vec2Like, limit: number, visit: (handle: BroadphaseHandle<T>) => number): void {
    // Read before any visit, which may write to them.
    const from = [origin[0]!, origin[1]!];
    const along = [direction[0]!, direction[1]!];
    this.still.cast(from, along, this.moving.cast(from, along, limit, visit), visit);
  }

  private handles(): TreeHandle<T>[] {
    return [...this.moving.items, ...this.still.items].filter((handle) => handle !== null);
  }

  private empty(): void {
    for (const handle of this.handles()) {
      handle.leaf = NONE;
      handle.pairs = null;
      handle.pairCount = 0;
    }
    this.moving.clear();
    this.still.clear();
    this.movedHandles.length = 0;
    this.movedCount = 0;
    this.boxCount = 0;
    this.freeBoxes.length = 0;
    this.pairs.length = 0;
    this.pairCount = 0;
  }

  private takeBox(): number {
    const free = this.freeBoxes.pop();
    if (free !== undefined) {
      return free;
    }
    const at = this.boxCount * BOX;
    this.boxCount += 1;
    if (at === this.boxes.length) {
      const { boxes } = this;
      this.boxes = new Float64Array(BOX * grown(this.boxCount));
      this.boxes.set(boxes);
    }
    return at;
  }

  private setBox(at: number, bounds: RectLike): void {
    const { boxes } = this;
    boxes[at] = bounds[0]!;
    boxes[at + 1] = bounds[1]!;
    boxes[at + 2] = bounds[2]!;
    boxes[at + 3] = bounds[3]!;
  }

  /** Drops the pairs of a handle whose leaves have parted, or that are both static now, and finds the new ones. */
  private renewPairs(handle: TreeHandle<T>): void {
    this.search += 1;
    const tree = this.treeOf(handle);
    const own = handle.pairs;
    for (let i = handle.pairCount - 1; i >= 0; i -= 1) {
      const pair = own![i]!;
      const other = pair.a === handle ? pair.b! : pair.a!;
      if ((handle.isStatic && other.isStatic) || !tree.overlaps(handle.leaf, this.treeOf(other), other.leaf)) {
        this.dropPair(pair);
      } else {
        other.mark = this.search;
      }
    }
    handle.mark = this.search;
    const box = tree.boxOf(handle.leaf, this.box);
    let count = this.moving.query(box, this.met, 0);
    if (!handle.isStatic) {
      count = this.still.query(box, this.met, count);
    }
    for (let i = 0; i < count; i += 1) {
      const other = this.met[i]!;
      this.met[i] = null;
      if (other.mark !== this.search) {
        this.addPair(handle, other);
      }
    }
  }

  private addPair(a: TreeHandle<T>, b: TreeHandle<T>): void {
    const slot = this.pairCount;
    if (slot === this.pairs.length) {
      this.pairs.push(new TreePair(a, b));
    }
    this.pairCount += 1;
    const pair = this.pairs[slot]!;
    pair.a = a;
    pair.b = b;
    pair.slot = slot;
    const at = slot * ENDS;
    if (at === this.ends.length) {
      const { ends } = this;
      this.ends = new Int32Array(2 * at);
      this.ends.set(ends);
    }
    this.ends[at + END_A] = a.at;
    this.ends[at + END_B] = b.at;
    this.ends[at + NOTE] = 0;
    pair.slotA = addTo(a, pair);
    pair.slotB = addTo(b, pair);
  }

  private dropPair(pair: TreePair<T>): void {
    this.pairCount -= 1;
    const last = this.pairs[this.pairCount]!;
    if (last !== pair) {
      const { slot } = pair;
      this.pairs[slot] = last;
      this.pairs[this.pairCount] = pair;
      this.ends.copyWithin(slot * ENDS, this.pairCount * ENDS, (this.pairCount + 1) * ENDS);
      last.slot = slot;
    }
    dropFrom(pair.a!, pair.slotA);
    dropFrom(pair.b!, pair.slotB);
    pair.a = null;
    pair.b = null;
  }

  private noteMoved(handle: TreeHandle<T>): void {
    if (handle.movedSlot === NONE) {
      handle.movedSlot = this.movedCount;
      this.movedHandles[this.movedCount] = handle;
      this.movedCount += 1;
    }
  }

  /** Takes a handle out of the list of `perform`; the last one takes its place. */
  private forgetMoved(handle: TreeHandle<T>): void {
    if (handle.movedSlot === NONE) {
      return;
    }
    this.movedCount -= 1;
    const last = this.movedHandles[this.movedCount]!;
    this.movedHandles[handle.movedSlot] = last;
    last.movedSlot = handle.movedSlot;
    this.movedHandles[this.movedCount] = null;
    handle.movedSlot = NONE;
  }

  private treeOf(handle: TreeHandle<T>): PackedTree<TreeHandle<T>> {
    return handle.isStatic ? this.still : this.moving;
  }

  private owned(where: string, handle: BroadphaseHandle<T>): TreeHandle<T> {
    const own = handle as TreeHandle<T>;
    if (!(own instanceof TreeHandle) || own.owner !== this || own.leaf < 0) {
      throw new TypeError(`${where}: handle must be one of this broadphase, and not removed`);
    }
    return own;
  }
}

/** Adds a pair to a handle's list. @returns its place. */
function addTo<T>(handle: TreeHandle<T>, pair: TreePair<T>): number {
  handle.pairs ??= [];
  const slot = handle.pairCount;
  handle.pairs[slot] = pair;
  handle.pairCount += 1;
  return slot;
}

/** Takes the pair at `slot` out of a handle's list; the last one takes its place. */
function dropFrom<T>(handle: TreeHandle<T>, slot: number): void {
  const pairs = handle.pairs!;
  handle.pairCount -= 1;
  const last = pairs[handle.pairCount]!;
  if (slot === handle.pairCount) {
    return;
  }
  pairs[slot] = last;
  if (last.a === handle) {
    last.slotA = slot;
  } else {
    last.slotB = slot;
  }
}
