import { describe, expect, it } from 'vitest';
import { type Broadphase, type BroadphaseHandle, phys2D, type Ray, type Rect } from '../../src/index.js';
import { BROADPHASES, Model, Notes, overlap, pairsOf, sampleOf } from './model.js';
import { meeting, RandomBoxes } from './random-boxes.js';
import { checkRay, type Item, TreeModel } from './tree-model.js';

// Random programs on the classes alone, beside plain lists. After every operation something is asked, now and then everything.

const PROGRAMS = 10;
const LENGTH = 600;
/** Things at a time, about. */
const CROWD = 30;

/** Runs one program; an error says which operation of which program it was. */
function run(seed: number, operation: (i: number) => void): void {
  for (let i = 0; i < LENGTH; i += 1) {
    try {
      operation(i);
    } catch (error) {
      throw new Error(`program ${seed}, operation ${i}: ${(error as Error).message}`, { cause: error });
    }
  }
}

function changeBroadphase(model: Model, random: RandomBoxes): void {
  const ids = [...model.entries.keys()];
  const choice = random.below(100);
  if (ids.length === 0 || choice < (ids.length < CROWD ? 40 : 10)) {
    model.insert(random.box(), random.chance(0.4));
  } else if (choice < 70) {
    const id = random.pick(ids);
    const isStatic = random.pick([undefined, undefined, true, false]);
    model.update(id, random.after(model.entries.get(id)!.bounds), isStatic);
  } else if (choice < 99) {
    model.remove(random.pick(ids));
  } else {
    const cleared: number[] = [];
    model.broadphase.clear((handle) => cleared.push(Number(handle.data)));
    expect(cleared.sort((a, b) => a - b)).toEqual(ids);
    model.entries.clear();
  }
}

function expectedStatic(model: Model, bounds: Rect): number[] {
  return [...model.entries].filter(([, e]) => e.isStatic && overlap(e.bounds, bounds)).map(([id]) => id);
}

function staticOf(broadphase: Broadphase, bounds: Rect): number[] {
  const found: number[] = [];
  broadphase.sampleStatic!(bounds, (handle) => found.push(Number(handle.data)));
  return found.sort((a, b) => a - b);
}

/** Every handle on the ray, or on the way of a box that begins there, is visited, none twice, up to where the visits end it. */
function checkCast(model: Model, ray: Ray, ends: boolean, [width, height]: readonly [number, number] = [0, 0]): void {
  const met = new Set<BroadphaseHandle>();
  let limit = ray.maxFactor;
  const [x, y] = [ray.origin[0]!, ray.origin[1]!];
  const meets = ([minX, minY, maxX, maxY]: Rect): number => meeting([minX - width, minY - height, maxX, maxY], ray);
  model.broadphase.cast!([x, y, x + width, y + height], ray.direction, limit, (handle) => {
    expect(met.has(handle)).toBe(false);
    met.add(handle);
    const at = meets(model.entries.get(Number(handle.data))!.bounds);
    limit = ends ? Math.min(limit, at) : limit;
    return limit;
  });
  for (const { handle, bounds } of model.entries.values()) {
    const at = meets(bounds);
    expect(at < limit || (at === limit && at < Infinity && !ends) ? met.has(handle) : true).toBe(true);
  }
}

/** Asks everything, then all of it from inside callbacks. */
function checkBroadphase(model: Model, random: RandomBoxes, ray: Ray): void {
  const { broadphase } = model;
  const [probe, other] = [random.box(), random.box()];
  const [pairs, found, still] = [model.expectedPairs(), model.expectedSample(probe), expectedStatic(model, probe)];
  const foundInOther = model.expectedSample(other);
  const all = (): void => {
    expect(pairsOf(broadphase)).toEqual(pairs);
    expect(sampleOf(broadphase, other)).toEqual(foundInOther);
    expect(sampleOf(broadphase, probe)).toEqual(found);
    if (broadphase.sampleStatic !== undefined) {
      expect(staticOf(broadphase, probe)).toEqual(still);
    }
    if (broadphase.cast !== undefined) {
      checkCast(model, ray, true);
      checkCast(model, ray, false);
    }
  };
  all();
  /** Calls `all` in some of the callbacks, one level deeper in some of those. */
  const inside = (ask: (callback: () => void) => void, depth: number): void => {
    ask(() => {
      if (random.chance(0.03)) {
        all();
        if (depth > 0) {
          inside(ask, depth - 1);
        }
      }
    });
  };
  const inPerform: string[] = [];
  broadphase.perform((a, b) => {
    inPerform.push([Number(a.data), Number(b.data)].sort((x, y) => x - y).join('-'));
    inside((callback) => broadphase.sample(probe, callback), 1);
  });
  expect(inPerform.sort()).toEqual(pairs);
  const inSample: number[] = [];
  broadphase.sample(probe, (handle) => {
    inSample.push(Number(handle.data));
    if (random.chance(0.3)) {
      all();
    }
    inside((callback) => broadphase.perform(callback), 0);
  });
  expect(inSample.sort((a, b) => a - b)).toEqual(found);
}

function playBroadphase(create: () => Broadphase, extreme: boolean): void {
  for (let seed = 1; seed <= PROGRAMS; seed += 1) {
    const random = new RandomBoxes(seed, extreme);
    const model = new Model(create());
    const notes = new Notes();
    run(seed, (i) => {
      changeBroadphase(model, random);
      expect(notes.pairsOf(model.broadphase, () => random.chance(0.8))).toEqual(model.expectedPairs());
      const probe = random.box();
      expect(sampleOf(model.broadphase, probe)).toEqual(model.expectedSample(probe));
      if (i % 3 === 0) {
        expect(pairsOf(model.broadphase)).toEqual(model.expectedPairs());
      }
      for (const { handle, isStatic } of model.entries.values()) {
        expect(handle.isStatic).toBe(isStatic);
      }
      if (i % 40 === 0) {
        checkBroadphase(model, random, random.ray());
      }
    });
  }
}

/** Rays and boxes along an axis, of which sides often lie in the side of a box, and some across. */
function playParallelCasts(create: () => Broadphase): void {
  for (let seed = 1; seed <= PROGRAMS; seed += 1) {
    const random = new RandomBoxes(seed, false);
    const model = new Model(create());
    run(seed, () => {
      changeBroadphase(model, random);
      const [x, y] = [random.below(80) / 4, random.below(80) / 4];
      const direction = random.pick([
        [1, 0],
        [-2, 0],
        [-0, 1],
        [0, -0.5],
        [0.25, 1],
        [-2, 0.5],
      ]);
      const size = random.chance(0.5) ? ([0, 0] as const) : ([random.below(20) / 4, random.below(20) / 4] as const);
      const ray = { origin: [x, y], direction, maxFactor: random.pick([4, 16, Infinity]) };
      checkCast(model, ray, random.chance(0.5), size);
    });
  }
}

/** Two trees and the objects in them or in neither. */
class TreeProgram {
  readonly models = [new TreeModel(true), new TreeModel(false)] as const;
  private readonly free: Item[] = Array.from({ length: 2 * CROWD }, (_, id) => ({ id }));

  constructor(private readonly random: RandomBoxes) {}

  change(): void {
    const { random, free } = this;
    const model = random.pick(this.models);
    const members = [...model.boxes.keys()];
    const choice = random.below(100);
    if (free.length > 0 && (members.length === 0 || choice < (members.length < CROWD ? 40 : 10))) {
      const item = free.splice(random.below(free.length), 1)[0]!;
      if (random.chance(0.5)) {
        model.add(item, random.box());
      } else {
        model.update(item, random.box());
      }
    } else if (members.length > 0 && choice < 70) {
      const item = random.pick(members);
      model.update(item, random.after(model.boxes.get(item)!));
    } else if (members.length > 0 && choice < 97) {
      const item = random.pick(members);
      model.remove(item);
      free.push(item);
    } else if (choice < 98) {
      free.push(...members);
      model.clear();
    } else {
      this.refused(model);
    }
  }

  /** Changes that are errors or nothing leave everything as it is. */
  private refused(model: TreeModel): void {
    const { random, models } = this;
    model.finalize();
    if (this.free.length > 0) {
      model.remove(random.pick(this.free));
    }
    const strangers = [...models[models[0] === model ? 1 : 0].boxes.keys()];
    if (strangers.length > 0) {
      const item = random.pick(strangers);
      expect(() => model.add(item, [0, 0, 1, 1])).toThrow(TypeError);
      expect(() => model.tree.update(item, [0, 0, 1, 1])).toThrow(TypeError);
      expect(() => model.tree.remove(item)).toThrow(TypeError);
    }
    const members = [...model.boxes.keys()];
    if (members.length > 0) {
      const item = random.pick(members);
      expect(() => model.tree.add(item, [0, 0, 1, 1])).toThrow(TypeError);
      expect(() => model.tree.update(item, [0, 0, -1, 1])).toThrow(RangeError);
      expect(() => model.tree.update(item, [0, 0, 1, NaN])).toThrow(RangeError);
    }
    expect(model.tree.needsFinalize()).toBe(false);
  }

  /** Asks everything; a ray asks everything again from inside some of its callbacks, down to `depth`. */
  check(depth: number): void {
    const { random } = this;
    const before = [...this.models[0].boxes.keys()].slice(0, random.below(6));
    for (const model of this.models) {
      const start = (): number | undefined => random.pick([undefined, 0, random.below(before.length + 1)]);
      model.checkOverlaps(random.box(), before, start());
      model.checkPairs(before, start());
      model.checkCircle(random.below(80) / 4, random.below(80) / 4, random.radius(), before);
      const planes = Array.from({ length: random.below(4) }, (): [number, number, number] => {
        const { direction } = random.ray();
        return [direction[0]!, direction[1]!, random.below(80) / 4 - 10];
      });
      model.checkVisible(planes, before, start());
      model.checkNodes();
    }
    const [a, b] = this.models;
    const modulus = random.pick([1, 2, 3, 1000]);
    checkRay(
      random.pick([[], [a], [b], [a, b], [b, a]]),
      random.ray(),
      ({ id }) => (id % modulus === modulus - 1 ? (id % 4) / 4 : random.pick([null, undefined])),
      () => {
        if (depth > 0 && random.chance(0.2)) {
          this.check(depth - 1);
        }
      },
    );
  }
}

function playTrees(extreme: boolean): void {
  for (let seed = 1; seed <= PROGRAMS; seed += 1) {
    const random = new RandomBoxes(seed, extreme);
    const program = new TreeProgram(random);
    run(seed, (i) => {
      program.change();
      if (random.chance(0.2) || i % 40 === 39) {
        for (const model of program.models) {
          model.finalize();
        }
        program.check(2);
      }
    });
  }
}

describe.each(BROADPHASES)('random programs: %s', (_, create) => {
  it('agrees with a list', () => {
    playBroadphase(create, false);
  });

  it('agrees with a list for infinite and tiny numbers', () => {
    playBroadphase(create, true);
  });
});

describe('random programs: casts through a box tree broadphase', () => {
  it('meet what they touch, along an axis and across', () => {
    playParallelCasts(() => phys2D.createBoxTreeBroadphase());
  });
});

describe('random programs: BoxTree', () => {
  it('agrees with a list', () => {
    playTrees(false);
  });

  it('agrees with a list for infinite and tiny numbers', () => {
    playTrees(true);
  });
});
