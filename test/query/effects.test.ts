import { describe, expect, it } from 'vitest';
import { type Broadphase, type CastResult, phys2D, type RigidBody, type Shape, type World } from '../../src/index.js';
import { BROADPHASES } from '../broadphase/model.js';
import { add, disc, plainBody, steps, weightless } from '../conformance/setting.js';
import { buildMixed } from '../scenes/mixed.js';

/** Everything that a body tells. */
function state(bodies: readonly RigidBody[]): unknown[] {
  return bodies.map((body) => [
    ...body.getPosition(),
    body.getRotation(),
    ...body.getVelocity(),
    body.getAngularVelocity(),
    body.sleeping,
    ...body.computeWorldBounds(),
  ]);
}

/** Every call that only looks, about a body. @returns what they find, with shapes by their user data. */
function lookAround(world: World, body: RigidBody, within: () => boolean = () => true): unknown[] {
  const utils = phys2D.createCollisionUtils();
  const [x, y] = body.getPosition();
  const shape = body.shapes[0]!;
  const other = world.rigidBodies[0]!.shapes[0]!;
  const ray = { origin: [x, y - 5], direction: [0.3, 1], maxFactor: Infinity };
  const collect = <T>(query: (store: T[]) => number): T[] => {
    const store: T[] = [];
    expect(query(store)).toBe(store.length);
    return store;
  };
  const names = (shapes: Shape[]): unknown[] => shapes.map(({ userData }) => userData).sort();
  const told = (hit: CastResult | null) => hit && [hit.shape.userData, hit.factor, ...hit.hitPoint, ...hit.hitNormal];
  const [witnessA, witnessB, axis] = [[], [], []] as [number[], number[], number[]];
  return [
    names(collect((store) => world.shapePointQuery([x, y], store))),
    names(collect((store) => world.shapeCircleQuery([x, y], 1, store))),
    names(collect((store) => world.shapeRectangleQuery([x - 1, y - 1, x + 1, y + 1], store))),
    collect<RigidBody>((store) => world.bodyPointQuery([x, y], store)).length,
    collect<RigidBody>((store) => world.bodyCircleQuery([x, y], 1, store)).length,
    collect<RigidBody>((store) => world.bodyRectangleQuery([x - 1, y - 1, x, y], store)).length,
    names(collect((store) => world.shapeQuery(shape, store))),
    told(world.rayCast(ray, false, within)),
    collect<CastResult>((store) => world.rayCastAll(ray, true, store)).map(told),
    told(world.convexCast(shape, 0.5, within)),
    utils.signedDistance(shape, other, witnessA, witnessB, axis),
    [witnessA, witnessB, axis],
    utils.intersects(shape, other),
    utils.containsPoint(shape, [x, y]),
    utils.rayTest(shape, ray, []),
    utils.sweepTest(shape, other, 1, witnessA, axis),
  ];
}

/** A bin of things that tumble, some asleep, some just moved. */
function bin(create: () => Broadphase, count = 40): World {
  const world = phys2D.createWorld({ broadphase: create() });
  buildMixed(phys2D, world, count, 5);
  world.rigidBodies.forEach(({ shapes }, i) => {
    shapes[0]!.userData = i;
  });
  return world;
}

describe.each(BROADPHASES)('looking, with %s,', (_, create) => {
  it('changes nothing that bodies tell', () => {
    const world = bin(create);
    steps(world, 60);
    const [, , , a, b, c] = world.rigidBodies;
    a!.setPosition([1, -8]);
    b!.setRotation(1);
    c!.sleep();
    const before = state(world.rigidBodies);
    const stamps = [world.timeStamp, world.liveDynamics.length, world.dynamicArbiters.length];
    for (const body of [...world.rigidBodies]) {
      lookAround(world, body);
    }
    expect(state(world.rigidBodies)).toEqual(before);
    expect([world.timeStamp, world.liveDynamics.length, world.dynamicArbiters.length]).toEqual(stamps);
  });

  it('changes nothing in the steps to come, whenever it is done', () => {
    const [watched, left] = [bin(create), bin(create)] as const;
    const start = watched.rigidBodies.length;
    let looks = 0;
    for (const body of watched.rigidBodies) {
      const look = () => {
        looks += 1;
        lookAround(watched, body);
      };
      if (looks % 3 === 0) {
        body.shapes[0]!.addEventListener('begin', look);
      }
    }
    // A listener that only decides, so that both worlds have the same ones.
    for (const world of [watched, left]) {
      world.rigidBodies[7]!.shapes[0]!.addEventListener('preSolve', () => {
        if (world === watched) {
          lookAround(world, world.rigidBodies[8]!);
        }
      });
    }
    for (const body of left.rigidBodies) {
      body.shapes[0]!.addEventListener('begin', () => {});
    }
    for (let i = 0; i < 150; i += 1) {
      for (const world of [watched, left]) {
        const body = world.rigidBodies[5 + (i % 20)]!;
        if (i % 7 === 0) {
          body.setPosition([(i % 5) - 2, -4 - (i % 3)]);
        }
        if (world === watched) {
          looks += 1;
          lookAround(world, world.rigidBodies[i % start]!);
        }
        world.step(1 / 60);
      }
      expect(state(watched.rigidBodies), `step ${i}`).toEqual(state(left.rigidBodies));
    }
    expect(looks).toBeGreaterThan(200);
  });

  it('from within a callback spoils neither look', () => {
    const world = bin(create);
    steps(world, 90);
    const plain = world.rigidBodies.map((body) => JSON.stringify(lookAround(world, body)));
    let nested = 0;
    world.rigidBodies.forEach((body, i) => {
      const k = (i * 7 + 3) % plain.length;
      const inner = world.rigidBodies[k]!;
      const found = lookAround(world, body, () => {
        nested += 1;
        const deeper = () => {
          expect(JSON.stringify(lookAround(world, body))).toBe(plain[i]);
          return true;
        };
        const seen = lookAround(world, inner, nested % 10 === 0 ? deeper : undefined);
        expect(JSON.stringify(seen)).toBe(plain[k]);
        return true;
      });
      expect(JSON.stringify(found)).toBe(plain[i]);
    });
    expect(nested).toBeGreaterThan(plain.length / 2);
  });

  it.each([
    ['the body before it', (world: World, { shape }: CastResult) => void world.removeRigidBody(shape.body!)],
    ['all bodies', (world: World) => world.clear()],
  ])('goes on where a callback takes away %s', (_what, take) => {
    const row = (): { world: World; swept: Shape } => {
      const world = weightless({ broadphase: create() });
      const swept = disc(0.2);
      const bodies = Array.from({ length: 6 }, (_each, i) => plainBody({ position: [2 * i, 0], shapes: [disc(0.5)] }));
      add(world, ...bodies, plainBody({ position: [-3, 0], velocity: [100, 0], shapes: [swept] }));
      return { world, swept };
    };
    for (const isRay of [true, false]) {
      const { world, swept } = row();
      let asked = 0;
      const accept = (_of: unknown, found: CastResult): boolean => {
        asked += 1;
        take(world, found);
        return false;
      };
      const ray = { origin: [-2, 0], direction: [1, 0], maxFactor: 100 };
      expect(isRay ? world.rayCast(ray, false, accept) : world.convexCast(swept, 1, accept)).toBe(null);
      expect(asked).toBe(world.rigidBodies.length > 0 ? 6 : 1);
    }
  });

  it('sees placements in preSolve as they were before the step', () => {
    const world = bin(create);
    steps(world, 30);
    let looked = 0;
    let before: unknown[] = [];
    const body = world.rigidBodies[6]!;
    let place = '';
    body.shapes[0]!.addEventListener('preSolve', () => {
      // Of an impact in the course of a step the handler is asked where that is.
      if (body.getPosition().join() !== place) {
        return;
      }
      looked += 1;
      expect(JSON.stringify(lookAround(world, world.rigidBodies[9]!)[1])).toBe(JSON.stringify(before[1]));
    });
    for (let i = 0; i < 60; i += 1) {
      before = lookAround(world, world.rigidBodies[9]!);
      place = body.getPosition().join();
      world.step(1 / 60);
    }
    expect(looked).toBeGreaterThan(10);
  });
});

describe('callbacks and stores', () => {
  it('an exception in a callback comes through and leaves nothing behind', () => {
    const world = weightless();
    add(world, plainBody({ position: [3, 0] }));
    const probe = plainBody({ velocity: [1, 0] }).shapes[0]!;
    const ray = { origin: [0, 0], direction: [1, 0], maxFactor: 9 };
    const fail = () => {
      throw new Error('from the callback');
    };
    expect(() => world.rayCast(ray, false, fail)).toThrow('from the callback');
    expect(() => world.convexCast(probe, 9, fail)).toThrow('from the callback');
    expect(world.rayCast(ray)?.factor).toBeCloseTo(2.5, 12);
    expect(world.convexCast(probe, 9)?.factor).toBeCloseTo(2, 6);
    steps(world, 1);
  });

  it('a callback may change the ray that it was called for', () => {
    for (const [, create] of BROADPHASES) {
      const world = phys2D.createWorld({ broadphase: create() });
      add(world, ...[3, 5, 7, 9].map((x) => plainBody({ position: [x, 0] })));
      const ray = { origin: [0, 0], direction: [1, 0], maxFactor: 20 };
      const factors: number[] = [];
      const found = world.rayCast(ray, false, (_, { factor }) => {
        factors.push(factor);
        ray.origin.fill(50);
        ray.direction.fill(-1);
        ray.maxFactor = 1;
        return factor > 6;
      });
      expect(factors).toContain(2.5);
      expect(found?.factor).toBeCloseTo(6.5, 12);
    }
  });

  it('results of rayCastAll are the caller’s: the next call does not write into them', () => {
    const world = weightless();
    add(world, plainBody({ position: [3, 0] }), plainBody({ position: [0, 4] }));
    const store: CastResult[] = [];
    world.rayCastAll({ origin: [0, 0], direction: [1, 0], maxFactor: 9 }, false, store);
    const [first] = store;
    const copy = { ...first!, hitPoint: [...first!.hitPoint], hitNormal: [...first!.hitNormal] };
    expect(world.rayCastAll({ origin: [0, 0], direction: [0, 1], maxFactor: 9 }, false, store)).toBe(1);
    expect(first).toEqual(copy);
    expect(store[0]).not.toBe(first);
  });

  it('origin, direction and rectangle may be typed arrays, and are not written to', () => {
    const world = weightless();
    add(world, plainBody({ position: [3, 0], shapes: [disc(0.5)] }));
    const ray = Object.freeze({
      origin: Float32Array.of(0, 0.25),
      direction: Object.freeze([2, 0]),
      maxFactor: Infinity,
    });
    expect(world.rayCast(ray)?.factor).toBeGreaterThan(1.25);
    expect([...ray.origin]).toEqual([0, 0.25]);
    const rectangle = Float64Array.of(4, 1, 3, -1);
    expect(world.shapeRectangleQuery(rectangle, [])).toBe(1);
    expect([...rectangle]).toEqual([4, 1, 3, -1]);
    expect(world.shapePointQuery(Object.freeze([3, 0]), [])).toBe(1);
  });
});
