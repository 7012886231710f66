import type { Ray, RectLike, Vec2Like, Vec3Like } from '../math/vectors.js';
import { boolean, nonNegative, typeError, vector } from '../validate.js';
import { badBounds, isRect } from './broadphase.js';
import { PackedTree } from './packed-tree.js';

/** Anything that can be put into a {@link BoxTree}; the tree writes its index. */
export interface BoxTreeExternalNode {
  boxTreeIndex?: number | undefined;
}

/** What a {@link BoxTree.rayTest} callback answers for a hit. */
export interface BoxTreeRayResult {
  factor: number;
}

/** A node as `getNodes` shows it: depth first, each followed by its subtrees. */
export class BoxTreeNode<T extends BoxTreeExternalNode = BoxTreeExternalNode> {
  static readonly version = 1;

  /** @internal */
  constructor(
    public minX: number,
    public minY: number,
    public maxX: number,
    public maxY: number,
    /** How many places further the next node outside this subtree is. */
    public escapeNodeOffset: number,
    /** Set on leaves only. */
    public externalNode: T | undefined,
  ) {}

  isLeaf(): boolean {
    return this.externalNode !== undefined;
  }
}

/**
 * A hierarchy of bounding boxes over objects of yours. Boxes that touch overlap. After `add`, `update` or `remove`, `finalize` is to
 * be called before queries. Results come in no particular order.
 */
export class BoxTree<T extends BoxTreeExternalNode = BoxTreeExternalNode> {
  static readonly version = 1;

  private readonly tree = new PackedTree<T>();
  private dirty = false;
  private nodes: BoxTreeNode<T>[] | null = null;

  /** `highQuality` is accepted for compatibility: every tree is built with the same care. */
  static create<T extends BoxTreeExternalNode = BoxTreeExternalNode>(highQuality: boolean): BoxTree<T> {
    boolean('BoxTree.create', 'highQuality', highQuality);
    return new BoxTree<T>();
  }

  /** Adds an object with its bounds `[minX, minY, maxX, maxY]`. */
  add(externalNode: T, extents: RectLike): void {
    checkNode('BoxTree.add', externalNode);
    checkExtents('BoxTree.add', extents);
    if (externalNode.boxTreeIndex !== undefined) {
      throw typeError('BoxTree.add', 'externalNode', 'an object that is in no tree', externalNode);
    }
    externalNode.boxTreeIndex = this.tree.insert(externalNode, extents, 0);
    this.changed();
  }

  /** Gives an object new bounds; one that is in no tree is added. */
  update(externalNode: T, extents: RectLike): void {
    checkNode('BoxTree.update', externalNode);
    checkExtents('BoxTree.update', extents);
    if (externalNode.boxTreeIndex === undefined) {
      this.add(externalNode, extents);
      return;
    }
    this.checkMember('BoxTree.update', externalNode);
    this.tree.move(externalNode.boxTreeIndex, extents, 0);
    this.changed();
  }

  /** Takes an object out; one that is in no tree is ignored. */
  remove(externalNode: T): void {
    checkNode('BoxTree.remove', externalNode);
    if (externalNode.boxTreeIndex === undefined) {
      return;
    }
    this.checkMember('BoxTree.remove', externalNode);
    this.tree.remove(externalNode.boxTreeIndex);
    externalNode.boxTreeIndex = undefined;
    this.changed();
  }

  /** Whether there were changes since the last `finalize`. */
  needsFinalize(): boolean {
    return this.dirty;
  }

  /** Makes changes visible to queries. */
  finalize(): void {
    this.dirty = false;
  }

  /** Takes everything out. */
  clear(): void {
    for (const item of this.tree.items) {
      if (item !== null) {
        item.boxTreeIndex = undefined;
      }
    }
    this.tree.clear();
    this.nodes = null;
    this.dirty = false;
  }

  /** Writes what overlaps `queryExtents` from `startIndex` (default: the array's length) on. @returns how many. */
  getOverlappingNodes(queryExtents: RectLike, overlappingNodes: T[], startIndex = overlappingNodes.length): number {
    checkExtents('BoxTree.getOverlappingNodes', queryExtents);
    return this.tree.query(queryExtents, overlappingNodes, startIndex) - startIndex;
  }

  /** Appends what lies within `radius` of `center`: boxes whose squared distance to it is at most radius². */
  getCircleOverlappingNodes(center: Vec2Like, radius: number, overlappingNodes: T[]): void {
    vector('BoxTree.getCircleOverlappingNodes', 'center', center, 2);
    nonNegative('BoxTree.getCircleOverlappingNodes', 'radius', radius);
    const x = center[0]!;
    const y = center[1]!;
    this.select(
      (boxes, at) => {
        const dx = Math.max(boxes[at]! - x, 0, x - boxes[at + 2]!);
        const dy = Math.max(boxes[at + 1]! - y, 0, y - boxes[at + 3]!);
        return dx * dx + dy * dy <= radius * radius;
      },
      overlappingNodes,
      overlappingNodes.length,
    );
  }

  /** Writes each overlapping pair once, as two consecutive entries, from `startIndex` on. @returns the number of entries. */
  getOverlappingPairs(overlappingPairs: T[], startIndex = overlappingPairs.length): number {
    const found: T[] = [];
    let end = startIndex;
    for (const item of this.tree.items) {
      if (item === null || item === undefined) {
        continue;
      }
      const own = item.boxTreeIndex!;
      const count = this.tree.query(this.tree.boxOf(own), found, 0);
      for (let i = 0; i < count; i += 1) {
        if (found[i]!.boxTreeIndex! > own) {
          overlappingPairs[end] = item;
          overlappingPairs[end + 1] = found[i]!;
          end += 2;
        }
      }
    }
    return end - startIndex;
  }

  /**
   * Writes what lies inside all planes `[nx, ny, d]` from `startIndex` on: boxes whose farthest corner along (nx, ny) has
   * n · p ≥ d. @returns how many.
   */
  getVisibleNodes(planes: ArrayLike<Vec3Like>, visibleNodes: T[], startIndex = visibleNodes.length): number {
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
    return this.select(inside, visibleNodes, startIndex) - startIndex;
  }

  /** The top node, or `undefined` for an empty tree. */
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
   * smallest factor answered so far, at first `ray.maxFactor`. @returns the answer with the smallest factor, or `null`.
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
    vector('BoxTree.rayTest', 'ray.origin', ray.origin, 2);
    vector('BoxTree.rayTest', 'ray.direction', ray.direction, 2);
    let upperBound = ray.maxFactor;
    let best: R | null = null;
    for (const owner of trees) {
      const { tree } = owner;
      const stack = tree.root < 0 ? [] : [tree.root];
      while (stack.length > 0) {
        const node = stack.pop()!;
        const distance = entry(tree.boxOf(node), ray);
        if (!(distance < upperBound)) {
          continue;
        }
        if (!tree.isLeaf(node)) {
          const a = tree.left[node]!;
          const b = tree.right[node]!;
          const aFirst = entry(tree.boxOf(a), ray) <= entry(tree.boxOf(b), ray);
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

  /** Writes the leaves for which `test` holds; it must hold for every box around one for which it holds. */
  private select(test: (boxes: Float64Array, at: number) => boolean, out: T[], start: number): number {
    const { tree } = this;
    const stack = tree.root < 0 ? [] : [tree.root];
    let end = start;
    while (stack.length > 0) {
      const node = stack.pop()!;
      if (!test(tree.boxes, 4 * node)) {
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

  /** Lists the nodes depth first; an inner node learns its offset when its subtree is done. */
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

function checkExtents(where: string, extents: RectLike): void {
  if (typeof extents !== 'object' || extents === null || !isRect(extents)) {
    throw badBounds(where, extents);
  }
}

/** The factor at which a ray enters a box: 0 from inside, `Infinity` if it never does (slabs; Kay & Kajiya 1986). */
function entry(box: ArrayLike<number>, ray: Ray): number {
  let near = 0;
  let far = Infinity;
  for (let axis = 0; axis < 2; axis += 1) {
    const from = ray.origin[axis]!;
    const step = ray.direction[axis]!;
    const low = box[axis]!;
    const high = box[axis + 2]!;
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
