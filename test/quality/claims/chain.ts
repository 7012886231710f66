import type { Physics2DDevice, PointConstraint, RigidBody, World } from '../../../src/index.js';
import { plainMaterial } from '../../scenes/stacks.js';

export const APART = { group: 2, mask: 1 };

export const FREE = { linearDrag: 0, angularDrag: 0 };

/** A chain of links of 1 m, held at the origin; `spacing` from link to link, and a ball at the end if it has a mass. */
export function buildChain(phys2D: Physics2DDevice, world: World, count: number, spacing: number, ballMass = 0) {
  const joints: PointConstraint[] = [];
  const bodies: RigidBody[] = [];
  let last = phys2D.createRigidBody({ type: 'static', position: [0, 0] });
  world.addRigidBody(last);
  const append = (body: RigidBody, anchorA: [number, number], anchorB: [number, number]): void => {
    world.addRigidBody(body);
    const joint = phys2D.createPointConstraint({ bodyA: last, bodyB: body, anchorA, anchorB });
    world.addConstraint(joint);
    joints.push(joint);
    bodies.push(body);
    last = body;
  };
  for (let i = 0; i < count; i += 1) {
    const shape = phys2D.createPolygonShape({ vertices: phys2D.createBoxVertices(1, 0.2), ...APART });
    const link = phys2D.createRigidBody({ position: [(i + 0.5) * spacing, 0], shapes: [shape], ...FREE });
    append(link, i === 0 ? [0, 0] : [0.5, 0], [-0.5, 0]);
  }
  if (ballMass > 0) {
    // Of 1 m radius; links weigh 0.2 kg.
    const material = plainMaterial(phys2D, 0.6, ballMass / Math.PI);
    const ball = phys2D.createCircleShape({ radius: 1, material, ...APART });
    const body = phys2D.createRigidBody({ position: [count * spacing + 1, 0], shapes: [ball], ...FREE });
    append(body, [0.5, 0], [-1, 0]);
  }
  return { joints, bodies };
}
