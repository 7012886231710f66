import { type Constraint, phys2D, type RigidBody, type Vec2, type World } from '../../src/index.js';
import { box } from '../conformance/setting.js';

// Things of several bodies that welds hold together.

export function dense(width: number, height: number, density: number) {
  const material = phys2D.createMaterial({ density, staticFriction: 0.7, dynamicFriction: 0.7 });
  return box(width, height, { material });
}

export function free(params: Parameters<typeof phys2D.createRigidBody>[0]): RigidBody {
  return phys2D.createRigidBody({ linearDrag: 0, angularDrag: 0, ...params });
}

/** Welds a body to another one where a point of it is. */
export function weld(
  world: World,
  bodyA: RigidBody,
  bodyB: RigidBody,
  point: Vec2,
  ignoreInteractions = true,
): Constraint {
  const constraint = phys2D.createWeldConstraint({
    bodyA,
    bodyB,
    anchorA: bodyA.transformWorldPointToLocal(point),
    anchorB: bodyB.transformWorldPointToLocal(point),
    phase: bodyB.getRotation() - bodyA.getRotation(),
    ignoreInteractions,
  });
  world.addConstraint(constraint);
  return constraint;
}

/** N·m·s, about the origin. */
export function angularMomentum(world: World): number {
  let sum = 0;
  for (const body of world.rigidBodies) {
    const [x, y] = body.getPosition();
    const [vx, vy] = body.getVelocity();
    sum += body.getMass() * (x * vy - y * vx) + body.getInertia() * body.getAngularVelocity();
  }
  return sum;
}

/** Lets a body turn with others about the origin. */
export function turn(body: RigidBody, rate: number): RigidBody {
  const [x, y] = body.getPosition();
  body.setVelocity([-rate * y, rate * x]);
  body.setAngularVelocity(rate);
  return body;
}
