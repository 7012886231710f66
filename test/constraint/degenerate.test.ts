import { describe, expect, it } from 'vitest';
import {
  type Constraint,
  type ConstraintParams,
  phys2D,
  type RigidBody,
  type RigidBodyParams,
  type World,
} from '../../src/index.js';
import {
  add,
  DT,
  disc,
  heavy,
  near,
  plainBody,
  speed,
  staticBody,
  steps,
  tie,
  weightless,
} from '../conformance/setting.js';

// Constraints that can do little or nothing: immovable bodies, a body tied to itself, rows that say the same twice.

/** A constraint and how far it is from being met. */
interface Made {
  readonly constraint: Constraint;
  readonly error: () => number;
}

const length = (x: number, y: number): number => Math.sqrt(x * x + y * y);

function offset(a: RigidBody, anchorA: readonly [number, number], b: RigidBody, anchorB: readonly [number, number]) {
  const [ax, ay] = a.transformLocalPointToWorld(anchorA);
  const [bx, by] = b.transformLocalPointToWorld(anchorB);
  return [bx - ax, by - ay] as const;
}

const P = [0.5, 0] as const;
const Q = [-0.5, 0] as const;
const O = [0, 0] as const;

/** One of each kind between two bodies that stand near [0, 0] and [2, 1]; none is met there. */
const KINDS: Record<string, (bodyA: RigidBody, bodyB: RigidBody, params?: ConstraintParams) => Made> = {
  POINT: (bodyA, bodyB, params) => ({
    constraint: phys2D.createPointConstraint({ bodyA, bodyB, anchorA: P, anchorB: Q, ...params }),
    error: () => length(...offset(bodyA, P, bodyB, Q)),
  }),
  WELD: (bodyA, bodyB, params) => ({
    constraint: phys2D.createWeldConstraint({ bodyA, bodyB, anchorA: P, anchorB: Q, phase: 0.5, ...params }),
    error: () => length(...offset(bodyA, P, bodyB, Q)) + Math.abs(bodyB.getRotation() - bodyA.getRotation() - 0.5),
  }),
  ANGLE: (bodyA, bodyB, params) => ({
    constraint: phys2D.createAngleConstraint({ bodyA, bodyB, ratio: 2, lowerBound: 0.5, upperBound: 0.5, ...params }),
    error: () => Math.abs(2 * bodyB.getRotation() - bodyA.getRotation() - 0.5),
  }),
  DISTANCE: (bodyA, bodyB, params) => ({
    constraint: phys2D.createDistanceConstraint({
      bodyA,
      bodyB,
      anchorA: P,
      lowerBound: 1.5,
      upperBound: 1.5,
      ...params,
    }),
    error: () => Math.abs(length(...offset(bodyA, P, bodyB, O)) - 1.5),
  }),
  LINE: (bodyA, bodyB, params) => ({
    constraint: phys2D.createLineConstraint({ bodyA, bodyB, axis: [1, 0], lowerBound: -1, upperBound: 1, ...params }),
    error: () => {
      const [x, y] = bodyA.transformWorldVectorToLocal([...offset(bodyA, O, bodyB, O)]);
      return Math.abs(y) + Math.max(0, Math.abs(x) - 1);
    },
  }),
  MOTOR: (bodyA, bodyB, params) => ({
    constraint: phys2D.createMotorConstraint({ bodyA, bodyB, ratio: 2, rate: 3, ...params }),
    error: () => Math.abs(2 * bodyB.getAngularVelocity() - bodyA.getAngularVelocity() - 3),
  }),
  PULLEY: (bodyA, bodyD, params) => {
    const [bodyB, bodyC] = [staticBody({ position: [0, -3] }), staticBody({ position: [2, -3] })];
    const bounds = { ratio: 2, lowerBound: 12, upperBound: 12 };
    return {
      constraint: phys2D.createPulleyConstraint({ bodyA, bodyB, bodyC, bodyD, ...bounds, ...params }),
      error: () => Math.abs(length(...offset(bodyA, O, bodyB, O)) + 2 * length(...offset(bodyC, O, bodyD, O)) - 12),
    };
  },
  CUSTOM: (bodyA, bodyB, params) => {
    const error = (): number => offset(bodyA, O, bodyB, O)[0] - 1;
    const constraint = phys2D.createCustomConstraint({
      dimension: 1,
      bodies: [bodyA, bodyB],
      position(data, index) {
        data[index] = error();
      },
      jacobian(data, index) {
        data[index] = -1;
        data[index + 3] = 1;
      },
      ...params,
    });
    return { constraint, error: () => Math.abs(error()) };
  },
};

const state = (body: RigidBody): number[] => [
  ...body.getPosition(),
  body.getRotation(),
  ...body.getVelocity(),
  body.getAngularVelocity(),
];

/** All numbers that can be seen are finite. */
function allFinite(world: World): boolean {
  const { rigidBodies, constraints } = world;
  return rigidBodies.every(
    (body) =>
      state(body).every(Number.isFinite) &&
      constraints.every((constraint) => constraint.getImpulseForBody(body).every(Number.isFinite)),
  );
}

/** Bodies without shapes do not get into each other's way. */
const free = (params: RigidBodyParams = {}): RigidBody => plainBody({ shapes: [], ...params });

const IMMOVABLE: Record<string, RigidBodyParams> = {
  static: { type: 'static' },
  kinematic: { type: 'kinematic' },
  'of infinite mass and inertia': { mass: Infinity, inertia: Infinity },
};

for (const [kind, make] of Object.entries(KINDS)) {
  for (const stiff of [true, false]) {
    describe(`${kind}, ${stiff ? 'stiff' : 'elastic'}`, () => {
      it('between two immovable bodies does nothing', () => {
        for (const a of Object.values(IMMOVABLE)) {
          for (const b of Object.values(IMMOVABLE)) {
            const world = heavy();
            const bodies = [free(a), free({ ...b, position: [2, 1] })] as const;
            add(world, ...bodies);
            const before = bodies.map(state);
            const { constraint } = make(...bodies, { stiff });
            tie(world, constraint);
            steps(world, 70);
            expect(bodies.map(state)).toEqual(before);
            expect(bodies.map((body) => constraint.getImpulseForBody(body))).toEqual([O.concat(0), O.concat(0)]);
            expect([constraint.sleeping, world.liveConstraints]).toEqual([true, []]);
          }
        }
      });

      it('leaves the motion of kinematic bodies as it is', () => {
        const world = heavy();
        const motion = { type: 'kinematic', velocity: [1, 2], angularVelocity: 3 } as const;
        const bodies = [free(motion), free({ ...motion, position: [2, 1] })] as const;
        add(world, ...bodies);
        tie(world, make(...bodies, { stiff }).constraint);
        steps(world, 60);
        near(state(bodies[0]), [1, 2, 3, 1, 2, 3], 1e-9);
        near(state(bodies[1]), [3, 3, 3, 1, 2, 3], 1e-9);
      });

      for (const [name, params] of Object.entries(IMMOVABLE)) {
        it(`moves the other body alone if one is ${name}`, () => {
          for (const isFirst of [true, false]) {
            const world = weightless();
            const a = free(isFirst ? params : {});
            const b = free({ ...(isFirst ? {} : params), position: [2, 1] });
            add(world, a, b);
            const fixed = isFirst ? a : b;
            const before = state(fixed);
            const { constraint, error } = make(a, b, { stiff });
            tie(world, constraint);
            steps(world, 60);
            expect(state(fixed)).toEqual(before);
            expect(allFinite(world)).toBe(true);
            expect(error()).toBeLessThan(0.01);
          }
        });
      }

      it('never pushes what has an infinite mass, nor turns what has an infinite inertia', () => {
        for (const isFirst of [true, false]) {
          for (const name of ['mass', 'inertia'] as const) {
            for (const other of [{}, { type: 'static' }, { mass: Infinity }, { inertia: Infinity }] as const) {
              const world = weightless();
              const half = { [name]: Infinity };
              const a = free(isFirst ? half : other);
              const b = free({ ...(isFirst ? other : half), position: [2, 1] });
              add(world, a, b);
              const { constraint } = make(a, b, { stiff });
              tie(world, constraint);
              const [x, y, turn] = state(isFirst ? a : b);
              for (let i = 0; i < 60; i += 1) {
                world.step(DT);
                expect(allFinite(world)).toBe(true);
              }
              const [x1, y1, turn1] = state(isFirst ? a : b);
              expect(name === 'mass' ? [x1, y1] : [turn1]).toEqual(name === 'mass' ? [x, y] : [turn]);
            }
          }
        }
      });

      it('from a body to itself does nothing', () => {
        const world = heavy();
        const body = free({ velocity: [1, 0], angularVelocity: 2 });
        const twin = free({ velocity: [1, 0], angularVelocity: 2 });
        add(world, body, twin);
        const { constraint } = kind === 'PULLEY' ? itself(body, stiff) : make(body, body, { stiff });
        tie(world, constraint);
        for (let i = 0; i < 60; i += 1) {
          world.step(DT);
          near(state(body), state(twin), 1e-9);
        }
        near(constraint.getImpulseForBody(body), [0, 0, 0], 1e-9);
        expect(body.constraints).toEqual([constraint]);
      });
    });
  }
}

/** All four bodies of the pulley are one. */
function itself(body: RigidBody, stiff: boolean): Pick<Made, 'constraint'> {
  const anchors = { anchorA: [1, 0], anchorB: [0, 2], anchorC: [-1, 1], anchorD: [0, -3] } as const;
  const bodies = { bodyA: body, bodyB: body, bodyC: body, bodyD: body };
  return { constraint: phys2D.createPulleyConstraint({ ...bodies, ...anchors, stiff }) };
}

describe('a pulley whose middle is one body', () => {
  it('keeps the sum, and the body gets both impulses [D-21]', () => {
    for (const stiff of [true, false]) {
      const world = heavy();
      const top = staticBody({ position: [0, -4] });
      const [a, middle, d] = [free({ position: [-2, 2] }), free(), free({ position: [2, 3] })];
      add(world, a, middle, d);
      tie(world, phys2D.createPointConstraint({ bodyA: top, bodyB: middle, anchorB: [0, -4] }));
      const bodies = { bodyA: a, bodyB: middle, bodyC: middle, bodyD: d };
      const anchors = { anchorB: [-2, 0], anchorC: [2, 0] } as const;
      const bounds = { ratio: 2, lowerBound: 8, upperBound: 8 };
      const pulley = phys2D.createPulleyConstraint({ ...bodies, ...anchors, ...bounds, stiff });
      tie(world, pulley);
      expect(middle.constraints.filter((constraint) => constraint === pulley)).toHaveLength(1);
      for (let i = 0; i < 60; i += 1) {
        world.step(DT);
        const sum = length(...offset(a, O, middle, [-2, 0])) + 2 * length(...offset(middle, [2, 0], d, O));
        near(sum, 8, stiff ? 0.01 : 0.1);
        const total = [a, middle, d].map((body) => pulley.getImpulseForBody(body));
        near(total[1]!.slice(0, 2), [-total[0]![0] - total[2]![0], -total[0]![1] - total[2]![1]], 1e-9);
      }
      expect(length(...(pulley.getImpulseForBody(d).slice(0, 2) as [number, number]))).toBeGreaterThan(0.01);
      world.removeConstraint(pulley);
      expect(middle.constraints).toHaveLength(1);
    }
  });
});

describe('custom constraints', () => {
  /** x and spin of one body, y and spin of another, weighed against each other. */
  const ROW = [1, 0.5, 0.3, -0.5, 2, -0.7];
  /** A row over two bodies whose columns are dealt out over the places where the bodies are listed. */
  function weighed(a: RigidBody, b: RigidBody, isSplit: boolean, params: ConstraintParams) {
    const target = (): number => {
      const [ax, ay, at] = state(a);
      const [bx, by, bt] = state(b);
      return [ax, ay, at, bx, by, bt].reduce((sum: number, value, i) => sum + ROW[i]! * value!, 0);
    };
    return phys2D.createCustomConstraint({
      dimension: 1,
      bodies: isSplit ? [a, b, a, b] : [a, b],
      position(data, index) {
        data[index] = target();
      },
      jacobian(data, index) {
        ROW.forEach((value, i) => {
          data[index + i] = isSplit ? 0.25 * value : value;
          if (isSplit) data[index + 6 + i] = 0.75 * value;
        });
      },
      ...params,
    });
  }

  it('a body listed twice moves as with the sum of its columns', () => {
    for (const params of [{}, { stiff: false, frequency: 2 }, { maxForce: 2, stiff: false }]) {
      const run = (isSplit: boolean): number[][] => {
        const world = weightless();
        const [a, b] = [free({ velocity: [1, 2] }), free({ position: [2, 1], angularVelocity: 2, mass: 3 })];
        add(world, a, b);
        const constraint = weighed(a, b, isSplit, params);
        tie(world, constraint);
        expect(a.constraints).toEqual([constraint]);
        const path: number[][] = [];
        for (let i = 0; i < 60; i += 1) {
          world.step(DT);
          path.push(state(a), state(b), constraint.getImpulseForBody(a), constraint.getImpulseForBody(b));
        }
        world.removeRigidBody(a);
        expect(b.constraints).toEqual([]);
        return path;
      };
      const [split, whole] = [run(true), run(false)];
      split.forEach((numbers, i) => {
        near(numbers, whole[i]!, 1e-9);
      });
    }
  });

  it('two equal rows act as one', () => {
    for (const params of [{}, { stiff: false, frequency: 2 }]) {
      for (const positional of [true, false]) {
        const run = (rows: number): number[][] => {
          const world = heavy();
          const body = free({ position: [1, 0], velocity: [2, 1] });
          add(world, body);
          const constraint = phys2D.createCustomConstraint({
            dimension: rows,
            bodies: [body],
            jacobian(data, index) {
              for (let d = 0; d < rows; d += 1) {
                data[index + 3 * d] = 1;
                data[index + 3 * d + 1] = 0.5;
              }
            },
            ...(positional && {
              position(data: { [index: number]: number }, index: number) {
                for (let d = 0; d < rows; d += 1) {
                  data[index + d] = body.getPosition()[0] + 0.5 * body.getPosition()[1];
                }
              },
            }),
            ...params,
          });
          tie(world, constraint);
          const path: number[][] = [];
          for (let i = 0; i < 60; i += 1) {
            world.step(DT);
            path.push(state(body), constraint.getImpulseForBody(body));
          }
          return path;
        };
        const [two, one] = [run(2), run(1)];
        two.forEach((numbers, i) => {
          near(numbers, one[i]!, 1e-9);
        });
      }
    }
  });

  it('a row of zeros does nothing', () => {
    const world = heavy();
    const body = free({ position: [1, 0] });
    add(world, body);
    const constraint = phys2D.createCustomConstraint({
      dimension: 2,
      bodies: [body],
      position(data, index) {
        data[index] = 7;
        data[index + 1] = body.getPosition()[1];
      },
      jacobian(data, index) {
        data[index + 4] = 1;
      },
    });
    tie(world, constraint);
    steps(world, 60);
    near(state(body), [1, 0, 0, 0, 0, 0], 1e-3);
  });
});

describe('two constraints that say the same', () => {
  for (const [kind, make] of Object.entries(KINDS)) {
    it(`${kind}: are met as one is`, () => {
      const world = weightless();
      const [a, b] = [free(), free({ position: [2, 1] })];
      add(world, a, b);
      const [one, other] = [make(a, b), make(a, b)];
      tie(world, one.constraint, other.constraint);
      steps(world, 60);
      expect(allFinite(world)).toBe(true);
      expect(one.error()).toBeLessThan(0.01);
      if (kind !== 'MOTOR') expect(speed(a) + speed(b)).toBeLessThan(0.05);
    });
  }
});

describe('bodies that are not in the world', () => {
  for (const [kind, make] of Object.entries(KINDS).filter(([name]) => name !== 'MOTOR')) {
    it(`${kind}: follows an anchor in no world that is moved and turned`, () => {
      for (const isFirst of [true, false]) {
        const world = weightless();
        const anchor = staticBody(isFirst ? {} : { position: [2, 1] });
        const body = free(isFirst ? { position: [2, 1] } : {});
        add(world, body);
        const { constraint, error } = isFirst ? make(anchor, body) : make(body, anchor);
        tie(world, constraint);
        steps(world, 30);
        expect(error()).toBeLessThan(0.01);
        anchor.setPosition([anchor.getPosition()[0] + 0.1, 0.8]);
        body.wake();
        steps(world, 10);
        expect(error()).toBeLessThan(0.01);
        anchor.setRotation(0.4);
        body.wake();
        steps(world, 10);
        expect(error()).toBeLessThan(0.01);
      }
    });
  }

  it('an anchor in no world that becomes dynamic makes the constraint inert, and the other way round [D-05]', () => {
    const world = heavy();
    const anchor = staticBody();
    const body = free({ position: [0, 1] });
    add(world, body);
    tie(world, phys2D.createPointConstraint({ bodyA: anchor, bodyB: body, anchorB: [0, -1] }));
    steps(world, 10);
    anchor.setAsDynamic();
    steps(world, 30);
    near(body.getVelocity(), [0, 5], 0.01);
    anchor.setAsStatic();
    steps(world, 60);
    near(body.transformLocalPointToWorld([0, -1]), [0, 0], 0.01);
  });

  it('an inert constraint gives no impulse', () => {
    const world = heavy();
    const anchor = staticBody();
    const body = free({ position: [0, 1] });
    add(world, body);
    const hinge = phys2D.createPointConstraint({ bodyA: anchor, bodyB: body, anchorB: [0, -1] });
    tie(world, hinge);
    steps(world, 10);
    anchor.setAsDynamic();
    world.step(DT);
    near(hinge.getImpulseForBody(body), [0, 0, 0], 0);
    near(hinge.getImpulseForBody(anchor), [0, 0, 0], 0);
  });

  it('a static body of another world: waking it there leaves this world alone', () => {
    const [here, there] = [weightless(), weightless()];
    const foreign = plainBody({ type: 'static' });
    const body = plainBody({ position: [3, 0] });
    add(there, foreign);
    add(here, body);
    const rope = phys2D.createDistanceConstraint({ bodyA: foreign, bodyB: body, upperBound: 5 });
    tie(here, rope);
    steps(here, 63);
    expect(rope.sleeping).toBe(true);
    expect(() => foreign.setSurfaceVelocity([1, 0])).not.toThrow();
    expect([there.liveConstraints, there.liveDynamics]).toEqual([[], []]);
  });

  it('a kinematic body of another world moves no stranger', () => {
    const [here, there] = [weightless(), weightless()];
    const foreign = free({ type: 'kinematic', velocity: [1, 0] });
    add(there, free(), free(), foreign);
    const bodies = [0, 1, 2, 3, 4].map((i) => free({ position: [0, 5 * i] }));
    add(here, ...bodies);
    tie(here, phys2D.createPointConstraint({ bodyA: foreign, bodyB: bodies[0]! }));
    for (let i = 0; i < 30; i += 1) {
      there.step(DT);
      here.step(DT);
    }
    expect(bodies.slice(1).map((body) => state(body))).toEqual([1, 2, 3, 4].map((i) => [0, 5 * i, 0, 0, 0, 0]));
  });
});

describe('joint against contact', () => {
  for (const stiff of [true, false]) {
    for (const type of ['static', 'dynamic'] as const) {
      for (const substeps of [1, 4]) {
        it(`${stiff ? 'stiff' : 'elastic'}, ${type}, ${substeps} sub-steps: bodies that stand have no velocity, and sleep`, () => {
          const found = [0.001, 0.005, 0.01, 0.02, 0.05, 0.1, 0.3].map((overlap) => {
            const world = weightless({ substeps });
            const a = phys2D.createRigidBody({ type, shapes: [disc(0.5)] });
            const b = phys2D.createRigidBody({ shapes: [disc(0.5)], position: [1 - overlap, 0] });
            add(world, a, b);
            tie(world, phys2D.createPointConstraint({ bodyA: a, bodyB: b, anchorA: [1 - overlap, 0], stiff }));
            steps(world, 60);
            const before = b.getPosition()[0] - a.getPosition()[0];
            world.step(DT);
            // Without sub-steps the two corrections can take turns between dynamic bodies, 12 mm to and fro at most, and keep them awake.
            const takesTurns = stiff && substeps === 1 && type === 'dynamic';
            near(b.getPosition()[0] - a.getPosition()[0], before, takesTurns ? 0.015 : 1e-4);
            const fastest = Math.max(speed(a), speed(b));
            steps(world, 300);
            return { overlap, isSlow: fastest < 0.03, sleeps: b.sleeping || takesTurns };
          });
          expect(found.filter(({ isSlow, sleeps }) => !isSlow || !sleeps)).toEqual([]);
        });
      }
    }
  }
});
