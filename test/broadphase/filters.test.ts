import { describe, expect, it } from 'vitest';
import { type BroadphaseHandle, phys2D, type Rect, type Shape } from '../../src/index.js';
import { generator } from '../scenes/mixed.js';
import { BROADPHASES, overlap, pairsOf } from './model.js';

interface Filter {
  group: number;
  mask: number;
}

const letsMeet = (a: Filter, b: Filter): boolean => (a.group & b.mask) !== 0 && (b.group & a.mask) !== 0;

describe.each(BROADPHASES)('filters: %s', (_, create) => {
  it('leave out no pair that they let meet, also after they changed', () => {
    const random = generator(3);
    const bits = (): number => Math.floor(8 * random());
    const box = (): Rect => {
      const [x, y] = [10 * random(), 10 * random()];
      return [x, y, x + 2 * random(), y + 2 * random()];
    };
    const broadphase = create();
    const things: { bounds: Rect; filter: Filter; handle: BroadphaseHandle }[] = [];
    for (let i = 0; i < 80; i += 1) {
      const [bounds, filter] = [box(), { group: bits(), mask: bits() }];
      things.push({ bounds, filter, handle: broadphase.insert(i, bounds, false, undefined, filter) });
    }
    let met = 0;
    for (let round = 0; round < 60; round += 1) {
      const reported = pairsOf(broadphase);
      for (const [i, a] of things.entries()) {
        for (const [j, b] of things.slice(0, i).entries()) {
          const pair = `${j}-${i}`;
          if (!overlap(a.bounds, b.bounds)) {
            expect(reported).not.toContain(pair);
          } else if (letsMeet(a.filter, b.filter)) {
            expect(reported).toContain(pair);
            met += 1;
          }
        }
      }
      for (const thing of things.slice(0, 5)) {
        thing.bounds = box();
        broadphase.update(thing.handle, thing.bounds);
      }
      for (const thing of things.slice(5, 20)) {
        thing.filter.group = bits();
        thing.filter.mask = bits();
        broadphase.refilter?.(thing.handle);
      }
    }
    expect(met).toBeGreaterThan(1000);
  });
});

describe('the box tree', () => {
  it('makes no pairs of what filters keep apart', () => {
    const tree = phys2D.createBoxTreeBroadphase();
    const apart = { group: 2, mask: 1 };
    const [one, other] = [0, 1].map((i) => tree.insert(i, [0, 0, 1, 1], false, undefined, apart));
    tree.insert(2, [0, 0, 1, 1], true, undefined, { group: 1, mask: 2 });
    expect(pairsOf(tree)).toEqual(['0-2', '1-2']);
    apart.mask = 3;
    expect(pairsOf(tree)).toEqual(['0-2', '1-2']);
    tree.refilter!(one!);
    expect(pairsOf(tree)).toEqual(['0-1', '0-2', '1-2']);
    tree.remove(other!);
    expect(() => tree.refilter!(other!)).toThrow(TypeError);
    expect(() => tree.insert(3, [0, 0, 1, 1], false, undefined, { group: 1 } as never)).toThrow(
      new TypeError(
        'BoxTreeBroadphase.insert: filter must be an object with the numbers group and mask, got an object',
      ),
    );
  });

  it('finds what comes later for what had nothing to meet', () => {
    const tree = phys2D.createBoxTreeBroadphase();
    for (let round = 0; round < 2; round += 1) {
      const [link, other] = [0, 1].map(() => ({ group: 2, mask: 1 }));
      const handles = [link, other].map((filter, i) => tree.insert(i, [0, 0, 1, 1], false, undefined, filter));
      expect(pairsOf(tree)).toEqual([]);
      tree.insert(2, [0, 0, 1, 1], true, undefined, { group: 1, mask: 2 });
      expect(pairsOf(tree)).toEqual(['0-2', '1-2']);
      tree.insert(3, [0, 0, 1, 1], false, undefined, { group: 4, mask: 8 });
      expect(pairsOf(tree)).toEqual(['0-2', '1-2']);
      other!.group |= 8;
      other!.mask |= 4;
      tree.refilter!(handles[1]!);
      expect(pairsOf(tree)).toEqual(['0-2', '1-2', '1-3']);
      tree.clear();
    }
  });
});

describe('a world', () => {
  it.each([
    ['setMask', 0xffffffff],
    ['setGroup', 1],
  ] as const)('lets what overlaps already meet after %s', (set, bits) => {
    const world = phys2D.createWorld({ gravity: [0, 0] });
    const shapes = [0, 0.5].map((x) => {
      const shape = phys2D.createCircleShape({ radius: 1, ...(set === 'setMask' ? { mask: 0 } : { group: 0 }) });
      world.addRigidBody(phys2D.createRigidBody({ position: [x, 0], shapes: [shape] }));
      return shape;
    });
    for (let i = 0; i < 5; i += 1) world.step(1 / 60);
    expect(world.dynamicArbiters).toEqual([]);
    for (const shape of shapes) shape[set](bits);
    world.step(1 / 60);
    expect(world.dynamicArbiters).toHaveLength(1);
  });

  it('lets it meet after a restore to when it could', () => {
    const world = phys2D.createWorld({ gravity: [0, 0] });
    const [one] = [0, 0.5].map((x) => {
      const shape = phys2D.createCircleShape({ radius: 1 });
      world.addRigidBody(phys2D.createRigidBody({ position: [x, 0], shapes: [shape] }));
      return shape;
    });
    const snapshot = world.snapshot();
    one!.setMask(0);
    for (let i = 0; i < 5; i += 1) world.step(1 / 60);
    expect(world.dynamicArbiters).toEqual([]);
    world.restore(snapshot);
    world.step(1 / 60);
    expect(world.dynamicArbiters).toHaveLength(1);
  });
});

it('a broadphase is told of a filter that has changed, not of one that is about to', () => {
  const broadphase = phys2D.createBoxTreeBroadphase();
  const told: number[][] = [];
  broadphase.refilter = ({ data }) => told.push([(data as Shape).getGroup(), (data as Shape).getMask()]);
  const shape = phys2D.createCircleShape({ radius: 1 });
  phys2D.createWorld({ broadphase }).addRigidBody(phys2D.createRigidBody({ shapes: [shape] }));
  shape.setGroup(4);
  shape.setMask(8);
  expect(told).toEqual([
    [4, 0xffffffff],
    [4, 8],
  ]);
});
