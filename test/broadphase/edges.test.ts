import { setFlagsFromString } from 'node:v8';
import { runInNewContext } from 'node:vm';
import { describe, expect, it } from 'vitest';
import { BoxTree, type BroadphaseHandle, phys2D, type Rect } from '../../src/index.js';
import { generator } from '../scenes/mixed.js';
import { BROADPHASES, Model, pairsOf, sampleOf } from './model.js';
import type { Item } from './tree-model.js';

// Single cases at the edges of what the classes promise.

const EVERYWHERE: Rect = [-Infinity, -Infinity, Infinity, Infinity];

describe.each(BROADPHASES)('edges: %s', (_, create) => {
  it('what a callback of a sample or a cast takes out is not visited', () => {
    const { broadphase } = new Model(create());
    const visits = (isCast: boolean): number => {
      const handles = Array.from({ length: 8 }, (_, i) => broadphase.insert(i, [i, 0, i + 0.5, 1], i % 2 === 0));
      let count = 0;
      const visit = (): number => {
        count += 1;
        for (const handle of handles.splice(0)) {
          broadphase.remove(handle);
        }
        return Infinity;
      };
      if (isCast) broadphase.cast?.([-1, 0.5, -1, 0.5], [1, 0], Infinity, visit);
      else broadphase.sample(EVERYWHERE, visit);
      return count;
    };
    expect(visits(false)).toBe(1);
    if (broadphase.cast !== undefined) expect(visits(true)).toBe(1);
  });

  it('what a callback of a sample inserts is not sampled', () => {
    const broadphase = create();
    for (let i = 0; i < 5; i += 1) broadphase.insert(i, [0, 0, 1, 1], i % 2 === 0);
    let calls = 0;
    broadphase.sample(EVERYWHERE, () => {
      calls += 1;
      if (calls < 100) broadphase.insert(null, [0, 0, 1, 1], false);
    });
    expect(calls).toBe(5);
  });

  it('takes the same data many times, and any data', () => {
    const broadphase = create();
    const data = {};
    const handles = [0, 1, 2].map(() => broadphase.insert(data, [0, 0, 1, 1], false));
    expect(new Set(handles).size).toBe(3);
    broadphase.remove(handles[1]!);
    const found: unknown[] = [];
    broadphase.sample([1, 1, 1, 1], (handle) => found.push(handle.data));
    expect(found).toEqual([data, data]);
    for (const odd of [undefined, null, NaN, '']) {
      expect(broadphase.insert(odd, [0, 0, 1, 1], false).data).toBe(odd);
    }
  });

  it('copies bounds, of typed arrays too', () => {
    const broadphase = create();
    const bounds = Float32Array.of(0, 0, 1, 1);
    const handle = broadphase.insert(0, bounds, false);
    bounds.fill(50);
    expect(sampleOf(broadphase, [1, 1, 2, 2])).toEqual([0]);
    bounds.set([5, 5, 6, 6]);
    broadphase.update(handle, bounds);
    bounds.fill(50);
    expect(sampleOf(broadphase, [6, 6, 7, 7])).toEqual([0]);
    expect(sampleOf(broadphase, [50, 50, 50, 50])).toEqual([]);
  });

  it('is whole after an error in a callback', () => {
    const broadphase = create();
    for (let i = 0; i < 3; i += 1) {
      broadphase.insert(i, [i, 0, i + 1, 1], false);
    }
    const thrower = () => {
      throw new Error('from a callback');
    };
    for (let i = 0; i < 3; i += 1) {
      expect(() => broadphase.perform(thrower)).toThrow('from a callback');
      expect(() => broadphase.sample(EVERYWHERE, () => broadphase.sample(EVERYWHERE, thrower))).toThrow();
      expect(pairsOf(broadphase)).toEqual(['0-1', '1-2']);
      expect(sampleOf(broadphase, EVERYWHERE)).toEqual([0, 1, 2]);
    }
  });

  it('lives on after clear', () => {
    const broadphase = create();
    const old = [false, true, false].map((isStatic, i) => broadphase.insert(i, [0, 0, 1, 1], isStatic));
    broadphase.clear();
    broadphase.clear();
    for (let i = 3; i < 9; i += 1) {
      broadphase.insert(i, [i, 0, i + 1, 1], i % 2 === 0);
    }
    for (const handle of old) {
      expect(() => broadphase.update(handle, [0, 0, 1, 1])).toThrow(TypeError);
      expect(() => broadphase.remove(handle)).toThrow(TypeError);
    }
    expect(sampleOf(broadphase, EVERYWHERE)).toEqual([3, 4, 5, 6, 7, 8]);
    expect(pairsOf(broadphase)).toEqual(['3-4', '4-5', '5-6', '6-7', '7-8']);
  });

  it('knows what was inserted and removed since the last perform, in any order', () => {
    for (let seed = 1; seed <= 50; seed += 1) {
      const random = generator(seed);
      const model = new Model(create());
      for (let i = 0; i < 60; i += 1) {
        const ids = [...model.entries.keys()];
        if (ids.length < 4 || random() < 0.5) {
          model.insert([i % 5, 0, (i % 5) + 1, 1], i % 3 === 0);
        } else {
          model.remove(ids[Math.floor(random() * ids.length)]!);
        }
      }
      expect(pairsOf(model.broadphase)).toEqual(model.expectedPairs());
    }
  });

  it('hands thisObject to the callback of clear', () => {
    const broadphase = create();
    broadphase.insert(0, [0, 0, 1, 1], false);
    const self = {};
    broadphase.clear(function (this: unknown) {
      expect(this).toBe(self);
    }, self);
    expect.assertions(1);
  });

  it('empties after the callbacks of clear', () => {
    const broadphase = create();
    broadphase.insert(0, [0, 0, 1, 1], false);
    broadphase.insert(1, [0, 0, 1, 1], true);
    const seen: number[][] = [];
    broadphase.clear(() => seen.push(sampleOf(broadphase, EVERYWHERE)));
    expect(seen).toEqual([
      [0, 1],
      [0, 1],
    ]);
  });

  it('is empty after an error in the callback of clear', () => {
    const broadphase = create();
    const handles = [0, 1, 2].map((id) => broadphase.insert(id, [0, 0, 1, 1], false));
    expect(() =>
      broadphase.clear((handle) => {
        if (handle.data === 1) {
          throw new Error('from a callback');
        }
      }),
    ).toThrow('from a callback');
    expect(sampleOf(broadphase, EVERYWHERE)).toEqual([]);
    broadphase.insert(3, [0, 0, 1, 1], false);
    for (const handle of handles) {
      expect(() => broadphase.remove(handle)).toThrow(TypeError);
    }
    expect(sampleOf(broadphase, EVERYWHERE)).toEqual([3]);
  });

  it('ends a clear whose callback inserts', () => {
    const broadphase = create();
    broadphase.insert(0, [0, 0, 1, 1], false);
    broadphase.insert(1, [0, 0, 1, 1], true);
    let calls = 0;
    broadphase.clear(() => {
      calls += 1;
      if (calls < 100) {
        broadphase.insert(2, [0, 0, 1, 1], false);
      }
    });
    expect(calls).toBe(2);
    expect(sampleOf(broadphase, EVERYWHERE)).toEqual([]);
    expect(pairsOf(broadphase)).toEqual([]);
  });

  it('reads the bounds of a sample at once', () => {
    const broadphase = create();
    for (let i = 0; i < 4; i += 1) {
      broadphase.insert(i, [0, 0, 1, 1], i % 2 === 0);
    }
    const scratch = [0, 0, 1, 1];
    const found: unknown[] = [];
    broadphase.sample(scratch, (handle) => {
      found.push(handle.data);
      scratch.fill(50);
    });
    expect(found.sort()).toEqual([0, 1, 2, 3]);
  });

  for (const isStatic of [true, false]) {
    const kind = isStatic ? 'static' : 'moving';

    // With rounding, minX − (maxX − minX) may be above minX.
    it(`finds a ${kind} box that is touched, whatever is lost in rounding`, () => {
      const broadphase = create();
      broadphase.insert(0, [-1e-20, 0, 1, 1], isStatic);
      expect(sampleOf(broadphase, [1, 0, 2, 1])).toEqual([0]);
      broadphase.insert(1, [1, 0, 2, 1], false);
      expect(pairsOf(broadphase)).toEqual(['0-1']);
    });

    // Its width is Infinity − Infinity.
    it(`finds ${kind} boxes beside one whose sides are both at infinity`, () => {
      const broadphase = create();
      broadphase.insert(0, [0, 0, 1, 1], isStatic);
      broadphase.insert(1, [Infinity, 0, Infinity, 1], isStatic);
      expect(sampleOf(broadphase, [0, 0, 1, 1])).toEqual([0]);
      broadphase.insert(2, [0, 0, 1, 1], false);
      expect(pairsOf(broadphase)).toEqual(['0-2']);
    });

    it(`finds ${kind} boxes at infinity`, () => {
      const broadphase = create();
      broadphase.insert(0, [0, 0, Infinity, 1], isStatic);
      expect(sampleOf(broadphase, [Infinity, 0, Infinity, 1])).toEqual([0]);
    });
  }

  it('finds everything in a crowd of thousands, moved at once', () => {
    const broadphase = create();
    const handles: BroadphaseHandle[] = [];
    for (let i = 0; i < 3000; i += 1) {
      handles.push(broadphase.insert(i, [i, 0, i + 1, 1], i % 3 === 0));
    }
    const touching = (i: number) => `${i}-${i + 1}`;
    expect(pairsOf(broadphase)).toEqual(Array.from({ length: 2999 }, (_, i) => touching(i)).sort());
    handles.forEach((handle, i) => {
      broadphase.update(handle, [-2 * i, 0, -2 * i + 1, 1], i % 2 === 0);
    });
    expect(pairsOf(broadphase)).toEqual([]);
    expect(sampleOf(broadphase, EVERYWHERE)).toHaveLength(3000);
    handles.forEach((handle, i) => {
      if (i !== 77 && i !== 88) {
        broadphase.remove(handle);
      }
    });
    broadphase.update(handles[88]!, [-154, 1, -150, 1]);
    expect(pairsOf(broadphase)).toEqual(['77-88']);
  });
});

describe('edges: rays through a box tree broadphase', () => {
  // Of a ray in a side of the box, 0 / 0 or 0 · ∞ tells when it enters or leaves.
  for (const x of [0, 1]) {
    it(`meet a box along its side x = ${x}`, () => {
      const broadphase = phys2D.createBoxTreeBroadphase();
      broadphase.insert(0, [0, 0, 1, 1], true);
      const met: unknown[] = [];
      broadphase.cast!([x, -5, x, -5], [0, 1], 9, (handle) => met.push(handle.data) * 9);
      expect(met).toEqual([0]);
    });
  }

  it('are read at once', () => {
    const broadphase = phys2D.createBoxTreeBroadphase();
    for (let i = 0; i < 4; i += 1) {
      broadphase.insert(i, [i, 0, i + 0.5, 1], i % 2 === 0);
    }
    const [start, direction] = [
      [-1, 0.5, -1, 0.5],
      [1, 0],
    ];
    const met: unknown[] = [];
    broadphase.cast!(start!, direction!, 9, (handle) => {
      met.push(handle.data);
      start!.fill(50);
      direction!.fill(-1);
      return 9;
    });
    expect(met.sort()).toEqual([0, 1, 2, 3]);
  });
});

describe('edges: BoxTree', () => {
  it('may be asked from inside the callback of rayTest, and left by an error', () => {
    const tree = BoxTree.create<Item>(true);
    for (let id = 0; id < 8; id += 1) {
      tree.add({ id }, [id, 0, id + 0.5, 1]);
    }
    tree.finalize();
    const ray = { origin: [-1, 0.5], direction: [1, 0], maxFactor: 100 };
    const outer: number[] = [];
    BoxTree.rayTest([tree], ray, (_tree, item) => {
      outer.push(item.id);
      const inner: number[] = [];
      BoxTree.rayTest([tree], ray, (_again, other) => {
        inner.push(other.id);
        expect(tree.getOverlappingNodes([0, 0, 1, 1], [], 0)).toBe(2);
        return null;
      });
      expect(inner).toEqual([0, 1, 2, 3, 4, 5, 6, 7]);
      return null;
    });
    expect(outer).toEqual([0, 1, 2, 3, 4, 5, 6, 7]);
    const thrower = () => {
      throw new Error('from a callback');
    };
    expect(() => BoxTree.rayTest([tree], ray, thrower)).toThrow('from a callback');
    expect(tree.getOverlappingPairs([])).toBe(0);
  });

  it('reads a ray at once', () => {
    const tree = BoxTree.create<Item>(true);
    tree.add({ id: 0 }, [0, 0, 1, 1]);
    tree.add({ id: 1 }, [2, 0, 3, 1]);
    tree.finalize();
    const ray = { origin: [-1, 0.5], direction: [1, 0], maxFactor: 100 };
    const met: number[] = [];
    BoxTree.rayTest([tree], ray, (_tree, item) => {
      met.push(item.id);
      ray.origin[1] = 50;
      return null;
    });
    expect(met).toEqual([0, 1]);
  });

  // Squares are infinite, or 0.
  it('measures circles of any size', () => {
    const tree = BoxTree.create<Item>(true);
    tree.add({ id: 0 }, [1e200, 0, 1e200, 0]);
    tree.add({ id: 1 }, [1e-180, 0, 1e-180, 0]);
    tree.finalize();
    const found: Item[] = [];
    tree.getCircleOverlappingNodes([0, 0], 1e160, found);
    expect(found.map((item) => item.id)).toEqual([1]);
    tree.getCircleOverlappingNodes([0, 0], 0, found);
    expect(found).toHaveLength(1);
  });
});

describe('edges: what is removed is let go', () => {
  setFlagsFromString('--expose-gc');
  const collect: () => void = runInNewContext('gc');

  /** Whether an object survives, once the function that used it has returned. */
  async function survives(use: (data: object) => void): Promise<boolean> {
    const reference = (() => {
      const data = { payload: new Array(100).fill(0) };
      use(data);
      return new WeakRef(data);
    })();
    for (let i = 0; i < 4 && reference.deref() !== undefined; i += 1) {
      await new Promise((resolve) => setTimeout(resolve, 1));
      collect();
    }
    return reference.deref() !== undefined;
  }

  for (const [name, create] of BROADPHASES) {
    const box: Rect = [0, 0, 1, 1];

    it(`by ${name}, once performed`, async () => {
      const broadphase = create();
      expect(
        await survives((data) => {
          broadphase.remove(broadphase.insert(data, box, false));
          broadphase.perform(() => {});
        }),
      ).toBe(false);
      broadphase.perform(() => {});
    });

    // The list of handles to look at in `perform`.
    it(`by ${name}, without perform`, async () => {
      const broadphase = create();
      expect(await survives((data) => broadphase.remove(broadphase.insert(data, box, false)))).toBe(false);
      broadphase.perform(() => {});
    });

    // Pairs kept for reuse, and the list of the last search, name their handles.
    it(`by ${name}, after pairs`, async () => {
      const broadphase = create();
      expect(
        await survives((data) => {
          const handles = [data, 0, data].map((each) => broadphase.insert(each, box, false));
          broadphase.perform(() => {});
          broadphase.remove(handles[0]!);
          broadphase.remove(handles[2]!);
          broadphase.perform(() => {});
        }),
      ).toBe(false);
      broadphase.perform(() => {});
    });

    // The list of what a sample found.
    it(`by ${name}, after a sample`, async () => {
      const broadphase = create();
      expect(
        await survives((data) => {
          const handle = broadphase.insert(data, box, false);
          broadphase.perform(() => {});
          broadphase.sample(box, () => {});
          broadphase.remove(handle);
        }),
      ).toBe(false);
      broadphase.perform(() => {});
    });
  }

  it('by BoxTree', async () => {
    const tree = BoxTree.create(true);
    expect(
      await survives((data) => {
        tree.add({}, [0, 0, 1, 1]);
        tree.add(data, [0, 0, 1, 1]);
        tree.finalize();
        tree.getNodes();
        tree.getOverlappingPairs([]);
        tree.remove(data);
      }),
    ).toBe(false);
    expect(tree.getEndNodeIndex()).toBe(1);
  });
});
