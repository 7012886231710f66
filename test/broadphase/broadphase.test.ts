import { describe, expect, it } from 'vitest';
import type { Rect } from '../../src/index.js';
import { generator } from '../scenes/mixed.js';
import { BROADPHASES, Model, pairsOf, sampleOf } from './model.js';

describe.each(BROADPHASES)('%s', (name, create) => {
  it('agrees with a plain list through thousands of random changes', () => {
    for (let seed = 1; seed <= 8; seed += 1) {
      const random = generator(seed);
      const model = new Model(create());
      const groups = [undefined, {}, {}];
      const box = (): Rect => {
        const [x, y] = [20 * random(), 20 * random()];
        const size = random() < 0.05 ? 15 : 2;
        return [x, y, x + size * random(), y + size * random()];
      };
      for (let i = 0; i < 500; i += 1) {
        const ids = [...model.entries.keys()];
        const id = ids[Math.floor(random() * ids.length)];
        const choice = random();
        if (id === undefined || (choice < 0.3 && ids.length < 60)) {
          model.insert(box(), random() < 0.4, groups[Math.floor(3 * random())]);
        } else if (choice < 0.6) {
          const [x0, y0, x1, y1] = model.entries.get(id)!.bounds;
          const [dx, dy] = [random() - 0.5, 0.2 * (random() - 0.5)];
          model.update(id, [x0 + dx, y0 + dy, x1 + dx, y1 + dy]);
        } else if (choice < 0.75) {
          model.update(id, box(), random() < 0.5);
        } else if (choice < 0.85) {
          model.remove(id);
        }
        if (i % 5 === 0) {
          expect(pairsOf(model.broadphase)).toEqual(model.expectedPairs());
        }
        const probe = box();
        expect(sampleOf(model.broadphase, probe)).toEqual(model.expectedSample(probe));
      }
    }
  });

  it('agrees with a plain list also where whole parts of it are of one group', () => {
    for (let seed = 1; seed <= 8; seed += 1) {
      const random = generator(100 + seed);
      const model = new Model(create());
      const bodies: number[][] = [];
      const insertBody = () => {
        const [x, y] = [12 * random(), 12 * random()];
        const group = {};
        bodies.push(
          Array.from({ length: 12 }, (_, i) => {
            const [left, top] = [x + (i % 4), y + Math.floor(i / 4)];
            return model.insert([left, top, left + 1, top + 1], random() < 0.1, group);
          }),
        );
      };
      for (let i = 0; i < 150; i += 1) {
        const at = Math.floor(random() * bodies.length);
        const choice = random();
        if (bodies.length < 4 || choice < 0.1) {
          insertBody();
        } else if (choice < 0.2 || bodies.length > 8) {
          for (const id of bodies.splice(at, 1)[0]!) model.remove(id);
        } else if (choice < 0.4) {
          model.remove(bodies[at]!.splice(Math.floor(random() * bodies[at]!.length), 1)[0] ?? -1);
          if (bodies[at]!.length === 0) bodies.splice(at, 1);
        } else {
          const [dx, dy] = [3 * (random() - 0.5), 3 * (random() - 0.5)];
          for (const id of bodies[at]!) {
            const [x0, y0, x1, y1] = model.entries.get(id)!.bounds;
            model.update(id, [x0 + dx, y0 + dy, x1 + dx, y1 + dy]);
          }
        }
        expect(pairsOf(model.broadphase)).toEqual(model.expectedPairs());
      }
    }
  });

  it('takes infinite bounds', () => {
    const model = new Model(create());
    model.insert([-Infinity, 3, Infinity, 4], true);
    model.insert([-Infinity, -Infinity, Infinity, Infinity], false);
    model.insert([0, 0, 1, 3.5], false);
    model.insert([5, 5, 6, 6], false);
    expect(pairsOf(model.broadphase)).toEqual(model.expectedPairs());
    for (const probe of [
      [100, 3.5, 101, 3.6],
      [0, 0, 0, 0],
      [-Infinity, -Infinity, Infinity, Infinity],
    ] as Rect[]) {
      expect(sampleOf(model.broadphase, probe)).toEqual(model.expectedSample(probe));
    }
  });

  it('can be queried from inside its callbacks', () => {
    const model = new Model(create());
    for (let i = 0; i < 10; i += 1) {
      model.insert([i, 0, i + 1, 1], false);
    }
    const outer: number[] = [];
    model.broadphase.perform((a) => {
      outer.push(Number(a.data));
      model.broadphase.sample([0, 0, 20, 1], (handle) => {
        if (handle.data === 0) {
          expect(sampleOf(model.broadphase, [3.5, 0, 3.6, 1])).toEqual([3]);
        }
      });
    });
    expect(outer).toHaveLength(9);
  });

  it('hands thisObject to callbacks, and the bounds of a sample', () => {
    const model = new Model(create());
    model.insert([0, 0, 1, 1], false);
    model.insert([1, 1, 2, 2], false);
    const self = {};
    const seen: unknown[] = [];
    const bounds: Rect = [0, 0, 0.5, 0.5];
    model.broadphase.perform(function (this: unknown) {
      seen.push(this);
    }, self);
    model.broadphase.sample(
      bounds,
      function (this: unknown, _handle, given) {
        seen.push(this, given);
      },
      self,
    );
    expect(seen).toEqual([self, self, bounds]);
  });

  it('does without pairs that are known', () => {
    const model = new Model(create());
    model.insert([0, 0, 1, 1], false);
    const moving = model.insert([1, 1, 2, 2], false);
    const told: string[] = [];
    const perform = (answer: boolean): string[] => {
      told.length = 0;
      model.broadphase.perform(
        () => {
          told.push('reported');
          return 7;
        },
        null,
        (note) => {
          told.push(`asked ${note}`);
          return answer;
        },
      );
      return told;
    };
    const keepsNotes = name === 'box tree';
    expect(perform(true)).toEqual(['reported']);
    expect(perform(true)).toEqual(keepsNotes ? ['asked 7'] : ['reported']);
    expect(perform(false)).toEqual(keepsNotes ? ['asked 7', 'reported'] : ['reported']);
    // Apart for one call: what is kept is forgotten. The leaves still overlap.
    model.update(moving, [1.05, 1, 2.05, 2]);
    expect(perform(true)).toEqual([]);
    model.update(moving, [1, 1, 2, 2]);
    expect(perform(true)).toEqual(['reported']);
  });

  it('may leave out what is of the group of a handle, and nothing else', () => {
    const broadphase = create();
    const group = {};
    const [first] = Array.from({ length: 9 }, (_, i) => broadphase.insert(i, [i, 0, i + 2, 1], i % 2 === 0, group));
    broadphase.insert(9, [0, 0, 9, 9], false);
    broadphase.insert(10, [0, 0, 9, 9], true);
    const found: unknown[] = [];
    broadphase.sample([0, 0, 20, 1], ({ data }) => found.push(data), undefined, first);
    expect(found).toEqual(expect.arrayContaining([9, 10]));
    if (name === 'box tree') expect(found).toHaveLength(2);
  });

  it('refuses bad bounds and foreign handles', () => {
    const broadphase = create();
    expect(() => broadphase.insert(0, [0, NaN, 1, 1], false)).toThrow(/insert: bounds\[1\] must be a number, not NaN/);
    expect(() => broadphase.insert(0, [2, 0, 1, 1], false)).toThrow(/bounds\[2\] must be >= bounds\[0\] = 2, got 1/);
    expect(() => broadphase.insert(0, [0, 0], false)).toThrow(TypeError);
    expect(() => broadphase.sample([0, 0, -1, 0], () => {})).toThrow(RangeError);
    const handle = broadphase.insert(0, [0, 0, 1, 1], false);
    expect(() => broadphase.update(handle, [0, 5, 1, 1])).toThrow(RangeError);
    expect(sampleOf(broadphase, [0, 0, 1, 1])).toEqual([0]);
    expect(() => create().remove(handle)).toThrow(/remove: handle must be one of this broadphase/);
    broadphase.remove(handle);
    expect(() => broadphase.remove(handle)).toThrow(TypeError);
    expect(() => broadphase.update(handle, [0, 0, 1, 1])).toThrow(TypeError);
  });
});
