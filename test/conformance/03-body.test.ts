import { describe, expect, it } from 'vitest';
import { phys2D } from '../../src/index.js';
import { add, disc, near, plainBody, weightless } from './setting.js';

describe('bodies: construction and plain access', () => {
  it('C-009 a body has defaults', () => {
    const body = phys2D.createRigidBody({});
    expect(body.isDynamic()).toBe(true);
    expect([
      body.getPosition(),
      body.getRotation(),
      body.getVelocity(),
      body.getAngularVelocity(),
      body.getForce(),
      body.getTorque(),
      body.getSurfaceVelocity(),
    ]).toEqual([[0, 0], 0, [0, 0], 0, [0, 0], 0, [0, 0]]);
    expect([body.getLinearDrag(), body.getAngularDrag()]).toEqual([0.05, 0.05]);
    expect([body.sleeping, body.bullet, body.world, body.userData]).toEqual([false, false, null, null]);
  });

  it('C-010 a body is of one type', () => {
    for (const type of ['dynamic', 'kinematic', 'static'] as const) {
      const body = phys2D.createRigidBody({ type });
      expect([body.isDynamic(), body.isKinematic(), body.isStatic()]).toEqual([
        type === 'dynamic',
        type === 'kinematic',
        type === 'static',
      ]);
    }
  });

  it('C-011 static bodies have no velocity', () => {
    const options = { velocity: [1, 2], angularVelocity: 3 };
    const fixed = phys2D.createRigidBody({ type: 'static', ...options });
    expect([...fixed.getVelocity(), fixed.getAngularVelocity()]).toEqual([0, 0, 0]);
    const moved = phys2D.createRigidBody({ type: 'kinematic', ...options });
    expect([...moved.getVelocity(), moved.getAngularVelocity()]).toEqual([1, 2, 3]);
  });

  it('C-012 getters fill and return a destination, and hand out copies', () => {
    const body = phys2D.createRigidBody({
      position: [1, 2],
      velocity: [3, 4],
      force: [5, 6],
      surfaceVelocity: [7, 8],
    });
    for (const [read, expected] of [
      [body.getPosition.bind(body), [1, 2]],
      [body.getVelocity.bind(body), [3, 4]],
      [body.getForce.bind(body), [5, 6]],
      [body.getSurfaceVelocity.bind(body), [7, 8]],
    ] as const) {
      const dst = new Float64Array(2);
      expect(read(dst)).toBe(dst);
      expect(Array.from(dst)).toEqual(expected);
      dst[0] = 99;
      read()[0] = 98;
      expect(read()).toEqual(expected);
    }
  });

  it('C-013 typed arrays are vectors too', () => {
    const body = phys2D.createRigidBody();
    body.setPosition(new Float32Array([3, 4]));
    expect(body.getPosition()).toEqual([3, 4]);
  });

  it('C-014 rotation is not wrapped', () => {
    const body = phys2D.createRigidBody();
    body.setRotation(7);
    expect(body.getRotation()).toBe(7);
  });

  it('C-015 drags read back', () => {
    const body = phys2D.createRigidBody();
    body.setLinearDrag(0.25);
    body.setAngularDrag(0.5);
    near([body.getLinearDrag(), body.getAngularDrag()], [0.25, 0.5]);
  });

  it('C-016 a static body takes no velocity, a kinematic one no impulse', () => {
    const fixed = plainBody({ type: 'static' });
    fixed.setVelocity([1, 1]);
    fixed.setAngularVelocity(1);
    fixed.applyImpulse([1, 1]);
    expect([...fixed.getVelocity(), fixed.getAngularVelocity()]).toEqual([0, 0, 0]);
    const moved = plainBody({ type: 'kinematic' });
    moved.applyImpulse([1, 1]);
    expect(moved.getVelocity()).toEqual([0, 0]);
  });

  it('C-017 a static body in a world stays where it is', () => {
    const body = plainBody({ type: 'static' });
    add(weightless(), body);
    body.setPosition([1, 2]);
    body.setRotation(1);
    expect([...body.getPosition(), body.getRotation()]).toEqual([0, 0, 0]);
  });

  it('C-018 a static body outside a world can be moved', () => {
    const body = plainBody({ type: 'static' });
    body.setPosition([1, 2]);
    expect(body.getPosition()).toEqual([1, 2]);
  });

  it('C-019 a static body in a world takes force, torque, surface velocity and mass', () => {
    const body = plainBody({ type: 'static' });
    add(weightless(), body);
    body.setForce([1, 2]);
    body.setTorque(3);
    body.setSurfaceVelocity([4, 5]);
    body.setMass(6);
    expect([body.getForce(), body.getTorque(), body.getSurfaceVelocity(), body.getMass()]).toEqual([
      [1, 2],
      3,
      [4, 5],
      6,
    ]);
  });

  it('C-020 an impulse without a point turns nothing', () => {
    const body = plainBody();
    body.applyImpulse([2, 0]);
    expect([...body.getVelocity(), body.getAngularVelocity()]).toEqual([2, 0, 0]);
  });

  it('C-021 an impulse at a point turns the body', () => {
    const body = plainBody({ mass: 2, inertia: 4 });
    body.applyImpulse([0, 2], [3, 0]);
    expect([...body.getVelocity(), body.getAngularVelocity()]).toEqual([0, 1, 1.5]);
  });

  it('C-022 velocities that lead to a placement', () => {
    const body = plainBody({ position: [1, 1] });
    body.setVelocityFromPosition([2, 3], 0.5, 0.5);
    expect([...body.getVelocity(), body.getAngularVelocity()]).toEqual([2, 4, 1]);
  });

  it('C-023 integrate moves there and back', () => {
    const body = plainBody({ velocity: [2, 0], angularVelocity: 1 });
    body.integrate(0.5);
    near([...body.getPosition(), body.getRotation()], [1, 0, 0.5]);
    body.integrate(-0.5);
    near([...body.getPosition(), body.getRotation()], [0, 0, 0]);
  });

  it('C-024 coordinates change between body and world', () => {
    const body = plainBody({ position: [1, 0], rotation: Math.PI / 2 });
    near(body.transformLocalPointToWorld([1, 0]), [1, 1]);
    near(body.transformWorldPointToLocal([1, 1]), [1, 0]);
    near(body.transformLocalVectorToWorld([1, 0]), [0, 1]);
    near(body.transformWorldVectorToLocal([0, 1]), [1, 0]);
  });

  it('C-025 world bounds follow the placement', () => {
    const body = plainBody({ shapes: [disc(1)], position: [2, 3] });
    expect(body.computeWorldBounds()).toEqual([1, 2, 3, 4]);
    body.setPosition([0, 0]);
    expect(body.computeWorldBounds()).toEqual([-1, -1, 1, 1]);
    add(weightless(), body);
    body.setPosition([5, 5]);
    expect(body.computeWorldBounds()).toEqual([4, 4, 6, 6]);
  });

  it('C-026 a body without shapes has empty bounds', () => {
    expect(phys2D.createRigidBody().computeWorldBounds()).toEqual([Infinity, Infinity, -Infinity, -Infinity]);
  });
});
