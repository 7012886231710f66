import { describe, expect, it } from 'vitest';
import { type Circle, type Polygon, phys2D } from '../../src/index.js';
import { add, box, disc, heavy, near, steps, weightless } from './setting.js';

const circle = (radius: number, origin: [number, number]): Circle => phys2D.createCircleShape({ radius, origin });
const describeCircle = (shape: Circle): number[] => [shape.getRadius(), ...shape.getOrigin()];

describe('shapes', () => {
  it('C-044 ids grow', () => {
    const [a, b] = [disc(1), box(1, 1)];
    expect(Number.isInteger(a.id) && a.id >= 0).toBe(true);
    expect(b.id).toBeGreaterThan(a.id);
  });

  it('C-045 a shape has defaults', () => {
    for (const [shape, type] of [
      [disc(1), 'CIRCLE'],
      [box(1, 1), 'POLYGON'],
    ] as const) {
      expect([shape.getGroup(), shape.getMask(), shape.sensor, shape.userData]).toEqual([1, 0xffffffff, false, null]);
      expect(shape.getMaterial()).toBe(phys2D.getDefaultMaterial());
      expect([shape.body, shape.arbiters, shape.type]).toEqual([null, [], type]);
    }
  });

  it('C-046 area, centre and inertia of a triangle', () => {
    const triangle = phys2D.createPolygonShape({
      vertices: [
        [0, 0],
        [3, 0],
        [0, 3],
      ],
    });
    near(
      [triangle.computeArea(), ...triangle.computeCenterOfMass(), triangle.computeMasslessInertia()],
      [4.5, 1, 1, 3],
    );
  });

  it('C-047 a circle scales by the first factor', () => {
    for (const factors of [[3], [3, 100]] as [number, number?][]) {
      const shape = circle(2, [1, 0]);
      shape.scale(...factors);
      near(describeCircle(shape), [6, 3, 0]);
    }
  });

  it('C-048 a polygon scales by both', () => {
    const shape = box(1, 1);
    shape.scale(2, 3);
    near(shape.computeArea(), 6);
  });

  it('C-049 factors that are not positive do nothing', () => {
    for (const factor of [0, -1]) {
      const [round, square] = [circle(2, [1, 0]), box(1, 1)];
      round.scale(factor);
      square.scale(factor);
      square.scale(1, factor);
      near([...describeCircle(round), square.computeArea()], [2, 1, 0, 1]);
    }
  });

  it('C-050 rotation is clockwise on screen', () => {
    const shape = circle(1, [1, 0]);
    shape.rotate(Math.PI / 2);
    near(shape.getOrigin(), [0, 1]);
  });

  it('C-051 a matrix scales and moves', () => {
    const shape = circle(1, [1, 2]);
    shape.transform([2, 0, 0, 2, 10, 20]);
    near(describeCircle(shape), [2, 12, 24]);
  });

  it('C-052 the matrix is given by columns', () => {
    const shape = circle(1, [1, 0]);
    shape.transform([0, 1, -1, 0, 0, 0]);
    near(shape.getOrigin(), [0, 1]);
  });

  it('C-053 a circle keeps the mapped area', () => {
    const shape = circle(1, [0, 0]);
    shape.transform([4, 0, 0, 1, 0, 0]);
    near(shape.getRadius(), 2);
  });

  it('C-054 mirrors are refused', () => {
    const [round, square] = [circle(1, [1, 2]), box(1, 2)];
    round.transform([-1, 0, 0, 1, 0, 0]);
    square.transform([-1, 0, 0, 1, 0, 0]);
    near([...describeCircle(round), square.computeArea()], [1, 1, 2, 2]);
  });

  it('C-055 vertices can be replaced', () => {
    const shape = box(1, 1);
    shape.setVertices([
      [0, 0],
      [3, 0],
      [0, 3],
    ]);
    near([shape.computeArea(), ...shape.computeCenterOfMass()], [4.5, 1, 1]);
  });

  it('C-056 a scaled box collides as a box of that size', () => {
    const restOn = (shape: Polygon): number => {
      const world = heavy();
      add(world, phys2D.createRigidBody({ type: 'static', position: [0, 1], shapes: [shape] }));
      const ball = phys2D.createRigidBody({ shapes: [disc(0.5)], position: [0.2, -1] });
      add(world, ball);
      steps(world, 60);
      return ball.getPosition()[1];
    };
    const scaled = box(1, 1);
    scaled.scale(2);
    near(restOn(scaled), restOn(box(2, 2)), 1e-9);
  });

  it('C-057 a clone is equal and independent', () => {
    const userData = {};
    const material = phys2D.createMaterial({ density: 2 });
    const options = { material, group: 4, mask: 6, sensor: true, userData };
    for (const shape of [phys2D.createCircleShape({ radius: 2, origin: [1, 3], ...options }), box(2, 3, options)]) {
      phys2D.createRigidBody({ shapes: [shape] });
      shape.addEventListener('begin', () => {});
      const clone = shape.clone();
      expect([clone.type, clone.getGroup(), clone.getMask(), clone.sensor]).toEqual([shape.type, 4, 6, true]);
      expect([clone.getMaterial(), clone.userData]).toEqual([material, userData]);
      expect(clone.userData).toBe(userData);
      expect(clone.id).toBeGreaterThan(shape.id);
      expect(clone.body).toBe(null);
      near(
        [clone.computeArea(), ...clone.computeCenterOfMass()],
        [shape.computeArea(), ...shape.computeCenterOfMass()],
      );
      expect(clone.removeEventListener('begin', () => {})).toBe(false);
      clone.scale(2);
      expect(clone.computeArea()).toBeGreaterThan(shape.computeArea());
    }
  });

  it('C-058 the geometry of a static body in a world stays', () => {
    const shape = circle(1, [1, 2]);
    const square = box(1, 1);
    add(weightless(), phys2D.createRigidBody({ type: 'static', shapes: [shape, square] }));
    shape.setRadius(2);
    shape.setOrigin([0, 0]);
    for (const each of [shape, square]) {
      each.translate([1, 1]);
      each.rotate(1);
      each.scale(2);
      each.transform([2, 0, 0, 2, 0, 0]);
    }
    square.setVertices(phys2D.createBoxVertices(3, 3));
    near([...describeCircle(shape), square.computeArea(), ...square.computeCenterOfMass()], [1, 1, 2, 1, 0, 0]);
  });

  it('C-059 unknown events are refused', () => {
    expect(disc(1).addEventListener('nonsense' as 'begin', () => {})).toBe(false);
  });

  it('C-060 a listener is added once', () => {
    const shape = disc(1);
    const handler = () => {};
    expect(shape.addEventListener('begin', handler, 4)).toBe(true);
    expect(shape.addEventListener('begin', handler, 4)).toBe(false);
    expect(shape.addEventListener('begin', handler, 8)).toBe(true);
    expect(shape.addEventListener('end', handler, 4)).toBe(true);
  });

  it('C-061 no mask is another listener than a full mask', () => {
    const shape = disc(1);
    const handler = () => {};
    shape.addEventListener('begin', handler);
    expect(shape.removeEventListener('begin', handler, 0xffffffff)).toBe(false);
    expect(shape.removeEventListener('begin', handler)).toBe(true);
    expect(shape.removeEventListener('begin', handler)).toBe(false);
  });
});
