import { describe, expect, it } from 'vitest';
import { PackedTree } from '../../src/broadphase/packed-tree.js';
import { BoxTree, BoxTreeBroadphase, type BoxTreeExternalNode, type Rect, type Vec2 } from '../../src/index.js';
import { bestTime } from '../best-time.js';
import { generator } from '../scenes/mixed.js';
import { overlap } from './model.js';

interface Item extends BoxTreeExternalNode {
  id: number;
}

const ids = (items: readonly Item[]): number[] => items.map((item) => item.id).sort((a, b) => a - b);

function around([x, y]: Vec2, reach: number): Rect {
  return [x - reach, y - reach, x + reach, y + reach];
}

function randomTree(count: number, seed: number): { tree: BoxTree<Item>; items: Item[]; boxes: Rect[] } {
  const random = generator(seed);
  const tree = BoxTree.create<Item>(true);
  const items: Item[] = [];
  const boxes: Rect[] = [];
  for (let id = 0; id < count; id += 1) {
    const [x, y] = [10 * random(), 10 * random()];
    boxes.push([x, y, x + random(), y + random()]);
    items.push({ id });
    tree.add(items[id]!, boxes[id]!);
  }
  tree.finalize();
  return { tree, items, boxes };
}

describe('box tree', () => {
  it('shows its nodes depth first, with the way out of each subtree', () => {
    const { tree } = randomTree(40, 1);
    const nodes = tree.getNodes();
    expect(nodes).toHaveLength(79);
    expect(tree.getEndNodeIndex()).toBe(79);
    expect(tree.getRootNode()).toBe(nodes[0]);
    expect(nodes[0]!.escapeNodeOffset).toBe(79);
    nodes.forEach((node, i) => {
      const subtree = nodes.slice(i, i + node.escapeNodeOffset);
      expect(subtree.filter((n) => n.isLeaf())).toHaveLength((node.escapeNodeOffset + 1) / 2);
      for (const inner of subtree) {
        expect(
          inner.minX >= node.minX && inner.maxX <= node.maxX && inner.minY >= node.minY && inner.maxY <= node.maxY,
        ).toBe(true);
      }
    });
  });

  it('writes and clears the index of its objects', () => {
    const tree = BoxTree.create<Item>(false);
    const item: Item = { id: 1 };
    expect(tree.getOverlappingNodes([0, 0, 9, 9], [])).toBe(0);
    expect([tree.needsFinalize(), tree.getRootNode()]).toEqual([false, undefined]);
    tree.update(item, [0, 0, 1, 1]);
    expect(item.boxTreeIndex).toBeTypeOf('number');
    expect(tree.needsFinalize()).toBe(true);
    tree.finalize();
    expect(tree.needsFinalize()).toBe(false);
    expect(() => tree.add(item, [0, 0, 1, 1])).toThrow(TypeError);
    tree.update(item, [5, 5, 6, 6]);
    tree.finalize();
    const found: Item[] = [item];
    expect(tree.getOverlappingNodes([6, 6, 7, 7], found)).toBe(1);
    expect(found).toEqual([item, item]);
    tree.remove(item);
    expect(item.boxTreeIndex).toBe(undefined);
    tree.remove(item);
    tree.add(item, [0, 0, 1, 1]);
    tree.clear();
    expect(item.boxTreeIndex).toBe(undefined);
    expect(tree.getNodes()).toEqual([]);
  });

  it('finds what lies inside planes', () => {
    const { tree, items, boxes } = randomTree(60, 2);
    const planes = [
      [1, 0, 3],
      [-0.6, -0.8, -9],
    ];
    const expected = items.filter((_, i) =>
      planes.every(([nx, ny, d]) => {
        const [x0, y0, x1, y1] = boxes[i]!;
        return (nx! > 0 ? x1 : x0) * nx! + (ny! > 0 ? y1 : y0) * ny! >= d!;
      }),
    );
    const found: Item[] = [items[0]!];
    expect(tree.getVisibleNodes(planes, found, 1)).toBe(expected.length);
    expect(ids(found.slice(1))).toEqual(ids(expected));
    expect(expected.length).toBeGreaterThan(5);
  });

  it('meets rays along an axis, without end, from inside', () => {
    const tree = BoxTree.create<Item>(true);
    const items = [0, 1, 2].map((id) => ({ id }) as Item);
    items.forEach((item, i) => {
      tree.add(item, [10 * i, 0, 10 * i + 1, 1]);
    });
    tree.finalize();
    const met: [number, number][] = [];
    const ray = { origin: [0.5, 0.5], direction: [2, 0], maxFactor: Infinity };
    const result = BoxTree.rayTest([tree], ray, (_tree, item, _ray, distance) => {
      met.push([item.id, distance]);
      return item.id === 2 ? { factor: distance } : null;
    });
    expect(met).toEqual([
      [0, 0],
      [1, 4.75],
      [2, 9.75],
    ]);
    expect(result).toEqual({ factor: 9.75 });
    const upward = { origin: [5, 0], direction: [0, 1], maxFactor: Infinity };
    expect(BoxTree.rayTest([tree], upward, () => ({ factor: 1 }))).toBe(null);
  });

  it('refuses bad arguments', () => {
    const tree = BoxTree.create<Item>(true);
    expect(() => tree.add({ id: 0 }, [1, 0, 0, 1])).toThrow('BoxTree.add: extents[2] must be >= extents[0] = 1, got 0');
    expect(() => tree.add(null as never, [0, 0, 1, 1])).toThrow(
      'BoxTree.add: externalNode must be an object, got null',
    );
    expect(() => tree.update({ id: 0, boxTreeIndex: 3 }, [0, 0, 1, 1])).toThrow('must be an object of this tree');
    expect(() => tree.getCircleOverlappingNodes([0, 0], -1, [])).toThrow('radius must be a finite number >= 0, got -1');
  });
});

/** Checks the nodes below one: its box is as large as theirs together, their heights differ little. @returns height, and perimeters of the inner nodes. */
function checkBelow(tree: PackedTree<number>, node: number): { height: number; perimeter: number } {
  if (tree.isLeaf(node)) {
    return { height: 0, perimeter: 0 };
  }
  const below = [tree.left[node]!, tree.right[node]!];
  const [a, b] = below.map((child) => checkBelow(tree, child));
  const [boxA, boxB] = below.map((child) => tree.boxOf(child));
  const box = [...tree.boxOf(node)];
  expect(box).toEqual([0, 1, 2, 3].map((k) => (k < 2 ? Math.min : Math.max)(boxA![k]!, boxB![k]!)));
  expect(Math.abs(a!.height - b!.height)).toBeLessThanOrEqual(4);
  const perimeter = 2 * (box[2]! - box[0]! + box[3]! - box[1]!);
  return { height: 1 + Math.max(a!.height, b!.height), perimeter: perimeter + a!.perimeter + b!.perimeter };
}

/** Perimeters of the inner nodes of a tree in which each divides its boxes at the median, across its longer side. */
function halved(boxes: readonly (readonly number[])[]): number {
  if (boxes.length < 2) {
    return 0;
  }
  const [x0, y0, x1, y1] = [0, 1, 2, 3].map((k) => (k < 2 ? Math.min : Math.max)(...boxes.map((box) => box[k]!)));
  const [width, height] = [x1! - x0!, y1! - y0!];
  const k = width > height ? 0 : 1;
  const sorted = [...boxes].sort((a, b) => a[k]! + a[k + 2]! - b[k]! - b[k + 2]!);
  const middle = sorted.length >> 1;
  return 2 * (width + height) + halved(sorted.slice(0, middle)) + halved(sorted.slice(middle));
}

describe('packed tree', () => {
  const inOrder: [string, (i: number) => Rect][] = [
    ['a row', (i) => [i, 0, i + 1, 1]],
    ['a grid', (i) => [i % 64, i >> 6, (i % 64) + 1, (i >> 6) + 1]],
    ['a pile of equal boxes', () => [0, 0, 1, 1]],
  ];
  it.each(inOrder)('stays low for %s', (_, box) => {
    const tree = new PackedTree<number>(0.1);
    const leaves: number[] = [];
    for (let i = 0; i < 4096; i += 1) {
      leaves.push(tree.insert(i, box(i)));
    }
    expect(checkBelow(tree, tree.root).height).toBeLessThanOrEqual(2 * Math.log2(4096));
    leaves.forEach((leaf, i) => {
      const [x0, y0, x1, y1] = box(i);
      tree.move(leaf, [x0 + 0.5, y0, x1 + 0.5, y1]);
    });
    expect(checkBelow(tree, tree.root).height).toBeLessThanOrEqual(2 * Math.log2(4096));
    for (const leaf of leaves.slice(0, 4000)) {
      tree.remove(leaf);
    }
    expect(checkBelow(tree, tree.root).height).toBeLessThanOrEqual(2 * Math.log2(96));
    const out: number[] = [];
    expect(tree.query([-1e9, -1e9, 1e9, 1e9], out, 0)).toBe(96);
  });
});

describe('packed tree, used for long', () => {
  const COUNT = 500;

  /** Boxes of 0.5 m or, some of them, 8 m, anywhere in 40 m; never empty. */
  const boxes = (seed: number): (() => Rect) => {
    const random = generator(seed);
    return () => {
      const [x, y, size] = [40 * random(), 40 * random(), random() < 0.05 ? 8 : 0.5];
      return [x, y, x + size * (0.1 + random()), y + size * (0.1 + random())];
    };
  };

  it('keeps its boxes tight and its heights alike', () => {
    for (let seed = 1; seed <= 4; seed += 1) {
      const random = generator(seed);
      const box = boxes(seed);
      const tree = new PackedTree<number>(0.1);
      const leaves: number[] = [];
      for (let i = 0; i < 10 * COUNT; i += 1) {
        const k = Math.floor(random() * leaves.length);
        const choice = random();
        // A row now and then: the worst there is for a tree that only looks at perimeters.
        const next: Rect = i % COUNT < 100 ? [i, 0, i + 1, 1] : box();
        if (leaves.length < 10 || choice < 0.4) {
          leaves.push(tree.insert(i, next));
        } else if (choice < 0.7) {
          tree.move(leaves[k]!, next);
        } else {
          tree.remove(leaves[k]!);
          leaves[k] = leaves.at(-1)!;
          leaves.pop();
        }
        if (i % 50 === 0) {
          const { height } = checkBelow(tree, tree.root);
          expect(height).toBeLessThanOrEqual(2.47 * Math.log2(leaves.length) + 1);
        }
      }
    }
  });

  it('is as good after many moves as one that is built anew by halves', () => {
    let [worn, fresh] = [0, 0];
    for (let seed = 1; seed <= 6; seed += 1) {
      const random = generator(seed);
      const box = boxes(10 + seed);
      const tree = new PackedTree<number>(0);
      const leaves = Array.from({ length: COUNT }, (_, i) => tree.insert(i, box()));
      for (let round = 0; round < 40; round += 1) {
        for (const leaf of leaves) {
          const [dx, dy] = [random() - 0.5, random() - 0.5];
          const [x0, y0, x1, y1] = round < 20 ? box() : tree.boxOf(leaf);
          tree.move(leaf, [x0! + dx, y0! + dy, x1! + dx, y1! + dy]);
        }
      }
      worn += checkBelow(tree, tree.root).perimeter;
      fresh += halved(leaves.map((leaf) => [...tree.boxOf(leaf)]));
    }
    console.log(`perimeters of trees after ${40 * COUNT} moves, beside new ones: × ${(worn / fresh).toFixed(3)}`);
    expect(worn / fresh).toBeLessThan(1.05);
  });

  it('stays good where each thing goes its own way', () => {
    let [worn, fresh] = [0, 0];
    for (let seed = 1; seed <= 6; seed += 1) {
      const random = generator(20 + seed);
      const tree = new PackedTree<number>(0.1);
      const flights = Array.from({ length: COUNT }, () => {
        const [x, y] = [40 * random(), 40 * random()];
        return { x, y, dx: random() - 0.5, dy: random() - 0.5, leaf: tree.insert(0, [x, y, x + 0.5, y + 0.5]) };
      });
      for (let round = 0; round < 200; round += 1) {
        for (const flight of flights) {
          // What leaves on one side comes back on the other.
          flight.x = (flight.x + flight.dx + 40) % 40;
          flight.y = (flight.y + flight.dy + 40) % 40;
          const { x, y, leaf } = flight;
          tree.move(leaf, [x, y, x + 0.5, y + 0.5]);
        }
      }
      worn += checkBelow(tree, tree.root).perimeter;
      fresh += halved(flights.map(({ leaf }) => [...tree.boxOf(leaf)]));
    }
    console.log(
      `perimeters of trees after ${200 * COUNT} moves in flights, beside new ones: × ${(worn / fresh).toFixed(3)}`,
    );
    expect(worn / fresh).toBeLessThan(1.15);
  });
});

describe('box tree broadphase', () => {
  it('is as fast where things were put elsewhere as where they were put at once', () => {
    const random = generator(7);
    const places = Array.from({ length: 2000 }, (): Vec2 => [200 * random(), 200 * random()]);
    const made = new BoxTreeBroadphase<number>();
    const moved = new BoxTreeBroadphase<number>();
    const handles = places.map((_, i) => moved.insert(i, around(places.at(-1 - i)!, 0.2), false));
    for (const [i, place] of places.entries()) {
      made.insert(i, around(place, 0.2), false);
      moved.update(handles[i]!, around(place, 0.2));
    }
    /** ms. At best, to look at all places. */
    const timeOf = (broadphase: BoxTreeBroadphase<number>): number =>
      bestTime(() => {
        let found = 0;
        for (const place of places) {
          broadphase.sample(around(place, 1), () => {
            found += 1;
          });
        }
        expect(found).toBeGreaterThan(2000);
      });
    timeOf(made);
    timeOf(moved);
    expect(timeOf(moved) / timeOf(made)).toBeLessThan(3);
  });
});

describe('packed tree, asked by rays', () => {
  it('misses no corner that they touch', () => {
    const random = generator(3);
    const integer = (most: number): number => Math.ceil(most * random());
    let met = 0;
    for (let i = 0; i < 20_000; i += 1) {
      const [dx, dy, factor] = [integer(999), integer(999), integer(99_999)];
      const [ox, oy] = [integer(1e6), integer(1e6)];
      // Integers, so exactly on the ray: it comes to the box where it goes by.
      const [x, y] = [ox + dx * factor, oy + dy * factor];
      const box: Rect = i % 2 === 0 ? [x, y - 9, x + 9, y] : [x - 9, y, x, y + 9];
      const tree = new PackedTree<number>(0);
      tree.insert(0, box);
      tree.insert(1, [-9, -9, -8, -8]);
      tree.cast([ox, oy, ox, oy], [dx, dy], factor, (item) => {
        met += item === 0 ? 1 : 0;
        return factor;
      });
    }
    expect(met).toBe(20_000);
  });

  it('begin where boxes end, along an axis and without end', () => {
    const box: Rect = [0, 0, 1, 1];
    for (const x of [-0.5, -5e-324, -0, 0, 0.5, 1, 1 + Number.EPSILON, 1.5]) {
      for (const zero of [0, -0]) {
        for (const way of [1, -1]) {
          const tree = new PackedTree<number>(0);
          tree.insert(0, box);
          tree.insert(1, [50, 50, 51, 51]);
          const met = { x: 0, y: 0 };
          tree.cast([x, -7 * way, x, -7 * way], [zero, way], Infinity, () => {
            met.x += 1;
            return Infinity;
          });
          tree.cast([-7 * way, x, -7 * way, x], [way, zero], Infinity, () => {
            met.y += 1;
            return Infinity;
          });
          const meets = x >= 0 && x <= 1 ? 1 : 0;
          expect(met).toEqual({ x: meets, y: meets });
        }
      }
    }
  });
});

describe('overlap of a model', () => {
  it('is inclusive', () => {
    expect(overlap([0, 0, 1, 1], [1, 1, 2, 2])).toBe(true);
    expect(overlap([0, 0, 1, 1], [1.1, 1, 2, 2])).toBe(false);
  });
});

it('pairs are told once, also after 2³¹ of them were looked for', () => {
  const broadphase = new BoxTreeBroadphase<string>();
  const [one, other] = [0, 0.5].map((x) => broadphase.insert(`at ${x}`, [x, 0, x + 1, 1], false));
  (broadphase as unknown as { search: number }).search = 2 ** 31 - 3;
  for (let i = 1; i <= 8; i += 1) {
    broadphase.update(one!, [i, 0, i + 1, 1]);
    broadphase.update(other!, [i + 0.5, 0, i + 1.5, 1]);
    let count = 0;
    broadphase.perform(() => {
      count += 1;
    });
    expect(count).toBe(1);
  }
});
