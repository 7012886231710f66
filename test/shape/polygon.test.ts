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

describe('a polygon far from the origin of its body', () => {
  it('is taken as it is, and has an area, a centre and a mass, which lies in the origin when it is aligned', () => {
    for (const far of [1e4, 1e6, 1e8]) {
      const vertices = phys2D.createRectangleVertices(far, -far, far + 1, 0.5 - far);
      const shape = phys2D.createPolygonShape({ vertices });
      const body = phys2D.createRigidBody({ shapes: [shape] });
      expect(shape.computeArea()).toBe(0.5);
      expect(body.computeLocalCenterOfMass()).toEqual([far + 0.5, 0.25 - far]);
      body.alignWithOrigin();
      expect(body.computeLocalCenterOfMass()).toEqual([0, 0]);
      expect(body.getMass()).toBe(0.5);
      expect(body.getInertia()).toBeCloseTo((0.5 * (1 + 0.25)) / 12, 12);
    }
  });

  it('is refused where rounding leaves no area', () => {
    const shape = phys2D.createPolygonShape({
      vertices: [
        [0, 0],
        [1, 0],
        [0.5, 1e-3],
      ],
    });
    const rule = 'must be one that leaves points apart, an area, and all within 1e+75 m';
    expect(() => shape.translate([0, 1e14])).toThrow(`Shape.translate: translation ${rule}`);
    expect(() => shape.transform([1, 1, 1, 1 + 2 ** -52, 0, 0])).toThrow(`Shape.transform: matrix ${rule}`);
    expect(shape.computeArea()).toBeCloseTo(5e-4, 12);
  });

  it('names the factor that stretches it too far', () => {
    const shape = phys2D.createPolygonShape({ vertices: phys2D.createBoxVertices(1, 1) });
    expect(() => shape.scale(1, 1e80)).toThrow('Shape.scale: scaleY must be one that');
    expect(() => shape.scale(1e-12, 1)).toThrow('Shape.scale: scaleX must be one that');
    expect(() => shape.scale(2, 1e-12)).toThrow('scaleY');
  });
});
