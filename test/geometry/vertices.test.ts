import { describe, expect, it } from 'vitest';
import { COLLINEAR_TOLERANCE, VERTEX_TOLERANCE } from '../../src/config.js';
import { convexVertices, repeatedVertex } from '../../src/geometry/vertices.js';
import { phys2D, type Vec2 } from '../../src/index.js';

const clean = (vertices: unknown): number[] => convexVertices('f', vertices);

describe('vertices of', () => {
  it('a box are clockwise from the upper left', () => {
    expect(phys2D.createBoxVertices(2, 6)).toEqual([
      [-1, -3],
      [1, -3],
      [1, 3],
      [-1, 3],
    ]);
  });

  it('a rectangle too, from two corners in any order', () => {
    const wanted = [
      [1, 2],
      [4, 2],
      [4, 7],
      [1, 7],
    ];
    for (const corners of [
      [1, 2, 4, 7],
      [4, 7, 1, 2],
      [1, 7, 4, 2],
      [4, 2, 1, 7],
    ] as [number, number, number, number][]) {
      expect(phys2D.createRectangleVertices(...corners)).toEqual(wanted);
    }
  });

  it('a rectangle are refused if it has no width or no height, or a corner is no number', () => {
    expect(() => phys2D.createRectangleVertices(3, 0, 3, 2)).toThrow('x2 must differ from x1, got 3 for both');
    expect(() => phys2D.createRectangleVertices(0, 3, 2, 3)).toThrow('y2 must differ from y1, got 3 for both');
    ['x1', 'y1', 'x2', 'y2'].forEach((name, i) => {
      const corners = [0, 0, 1, 1].map((x, k) => (k === i ? Number.NaN : x)) as [number, number, number, number];
      expect(() => phys2D.createRectangleVertices(...corners)).toThrow(`createRectangleVertices: ${name} must be`);
    });
  });

  it('a regular polygon lie on its ellipse, clockwise from the x-axis', () => {
    for (const count of [3, 4, 7]) {
      const vertices = phys2D.createRegularPolygonVertices(4, 10, count);
      expect(vertices).toHaveLength(count);
      vertices.forEach(([x, y], k) => {
        expect(x).toBeCloseTo(2 * Math.cos((2 * Math.PI * k) / count), 12);
        expect(y).toBeCloseTo(5 * Math.sin((2 * Math.PI * k) / count), 12);
      });
    }
  });
});

describe('a convex polygon', () => {
  const square = [0, 0, 2, 0, 2, 2, 0, 2];
  const pairs = (flat: readonly number[]): Vec2[] =>
    Array.from({ length: flat.length / 2 }, (_, i) => [flat[2 * i]!, flat[2 * i + 1]!]);

  it('is taken as it is, wherever it starts', () => {
    for (let i = 0; i < 4; i += 1) {
      const turned = [...square.slice(2 * i), ...square.slice(0, 2 * i)];
      expect(clean(pairs(turned))).toEqual(turned);
    }
  });

  it('is taken from anything like a list', () => {
    const vertices = { length: 3, 0: [0, 0], 1: new Float32Array([3, 0]), 2: { length: 2, 0: 0, 1: 3 } };
    expect(clean(vertices)).toEqual([0, 0, 3, 0, 0, 3]);
    for (const bad of [null, undefined, 3, 'abc', {}, { length: '3' }]) {
      expect(() => clean(bad)).toThrow('f: vertices must be an array of vertices [x, y]');
    }
  });

  it('is turned round if it is counter-clockwise', () => {
    expect(clean(pairs(square).reverse())).toEqual(square);
    expect(clean(pairs([0, 0, 0, 3, 3, 0]))).toEqual([3, 0, 0, 3, 0, 0]);
  });

  it('loses the vertices inside its edges, on whichever side', () => {
    const between = [0, 0, 1, 0, 2, 0, 2, 1, 2, 2, 1, 2, 0, 2, 0, 1];
    for (let i = 0; i < 8; i += 1) {
      const turned = pairs([...between.slice(2 * i), ...between.slice(0, 2 * i)]);
      const kept = turned.filter(([x, y]) => x !== 1 && y !== 1);
      expect(clean(turned)).toEqual(kept.flat());
    }
  });

  it('keeps a corner that bends by more than the tolerance, and loses one that bends by less', () => {
    // The bend at (1, −h) between two edges of length 1 is 2h.
    const tip = (h: number): Vec2[] => pairs([0, 0, 1, -h, 2, 0, 1, 1]);
    expect(clean(tip(COLLINEAR_TOLERANCE))).toHaveLength(8);
    expect(clean(tip(COLLINEAR_TOLERANCE / 4))).toHaveLength(6);
    expect(clean(tip(-COLLINEAR_TOLERANCE / 4))).toHaveLength(6);
    expect(() => clean(tip(-COLLINEAR_TOLERANCE))).toThrow('vertex 1 bending the other way');
  });

  it('is refused with the vertex that bends the other way, as the caller counts', () => {
    const dent = pairs([0, 0, 4, 0, 4, 4, 3, 1]);
    expect(() => clean(dent)).toThrow(
      'f: vertices must go once around a convex polygon, got vertex 3 bending the other way',
    );
    expect(() => clean(dent)).toThrow('[3, 1]');
    expect(() => clean([...dent].reverse())).toThrow('vertex 0 bending the other way: [3, 1]');
  });

  it('is refused if it has no area', () => {
    expect(() => clean(pairs([0, 0, 1, 1, 3, 3]))).toThrow('vertex 0 turning straight back');
    expect(() => clean(pairs([0, 0, 2, 0, 1, 0]))).toThrow('turning straight back');
    expect(() => clean(pairs([0, 0, 0, 2, 0, 1]))).toThrow('turning straight back');
    // A lens whose sides bend by less than the tolerance at each vertex: only the two tips are left.
    const h = 0.9 * COLLINEAR_TOLERANCE;
    const side = [-1, -0.5, 0, 0.5].map((x): Vec2 => [x, h * (x * x - 1)]);
    const back = side.map(([x, y]): Vec2 => [-x, -y]);
    expect(() => clean([...side, ...back])).toThrow('got all vertices on one line');
  });

  it('is refused if it goes round more than once, with the vertex that starts the second round', () => {
    for (const count of [5, 7, 9]) {
      const star = Array.from({ length: count }, (_, k): Vec2 => {
        const angle = (4 * Math.PI * k) / count;
        return [Math.cos(angle), Math.sin(angle)];
      });
      for (const path of [star, [...star].reverse()]) {
        expect(() => clean(path)).toThrow(/got a second round at vertex [1-9]/);
      }
    }
    // As wide as ten atoms, upright and lying.
    const thin = Array.from(
      { length: 5 },
      (_, k): Vec2 => [0.79e-8 * Math.cos(0.1 + 0.8 * k * Math.PI), Math.sin(0.1 + 0.8 * k * Math.PI)],
    );
    for (const path of [thin, thin.map(([x, y]): Vec2 => [y, -x])]) {
      expect(() => clean(path)).toThrow(/got a second round at vertex [1-9]/);
    }
    // Twice round a square of other sizes: every edge upright or level.
    const twice = pairs([0, 0, 3, 0, 3, 3, 1, 3, 1, -1, 4, -1, 4, 4, 0, 4]);
    expect(() => clean(twice)).toThrow(/second round at vertex [1-9]/);
  });

  it('is refused if two neighbours are the same, up to the tolerance', () => {
    const gap = (d: number): number[] => [0, 0, 2, 0, 2, d, 0, 2];
    expect(repeatedVertex(gap(VERTEX_TOLERANCE))).toBe(1);
    expect(repeatedVertex(gap(2 * VERTEX_TOLERANCE))).toBe(-1);
    expect(repeatedVertex([0, 0, 2, 0, 2, 2, VERTEX_TOLERANCE / 2, VERTEX_TOLERANCE / 2])).toBe(3);
    expect(repeatedVertex([5, 5, 5 + VERTEX_TOLERANCE, 5 + VERTEX_TOLERANCE, 7, 8])).toBe(-1);
    expect(repeatedVertex([5, 5, 5, 5, 7, 8])).toBe(0);
    expect(() => clean(pairs([5, 5, 5, 5, 7, 8]))).toThrow('got vertex 1 equal to vertex 0: [5, 5]');
    expect(() => clean(pairs(gap(0)))).toThrow('f: vertices must be distinct, got vertex 2 equal to vertex 1: [2, 0]');
  });
});
