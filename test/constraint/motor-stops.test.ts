import { describe, expect, it } from 'vitest';
import { type MotorConstraint, phys2D, type RigidBody, type World } from '../../src/index.js';
import { boxBody, DT, staticBody, steps, weightless } from '../conformance/setting.js';

// A motor drives no further than the bounds of an angle between its bodies: without that each undid what the other did in every sweep, and arms stood still for as long as they had been held,
// or whirled at thousands of rad/s.

const REACH = 0.8;

interface Arm {
  readonly segments: RigidBody[];
  readonly motors: MotorConstraint[];
}

/** Bars of 1 m on each other's ends, each hinge with bounds and a motor. */
function addArm(world: World, hinges: number, maxForce: number): Arm {
  const segments: RigidBody[] = [];
  const motors: MotorConstraint[] = [];
  let last = staticBody();
  for (let i = 0; i < hinges; i += 1) {
    const bodyB = boxBody(1, 0.2, { position: [i + 0.5, 0] });
    const pair = { bodyA: last, bodyB };
    world.addRigidBody(bodyB);
    world.addConstraint(
      phys2D.createPointConstraint({
        ...pair,
        anchorA: [i === 0 ? 0 : 0.5, 0],
        anchorB: [-0.5, 0],
        ignoreInteractions: true,
      }),
    );
    world.addConstraint(phys2D.createAngleConstraint({ ...pair, lowerBound: -REACH, upperBound: REACH }));
    const motor = phys2D.createMotorConstraint({ ...pair, maxForce });
    world.addConstraint(motor);
    segments.push(bodyB);
    motors.push(motor);
    last = bodyB;
  }
  return { segments, motors };
}

/** rad. At each hinge. */
function anglesOf({ segments }: Arm): number[] {
  return segments.map((body, i) => body.getRotation() - (segments[i - 1]?.getRotation() ?? 0));
}

describe('a motor between bodies whose angle has bounds', () => {
  for (const hinges of [1, 2, 3]) {
    for (const maxForce of [1000, 1e5, Infinity]) {
      for (const substeps of [1, 4, 8]) {
        it(`drives an arm of ${hinges} to its stops and back, maxForce ${maxForce}, substeps ${substeps}`, () => {
          const world = phys2D.createWorld({ gravity: [0, 10], substeps });
          const arm = addArm(world, hinges, maxForce);
          let fastest = 0;
          for (let turn = 0; turn < 6; turn += 1) {
            arm.motors.forEach((motor, i) => {
              motor.setRate((turn + i) % 2 === 0 ? 1.5 : -1.5);
            });
            for (let i = 0; i < 150; i += 1) {
              world.step(DT);
              fastest = Math.max(fastest, ...arm.segments.map((body) => Math.abs(body.getAngularVelocity())));
            }
            anglesOf(arm).forEach((angle, i) => {
              expect(angle).toBeCloseTo((turn + i) % 2 === 0 ? REACH : -REACH, 2);
            });
          }
          expect(fastest).toBeLessThan(20);
        });
      }
    }
  }

  it.each([
    ['the other way round', -1, { ratio: 1 }],
    ['by another ratio', 2, { ratio: 2 }],
    ['the other way round, by the inverse ratio', -1, { ratio: 0.5 }],
  ] as const)('turns back at once where the angle is measured %s', (_, way, { ratio }) => {
    const world = weightless();
    const body = boxBody(1, 0.2, {});
    world.addRigidBody(body);
    const frame = staticBody();
    const pair = way > 0 ? { bodyA: frame, bodyB: body } : { bodyA: body, bodyB: frame };
    world.addConstraint(phys2D.createAngleConstraint({ ...pair, ratio, lowerBound: -0.3, upperBound: 0.3 }));
    const motor = phys2D.createMotorConstraint({
      bodyA: frame,
      bodyB: body,
      ratio: way > 0 ? ratio : 1 / ratio,
      rate: 2,
    });
    world.addConstraint(motor);
    steps(world, 60);
    const held = body.getRotation();
    motor.setRate(-2);
    steps(world, 60);
    expect(held).toBeCloseTo(way > 0 ? 0.3 / ratio : 0.3, 6);
    expect(body.getRotation()).toBeCloseTo(-held, 6);
  });

  it('holds what is at its stop in the very first step', () => {
    const world = weightless({ substeps: 1 });
    const flipper = boxBody(1, 0.2, { rotation: 0.5, position: [0.44, 0.24] });
    const pair = { bodyA: staticBody(), bodyB: flipper };
    world.addRigidBody(flipper);
    world.addConstraint(phys2D.createPointConstraint({ ...pair, anchorB: [-0.5, 0] }));
    world.addConstraint(phys2D.createAngleConstraint({ ...pair, lowerBound: -0.5, upperBound: 0.5 }));
    world.addConstraint(phys2D.createMotorConstraint({ ...pair, rate: 20, maxForce: 200 }));
    for (let i = 0; i < 10; i += 1) {
      world.step(DT);
      expect(flipper.getRotation()).toBeCloseTo(0.5, 2);
    }
  });

  it('drives on where the angle is soft, off, or of other bodies', () => {
    for (const [stiff, enabled, isOther] of [
      [false, true, false],
      [true, false, false],
      [true, true, true],
    ] as const) {
      const world = weightless();
      const [frame, body, other] = [staticBody(), boxBody(1, 0.2, {}), boxBody(1, 0.2, { position: [5, 0] })];
      world.addRigidBody(body);
      world.addRigidBody(other);
      const bounds = { lowerBound: -0.1, upperBound: 0.1, stiff, frequency: 0.1, maxForce: 0.01 };
      const angle = phys2D.createAngleConstraint({ bodyA: frame, bodyB: isOther ? other : body, ...bounds });
      world.addConstraint(angle);
      if (!enabled) angle.disable();
      world.addConstraint(phys2D.createMotorConstraint({ bodyA: frame, bodyB: body, rate: 2 }));
      steps(world, 60);
      expect(body.getRotation()).toBeCloseTo(2, 1);
    }
  });
});
