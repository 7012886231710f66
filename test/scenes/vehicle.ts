import type {
  DistanceConstraint,
  LineConstraint,
  MotorConstraint,
  Physics2DDevice,
  RigidBody,
  Vec2,
  World,
} from '../../src/index.js';

export interface Vehicle {
  readonly chassis: RigidBody;
  readonly wheels: readonly RigidBody[];
  /** Keep the wheels below the chassis. */
  readonly guides: readonly LineConstraint[];
  readonly springs: readonly DistanceConstraint[];
  readonly motor: MotorConstraint;
}

/** m. Length of the springs when nothing loads them. */
const SPRING = 0.9;

/** A car on bumpy ground that rises to the right in waves; it drives to the right. Wheels hang on a guide and a spring each. */
export function buildVehicle(phys2D: Physics2DDevice, world: World): Vehicle {
  buildGround(phys2D, world);
  const material = phys2D.createMaterial({ staticFriction: 1.2, dynamicFriction: 1 });
  const chassis = phys2D.createRigidBody({
    position: [0, -1.6],
    shapes: [phys2D.createPolygonShape({ vertices: phys2D.createBoxVertices(2.6, 0.5) })],
  });
  world.addRigidBody(chassis);
  const wheels: RigidBody[] = [];
  const guides: LineConstraint[] = [];
  const springs: DistanceConstraint[] = [];
  for (const x of [-0.9, 0.9]) {
    const wheel = phys2D.createRigidBody({
      position: [x, -0.75],
      shapes: [phys2D.createCircleShape({ radius: 0.4, material })],
    });
    world.addRigidBody(wheel);
    const bodies = { bodyA: chassis, bodyB: wheel, ignoreInteractions: true };
    const guide = phys2D.createLineConstraint({
      ...bodies,
      anchorA: [x, 0],
      axis: [0, 1],
      lowerBound: 0.5,
      upperBound: 1,
    });
    const spring = phys2D.createDistanceConstraint({
      ...bodies,
      anchorA: [x, 0],
      lowerBound: SPRING,
      upperBound: SPRING,
      stiff: false,
      frequency: 4,
      damping: 0.6,
    });
    world.addConstraint(guide);
    world.addConstraint(spring);
    wheels.push(wheel);
    guides.push(guide);
    springs.push(spring);
  }
  const drive = { bodyA: chassis, bodyB: wheels[0]!, rate: 12, maxForce: 8 };
  const motor = phys2D.createMotorConstraint(drive);
  world.addConstraint(motor);
  return { chassis, wheels, guides, springs, motor };
}

/** A row of static boxes, each turned a little against the one before. */
function buildGround(phys2D: Physics2DDevice, world: World): void {
  let [x, y]: Vec2 = [-6, 0];
  for (let i = 0; i < 60; i += 1) {
    const slope = i < 6 ? 0 : 0.18 * (((i * 7) % 5) / 2 - 1);
    const next: Vec2 = [x + 1, y + slope];
    const thickness = 1;
    const vertices: Vec2[] = [[x, y], next, [next[0], next[1] + thickness], [x, y + thickness]];
    const shapes = [phys2D.createPolygonShape({ vertices })];
    world.addRigidBody(phys2D.createRigidBody({ type: 'static', shapes }));
    [x, y] = next;
  }
}
