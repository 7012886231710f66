import { expect } from 'vitest';
import { BoxTree, type BoxTreeExternalNode, type BoxTreeNode, type Ray, type Rect } from '../../src/index.js';
import { overlap } from './model.js';
import { meeting } from './random-boxes.js';

export interface Item extends BoxTreeExternalNode {
  id: number;
}

/** A {@link BoxTree} beside the plainest possible one: a list of boxes. Every `check…` throws if they differ. */
export class TreeModel {
  readonly tree: BoxTree<Item>;
  readonly boxes = new Map<Item, Rect>();

  constructor(highQuality: boolean) {
    this.tree = BoxTree.create<Item>(highQuality);
  }

  add(item: Item, box: Rect): void {
    const given: Rect = [...box];
    this.tree.add(item, given);
    given.fill(1e6);
    this.boxes.set(item, box);
    expect(typeof item.boxTreeIndex).toBe('number');
    expect(this.tree.needsFinalize()).toBe(true);
  }

  update(item: Item, box: Rect): void {
    const given: Rect = [...box];
    this.tree.update(item, given);
    given.fill(1e6);
    this.boxes.set(item, box);
    expect(typeof item.boxTreeIndex).toBe('number');
    expect(this.tree.needsFinalize()).toBe(true);
  }

  remove(item: Item): void {
    this.tree.remove(item);
    this.boxes.delete(item);
    expect(item.boxTreeIndex).toBe(undefined);
  }

  clear(): void {
    this.tree.clear();
    for (const item of this.boxes.keys()) {
      expect(item.boxTreeIndex).toBe(undefined);
    }
    this.boxes.clear();
  }

  finalize(): void {
    this.tree.finalize();
    expect(this.tree.needsFinalize()).toBe(false);
  }

  where(test: (box: Rect, item: Item) => boolean): Item[] {
    return [...this.boxes].filter(([item, box]) => test(box, item)).map(([item]) => item);
  }

  checkOverlaps(query: Rect, before: readonly Item[], start: number | undefined): void {
    const out = [...before];
    const count = this.tree.getOverlappingNodes(query, out, ...(start === undefined ? [] : [start]));
    written(
      before,
      start,
      out,
      count,
      this.where((box) => overlap(box, query)),
    );
  }

  checkCircle(x: number, y: number, radius: number, before: readonly Item[]): void {
    const out = [...before];
    this.tree.getCircleOverlappingNodes([x, y], radius, out);
    const expected = this.where(([x0, y0, x1, y1]) => {
      const [nearX, nearY] = [Math.min(Math.max(x, x0), x1), Math.min(Math.max(y, y0), y1)];
      return (nearX - x) ** 2 + (nearY - y) ** 2 <= radius ** 2;
    });
    written(before, undefined, out, out.length - before.length, expected);
  }

  checkVisible(planes: readonly [number, number, number][], before: readonly Item[], start: number | undefined): void {
    const out = [...before];
    const count = this.tree.getVisibleNodes(planes, out, ...(start === undefined ? [] : [start]));
    const farthest = (n: number, low: number, high: number) => (n === 0 ? 0 : Math.max(n * low, n * high));
    const expected = this.where(([x0, y0, x1, y1]) =>
      planes.every(([nx, ny, d]) => farthest(nx, x0, x1) + farthest(ny, y0, y1) >= d),
    );
    written(before, start, out, count, expected);
  }

  checkPairs(before: readonly Item[], start: number | undefined): void {
    const out = [...before];
    const count = this.tree.getOverlappingPairs(out, ...(start === undefined ? [] : [start]));
    const from = start ?? before.length;
    const found: string[] = [];
    for (let i = from; i < from + count; i += 2) {
      found.push(key(out[i]!, out[i + 1]!));
    }
    const list = [...this.boxes];
    const expected = list.flatMap(([a, boxA], i) =>
      list.slice(i + 1).flatMap(([b, boxB]) => (overlap(boxA, boxB) ? [key(a, b)] : [])),
    );
    expect(found.sort()).toEqual(expected.sort());
    expect(out.slice(0, from)).toEqual(before.slice(0, from));
    expect(out.slice(from + count)).toEqual(before.slice(from + count));
  }

  /** Depth first, each node as large as what is below, the leaves with the boxes as given. */
  checkNodes(): void {
    const nodes = this.tree.getNodes();
    expect(this.tree.getEndNodeIndex()).toBe(nodes.length);
    expect(this.tree.getRootNode()).toBe(nodes[0]);
    expect(nodes.length).toBe(Math.max(0, 2 * this.boxes.size - 1));
    const leaves = nodes.filter((node) => node.isLeaf());
    expect(new Set(leaves.map((leaf) => leaf.externalNode))).toEqual(new Set(this.boxes.keys()));
    expect(nodes.length === 0 ? 0 : subtree(nodes, 0)).toBe(nodes.length);
    for (const leaf of leaves) {
      sameBox(leaf, this.boxes.get(leaf.externalNode!)!);
    }
  }
}

/** What a callback of `rayTest` answers in {@link checkRay}: a delay behind the box, or nothing. */
export type Answer = (item: Item) => number | null | undefined;

/** Casts a ray through several trees; `inside` is called in every callback. */
export function checkRay(models: readonly TreeModel[], ray: Ray, answer: Answer, inside: () => void): void {
  const met = new Map<Item, number>();
  let bound = ray.maxFactor;
  const trees = models.map((model) => model.tree);
  const result = BoxTree.rayTest(trees, ray, (tree, item, sameRay, distance, upperBound) => {
    const model = models.find((candidate) => candidate.tree === tree);
    expect(sameRay).toBe(ray);
    expect(met.has(item)).toBe(false);
    expect(upperBound).toBe(bound);
    expect(distance).toBe(meeting(model!.boxes.get(item)!, ray));
    expect(distance).toBeLessThan(upperBound);
    met.set(item, distance);
    inside();
    const delay = answer(item);
    if (delay === null || delay === undefined) {
      return delay;
    }
    bound = Math.min(bound, distance + delay);
    return { factor: distance + delay };
  });
  const all = models.flatMap((model) => [...model.boxes].map(([item, box]) => ({ item, factor: meeting(box, ray) })));
  const least = Math.min(...all.map(({ item, factor }) => factor + (answer(item) ?? Infinity)));
  expect(result === null ? null : result.factor).toBe(least < ray.maxFactor ? least : null);
  for (const { item, factor } of all) {
    if (factor < Math.min(least, ray.maxFactor)) {
      expect(met.has(item)).toBe(true);
    }
  }
}

const key = (a: Item, b: Item): string => (a.id < b.id ? `${a.id}-${b.id}` : `${b.id}-${a.id}`);
const ids = (items: readonly Item[]): number[] => items.map((item) => item.id).sort((a, b) => a - b);

/** `out` is `before` with `expected`, in any order, from `start` on. */
function written(
  before: readonly Item[],
  start: number | undefined,
  out: readonly Item[],
  count: number,
  expected: readonly Item[],
): void {
  const from = start ?? before.length;
  expect(count).toBe(expected.length);
  expect(ids(out.slice(from, from + count))).toEqual(ids(expected));
  expect(ids(out.slice(0, from))).toEqual(ids(before.slice(0, from)));
  expect(ids(out.slice(from + count))).toEqual(ids(before.slice(from + count)));
}

/** Checks the node at an index and all below. @returns how many those are. */
function subtree(nodes: readonly BoxTreeNode<Item>[], at: number): number {
  const node = nodes[at]!;
  if (node.isLeaf()) {
    expect(node.escapeNodeOffset).toBe(1);
    return 1;
  }
  const second = at + 1 + subtree(nodes, at + 1);
  const [a, b] = [nodes[at + 1]!, nodes[second]!];
  const size = second - at + subtree(nodes, second);
  expect(node.escapeNodeOffset).toBe(size);
  sameBox(node, [
    Math.min(a.minX, b.minX),
    Math.min(a.minY, b.minY),
    Math.max(a.maxX, b.maxX),
    Math.max(a.maxY, b.maxY),
  ]);
  return size;
}

function sameBox(node: BoxTreeNode<Item>, [x0, y0, x1, y1]: Rect): void {
  expect(node.minX === x0 && node.minY === y0 && node.maxX === x1 && node.maxY === y1).toBe(true);
}
