import { describe, expect, it } from 'vitest';
import { DRAW_OPTIONS, defaults, fromLink, RANGES, SPEEDS } from '../../playground/settings.js';
import { validate } from '../../src/audit/index.js';
import { type Polygon, phys2D, type World } from '../../src/index.js';
import { seal } from '../../src/state/format.js';
import { deserialize, type PlainWorld, Recorder, type Recording, replay, serialize } from '../../src/state/index.js';
import { generator } from '../scenes/mixed.js';
import { GAMES } from '../scenes/states.js';

// What comes from a file, a message or a link may be anything: it is refused or taken, but runs no code, changes no prototype, and breaks no world.

const NAMES = Object.getOwnPropertyNames(Object.prototype).sort();

function expectClean(): void {
  expect(Object.getOwnPropertyNames(Object.prototype).sort()).toEqual(NAMES);
  expect(({} as Record<string, unknown>).polluted).toBeUndefined();
}

/** A world that was made of what may be wrong is consistent, and stays so. */
function expectSound(world: World): void {
  validate(world);
  for (let i = 0; i < 3; i += 1) {
    world.step(1 / 60);
    validate(world);
  }
}

function played(name: string, steps = 60): World {
  const game = GAMES[name]!(phys2D);
  for (let i = 0; i < steps; i += 1) {
    game.step();
  }
  return game.world;
}

/** A world without code of its own. */
const plain = (): PlainWorld => JSON.parse(JSON.stringify(serialize(played('drum')))) as PlainWorld;

const HOSTILE: readonly unknown[] = [
  null,
  true,
  -1,
  0,
  0.5,
  NaN,
  1e308,
  -1e308,
  2 ** 31,
  2 ** 53,
  '',
  'text',
  '__proto__',
  'constructor',
  'Infinity',
  [],
  {},
  [[]],
  [1e308, 1e308],
  { length: 2 ** 32 - 1 },
  { valueOf: null, toString: null },
];

/** All places in data: an object, and one of its keys. */
function placesIn(value: unknown): [Record<string, unknown>, string][] {
  return typeof value !== 'object' || value === null
    ? []
    : Object.entries(value).flatMap(([key, part]) => [
        [value as Record<string, unknown>, key] as [Record<string, unknown>, string],
        ...placesIn(part),
      ]);
}

describe('deserialize', () => {
  it('of data with something else in any place refuses it, or makes a sound world', () => {
    const random = generator(3);
    const pick = <T>(list: readonly T[]): T => list[Math.floor(random() * list.length)]!;
    const source = plain();
    source.bodies.length = Math.min(source.bodies.length, 40);
    let taken = 0;
    for (let i = 0; i < 300; i += 1) {
      const data = plainCopy(i % 2 === 0 ? plainSmall : source);
      const [object, key] = pick(placesIn(data));
      object[key] = pick(HOSTILE);
      try {
        expectSound(deserialize(phys2D, data));
        taken += 1;
      } catch (error) {
        expect(String(error), `case ${i}: ${key}`).toMatch(/^(?:Range|Type)?Error: (?:deserialize|World\.restore): /);
      }
    }
    expect(taken).toBeGreaterThan(0);
    expectClean();
  }, 120_000);

  it('of data with __proto__ as a key anywhere changes no prototype', () => {
    const text = JSON.stringify(plainSmall).replaceAll(
      '{',
      '{"__proto__":{"polluted":1},"constructor":{"prototype":{"polluted":1}},',
    );
    const world = deserialize(phys2D, JSON.parse(text) as PlainWorld);
    expectClean();
    expect(world.hash()).toBe(deserialize(phys2D, plainCopy(plainSmall)).hash());
    expect((world.rigidBodies[0] as unknown as Record<string, unknown>).polluted).toBeUndefined();
  });

  it('calls nothing that is in the data', () => {
    const data = plainCopy(plainSmall) as unknown as Record<string, unknown>;
    for (const [object] of placesIn(data)) {
      object.toJSON =
        object.valueOf =
        object.toString =
          () => {
            throw new Error('called');
          };
    }
    expect(() => deserialize(phys2D, data as never)).not.toThrow();
  });
});

const plainCopy = (data: PlainWorld): PlainWorld => structuredClone(data);
const plainSmall = ((): PlainWorld => {
  const world = phys2D.createWorld();
  const add = (type: 'dynamic' | 'static', y: number) => {
    const shape = phys2D.createPolygonShape({ vertices: phys2D.createBoxVertices(1, 1) });
    const body = phys2D.createRigidBody({ type, position: [0, y], shapes: [shape], userData: { of: 'mine' } });
    world.addRigidBody(body);
    return body;
  };
  const [bodyA, bodyB] = [add('static', 0), add('dynamic', -0.99)];
  world.addConstraint(phys2D.createDistanceConstraint({ bodyA, bodyB, lowerBound: 0, upperBound: Infinity }));
  world.addConstraint(phys2D.createLineConstraint({ bodyA, bodyB, axis: [0, 1], lowerBound: -9, upperBound: 9 }));
  world.step(1 / 60);
  return serialize(world, { userData: (value) => value });
})();

it('restore refuses vertices that make no polygon, of shapes that the world has and of others', () => {
  for (const isOther of [false, true]) {
    const world = phys2D.createWorld();
    const polygon = phys2D.createPolygonShape({ vertices: phys2D.createBoxVertices(0.875, 0.875) });
    world.addRigidBody(phys2D.createRigidBody({ shapes: [polygon] }));
    const snapshot = world.snapshot();
    const numbers = new Float64Array(snapshot.slice(0, snapshot.byteLength & ~7));
    const places = [...numbers.keys()].filter((i) => Math.abs(numbers[i]!) === 0.4375);
    expect(places).toHaveLength(8);
    if (isOther) {
      polygon.setVertices(phys2D.createBoxVertices(1, 2));
    }
    const before = world.hash();
    for (const place of places) {
      const forged = new Uint8Array(snapshot.slice(0));
      forged[8 * place + 7]! ^= 128;
      seal(forged.buffer);
      expect(() => world.restore(forged.buffer)).toThrow('World.restore: the snapshot');
    }
    expect(world.hash()).toBe(before);
    world.restore(snapshot);
    expect(polygon.vertices[0]).toBe(numbers[places[0]!]);
  }
});

it('restore takes any polygon that a shape can be mapped to, from a snapshot made elsewhere', () => {
  const maps: ((shape: Polygon) => void)[] = [
    (shape) => shape.scale(1e4, 1e-6),
    (shape) => shape.transform([1, 0, 1e9, 1, 0, 0]),
    (shape) => shape.translate([1e12, 3e7]),
  ];
  for (const map of maps) {
    for (const corners of [3, 4, 6, 16]) {
      const world = phys2D.createWorld();
      const polygon = phys2D.createPolygonShape({ vertices: phys2D.createRegularPolygonVertices(1, 1, corners) });
      world.addRigidBody(phys2D.createRigidBody({ shapes: [polygon] }));
      map(polygon);
      const snapshot = world.snapshot().slice(0);
      const before = world.hash();
      polygon.setVertices(phys2D.createBoxVertices(1, 2));
      world.restore(snapshot);
      expect(world.hash()).toBe(before);
    }
  }
});

it.each(['events', 'constraints', 'drum'])(
  'restore of a forged snapshot leaves a world that can be stepped, and stays finite: %s',
  (name) => {
    const world = played(name, 120);
    const snapshot = world.snapshot();
    const random = generator(11);
    let taken = 0;
    for (let i = 0; i < 200; i += 1) {
      const forged = new Uint8Array(snapshot.byteLength);
      forged.set(new Uint8Array(snapshot));
      for (let k = Math.floor(3 * random()); k >= 0; k -= 1) {
        forged[32 + Math.floor((forged.length - 32) * random())]! ^= 1 << Math.floor(8 * random());
      }
      seal(forged.buffer);
      try {
        world.restore(forged.buffer);
      } catch (error) {
        expect(String(error), `case ${i}`).toMatch(
          /^(?:Range|Type)?Error: (?:World\.restore: the snapshot|createMaterial)/,
        );
        continue;
      }
      taken += 1;
      // Any count of iterations is legal, and takes its time.
      world.velocityIterations = Math.min(world.velocityIterations, 100);
      world.positionIterations = Math.min(world.positionIterations, 100);
      world.substeps = Math.min(world.substeps, 100);
      for (let k = 0; k < 3; k += 1) {
        try {
          world.step(1 / 60);
        } catch (error) {
          // Callbacks that were not made for such numbers.
          expect(String(error)).toMatch(/^RangeError: CustomConstraint\./);
        }
        for (const body of world.rigidBodies) {
          const numbers = [...body.getPosition(), body.getRotation(), ...body.getVelocity(), body.getAngularVelocity()];
          expect(numbers.every(Number.isFinite), `case ${i}: ${numbers}`).toBe(true);
        }
      }
      world.restore(snapshot);
    }
    expect(taken).toBeGreaterThan(0);
  },
  120_000,
);

describe('replay', () => {
  const record = (): Recording => {
    const world = played('drum', 1);
    const recorder = Recorder.create(world);
    recorder.call(world.liveDynamics[0]!, 'applyImpulse', [1, 0]);
    recorder.step(1 / 60);
    return recorder.recording;
  };

  it.each([
    'constructor',
    '__proto__',
    '__defineGetter__',
    'hasOwnProperty',
    'toString',
    'restore',
    'step',
    'userData',
    'nothing',
  ])('calls no %s', (method) => {
    const { snapshot, frames } = record();
    const [call] = frames[0]!.calls;
    const forged = { snapshot, frames: [{ ...frames[0]!, calls: [{ ...call!, method }] }] };
    expect(() => replay((call!.object as { world: World }).world, forged)).toThrow(/^replay: /);
    expectClean();
  });
});

describe('links of the playground', () => {
  const WORDS = [
    'scene',
    'speed',
    'gravity',
    'velocity',
    'position',
    'substeps',
    'broadphase',
    'sleep',
    'draw',
    'steps',
    '__proto__',
    'constructor',
  ];
  const VALUES = [
    '',
    '1',
    '-1',
    '1e9',
    'NaN',
    'Infinity',
    '1,2',
    '1e308,1',
    'tree',
    'fill,__proto__,x',
    '<script>',
    'javascript:1',
    '__proto__',
    '%',
    '0x10',
  ];

  it('are settings that make sense, whatever they say', () => {
    const random = generator(4);
    const pick = <T>(list: readonly T[]): T => list[Math.floor(random() * list.length)]!;
    for (let i = 0; i < 5000; i += 1) {
      const parts = Array.from({ length: 1 + Math.floor(6 * random()) }, () => `${pick(WORDS)}=${pick(VALUES)}`);
      const settings = fromLink(`#${parts.join('&')}`);
      const { scene, speed, gravity, steps, draw } = settings;
      expect(Object.keys(settings).sort()).toEqual(Object.keys(defaults(scene)).sort());
      expect(SPEEDS).toContain(speed);
      expect(gravity === null || gravity.every((part) => Math.abs(part) <= 100)).toBe(true);
      expect(steps === null || (Number.isInteger(steps) && steps >= 0 && steps <= 20_000)).toBe(true);
      for (const name of Object.keys(RANGES) as (keyof typeof RANGES)[]) {
        expect(settings[name]).toBeGreaterThanOrEqual(RANGES[name][0]);
        expect(settings[name]).toBeLessThanOrEqual(RANGES[name][1]);
      }
      expect([...draw].filter((name) => !Object.keys(DRAW_OPTIONS).includes(name))).toEqual([]);
    }
    expectClean();
  });
});
