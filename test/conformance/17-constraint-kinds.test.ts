import { describe, expect, it } from 'vitest';
import { phys2D, type RigidBody, type World } from '../../src/index.js';
import { add, DT, heavy, near, plainBody, speed, staticBody, steps, tie, weightless } from './setting.js';

function addPlain(world: World, params: Parameters<typeof plainBody>[0] = {}): RigidBody {
  const body = plainBody(params);
  add(world, body);
  return body;
}

describe('17 Constraints: kinds', () => {
  it('C-190 POINT: pulls a body in from afar and leaves the static one, whichever is A [D-19]', () => {
    for (const swapped of [false, true]) {
      const world = weightless();
      const anchor = staticBody();
      const body = addPlain(world, { position: [5, 0] });
      const [bodyA, bodyB] = swapped ? [body, anchor] : [anchor, body];
      tie(world, phys2D.createPointConstraint({ bodyA, bodyB }));
      steps(world, 5);
      near(body.getPosition(), [0, 0], 0.01);
      near(anchor.getPosition(), [0, 0], 0);
      expect(speed(body)).toBeLessThan(0.01);
    }
  });

  it('C-190 POINT: two dynamic bodies meet half-way, a kinematic one stays', () => {
    const world = weightless();
    const [a, b] = [addPlain(world), addPlain(world, { position: [5, 0] })];
    const point = { anchorA: [0.5, 0], anchorB: [-0.5, 0] } as const;
    tie(world, phys2D.createPointConstraint({ bodyA: a, bodyB: b, ...point }));
    steps(world, 5);
    near([a.getPosition()[0], b.getPosition()[0]], [2, 3], 0.01);
    const other = weightless();
    const platform = addPlain(other, { type: 'kinematic' });
    const body = addPlain(other, { position: [5, 0] });
    tie(other, phys2D.createPointConstraint({ bodyA: body, bodyB: platform, anchorA: [-1, 0] }));
    steps(other, 5);
    near(platform.getPosition(), [0, 0], 0);
    near(body.getPosition(), [1, 0], 0.01);
  });

  it('C-191 POINT: a pendulum keeps its length', () => {
    const world = heavy();
    const body = addPlain(world, { position: [2, 0] });
    tie(world, phys2D.createPointConstraint({ bodyA: staticBody(), bodyB: body, anchorB: [-2, 0] }));
    for (let i = 0; i < 300; i += 1) {
      world.step(DT);
      const [x, y] = body.getPosition();
      near(Math.sqrt(x * x + y * y), 2, 0.01);
    }
  });

  it('C-192 WELD: phase and anchors', () => {
    const world = weightless();
    const a = addPlain(world);
    const b = addPlain(world, { position: [2, 0], angularVelocity: 3 });
    const weld = { bodyA: a, bodyB: b, anchorA: [1, 0], anchorB: [-1, 0], phase: 0.5 };
    tie(world, phys2D.createWeldConstraint(weld));
    steps(world, 60);
    near(b.getRotation() - a.getRotation(), 0.5, 0.01);
    const [x, y] = b.transformLocalPointToWorld([-1, 0]);
    near(a.transformLocalPointToWorld([1, 0]), [x, y], 0.01);
  });

  it('C-192 WELD: the same on a static body, whichever is A, stiff or elastic', () => {
    for (const stiff of [true, false]) {
      for (const swapped of [false, true]) {
        const world = weightless();
        const anchor = staticBody({ rotation: 0.2 });
        const body = addPlain(world, { position: [2, 0], angularVelocity: 3 });
        const own = { bodyA: anchor, bodyB: body, anchorA: [1, 0], anchorB: [-1, 0] } as const;
        const exchanged = { bodyA: body, bodyB: anchor, anchorA: [-1, 0], anchorB: [1, 0] } as const;
        tie(world, phys2D.createWeldConstraint({ ...(swapped ? exchanged : own), phase: 0.5, stiff }));
        steps(world, 60);
        near(body.getRotation(), swapped ? -0.3 : 0.7, 0.01);
        near(body.transformLocalPointToWorld([-1, 0]), anchor.transformLocalPointToWorld([1, 0]), 0.01);
        near(anchor.getPosition(), [0, 0], 0);
      }
    }
  });

  it('C-192 WELD: rotations are not wrapped', () => {
    const world = weightless();
    const body = addPlain(world, { rotation: 2 * Math.PI });
    tie(world, phys2D.createWeldConstraint({ bodyA: staticBody(), bodyB: body }));
    steps(world, 10);
    near(body.getRotation(), 0, 0.01);
  });

  it('C-193 DISTANCE: from beyond either bound to it; slack between them', () => {
    for (const [start, end] of [
      [5, 3],
      [1, 2],
      [2.5, 2.5],
    ] as const) {
      const world = weightless();
      const body = addPlain(world, { position: [start, 0] });
      tie(world, phys2D.createDistanceConstraint({ bodyA: staticBody(), bodyB: body, lowerBound: 2, upperBound: 3 }));
      steps(world, 5);
      near(body.getPosition(), [end, 0], 0.01);
      expect(speed(body)).toBeLessThan(0.01);
    }
    const world = weightless();
    const body = addPlain(world, { position: [2.5, 0], velocity: [1, 2] });
    tie(world, phys2D.createDistanceConstraint({ bodyA: staticBody(), bodyB: body, lowerBound: 2, upperBound: 3 }));
    steps(world, 10);
    near(body.getPosition(), [2.5 + 1 / 6, 1 / 3]);
    near(body.getVelocity(), [1, 2]);
  });

  it('C-193 DISTANCE: the same with the roles exchanged, and elastic with equal bounds', () => {
    for (const stiff of [true, false]) {
      for (const [start, end] of [
        [5, 3],
        [1, 2],
        [2.5, 2.5],
      ] as const) {
        const world = weightless();
        const anchor = staticBody();
        const body = addPlain(world, { position: [start, 0] });
        const bounds = stiff ? { lowerBound: 2, upperBound: 3 } : { lowerBound: end, upperBound: end };
        tie(world, phys2D.createDistanceConstraint({ bodyA: body, bodyB: anchor, ...bounds, stiff }));
        steps(world, stiff ? 5 : 40);
        near(body.getPosition(), [end, 0], 0.01);
        near(anchor.getPosition(), [0, 0], 0);
      }
    }
  });

  it('C-194 LINE: the axis is a unit vector, always; default bounds [R-15]', () => {
    const line = phys2D.createLineConstraint({ bodyA: staticBody(), bodyB: plainBody(), axis: [3, 0] });
    expect(line.getAxis()).toEqual([1, 0]);
    line.setAxis([0, 5]);
    expect(line.getAxis()).toEqual([0, 1]);
    line.setAxis([0, 0]);
    expect(line.getAxis()).toEqual([0, 1]);
    expect(line.getLowerBound()).toBe(-Infinity);
    expect(line.getUpperBound()).toBe(Infinity);
  });

  it('C-195, C-196 LINE: onto the line, and to its bound', () => {
    for (const [start, end] of [
      [
        [0.5, 2],
        [0.5, 0],
      ],
      [
        [5, 0],
        [1, 0],
      ],
      [
        [-5, 3],
        [-1, 0],
      ],
    ] as const) {
      const world = weightless();
      const body = addPlain(world, { position: start });
      const bounds = { lowerBound: -1, upperBound: 1 };
      tie(world, phys2D.createLineConstraint({ bodyA: staticBody(), bodyB: body, axis: [1, 0], ...bounds }));
      steps(world, 5);
      near(body.getPosition(), end, 0.01);
      expect(speed(body)).toBeLessThan(0.01);
    }
  });

  it('C-195, C-196 LINE: the same with the line on the moving body, and elastic', () => {
    for (const stiff of [true, false]) {
      for (const swapped of [false, true]) {
        for (const start of [
          [0.5, 2],
          [5, 0],
          [-5, 3],
        ] as const) {
          const world = weightless();
          const anchor = staticBody();
          const body = addPlain(world, { position: start });
          const [bodyA, bodyB] = swapped ? [body, anchor] : [anchor, body];
          const bounds = { lowerBound: -1, upperBound: 1, stiff };
          tie(world, phys2D.createLineConstraint({ bodyA, bodyB, axis: [1, 0], ...bounds }));
          steps(world, stiff ? 10 : 60);
          const [x, y] = bodyA.transformWorldPointToLocal(bodyB.getPosition());
          near(y, 0, 0.01);
          expect(Math.abs(x)).toBeLessThan(stiff ? 1.01 : 1.1);
          near(anchor.getPosition(), [0, 0], 0);
        }
      }
    }
  });

  it('C-197 ANGLE: stops at the bound, with ratio', () => {
    const world = weightless();
    const body = addPlain(world, { angularVelocity: 4 });
    const bounds = { lowerBound: -1, upperBound: 1 };
    tie(world, phys2D.createAngleConstraint({ bodyA: staticBody(), bodyB: body, ratio: 2, ...bounds }));
    steps(world, 60);
    near(2 * body.getRotation(), 1, 0.01);
    expect(Math.abs(body.getAngularVelocity())).toBeLessThan(0.01);
  });

  it('C-197 ANGLE: the same on body A, from below, and elastic with equal bounds', () => {
    for (const stiff of [true, false]) {
      for (const [spin, swapped, end] of [
        [-4, false, -0.5],
        [4, true, 1],
        [-4, true, -1],
      ] as const) {
        const world = weightless();
        const body = addPlain(world, { angularVelocity: spin });
        const [bodyA, bodyB] = swapped ? [body, staticBody()] : [staticBody(), body];
        const reached = swapped ? -end : 2 * end;
        const bounds = stiff ? { lowerBound: -1, upperBound: 1 } : { lowerBound: reached, upperBound: reached };
        tie(world, phys2D.createAngleConstraint({ bodyA, bodyB, ratio: 2, ...bounds, stiff }));
        steps(world, 60);
        near(body.getRotation(), end, 0.01);
        expect(Math.abs(body.getAngularVelocity())).toBeLessThan(0.02);
      }
    }
  });

  it('C-198 ANGLE: an error of 2 is gone after a step [D-18]', () => {
    const world = weightless();
    const body = addPlain(world, { rotation: 2 });
    tie(world, phys2D.createAngleConstraint({ bodyA: staticBody(), bodyB: body }));
    world.step(DT);
    near(body.getRotation(), 2 * 0.5 ** 8, 0.01);
  });

  it('C-198 ANGLE: also where the two bodies touch or overlap each other, and nothing else', () => {
    for (const x of [0, 0.9, 1, 3]) {
      const world = weightless();
      const bodyA = addPlain(world);
      const bodyB = addPlain(world, { position: [x, 0], rotation: 2 });
      tie(world, phys2D.createAngleConstraint({ bodyA, bodyB }));
      world.step(DT);
      near(bodyB.getRotation() - bodyA.getRotation(), 2 * 0.5 ** 8, 0.01);
    }
  });

  it('C-198 ANGLE: with ratio, and whichever body is A', () => {
    for (const swapped of [false, true]) {
      const world = weightless();
      const body = addPlain(world, { rotation: 1 });
      const [bodyA, bodyB] = swapped ? [body, staticBody()] : [staticBody(), body];
      tie(world, phys2D.createAngleConstraint({ bodyA, bodyB, ratio: 2 }));
      world.step(DT);
      near((swapped ? 1 : 2) * body.getRotation(), 0, 0.01);
    }
  });

  it('C-199 MOTOR: reaches its rate', () => {
    const world = weightless();
    const a = addPlain(world);
    const b = addPlain(world, { position: [3, 0] });
    tie(world, phys2D.createMotorConstraint({ bodyA: a, bodyB: b, ratio: 2, rate: 3 }));
    steps(world, 5);
    near(2 * b.getAngularVelocity() - a.getAngularVelocity(), 3, 1e-4);
  });

  it('C-199 MOTOR: between a body and a static one, whichever is A', () => {
    for (const [swapped, rate] of [
      [false, 1.5],
      [true, -3],
    ] as const) {
      const world = weightless();
      const body = addPlain(world);
      const [bodyA, bodyB] = swapped ? [body, staticBody()] : [staticBody(), body];
      tie(world, phys2D.createMotorConstraint({ bodyA, bodyB, ratio: 2, rate: 3 }));
      steps(world, 5);
      near(body.getAngularVelocity(), rate, 1e-4);
    }
  });

  it('C-200 MOTOR: no stronger than maxForce', () => {
    const world = weightless();
    const body = addPlain(world);
    tie(world, phys2D.createMotorConstraint({ bodyA: staticBody(), bodyB: body, rate: 100, maxForce: 6 }));
    world.step(DT);
    near(body.getAngularVelocity(), 6 * DT);
  });

  it('C-200 MOTOR: with ratio, whichever body is A, whether stiff or not', () => {
    for (const stiff of [true, false]) {
      for (const [swapped, change] of [
        [false, 12],
        [true, -6],
      ] as const) {
        const world = weightless();
        const body = addPlain(world);
        const [bodyA, bodyB] = swapped ? [body, staticBody()] : [staticBody(), body];
        const motor = phys2D.createMotorConstraint({ bodyA, bodyB, ratio: 2, rate: 100, maxForce: 6, stiff });
        tie(world, motor);
        for (let i = 1; i <= 5; i += 1) {
          world.step(DT);
          near(body.getAngularVelocity(), i * change * DT, 1e-9);
          near(motor.getImpulseForBody(body), [0, 0, change * DT], 1e-9);
        }
      }
    }
  });

  it('C-201, C-202 PULLEY: keeps the sum, and its impulses are in its ratio [D-76]', () => {
    const world = heavy();
    const a = addPlain(world, { position: [-2, 5] });
    const d = addPlain(world, { position: [2, 5] });
    const [b, c] = [staticBody({ position: [-2, 0] }), staticBody({ position: [2, 0] })];
    const bodies = { bodyA: a, bodyB: b, bodyC: c, bodyD: d };
    const pulley = phys2D.createPulleyConstraint({ ...bodies, ratio: 2, lowerBound: 15, upperBound: 15 });
    tie(world, pulley);
    a.setVelocity([1, 0]);
    for (let i = 0; i < 60; i += 1) {
      world.step(DT);
    }
    const length = (p: RigidBody, q: RigidBody): number => {
      const [px, py] = p.getPosition();
      const [qx, qy] = q.getPosition();
      return Math.sqrt((px - qx) ** 2 + (py - qy) ** 2);
    };
    near(length(a, b) + 2 * length(c, d), 15, 0.01);
    expect(speed(a)).toBeGreaterThan(0.1);
    const impulse = (body: RigidBody): number => {
      const [x, y] = pulley.getImpulseForBody(body);
      return Math.sqrt(x * x + y * y);
    };
    expect(impulse(a)).toBeGreaterThan(0.01);
    near(impulse(d) / impulse(a), 2, 1e-3);
    near(impulse(b), impulse(a), 1e-9);
    near(impulse(c), impulse(d), 1e-9);
  });

  it('C-201 PULLEY: a rope between its bounds is slack, below and above them it is not', () => {
    for (const stiff of [true, false]) {
      for (const [y, sum] of [
        [6, 15],
        [1, 9],
        [4, 12],
      ] as const) {
        const world = weightless();
        const [a, d] = [addPlain(world, { position: [-2, y] }), addPlain(world, { position: [2, y] })];
        const [b, c] = [staticBody({ position: [-2, 0] }), staticBody({ position: [2, 0] })];
        const bodies = { bodyA: a, bodyB: b, bodyC: c, bodyD: d };
        const bounds = stiff ? { lowerBound: 9, upperBound: 15 } : { lowerBound: sum, upperBound: sum };
        tie(world, phys2D.createPulleyConstraint({ ...bodies, ratio: 2, ...bounds, stiff }));
        steps(world, 40);
        near(a.getPosition()[1] + 2 * d.getPosition()[1], sum, 0.01);
      }
    }
  });

  it('C-203 CUSTOM: lists its bodies, copied, in a list of the type of all others', () => {
    const given = [plainBody(), staticBody()];
    const bodies: RigidBody[] = phys2D.createCustomConstraint({ dimension: 1, bodies: given, jacobian() {} }).bodies;
    expect(bodies).toEqual(given);
    expect(bodies).not.toBe(given);
  });

  it('C-203 CUSTOM: an error of one metre is gone after a step', () => {
    const world = weightless();
    const body = addPlain(world, { position: [1, 0] });
    const custom = phys2D.createCustomConstraint({
      dimension: 1,
      bodies: [body],
      position(data, index) {
        data[index] = body.getPosition()[0];
      },
      jacobian(data, index) {
        data[index] = 1;
        data[index + 1] = 0;
        data[index + 2] = 0;
      },
    });
    tie(world, custom);
    world.step(DT);
    near(body.getPosition(), [0, 0], 1e-4);
    near(body.getVelocity(), [0, 0], 1e-4);
  });

  it('C-203 CUSTOM: in any row, of any body; elastic in its time', () => {
    for (const stiff of [true, false]) {
      const world = weightless();
      const [a, b] = [addPlain(world), addPlain(world, { position: [3, 2], rotation: 1 })];
      const custom = phys2D.createCustomConstraint({
        stiff,
        dimension: 2,
        bodies: [a, b],
        position(data, index) {
          data[index] = b.getRotation() - a.getRotation();
          data[index + 1] = b.getPosition()[1] - a.getPosition()[1];
        },
        jacobian(data, index) {
          data[index + 2] = -1;
          data[index + 5] = 1;
          data[index + 7] = -1;
          data[index + 10] = 1;
        },
      });
      tie(world, custom);
      steps(world, stiff ? 1 : 40);
      near([a.getRotation(), b.getRotation()], [0.5, 0.5], stiff ? 1e-4 : 0.01);
      near([...a.getPosition(), ...b.getPosition()], [0, 1, 3, 1], stiff ? 1e-4 : 0.01);
    }
  });

  it('C-204 CUSTOM: order and number of calls', () => {
    for (const [stiff, expected] of [
      [true, 'constants jacobian vClamp vClamp constants position jacobian pClamp constants position jacobian pClamp'],
      [false, 'constants position jacobian vClamp vClamp'],
    ] as const) {
      const world = weightless({ substeps: 1, velocityIterations: 2, positionIterations: 2 });
      const body = addPlain(world);
      const calls: string[] = [];
      const note = (name: string) => () => calls.push(name);
      const custom = phys2D.createCustomConstraint({
        stiff,
        dimension: 1,
        bodies: [body],
        positionConstants: note('constants'),
        position: note('position'),
        jacobian: note('jacobian'),
        velocityClamp: note('vClamp'),
        positionClamp: note('pClamp'),
      });
      tie(world, custom);
      world.step(DT);
      expect(calls.join(' ')).toBe(expected);
    }
  });

  it('C-204 CUSTOM: without `position` it is one of velocities, stiff or not', () => {
    for (const stiff of [true, false]) {
      const world = weightless({ substeps: 1, velocityIterations: 2, positionIterations: 2 });
      const calls: string[] = [];
      const note = (name: string) => () => calls.push(name);
      const custom = phys2D.createCustomConstraint({
        stiff,
        dimension: 1,
        bodies: [addPlain(world)],
        positionConstants: note('constants'),
        jacobian: note('jacobian'),
        velocityClamp: note('vClamp'),
        positionClamp: note('pClamp'),
      });
      tie(world, custom);
      world.step(DT);
      expect(calls.join(' ')).toBe('constants jacobian vClamp vClamp');
    }
  });

  it('C-204 CUSTOM: nothing is called while it is disabled, asleep, or has no dynamic body', () => {
    const world = weightless();
    const body = addPlain(world);
    let calls = 0;
    const jacobian = (): void => {
      calls += 1;
    };
    const custom = phys2D.createCustomConstraint({ dimension: 1, bodies: [body], jacobian, disabled: true });
    const idle = phys2D.createCustomConstraint({ dimension: 1, bodies: [staticBody()], jacobian });
    tie(world, custom, idle);
    world.step(DT);
    custom.enable();
    custom.sleep();
    world.step(DT);
    expect(calls).toBe(0);
    custom.wake();
    world.step(DT);
    expect(calls).toBe(1);
  });

  it('C-204 CUSTOM: the clamps change impulses and corrections in place', () => {
    const world = weightless({ substeps: 1 });
    const body = addPlain(world, { position: [1, 0], velocity: [0, 3] });
    const held = phys2D.createCustomConstraint({
      dimension: 2,
      bodies: [body],
      position(data, index) {
        data[index] = body.getPosition()[0];
      },
      jacobian(data, index) {
        data[index] = 1;
        data[index + 4] = 1;
      },
      velocityClamp(data, index) {
        data[index + 1] = Math.max(-2, data[index + 1]!);
      },
      positionClamp(data, index) {
        data[index] = Math.max(-0.01, data[index]!);
      },
    });
    tie(world, held);
    world.step(DT);
    near(body.getPosition()[0], 1 - 8 * 0.01, 1e-9);
    near(body.getVelocity()[1], 1, 1e-9);
    near(held.getImpulseForBody(body)[1], -2, 1e-9);
  });

  it('C-204 CUSTOM: velocityClamp is shown the impulse of the whole step, and limits that, in however many sub-steps', () => {
    for (const substeps of [1, 4]) {
      const world = heavy({ gravity: [0, 6], substeps, velocityIterations: 8 });
      const body = addPlain(world);
      let shown = 0;
      let most = 1;
      const held = phys2D.createCustomConstraint({
        dimension: 1,
        bodies: [body],
        jacobian(data, index) {
          data[index + 1] = 1;
        },
        velocityClamp(data, index) {
          shown = data[index]!;
          data[index] = Math.max(-most, shown);
        },
      });
      tie(world, held);
      steps(world, 10);
      near(shown, -6 / 60, 1e-9);
      near(body.getVelocity(), [0, 0], 1e-9);
      most = 0.04;
      steps(world, 10);
      near(held.getImpulseForBody(body)[1], -most, 1e-9);
      near(body.getVelocity(), [0, 10 * (6 / 60 - most)], 1e-9);
    }
  });

  it('C-204 CUSTOM: the same totals with sub-steps', () => {
    const world = weightless();
    const body = addPlain(world);
    const counts = { constants: 0, position: 0, jacobian: 0, velocityClamp: 0, positionClamp: 0 };
    const custom = phys2D.createCustomConstraint({
      dimension: 1,
      bodies: [body],
      positionConstants: () => {
        counts.constants += 1;
      },
      position: () => {
        counts.position += 1;
      },
      jacobian: () => {
        counts.jacobian += 1;
      },
      velocityClamp: () => {
        counts.velocityClamp += 1;
      },
      positionClamp: () => {
        counts.positionClamp += 1;
      },
    });
    tie(world, custom);
    world.step(DT);
    expect(counts).toEqual({ constants: 9, position: 8, jacobian: 9, velocityClamp: 8, positionClamp: 8 });
  });

  it('C-205 CUSTOM: velocity-only constraints respect maxForce [D-25]', () => {
    const world = weightless();
    const body = addPlain(world, { velocity: [1, 0] });
    const custom = phys2D.createCustomConstraint({
      dimension: 1,
      bodies: [body],
      maxForce: 1,
      jacobian(data, index) {
        data[index] = 1;
      },
    });
    tie(world, custom);
    world.step(DT);
    near(body.getVelocity(), [1 - DT, 0], 1e-9);
  });

  it('C-205 CUSTOM: the length over all rows, stiff or not', () => {
    for (const stiff of [true, false]) {
      const world = weightless();
      const body = addPlain(world, { velocity: [3, 4] });
      const custom = phys2D.createCustomConstraint({
        stiff,
        dimension: 2,
        bodies: [body],
        maxForce: 1,
        jacobian(data, index) {
          data[index] = 1;
          data[index + 4] = 1;
        },
      });
      tie(world, custom);
      world.step(DT);
      near(speed(body), 5 - DT, 1e-9);
      custom.configure({ breakUnderForce: true });
      world.step(DT);
      expect(custom.world).toBeNull();
    }
  });

  it('C-204 CUSTOM: is shown where all of its bodies are in the course of the step, and which way they look', () => {
    const world = weightless({ substeps: 4, positionIterations: 4 });
    const bodies = Array.from({ length: 6 }, (_, i) =>
      addPlain(world, { position: [9 * i, i], velocity: [i, 1], angularVelocity: i, rotation: 0.1 * i }),
    );
    const times = new Set<number>();
    const look = (): void => {
      const time = bodies[0]!.getPosition()[1];
      times.add(Math.round((time / DT) * 4));
      bodies.forEach((body, i) => {
        const [x, y, angle] = [(9 + time) * i, i + time, (0.1 + time) * i];
        near([...body.getPosition(), body.getRotation()], [x, y, angle], 1e-12);
        near(body.transformLocalPointToWorld([1, 0]), [x + Math.cos(angle), y + Math.sin(angle)], 1e-12);
        near([...body.getVelocity(), body.getAngularVelocity()], [i, 1, i], 1e-12);
      });
    };
    const callbacks = { position: look, jacobian: look, positionClamp: look, velocityClamp: look };
    tie(world, phys2D.createCustomConstraint({ dimension: 1, bodies, ...callbacks }));
    world.step(DT);
    expect([...times]).toEqual([0, 1, 2, 3, 4]);
    near(bodies[5]!.transformLocalPointToWorld([0, 1]), [
      45 + 5 * DT - Math.sin(0.5 + 5 * DT),
      5 + DT + Math.cos(0.5 + 5 * DT),
    ]);
  });

  it('C-206 CUSTOM: `this` is the constraint, and `bodies` a copy', () => {
    const world = weightless();
    const list = [addPlain(world)];
    const contexts = new Set<unknown>();
    function note(this: unknown): void {
      contexts.add(this);
    }
    const callbacks = { positionConstants: note, position: note, jacobian: note, velocityClamp: note };
    const custom = phys2D.createCustomConstraint({ dimension: 1, bodies: list, ...callbacks, positionClamp: note });
    tie(world, custom);
    expect(custom.bodies).toEqual(list);
    expect(custom.bodies).not.toBe(list);
    list.pop();
    expect(custom.bodies).toHaveLength(1);
    world.step(DT);
    expect([...contexts]).toEqual([custom]);
  });
});
