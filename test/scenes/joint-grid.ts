import type { Physics2DDevice, PointConstraint, RigidBody, World } from '../../src/index.js';

/** Shapes of one group that is not in their own mask do not meet. */
const APART = { group: 2, mask: 1 };

/** What hangs together: bodies, and the joints between them. */
export interface Jointed {
  readonly bodies: RigidBody[];
  readonly joints: PointConstraint[];
}

/** Joins two bodies at a point of the world. */
function join(
  phys2D: Physics2DDevice,
  world: World,
  a: RigidBody,
  b: RigidBody,
  point: [number, number],
): PointConstraint {
  const [ax, ay] = a.getPosition();
  const [bx, by] = b.getPosition();
  const joint = phys2D.createPointConstraint({
    bodyA: a,
    bodyB: b,
    anchorA: [point[0] - ax, point[1] - ay],
    anchorB: [point[0] - bx, point[1] - by],
  });
  world.addConstraint(joint);
  return joint;
}

/** Horizontal chains, 25 m apart, of links of 0.5 × 0.1 m, each held at one end; nothing collides, no drag. */
export function buildChains(phys2D: Physics2DDevice, world: World, count: number, links: number): Jointed {
  const bodies: RigidBody[] = [];
  const joints: PointConstraint[] = [];
  for (let chain = 0; chain < count; chain += 1) {
    const x = 25 * chain;
    let last = phys2D.createRigidBody({ type: 'static', position: [x, 0] });
    world.addRigidBody(last);
    for (let i = 0; i < links; i += 1) {
      const shape = phys2D.createPolygonShape({ vertices: phys2D.createBoxVertices(0.5, 0.1), ...APART });
      const link = phys2D.createRigidBody({
        position: [x + 0.25 + 0.5 * i, 0],
        linearDrag: 0,
        angularDrag: 0,
        shapes: [shape],
      });
      world.addRigidBody(link);
      joints.push(join(phys2D, world, last, link, [x + 0.5 * i, 0]));
      bodies.push(link);
      last = link;
    }
  }
  return { bodies, joints };
}

/** A net of `size` × `size` discs, 1 m apart, joined to their neighbours half-way and held by a few in the middle of the upper row. */
export function buildJointGrid(phys2D: Physics2DDevice, world: World, size: number): Jointed {
  const bodies: RigidBody[] = [];
  const joints: PointConstraint[] = [];
  for (let column = 0; column < size; column += 1) {
    for (let row = 0; row < size; row += 1) {
      const isHeld = row === 0 && Math.abs(column - size / 2) <= 3;
      const disc = phys2D.createRigidBody({
        type: isHeld ? 'static' : 'dynamic',
        position: [column, row],
        linearDrag: 0,
        angularDrag: 0,
        shapes: [phys2D.createCircleShape({ radius: 0.4, ...APART })],
      });
      world.addRigidBody(disc);
      bodies.push(disc);
      if (row > 0) {
        joints.push(join(phys2D, world, bodies[bodies.length - 2]!, disc, [column, row - 0.5]));
      }
      if (column > 0) {
        joints.push(join(phys2D, world, bodies[bodies.length - 1 - size]!, disc, [column - 0.5, row]));
      }
    }
  }
  return { bodies, joints };
}

/** m. The largest distance between the two anchors of a joint. */
export function worstGap(joints: readonly PointConstraint[]): number {
  let worst = 0;
  for (const joint of joints) {
    const [ax, ay] = joint.bodyA.transformLocalPointToWorld(joint.getAnchorA());
    const [bx, by] = joint.bodyB.transformLocalPointToWorld(joint.getAnchorB());
    worst = Math.max(worst, Math.sqrt((bx - ax) ** 2 + (by - ay) ** 2));
  }
  return worst;
}
