import { describe, expect, it } from 'vitest';
import { Along, collideAlong, reachAlong, roundness, separationAlong } from '../../src/collide/along.js';
import * as g from '../../src/collide/layout.js';
import { reset } from '../../src/collide/manifold.js';
import { intersect } from '../../src/collide/table.js';
import { Outline } from '../../src/geometry/outline.js';
import { phys2D, type Shape } from '../../src/index.js';
import { near } from '../conformance/setting.js';
import { Chance, formOf, randomShape } from '../geometry/forms.js';
import { type Form, gapAlong, signedDistance } from '../geometry/reference.js';

// What is asked of one or two placed shapes, against plain geometry.

const utils = phys2D.createCollisionUtils();
/** m. The shapes are about a metre large. */
const CLOSE = 1e-9;

/** A shape of a body at a place, and its form in the world. */
interface Placed {
  shape: Shape;
  x: number;
  y: number;
  form: Form;
}

function place(shape: Shape, x: number, y: number, rotation: number): Placed {
  const body = phys2D.createRigidBody({ position: [x, y], rotation, shapes: [shape] });
  body.place();
  const outline = new Outline().put(x, y, Math.cos(rotation), Math.sin(rotation));
  shape.outline(outline);
  return { shape, x, y, form: formOf(outline) };
}

/** A random shape of a body somewhere. */
const put = (chance: Chance): Placed =>
  place(randomShape(chance, 1), chance.span(-1, 1), chance.span(-1, 1), chance.span(-4, 4));

const box = (): Shape => phys2D.createPolygonShape({ vertices: phys2D.createBoxVertices(1, 1) });

const pointAt = (x: number, y: number): Form => ({ corners: Float64Array.of(x, y), radius: 0 });

/** The record of a pair. */
function recordOf(a: Placed, b: Placed): Float64Array {
  const numbers = new Float64Array(g.PAIR_NUMBERS);
  reset(numbers, 0);
  numbers.set([b.x - a.x, b.y - a.y, a.shape.body!.getRotation(), b.shape.body!.getRotation()]);
  return numbers;
}

function directionOf(chance: Chance): [number, number] {
  const angle = chance.span(0, 2 * Math.PI);
  return [Math.cos(angle), Math.sin(angle)];
}

describe('two shapes', () => {
  it('intersect if they are no distance apart, and the record of the pair shows no points', () => {
    const chance = new Chance(1);
    const found = { together: 0, apart: 0 };
    for (let i = 0; i < 1000; i += 1) {
      const [a, b] = [put(chance), put(chance)];
      const truth = signedDistance(a.form, b.form);
      if (Math.abs(truth) < CLOSE) {
        continue;
      }
      const numbers = recordOf(a, b);
      // What was found before is looked at first, and changes nothing.
      for (let again = 0; again < 2; again += 1) {
        expect(intersect(a.shape, b.shape, numbers, 0)).toBe(truth < 0);
        expect([numbers[g.COUNT], numbers[g.NX], numbers[g.NY]]).toEqual([0, 0, 0]);
      }
      found[truth < 0 ? 'together' : 'apart'] += 1;
    }
    expect(Math.min(found.together, found.apart)).toBeGreaterThan(100);
  });

  it('that touch intersect', () => {
    const pairs = [
      [box(), [1, 0]],
      [box(), [1, 1]],
      [box(), [0, -1]],
      [phys2D.createCircleShape({ radius: 0.5 }), [-1, 0]],
    ] as const;
    for (const [shape, at] of pairs) {
      const [a, b] = [place(box(), 0, 0, 0), place(shape, at[0], at[1], 0)];
      expect(intersect(a.shape, b.shape, recordOf(a, b), 0)).toBe(true);
      expect(intersect(b.shape, a.shape, recordOf(b, a), 0)).toBe(true);
    }
  });

  it('that are apart along a direction and lie beside each other have no points there', () => {
    const [a, b] = [place(box(), 0, 0, 0), place(box(), 0.9, 0.5, 0)];
    const numbers = recordOf(a, b);
    numbers.set([1, 0], g.NX);
    collideAlong(a.shape, b.shape, numbers, 0);
    expect(numbers[g.COUNT]).toBe(2);
    numbers.set([1.001, 5]);
    collideAlong(a.shape, b.shape, numbers, 0);
    expect(numbers[g.COUNT]).toBe(0);
  });

  it('have an axis without negative zeros', () => {
    const [a, b] = [place(box(), 0, 0, 0), place(box(), -3, 0, 0)];
    const axis = [7, 8];
    expect(utils.signedDistance(a.shape, b.shape, [], [], axis)).toBe(2);
    expect(axis).toEqual([-1, 0]);
    utils.signedDistance(b.shape, a.shape, [], [], axis);
    expect(axis).toEqual([1, 0]);
  });

  it('are as far apart along a direction as their corners are', () => {
    const chance = new Chance(2);
    for (let i = 0; i < 300; i += 1) {
      const [a, b] = [put(chance), put(chance)];
      const [nx, ny] = directionOf(chance);
      const gap = gapAlong(a.form.corners, b.form.corners, nx, ny) - a.form.radius - b.form.radius;
      const along = Object.assign(new Along(), { x: nx, y: ny, dx: b.x - a.x, dy: b.y - a.y });
      separationAlong(a.shape, b.shape, along);
      near(along.found, gap, CLOSE);
      for (const sign of [1, -1]) {
        reachAlong(a.shape, along, sign);
        const reach = -gapAlong(a.form.corners, Float64Array.of(a.x, a.y), sign * nx, sign * ny) + a.form.radius;
        near(along.found, reach, CLOSE);
      }
    }
  });

  it('one of them round, meet along a direction in the middle between their surfaces, under the centre', () => {
    const chance = new Chance(3);
    let met = 0;
    for (let i = 0; i < 1000; i += 1) {
      const [a, b] = [put(chance), put(chance)];
      if (a.shape.type === 'POLYGON' && b.shape.type === 'POLYGON') {
        continue;
      }
      const [nx, ny] = directionOf(chance);
      const numbers = recordOf(a, b);
      numbers.set([nx, ny], g.NX);
      collideAlong(a.shape, b.shape, numbers, 0);
      const point = Float64Array.of(a.x + numbers[g.X0]!, a.y + numbers[g.Y0]!);
      const separation = gapAlong(a.form.corners, b.form.corners, nx, ny) - a.form.radius - b.form.radius;
      expect(numbers[g.COUNT]).toBe(1);
      near([numbers[g.S0]!, numbers[g.NX]!, numbers[g.NY]!], [separation, nx, ny], CLOSE);
      near(gapAlong(a.form.corners, point, nx, ny) - a.form.radius, separation / 2, CLOSE);
      near(gapAlong(point, b.form.corners, nx, ny) - b.form.radius, separation / 2, CLOSE);
      const [cx, cy] = (a.shape.type === 'POLYGON' ? b : a).form.corners;
      near(nx * (point[1]! - cy!), ny * (point[0]! - cx!), CLOSE);
      met += 1;
    }
    expect(met).toBeGreaterThan(100);
  });

  it('have arms that do not turn with them as far as they are round', () => {
    const disc = phys2D.createCircleShape({ radius: 2 });
    expect([roundness(disc, -0.5), roundness(box(), -0.5)]).toEqual([1.75, 0]);
  });
});

describe('a shape', () => {
  it('contains the points that are no distance from it', () => {
    const chance = new Chance(4);
    for (let i = 0; i < 2000; i += 1) {
      const { shape, form, x, y } = put(chance);
      const point = [x + chance.span(-1, 1), y + chance.span(-1, 1)] as const;
      const truth = signedDistance(form, pointAt(...point));
      if (Math.abs(truth) > 1e-5) {
        expect(utils.containsPoint(shape, point)).toBe(truth < 0);
      }
    }
  });

  it('is met by a ray where that first comes to its surface, with the normal there', () => {
    const chance = new Chance(5);
    const found = { outer: 0, inner: 0, missed: 0 };
    for (let i = 0; i < 1500; i += 1) {
      const { shape, form, x, y } = put(chance);
      const far = chance.next() < 0.5 ? 0.2 : 1.5;
      const origin = [x + chance.span(-far, far), y + chance.span(-far, far)] as const;
      const target = [x + chance.span(-0.6, 0.6), y + chance.span(-0.6, 0.6)] as const;
      const size = chance.size(0.01, 100);
      const [dx, dy] = [size * (target[0] - origin[0]), size * (target[1] - origin[1])];
      const at = (f: number): number => signedDistance(form, pointAt(origin[0] + f * dx, origin[1] + f * dy));
      const normal = [7, 8];
      const ray = { origin, direction: [dx, dy], maxFactor: 3 / size } as const;
      const start = at(0);
      if (Math.abs(start) < CLOSE) {
        continue;
      }
      const factor = utils.rayTest(shape, ray, normal);
      if (factor === undefined) {
        expect(normal).toEqual([7, 8]);
        for (let k = 0; k <= 30; k += 1) {
          const distance = at((k / 30) * ray.maxFactor);
          expect(start > 0 ? distance > -CLOSE : distance < CLOSE).toBe(true);
        }
        found.missed += 1;
        continue;
      }
      expect(factor).toBeGreaterThanOrEqual(0);
      expect(factor).toBeLessThan(ray.maxFactor);
      near(at(factor), 0, CLOSE);
      for (let k = 0; k < 10; k += 1) {
        const distance = at((k / 10) * factor);
        expect(start > 0 ? distance > -CLOSE : distance < CLOSE).toBe(true);
      }
      const [nx, ny] = normal as [number, number];
      near(nx * nx + ny * ny, 1, CLOSE);
      expect(nx * dx + ny * dy).toBeLessThanOrEqual(CLOSE * size);
      // The shape lies wholly on one side of the line through the point.
      const side = start > 0 ? 1 : -1;
      const point = Float64Array.of(origin[0] + factor * dx, origin[1] + factor * dy);
      near(gapAlong(form.corners, point, side * nx, side * ny) - form.radius, 0, CLOSE);
      expect(utils.rayTest(shape, ray, normal, true)).toBe(start > 0 ? factor : undefined);
      expect(utils.rayTest(shape, { ...ray, maxFactor: factor }, normal)).toBe(undefined);
      found[start > 0 ? 'outer' : 'inner'] += 1;
    }
    expect(Math.min(...Object.values(found))).toBeGreaterThan(100);
  });
});
