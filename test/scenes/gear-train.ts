import type { AngleConstraint, MotorConstraint, Physics2DDevice, RigidBody, World } from '../../src/index.js';

export interface GearTrain {
  readonly wheels: readonly RigidBody[];
  /** Between each wheel and the next. */
  readonly gears: readonly AngleConstraint[];
  readonly motor: MotorConstraint;
}

const RADII = [0.5, 1, 0.8];

/** Wheels in a row that mesh, the first driven by a motor: neighbours turn against each other, the smaller the faster. */
export function buildGearTrain(phys2D: Physics2DDevice, world: World): GearTrain {
  const frame = phys2D.createRigidBody({ type: 'static' });
  const wheels: RigidBody[] = [];
  const gears: AngleConstraint[] = [];
  let x = 0;
  RADII.forEach((radius, i) => {
    const before = wheels[i - 1];
    x += i === 0 ? 0 : RADII[i - 1]! + radius;
    const wheel = phys2D.createRigidBody({ position: [x, 0], shapes: [phys2D.createCircleShape({ radius })] });
    world.addRigidBody(wheel);
    world.addConstraint(phys2D.createPointConstraint({ bodyA: frame, bodyB: wheel, anchorA: [x, 0] }));
    if (before !== undefined) {
      const bodies = { bodyA: before, bodyB: wheel, ignoreInteractions: true };
      const gear = phys2D.createAngleConstraint({ ...bodies, ratio: -radius / RADII[i - 1]! });
      world.addConstraint(gear);
      gears.push(gear);
    }
    wheels.push(wheel);
  });
  const motor = phys2D.createMotorConstraint({ bodyA: frame, bodyB: wheels[0]!, rate: 4, maxForce: 20 });
  world.addConstraint(motor);
  return { wheels, gears, motor };
}
