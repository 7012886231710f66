import { describe, expect, it } from 'vitest';
import { type CastResult, phys2D, type RigidBody, type Shape, type World } from '../../src/index.js';
import { add, addFloor, box, boxBody, disc, heavy, near, plainBody, steps, weightless } from './setting.js';

/** A world with a body of `box(1, 1)`. */
function boxed(position = [5, 0]): { world: World; body: RigidBody; shape: Shape } {
  const world = weightless();
  const body = boxBody(1, 1, { position });
  add(world, body);
  return { world, body, shape: body.shapes[0]! };
}

const along = (direction: readonly number[], maxFactor = 10, origin: readonly number[] = [0, 0]) => ({
  origin,
  direction,
  maxFactor,
});

describe('queries', () => {
  it('C-207 a point on the boundary is inside, one beyond it is not', () => {
    const { world, shape } = boxed([0, 0]);
    for (const [point, found] of [
      [[0.5, 0], [shape]],
      [[0, 0], [shape]],
      [[0.5, -0.5], [shape]],
      [[0.51, 0], []],
      [[0.50001, 0.5], []],
    ] as const) {
      const store: Shape[] = [];
      expect(world.shapePointQuery(point, store), String(point)).toBe(found.length);
      expect(store).toEqual(found);
    }
  });

  it('C-208 results overwrite the start of the store, the rest stays', () => {
    const { world, body, shape } = boxed();
    const other = plainBody({ position: [5, 5] });
    add(world, other);
    for (const query of [
      (store: Shape[]) => world.shapePointQuery([5, 0], store),
      (store: Shape[]) => world.shapeCircleQuery([5, 0], 1, store),
      (store: Shape[]) => world.shapeRectangleQuery([4, -1, 6, 1], store),
    ]) {
      const store: unknown[] = [1, 2, 3];
      expect(query(store as Shape[])).toBe(1);
      expect(store).toEqual([shape, 2, 3]);
    }
    const store: unknown[] = [1, 2, 3];
    expect(world.bodyPointQuery([5, 0], store as RigidBody[])).toBe(1);
    expect(store).toEqual([body, 2, 3]);
    expect(world.bodyPointQuery([99, 0], store as RigidBody[])).toBe(0);
    expect(store).toEqual([body, 2, 3]);
  });

  it('C-209 each shape is reported once, and each body', () => {
    const world = weightless();
    const body = phys2D.createRigidBody({ shapes: [box(1, 1), disc(0.5)] });
    add(world, body);
    const shapes: Shape[] = [];
    const bodies: RigidBody[] = [];
    expect([world.shapePointQuery([0.1, 0], shapes), world.bodyPointQuery([0.1, 0], bodies)]).toEqual([2, 1]);
    expect(new Set(shapes)).toEqual(new Set(body.shapes));
    expect(bodies).toEqual([body]);
    expect([world.shapeCircleQuery([0, 0], 3, []), world.bodyCircleQuery([0, 0], 3, [])]).toEqual([2, 1]);
    expect([world.shapeRectangleQuery([0, 0, 1, 1], []), world.bodyRectangleQuery([0, 0, 1, 1], [])]).toEqual([2, 1]);
    // At the corner of the box, the disc is not there.
    expect([world.shapePointQuery([0.49, 0.49], []), world.bodyPointQuery([0.49, 0.49], [])]).toEqual([1, 1]);
  });

  it('C-210 a circle finds what it touches', () => {
    const world = weightless();
    add(world, plainBody({ position: [3, 3] }));
    expect(world.bodyCircleQuery([4, 3], 0.5, [])).toBe(1);
    expect(world.bodyCircleQuery([4, 3], 0.4999, [])).toBe(0);
  });

  it('C-211 a rectangle finds what it touches', () => {
    const world = weightless();
    add(world, plainBody());
    expect(world.shapeRectangleQuery([0.5, -1, 2, 1], [])).toBe(1);
    expect(world.shapeRectangleQuery([0.51, -1, 2, 1], [])).toBe(0);
    // Its bounds meet the disc's, its corner does not.
    expect(world.shapeRectangleQuery([0.4, 0.4, 2, 2], [])).toBe(0);
    expect(world.shapeRectangleQuery([0.3, 0.3, 2, 2], [])).toBe(1);
  });

  it('C-212 a rectangle with swapped corners finds the same [D-30]', () => {
    const world = weightless();
    add(world, plainBody());
    for (const [minX, count] of [
      [0.5, 1],
      [0.51, 0],
    ] as const) {
      for (const corners of [
        [2, 1, minX, -1],
        [minX, 1, 2, -1],
        [2, -1, minX, 1],
      ]) {
        expect(world.shapeRectangleQuery(corners, []), String(corners)).toBe(count);
        expect(world.bodyRectangleQuery(corners, []), String(corners)).toBe(count);
      }
    }
    expect(world.shapeRectangleQuery([0.2, -1, 0.2, 1], []), 'a line').toBe(1);
    expect(world.shapeRectangleQuery([0.2, 0.2, 0.2, 0.2], []), 'a point').toBe(1);
  });

  it('C-213 queries see bodies as they were just added, moved, turned or reshaped [D-29]', () => {
    const { world, body, shape } = boxed();
    const finds = (x: number, y: number): boolean => {
      const counts = [
        world.shapePointQuery([x, y], []),
        world.bodyCircleQuery([x, y], 1e-3, []),
        world.bodyRectangleQuery([x, y, x, y], []),
        world.rayCast(along([0, 1], Infinity, [x, -50])) === null ? 0 : 1,
      ];
      expect(new Set(counts).size, String(counts)).toBe(1);
      return counts[0] === 1;
    };
    expect([finds(5, 0), finds(0, 0)]).toEqual([true, false]);
    steps(world, 1);
    body.setPosition([20, 0]);
    expect([finds(5, 0), finds(20, 0), finds(20.6, 0)]).toEqual([false, true, false]);
    body.setRotation(Math.PI / 4);
    expect(finds(20.6, 0)).toBe(true);
    shape.scale(3);
    expect(finds(22, 0)).toBe(true);
    body.removeShape(shape);
    expect(finds(20, 0)).toBe(false);
  });

  it('C-214 after a step a fast body is found where it is [D-29]', () => {
    const world = weightless();
    const body = plainBody({ velocity: [60, 0], shapes: [disc(0.1)] });
    add(world, body);
    for (let i = 0; i < 5; i += 1) {
      steps(world, 1);
      expect(world.bodyPointQuery(body.getPosition(), [])).toBe(1);
      expect(world.bodyPointQuery([body.getPosition()[0] - 0.11, 0], [])).toBe(0);
    }
  });

  it('C-215 sensors, sleeping and static bodies are found, whatever the groups', () => {
    const world = weightless();
    const asleep = plainBody();
    asleep.sleep();
    add(
      world,
      asleep,
      plainBody({ type: 'static' }),
      plainBody({ type: 'kinematic', shapes: [disc(0.5, { sensor: true })] }),
      plainBody({ shapes: [disc(0.5, { group: 0, mask: 0 })] }),
    );
    expect(asleep.sleeping).toBe(true);
    expect(world.shapePointQuery([0, 0], [])).toBe(4);
    expect(world.bodyCircleQuery([0, 0], 1, [])).toBe(4);
    expect(world.shapeRectangleQuery([0, 0, 1, 1], [])).toBe(4);
    expect(world.rayCastAll(along([1, 0], 10, [-3, 0]), false, [])).toBe(4);
    const probe = plainBody({ position: [-3, 0], velocity: [1, 0] });
    expect(world.convexCast(probe.shapes[0]!, 5)?.factor).toBeCloseTo(2, 3);
    probe.setPosition([0, 0]);
    expect(world.shapeQuery(probe.shapes[0]!, [])).toBe(4);
    expect(asleep.sleeping).toBe(true);
  });
});

describe('ray casts', () => {
  it('C-216 a hit: factor, point, normal, shape; the limit is excluded', () => {
    const { world, shape } = boxed();
    const hit = world.rayCast(along([2, 0]))!;
    expect(hit.shape).toBe(shape);
    near(hit.factor, 2.25);
    near(hit.hitPoint, [4.5, 0]);
    near(hit.hitNormal, [-1, 0]);
    expect(world.rayCast(along([2, 0], 2.25))).toBe(null);
    expect(world.rayCast(along([2, 0], 2.26))?.shape).toBe(shape);
    expect(world.rayCast(along([-2, 0]))).toBe(null);
    expect(world.rayCast(along([2, 0], 0))).toBe(null);
  });

  it('C-217 from inside it meets the far side, unless inner surfaces are ignored', () => {
    for (const shape of [box(1, 1), disc(0.5)]) {
      const world = weightless();
      add(world, phys2D.createRigidBody({ position: [5, 0], shapes: [shape] }));
      const ray = along([2, 0], 10, [4.75, 0]);
      const hit = world.rayCast(ray)!;
      near(hit.factor, 0.375);
      near(hit.hitPoint, [5.5, 0]);
      near(hit.hitNormal, [-1, 0]);
      expect(world.rayCast(ray, true)).toBe(null);
      expect(world.rayCast(along([2, 0]), true)?.factor).toBeCloseTo(2.25, 6);
    }
  });

  it('C-218 the nearer shape is reported, or the farther if a callback discards the nearer', () => {
    const { world, shape } = boxed();
    const farther = boxBody(1, 1, { position: [8, 0] });
    add(world, farther);
    expect(world.rayCast(along([1, 0]))?.shape).toBe(shape);
    const hit = world.rayCast(along([1, 0]), false, (_ray, found) => found.shape !== shape)!;
    expect(hit.shape).toBe(farther.shapes[0]);
    near(hit.factor, 7.5);
    expect(world.rayCast(along([1, 0]), false, () => false)).toBe(null);
    expect(world.rayCast(along([1, 0]), false, () => undefined as never)).toBe(null);
  });

  it('C-219 the callback gets its this, the ray, and only real hits [D-28]', () => {
    const { world, shape } = boxed();
    // In the way of the ray's bounds, not of the ray.
    add(world, plainBody({ position: [4, 2] }), plainBody({ position: [2, 1.4] }));
    const ray = along([1, 0.1], Infinity);
    const context = {};
    const seen: unknown[] = [];
    const hit = world.rayCast(
      ray,
      false,
      function (this: unknown, given, found) {
        expect(this).toBe(context);
        expect(given).toBe(ray);
        expect(Number.isFinite(found.factor)).toBe(true);
        near(found.hitPoint, [found.factor, 0.1 * found.factor]);
        near(Math.hypot(...found.hitNormal), 1);
        seen.push(found.shape, found);
        return true;
      },
      context,
    )!;
    expect(seen[0]).toBe(shape);
    expect(seen).toHaveLength(2);
    expect(hit.shape).toBe(shape);
    expect(world.rayCast(ray)).not.toBe(world.rayCast(ray));
    expect(ray).toEqual(along([1, 0.1], Infinity));
  });

  it('C-219 the returned object is not the one that the callback got, whatever becomes of that', () => {
    const { world } = boxed();
    let temporary: CastResult | undefined;
    const hit = world.rayCast(along([2, 0]), false, (_ray, found) => {
      temporary = found;
      return true;
    });
    world.rayCast(along([0, 1], 10, [5.25, -5]), false, () => true);
    near(hit!.hitPoint, [4.5, 0]);
    expect(hit).not.toBe(temporary);
  });
});

describe('convex casts', () => {
  it('C-220 a swept disc meets a box [in seconds]', () => {
    const { world, shape } = boxed();
    const body = plainBody({ velocity: [2, 0] });
    const swept = body.shapes[0]!;
    const hit = world.convexCast(swept, 5)!;
    expect(hit.shape).toBe(shape);
    near(hit.factor, 2, 1e-3);
    near(hit.hitPoint, [4.5, 0], 1e-3);
    near(hit.hitNormal, [-1, 0], 1e-6);
    expect(world.convexCast(swept, 1)).toBe(null);
    expect(world.convexCast(swept, 2.01)?.shape).toBe(shape);
    weightless().addRigidBody(body);
    expect(world.convexCast(swept, 5)).toEqual(hit);
    expect(world.convexCast(swept, 5, () => false)).toBe(null);
  });

  it('C-221 a body that has been stepped is where it was afterwards [D-26]', () => {
    const { world } = boxed();
    const body = boxBody(2, 1, { velocity: [3, 1], angularVelocity: 2, rotation: 0.3 });
    add(world, body);
    steps(world, 7);
    const state = () => [body.getPosition(), body.getRotation(), body.getVelocity(), body.getAngularVelocity()];
    const before = state();
    expect(world.convexCast(body.shapes[0]!, 5)).not.toBe(null);
    expect(state()).toEqual(before);
    expect(world.bodyPointQuery(body.getPosition(), [])).toBe(1);
  });

  it('C-222 what it overlaps or touches at the start is left out', () => {
    const { world } = boxed([0.7, 0]);
    const body = plainBody({ velocity: [2, 0] });
    expect(world.convexCast(body.shapes[0]!, 5)).toBe(null);
    body.setPosition([-0.3, 0]);
    expect(world.convexCast(body.shapes[0]!, 5), 'touching').toBe(null);
    body.setPosition([-0.4, 0]);
    expect(world.convexCast(body.shapes[0]!, 5)?.factor).toBeCloseTo(0.05, 3);
    add(world, body);
    expect(world.convexCast(body.shapes[0]!, 5)?.factor, 'its body in the world').toBeCloseTo(0.05, 3);
    body.addShape(box(0.1, 0.1));
    body.shapes[1]!.translate([0.8, 0]);
    expect(world.convexCast(body.shapes[0]!, 5)?.factor, 'another shape of its body [D-27]').toBeCloseTo(0.05, 3);
  });

  it('C-223 a long box that hits because it turns [D-26]', () => {
    const world = heavy();
    const floor = addFloor(world);
    const body = boxBody(2, 0.2, { angularVelocity: 1 });
    const hit = world.convexCast(body.shapes[0]!, 5)!;
    expect(hit.shape).toBe(floor.shapes[0]);
    // The lower corner is at the height sin(a) + 0.1 · cos(a) = 0.5.
    near(hit.factor, Math.asin(0.5 / Math.sqrt(1.01)) - Math.atan(0.1), 1e-3);
    near(hit.hitPoint[1], 0.5, 1e-3);
    near(hit.hitNormal, [0, -1], 1e-6);
    body.setAngularVelocity(0);
    expect(world.convexCast(body.shapes[0]!, 5)).toBe(null);
  });
});
