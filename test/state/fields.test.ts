import { describe, expect, it } from 'vitest';
import { BodyNumbers } from '../../src/body-numbers.js';
import { LOCAL_X, LOCAL_Y, PAIR_NUMBERS } from '../../src/collide/layout.js';
import { KEPT, LISTED } from '../../src/contact/bits.js';
import { APPROACH } from '../../src/contact/layout.js';
import { type Arbiter, phys2D, type World } from '../../src/index.js';
import { GAMES } from '../scenes/states.js';

// No field may be forgotten: each number and flag of the objects of a world that is spoilt has to be as before after a restore, and to change the
// hash. Those that are named here need not, for the reason given.

type Fields = Record<string, unknown>;

/** Worked out anew before it is used, dead between steps, or the number by which the world itself finds something. */
const DERIVED: Readonly<Record<string, readonly string[]>> = {
  world: ['stepping', 'delivering', 'someLeft', 'jointsTouched', 'filters', 'filtersChanged'],
  solver: [
    'bodyCount',
    'substeps',
    'impulseScale',
    'contactScale',
    'remembered',
    'hardCount',
    'deepCircles',
    'unloads',
    'roomFor',
  ],
  body: ['mass', 'inertia', 'radius', 'massStale', 'placeStale', 'slot', 'mover'],
  shape: ['groundStamp', 'stateIndex'],
  // Only whether it has failed in this step; where the solver has its numbers.
  constraint: ['failed', 'place', 'fetched'],
  arbiter: ['foreseen'],
  group: [
    ...[
      'start',
      'end',
      'hasCustoms',
      'tolerance',
      'errorSquare',
      'pushedSquare',
      'pushed',
      'isPushed',
      'touched',
      'neighbours',
      'isBeside',
      'branches',
      'isIndeterminate',
      'isMixed',
    ],
    ...[
      'isDriven',
      'isAnchored',
      'isHeldTwice',
      'isUnmet',
      'anchors',
      'isTorn',
      'mayBreak',
      'frequency',
      'isWatched',
      'energy',
      'isFirm',
      'stands',
      'isBent',
      'isOverheld',
      'isWhole',
      'isAfloat',
    ],
  ],
  record: [LOCAL_X, LOCAL_Y, APPROACH].map(String),
};

/** Fixed when an object is made. */
const FIXED: Readonly<Record<string, readonly string[]>> = {
  body: ['at'],
  shape: ['id', 'sensor', 'kind', 'at'],
  polygon: ['radius'],
  constraint: ['dimension', 'positional', 'bounded'],
  arbiter: ['at', 'number'],
};

/** Kept, but of no influence: lists without order, and by what objects are found. */
const UNHEARD: Readonly<Record<string, readonly string[]>> = {
  world: ['nextOrder'],
  body: ['order', 'index', 'liveIndex'],
  shape: ['order'],
  constraint: ['order', 'index', 'liveIndex'],
  arbiter: ['listIndex', 'indexA', 'indexB'],
};

/** What a body has as accessors. */
const NUMBERS = Object.entries(Object.getOwnPropertyDescriptors(BodyNumbers.prototype))
  .filter(([, { set }]) => set !== undefined)
  .map(([key]) => key);

const names = (of: Readonly<Record<string, readonly string[]>>, kind: string): readonly string[] => [
  ...(kind === 'polygon' ? (of.shape ?? []) : []),
  ...(of[kind] ?? []),
];

/** A world in the middle of everything, awake and asleep. */
function busy(name: string, steps: number): World {
  const game = GAMES[name]!(phys2D);
  for (let i = 0; i < steps; i += 1) {
    game.step();
  }
  game.world.liveDynamics[0]!.applyForce([0.1, 0], [0.2, 0.3]);
  return game.world;
}

/** The numbers of a pair of two points: of fewer, those that are missing mean nothing. */
function recordOf({ numbers, at }: Arbiter): Float64Array {
  return numbers.subarray(at, at + PAIR_NUMBERS);
}

/** One object of each kind, as they are after a restore: arbiters are found anew. */
function objects(world: World): [string, () => object][] {
  const circle = world.rigidBodies.findIndex(({ shapes }) => shapes[0]!.type === 'CIRCLE');
  const polygon = world.rigidBodies.findIndex(({ shapes }) => shapes[0]!.type === 'POLYGON');
  const dynamic = world.liveDynamics[0]!;
  const kinds = new Set(world.constraints.map(({ type }) => type));
  return [
    ['world', () => world],
    ['solver', () => world.solver],
    ['body', () => dynamic],
    ['applied', () => dynamic.applied!],
    ...Object.entries({ shape: circle, polygon })
      .filter(([, i]) => i >= 0)
      .map(([kind, i]): [string, () => object] => [kind, () => world.rigidBodies[i]!.shapes[0]!]),
    ...[...kinds].map((kind): [string, () => object] => {
      const constraint = world.constraints.find(({ type }) => type === kind)!;
      return ['constraint', () => constraint];
    }),
    ...(world.dynamicArbiters.some(({ active }) => active)
      ? ([['arbiter', () => world.dynamicArbiters.find(({ active }) => active)!]] as [string, () => object][])
      : []),
    ...(world.dynamicArbiters.some(({ active, count }) => active && count === 2)
      ? ([['record', () => recordOf(world.dynamicArbiters.find(({ active, shown }) => active && shown === 2)!)]] as [
          string,
          () => object,
        ][])
      : []),
    ...(world.solver.joints.groups.length > 0
      ? ([['group', () => world.solver.joints.groups[0]!]] as [string, () => object][])
      : []),
  ];
}

function spoilt(value: unknown): unknown {
  return typeof value === 'boolean' ? !value : Number.isFinite(value) ? (value as number) + 1 : 12.5;
}

describe.each([
  ['constraints', 40],
  ['events', 200],
])('%s', (name, steps) => {
  const world = busy(name, steps);
  const snapshot = world.snapshot();
  const hash = world.hash();

  for (const [kind, find] of objects(world)) {
    const keys = [...Object.keys(find()), ...(kind === 'body' ? NUMBERS : [])]
      .filter((key) => ['number', 'boolean'].includes(typeof (find() as Fields)[key]))
      .filter((key) => ![...names(DERIVED, kind), ...names(FIXED, kind)].includes(key));

    it(`${kind}: ${keys.join(' ') || 'nothing'}`, () => {
      for (const key of keys) {
        const object = find() as Fields;
        const before = object[key];
        object[key] = spoilt(before);
        if (!names(UNHEARD, kind).includes(key)) {
          expect(world.hash(), `${kind}.${key} and the hash`).not.toBe(hash);
        }
        // By these the world finds its own objects again.
        if (['index', 'liveIndex', 'indexA', 'indexB', 'listIndex'].includes(key)) {
          object[key] = before;
        }
        world.restore(snapshot);
        expect((find() as Fields)[key], `${kind}.${key}`).toBe(before);
        expect(world.hash(), `the hash after ${kind}.${key}`).toBe(hash);
      }
    });
  }

  it('bits of an arbiter', () => {
    const find = () => world.dynamicArbiters.find((arbiter) => arbiter.is(LISTED) && arbiter.count > 0)!;
    for (let bit = 1; bit <= KEPT; bit *= 2) {
      // By whether it is listed the world finds it again.
      if ((KEPT & bit) !== 0 && bit !== LISTED) {
        const { bits } = find();
        find().bits ^= bit;
        expect(world.hash(), `bit ${bit}`).not.toBe(hash);
        world.restore(snapshot);
        expect(find().bits, `bit ${bit}`).toBe(bits);
      }
    }
  });

  it('lists of numbers', () => {
    for (const constraint of world.constraints) {
      const { impulse, given } = constraint;
      const own = Object.values(constraint).filter((value) => value instanceof Float64Array);
      for (const list of [impulse, given, ...own]) {
        if (list.length > 0 && (list as unknown) !== (constraint as unknown as Fields).data) {
          const [before] = list;
          list[0] = before! + 1;
          expect(world.hash()).not.toBe(hash);
          world.restore(snapshot);
          expect(list[0]).toBe(before);
        }
      }
    }
  });
});
