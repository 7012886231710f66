import { describe, expect, it } from 'vitest';
import { type CastResult, phys2D, type Ray, type Vec2 } from '../../src/index.js';
import { Chance } from '../geometry/forms.js';
import { type Crossing, indices, Scene } from './scene.js';

const RAYS = 10_000;
const BODIES = 300;
const EXTENT = 30;

const chance = new Chance(18);
const scene = new Scene(chance, BODIES, EXTENT);

const anywhere = (): Vec2 => [chance.span(-5, EXTENT + 5), chance.span(-5, EXTENT + 5)];
const minus = ([ax, ay]: Vec2, [bx, by]: Vec2): Vec2 => [ax - bx, ay - by];

/** Origin and direction by kind. */
const KINDS: Record<string, () => [origin: Vec2, direction: Vec2]> = {
  anyhow: () => [anywhere(), minus(anywhere(), anywhere())],
  'from inside': () => [scene.bodies[0]![chance.index(BODIES)]!.getPosition(), minus(anywhere(), anywhere())],
  'from close to a boundary': () => [scene.nearBoundary(), minus(anywhere(), anywhere())],
  'along an axis': () => {
    const length = chance.span(-2, 2);
    return [anywhere(), chance.next() < 0.5 ? [length, 0] : [0, length]];
  },
  'along an edge': () => {
    const [p, q] = scene.randomEdge();
    const [x, y] = minus(q, p);
    const back = chance.size(0.1, 30);
    return [
      [p[0] - back * x, p[1] - back * y],
      [x, y],
    ];
  },
  'through a corner': () => {
    const origin = anywhere();
    return [origin, minus(scene.randomEdge()[0], origin)];
  },
  'from a corner': () => [scene.randomEdge()[0], minus(anywhere(), anywhere())],
  'very short': () => [anywhere(), minus(anywhere(), anywhere()).map((x) => x * 1e-200) as Vec2],
  'very long': () => [anywhere(), minus(anywhere(), anywhere()).map((x) => x * 1e200) as Vec2],
};
const NAMES = Object.keys(KINDS);

function randomRay(i: number): Ray {
  const [origin, direction] = KINDS[NAMES[i % NAMES.length]!]!();
  const length = Math.max(Math.abs(direction[0]), Math.abs(direction[1]));
  return { origin, direction, maxFactor: chance.next() < 0.4 ? Infinity : chance.size(0.1, 100) / length };
}

/** m, from the origin. */
function lengthTo(ray: Ray, { factor }: CastResult): number {
  const scale = Math.max(Math.abs(ray.direction[0]!), Math.abs(ray.direction[1]!));
  return factor * scale * Math.hypot(ray.direction[0]! / scale, ray.direction[1]! / scale);
}

/** In loops: `expect` takes as long as a hundred rays. */
function ensure(holds: boolean, what: () => string): void {
  if (!holds) {
    expect.fail(what());
  }
}

function isNear(a: ArrayLike<number>, b: ArrayLike<number>, tolerance: number): boolean {
  return Math.abs(a[0]! - b[0]!) <= tolerance && Math.abs(a[1]! - b[1]!) <= tolerance;
}

function checkHit(ray: Ray, found: CastResult, crossing: Crossing | undefined, what: () => string): void {
  const { factor, hitPoint, hitNormal } = found;
  const { origin, direction, maxFactor } = ray;
  const why = (text: string) => () => `${what()}: ${text} ${JSON.stringify([factor, hitPoint, hitNormal, crossing])}`;
  ensure(crossing !== undefined, why('hit what is not in the way'));
  ensure(factor >= 0 && factor < maxFactor, why('factor'));
  const { at, normal, corner, unsure } = crossing!;
  const [nx, ny] = hitNormal;
  const scale = Math.max(Math.abs(direction[0]!), Math.abs(direction[1]!));
  ensure(Math.abs(nx * nx + ny * ny - 1) < 1e-12, why('unit normal'));
  ensure(nx * (direction[0]! / scale) + ny * (direction[1]! / scale) <= 1e-9, why('normal against the ray'));
  if (!unsure) {
    const point = [0, 1].map((k) => origin[k]! + direction[k]! * factor);
    ensure(Math.abs(lengthTo(ray, found) - at) <= 1e-7, why('length'));
    ensure(isNear(hitPoint, point, 1e-9), why('point'));
    ensure(corner || isNear(hitNormal, normal, 1e-6), why('normal'));
  }
}

function isSame(a: CastResult | null, b: CastResult | null): boolean {
  if (a === null || b === null) {
    return a === b;
  }
  return (
    a.shape.userData === b.shape.userData &&
    a.factor === b.factor &&
    isNear(a.hitPoint, b.hitPoint, 0) &&
    isNear(a.hitNormal, b.hitNormal, 0)
  );
}

/** The nearest that is not a matter of rounding. */
function nearest(crossings: Map<number, Crossing>): number {
  return Math.min(...[...crossings.values()].filter(({ unsure }) => !unsure).map(({ at }) => at));
}

describe(`rays through ${BODIES} bodies`, () => {
  it(`${RAYS} of them meet what a loop over all shapes finds, with both broadphases`, () => {
    let hits = 0;
    let unsure = 0;
    for (let i = 0; i < RAYS; i += 1) {
      const ray = randomRay(i);
      const outerOnly = chance.next() < 0.4;
      const what = () => `ray ${i}, ${NAMES[i % NAMES.length]}, ${JSON.stringify(ray)}`;
      const crossings = scene.crossings(ray, outerOnly);
      unsure += [...crossings.values()].filter((crossing) => crossing.unsure).length;
      const results = scene.worlds.map((world) => world.rayCast(ray, outerOnly));
      const limit = nearest(crossings);
      for (const found of results) {
        if (found === null) {
          ensure(limit === Infinity, () => `${what()}: nothing hit`);
        } else {
          hits += 1;
          const index = found.shape.userData as number;
          checkHit(ray, found, crossings.get(index), what);
          ensure(lengthTo(ray, found) <= limit + 1e-7, () => `${what()}: not the nearest`);
        }
      }
      const [one, other] = results;
      ensure(isSame(one!, other!), () => `${what()}: broadphases differ`);
    }
    console.log(`${RAYS} rays in 2 worlds: ${hits} hits; ${unsure} touches that are a matter of rounding`);
    expect(hits).toBeGreaterThan(RAYS);
    expect(unsure).toBeLessThan(RAYS);
  });

  it('all that they meet, nearest first', () => {
    let total = 0;
    for (let i = 0; i < RAYS / 4; i += 1) {
      const ray = randomRay(i);
      const outerOnly = chance.next() < 0.4;
      const what = () => `ray ${i}, ${NAMES[i % NAMES.length]}, ${JSON.stringify(ray)}`;
      const crossings = scene.crossings(ray, outerOnly);
      for (const world of scene.worlds) {
        const store: CastResult[] = [];
        const count = world.rayCastAll(ray, outerOnly, store);
        ensure(store.length === count, () => `${what()}: count`);
        total += count;
        const found = indices(store.map(({ shape }) => shape));
        ensure(new Set(found).size === count, () => `${what()}: a shape twice`);
        for (const [k, hit] of store.entries()) {
          checkHit(ray, hit, crossings.get(found[k]!), what);
          ensure(hit.factor >= (store[k - 1]?.factor ?? 0), () => `${what()}: order`);
        }
        const missing = [...crossings].filter(([index, { unsure }]) => !unsure && !found.includes(index));
        ensure(missing.length === 0, () => `${what()}: missed ${missing}`);
        ensure(isSame(store[0] ?? null, world.rayCast(ray, outerOnly)), () => `${what()}: rayCast finds another`);
      }
    }
    expect(total).toBeGreaterThan(RAYS);
  });

  it('the nearest that a callback accepts', () => {
    for (let i = 0; i < RAYS / 10; i += 1) {
      const ray = randomRay(i);
      const what = () => `ray ${i}, ${JSON.stringify(ray)}`;
      const modulus = 2 + chance.index(5);
      const store: CastResult[] = [];
      const [world] = scene.worlds;
      world!.rayCastAll(ray, false, store);
      const wanted = store.find(({ shape }) => (shape.userData as number) % modulus === 0) ?? null;
      for (const each of scene.worlds) {
        const asked: number[] = [];
        const found = each.rayCast(ray, false, (_, { shape, factor, hitPoint }) => {
          ensure(Number.isFinite(factor + hitPoint[0] + hitPoint[1]), what);
          asked.push(shape.userData as number);
          return (shape.userData as number) % modulus === 0;
        });
        ensure(found?.factor === wanted?.factor, what);
        expect(new Set(asked).size, 'each shape once').toBe(asked.length);
      }
    }
  });

  it('a ray that ends where it would hit does not, one that ends a little later does', () => {
    let again = 0;
    for (let i = 0; i < RAYS / 10; i += 1) {
      const ray = { ...randomRay(i), maxFactor: Infinity };
      for (const world of scene.worlds) {
        const hit = world.rayCast(ray);
        if (hit !== null && hit.factor > 0) {
          const shorter = world.rayCast({ ...ray, maxFactor: hit.factor });
          expect(shorter?.factor, `ray ${i}, ${JSON.stringify(ray)}`).not.toBe(hit.factor);
          again += 1;
          expect(world.rayCast({ ...ray, maxFactor: hit.factor * (1 + 1e-9) })?.factor).toBe(hit.factor);
        }
      }
    }
    expect(again).toBeGreaterThan(RAYS / 20);
  });
});

describe('rays at a box, in numbers without rounding', () => {
  const box = phys2D.createPolygonShape({ vertices: phys2D.createBoxVertices(2, 2) });
  const worlds = [phys2D.createBoxTreeBroadphase(), phys2D.createSweepAndPruneBroadphase()].map((broadphase) => {
    const world = phys2D.createWorld({ broadphase });
    world.addRigidBody(phys2D.createRigidBody({ type: 'static', shapes: [box.clone()] }));
    return world;
  });

  it.each([
    ['along an edge', [-3, 1], [1, 0], 2, [-1, 0]],
    ['along an edge, upwards', [-1, 5], [0, -2], 2, [0, 1]],
    ['along an edge, just beside it', [-3, 1 + 2 ** -30], [1, 0], null, null],
    ['into a corner', [-3, -3], [1, 1], 2, null],
    ['past a corner, touching it', [-2, 0], [1, 1], 1, null],
    ['past a corner, beside it', [-2, 2 ** -30], [1, 1], null, null],
    ['from an edge, inwards', [-1, 0], [1, 0], 0, [-1, 0]],
    ['from an edge, outwards', [1, 0], [1, 0], 0, [-1, 0]],
    ['away from it', [3, 0], [1, 0], null, null],
    ['from the middle', [0, 0], [4, 0], 0.25, [-1, 0]],
    ['tiny', [-3, 0.25], [2 ** -1000, 0], 2 ** 1001, [-1, 0]],
    ['huge', [-3, 0.25], [2 ** 1000, 0], 2 ** -999, [-1, 0]],
    ['long and thin', [-3, 0], [1, 2 ** -60], 2, [-1, 0]],
  ] as [string, Vec2, Vec2, number | null, Vec2 | null][])('%s', (_, origin, direction, factor, normal) => {
    for (const world of worlds) {
      for (const maxFactor of [Infinity, 2 ** 1002]) {
        const hit = world.rayCast({ origin, direction, maxFactor });
        expect(hit && hit.factor + 0).toBe(factor);
        if (normal !== null) {
          expect(hit!.hitNormal).toEqual(normal);
        }
      }
    }
  });
});
