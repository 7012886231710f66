import { describe, expect, it } from 'vitest';
import { Distance, measureDistance } from '../../src/geometry/distance.js';
import { Outline } from '../../src/geometry/outline.js';
import { phys2D, type Shape, type Vec2 } from '../../src/index.js';
import { near } from '../conformance/setting.js';
import { Chance, formOf } from './forms.js';
import { measure } from './random-pairs.js';
import { exactDistance, type Form, gapAlong, signedDistance } from './reference.js';
import { expectRight } from './right.js';

/** Few, in this process; many.test.ts takes a million. */
const PAIRS = 2000;

function form(radius: number, ...corners: number[]): Form {
  return { corners: Float64Array.from(corners), radius };
}

interface Placed {
  outline: Outline;
  form: Form;
}

function place(shape: Shape, [x, y]: Vec2, angle = 0): Placed {
  const outline = new Outline();
  shape.outline(outline.put(x, y, Math.cos(angle), Math.sin(angle)));
  return { outline, form: formOf(outline) };
}

function measureOne(a: Placed, b: Placed): { out: Distance; forms: [Form, Form] } {
  const out = new Distance();
  measureDistance(a.outline, b.outline, out);
  return { out, forms: [a.form, b.form] };
}

const box = (width: number, height: number): Shape =>
  phys2D.createPolygonShape({ vertices: phys2D.createBoxVertices(width, height) });
const disc = (radius: number): Shape => phys2D.createCircleShape({ radius });
const triangle = phys2D.createPolygonShape({
  vertices: [
    [0, 0],
    [3, -1],
    [2, 1],
  ],
});

describe('the references', () => {
  const square = form(0, -0.5, -0.5, 0.5, -0.5, 0.5, 0.5, -0.5, 0.5);
  const moved = (x: number, y: number): Form => ({
    ...square,
    corners: square.corners.map((c, i) => c + (i % 2 ? y : x)),
  });

  it.each([
    ['side by side', square, moved(1.5, 0.25), 0.5],
    ['corner to corner', square, moved(4, 5), 5],
    ['touching', square, moved(1, 1), 0],
    ['overlapping', square, moved(0.75, 0.125), -0.25],
    ['the same twice', square, square, -1],
    ['a disc over an edge', square, form(0.25, 0.125, 2), 1.25],
    ['a disc off a corner', form(0.5, 3.5, 4.5), square, 4.5],
    ['a disc within', square, form(0.25, 0.25, 0), -0.5],
    ['a disc on a corner', square, form(0.25, 0.5, 0.5), -0.25],
    ['two discs', form(1, 0, 0), form(2, 3, 4), 2],
    ['one disc in the middle of another', form(1, 3, 4), form(2, 3, 4), -3],
  ])('know %s', (_, a, b, distance) => {
    expect(exactDistance(a, b)).toBe(distance);
    expect(exactDistance(b, a)).toBe(distance);
    expect(signedDistance(a, b)).toBe(distance);
    expect(signedDistance(b, a)).toBe(distance);
  });
});

describe('distance', () => {
  it(`of ${PAIRS} random pairs is that of the references`, () => {
    expectRight(measure(PAIRS, 2), PAIRS);
  });

  // Where a corner lies on a corner, the way from one to the other is nothing but rounding, and has no direction.
  it.each([
    ['a disc on the corner of a box', box(1, 1), disc(0.5), 0],
    ['boxes corner to corner', box(1, 1), box(1, 1), Math.PI],
    ['a triangle on the corner of a box', box(1, 1), triangle, 3],
  ])('has an axis that separates for %s, however turned', (_, a, b, turn) => {
    for (let i = 0; i < 1000; i += 1) {
      const corner = place(a, [(i % 10) / 10, 0], i).form.corners;
      const tip = place(b, [0, 0], i + turn).form.corners;
      const at: Vec2 = [corner[0]! - tip[0]!, corner[1]! - tip[1]!];
      const { out, forms } = measureOne(place(a, [(i % 10) / 10, 0], i), place(b, at, i + turn));
      const [p, q] = forms;
      near(gapAlong(p.corners, q.corners, out.axisX, out.axisY) - q.radius, out.value, 1e-12);
    }
  });

  it('puts the witnesses in the middle of what parallel edges share', () => {
    const { out } = measureOne(place(box(4, 1), [0, 0]), place(box(1, 1), [1, 2]));
    expect([out.value, out.axisX, out.axisY]).toEqual([1, 0, 1]);
    expect([out.ax, out.ay, out.bx, out.by]).toEqual([1, 0.5, 1, 1.5]);
  });

  it('of discs around one point is along the x-axis', () => {
    const { out } = measureOne(place(disc(1), [2, 3]), place(disc(0.5), [2, 3]));
    expect([out.value, out.axisX, out.axisY]).toEqual([-1.5, 1, 0]);
    expect([out.ax, out.ay, out.bx, out.by]).toEqual([3, 3, 1.5, 3]);
  });

  // Which of the edges is the farthest is then a matter of rounding, and the corner may lie beside that one.
  it('is right where a corner lies above two edges that bend by next to nothing', () => {
    const chance = new Chance(1);
    for (let i = 0; i < 500; i += 1) {
      const bend = chance.size(1e-9, 1e-6);
      const blunt = phys2D.createPolygonShape({
        vertices: [
          [2, 3],
          [3, 3 - bend],
          [4, 3],
          [3, 4],
        ],
      });
      const beside = (chance.next() < 0.5 ? -1 : 1) * chance.size(1e-9, 1e-5);
      const [x, y] = [3 + beside, 3 - bend - chance.size(1e-11, 1e-7)];
      const sharp = phys2D.createPolygonShape({
        vertices: [
          [x, y],
          [x - 0.5, y - 1],
          [x + 0.5, y - 1],
        ],
      });
      const turn = chance.span(0, 6);
      const pair = [place(blunt, [0, 0], turn), place(sharp, [0, 0], turn)] as const;
      for (const [a, b] of [pair, [pair[1], pair[0]] as const]) {
        const { out, forms } = measureOne(a, b);
        near(out.value, signedDistance(...forms), 1e-13);
        near(gapAlong(forms[0].corners, forms[1].corners, out.axisX, out.axisY), out.value, 1e-13);
        near([out.ax + out.axisX * out.value, out.ay + out.axisY * out.value], [out.bx, out.by], 1e-13);
        const tip = a === pair[1] ? [out.ax, out.ay] : [out.bx, out.by];
        near(tip, [...pair[1].form.corners.subarray(0, 2)], 1e-13);
      }
    }
  });

  it('takes outlines of many corners', () => {
    const vertices = phys2D.createRegularPolygonVertices(2, 2, 500);
    const round = phys2D.createPolygonShape({ vertices });
    const { out, forms } = measureOne(place(round, [0, 0]), place(round, [2.5, 0.1], 1));
    near(out.value, signedDistance(...forms), 1e-12);
  });
});

describe('needles', () => {
  it.each([
    [1e6, 2, 0.1],
    [1e5, 2, 5e-3],
    [1e3, 2e-3, 1e-3],
    [1e3, 2e-2, 1e-4],
  ])('of %d m by %d m, whose tips are %d m apart, are as far apart', (length, width, gap) => {
    const needle = (x: number, to: number) =>
      phys2D.createRigidBody({
        shapes: [
          phys2D.createPolygonShape({
            vertices: [
              [x, 0],
              [to, -width / 2],
              [to, width / 2],
            ],
          }),
        ],
      });
    const [a, b] = [needle(0, -length), needle(gap, gap + length)];
    const utils = phys2D.createCollisionUtils();
    const [onA, onB, axis]: [number[], number[], number[]] = [[], [], []];
    expect(utils.signedDistance(a.shapes[0]!, b.shapes[0]!, onA, onB, axis)).toBeCloseTo(gap, 12);
    expect([...onA, ...onB, ...axis]).toEqual([0, 0, gap, 0, 1, 0]);
    const disc = phys2D.createRigidBody({
      position: [gap, 0],
      shapes: [phys2D.createCircleShape({ radius: gap / 2 })],
    });
    expect(utils.intersects(a.shapes[0]!, disc.shapes[0]!)).toBe(false);
    expect(utils.signedDistance(disc.shapes[0]!, a.shapes[0]!, onA, onB, axis)).toBeCloseTo(gap / 2, 12);
  });
});
