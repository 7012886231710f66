import { describe, expect, it, vi } from 'vitest';
import { type Constraint, type PointConstraintParams, phys2D, type RigidBody, type World } from '../../src/index.js';
import { add, boxBody, DT, heavy, near, plainBody, speed, staticBody, steps, tie, weightless } from './setting.js';

/** A plain body that hangs one metre below a static anchor. */
function hang(world: World, params: Partial<PointConstraintParams> = {}) {
  const anchor = staticBody();
  const body = plainBody({ position: [0, 1] });
  add(world, body);
  const constraint = phys2D.createPointConstraint({ bodyA: anchor, bodyB: body, anchorB: [0, -1], ...params });
  tie(world, constraint);
  return { anchor, body, constraint };
}

function oneOfEachKind(a: RigidBody, b: RigidBody): Record<string, [Constraint, number]> {
  const bodies = { bodyA: a, bodyB: b };
  return {
    POINT: [phys2D.createPointConstraint(bodies), 2],
    WELD: [phys2D.createWeldConstraint(bodies), 3],
    ANGLE: [phys2D.createAngleConstraint(bodies), 1],
    DISTANCE: [phys2D.createDistanceConstraint(bodies), 1],
    LINE: [phys2D.createLineConstraint({ ...bodies, axis: [1, 0] }), 2],
    MOTOR: [phys2D.createMotorConstraint(bodies), 1],
    PULLEY: [phys2D.createPulleyConstraint({ ...bodies, bodyC: a, bodyD: b }), 1],
    CUSTOM: [phys2D.createCustomConstraint({ bodies: [a, b], dimension: 5, jacobian() {} }), 5],
  };
}

describe('16 Constraints: common', () => {
  it('C-177 a new constraint is enabled, awake, in no world, and of its type and dimension', () => {
    for (const [type, [constraint, dimension]] of Object.entries(oneOfEachKind(plainBody(), plainBody()))) {
      expect(constraint.isEnabled(), type).toBe(true);
      expect(constraint.isDisabled(), type).toBe(false);
      expect(constraint.sleeping, type).toBe(false);
      expect(constraint.world, type).toBeNull();
      expect(constraint.userData, type).toBeNull();
      expect(constraint.type).toBe(type);
      expect(constraint.dimension, type).toBe(dimension);
    }
  });

  it('C-178 a disabled constraint is in the world without effect until enabled', () => {
    const world = heavy();
    const { body, constraint } = hang(world, { disabled: true });
    expect(world.constraints).toContain(constraint);
    expect(world.liveConstraints).not.toContain(constraint);
    steps(world, 30);
    near(body.getVelocity(), [0, 5], 1e-6);
    constraint.enable();
    expect(world.liveConstraints).toContain(constraint);
    steps(world, 30);
    near(body.transformLocalPointToWorld([0, -1]), [0, 0], 1e-3);
  });

  it('C-179 configure keeps the options that are left out', () => {
    const world = weightless({ substeps: 1 });
    const { body, constraint } = hang(world, { frequency: 5, damping: 0.5 });
    constraint.configure({ stiff: false });
    body.setPosition([0, 2]);
    world.step(DT);
    const w = 2 * Math.PI * 5;
    const gamma = 1 / (DT * w * (2 * 0.5 + w * DT));
    near(speed(body), w / (2 * 0.5 + w * DT) / (1 + gamma), 1e-6);
  });

  it('C-180 a handler is added once, and only for known events', () => {
    const constraint = phys2D.createPointConstraint({ bodyA: staticBody(), bodyB: plainBody() });
    const handler = () => {};
    expect(constraint.addEventListener('break', handler)).toBe(true);
    expect(constraint.addEventListener('break', handler)).toBe(false);
    expect(constraint.addEventListener('nonsense' as 'break', handler)).toBe(false);
    expect(constraint.removeEventListener('break', handler)).toBe(true);
    expect(constraint.removeEventListener('break', handler)).toBe(false);
  });

  it('C-181 getImpulseForBody tells what a body got in the latest step', () => {
    const world = heavy();
    const { anchor, body, constraint } = hang(world);
    steps(world, 30);
    near(constraint.getImpulseForBody(body), [0, -1 / 6, 0], 1e-3);
    near(constraint.getImpulseForBody(anchor), [0, 1 / 6, 0], 1e-3);
    near(constraint.getImpulseForBody(plainBody()), [0, 0, 0], 0);
    const dst = new Float64Array(3);
    expect(constraint.getImpulseForBody(body, dst)).toBe(dst);
  });

  it('C-182 a stiff constraint breaks under too much force [R-16]', () => {
    for (const removeOnBreak of [true, false]) {
      const world = heavy();
      const { body, constraint } = hang(world, { maxForce: 5, breakUnderForce: true, removeOnBreak });
      const broken = vi.fn();
      constraint.addEventListener('break', broken);
      steps(world, 30);
      expect(broken).toHaveBeenCalledTimes(1);
      expect(broken.mock.contexts[0]).toBe(constraint);
      expect(constraint.world).toBe(removeOnBreak ? null : world);
      expect(constraint.isEnabled()).toBe(removeOnBreak);
      expect(world.constraints).toHaveLength(removeOnBreak ? 0 : 1);
      expect(world.liveConstraints).toHaveLength(0);
      expect(body.constraints).toHaveLength(removeOnBreak ? 0 : 1);
      expect(body.getVelocity()[1]).toBeGreaterThan(4);
    }
  });

  it('C-182 it holds under a force just below', () => {
    const world = heavy();
    const { body } = hang(world, { maxForce: 10.2, breakUnderForce: true });
    steps(world, 60);
    near(body.getPosition(), [0, 1], 1e-3);
  });

  it('C-183 a stiff constraint ignores maxForce otherwise', () => {
    const world = heavy();
    const { body } = hang(world, { maxForce: 5 });
    steps(world, 60);
    near(body.getPosition(), [0, 1], 1e-3);
  });

  it('C-184 a soft constraint pulls no harder than maxForce', () => {
    const world = heavy();
    const { body, constraint } = hang(world, { stiff: false, maxForce: 5 });
    for (let i = 0; i < 60; i += 1) {
      world.step(DT);
      const [x, y] = constraint.getImpulseForBody(body);
      expect(Math.sqrt(x * x + y * y)).toBeLessThanOrEqual(5 * DT + 1e-12);
    }
    expect(body.getPosition()[1]).toBeGreaterThan(2);
    near(body.getVelocity()[1], 5, 0.01);
  });

  it('C-185 breaks under too large an error in the first step, stiff and soft', () => {
    for (const stiff of [true, false]) {
      const world = weightless();
      const { body, constraint } = hang(world, { stiff, maxError: 0.5, breakUnderError: true, anchorB: [0, 0] });
      world.step(DT);
      expect(constraint.world).toBeNull();
      near(body.getVelocity(), [0, 0], 0);
      near(body.getPosition(), [0, 1], 0);
      const other = hang(world, { stiff, maxError: 1.5, breakUnderError: true, anchorB: [0, 0] });
      world.step(DT);
      expect(other.constraint.world).toBe(world);
    }
  });

  it('C-186 an undamped soft distance oscillates at its frequency', () => {
    const world = weightless();
    const body = plainBody({ position: [5, 0] });
    add(world, body);
    const bounds = { lowerBound: 4, upperBound: 4 };
    const spring = { stiff: false, frequency: 1, damping: 0 };
    tie(world, phys2D.createDistanceConstraint({ bodyA: staticBody(), bodyB: body, ...bounds, ...spring }));
    const crossings: number[] = [];
    for (let i = 1; i <= 250; i += 1) {
      const before = body.getPosition()[0];
      world.step(DT);
      if (before > 4 && body.getPosition()[0] <= 4) {
        crossings.push(i);
      }
    }
    expect(crossings.length).toBeGreaterThanOrEqual(4);
    for (let k = 1; k < crossings.length; k += 1) {
      expect(Math.abs(crossings[k]! - crossings[k - 1]! - 60)).toBeLessThanOrEqual(2);
    }
  });

  it('C-187 the first step of a soft distance, and its limit', () => {
    for (const [params, least, most] of [
      [{}, 15.6996 - 0.01, 15.6996 + 0.01],
      [{ maxError: 2 }, 1, 2],
    ] as const) {
      const world = weightless({ substeps: 1 });
      const body = plainBody({ position: [5, 0] });
      add(world, body);
      const bounds = { lowerBound: 4, upperBound: 4 };
      tie(
        world,
        phys2D.createDistanceConstraint({ bodyA: staticBody(), bodyB: body, stiff: false, ...bounds, ...params }),
      );
      world.step(DT);
      expect(speed(body)).toBeGreaterThanOrEqual(least);
      expect(speed(body)).toBeLessThanOrEqual(most);
      expect(body.getVelocity()[0]).toBeLessThan(0);
    }
  });

  it('C-188 broken and slack constraints give no impulse [D-22]', () => {
    const world = heavy();
    const { body, constraint } = hang(world, { maxForce: 5, breakUnderForce: true, removeOnBreak: false });
    steps(world, 5);
    near(constraint.getImpulseForBody(body), [0, 0, 0], 0);
    const rope = phys2D.createDistanceConstraint({ bodyA: staticBody(), bodyB: body, upperBound: 2 });
    body.setPosition([0, 0]);
    body.setVelocity([0, 10]);
    tie(world, rope);
    steps(world, 30);
    expect(rope.getImpulseForBody(body)[1]).toBeLessThan(0);
    body.setPosition([0, 0]);
    body.setVelocity([0, -5]);
    world.step(DT);
    near(rope.getImpulseForBody(body), [0, 0, 0], 0);
  });

  it('C-189 a setter with a new value wakes the constraint and its bodies, with the old one it does not', () => {
    const world = weightless();
    const a = plainBody();
    const b = plainBody({ position: [3, 0] });
    add(world, a, b);
    const constraint = phys2D.createDistanceConstraint({ bodyA: a, bodyB: b, upperBound: 5 });
    tie(world, constraint);
    steps(world, 63);
    expect([a.sleeping, b.sleeping, constraint.sleeping]).toEqual([true, true, true]);
    constraint.setUpperBound(5);
    constraint.setLowerBound(0);
    constraint.setAnchorA([0, 0]);
    expect([a.sleeping, b.sleeping, constraint.sleeping]).toEqual([true, true, true]);
    constraint.setUpperBound(4);
    expect([a.sleeping, b.sleeping, constraint.sleeping]).toEqual([false, false, false]);
    const line = phys2D.createLineConstraint({ bodyA: a, bodyB: b, axis: [1, 0] });
    tie(world, line);
    steps(world, 63);
    expect(line.sleeping).toBe(true);
    line.setAxis([2, 0]);
    expect(line.sleeping).toBe(true);
    line.setAxis([2, 0.001]);
    expect([line.sleeping, a.sleeping]).toEqual([false, false]);
  });

  it('C-189 boxes too', () => {
    const world = weightless();
    const a = boxBody(1, 1);
    const b = boxBody(1, 1, { position: [3, 0] });
    add(world, a, b);
    const angle = phys2D.createAngleConstraint({ bodyA: a, bodyB: b });
    tie(world, angle);
    steps(world, 63);
    expect(angle.sleeping).toBe(true);
    angle.setRatio(1);
    expect(angle.sleeping).toBe(true);
    angle.setRatio(2);
    expect([angle.sleeping, a.sleeping, b.sleeping]).toEqual([false, false, false]);
  });
});
