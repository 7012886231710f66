import { describe, expect, it } from 'vitest';
import { type Polygon, phys2D } from '../../src/index.js';

// Equal polygons share their form: what is done to one must not be seen by the other.

function square(): Polygon {
  return phys2D.createPolygonShape({ vertices: phys2D.createBoxVertices(1, 1) });
}

/** All that can be asked of the form of a polygon. */
function formOf(polygon: Polygon) {
  return {
    area: polygon.computeArea(),
    inertia: polygon.computeMasslessInertia(),
    centre: polygon.computeCenterOfMass(),
    bounds: polygon.body!.computeWorldBounds(),
  };
}

const changes: Record<string, (polygon: Polygon) => void> = {
  scale: (polygon) => polygon.scale(2, 3),
  translate: (polygon) => polygon.translate([1, 2]),
  rotate: (polygon) => polygon.rotate(0.5),
  transform: (polygon) => polygon.transform([1, 0, 0.5, 1, 0, 0]),
  setVertices: (polygon) => polygon.setVertices(phys2D.createBoxVertices(3, 4)),
};

describe.each(Object.entries(changes))('%s of one of two equal polygons', (_, change) => {
  it('leaves the other as it was', () => {
    const [one, other] = [square(), square()];
    phys2D.createRigidBody({ shapes: [one] });
    phys2D.createRigidBody({ shapes: [other] });
    const before = formOf(other);
    change(one);
    expect(formOf(one)).not.toEqual(before);
    expect(formOf(other)).toEqual(before);
  });

  it('leaves it so after a restore as well', () => {
    const world = phys2D.createWorld();
    const [one, other] = [square(), square()];
    for (const shape of [one, other]) {
      world.addRigidBody(phys2D.createRigidBody({ shapes: [shape] }));
    }
    const before = formOf(other);
    const snapshot = world.snapshot();
    change(one);
    change(other);
    world.restore(snapshot);
    expect(formOf(other)).toEqual(before);
    change(one);
    expect(formOf(other)).toEqual(before);
  });
});

describe('getVertices', () => {
  it('gives the corners as they are now, clockwise, without those inside an edge, in arrays of the caller', () => {
    const polygon = phys2D.createPolygonShape({
      vertices: [
        [0, 0],
        [0, 2],
        [1, 2],
        [3, 2],
      ],
    });
    const corners = polygon.getVertices();
    expect(corners).toHaveLength(3);
    expect(new Set(corners.map(String))).toEqual(new Set(['0,0', '3,2', '0,2']));
    const area = corners.reduce((sum, [x, y], i) => {
      const [nextX, nextY] = corners[(i + 1) % 3]!;
      return sum + x * nextY - y * nextX;
    }, 0);
    expect(area / 2).toBe(polygon.computeArea());
    corners[0]![0] = 100;
    expect(polygon.getVertices()).not.toEqual(corners);
    polygon.translate([1, -1]);
    expect(new Set(polygon.getVertices().map(String))).toEqual(new Set(['1,-1', '4,1', '1,1']));
    const copy = phys2D.createPolygonShape({ vertices: polygon.getVertices() });
    expect(copy.getVertices()).toEqual(polygon.getVertices());
  });
});

describe('equal polygons', () => {
  it('are told from those with the other zero, as results may tell', () => {
    const [plus, minus] = [0, -0].map((y) =>
      phys2D.createPolygonShape({
        vertices: [
          [0, y],
          [1, 1],
          [-1, 1],
        ],
      }),
    );
    expect(Object.is(plus!.vertices[1], 0)).toBe(true);
    expect(Object.is(minus!.vertices[1], -0)).toBe(true);
  });
});
