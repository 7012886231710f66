import { describe, expect, it } from 'vitest';
import { phys2D } from '../../src/index.js';
import { add, box, disc, plainBody, weightless } from '../conformance/setting.js';
import { type Bad, NOT_BOOLEAN, NOT_FINITE, NOT_NUMBERS, NOT_POSITIVE, NOT_VECTOR, refuses } from './refuses.js';

// Queries, casts and CollisionUtils refuse bad arguments, and say which.

const world = weightless();
const body = plainBody();
add(world, body);
const shape = body.shapes[0]!;
const utils = phys2D.createCollisionUtils();

const NOT_STORE: Bad[] = [
  [undefined, TypeError],
  [null, TypeError],
  [5, TypeError, '5'],
];
const NOT_FUNCTION: Bad[] = [
  [5, TypeError, '5'],
  ['x', TypeError, '"x"'],
  [{}, TypeError, 'an object'],
];
const NOT_SHAPE: Bad[] = [
  [undefined, TypeError],
  [null, TypeError],
  [body, TypeError, 'an object'],
  [disc(1), TypeError, 'an object'],
];
const NOT_RAY: Bad[] = [
  [undefined, TypeError],
  [null, TypeError],
  ['ray', TypeError, '"ray"'],
];
const NOT_MAX: Bad[] = [...NOT_NUMBERS, [undefined, TypeError], [NaN, RangeError], [-1, RangeError, '-1']];

/** What is wrong with two numbers, in either place. */
function badVectors(call: (value: never) => unknown, where: string, name: string): void {
  for (const bad of [...NOT_VECTOR, [undefined, TypeError]] as Bad[]) {
    refuses(call, where, name, bad);
  }
  for (const [value, kind, shown] of NOT_FINITE) {
    refuses((one) => call([one, 0] as never), where, `${name}[0]`, [value, kind, shown!]);
    refuses((one) => call([0, one] as never), where, `${name}[1]`, [value, kind, shown!]);
  }
}

function badRays(call: (ray: never) => unknown, where: string): void {
  const ray = { origin: [0, 0], direction: [1, 0], maxFactor: 9 };
  for (const bad of NOT_RAY) {
    refuses(call, where, 'ray', bad);
  }
  badVectors((origin) => call({ ...ray, origin } as never), where, 'ray.origin');
  badVectors((direction) => call({ ...ray, direction } as never), where, 'ray.direction');
  for (const bad of NOT_MAX) {
    refuses((maxFactor) => call({ ...ray, maxFactor } as never), where, 'ray.maxFactor', bad);
  }
  for (const zero of [
    [0, 0],
    [-0, 0],
  ]) {
    expect(() => call({ ...ray, direction: zero } as never)).toThrow(RangeError);
    expect(() => call({ ...ray, direction: zero } as never)).toThrow(`${where}: ray.direction must be `);
  }
}

describe('queries', () => {
  it.each(['shapePointQuery', 'bodyPointQuery'] as const)('%s', (name) => {
    const where = `World.${name}`;
    badVectors((point) => world[name](point, []), where, 'point');
    for (const bad of NOT_STORE) {
      refuses((store) => world[name]([0, 0], store), where, 'store', bad);
    }
  });

  it.each(['shapeCircleQuery', 'bodyCircleQuery'] as const)('%s', (name) => {
    const where = `World.${name}`;
    badVectors((center) => world[name](center, 1, []), where, 'center');
    for (const bad of [
      ...NOT_NUMBERS,
      [undefined, TypeError],
      [NaN, RangeError],
      [-1, RangeError],
      [0, RangeError],
    ] as Bad[]) {
      refuses((radius) => world[name]([0, 0], radius, []), where, 'radius', bad);
    }
    for (const bad of NOT_STORE) {
      refuses((store) => world[name]([0, 0], 1, store), where, 'store', bad);
    }
  });

  it.each(['shapeRectangleQuery', 'bodyRectangleQuery'] as const)('%s', (name) => {
    const where = `World.${name}`;
    for (const bad of [
      [undefined, TypeError],
      [null, TypeError],
      [5, TypeError],
      [[0, 0, 1], TypeError, 'an array of length 3'],
    ] as Bad[]) {
      refuses((rectangle) => world[name](rectangle, []), where, 'rectangle', bad);
    }
    for (const bad of [...NOT_NUMBERS, [NaN, RangeError]] as Bad[]) {
      refuses((value) => world[name]([0, value, 1, 1], []), where, 'rectangle[1]', bad);
      refuses((value) => world[name]([0, 0, 1, value], []), where, 'rectangle[3]', bad);
    }
    for (const bad of NOT_STORE) {
      refuses((store) => world[name]([0, 0, 1, 1], store), where, 'store', bad);
    }
  });

  it('shapeQuery', () => {
    for (const bad of NOT_SHAPE) {
      refuses((value) => world.shapeQuery(value, []), 'World.shapeQuery', 'shape', bad);
    }
    for (const bad of NOT_STORE) {
      refuses((store) => world.shapeQuery(shape, store), 'World.shapeQuery', 'store', bad);
    }
  });

  it('write nothing when they refuse', () => {
    const store: unknown[] = [1, 2];
    expect(() => world.shapePointQuery([NaN, 0], store as never)).toThrow(RangeError);
    expect(() => world.shapeCircleQuery([0, 0], -1, store as never)).toThrow(RangeError);
    expect(() =>
      world.rayCastAll({ origin: [0, 0], direction: [0, 0], maxFactor: 1 }, false, store as never),
    ).toThrow();
    expect(store).toEqual([1, 2]);
  });
});

describe('casts', () => {
  const ray = { origin: [-5, 0], direction: [1, 0], maxFactor: 9 };

  it('rayCast', () => {
    badRays((value) => world.rayCast(value), 'World.rayCast');
    for (const bad of NOT_BOOLEAN) {
      refuses((value) => world.rayCast(ray, value), 'World.rayCast', 'ignoreInnerSurfaces', bad);
    }
    for (const bad of NOT_FUNCTION) {
      refuses((value) => world.rayCast(ray, false, value), 'World.rayCast', 'callback', bad);
    }
    expect(world.rayCast(ray, undefined, undefined)?.shape).toBe(shape);
  });

  it('rayCastAll', () => {
    badRays((value) => world.rayCastAll(value, false, []), 'World.rayCastAll');
    for (const bad of NOT_BOOLEAN) {
      refuses((value) => world.rayCastAll(ray, value, []), 'World.rayCastAll', 'ignoreInnerSurfaces', bad);
    }
    for (const bad of NOT_STORE) {
      refuses((value) => world.rayCastAll(ray, false, value), 'World.rayCastAll', 'store', bad);
    }
  });

  it('convexCast', () => {
    for (const bad of NOT_SHAPE) {
      refuses((value) => world.convexCast(value, 1), 'World.convexCast', 'shape', bad);
    }
    for (const bad of [...NOT_POSITIVE, [undefined, TypeError]] as Bad[]) {
      refuses((value) => world.convexCast(shape, value), 'World.convexCast', 'deltaTime', bad);
    }
    for (const bad of NOT_FUNCTION) {
      refuses((value) => world.convexCast(shape, 1, value), 'World.convexCast', 'callback', bad);
    }
  });
});

describe('CollisionUtils', () => {
  const other = box(1, 1);
  phys2D.createRigidBody({ shapes: [other], position: [3, 0] });
  const ray = { origin: [-5, 0], direction: [1, 0], maxFactor: 9 };

  it('containsPoint', () => {
    badVectors((point) => utils.containsPoint(shape, point), 'CollisionUtils.containsPoint', 'point');
    for (const bad of NOT_SHAPE) {
      refuses((value) => utils.containsPoint(value, [0, 0]), 'CollisionUtils.containsPoint', 'shape', bad);
    }
  });

  it('rayTest', () => {
    const where = 'CollisionUtils.rayTest';
    badRays((value) => utils.rayTest(shape, value, []), where);
    for (const bad of NOT_SHAPE) {
      refuses((value) => utils.rayTest(value, ray, []), where, 'shape', bad);
    }
    for (const bad of NOT_STORE) {
      refuses((value) => utils.rayTest(shape, ray, value), where, 'normal', bad);
    }
    for (const bad of NOT_BOOLEAN) {
      refuses((value) => utils.rayTest(shape, ray, [], value), where, 'ignoreInnerSurfaces', bad);
    }
  });

  it('signedDistance, intersects and sweepTest', () => {
    const distance = 'CollisionUtils.signedDistance';
    const sweep = 'CollisionUtils.sweepTest';
    for (const bad of NOT_SHAPE) {
      refuses((value) => utils.signedDistance(value, other, [], [], []), distance, 'shapeA', bad);
      refuses((value) => utils.signedDistance(shape, value, [], [], []), distance, 'shapeB', bad);
      refuses((value) => utils.intersects(value, other), 'CollisionUtils.intersects', 'shapeA', bad);
      refuses((value) => utils.intersects(shape, value), 'CollisionUtils.intersects', 'shapeB', bad);
      refuses((value) => utils.sweepTest(value, other, 1, [], []), sweep, 'shapeA', bad);
      refuses((value) => utils.sweepTest(shape, value, 1, [], []), sweep, 'shapeB', bad);
    }
    for (const bad of NOT_STORE) {
      refuses((value) => utils.signedDistance(shape, other, value, [], []), distance, 'witnessA', bad);
      refuses((value) => utils.signedDistance(shape, other, [], value, []), distance, 'witnessB', bad);
      refuses((value) => utils.signedDistance(shape, other, [], [], value), distance, 'axis', bad);
      refuses((value) => utils.sweepTest(shape, other, 1, value, []), sweep, 'point', bad);
      refuses((value) => utils.sweepTest(shape, other, 1, [], value), sweep, 'normal', bad);
    }
    for (const bad of NOT_POSITIVE) {
      refuses((value) => utils.sweepTest(shape, other, value, [], []), sweep, 'deltaTime', bad);
    }
  });
});
