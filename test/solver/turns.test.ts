import { describe, expect, it } from 'vitest';
import {
  type AngleConstraint,
  type AngleConstraintParams,
  type MotorConstraint,
  phys2D,
  type RigidBody,
  type RigidBodyParams,
  type World,
} from '../../src/index.js';

// Angles and motors that do not break have a kernel of their own: it does what that of all other joints does, and looks at both bounds.

const DT = 1 / 60;

function add(world: World, params: RigidBodyParams = {}): RigidBody {
  const shapes = [phys2D.createPolygonShape({ vertices: phys2D.createBoxVertices(1, 0.5), group: 0, mask: 0 })];
  const body = phys2D.createRigidBody({ shapes, linearDrag: 0, angularDrag: 0, ...params });
  world.addRigidBody(body);
  return body;
}

interface Pair {
  world: World;
  bodyA: RigidBody;
  bodyB: RigidBody;
  joint: AngleConstraint | MotorConstraint;
}

/** Two bodies and what turns them, `canBreak` or not: then the other kernel solves it, and it cannot break all the same. */
function pairOf(
  kind: 'angle' | 'motor',
  options: Partial<AngleConstraintParams> & { rate?: number },
  canBreak: boolean,
): Pair {
  const world = phys2D.createWorld();
  const bodyA = add(world, { rotation: 0.2, angularVelocity: 3 });
  const bodyB = add(world, { position: [3, 0], rotation: -0.4, angularVelocity: -5 });
  const params = { ...options, bodyA, bodyB, breakUnderError: canBreak };
  const joint = kind === 'angle' ? phys2D.createAngleConstraint(params) : phys2D.createMotorConstraint(params);
  world.addConstraint(joint);
  return { world, bodyA, bodyB, joint };
}

describe('the kernel of angles and motors does what the common one does', () => {
  const cases: [string, 'angle' | 'motor', Partial<AngleConstraintParams> & { rate?: number }][] = [
    ['an equality', 'angle', { lowerBound: -0.3, upperBound: -0.3 }],
    ['bounds', 'angle', { lowerBound: -1, upperBound: 0.5 }],
    ['an upper bound alone', 'angle', { ratio: -1, lowerBound: -Infinity, upperBound: 0.5 }],
    ['a lower bound alone', 'angle', { lowerBound: -0.7, upperBound: Infinity }],
    ['no bound', 'angle', { lowerBound: -Infinity, upperBound: Infinity }],
    ['a gear', 'angle', { ratio: -2.5, lowerBound: 0.1, upperBound: 0.2 }],
    ['a spring', 'angle', { stiff: false, frequency: 2, damping: 0.1 }],
    ['a spring with bounds', 'angle', { stiff: false, frequency: 3, damping: 0.5, lowerBound: -0.2, upperBound: 0.2 }],
    ['a weak spring', 'angle', { stiff: false, frequency: 2, maxForce: 0.2 }],
    ['a motor', 'motor', { rate: 4, ratio: 0.5 }],
    ['a weak motor', 'motor', { rate: -9, maxForce: 0.3 }],
  ];
  it.each(cases)('%s', (_name, kind, options) => {
    const one = pairOf(kind, options, false);
    const other = pairOf(kind, options, true);
    let most = 0;
    for (let i = 0; i < 240; i += 1) {
      for (const { world, bodyB } of [one, other]) {
        bodyB.setTorque(Math.floor(i / 30) % 2 === 0 ? 0.4 : -0.4);
        // The length of a step scales what is kept of impulses, and how soft a spring is.
        world.step(i % 50 < 25 ? DT : DT / 2);
      }
      for (const name of ['bodyA', 'bodyB'] as const) {
        most = Math.max(most, Math.abs(one[name].getRotation() - other[name].getRotation()));
        const given = one.joint.getImpulseForBody(one[name]);
        const same = other.joint.getImpulseForBody(other[name]);
        given.forEach((part, c) => {
          expect(part).toBeCloseTo(same[c]!, 9);
        });
      }
    }
    expect(most).toBeLessThan(1e-9);
    // It has done something, unless there is nothing to do.
    const isFree = options.lowerBound === -Infinity && options.upperBound === Infinity;
    expect(Math.abs(one.bodyA.getAngularVelocity() - 3) > 1e-3).toBe(!isFree);
  });
});

it('what would pass both of two close bounds in a sub-step is stopped between them', () => {
  for (const angularVelocity of [40, -40]) {
    const world = phys2D.createWorld({ velocityIterations: 1 });
    const bodyA = add(world, { type: 'static', rotation: 0.7 });
    const bodyB = add(world, { rotation: 0.7, angularVelocity });
    // A motor that wants on.
    world.addConstraint(phys2D.createMotorConstraint({ bodyA, bodyB, rate: angularVelocity, maxForce: 5 }));
    world.addConstraint(phys2D.createAngleConstraint({ bodyA, bodyB, lowerBound: -0.002, upperBound: 0.002 }));
    for (let i = 0; i < 120; i += 1) {
      world.step(DT);
      expect(Math.abs(bodyB.getRotation() - 0.7)).toBeLessThan(0.003);
    }
  }
});

it('bounds, ratio, rate and an anchor that are changed count from the next step on', () => {
  const world = phys2D.createWorld();
  // In no world, so that it can be turned.
  const bodyA = phys2D.createRigidBody({ type: 'static', rotation: 0.5 });
  const bodyB = add(world, { position: [0, 2] });
  const angle = phys2D.createAngleConstraint({ bodyA, bodyB, lowerBound: -Infinity, upperBound: Infinity });
  const motor = phys2D.createMotorConstraint({ bodyA, bodyB, rate: 2 });
  world.addConstraint(angle);
  world.addConstraint(motor);
  world.step(DT);
  expect(bodyB.getAngularVelocity()).toBeCloseTo(2, 6);
  motor.setRate(3);
  motor.setRatio(2);
  world.step(DT);
  expect(bodyB.getAngularVelocity()).toBeCloseTo(1.5, 6);
  motor.disable();
  angle.setRatio(2);
  angle.setUpperBound(0.3);
  angle.setLowerBound(0.3);
  for (let i = 0; i < 60; i += 1) {
    world.step(DT);
  }
  expect(2 * bodyB.getRotation() - 0.5).toBeCloseTo(0.3, 6);
  bodyA.setRotation(0.9);
  for (let i = 0; i < 60; i += 1) {
    world.step(DT);
  }
  expect(2 * bodyB.getRotation() - 0.9).toBeCloseTo(0.3, 6);
});
