import { describe, expect, it } from 'vitest';
import { BoxTree, type BoxTreeExternalNode, type Rect } from '../../src/index.js';
import { BROADPHASES, overlap, pairsOf, sampleOf } from '../broadphase/model.js';
import { generator } from '../scenes/mixed.js';

describe.each(BROADPHASES)('broadphase: %s', (_, create) => {
  it('C-233 perform reports overlapping pairs once, touching included', () => {
    const broadphase = create();
    broadphase.insert(0, [0, 0, 1, 1], false);
    broadphase.insert(1, [1, 1, 2, 2], false);
    broadphase.insert(2, [0.5, 0.5, 3, 0.6], true);
    broadphase.insert(3, [9, 9, 10, 10], false);
    expect(pairsOf(broadphase)).toEqual(['0-1', '0-2']);
    expect(pairsOf(broadphase)).toEqual(['0-1', '0-2']);
  });

  it('C-234 two static handles are no pair', () => {
    const broadphase = create();
    broadphase.insert(0, [0, 0, 1, 1], true);
    broadphase.insert(1, [0, 0, 1, 1], true);
    expect(pairsOf(broadphase)).toEqual([]);
  });

  it('C-235 sample sees an update at once', () => {
    const broadphase = create();
    const handle = broadphase.insert(7, [0, 0, 1, 1], false);
    broadphase.insert(8, [1, 0, 2, 1], true);
    expect(sampleOf(broadphase, [1, 1, 1, 1])).toEqual([7, 8]);
    broadphase.update(handle, [50, 50, 51, 51]);
    expect(sampleOf(broadphase, [1, 1, 1, 1])).toEqual([8]);
    expect(sampleOf(broadphase, [50.5, 50.5, 60, 60])).toEqual([7]);
  });

  it('C-236 update without a kind keeps it', () => {
    const broadphase = create();
    for (const isStatic of [true, false]) {
      const handle = broadphase.insert(isStatic, [0, 0, 1, 1], isStatic);
      broadphase.update(handle, [20, 20, 21, 21]);
      expect(handle.isStatic).toBe(isStatic);
    }
    expect(sampleOf(broadphase, [20, 20, 20, 20])).toHaveLength(2);
    expect(sampleOf(broadphase, [0, 0, 1, 1])).toEqual([]);
  });

  it('C-237 update may change the kind; a removed handle is gone', () => {
    const broadphase = create();
    const handle = broadphase.insert(0, [0, 0, 1, 1], false);
    broadphase.insert(1, [0, 0, 1, 1], true);
    expect(pairsOf(broadphase)).toEqual(['0-1']);
    broadphase.update(handle, [0, 0, 1, 1], true);
    expect(handle.isStatic).toBe(true);
    expect(pairsOf(broadphase)).toEqual([]);
    broadphase.remove(handle);
    expect(sampleOf(broadphase, [0, 0, 1, 1])).toEqual([1]);
  });

  it('C-238 clear calls back once per handle', () => {
    const broadphase = create();
    for (let i = 0; i < 6; i += 1) {
      broadphase.insert(i, [0, 0, 1, 1], i % 2 === 0);
    }
    pairsOf(broadphase);
    const cleared: number[] = [];
    broadphase.clear((handle) => cleared.push(Number(handle.data)));
    expect(cleared.sort()).toEqual([0, 1, 2, 3, 4, 5]);
    expect(sampleOf(broadphase, [0, 0, 1, 1])).toEqual([]);
    expect(pairsOf(broadphase)).toEqual([]);
  });
});

describe('BoxTree', () => {
  const random = generator(5);
  const tree = BoxTree.create<BoxTreeExternalNode>(true);
  const boxes = new Map<BoxTreeExternalNode, Rect>();
  for (let i = 0; i < 100; i += 1) {
    const [x, y] = [10 * random(), 10 * random()];
    const box: Rect = [x, y, x + 2 * random(), y + 2 * random()];
    const item: BoxTreeExternalNode = {};
    boxes.set(item, box);
    tree.add(item, box);
  }
  tree.finalize();
  const where = (test: (box: Rect) => boolean) =>
    new Set([...boxes].filter(([, box]) => test(box)).map(([item]) => item));

  it('C-240 finds what brute force finds', () => {
    const query: Rect = [3, 3, 6, 5];
    const nodes: BoxTreeExternalNode[] = [];
    expect(tree.getOverlappingNodes(query, nodes)).toBe(nodes.length);
    expect(new Set(nodes)).toEqual(where((box) => overlap(box, query)));
    const round: BoxTreeExternalNode[] = [];
    tree.getCircleOverlappingNodes([5, 5], 2, round);
    const inCircle = where(([x0, y0, x1, y1]) => {
      const dx = Math.max(x0 - 5, 0, 5 - x1);
      const dy = Math.max(y0 - 5, 0, 5 - y1);
      return dx * dx + dy * dy <= 4;
    });
    expect(new Set(round)).toEqual(inCircle);
    const pairs: BoxTreeExternalNode[] = [];
    const count = tree.getOverlappingPairs(pairs);
    const items = [...boxes];
    const key = (a: BoxTreeExternalNode, b: BoxTreeExternalNode) =>
      [a.boxTreeIndex!, b.boxTreeIndex!].sort((p, q) => p - q).join();
    const expected = items.flatMap(([a, boxA], i) =>
      items.slice(i + 1).flatMap(([b, boxB]) => (overlap(boxA, boxB) ? [key(a, b)] : [])),
    );
    const found = Array.from({ length: count / 2 }, (_, i) => key(pairs[2 * i]!, pairs[2 * i + 1]!));
    expect(found.sort()).toEqual(expected.sort());
    expect(count).toBe(pairs.length);
  });

  it('C-241 rayTest returns the smallest factor, or null', () => {
    const ray = { origin: [-1, 4], direction: [1, 0.1], maxFactor: 100 };
    let least = Infinity;
    const all = BoxTree.rayTest([tree], ray, (_tree, _item, _ray, distance) => {
      least = Math.min(least, distance);
      return { factor: distance };
    });
    expect(all).toEqual({ factor: least });
    expect(least).toBeLessThan(100);
    expect(BoxTree.rayTest([tree], ray, () => null)).toBe(null);
  });
});
