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
factory('createWeldConstraint', (p) => phys2D.createWeldConstraint(p), two, { ...BODIES, phase: NOT_FINITE });
factory('createDistanceConstraint', (p) => phys2D.createDistanceConstraint(p), two, {
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
    ...BODIES,
    ...ANCHORS,
    ...BOUNDS,
    axis: [...NOT_VECTOR, [[0, 0], RangeError, '"one of length 0"']],
  },
);
factory('createAngleConstraint', (p) => phys2D.createAngleConstraint(p), two, {
  ...BODIES,
  ...BOUNDS,
  ratio: NOT_RATIO,
});
factory('createMotorConstraint', (p) => phys2D.createMotorConstraint(p), two, {
  ...BODIES,
  ratio: NOT_RATIO,
  rate: NOT_FINITE,
});
factory('createPulleyConstraint', (p) => phys2D.createPulleyConstraint(p), four, {
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
    tie(world, rope, line, gear, motor, pulley, weld);
    steps(world, 63);
    expect(world.liveConstraints).toEqual([]);
    const state = () => [
      [rope.getLowerBound(), rope.getUpperBound(), rope.getAnchorA(), rope.getAnchorB()],
      [line.getAxis(), line.getLowerBound(), line.getUpperBound()],
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
        ],
      ],
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
      ['PulleyConstraint.setLowerBound', 'lowerBound', (v) => pulley.setLowerBound(v), NOT_BOUND],
      ['PulleyConstraint.setUpperBound', 'upperBound', (v) => pulley.setUpperBound(v), NOT_BOUND],
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
