import { describe, expect, it } from 'vitest';
import { phys2D, type RigidBodyParams, type Shape, type Vec2 } from '../../src/index.js';
import { Chance, randomShape } from '../geometry/forms.js';
import { box, disc, near, weightless } from './setting.js';

const utils = phys2D.createCollisionUtils();

/** A shape of a body at a place. */
function put<T extends Shape>(shape: T, x = 0, y = 0, params: RigidBodyParams = {}): T {
  phys2D.createRigidBody({ position: [x, y], shapes: [shape], ...params });
  return shape;
}

/** Corners of a polygon in the world; those of a disc are many. */
function outline(shape: Shape): Vec2[] {
  const corners: Vec2[] = [];
  const body = shape.body!;
  const [x, y] = body.getPosition();
  const [c, s] = [Math.cos(body.getRotation()), Math.sin(body.getRotation())];
  const { vertices } = shape as unknown as { vertices: Float64Array };
  for (let i = 0; i < vertices.length; i += 2) {
    const [px, py] = [vertices[i]!, vertices[i + 1]!];
    corners.push([x + c * px - s * py, y + s * px + c * py]);
  }
  return corners;
}

/** Of a point from a segment. */
function toSegment([x, y]: Vec2, [ax, ay]: Vec2, [bx, by]: Vec2): number {
  const [dx, dy] = [bx - ax, by - ay];
  const t = Math.max(0, Math.min(1, ((x - ax) * dx + (y - ay) * dy) / (dx * dx + dy * dy)));
  return Math.hypot(x - ax - t * dx, y - ay - t * dy);
}

/** Of polygons that are apart: the least distance of any corner of one from any edge of the other. */
function bruteDistance(a: Vec2[], b: Vec2[]): number {
  const reach = (from: Vec2[], to: Vec2[]) =>
    Math.min(...from.flatMap((p) => to.map((q, i) => toSegment(p, q, to[(i + 1) % to.length]!))));
  return Math.min(reach(a, b), reach(b, a));
}

function signedDistance(a: Shape, b: Shape) {
  const [witnessA, witnessB, axis] = [[], [], []] as [number[], number[], number[]];
  const distance = utils.signedDistance(a, b, witnessA, witnessB, axis);
  near(axis[0]! ** 2 + axis[1]! ** 2, 1, 1e-12);
  near(witnessB, [witnessA[0]! + axis[0]! * distance, witnessA[1]! + axis[1]! * distance], 1e-9);
  return { distance, witnessA, witnessB, axis };
}

describe('CollisionUtils', () => {
  it('C-224 signed distance of two discs', () => {
    const { distance, witnessA, witnessB, axis } = signedDistance(put(disc(1)), put(disc(1), 3));
    near(distance, 1);
    near(witnessA, [1, 0]);
    near(witnessB, [2, 0]);
    near(axis, [1, 0]);
    const inside = signedDistance(put(disc(1)), put(disc(0.5), 0.25));
    near(inside.distance, -1.25);
    near(inside.axis, [1, 0]);
  });

  it('C-225 signed distance of two boxes that overlap, and exchanged', () => {
    const [a, b] = [put(box(1, 1)), put(box(1, 1), 0.75)];
    const there = signedDistance(a, b);
    const back = signedDistance(b, a);
    for (const { distance } of [there, back]) {
      near(distance, -0.25);
    }
    near(there.axis, [1, 0]);
    near(back.axis, [-1, 0]);
    near(back.witnessA, there.witnessB);
    near(back.witnessB, there.witnessA);
  });

  it('C-226 signed distance of polygons that are apart, by brute force [D-39]', () => {
    const chance = new Chance(226);
    let apart = 0;
    let worst = 0;
    for (let i = 0; i < 10_000; i += 1) {
      const [a, b] = [0, 1].map(() =>
        put(randomShape(chance, chance.size(0.05, 5)), chance.span(-5, 5), chance.span(-5, 5), {
          rotation: chance.span(-4, 4),
        }),
      ) as [Shape, Shape];
      if (a.type === 'CIRCLE' || b.type === 'CIRCLE') {
        continue;
      }
      const { distance } = signedDistance(a, b);
      if (distance > 0) {
        apart += 1;
        worst = Math.max(worst, Math.abs(distance - bruteDistance(outline(a), outline(b))));
      }
    }
    expect(apart).toBeGreaterThan(3000);
    expect(worst).toBeLessThan(1e-9);
  });

  it('C-227 touching intersects, a millimetre apart does not', () => {
    const pairs: [Shape, Shape, Shape][] = [
      [put(box(1, 1)), put(box(1, 1), 1), put(box(1, 1), 1.001)],
      [put(box(1, 1)), put(box(1, 1), 1, 1), put(box(1, 1), 1.001, 1.001)],
      [put(disc(0.5)), put(disc(0.5), 1), put(disc(0.5), 1.001)],
      [put(disc(2.5)), put(disc(2.5), 3, 4), put(disc(2.5), 3, 4.0013)],
      [put(box(1, 1)), put(disc(0.5), 0, 1), put(disc(0.5), 0, 1.001)],
      [put(box(1, 1), 0, 0, { rotation: Math.PI / 2 }), put(box(1, 1), 0.999), put(box(1, 1), 1.001)],
    ];
    for (const [a, touching, apart] of pairs) {
      expect([utils.intersects(a, touching), utils.intersects(touching, a)]).toEqual([true, true]);
      expect([utils.intersects(a, apart), utils.intersects(apart, a)]).toEqual([false, false]);
    }
  });

  it('C-228 the boundary contains its points', () => {
    const square = put(box(1, 1));
    expect(utils.containsPoint(square, [0.5, 0])).toBe(true);
    expect(utils.containsPoint(square, [0.500002, 0])).toBe(false);
    expect(utils.containsPoint(square, [-0.5, 0.5])).toBe(true);
    const round = put(disc(1));
    expect(utils.containsPoint(round, [1, 0])).toBe(true);
    expect(utils.containsPoint(round, [0.6, -0.8])).toBe(true);
    expect(utils.containsPoint(round, [1.000002, 0])).toBe(false);
  });

  it('C-229 a ray: factor and normal, and neither at the limit', () => {
    const square = put(box(1, 1));
    const normal = [7, 8];
    const ray = { origin: [-2, 0], direction: [1, 0], maxFactor: 1.5 };
    expect(utils.rayTest(square, ray, normal)).toBe(undefined);
    expect(normal).toEqual([7, 8]);
    near(utils.rayTest(square, { ...ray, maxFactor: 10 }, normal)!, 1.5);
    near(normal, [-1, 0]);
    const inner = { ...ray, origin: [0, 0] };
    near(utils.rayTest(square, inner, normal)!, 0.5);
    near(normal, [-1, 0]);
    expect(utils.rayTest(square, inner, normal, true)).toBe(undefined);
    near(utils.rayTest(put(disc(1), 3, 0.6), { ...ray, maxFactor: Infinity }, normal)!, 4.2);
    near(normal, [-0.8, -0.6]);
  });

  it('C-230 a sweep: time, normal and point', () => {
    const a = put(box(1, 1), -3, 0, { velocity: [2, 0] });
    const b = put(box(1, 1));
    const [point, normal] = [
      [7, 8],
      [7, 8],
    ];
    expect(utils.sweepTest(a, b, 0.5, point, normal)).toBe(undefined);
    expect([point, normal]).toEqual([
      [7, 8],
      [7, 8],
    ]);
    near(utils.sweepTest(a, b, 5, point, normal)!, 1, 1e-3);
    near(normal, [1, 0]);
    near(point[0]!, -0.5, 1e-3);
    near(utils.sweepTest(b, a, 5, point, normal)!, 1, 1e-3);
    near(normal, [-1, 0]);
    b.body!.setVelocity([-2, 0]);
    near(utils.sweepTest(a, b, 5, point, normal)!, 0.5, 1e-3);
    near(point[0]!, -1.5, 1e-3);
  });

  it('C-231 a sweep of shapes that overlap or touch is 0, and moves nothing', () => {
    const motion: RigidBodyParams = { velocity: [3, 4], angularVelocity: 5, rotation: 0.5 };
    const a = put(box(1, 1), -0.25, 0, motion);
    const b = put(box(1, 1), 0.5, 0, motion);
    const state = () =>
      [a, b].map(({ body }) => [body!.getPosition(), body!.getRotation(), body!.getVelocity(), body!.sleeping]);
    const before = state();
    expect(utils.sweepTest(a, b, 1, [], [])).toBe(0);
    expect(state()).toEqual(before);
    expect(utils.sweepTest(put(disc(1)), put(disc(1), 2), 1, [], [])).toBe(0);
    const far = put(box(1, 1), 4, 0, { velocity: [-9, 4], angularVelocity: -5 });
    expect(utils.sweepTest(a, far, 1, [], [])).toBeGreaterThan(0);
    expect(state()).toEqual(before);
  });

  it('C-232 all see a body where it was just put, in a world or not', () => {
    for (const world of [null, weightless()]) {
      const [a, b] = [put(box(1, 1)), put(disc(0.5), 9, 9)];
      world?.addRigidBody(a.body!);
      world?.addRigidBody(b.body!);
      world?.step(1 / 60);
      a.body!.setPosition([5, 0]);
      a.body!.setRotation(Math.PI / 4);
      b.body!.setPosition([5, 3]);
      const tip = Math.SQRT1_2;
      expect(utils.containsPoint(a, [5 + tip - 1e-3, 0])).toBe(true);
      expect(utils.containsPoint(a, [0, 0])).toBe(false);
      const { distance, witnessA } = signedDistance(a, b);
      near(distance, 2.5 - tip);
      near(witnessA, [5, tip]);
      expect(utils.intersects(a, b)).toBe(false);
      near(utils.rayTest(a, { origin: [0, 0], direction: [1, 0], maxFactor: 9 }, [])!, 5 - tip);
      b.body!.setVelocity([0, -1]);
      near(utils.sweepTest(a, b, 9, [], [])!, 2.5 - tip);
      b.scale(2);
      near(signedDistance(a, b).distance, 2 - tip);
    }
  });
});
