// A small car with springs drives over humps: line constraints guide the wheels, elastic distances carry the chassis.
import { phys2D, type RigidBody } from 'phys2d';

const RADIUS = 0.35;
const SPEED = 3;

const world = phys2D.createWorld();
const box = (width: number, height: number) =>
  phys2D.createPolygonShape({ vertices: phys2D.createBoxVertices(width, height) });

world.addRigidBody(phys2D.createRigidBody({ type: 'static', position: [20, 0.5], shapes: [box(60, 1)] }));
for (let x = 4; x < 40; x += 3) {
  const vertices = [
    [x - 0.8, 0],
    [x, -0.15],
    [x + 0.8, 0],
  ];
  const shapes = [phys2D.createPolygonShape({ vertices })];
  world.addRigidBody(phys2D.createRigidBody({ type: 'static', shapes }));
}

const chassis = phys2D.createRigidBody({ position: [0, -1], shapes: [box(2, 0.4)] });
world.addRigidBody(chassis);

/** A wheel that slides up and down below the chassis at `x`, on a spring. */
function addWheel(x: number): RigidBody {
  const rubber = phys2D.createMaterial({ staticFriction: 1.5, dynamicFriction: 1.2 });
  const wheel = phys2D.createRigidBody({
    position: [x, -RADIUS],
    shapes: [phys2D.createCircleShape({ radius: RADIUS, material: rubber })],
  });
  const parts = { bodyA: chassis, bodyB: wheel, anchorA: [x, 0], ignoreInteractions: true };
  const spring = { stiff: false, frequency: 4, damping: 0.7, lowerBound: 0.7, upperBound: 0.7 };
  world.addRigidBody(wheel);
  world.addConstraint(phys2D.createLineConstraint({ ...parts, axis: [0, 1], lowerBound: 0.45, upperBound: 0.8 }));
  world.addConstraint(phys2D.createDistanceConstraint({ ...parts, ...spring }));
  return wheel;
}

const wheels = [addWheel(-0.7), addWheel(0.7)];
const drive = phys2D.createMotorConstraint({
  bodyA: chassis,
  bodyB: wheels[0]!,
  rate: SPEED / RADIUS,
  maxForce: 5,
});
world.addConstraint(drive);

console.log('   time   position       speed      springs');
for (let i = 1; i <= 600; i += 1) {
  world.step(1 / 60);
  if (i % 60 === 0) {
    const [x, y] = chassis.getPosition();
    const [vx] = chassis.getVelocity();
    const springs = wheels.map((wheel) => chassis.transformWorldPointToLocal(wheel.getPosition())[1].toFixed(2));
    const time = world.simulatedTime.toFixed(0).padStart(5);
    console.log(
      `${time} s   ${x.toFixed(2).padStart(5)}, ${y.toFixed(2)}   ${vx.toFixed(2)} m/s   ${springs.join(', ')}`,
    );
  }
}
