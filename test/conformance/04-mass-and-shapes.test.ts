import { describe, expect, it } from 'vitest';
import { phys2D, type Shape } from '../../src/index.js';
import { add, box, disc, heavy, near, plainBody, steps, weightless } from './setting.js';

const bodyOf = (...shapes: Shape[]) => phys2D.createRigidBody({ shapes });
const at = (x: number, y: number, density = 1) =>
  phys2D.createCircleShape({ radius: 1, origin: [x, y], material: phys2D.createMaterial({ density }) });

describe('bodies: mass, inertia, shapes', () => {
  it('C-027 mass and inertia of a box', () => {
    const body = bodyOf(box(2, 3));
    near([body.getMass(), body.getInertia()], [6, 6.5]);
  });

  it('C-028 mass and inertia of a disc', () => {
    const body = bodyOf(disc(2));
    near([body.getMass(), body.getInertia()], [4 * Math.PI, 8 * Math.PI]);
  });

  it('C-029 inertia is about the body origin', () => {
    near(bodyOf(at(3, 0)).getInertia(), Math.PI * 9.5);
  });

  it('C-030 shapes add up', () => {
    const body = bodyOf(box(1, 1), disc(1));
    near([body.getMass(), body.getInertia()], [1 + Math.PI, 1 / 6 + Math.PI / 2]);
  });

  it('C-031 a given mass stays, inertia from shapes follows', () => {
    const body = phys2D.createRigidBody({ shapes: [disc(1)], mass: 10 });
    const inertia = body.getInertia();
    body.addShape(box(1, 1));
    expect(body.getMass()).toBe(10);
    near(body.getInertia(), inertia + 1 / 6);
  });

  it('C-032 mass can be set free again', () => {
    const body = bodyOf(disc(1));
    body.setMass(3);
    expect(body.getMass()).toBe(3);
    body.setMassFromShapes();
    expect(body.getMass()).toBe(body.computeMassFromShapes());
    body.addShape(box(1, 1));
    near(body.getMass(), Math.PI + 1);
  });

  it('C-033 mass follows the radius', () => {
    const shape = disc(1);
    const body = bodyOf(shape);
    const mass = body.getMass();
    shape.setRadius(2);
    near(body.getMass(), 4 * mass);
  });

  it('C-034 mass follows the material', () => {
    const shape = disc(1);
    const body = bodyOf(shape);
    const mass = body.getMass();
    shape.setMaterial(phys2D.createMaterial({ density: 3 }));
    near(body.getMass(), 3 * mass);
  });

  it('C-035 mass survives type changes', () => {
    const body = phys2D.createRigidBody({ type: 'static', shapes: [disc(1)], mass: 10 });
    expect(body.getMass()).toBe(10);
    body.setAsDynamic();
    body.applyImpulse([10, 0]);
    near(body.getVelocity(), [1, 0]);
  });

  it('C-036 shapes can be aligned with the origin', () => {
    const body = bodyOf(at(0, 0, 1), at(4, 0, 3));
    body.setPosition([7, 8]);
    near(body.computeLocalCenterOfMass(), [3, 0]);
    body.alignWithOrigin();
    near(body.computeLocalCenterOfMass(), [0, 0]);
    expect(body.getPosition()).toEqual([7, 8]);
  });

  it('C-037 a body without mass stays finite', () => {
    const world = heavy();
    const body = phys2D.createRigidBody({ velocity: [1, 0] });
    const weightlessShape = bodyOf(disc(1, { material: phys2D.createMaterial({ density: 0 }) }));
    add(world, body, weightlessShape);
    steps(world, 60);
    expect(body.getMass()).toBe(0);
    for (const each of [body, weightlessShape]) {
      expect([...each.getPosition(), ...each.getVelocity()].every(Number.isFinite)).toBe(true);
    }
  });

  it('C-038 a shape can be added', () => {
    const body = bodyOf();
    const shape = disc(1);
    expect(body.addShape(shape)).toBe(true);
    expect(shape.body).toBe(body);
    expect(body.shapes).toEqual([shape]);
  });

  it('C-039 a shape with a body is refused', () => {
    const shape = disc(1);
    const [owner, other] = [bodyOf(shape), bodyOf()];
    expect(other.addShape(shape)).toBe(false);
    expect(shape.body).toBe(owner);
    expect(other.shapes).toEqual([]);
  });

  it('C-040 own shapes can be removed', () => {
    const [own, foreign] = [disc(1), disc(1)];
    const body = bodyOf(own);
    bodyOf(foreign);
    expect(body.removeShape(foreign)).toBe(false);
    expect(body.removeShape(own)).toBe(true);
    expect(own.body).toBe(null);
    expect(body.shapes).toEqual([]);
  });

  it('C-041 shapes of a static body in a world stay', () => {
    const shape = disc(1);
    const body = plainBody({ type: 'static', shapes: [shape] });
    add(weightless(), body);
    expect(body.addShape(disc(1))).toBe(false);
    expect(body.removeShape(shape)).toBe(false);
    expect(body.shapes).toEqual([shape]);
  });

  it('C-042 a body is not made from the shapes of another', () => {
    const shape = disc(1);
    const owner = bodyOf(shape);
    const other = bodyOf(shape);
    expect(shape.body).toBe(owner);
    expect(owner.shapes).toEqual([shape]);
    expect(other.shapes).toEqual([]);
  });

  it('C-043 a shape listed twice is attached once', () => {
    const shape = disc(1);
    expect(bodyOf(shape, shape).shapes).toEqual([shape]);
  });

  it('shapes added and removed in a world take part at once', () => {
    const world = heavy();
    add(world, phys2D.createRigidBody({ type: 'static', position: [0, 2], shapes: [box(20, 1)] }));
    const body = bodyOf(disc(0.5));
    add(world, body);
    const wing = phys2D.createCircleShape({ radius: 0.5, origin: [0, 1] });
    expect(body.addShape(wing)).toBe(true);
    steps(world, 120);
    near(body.getPosition()[1], 0, 0.02);
    expect(wing.arbiters).toHaveLength(1);
    body.removeShape(wing);
    expect(wing.arbiters).toEqual([]);
    steps(world, 120);
    near(body.getPosition()[1], 1, 0.02);
  });
});
