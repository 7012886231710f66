import { describe, expect, it } from 'vitest';
import { BoxTree, type Rect } from '../../src/index.js';
import { type Bad, NOT_BOOLEAN, NOT_NON_NEGATIVE, NOT_NUMBERS, NOT_VECTOR, refuses } from '../bad-input/refuses.js';
import { BROADPHASES, pairsOf, sampleOf } from './model.js';
import type { Item } from './tree-model.js';

// What the classes refuse, how they say so, and that nothing has changed then.

const NOT_BOUNDS: Bad[] = [
  [5, TypeError, '5'],
  ['box', TypeError, '"box"'],
  [{}, TypeError, 'an object'],
  [[], TypeError, 'an array of length 0'],
  [[0, 0, 1], TypeError, 'an array of length 3'],
];
const MISSING: Bad[] = [
  [null, TypeError, 'null'],
  [undefined, TypeError, 'undefined'],
];
/** Things that can be compared like numbers. */
const ALIKE: [unknown, string][] = [
  [['0', '0', '1', '1'], '"0"'],
  [[null, null, 1, 1], 'null'],
  [[false, false, true, true], 'false'],
  [[0n, 0n, 1n, 1n], '0'],
  [[[0], [0], [1], [1]], 'an array of length 1'],
];
const NOT_FUNCTION: Bad[] = [
  [5, TypeError, '5'],
  ['x', TypeError, '"x"'],
  [{}, TypeError, 'an object'],
];
const REQUIRED_FUNCTION: Bad[] = [...NOT_FUNCTION, ...MISSING];
const NOT_INDEX: Bad[] = [
  ...NOT_NUMBERS,
  [NaN, RangeError],
  [-1, RangeError],
  [1.5, RangeError],
  [Infinity, RangeError],
];
const NOT_ARRAY: Bad[] = [...MISSING, [5, TypeError, '5'], ['x', TypeError, '"x"']];

function refusesBounds(call: (bounds: never) => unknown, where: string, name = 'bounds'): void {
  for (const bad of NOT_BOUNDS) {
    refuses(call, where, name, bad);
  }
  for (let i = 0; i < 4; i += 1) {
    const withNaN = [0, 0, 1, 1].map((value, at) => (at === i ? NaN : value));
    refuses(() => call(withNaN as never), where, `${name}[${i}]`, [NaN, RangeError]);
    const withHole = [0, 0, 1, 1].map((value, at) => (at === i ? undefined : value));
    refuses(() => call(withHole as never), where, `${name}[${i}]`, [undefined, TypeError]);
  }
  refuses(() => call([2, 0, 1, 1] as never), where, `${name}[2]`, [1, RangeError]);
  refuses(() => call([0, 2, 1, 1] as never), where, `${name}[3]`, [1, RangeError]);
  refuses(() => call([Infinity, 0, -Infinity, 1] as never), where, `${name}[2]`, [-Infinity, RangeError]);
}

function refusesMissing(call: (bounds: never) => unknown, where: string, name = 'bounds'): void {
  for (const bad of MISSING) {
    refuses(call, where, name, bad);
  }
}

function refusesAlike(call: (bounds: never) => unknown, where: string, name = 'bounds'): void {
  for (const [bounds, shown] of ALIKE) {
    refuses(() => call(bounds as never), where, `${name}[0]`, [bounds, TypeError, shown]);
  }
  refuses(() => call('0011' as never), where, name, ['0011', TypeError, '"0011"']);
}

describe.each(BROADPHASES)('refusals: %s', (name, create) => {
  const where = name === 'box tree' ? 'BoxTreeBroadphase' : 'SweepAndPrune';
  const [broadphase, box] = [create(), [0, 0, 1, 1] as Rect];
  const handle = broadphase.insert(0, box, false);
  broadphase.insert(1, box, true);
  const same = (): void => {
    expect(sampleOf(broadphase, [-9, -9, 9, 9])).toEqual([0, 1]);
    expect(sampleOf(broadphase, [-9, -9, -1, 9])).toEqual([]);
    expect(pairsOf(broadphase)).toEqual(['0-1']);
    expect(handle.isStatic).toBe(false);
  };

  for (const [method, call] of [
    ['insert', (bounds: never) => broadphase.insert(2, bounds, false)],
    ['update', (bounds: never) => broadphase.update(handle, bounds)],
    ['sample', (bounds: never) => broadphase.sample(bounds, () => {})],
  ] as const) {
    it(`${method}: bounds`, () => {
      refusesBounds(call, `${where}.${method}`);
      same();
    });

    it(`${method}: bounds that are missing`, () => {
      refusesMissing(call, `${where}.${method}`);
    });

    it(`${method}: bounds of what is only compared like numbers`, () => {
      const other = create();
      const own = other.insert(0, box, false);
      const calls = {
        insert: (bounds: never) => other.insert(1, bounds, false),
        update: (bounds: never) => other.update(own, bounds),
        sample: (bounds: never) => other.sample(bounds, () => {}),
      };
      refusesAlike(calls[method], `${where}.${method}`);
    });
  }

  it('insert: isStatic', () => {
    for (const bad of [...NOT_BOOLEAN, [undefined, TypeError]] as Bad[]) {
      refuses((isStatic) => create().insert(2, box, isStatic), `${where}.insert`, 'isStatic', bad);
    }
  });

  it('update: isStatic', () => {
    for (const bad of NOT_BOOLEAN) {
      const other = create();
      const own = other.insert(0, box, false);
      refuses((isStatic) => other.update(own, box, isStatic), `${where}.update`, 'isStatic', bad);
    }
  });

  it('handles of others', () => {
    for (const [, createOther] of BROADPHASES) {
      const stranger = createOther().insert(0, box, false);
      expect(() => broadphase.update(stranger, box)).toThrow(`${where}.update: handle must be `);
      expect(() => broadphase.remove(stranger)).toThrow(`${where}.remove: handle must be `);
    }
    for (const odd of [5, 'x', {}, { ...handle }]) {
      expect(() => broadphase.update(odd as never, box)).toThrow(`${where}.update: handle must be `);
      expect(() => broadphase.remove(odd as never)).toThrow(`${where}.remove: handle must be `);
    }
    same();
  });

  it('handles that are missing', () => {
    for (const odd of [null, undefined]) {
      expect(() => broadphase.remove(odd as never)).toThrow(`${where}.remove: handle must be `);
      expect(() => broadphase.update(odd as never, box)).toThrow(`${where}.update: handle must be `);
    }
  });

  it('perform: callback, also with nothing to report', () => {
    for (const bad of REQUIRED_FUNCTION) {
      refuses((callback) => create().perform(callback), `${where}.perform`, 'callback', bad);
    }
  });

  it('sample: callback, also with nothing to report', () => {
    for (const bad of REQUIRED_FUNCTION) {
      refuses((callback) => create().sample(box, callback), `${where}.sample`, 'callback', bad);
    }
  });

  it('clear: callback, and then nothing is cleared', () => {
    for (const bad of NOT_FUNCTION) {
      const other = create();
      other.insert(0, box, false);
      other.insert(1, box, false);
      refuses((callback) => other.clear(callback), `${where}.clear`, 'callback', bad);
      expect(pairsOf(other)).toEqual(['0-1']);
    }
  });
});

describe('refusals: BoxTree', () => {
  function three(): { tree: BoxTree<Item>; items: Item[] } {
    const tree = BoxTree.create<Item>(true);
    const items = [0, 1, 2].map((id) => ({ id }) as Item);
    for (const item of items) {
      tree.add(item, [item.id, 0, item.id + 1, 1]);
    }
    tree.finalize();
    return { tree, items };
  }
  const { tree, items } = three();
  const same = (of: BoxTree<Item>): void => {
    expect(of.needsFinalize()).toBe(false);
    expect(of.getEndNodeIndex()).toBe(5);
    expect(of.getOverlappingNodes([-9, -9, 9, 9], [])).toBe(3);
    expect(of.getOverlappingPairs([])).toBe(4);
  };

  for (const [method, call, name] of [
    ['add', (of: BoxTree<Item>, _: Item, bounds: never) => of.add({ id: 3 }, bounds), 'extents'],
    ['update', (of: BoxTree<Item>, item: Item, bounds: never) => of.update(item, bounds), 'extents'],
    [
      'getOverlappingNodes',
      (of: BoxTree<Item>, _: Item, bounds: never) => of.getOverlappingNodes(bounds, []),
      'queryExtents',
    ],
  ] as const) {
    it(`${method}: bounds`, () => {
      refusesBounds((bounds) => call(tree, items[1]!, bounds), `BoxTree.${method}`, name);
      refusesMissing((bounds) => call(tree, items[1]!, bounds), `BoxTree.${method}`, name);
      same(tree);
    });

    it(`${method}: bounds of what is only compared like numbers`, () => {
      const fresh = three();
      refusesAlike((bounds) => call(fresh.tree, fresh.items[1]!, bounds), `BoxTree.${method}`, name);
      same(fresh.tree);
    });
  }

  it('update: leaves the tree whole when it cannot read the bounds', () => {
    const fresh = three();
    expect(() => fresh.tree.update(fresh.items[1]!, [0n, 0n, 1n, 1n] as never)).toThrow(TypeError);
    same(fresh.tree);
  });

  it('add: leaves the tree whole when it cannot write the index', () => {
    const fresh = three();
    expect(() => fresh.tree.add(Object.freeze({ id: 3 }), [0, 0, 1, 1])).toThrow(
      'BoxTree.add: externalNode must be an object with a boxTreeIndex that can be written, got an object',
    );
    same(fresh.tree);
  });

  it('remove: leaves the tree whole when it cannot write the index', () => {
    const fresh = three();
    Object.freeze(fresh.items[1]);
    expect(() => fresh.tree.remove(fresh.items[1]!)).toThrow('BoxTree.remove: externalNode must be an object with');
    same(fresh.tree);
    fresh.tree.clear();
    expect(fresh.tree.getEndNodeIndex()).toBe(0);
    expect(fresh.items.map(({ boxTreeIndex }) => typeof boxTreeIndex)).toEqual(['undefined', 'number', 'undefined']);
  });

  it('objects that are none, or in no tree, or in another', () => {
    for (const odd of [5, 'x', null, undefined] as never[]) {
      expect(() => tree.add(odd, [0, 0, 1, 1])).toThrow('BoxTree.add: externalNode must be an object');
      expect(() => tree.update(odd, [0, 0, 1, 1])).toThrow('BoxTree.update: externalNode must be an object');
      expect(() => tree.remove(odd)).toThrow('BoxTree.remove: externalNode must be an object');
    }
    for (const boxTreeIndex of [0, -1, 0.5, NaN, 99, 'length']) {
      const stranger = { id: 9, boxTreeIndex } as Item;
      expect(() => tree.add(stranger, [0, 0, 1, 1])).toThrow('must be an object that is in no tree');
      expect(() => tree.update(stranger, [0, 0, 1, 1])).toThrow('must be an object of this tree');
      expect(() => tree.remove(stranger)).toThrow('must be an object of this tree');
    }
    same(tree);
  });

  it('create: highQuality', () => {
    for (const bad of [...NOT_BOOLEAN, [undefined, TypeError]] as Bad[]) {
      refuses((value) => BoxTree.create(value), 'BoxTree.create', 'highQuality', bad);
    }
  });

  it('getCircleOverlappingNodes: center and radius', () => {
    const where = 'BoxTree.getCircleOverlappingNodes';
    for (const bad of [...NOT_VECTOR, [undefined, TypeError]] as Bad[]) {
      refuses((center) => tree.getCircleOverlappingNodes(center, 1, []), where, 'center', bad);
    }
    for (const bad of [...NOT_NON_NEGATIVE, [undefined, TypeError]] as Bad[]) {
      refuses((radius) => tree.getCircleOverlappingNodes([0, 0], radius, []), where, 'radius', bad);
    }
  });

  const box: Rect = [0, 0, 1, 1];
  for (const [method, argument, call] of [
    ['getOverlappingNodes', 'overlappingNodes', (out: never, i?: never) => tree.getOverlappingNodes(box, out, i)],
    ['getOverlappingPairs', 'overlappingPairs', (out: never, i?: never) => tree.getOverlappingPairs(out, i)],
    ['getVisibleNodes', 'visibleNodes', (out: never, i?: never) => tree.getVisibleNodes([], out, i)],
    ['getCircleOverlappingNodes', 'overlappingNodes', (out: never) => tree.getCircleOverlappingNodes([0, 0], 9, out)],
  ] as const) {
    it(`${method}: ${argument}`, () => {
      for (const bad of NOT_ARRAY) {
        refuses((out) => call(out), `BoxTree.${method}`, argument, bad);
      }
    });

    if (method !== 'getCircleOverlappingNodes') {
      it(`${method}: startIndex`, () => {
        for (const bad of NOT_INDEX) {
          refuses((start) => call([] as never, start), `BoxTree.${method}`, 'startIndex', bad);
        }
      });
    }
  }

  it('getVisibleNodes: what is in planes', () => {
    const where = 'BoxTree.getVisibleNodes';
    refuses((x) => tree.getVisibleNodes([[1, 0, 0], x], []), where, 'planes[1]', [
      [1, 0],
      TypeError,
      'an array of length 2',
    ]);
    for (const i of [0, 1, 2]) {
      const plane = [1, 1, 1].map((value, at) => (at === i ? NaN : value));
      refuses(() => tree.getVisibleNodes([plane], []), where, `planes[0][${i}]`, [NaN, RangeError]);
    }
  });

  it('getVisibleNodes: planes', () => {
    for (const bad of [...MISSING, [5, TypeError], [{}, TypeError, 'an object']] as Bad[]) {
      refuses((planes) => tree.getVisibleNodes(planes, []), 'BoxTree.getVisibleNodes', 'planes', bad);
    }
  });

  const ray = { origin: [-1, 0.5], direction: [1, 0], maxFactor: 9 };
  const cast = (value: unknown) => BoxTree.rayTest([tree], value as never, () => null);

  it('rayTest: origin and direction', () => {
    for (const name of ['origin', 'direction']) {
      for (const bad of [...NOT_VECTOR, [undefined, TypeError]] as Bad[]) {
        refuses((value) => cast({ ...ray, [name]: value }), 'BoxTree.rayTest', `ray.${name}`, bad);
      }
      refuses((value) => cast({ ...ray, [name]: [0, value] }), 'BoxTree.rayTest', `ray.${name}[1]`, [NaN, RangeError]);
    }
  });

  it('rayTest: maxFactor', () => {
    for (const bad of [...NOT_NUMBERS, [undefined, TypeError], [NaN, RangeError], [-1, RangeError]] as Bad[]) {
      refuses((maxFactor) => cast({ ...ray, maxFactor }), 'BoxTree.rayTest', 'ray.maxFactor', bad);
    }
  });

  it('rayTest: a direction of no length', () => {
    expect(() => cast({ ...ray, direction: [0, 0] })).toThrow('BoxTree.rayTest: ray.direction must be ');
  });

  it('rayTest: a ray that is none', () => {
    for (const bad of [...MISSING, [5, TypeError]] as Bad[]) {
      refuses(cast, 'BoxTree.rayTest', 'ray', bad);
    }
  });

  it('rayTest: callback, also with nothing to meet', () => {
    for (const bad of REQUIRED_FUNCTION) {
      refuses((callback) => BoxTree.rayTest([], ray, callback), 'BoxTree.rayTest', 'callback', bad);
    }
  });

  it('rayTest: trees', () => {
    for (const bad of [...MISSING, [5, TypeError], [{}, TypeError, 'an object']] as Bad[]) {
      refuses((trees) => BoxTree.rayTest(trees, ray, () => null), 'BoxTree.rayTest', 'trees', bad);
    }
    expect(() => BoxTree.rayTest([{}] as never, ray, () => null)).toThrow('BoxTree.rayTest: trees[0] must be ');
  });
});
