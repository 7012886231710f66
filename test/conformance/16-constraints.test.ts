import { describe, expect, it, vi } from 'vitest';
import {
  type Constraint,
  type ConstraintParams,
  type PointConstraintParams,
  phys2D,
  type RigidBody,
  type World,
} from '../../src/index.js';
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

/** What holds a body 1 m below the origin, as bodyB or, if `swapped`, as bodyA. */
const HOLDING: Record<
  string,
  (anchor: RigidBody, body: RigidBody, swapped: boolean, params: ConstraintParams) => Constraint
> = {
  POINT: (anchor, body, swapped, params) => {
    const own = { bodyA: anchor, bodyB: body, anchorB: [0, -1] } as const;
    const exchanged = { bodyA: body, bodyB: anchor, anchorA: [0, -1] } as const;
    return phys2D.createPointConstraint({ ...(swapped ? exchanged : own), ...params });
  },
  WELD: (anchor, body, swapped, params) => {
    const own = { bodyA: anchor, bodyB: body, anchorA: [0, 1] } as const;
    const exchanged = { bodyA: body, bodyB: anchor, anchorB: [0, 1] } as const;
    return phys2D.createWeldConstraint({ ...(swapped ? exchanged : own), ...params });
  },
  DISTANCE: (anchor, body, swapped, params) => {
    const bodies = { bodyA: swapped ? body : anchor, bodyB: swapped ? anchor : body };
    return phys2D.createDistanceConstraint({ ...bodies, lowerBound: 1, upperBound: 1, ...params });
  },
  LINE: (anchor, body, swapped, params) => {
    const bodies = { bodyA: swapped ? body : anchor, bodyB: swapped ? anchor : body };
    const [lowerBound, upperBound] = swapped ? [-1, Infinity] : [-Infinity, 1];
    return phys2D.createLineConstraint({ ...bodies, axis: [0, 1], lowerBound, upperBound, ...params });
  },
  PULLEY: (anchor, body, swapped, params) => {
    const bodies = { bodyA: swapped ? body : anchor, bodyB: swapped ? anchor : body };
    const rest = { bodyC: staticBody(), bodyD: staticBody({ position: [2, 0] }), upperBound: 3 };
    return phys2D.createPulleyConstraint({ ...bodies, ...rest, ...params });
  },
  CUSTOM: (anchor, body, swapped, params) =>
    phys2D.createCustomConstraint({
      dimension: 1,
      bodies: swapped ? [body, anchor] : [anchor, body],
      position(data, index) {
        data[index] = body.getPosition()[1] - 1;
      },
      jacobian(data, index) {
        data[index + (swapped ? 1 : 4)] = 1;
      },
      ...params,
    }),
};

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

  it('C-177 options of a new constraint read back, `userData` whatever it is [D-48]', () => {
    const bodies = { bodyA: plainBody(), bodyB: plainBody() };
    for (const userData of [0, '', false, null, bodies]) {
      const constraint = phys2D.createMotorConstraint({ ...bodies, disabled: true, sleeping: true, userData });
      expect([constraint.isDisabled(), constraint.sleeping, constraint.userData]).toEqual([true, true, userData]);
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

  it('C-179 configure keeps limits and what they lead to, and reads nothing else', () => {
    const world = heavy();
    const options = { maxForce: 5, breakUnderForce: true, removeOnBreak: false, userData: 7 };
    const { constraint } = hang(world, options);
    constraint.configure({ stiff: false, maxForce: undefined, breakUnderForce: undefined });
    constraint.configure({ damping: 2, sleeping: true, disabled: true, userData: 8 } as ConstraintParams);
    expect([constraint.sleeping, constraint.isEnabled(), constraint.userData]).toEqual([false, true, 7]);
    steps(world, 30);
    expect([constraint.world, constraint.isEnabled()]).toEqual([world, false]);

    const other = heavy();
    const { body, constraint: weak } = hang(other, { stiff: false, maxForce: 5 });
    weak.configure({ frequency: 20 });
    steps(other, 30);
    near(body.getVelocity(), [0, 2.5], 0.1);

    const third = weightless();
    const far = hang(third, { anchorB: [0, 0], maxError: 0.5, breakUnderError: true });
    far.constraint.configure({ stiff: false });
    third.step(DT);
    expect(far.constraint.world).toBeNull();
  });

  it('C-179 configure wakes, even if nothing is changed', () => {
    const world = weightless();
    const { body, constraint } = hang(world);
    steps(world, 63);
    expect([body.sleeping, constraint.sleeping]).toEqual([true, true]);
    constraint.configure({});
    expect([body.sleeping, constraint.sleeping]).toEqual([false, false]);
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

  it('C-181 the same with the roles exchanged, for elastic ones and for other kinds', () => {
    for (const stiff of [true, false]) {
      for (const [type, make] of Object.entries(HOLDING)) {
        for (const swapped of [false, true]) {
          const world = heavy();
          const anchor = staticBody();
          const body = plainBody({ position: [0, 1] });
          add(world, body);
          const constraint = make(anchor, body, swapped, { stiff });
          tie(world, constraint);
          steps(world, 40);
          const message = `${type}, ${stiff}, ${swapped}`;
          const [x, y, w] = constraint.getImpulseForBody(body);
          expect(Math.abs(y + 1 / 6) + Math.abs(x) + Math.abs(w), message).toBeLessThan(1e-3);
          if (type !== 'CUSTOM') {
            const [u, v] = constraint.getImpulseForBody(anchor);
            expect(Math.abs(v - 1 / 6) + Math.abs(u), message).toBeLessThan(1e-3);
          }
        }
      }
    }
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

  it('C-182 so does every kind, stiff or elastic, whichever body is A', () => {
    for (const stiff of [true, false]) {
      for (const [type, make] of Object.entries(HOLDING)) {
        for (const swapped of [false, true]) {
          const world = heavy();
          const body = plainBody({ position: [0, 1] });
          add(world, body);
          const breaking = { stiff, maxForce: 5, breakUnderForce: true };
          const constraint = make(staticBody(), body, swapped, breaking);
          const broken = vi.fn();
          constraint.addEventListener('break', broken);
          tie(world, constraint);
          steps(world, 60);
          const message = `${type}, ${stiff}, ${swapped}`;
          expect(broken, message).toHaveBeenCalledTimes(1);
          expect([constraint.world, world.constraints], message).toEqual([null, []]);
          expect(body.getVelocity()[1], message).toBeGreaterThan(4);
          constraint.configure({ maxForce: 100 });
          body.setPosition([0, 1]);
          body.setVelocity([0, 0]);
          tie(world, constraint);
          steps(world, 60);
          expect(Math.abs(body.getPosition()[1] - 1), message).toBeLessThan(stiff ? 1e-3 : 0.01);
        }
      }
    }
  });

  it('C-182 a motor breaks under its torque', () => {
    const world = weightless();
    const body = plainBody();
    add(world, body);
    const params = { rate: 3, maxForce: 6, breakUnderForce: true };
    const motor = phys2D.createMotorConstraint({ bodyA: staticBody(), bodyB: body, ...params });
    tie(world, motor);
    world.step(DT);
    expect(motor.world).toBeNull();
    expect(body.getAngularVelocity()).toBe(0);
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

  it('C-183 so do the other kinds', () => {
    for (const [type, make] of Object.entries(HOLDING)) {
      const world = heavy();
      const body = plainBody({ position: [0, 1] });
      add(world, body);
      tie(world, make(staticBody(), body, false, { maxForce: 5 }));
      steps(world, 60);
      expect(Math.abs(body.getPosition()[1] - 1), type).toBeLessThan(1e-3);
    }
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

  it('C-184 nor do the other kinds, whichever body is A', () => {
    for (const [type, make] of Object.entries(HOLDING)) {
      for (const swapped of [false, true]) {
        const world = heavy();
        const body = plainBody({ position: [0, 1] });
        add(world, body);
        const constraint = make(staticBody(), body, swapped, { stiff: false, maxForce: 5 });
        tie(world, constraint);
        for (let i = 0; i < 60; i += 1) {
          world.step(DT);
          const [x, y] = constraint.getImpulseForBody(body);
          expect(Math.sqrt(x * x + y * y), type).toBeLessThanOrEqual(5 * DT + 1e-9);
        }
        expect(body.getPosition()[1], type).toBeGreaterThan(2);
      }
    }
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

  it('C-185 so does every kind, with the length of its error over all dimensions', () => {
    const errors: Record<string, (bodyA: RigidBody, bodyB: RigidBody, params: ConstraintParams) => Constraint> = {
      POINT: (bodyA, bodyB, params) => phys2D.createPointConstraint({ bodyA, bodyB, anchorA: [0.6, 0.2], ...params }),
      WELD: (bodyA, bodyB, params) =>
        phys2D.createWeldConstraint({ bodyA, bodyB, anchorA: [0, 0.2], phase: -0.6, ...params }),
      ANGLE: (bodyA, bodyB, params) =>
        phys2D.createAngleConstraint({ bodyA, bodyB, lowerBound: 1, upperBound: 2, ...params }),
      DISTANCE: (bodyA, bodyB, params) =>
        phys2D.createDistanceConstraint({ bodyA, bodyB, anchorA: [0, 2.6], upperBound: 0.6, ...params }),
      LINE: (bodyA, bodyB, params) =>
        phys2D.createLineConstraint({ bodyA, bodyB, axis: [1, 0], anchorA: [-1.6, 0.2], upperBound: 1, ...params }),
      PULLEY: (bodyA, bodyB, params) =>
        phys2D.createPulleyConstraint({ bodyA, bodyB, bodyC: bodyB, bodyD: bodyA, upperBound: 1, ...params }),
      CUSTOM: (bodyA, bodyB, params) =>
        phys2D.createCustomConstraint({
          dimension: 2,
          bodies: [bodyA, bodyB],
          position(data, index) {
            data[index] = 0.6;
            data[index + 1] = 0.8;
          },
          jacobian(data, index) {
            data[index] = 1;
            data[index + 10] = 1;
          },
          ...params,
        }),
    };
    for (const [type, make] of Object.entries(errors)) {
      for (const stiff of [true, false]) {
        for (const swapped of [false, true]) {
          const world = weightless();
          const [fixed, body] = [staticBody(), plainBody({ position: [0, 1] })];
          if (swapped) fixed.setPosition([0, 1]);
          if (swapped) body.setPosition([0, 0]);
          add(world, body);
          const limits = { stiff, breakUnderError: true };
          const [a, b] = swapped ? [body, fixed] : [fixed, body];
          const weak = make(a, b, { ...limits, maxError: 0.99 });
          const broken = vi.fn();
          weak.addEventListener('break', broken);
          tie(world, weak);
          world.step(DT);
          const message = `${type}, ${stiff}, ${swapped}`;
          expect([weak.world, broken.mock.calls.length], message).toEqual([null, 1]);
          expect([...body.getVelocity(), body.getAngularVelocity()], message).toEqual([0, 0, 0]);
          const strong = make(a, b, { ...limits, maxError: 1.01 });
          tie(world, strong);
          world.step(DT);
          expect(strong.world, message).toBe(world);
        }
      }
    }
  });

  it('C-185 an error within the bounds is none; without breakUnderError a stiff constraint ignores maxError', () => {
    const world = weightless();
    const body = plainBody({ position: [0, 1] });
    add(world, body);
    const limits = { maxError: 0.01, breakUnderError: true };
    const bodies = { bodyA: staticBody(), bodyB: body };
    const rope = phys2D.createDistanceConstraint({ ...bodies, upperBound: 5, ...limits });
    const line = phys2D.createLineConstraint({ ...bodies, axis: [0, 1], lowerBound: 0, upperBound: 5, ...limits });
    const point = phys2D.createPointConstraint({ ...bodies, maxError: 0.01 });
    tie(world, rope, line, point);
    steps(world, 10);
    expect(world.constraints).toHaveLength(3);
    near(body.getPosition(), [0, 0], 0.01);
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

  it('C-187 the same with the roles exchanged, and from below the target', () => {
    for (const [start, sign] of [
      [5, -1],
      [3, 1],
    ] as const) {
      const world = weightless({ substeps: 1 });
      const body = plainBody({ position: [start, 0] });
      add(world, body);
      const bounds = { lowerBound: 4, upperBound: 4 };
      tie(world, phys2D.createDistanceConstraint({ bodyA: body, bodyB: staticBody(), stiff: false, ...bounds }));
      world.step(DT);
      near(body.getVelocity(), [sign * 15.6996, 0], 0.01);
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

  it('C-188 so do those that left the world, and a slack pulley [D-22]', () => {
    const world = heavy();
    const { anchor, body, constraint } = hang(world, { maxForce: 20, breakUnderForce: true });
    steps(world, 20);
    near(constraint.getImpulseForBody(body), [0, -1 / 6, 0], 1e-3);
    constraint.configure({ maxForce: 5 });
    world.step(DT);
    expect(constraint.world).toBeNull();
    near(constraint.getImpulseForBody(body), [0, 0, 0], 0);
    near(constraint.getImpulseForBody(anchor), [0, 0, 0], 0);
    const other = heavy();
    const [a, d] = [plainBody({ position: [0, 1] }), plainBody({ position: [3, 1] })];
    add(other, a, d);
    const bodies = { bodyA: a, bodyB: staticBody(), bodyC: staticBody({ position: [3, 0] }), bodyD: d };
    for (const stiff of [true, false]) {
      const pulley = phys2D.createPulleyConstraint({ ...bodies, upperBound: 2, stiff });
      tie(other, pulley);
      for (const body of [a, d]) {
        body.setPosition([body.getPosition()[0], 1]);
        body.setVelocity([0, 0]);
      }
      steps(other, 30);
      expect(pulley.getImpulseForBody(a)[1]).toBeLessThan(-0.1);
      for (const body of [a, d]) {
        body.setPosition([body.getPosition()[0], 0.5]);
        body.setVelocity([0, -1]);
      }
      other.step(DT);
      for (const body of Object.values(bodies)) {
        near(pulley.getImpulseForBody(body), [0, 0, 0], 0);
      }
      other.removeConstraint(pulley);
    }
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

  it('C-189 every setter of every kind', () => {
    const world = weightless();
    const [a, b] = [plainBody(), plainBody({ position: [3, 0] })];
    add(world, a, b);
    const bodies = { bodyA: a, bodyB: b };
    const wide = { lowerBound: 1, upperBound: 50 };
    const point = phys2D.createPointConstraint({ ...bodies, anchorA: [3, 0] });
    const weld = phys2D.createWeldConstraint({ ...bodies, anchorA: [3, 0] });
    const distance = phys2D.createDistanceConstraint({ ...bodies, ...wide });
    const line = phys2D.createLineConstraint({ ...bodies, axis: [1, 0], ...wide });
    const angle = phys2D.createAngleConstraint({ ...bodies, lowerBound: -1, upperBound: 1 });
    const motor = phys2D.createMotorConstraint({ ...bodies });
    const pulley = phys2D.createPulleyConstraint({ ...bodies, bodyC: a, bodyD: b, ...wide });
    const [same, nudged] = [
      [0, 0],
      [0, 1e-6],
    ] as const;
    const setters: [string, Constraint, old: () => void, changed: () => void][] = [
      ['point A', point, () => point.setAnchorA([3, 0]), () => point.setAnchorA([3, 1e-6])],
      ['point B', point, () => point.setAnchorB(same), () => point.setAnchorB(nudged)],
      ['weld A', weld, () => weld.setAnchorA([3, 0]), () => weld.setAnchorA([3, 1e-6])],
      ['weld B', weld, () => weld.setAnchorB(same), () => weld.setAnchorB(nudged)],
      ['phase', weld, () => weld.setPhase(0), () => weld.setPhase(1e-6)],
      ['distance A', distance, () => distance.setAnchorA(same), () => distance.setAnchorA(nudged)],
      ['distance B', distance, () => distance.setAnchorB(same), () => distance.setAnchorB(nudged)],
      ['distance lower', distance, () => distance.setLowerBound(1), () => distance.setLowerBound(2)],
      ['distance upper', distance, () => distance.setUpperBound(50), () => distance.setUpperBound(51)],
      ['line A', line, () => line.setAnchorA(same), () => line.setAnchorA(nudged)],
      ['line B', line, () => line.setAnchorB(same), () => line.setAnchorB(nudged)],
      ['axis', line, () => line.setAxis([7, 0]), () => line.setAxis([1, 1e-6])],
      ['no axis', line, () => line.setAxis([0, 0]), () => line.setAxis([1, 1e-5])],
      ['line lower', line, () => line.setLowerBound(1), () => line.setLowerBound(2)],
      ['line upper', line, () => line.setUpperBound(50), () => line.setUpperBound(51)],
      ['angle lower', angle, () => angle.setLowerBound(-1), () => angle.setLowerBound(-2)],
      ['angle upper', angle, () => angle.setUpperBound(1), () => angle.setUpperBound(2)],
      ['angle ratio', angle, () => angle.setRatio(1), () => angle.setRatio(2)],
      ['motor ratio', motor, () => motor.setRatio(1), () => motor.setRatio(2)],
      ['motor rate', motor, () => motor.setRate(0), () => motor.setRate(1e-6)],
      ['pulley A', pulley, () => pulley.setAnchorA(same), () => pulley.setAnchorA(nudged)],
      ['pulley B', pulley, () => pulley.setAnchorB(same), () => pulley.setAnchorB(nudged)],
      ['pulley C', pulley, () => pulley.setAnchorC(same), () => pulley.setAnchorC(nudged)],
      ['pulley D', pulley, () => pulley.setAnchorD(same), () => pulley.setAnchorD(nudged)],
      ['pulley lower', pulley, () => pulley.setLowerBound(1), () => pulley.setLowerBound(2)],
      ['pulley upper', pulley, () => pulley.setUpperBound(50), () => pulley.setUpperBound(51)],
      ['pulley ratio', pulley, () => pulley.setRatio(1), () => pulley.setRatio(2)],
    ];
    for (const [name, constraint, old, changed] of setters) {
      tie(world, constraint);
      steps(world, 70);
      old();
      expect([constraint.sleeping, a.sleeping, b.sleeping], name).toEqual([true, true, true]);
      changed();
      expect([constraint.sleeping, a.sleeping, b.sleeping], name).toEqual([false, false, false]);
      old();
      world.removeConstraint(constraint);
    }
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
