import { grown, widened } from '../math/doubles.js';
import type { RectLike, Vec2Like } from '../math/vectors.js';
import { boolean, callable, callbackOf } from '../validate.js';
import {
  type Broadphase,
  type BroadphaseFilter,
  type BroadphaseHandle,
  checkInsert,
  checkRect,
  letsMeet,
  UNFILTERED,
} from './broadphase.js';
import { BOX, END_A, END_B, FIRST, LEAF, MARK, MOVED, NONE, NOTE, PAIR, STATE, STATIC, STRANGER } from './layout.js';
import { PackedTree } from './packed-tree.js';

/**
 * By how much the leaf of a moving handle is larger than its bounds, m: how far it may go before the leaf is updated. More means fewer
 * updates and more pairs to test.
 */
const MARGIN = 0.1;

/** For how many steps ahead the leaf of a moving handle is extended along its motion. */
const AHEAD = 4;

/** m. What moves farther than this in a step is fast, and its leaf is not extended ahead. */
const MAX_AHEAD = 1;

/** m. How large the leaf of a fast handle may get to keep its earlier places within it. */
const MAX_STAY = 3;

/** In place of a group: the group of no handle. */
const NO_GROUP = /* @__PURE__ */ Symbol();

/** A handle of {@link BoxTreeBroadphase}. */
class TreeHandle<T> implements BroadphaseHandle<T> {
  constructor(
    public data: T,
    public isStatic: boolean,
    /** Index of its box and state in the broadphase. */
    readonly number: number,
    readonly group: unknown,
    readonly filter: BroadphaseFilter,
    /** Handles of the same kin are of the same group; see `latestGroup`. */
    readonly kin: number,
  ) {}
}

/**
 * Two box trees, one for static and one for moving handles. Leaves are larger than the bounds of their handles, and the pairs of
 * overlapping leaves are kept from call to call: only handles that left their leaf are looked up again. So what rests costs one comparison
 * a pair, and what is static costs nothing.
 */
export class BoxTreeBroadphase<T = unknown> implements Broadphase<T> {
  /** Of the class, as in Turbulenz. */
  static get version(): number {
    return 1;
  }

  private readonly moving = new PackedTree<TreeHandle<T>>(MARGIN);
  private readonly still = new PackedTree<TreeHandle<T>>(0);
  /** All filters that handles have had, together: a handle that these keep apart from all others meets none, and is not looked up. */
  private readonly filters = { group: 0, mask: 0 };
  /** Bounds and state of all handles, by their numbers. Side by side, as `perform` walks through all of them. */
  private boxes = new Float64Array(16 * BOX);
  private states = new Int32Array(16 * STATE).fill(NONE);
  private handleCount = 0;
  /**
   * The last group that was inserted, as long as nothing has been removed since, and the number of its kin: handles inserted one after the
   * other in one group are of one kin. A group may have several kins, which only makes queries slower.
   */
  private latestGroup: unknown = NO_GROUP;
  private kin = 0;
  private readonly freeNumbers: number[] = [];
  /**
   * The numbers of handles that moved: the first `movedCount`. The list is not shortened, which would give its memory back; nor are `met`
   * and `samples`.
   */
  private readonly moved: number[] = [];
  private movedCount = 0;
  /** The pairs of handles, not both static, whose leaves overlap. */
  private pairs = new Int32Array(16 * PAIR);
  private pairCount = 0;
  /** Linked lists of the pairs of each handle: pair p has link 2 p in the list of its handle A, and link 2 p + 1 in that of its handle B. */
  private next = new Int32Array(32);
  private previous = new Int32Array(32);
  private search = 0;
  private readonly met: number[] = [];
  private readonly box = new Float64Array(BOX);
  /** The leaf that `foresee` makes: bounds that a handle will not leave for a while. */
  private readonly reach = new Float64Array(BOX);
  /** Leaves that `sample` found: a list for each call within another. */
  private readonly samples: number[][] = [];
  private depth = 0;

  insert(
    data: T,
    bounds: RectLike,
    isStatic: boolean,
    group: unknown = {},
    filter: BroadphaseFilter = UNFILTERED,
  ): BroadphaseHandle<T> {
    checkInsert('BoxTreeBroadphase.insert', bounds, isStatic, filter);
    if (group !== this.latestGroup) {
      this.latestGroup = group;
      this.kin += 1;
    }
    const handle = new TreeHandle<T>(data, isStatic, this.takeNumber(), group, filter, this.kin);
    this.setBox(handle.number, bounds);
    this.noteFilter(filter);
    this.enter(handle, bounds);
    return handle;
  }

  private noteFilter({ group, mask }: BroadphaseFilter): void {
    this.filters.group |= group;
    this.filters.mask |= mask;
  }

  /** Puts a handle into the static or the moving tree. */
  private enter(handle: TreeHandle<T>, bounds: RectLike): void {
    const { number, isStatic } = handle;
    const at = number * STATE;
    this.states[at + LEAF] = this.treeOf(handle).insert(handle, bounds, number, handle.kin);
    this.states[at + STATIC] = isStatic ? 1 : 0;
    this.noteMoved(number);
  }

  update(handle: BroadphaseHandle<T>, bounds: RectLike, isStatic?: boolean): void {
    checkRect('BoxTreeBroadphase.update', bounds);
    const own = this.owned('BoxTreeBroadphase.update', handle);
    const becomesStatic =
      isStatic === undefined ? own.isStatic : boolean('BoxTreeBroadphase.update', 'isStatic', isStatic);
    const { number } = own;
    const leaf = this.states[number * STATE + LEAF]!;
    const tree = this.treeOf(own);
    if (becomesStatic !== own.isStatic) {
      tree.remove(leaf);
      own.isStatic = becomesStatic;
      this.enter(own, bounds);
    } else if (!tree.contains(leaf, bounds)) {
      this.foresee(number * BOX, bounds, tree.boxOf(leaf, this.reach));
      tree.move(leaf, becomesStatic ? bounds : this.reach);
      this.noteMoved(number);
    }
    this.setBox(number, bounds);
  }

  refilter(handle: BroadphaseHandle<T>): void {
    const { number, filter } = this.owned('BoxTreeBroadphase.refilter', handle);
    this.noteFilter(filter);
    this.noteMoved(number);
  }

  /**
   * Writes bounds to `reach` that a handle will not leave for a while if it goes on as in the last step. A fast one often turns back soon:
   * its bounds keep the earlier places within them, unless that makes them too large, as after a teleport.
   */
  private foresee(box: number, bounds: RectLike, reach: Float64Array): void {
    const { boxes } = this;
    const isFast = Math.abs(bounds[0]! - boxes[box]!) + Math.abs(bounds[1]! - boxes[box + 1]!) > MAX_AHEAD;
    for (let low = 0; low < 2; low += 1) {
      const high = low + 2;
      const way = bounds[low]! - boxes[box + low]!;
      const back = Math.abs(way) <= MAX_STAY ? -way : 0;
      const ahead = isFast ? back : Math.max(-MAX_AHEAD, Math.min(MAX_AHEAD, AHEAD * way));
      const min = bounds[low]! + Math.min(ahead, 0);
      const max = bounds[high]! + Math.max(ahead, 0);
      const least = Math.min(min, reach[low]!);
      const most = Math.max(max, reach[high]!);
      const stays = isFast && most - least <= MAX_STAY;
      reach[low] = stays ? least : min;
      reach[high] = stays ? most : max;
    }
  }

  remove(handle: BroadphaseHandle<T>): void {
    const own = this.owned('BoxTreeBroadphase.remove', handle);
    const { states } = this;
    const { number } = own;
    const first = number * STATE + FIRST;
    while (states[first] !== NONE) {
      this.dropPair(states[first]! >> 1);
    }
    this.treeOf(own).remove(states[number * STATE + LEAF]!);
    states[number * STATE + LEAF] = NONE;
    this.latestGroup = NO_GROUP;
    this.freeNumbers.push(number);
  }

  clear(callback?: (handle: BroadphaseHandle<T>) => void, thisObject?: unknown): void {
    const call = callbackOf('BoxTreeBroadphase.clear', callback);
    try {
      for (const handle of [...this.moving.items, ...this.still.items]) {
        if (handle !== null) call?.call(thisObject, handle);
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
    const { moved, states, movedCount } = this;
    this.movedCount = 0;
    for (let i = 0; i < movedCount; i += 1) {
      const handle = moved[i]!;
      states[handle * STATE + MOVED] = NONE;
      if (states[handle * STATE + LEAF] !== NONE) {
        this.renewPairs(handle);
      }
    }
  }

  private reportPairs(
    callback: (a: BroadphaseHandle<T>, b: BroadphaseHandle<T>) => unknown,
    thisObject: unknown,
    isKnown: ((note: number) => boolean) | undefined,
  ): void {
    const { pairs, boxes } = this;
    for (let i = 0; i < this.pairCount; i += 1) {
      const at = i * PAIR;
      const a = pairs[at + END_A]! * BOX;
      const b = pairs[at + END_B]! * BOX;
      const note = pairs[at + NOTE]!;
      if (
        boxes[a]! <= boxes[b + 2]! &&
        boxes[a + 2]! >= boxes[b]! &&
        boxes[a + 1]! <= boxes[b + 3]! &&
        boxes[a + 3]! >= boxes[b + 1]!
      ) {
        if (note === 0 || isKnown === undefined || !isKnown.call(thisObject, note)) {
          const given = callback.call(thisObject, this.handleOf(pairs[at + END_A]!), this.handleOf(pairs[at + END_B]!));
          if (isKnown !== undefined) pairs[at + NOTE] = given as number;
        }
      } else if (note !== 0) {
        pairs[at + NOTE] = 0;
      }
    }
  }

  sample(
    bounds: RectLike,
    callback: (handle: BroadphaseHandle<T>, bounds: RectLike) => void,
    thisObject?: unknown,
    like?: BroadphaseHandle<T>,
  ): void {
    checkRect('BoxTreeBroadphase.sample', bounds);
    callable('BoxTreeBroadphase.sample', 'callback', callback);
    const kin = like === undefined ? STRANGER : this.owned('BoxTreeBroadphase.sample', like, 'like').kin;
    this.report(bounds, true, kin, callback, thisObject);
  }

  sampleStatic(bounds: RectLike, callback: (handle: BroadphaseHandle<T>, bounds: RectLike) => void): void {
    this.report(bounds, false, STRANGER, callback, undefined);
  }

  private report(
    bounds: RectLike,
    alsoMoving: boolean,
    kin: number,
    callback: (handle: BroadphaseHandle<T>, bounds: RectLike) => void,
    thisObject: unknown,
  ): void {
    // Read before any callback, which may write to the array.
    const minX = bounds[0]!;
    const minY = bounds[1]!;
    const maxX = bounds[2]!;
    const maxY = bounds[3]!;
    this.samples[this.depth] ??= [];
    const found = this.samples[this.depth]!;
    const { moving, still, boxes } = this;
    const movingCount = alsoMoving ? moving.query(bounds, found, 0, kin) : 0;
    const count = still.query(bounds, found, movingCount, kin);
    this.depth += 1;
    try {
      for (let i = 0; i < count; i += 1) {
        const tree = i < movingCount ? moving : still;
        const handle = tree.items[found[i]!];
        const at = tree.right[found[i]!]! * BOX;
        const isMet = boxes[at]! <= maxX && boxes[at + 2]! >= minX && boxes[at + 1]! <= maxY && boxes[at + 3]! >= minY;
        // Callbacks may take others out.
        if (isMet && handle) {
          callback.call(thisObject, handle, bounds);
        }
      }
    } finally {
      this.depth -= 1;
    }
  }

  cast(start: RectLike, direction: Vec2Like, limit: number, visit: (handle: BroadphaseHandle<T>) => number): void {
    // Read before any visit, which may write to the arrays.
    const from = [start[0]!, start[1]!, start[2]!, start[3]!];
    const along = [direction[0]!, direction[1]!];
    this.still.cast(from, along, this.moving.cast(from, along, limit, visit), visit);
  }

  private empty(): void {
    this.moving.clear();
    this.still.clear();
    this.filters.group = 0;
    this.filters.mask = 0;
    this.states.fill(NONE);
    this.movedCount = 0;
    this.handleCount = 0;
    this.latestGroup = NO_GROUP;
    this.freeNumbers.length = 0;
    this.pairCount = 0;
  }

  private takeNumber(): number {
    const free = this.freeNumbers.pop();
    if (free !== undefined) {
      return free;
    }
    const number = this.handleCount;
    this.handleCount += 1;
    if (number * BOX === this.boxes.length) {
      this.boxes = widened(this.boxes, new Float64Array(BOX * grown(this.handleCount)));
      this.states = widened(this.states, new Int32Array(STATE * grown(this.handleCount)).fill(NONE));
    }
    return number;
  }

  private setBox(number: number, bounds: RectLike): void {
    const { boxes } = this;
    const at = number * BOX;
    boxes[at] = bounds[0]!;
    boxes[at + 1] = bounds[1]!;
    boxes[at + 2] = bounds[2]!;
    boxes[at + 3] = bounds[3]!;
  }

  /** Drops the pairs of a handle whose leaves have parted, or of which both are static now, and finds the new ones. */
  private renewPairs(handle: number): void {
    const { states, moving, still } = this;
    // Wraps to 32 bits, as the marks do, and skips NONE, the mark of handles that were never met.
    this.search = (this.search + 1) | 0;
    if (this.search === NONE) this.search = 0;
    const isStatic = states[handle * STATE + STATIC] === 1;
    const tree = isStatic ? still : moving;
    const leaf = states[handle * STATE + LEAF]!;
    let link = states[handle * STATE + FIRST]!;
    while (link !== NONE) {
      const pair = link >> 1;
      const other = this.endOf(link ^ 1) * STATE;
      link = this.next[link]!;
      const isOtherStatic = states[other + STATIC] === 1;
      if ((isStatic && isOtherStatic) || !tree.overlaps(leaf, isOtherStatic ? still : moving, states[other + LEAF]!)) {
        this.dropPair(pair);
        if (link >> 1 === this.pairCount) {
          // The next link was of the last pair, which has taken the place of the dropped one.
          link = 2 * pair + (link & 1);
        }
      } else {
        states[other + MARK] = this.search;
      }
    }
    states[handle * STATE + MARK] = this.search;
    const own = tree.items[leaf]!;
    if (!letsMeet(own.filter, this.filters)) {
      return;
    }
    tree.boxOf(leaf, this.box);
    this.addPairs(own, moving);
    if (!isStatic) {
      this.addPairs(own, still);
    }
  }

  /** Adds the pairs of a handle with the leaves that overlap `box`, unless they are marked, of the same group, or kept apart by the filters. */
  private addPairs({ number, group, filter, kin }: TreeHandle<T>, tree: PackedTree<TreeHandle<T>>): void {
    const { met, states, search, box } = this;
    const count = tree.query(box, met, 0, kin);
    for (let i = 0; i < count; i += 1) {
      const leaf = met[i]!;
      const other = tree.right[leaf]!;
      if (states[other * STATE + MARK] !== search) {
        const item = tree.items[leaf]!;
        if (item.group !== group && letsMeet(item.filter, filter)) {
          this.addPair(number, other);
        }
      }
    }
  }

  private addPair(a: number, b: number): void {
    const pair = this.pairCount;
    const at = pair * PAIR;
    this.pairCount += 1;
    if (at === this.pairs.length) {
      this.pairs = widened(this.pairs, new Int32Array(2 * at));
      this.next = widened(this.next, new Int32Array(4 * pair));
      this.previous = widened(this.previous, new Int32Array(4 * pair));
    }
    this.pairs[at + END_A] = a;
    this.pairs[at + END_B] = b;
    this.pairs[at + NOTE] = 0;
    this.link(a, 2 * pair);
    this.link(b, 2 * pair + 1);
  }

  private link(handle: number, link: number): void {
    this.join(handle, link, this.states[handle * STATE + FIRST]!);
    this.join(handle, NONE, link);
  }

  /** Makes link `after` follow link `before` in the list of a handle; with NONE before, it is the first. */
  private join(handle: number, before: number, after: number): void {
    if (before === NONE) {
      this.states[handle * STATE + FIRST] = after;
    } else {
      this.next[before] = after;
    }
    if (after !== NONE) {
      this.previous[after] = before;
    }
  }

  /** Removes a pair; the last one takes its place. */
  private dropPair(pair: number): void {
    this.unlink(2 * pair);
    this.unlink(2 * pair + 1);
    this.pairCount -= 1;
    const last = this.pairCount;
    if (last !== pair) {
      this.relink(2 * last, 2 * pair);
      this.relink(2 * last + 1, 2 * pair + 1);
      for (let k = 0; k < PAIR; k += 1) {
        this.pairs[pair * PAIR + k] = this.pairs[last * PAIR + k]!;
      }
    }
  }

  private unlink(link: number): void {
    this.join(this.endOf(link), this.previous[link]!, this.next[link]!);
  }

  /** Link `to` takes the place of link `from`. */
  private relink(from: number, to: number): void {
    const handle = this.endOf(from);
    this.join(handle, this.previous[from]!, to);
    this.join(handle, to, this.next[from]!);
  }

  /** The handle in whose list a link is. */
  private endOf(link: number): number {
    return this.pairs[(link >> 1) * PAIR + (link & 1)]!;
  }

  private noteMoved(number: number): void {
    const at = number * STATE + MOVED;
    if (this.states[at] === NONE) {
      this.states[at] = 1;
      this.moved[this.movedCount] = number;
      this.movedCount += 1;
    }
  }

  private handleOf(number: number): TreeHandle<T> {
    const at = number * STATE;
    const tree = this.states[at + STATIC] === 1 ? this.still : this.moving;
    return tree.items[this.states[at + LEAF]!]!;
  }

  private treeOf(handle: TreeHandle<T>): PackedTree<TreeHandle<T>> {
    return handle.isStatic ? this.still : this.moving;
  }

  private owned(where: string, handle: BroadphaseHandle<T>, name = 'handle'): TreeHandle<T> {
    const own = handle as TreeHandle<T>;
    if (!(own instanceof TreeHandle) || this.handleOf(own.number) !== own) {
      throw new TypeError(`${where}: ${name} must be one of this broadphase, and not removed`);
    }
    return own;
  }
}
