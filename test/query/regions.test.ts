import { describe, expect, it } from 'vitest';
import { phys2D, type RectLike, type RigidBody, type Shape, type Vec2, type World } from '../../src/index.js';
import { add, box, disc, plainBody, weightless } from '../conformance/setting.js';
import { Chance } from '../geometry/forms.js';
import type { Form } from '../geometry/reference.js';
import { indices, Scene } from './scene.js';

const EACH = 600;
const EXTENT = 20;

const chance = new Chance(207);
const scene = new Scene(chance, 150, EXTENT);

const disk = ([x, y]: Vec2, radius: number): Form => ({ corners: Float64Array.of(x, y), radius });
const anywhere = (): Vec2 => [chance.span(-2, EXTENT + 2), chance.span(-2, EXTENT + 2)];

/** On the boundary of something, or near it, or anywhere. */
function somewhere(): Vec2 {
  const [p, q] = scene.randomEdge();
  const share = chance.next();
  const off = chance.next() < 0.5 ? 0 : chance.span(-0.01, 0.01);
  const point: Vec2 = [p[0] + share * (q[0] - p[0]) + off, p[1] + share * (q[1] - p[1])];
  return chance.next() < 0.5 ? point : anywhere();
}

function compare(
  what: string,
  form: Form,
  tolerance: number,
  shapeQuery: (world: World, store: Shape[]) => number,
  bodyQuery?: (world: World, store: RigidBody[]) => number,
): number {
  const { sure, unsure } = scene.meeting(form, tolerance);
  for (const world of scene.worlds) {
    const shapes: Shape[] = [];
    expect(shapeQuery(world, shapes), what).toBe(shapes.length);
    const found = indices(shapes);
    expect(new Set(found).size, `${what}: a shape twice`).toBe(found.length);
    expect(
      found.filter((index) => !sure.has(index) && !unsure.has(index)),
      `${what}: found too much`,
    ).toEqual([]);
    expect(
      [...sure].filter((index) => !found.includes(index)),
      `${what}: missing`,
    ).toEqual([]);
    const bodies: RigidBody[] = [];
    if (bodyQuery !== undefined) {
      expect(bodyQuery(world, bodies), what).toBe(bodies.length);
      expect(new Set(bodies), what).toEqual(new Set(shapes.map(({ body }) => body)));
      expect(new Set(bodies).size, `${what}: a body twice`).toBe(bodies.length);
    }
  }
  return sure.size;
}

describe('regions of random size in a random scene, with both broadphases, by a loop over all shapes', () => {
  it(`${EACH} points`, () => {
    let found = 0;
    for (let i = 0; i < EACH; i += 1) {
      const point = somewhere();
      found += compare(
        `point ${point}`,
        disk(point, 0),
        2e-6,
        (world, store) => world.shapePointQuery(point, store),
        (world, store) => world.bodyPointQuery(point, store),
      );
    }
    expect(found).toBeGreaterThan(EACH / 4);
  });

  it(`${EACH} circles`, () => {
    for (let i = 0; i < EACH; i += 1) {
      const center = somewhere();
      const radius = chance.size(1e-9, 1e6);
      compare(
        `circle ${center}, ${radius}`,
        disk(center, radius),
        1e-9 * Math.max(1, radius),
        (world, store) => world.shapeCircleQuery(center, radius, store),
        (world, store) => world.bodyCircleQuery(center, radius, store),
      );
    }
  });

  it(`${EACH} rectangles, some without width or height, with corners in any order`, () => {
    for (let i = 0; i < EACH; i += 1) {
      const [x, y] = somewhere();
      const [w, h] = [chance, chance].map(() => (chance.next() < 0.1 ? 0 : chance.size(1e-6, 1e4)));
      const rectangle: RectLike = chance.next() < 0.5 ? [x, y, x + w!, y + h!] : [x + w!, y, x, y + h!];
      compare(
        `rectangle ${rectangle}`,
        { corners: rectangleCorners(x, y, x + w!, y + h!), radius: 0 },
        1e-9 * Math.max(1, w!, h!),
        (world, store) => world.shapeRectangleQuery(rectangle, store),
        (world, store) => world.bodyRectangleQuery(rectangle, store),
      );
    }
  });

  it(`${EACH} shapes, of bodies in the world and out of it`, () => {
    for (let i = 0; i < EACH; i += 1) {
      const index = chance.index(scene.forms.length);
      const own = scene.shapes[0]![index]!.body!;
      const inWorld = chance.next() < 0.5;
      const probe = phys2D.createRigidBody({ position: somewhere(), rotation: chance.span(-9, 9) });
      const clone = scene.shapes[0]![index]!.clone();
      probe.addShape(clone);
      const form = scene.formOf(index, inWorld ? own : probe);
      const { sure, unsure } = scene.meeting(form, 1e-9);
      for (const [w, world] of scene.worlds.entries()) {
        const shape = inWorld ? scene.shapes[w]![index]! : clone;
        const store: Shape[] = [];
        expect(world.shapeQuery(shape, store)).toBe(store.length);
        const found = indices(store);
        const wanted = [...sure].filter((k) => !(inWorld && scene.shapes[0]![k]!.body === own));
        expect(wanted.filter((k) => !found.includes(k))).toEqual([]);
        expect(found.filter((k) => !wanted.includes(k) && !unsure.has(k))).toEqual([]);
        expect(store.some(({ body }) => body === shape.body)).toBe(false);
      }
    }
  });
});

function rectangleCorners(minX: number, minY: number, maxX: number, maxY: number): Float64Array {
  // Without width or height its edges have no normals, but two points or one tell as much.
  if (minX === maxX && minY === maxY) {
    return Float64Array.of(minX, minY);
  }
  if (minX === maxX || minY === maxY) {
    return Float64Array.of(minX, minY, maxX, maxY);
  }
  return Float64Array.of(minX, minY, maxX, minY, maxX, maxY, minX, maxY);
}

describe('regions without end, and empty worlds', () => {
  const all = scene.forms.length;

  it('an infinite circle or rectangle finds everything', () => {
    for (const world of scene.worlds) {
      for (const count of [
        world.shapeCircleQuery([0, 0], Infinity, []),
        world.shapeCircleQuery([1e9, -1e9], 1e300, []),
        world.shapeRectangleQuery([-Infinity, -Infinity, Infinity, Infinity], []),
        world.shapeRectangleQuery([Infinity, Infinity, -Infinity, -Infinity], []),
        world.shapeRectangleQuery([-1e300, -1e300, 1e300, 1e300], []),
      ]) {
        expect(count).toBe(all);
      }
      expect(world.bodyCircleQuery([0, 0], Infinity, [])).toBe(150);
      expect(world.bodyRectangleQuery([-Infinity, -Infinity, Infinity, Infinity], [])).toBe(150);
    }
  });

  it('half a plane, a quarter, a strip', () => {
    const huge = 1e7;
    for (const [minX, minY, maxX, maxY] of [
      [-Infinity, -Infinity, 10, Infinity],
      [10, -Infinity, Infinity, Infinity],
      [-Infinity, 7, Infinity, Infinity],
      [-Infinity, -Infinity, 5, 5],
      [-Infinity, 5, Infinity, 5.5],
      [8, -Infinity, 8, Infinity],
    ] as const) {
      const [x1, y1, x2, y2] = [minX, minY, maxX, maxY].map((x) => Math.max(-huge, Math.min(huge, x)));
      const form = { corners: rectangleCorners(x1!, y1!, x2!, y2!), radius: 0 };
      const rectangle = [minX, minY, maxX, maxY];
      const found = compare(`${rectangle}`, form, 1e-6, (world, store) => world.shapeRectangleQuery(rectangle, store));
      expect(found).toBeGreaterThan(5);
      expect(found).toBeLessThan(all);
    }
  });

  it('points, circles and rectangles far away find nothing', () => {
    for (const world of scene.worlds) {
      expect(world.shapePointQuery([1e300, -1e300], [])).toBe(0);
      expect(world.shapeCircleQuery([1e300, 0], 1e200, [])).toBe(0);
      expect(world.shapeRectangleQuery([1e300, 0, Infinity, 1], [])).toBe(0);
      expect(world.shapeRectangleQuery([Infinity, 0, Infinity, 1], [])).toBe(0);
    }
  });

  it('an empty world has nothing to find', () => {
    const world = weightless();
    const probe = plainBody({ velocity: [1, 0] }).shapes[0]!;
    const ray = { origin: [0, 0], direction: [1, 0], maxFactor: Infinity };
    expect(world.shapePointQuery([0, 0], [])).toBe(0);
    expect(world.bodyCircleQuery([0, 0], Infinity, [])).toBe(0);
    expect(world.bodyRectangleQuery([0, 0, 1, 1], [])).toBe(0);
    expect(world.shapeQuery(probe, [])).toBe(0);
    expect(world.rayCastAll(ray, false, [])).toBe(0);
    expect(world.rayCast(ray)).toBe(null);
    expect(world.convexCast(probe, 1)).toBe(null);
  });

  it('touching counts, for shapes too', () => {
    const world = weightless();
    add(world, phys2D.createRigidBody({ shapes: [box(1, 1)] }), plainBody({ position: [3, 0] }));
    const probe = phys2D.createRigidBody({ shapes: [box(2, 1)], position: [1.5, 0] });
    expect(world.shapeQuery(probe.shapes[0]!, [])).toBe(2);
    probe.setPosition([1.5, 1]);
    expect(world.shapeQuery(probe.shapes[0]!, []), 'corner to corner').toBe(1);
    probe.setPosition([1.5001, 1]);
    expect(world.shapeQuery(probe.shapes[0]!, [])).toBe(0);
    probe.addShape(disc(1));
    probe.setPosition([-1.5, 0]);
    expect(world.shapeQuery(probe.shapes[1]!, [])).toBe(1);
  });
});
