import type { Ray, RectLike, Vec2Like, Vec3Like } from '../math/vectors.js';
import {
  boolean,
  callable,
  checkedRay,
  instance,
  integer,
  list,
  nonNegative,
  optional,
  typeError,
  vector,
} from '../validate.js';
import { checkRect } from './broadphase.js';
import { BOX, NONE } from './layout.js';
import { PackedTree } from './packed-tree.js';

/** Anything that can be put into a {@link BoxTree}; the tree writes its index into it. */
export interface BoxTreeExternalNode {
  /** Written by the tree: the index of the object in it, `undefined` if it is in none. */
  boxTreeIndex?: number | undefined;
}

/** What a {@link BoxTree.rayTest} callback returns for a hit. */
export interface BoxTreeRayResult {
  /** How far along the ray, in lengths of its direction. What is visited later has to be nearer than that. */
  factor: number;
}

/** A node as `getNodes` lists it: depth first, each followed by its subtrees. */
export class BoxTreeNode<T extends BoxTreeExternalNode = BoxTreeExternalNode> {
  /** Of the class, as in Turbulenz. */
  static get version(): number {
    return 1;
  }

  /** @internal */
  constructor(
    /** Left side of the bounds. */
    public minX: number,
    /** Upper side of the bounds: y points down. */
    public minY: number,
    /** Right side of the bounds. */
    public maxX: number,
    /** Lower side of the bounds. */
    public maxY: number,
    /** How many places further in the list the next node outside this subtree is. */
    public escapeNodeOffset: number,
    /** The object of a leaf; `undefined` for inner nodes. */
    public externalNode: T | undefined,
  ) {}

  /** Whether it is a leaf, with an object and without children. */
  isLeaf(): boolean {
    return this.externalNode !== undefined;
  }
}

/**
 * A hierarchy of bounding boxes over objects of yours. Boxes that touch overlap. After `add`, `update` or `remove`, call `finalize` before
 * queries. Results come in no particular order.
 */
export class BoxTree<T extends BoxTreeExternalNode = BoxTreeExternalNode> {
  /** Of the class, as in Turbulenz. */
  static get version(): number {
    return 1;
  }

  private readonly tree = new PackedTree<T>(0);
  /** Leaves that a query found: scratch. */
  private readonly met: number[] = [];
  private dirty = false;
  private nodes: BoxTreeNode<T>[] | null = null;

  /** Makes an empty tree. `highQuality` is accepted for compatibility: every tree is built with the same care. */
  static create<T extends BoxTreeExternalNode = BoxTreeExternalNode>(highQuality: boolean): BoxTree<T> {
    boolean('BoxTree.create', 'highQuality', highQuality);
    return new BoxTree<T>();
  }

  /** Adds an object with its bounds `[minX, minY, maxX, maxY]`. @throws TypeError if it is in a tree already. */
  add(externalNode: T, extents: RectLike): void {
    checkNode('BoxTree.add', externalNode);
    checkRect('BoxTree.add', extents, 'extents');
    if (externalNode.boxTreeIndex !== undefined) {
      throw typeError('BoxTree.add', 'externalNode', 'an object that is in no tree', externalNode);
    }
    this.enter('BoxTree.add', externalNode, extents);
  }

  private enter(where: string, externalNode: T, extents: RectLike): void {
    writeIndex(where, externalNode, NONE);
    externalNode.boxTreeIndex = this.tree.insert(externalNode, extents);
    this.changed();
  }

  /** Gives an object new bounds; one that is in no tree is added. @throws TypeError if it is in another tree. */
  update(externalNode: T, extents: RectLike): void {
    checkNode('BoxTree.update', externalNode);
    checkRect('BoxTree.update', extents, 'extents');
    if (externalNode.boxTreeIndex === undefined) {
      this.enter('BoxTree.update', externalNode, extents);
      return;
    }
    this.checkMember('BoxTree.update', externalNode);
    this.tree.move(externalNode.boxTreeIndex, extents);
    this.changed();
  }

  /** Removes an object; one that is in no tree is ignored. @throws TypeError if it is in another tree. */
  remove(externalNode: T): void {
    checkNode('BoxTree.remove', externalNode);
    if (externalNode.boxTreeIndex === undefined) {
      return;
    }
    this.checkMember('BoxTree.remove', externalNode);
    const leaf = externalNode.boxTreeIndex;
    writeIndex('BoxTree.remove', externalNode, undefined);
    this.tree.remove(leaf);
    this.changed();
  }

  /** Whether there have been changes since the last `finalize`. */
  needsFinalize(): boolean {
    return this.dirty;
  }

  /** Makes changes visible to queries. */
  finalize(): void {
    this.dirty = false;
  }

  /** Removes everything. */
  clear(): void {
    for (const item of this.tree.items) {
      if (item !== null) {
        Reflect.set(item, 'boxTreeIndex', undefined);
      }
    }
    this.tree.clear();
    this.nodes = null;
    this.dirty = false;
  }

  /** Writes the objects that overlap `queryExtents` to `overlappingNodes`, from `startIndex` (default: the array's length) on. @returns how many. */
  getOverlappingNodes(queryExtents: RectLike, overlappingNodes: T[], startIndex?: number): number {
    checkRect('BoxTree.getOverlappingNodes', queryExtents, 'queryExtents');
    const start = checkedStart('BoxTree.getOverlappingNodes', 'overlappingNodes', overlappingNodes, startIndex);
    const { tree, met } = this;
    const count = tree.query(queryExtents, met, 0);
    for (let i = 0; i < count; i += 1) {
      overlappingNodes[start + i] = tree.items[met[i]!]!;
    }
    return count;
  }

  /** Appends the objects within `radius` of `center`: boxes whose squared distance to it is at most radius². */
  getCircleOverlappingNodes(center: Vec2Like, radius: number, overlappingNodes: T[]): void {
    vector('BoxTree.getCircleOverlappingNodes', 'center', center, 2);
    nonNegative('BoxTree.getCircleOverlappingNodes', 'radius', radius);
    const start = checkedStart('BoxTree.getCircleOverlappingNodes', 'overlappingNodes', overlappingNodes, undefined);
    const x = center[0]!;
    const y = center[1]!;
    // Scaled so that the square of the radius is neither infinite nor 0.
    const scale = radius > 1e150 ? 1e-200 : radius < 1e-150 ? 1e200 : 1;
    const reach = radius * scale;
    const isNear = (boxes: Float64Array, at: number): boolean => {
      const dx = scale * Math.max(boxes[at]! - x, 0, x - boxes[at + 2]!);
      const dy = scale * Math.max(boxes[at + 1]! - y, 0, y - boxes[at + 3]!);
      return dx * dx + dy * dy <= reach * reach;
    };
    this.select(isNear, overlappingNodes, start);
  }

  /**
   * Writes each overlapping pair once, as two consecutive entries, from `startIndex` (default: the array's length) on. @returns the number
   * of entries.
   */
  getOverlappingPairs(overlappingPairs: T[], startIndex?: number): number {
    const start = checkedStart('BoxTree.getOverlappingPairs', 'overlappingPairs', overlappingPairs, startIndex);
    const { tree, met } = this;
    let end = start;
    for (const item of tree.items) {
      if (item === null || item === undefined) {
        continue;
      }
      const own = item.boxTreeIndex!;
      const count = tree.query(tree.boxOf(own), met, 0);
      for (let i = 0; i < count; i += 1) {
        if (met[i]! > own) {
          overlappingPairs[end] = item;
          overlappingPairs[end + 1] = tree.items[met[i]!]!;
          end += 2;
        }
      }
    }
    return end - start;
  }

  /**
   * Writes the objects inside all planes `[nx, ny, d]`, from `startIndex` (default: the array's length) on: boxes whose farthest corner
   * along (nx, ny) has n · p ≥ d. @returns how many.
   */
  getVisibleNodes(planes: ArrayLike<Vec3Like>, visibleNodes: T[], startIndex?: number): number {
    if (typeof planes !== 'object' || planes === null || !(planes.length >= 0)) {
      throw typeError('BoxTree.getVisibleNodes', 'planes', 'an array of planes [nx, ny, d]', planes);
    }
    const start = checkedStart('BoxTree.getVisibleNodes', 'visibleNodes', visibleNodes, startIndex);
    for (let i = 0; i < planes.length; i += 1) {
      vector('BoxTree.getVisibleNodes', `planes[${i}]`, planes[i], 3);
    }
    const inside = (boxes: Float64Array, at: number): boolean => {
      for (let i = 0; i < planes.length; i += 1) {
        const [nx, ny, d] = [planes[i]![0]!, planes[i]![1]!, planes[i]![2]!];
        const x = boxes[nx > 0 ? at + 2 : at]!;
        const y = boxes[ny > 0 ? at + 3 : at + 1]!;
        if (!((nx === 0 ? 0 : nx * x) + (ny === 0 ? 0 : ny * y) >= d)) {
          return false;
        }
      }
      return true;
    };
    return this.select(inside, visibleNodes, start) - start;
  }

  /** The root node, or `undefined` for an empty tree. */
  getRootNode(): BoxTreeNode<T> | undefined {
    return this.getNodes()[0];
  }

  /** All nodes, depth first. */
  getNodes(): BoxTreeNode<T>[] {
    if (this.nodes === null) {
      this.nodes = [];
      if (this.tree.root >= 0) {
        this.listNodes(this.nodes);
      }
    }
    return this.nodes;
  }

  /** The number of nodes. */
  getEndNodeIndex(): number {
    return this.getNodes().length;
  }

  /**
   * Calls back for each object whose box the ray meets at a distance (as a factor of the direction; 0 if it starts inside) below the
   * smallest factor returned so far, at first `ray.maxFactor`. @returns the result with the smallest factor, or `null`.
   */
  static rayTest<N extends BoxTreeExternalNode, R extends BoxTreeRayResult>(
    trees: readonly BoxTree<N>[],
    ray: Ray,
    callback: (
      tree: BoxTree<N>,
      externalNode: N,
      ray: Ray,
      distance: number,
      upperBound: number,
    ) => R | null | undefined,
  ): R | null {
    checkTrees('BoxTree.rayTest', trees);
    checkedRay('BoxTree.rayTest', ray);
    callable('BoxTree.rayTest', 'callback', callback);
    // Read before any callback, which may write to it.
    const origin = [ray.origin[0]!, ray.origin[1]!];
    const direction = [ray.direction[0]!, ray.direction[1]!];
    let upperBound = ray.maxFactor;
    let best: R | null = null;
    for (const owner of trees) {
      const { tree } = owner;
      const stack = tree.root < 0 ? [] : [tree.root];
      const { boxes } = tree;
      while (stack.length > 0) {
        const node = stack.pop()!;
        const distance = entry(boxes, BOX * node, origin, direction);
        if (!(distance < upperBound)) {
          continue;
        }
        if (!tree.isLeaf(node)) {
          const a = tree.left[node]!;
          const b = tree.right[node]!;
          const aFirst = entry(boxes, BOX * a, origin, direction) <= entry(boxes, BOX * b, origin, direction);
          stack.push(aFirst ? b : a, aFirst ? a : b);
          continue;
        }
        const result = callback(owner, tree.items[node]!, ray, distance, upperBound);
        if (result !== null && result !== undefined && result.factor < upperBound) {
          upperBound = result.factor;
          best = result;
        }
      }
    }
    return best;
  }

  /** Writes the objects for which `test` holds. It must hold for every box around one for which it holds. */
  private select(test: (boxes: Float64Array, at: number) => boolean, out: T[], start: number): number {
    const { tree } = this;
    const stack = tree.root < 0 ? [] : [tree.root];
    let end = start;
    while (stack.length > 0) {
      const node = stack.pop()!;
      if (!test(tree.boxes, BOX * node)) {
        continue;
      }
      if (tree.isLeaf(node)) {
        out[end] = tree.items[node]!;
        end += 1;
      } else {
        stack.push(tree.right[node]!, tree.left[node]!);
      }
    }
    return end;
  }

  /** Lists the nodes depth first; an inner node gets its offset when its subtree is done. */
  private listNodes(nodes: BoxTreeNode<T>[]): void {
    const { tree } = this;
    const stack = [tree.root];
    const open: { node: BoxTreeNode<T>; index: number; rest: number }[] = [];
    while (stack.length > 0) {
      const at = stack.pop()!;
      const [minX, minY, maxX, maxY] = tree.boxOf(at);
      const leaf = tree.isLeaf(at);
      const node = new BoxTreeNode(minX!, minY!, maxX!, maxY!, 1, leaf ? tree.items[at]! : undefined);
      nodes.push(node);
      if (!leaf) {
        stack.push(tree.right[at]!, tree.left[at]!);
        open.push({ node, index: nodes.length - 1, rest: 2 });
        continue;
      }
      for (let top = open.at(-1); top !== undefined; top = open.at(-1)) {
        top.rest -= 1;
        if (top.rest > 0) {
          break;
        }
        top.node.escapeNodeOffset = nodes.length - top.index;
        open.pop();
      }
    }
  }

  private changed(): void {
    this.dirty = true;
    this.nodes = null;
  }

  private checkMember(where: string, externalNode: T): void {
    if (this.tree.items[externalNode.boxTreeIndex!] !== externalNode) {
      throw typeError(where, 'externalNode', 'an object of this tree', externalNode);
    }
  }
}

function checkNode(where: string, externalNode: unknown): void {
  if (typeof externalNode !== 'object' || externalNode === null) {
    throw typeError(where, 'externalNode', 'an object', externalNode);
  }
}

/** Writes the index into an object, before anything else is changed: a frozen object is refused. */
function writeIndex(where: string, externalNode: BoxTreeExternalNode, index: number | undefined): void {
  if (!Reflect.set(externalNode, 'boxTreeIndex', index)) {
    throw typeError(where, 'externalNode', 'an object with a boxTreeIndex that can be written', externalNode);
  }
}

/** The index from which to write to an array: `startIndex`, or its end. */
function checkedStart(where: string, name: string, out: ArrayLike<unknown>, startIndex: number | undefined): number {
  list(where, name, out);
  return integer(where, 'startIndex', optional(startIndex, out.length), 0);
}

function checkTrees(where: string, trees: unknown): void {
  if (!Array.isArray(trees)) {
    throw typeError(where, 'trees', 'an array of trees', trees);
  }
  trees.forEach((tree: unknown, i) => {
    instance(where, `trees[${i}]`, tree, BoxTree, 'a BoxTree');
  });
}

/** The factor at which a ray enters the box at an index: 0 from inside, `Infinity` if it never does (slabs; Kay & Kajiya 1986). */
function entry(boxes: Float64Array, at: number, origin: number[], direction: number[]): number {
  let near = 0;
  let far = Infinity;
  for (let axis = 0; axis < 2; axis += 1) {
    const from = origin[axis]!;
    const step = direction[axis]!;
    const low = boxes[at + axis]!;
    const high = boxes[at + axis + 2]!;
    if (step === 0) {
      if (from < low || from > high) {
        return Infinity;
      }
      continue;
    }
    const a = (low - from) / step;
    const b = (high - from) / step;
    near = Math.max(near, Math.min(a, b));
    far = Math.min(far, Math.max(a, b));
  }
  return near <= far ? near : Infinity;
}
