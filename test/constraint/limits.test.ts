import { describe, expect, it } from 'vitest';
import { type Constraint, phys2D, type RigidBody } from '../../src/index.js';
import { add, heavy, near, plainBody, staticBody, steps, tie, weightless } from '../conformance/setting.js';

// What a constraint may give at most is meant for the whole step, however many parts that is solved in.

const WEIGHT = 6;

type Limits = { maxForce: number; breakUnderForce?: boolean };

/** Constraints that hold a body of mass 1 at the origin against its weight. */
const KINDS: Record<string, (body: RigidBody, limits: Limits) => Constraint> = {
  POINT: (bodyB, limits) => phys2D.createPointConstraint({ bodyA: staticBody(), bodyB, ...limits }),
  WELD: (bodyB, limits) => phys2D.createWeldConstraint({ bodyA: staticBody(), bodyB, ...limits }),
  DISTANCE: (bodyB, limits) =>
    phys2D.createDistanceConstraint({
      bodyA: staticBody(),
      bodyB,
      anchorA: [0, -3],
      lowerBound: 0,
      upperBound: 3,
      ...limits,
    }),
  LINE: (bodyB, limits) =>
    phys2D.createLineConstraint({
      bodyA: staticBody(),
      bodyB,
      axis: [1, 0],
      lowerBound: -9,
      upperBound: 9,
      ...limits,
    }),
  CUSTOM: (body, limits) =>
    phys2D.createCustomConstraint({
      dimension: 2,
      bodies: [body],
      jacobian(data, index) {
        data[index] = 1;
        data[index + 4] = 1;
      },
      ...limits,
    }),
};

/** A body that hangs on a constraint. */
function hang(kind: string, substeps: number, limits: Limits) {
  const world = heavy({ gravity: [0, WEIGHT], substeps });
  const body = plainBody();
  add(world, body);
  const constraint = KINDS[kind]!(body, limits);
  tie(world, constraint);
  return { world, body, constraint };
}

describe.each(Object.keys(KINDS))('%s', (kind) => {
  it.each([1, 4])('breaks at once under more than its force and holds under less, with %d sub-steps', (substeps) => {
    for (const share of [0.9, 1.1]) {
      const { world, constraint } = hang(kind, substeps, { maxForce: share * WEIGHT, breakUnderForce: true });
      steps(world, share > 1 ? 50 : 1);
      expect(constraint.world, `${share} of the weight`).toBe(share > 1 ? world : null);
    }
  });

  it.each([1, 4])('gives the weight, with %d sub-steps', (substeps) => {
    const { world, body, constraint } = hang(kind, substeps, { maxForce: 2 * WEIGHT });
    steps(world, 30);
    near(constraint.getImpulseForBody(body).slice(0, 2), [0, -WEIGHT / 60], 1e-6);
  });
});

it.each([1, 4])('a custom constraint of velocities gives its force and no more, with %d sub-steps', (substeps) => {
  const { world, body, constraint } = hang('CUSTOM', substeps, { maxForce: 4 });
  steps(world, 30);
  near(constraint.getImpulseForBody(body).slice(0, 2), [0, -4 / 60], 1e-9);
  near(body.getVelocity(), [0, (30 * (WEIGHT - 4)) / 60], 1e-9);
});

/** Constraints that keep two bodies of mass 1, at x = −1 and x = 1, together. */
const PAIRS: Record<string, (bodyA: RigidBody, bodyB: RigidBody, limits: Partial<Limits>) => Constraint> = {
  POINT: (bodyA, bodyB, limits) =>
    phys2D.createPointConstraint({ bodyA, bodyB, anchorA: [1, 0], anchorB: [-1, 0], ...limits }),
  WELD: (bodyA, bodyB, limits) =>
    phys2D.createWeldConstraint({ bodyA, bodyB, anchorA: [1, 0], anchorB: [-1, 0], ...limits }),
  DISTANCE: (bodyA, bodyB, limits) =>
    phys2D.createDistanceConstraint({ bodyA, bodyB, lowerBound: 2, upperBound: 2, ...limits }),
  'a rope': (bodyA, bodyB, limits) => phys2D.createDistanceConstraint({ bodyA, bodyB, upperBound: 2, ...limits }),
  LINE: (bodyA, bodyB, limits) =>
    phys2D.createLineConstraint({ bodyA, bodyB, axis: [1, 0], lowerBound: 2, upperBound: 2, ...limits }),
};

describe.each(Object.keys(PAIRS))('%s between two free bodies', (kind) => {
  it.each([1, 4])(
    'that whirl breaks under the force that keeps them on their circle, with %d sub-steps',
    (substeps) => {
      const spin = 2;
      for (const share of [0.8, 1.2]) {
        const world = weightless({ substeps });
        const [a, b] = [-1, 1].map((x) =>
          plainBody({ position: [x, 0], velocity: [0, spin * x], angularVelocity: spin }),
        );
        add(world, a!, b!);
        const constraint = PAIRS[kind]!(a!, b!, { maxForce: share * spin * spin, breakUnderForce: true });
        tie(world, constraint);
        steps(world, 40);
        expect(constraint.world, `${share} of the force`).toBe(share > 1 ? world : null);
      }
    },
  );

  it.each([1, 4])(
    'that are too far apart brings them together, and leaves them at rest, with %d sub-steps',
    (substeps) => {
      for (const gap of [0.15, 0.009]) {
        const world = weightless({ substeps, allowSleeping: false });
        const [a, b] = [-1 - gap, 1].map((x) => plainBody({ position: [x, 0] }));
        add(world, a!, b!);
        tie(world, PAIRS[kind]!(a!, b!, {}));
        steps(world, 20);
        near(a!.getPosition(), [-1 - gap / 2, 0], 1e-3);
        near(b!.getPosition(), [1 - gap / 2, 0], 1e-3);
        near([...a!.getVelocity(), ...b!.getVelocity()], [0, 0, 0, 0], 1e-3);
      }
    },
  );
});

describe('a chain that is built hanging, and falls into its joints', () => {
  /** Bodies of mass 1, one below the other; one joint may break under so many times what it bears at rest. */
  function makeChain(count: number, breakable = -1, share = 0) {
    const world = heavy({ allowSleeping: false });
    const joints: Constraint[] = [];
    for (let i = 0, bodyA = staticBody({ position: [0, -1] }); i < count; i += 1) {
      const bodyB = plainBody({ position: [0, i], shapes: [] });
      add(world, bodyB);
      const limits = i === breakable ? { breakUnderForce: true, maxForce: share * 10 * (count - i) } : {};
      joints.push(phys2D.createPointConstraint({ bodyA, bodyB, anchorA: [0, 0.5], anchorB: [0, -0.5], ...limits }));
      bodyA = bodyB;
    }
    tie(world, ...joints);
    return { world, joints };
  }

  it('does not open', () => {
    const { world } = makeChain(30);
    for (let i = 0; i < 60; i += 1) {
      steps(world, 1);
      world.rigidBodies.forEach((body, k) => {
        expect(body.getPosition()[1] - (world.rigidBodies[k - 1]?.getPosition()[1] ?? -1)).toBeLessThan(1.0015);
      });
    }
  });

  it.each([0, 5, 9])('does not break at joint %d, if that bears half as much again, but if it bears less', (k) => {
    for (const share of [0.9, 1.5]) {
      const { world, joints } = makeChain(10, k, share);
      steps(world, 90);
      expect(joints[k]!.world, `${share} of the weight`).toBe(share > 1 ? world : null);
    }
  });
});
