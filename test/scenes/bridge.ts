import type { Physics2DDevice, PointConstraint, RigidBody, World } from '../../src/index.js';
import { hang } from './hanging.js';

export interface Bridge {
  readonly planks: readonly RigidBody[];
  readonly joints: readonly PointConstraint[];
  readonly load: readonly RigidBody[];
}

/** Joints do not brake, so what swings is stopped by the air alone. */
const DRAG = { linearDrag: 0.5, angularDrag: 0.5 };

/** Planks of 1 m between two anchors, joined at their ends, and boxes that fall on them. */
export function buildBridge(phys2D: Physics2DDevice, world: World, count = 16): Bridge {
  const box = (width: number, height: number) =>
    phys2D.createPolygonShape({ vertices: phys2D.createBoxVertices(width, height) });
  const { span, links } = hang(count, 1, 0.3);
  const left = phys2D.createRigidBody({ type: 'static', position: [-span / 2, 0] });
  const right = phys2D.createRigidBody({ type: 'static', position: [span / 2, 0] });
  const planks: RigidBody[] = [];
  const joints: PointConstraint[] = [];
  const join = (bodyA: RigidBody, anchorA: [number, number], bodyB: RigidBody, anchorB: [number, number]): void => {
    const joint = phys2D.createPointConstraint({ bodyA, anchorA, bodyB, anchorB, ignoreInteractions: true });
    world.addConstraint(joint);
    joints.push(joint);
  };
  for (const place of links) {
    const plank = phys2D.createRigidBody({ ...place, shapes: [box(1, 0.2)], ...DRAG });
    const last = planks[planks.length - 1];
    world.addRigidBody(plank);
    join(last ?? left, last === undefined ? [0, 0] : [0.5, 0], plank, [-0.5, 0]);
    planks.push(plank);
  }
  join(planks[count - 1]!, [0.5, 0], right, [0, 0]);
  const load: RigidBody[] = [];
  for (let i = 0; i < 5; i += 1) {
    const body = phys2D.createRigidBody({ position: [1.5 * (i - 2), -3], shapes: [box(0.8, 0.8)], ...DRAG });
    world.addRigidBody(body);
    load.push(body);
  }
  return { planks, joints, load };
}
