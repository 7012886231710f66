import { describe, expect, it } from 'vitest';
import { type CustomConstraintParams, phys2D, type World } from '../../src/index.js';
import { add, DT, heavy, near, plainBody, staticBody, steps, tie, weightless } from '../conformance/setting.js';
import {
  type Bad,
  factory,
  NOT_BOOLEAN,
  NOT_FINITE,
  NOT_NON_NEGATIVE,
  NOT_NUMBERS,
  NOT_POSITIVE,
  NOT_VECTOR,
  refuses,
} from './refuses.js';

const NOT_BODY: Bad[] = [
  [undefined, TypeError, 'undefined'],
  [null, TypeError],
  [{}, TypeError, 'an object'],
];
const NOT_LIMIT: Bad[] = [...NOT_NUMBERS, [NaN, RangeError], [-1, RangeError, '-1']];
const NOT_BOUND: Bad[] = [...NOT_NUMBERS, [NaN, RangeError]];
const NOT_RATIO: Bad[] = [...NOT_FINITE, [0, RangeError, '0']];
const NOT_FUNCTION: Bad[] = [
  [1, TypeError, '1'],
  [null, TypeError],
];

const COMMON = {
  stiff: NOT_BOOLEAN,
  frequency: NOT_POSITIVE,
  damping: NOT_NON_NEGATIVE,
  maxForce: NOT_LIMIT,
  maxError: NOT_LIMIT,
  removeOnBreak: NOT_BOOLEAN,
  breakUnderForce: NOT_BOOLEAN,
  breakUnderError: NOT_BOOLEAN,
  ignoreInteractions: NOT_BOOLEAN,
};
const COMMON_NEW = { ...COMMON, sleeping: NOT_BOOLEAN, disabled: NOT_BOOLEAN };
const BODIES = { bodyA: NOT_BODY, bodyB: NOT_BODY };
const ANCHORS = { anchorA: NOT_VECTOR, anchorB: NOT_VECTOR };
const BOUNDS = {
  lowerBound: [...NOT_BOUND, [Infinity, RangeError]] as Bad[],
  upperBound: [...NOT_BOUND, [-Infinity, RangeError]] as Bad[],
};

const two = { bodyA: plainBody(), bodyB: plainBody() };
const four = { ...two, bodyC: plainBody(), bodyD: plainBody() };
const custom = { dimension: 1, bodies: [plainBody()], jacobian() {} };

factory('createPointConstraint', (p) => phys2D.createPointConstraint(p), two, { ...COMMON_NEW, ...BODIES, ...ANCHORS });
factory('createWeldConstraint', (p) => phys2D.createWeldConstraint(p), two, {
  ...COMMON_NEW,
  ...BODIES,
  ...ANCHORS,
  phase: NOT_FINITE,
});
factory('createDistanceConstraint', (p) => phys2D.createDistanceConstraint(p), two, {
  ...COMMON_NEW,
  ...BODIES,
  ...ANCHORS,
  ...BOUNDS,
  lowerBound: [...BOUNDS.lowerBound, [-1, RangeError, '-1'], [1, RangeError, '1']],
  upperBound: [...BOUNDS.upperBound, [-1, RangeError, '-1']],
});
factory(
  'createLineConstraint',
  (p) => phys2D.createLineConstraint(p),
  { ...two, axis: [1, 0] },
  {
    ...COMMON_NEW,
    ...BODIES,
    ...ANCHORS,
    ...BOUNDS,
    axis: [...NOT_VECTOR, [[0, 0], RangeError, 'an array of length 2']],
  },
);
factory('createAngleConstraint', (p) => phys2D.createAngleConstraint(p), two, {
  ...COMMON_NEW,
  ...BODIES,
  ...BOUNDS,
  ratio: NOT_RATIO,
});
factory('createMotorConstraint', (p) => phys2D.createMotorConstraint(p), two, {
  ...COMMON_NEW,
  ...BODIES,
  ratio: NOT_RATIO,
  rate: NOT_FINITE,
});
factory('createPulleyConstraint', (p) => phys2D.createPulleyConstraint(p), four, {
  ...COMMON_NEW,
  ...BODIES,
  bodyC: NOT_BODY,
  bodyD: NOT_BODY,
  ...ANCHORS,
  anchorC: NOT_VECTOR,
  anchorD: NOT_VECTOR,
  ...BOUNDS,
  ratio: NOT_RATIO,
});
factory('createCustomConstraint', (p) => phys2D.createCustomConstraint(p), custom, {
  ...COMMON_NEW,
  dimension: [...NOT_FINITE, [0, RangeError, '0'], [1.5, RangeError, '1.5'], [-1, RangeError, '-1']],
  bodies: [
    [undefined, TypeError, 'undefined'],
    [[], TypeError, 'an array of length 0'],
    [1, TypeError],
  ],
  jacobian: [[undefined, TypeError, 'undefined'], ...NOT_FUNCTION],
  position: NOT_FUNCTION,
  positionConstants: NOT_FUNCTION,
  velocityClamp: NOT_FUNCTION,
  positionClamp: NOT_FUNCTION,
  debugDraw: NOT_FUNCTION,
});

describe('constraints: bounds and bodies', () => {
  it('bounds that do not fit are refused, and the message shows both', () => {
    const makers: [string, (bounds: { lowerBound?: number; upperBound?: number }) => unknown][] = [
      ['createDistanceConstraint', (bounds) => phys2D.createDistanceConstraint({ ...two, ...bounds })],
      ['createLineConstraint', (bounds) => phys2D.createLineConstraint({ ...two, axis: [1, 0], ...bounds })],
      ['createAngleConstraint', (bounds) => phys2D.createAngleConstraint({ ...two, ...bounds })],
      ['createPulleyConstraint', (bounds) => phys2D.createPulleyConstraint({ ...four, ...bounds })],
    ];
    for (const [where, make] of makers) {
      expect(() => make({ lowerBound: 4, upperBound: 3 })).toThrow(RangeError);
      expect(() => make({ lowerBound: 4, upperBound: 3 })).toThrow(
        `${where}: upperBound must be >= lowerBound (4), got 3`,
      );
      expect(() => make({ lowerBound: 3, upperBound: 3 })).not.toThrow();
      expect(() => make({ lowerBound: 0, upperBound: Infinity })).not.toThrow();
    }
    expect(() => phys2D.createAngleConstraint({ ...two, lowerBound: 1 })).toThrow(
      'createAngleConstraint: lowerBound must be <= upperBound (0), got 1',
    );
    expect(() => phys2D.createPulleyConstraint({ ...four, lowerBound: 1 })).toThrow('lowerBound must be <= upperBound');
    expect(() => phys2D.createLineConstraint({ ...two, axis: [1, 0], lowerBound: -Infinity })).not.toThrow();
  });

  it('the body of a list that is none is named', () => {
    for (const wrong of [undefined, null, {}, 1, two]) {
      const bodies = [plainBody(), wrong] as never;
      expect(() => phys2D.createCustomConstraint({ ...custom, bodies })).toThrow(TypeError);
      expect(() => phys2D.createCustomConstraint({ ...custom, bodies })).toThrow(
        'createCustomConstraint: bodies[1] must be a RigidBody, got ',
      );
    }
  });

  it('a constraint or a world is no body, a body no constraint', () => {
    const angle = phys2D.createAngleConstraint(two);
    const world = weightless();
    for (const wrong of [angle, world, two.bodyA.shapes[0]]) {
      expect(() => phys2D.createAngleConstraint({ bodyA: wrong as never, bodyB: two.bodyB })).toThrow(
        'createAngleConstraint: bodyA must be a RigidBody, got an object',
      );
    }
    expect(() => world.addConstraint(two.bodyA as never)).toThrow(
      'World.addConstraint: constraint must be a Constraint',
    );
    expect(() => world.addRigidBody(angle as never)).toThrow('World.addRigidBody: body must be a RigidBody');
    expect([world.constraints, world.rigidBodies]).toEqual([[], []]);
  });

  it('a refused factory leaves the bodies alone', () => {
    const body = plainBody({ sleeping: true });
    expect(() => phys2D.createPointConstraint({ bodyA: body, bodyB: body, frequency: 0 })).toThrow(RangeError);
    expect([body.sleeping, body.constraints]).toEqual([true, []]);
  });
});

describe('constraints: setters', () => {
  it('refuse bad values, and change and wake nothing', () => {
    const world = weightless();
    const a = plainBody();
    const b = plainBody({ position: [3, 0] });
    add(world, a, b);
    const bodies = { bodyA: a, bodyB: b };
    const rope = phys2D.createDistanceConstraint({ ...bodies, upperBound: 5 });
    const line = phys2D.createLineConstraint({ ...bodies, axis: [1, 0], lowerBound: -5, upperBound: 5 });
    const gear = phys2D.createAngleConstraint(bodies);
    const motor = phys2D.createMotorConstraint(bodies);
    const pulley = phys2D.createPulleyConstraint({ ...bodies, bodyC: a, bodyD: b, upperBound: 20 });
    const weld = phys2D.createWeldConstraint({ ...bodies, anchorA: [3, 0] });
    const point = phys2D.createPointConstraint({ ...bodies, anchorA: [3, 0] });
    tie(world, rope, line, gear, motor, pulley, weld, point);
    steps(world, 63);
    expect(world.liveConstraints).toEqual([]);
    const state = () => [
      [rope.getLowerBound(), rope.getUpperBound(), rope.getAnchorA(), rope.getAnchorB()],
      [line.getAxis(), line.getLowerBound(), line.getUpperBound()],
      [line, pulley, weld, point].map((constraint) => [constraint.getAnchorA(), constraint.getAnchorB()]),
      [gear.getLowerBound(), gear.getUpperBound(), pulley.getLowerBound(), pulley.getUpperBound(), pulley.getRatio()],
      [gear.getRatio(), motor.getRatio(), motor.getRate(), pulley.getAnchorC(), pulley.getAnchorD(), weld.getPhase()],
    ];
    const before = state();
    const setters: [string, string, (value: never) => void, readonly Bad[]][] = [
      [
        'DistanceConstraint.setLowerBound',
        'lowerBound',
        (v) => rope.setLowerBound(v),
        [
          [6, RangeError],
          [-1, RangeError],
          [NaN, RangeError],
          [Infinity, RangeError],
          ['1', TypeError, '"1"'],
        ],
      ],
      ['PointConstraint.setAnchorA', 'anchor', (v) => point.setAnchorA(v), NOT_VECTOR],
      ['PointConstraint.setAnchorB', 'anchor', (v) => point.setAnchorB(v), NOT_VECTOR],
      ['WeldConstraint.setAnchorA', 'anchor', (v) => weld.setAnchorA(v), NOT_VECTOR],
      ['WeldConstraint.setAnchorB', 'anchor', (v) => weld.setAnchorB(v), NOT_VECTOR],
      ['LineConstraint.setAnchorA', 'anchor', (v) => line.setAnchorA(v), NOT_VECTOR],
      ['LineConstraint.setAnchorB', 'anchor', (v) => line.setAnchorB(v), NOT_VECTOR],
      ['PulleyConstraint.setAnchorA', 'anchor', (v) => pulley.setAnchorA(v), NOT_VECTOR],
      ['PulleyConstraint.setAnchorB', 'anchor', (v) => pulley.setAnchorB(v), NOT_VECTOR],
      ['DistanceConstraint.setUpperBound', 'upperBound', (v) => rope.setUpperBound(v), NOT_LIMIT],
      ['DistanceConstraint.setAnchorA', 'anchor', (v) => rope.setAnchorA(v), NOT_VECTOR],
      ['DistanceConstraint.setAnchorB', 'anchor', (v) => rope.setAnchorB(v), NOT_VECTOR],
      ['LineConstraint.setAxis', 'axis', (v) => line.setAxis(v), NOT_VECTOR],
      ['LineConstraint.setLowerBound', 'lowerBound', (v) => line.setLowerBound(v), [...NOT_BOUND, [6, RangeError]]],
      ['LineConstraint.setUpperBound', 'upperBound', (v) => line.setUpperBound(v), [...NOT_BOUND, [-6, RangeError]]],
      ['AngleConstraint.setRatio', 'ratio', (v) => gear.setRatio(v), NOT_RATIO],
      ['AngleConstraint.setLowerBound', 'lowerBound', (v) => gear.setLowerBound(v), [...NOT_BOUND, [1, RangeError]]],
      ['AngleConstraint.setUpperBound', 'upperBound', (v) => gear.setUpperBound(v), [...NOT_BOUND, [-1, RangeError]]],
      ['MotorConstraint.setRatio', 'ratio', (v) => motor.setRatio(v), NOT_RATIO],
      ['MotorConstraint.setRate', 'rate', (v) => motor.setRate(v), NOT_FINITE],
      ['PulleyConstraint.setRatio', 'ratio', (v) => pulley.setRatio(v), NOT_RATIO],
      ['PulleyConstraint.setAnchorC', 'anchor', (v) => pulley.setAnchorC(v), NOT_VECTOR],
      ['PulleyConstraint.setAnchorD', 'anchor', (v) => pulley.setAnchorD(v), NOT_VECTOR],
      [
        'PulleyConstraint.setLowerBound',
        'lowerBound',
        (v) => pulley.setLowerBound(v),
        [...NOT_BOUND, [21, RangeError]],
      ],
      [
        'PulleyConstraint.setUpperBound',
        'upperBound',
        (v) => pulley.setUpperBound(v),
        [...NOT_BOUND, [-1, RangeError]],
      ],
      ['WeldConstraint.setPhase', 'phase', (v) => weld.setPhase(v), NOT_FINITE],
      ['Constraint.getImpulseForBody', 'body', (v) => weld.getImpulseForBody(v), NOT_BODY],
      ['Constraint.addEventListener', 'handler', (v) => weld.addEventListener('break', v), NOT_FUNCTION],
      ['World.addConstraint', 'constraint', (v) => world.addConstraint(v), NOT_BODY],
      ['World.removeConstraint', 'constraint', (v) => world.removeConstraint(v), NOT_BODY],
    ];
    for (const [where, name, set, values] of setters) {
      for (const bad of values) {
        refuses(set, where, name, bad);
      }
    }
    for (const [name, values] of Object.entries(COMMON)) {
      for (const bad of values) {
        refuses((value) => rope.configure({ damping: 7, [name]: value }), 'Constraint.configure', name, bad);
      }
    }
    refuses((value) => rope.configure(value), 'Constraint.configure', 'params', [null, TypeError]);
    expect(() => weld.setAnchorA([0, NaN])).toThrow('WeldConstraint.setAnchorA: anchor[1] must be a finite number');
    expect(() => line.setAxis([Infinity, 0])).toThrow('LineConstraint.setAxis: axis[0] must be a finite number');
    expect(state()).toEqual(before);
    expect(world.liveConstraints).toEqual([]);
    expect([a.sleeping, b.sleeping]).toEqual([true, true]);
  });
});

describe('custom constraints: callbacks', () => {
  const good: Pick<CustomConstraintParams, 'position' | 'jacobian' | 'velocityClamp' | 'positionClamp'> = {
    position(data, index) {
      data[index] = this.bodies[0]!.getPosition()[1] - 2;
    },
    jacobian(data, index) {
      data[index + 1] = 1;
    },
    velocityClamp() {},
    positionClamp() {},
  };

  /** A custom constraint whose callback `name` does something bad while `fails` is set, beside a joint that has to hold. */
  function setUp(name: keyof typeof good, bad: (data: { [index: number]: number }, index: number) => void) {
    const world: World = heavy();
    const body = plainBody({ position: [0, 2] });
    const hung = plainBody({ position: [5, 1] });
    add(world, body, hung);
    tie(
      world,
      phys2D.createPointConstraint({ bodyA: staticBody({ position: [5, 0] }), bodyB: hung, anchorB: [0, -1] }),
    );
    const state = { fails: false };
    const constraint = phys2D.createCustomConstraint({
      ...good,
      dimension: 1,
      bodies: [body],
      [name](this: never, data: { [index: number]: number }, index: number) {
        if (state.fails) bad(data, index);
        else good[name]!.call(this, data as never, index);
      },
    });
    tie(world, constraint);
    return { world, body, hung, state };
  }

  for (const name of ['position', 'jacobian', 'velocityClamp', 'positionClamp'] as const) {
    for (const value of [NaN, Infinity]) {
      it(`${name} that writes ${value}: the step throws, names the constraint, and the world goes on`, () => {
        const { world, body, hung, state } = setUp(name, (data, index) => {
          data[index] = value;
        });
        steps(world, 10);
        state.fails = true;
        for (let i = 0; i < 3; i += 1) {
          expect(() => world.step(DT)).toThrow(
            `CustomConstraint.${name} of world.constraints[1]: data[index + 0] must be a finite number, got ${value}`,
          );
        }
        expect(world.timeStamp).toBe(13);
        expect([...body.getPosition(), ...body.getVelocity()].every(Number.isFinite)).toBe(true);
        state.fails = false;
        steps(world, 60);
        near(body.getPosition(), [0, 2], 1e-3);
        near(hung.getPosition(), [5, 1], 1e-3);
      });
    }

    it(`${name} that throws: its error comes out of the step, and the world goes on`, () => {
      const { world, body, hung, state } = setUp(name, () => {
        throw new Error('mine');
      });
      steps(world, 10);
      state.fails = true;
      expect(() => world.step(DT)).toThrow('mine');
      expect(world.timeStamp).toBe(11);
      state.fails = false;
      steps(world, 60);
      near(body.getPosition(), [0, 2], 1e-3);
      near(hung.getPosition(), [5, 1], 1e-3);
    });
  }

  it('the row and the place in it are named, in every scheme; others still hold', () => {
    for (const params of [{}, { stiff: false }, { stiff: false, breakUnderForce: true, maxForce: 1e6 }]) {
      for (const substeps of [1, 4]) {
        for (const name of ['position', 'jacobian', 'velocityClamp', 'positionClamp', undefined] as const) {
          if (name === 'positionClamp' && params.stiff === false) {
            continue;
          }
          const world = heavy({ substeps });
          const [a, b] = [plainBody({ position: [0, 2] }), plainBody({ position: [3, 2] })];
          const hung = plainBody({ position: [5, 1] });
          add(world, a, b, hung);
          const anchor = staticBody({ position: [5, 0] });
          const before = phys2D.createDistanceConstraint({ bodyA: anchor, bodyB: hung, lowerBound: 1, upperBound: 1 });
          let fails = false;
          const spoil = (data: { [index: number]: number }, index: number): void => {
            data[index + (name === 'jacobian' ? 10 : 1)] = -Infinity;
          };
          const constraint = phys2D.createCustomConstraint({
            ...params,
            dimension: 2,
            bodies: [a, b],
            position(data, index) {
              data[index] = a.getPosition()[1] - 2;
              data[index + 1] = b.getPosition()[1] - 2;
              if (fails && name === 'position') spoil(data, index);
            },
            jacobian(data, index) {
              data[index + 1] = 1;
              data[index + 10] = 1;
              if (fails && name === 'jacobian') spoil(data, index);
            },
            positionConstants() {
              if (fails && name === undefined) throw new Error('constants');
            },
            velocityClamp(data, index) {
              if (fails && name === 'velocityClamp') spoil(data, index);
            },
            positionClamp(data, index) {
              if (fails && name === 'positionClamp') spoil(data, index);
            },
          });
          tie(world, before, constraint);
          steps(world, 30);
          fails = true;
          const message =
            name === undefined
              ? 'constants'
              : `CustomConstraint.${name} of world.constraints[1]: data[index + ${name === 'jacobian' ? 10 : 1}] must be`;
          for (let i = 1; i <= 20; i += 1) {
            expect(() => world.step(DT)).toThrow(message);
            expect(world.timeStamp).toBe(30 + i);
            for (const body of [a, b, hung]) {
              expect([...body.getPosition(), ...body.getVelocity(), body.getRotation()].every(Number.isFinite)).toBe(
                true,
              );
              expect(constraint.getImpulseForBody(body).every(Number.isFinite)).toBe(true);
            }
          }
          near(hung.getPosition(), [5, 1], 1e-3);
          fails = false;
          steps(world, 60);
          near([...a.getPosition(), ...b.getPosition()], [0, 2, 3, 2], params.stiff === false ? 0.05 : 1e-3);
          expect(world.constraints).toEqual([before, constraint]);
        }
      }
    }
  });

  it('the index in the message is the present one', () => {
    const { world, state } = setUp('jacobian', (data, index) => {
      data[index] = NaN;
    });
    state.fails = true;
    world.removeConstraint(world.constraints[0]!);
    expect(() => world.step(DT)).toThrow('CustomConstraint.jacobian of world.constraints[0]: data[index + 0]');
  });

  it('cannot step, add or remove', () => {
    const { world, body, state } = setUp('jacobian', () => {
      expect(world.removeRigidBody(body)).toBe(false);
      world.step(DT);
    });
    state.fails = true;
    expect(() => world.step(DT)).toThrow('World.step: must not be called from a handler or callback');
    expect(world.rigidBodies).toContain(body);
  });
});
