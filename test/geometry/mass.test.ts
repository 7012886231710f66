import { expect, it } from 'vitest';
import { polygonArea, polygonCentre, polygonMasslessInertia } from '../../src/geometry/mass.js';

// Against sums over the triangles of a fan, from closed forms of their own: none of the polygons is symmetric to anything, and the origin is outside.

type Point = readonly [number, number];

const POLYGONS: readonly (readonly Point[])[] = [
  [
    [3, 1],
    [7, 2],
    [5, 6],
  ],
  [
    [-9, 2],
    [-4, -3],
    [-1, 1],
    [-6, 5],
  ],
  [
    [2, -8],
    [6, -7],
    [7, -3],
    [4, -1],
    [1, -4],
  ],
];

/** Area, centre and second moment about the origin of a triangle. */
function triangle([ax, ay]: Point, [bx, by]: Point, [cx, cy]: Point) {
  const area = ((bx - ax) * (cy - ay) - (by - ay) * (cx - ax)) / 2;
  const x = (ax + bx + cx) / 3;
  const y = (ay + by + cy) / 3;
  // About the centre a thirty-sixth of the area times the squares of the sides; Steiner's theorem adds the rest.
  const sides = (bx - ax) ** 2 + (by - ay) ** 2 + (cx - bx) ** 2 + (cy - by) ** 2 + (ax - cx) ** 2 + (ay - cy) ** 2;
  return { area, x, y, moment: area * (sides / 36 + x * x + y * y) };
}

it.each(POLYGONS.map((polygon) => [polygon.length, polygon] as const))('of a polygon with %d corners', (_, polygon) => {
  const fan = polygon.slice(2).map((corner, i) => triangle(polygon[0]!, polygon[i + 1]!, corner));
  const sum = (of: (part: ReturnType<typeof triangle>) => number): number =>
    fan.reduce((all, part) => all + of(part), 0);
  const area = sum((part) => part.area);
  const flat = polygon.flat();
  const centre = [0, 0];
  polygonCentre(flat, centre);
  expect(area).toBeGreaterThan(0);
  expect(polygonArea(flat)).toBeCloseTo(area, 10);
  expect(polygonMasslessInertia(flat)).toBeCloseTo(sum((part) => part.moment) / area, 10);
  expect(centre[0]).toBeCloseTo(sum((part) => part.area * part.x) / area, 10);
  expect(centre[1]).toBeCloseTo(sum((part) => part.area * part.y) / area, 10);
});

it.each([1e3, 1e5, 1e7])('of a polygon that is %d m away, as of one at hand', (distance) => {
  // Of numbers that a shift by a power of two keeps to the bit.
  const far = 2 ** Math.round(Math.log2(distance));
  for (const [x, y] of [
    [far, 0],
    [0, -far],
    [-far, far],
  ] as const) {
    for (const polygon of POLYGONS) {
      const corners = polygon.flatMap(([px, py]) => [px / 8, py / 8]);
      const moved = corners.map((value, i) => value + (i % 2 === 0 ? x : y));
      const [here, there]: [number[], number[]] = [[], []];
      polygonCentre(corners, here);
      polygonCentre(moved, there);
      expect(Math.abs(polygonArea(moved) / polygonArea(corners) - 1)).toBeLessThan(1e-12);
      expect(Math.hypot(there[0]! - x - here[0]!, there[1]! - y - here[1]!)).toBeLessThan(4 * far * Number.EPSILON);
      const steiner = polygonMasslessInertia(corners) + 2 * (x * here[0]! + y * here[1]!) + x * x + y * y;
      expect(Math.abs(polygonMasslessInertia(moved) / steiner - 1)).toBeLessThan(1e-14);
    }
  }
});
