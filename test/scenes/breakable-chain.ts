import type { Physics2DDevice, PointConstraint, RigidBody, World } from '../../src/index.js';
import { hang } from './hanging.js';

export interface BreakableChain {
  readonly links: readonly RigidBody[];
  readonly joints: readonly PointConstraint[];
  readonly ball: RigidBody;
  /** Indices of the joints that broke, in that order. */
  readonly broken: number[];
}

/** N. More than it takes to hold the chain itself; the joints are weakest in the middle, and stronger by this share from each to the next. */
const STRENGTH = 250;
const STRONGER = 0.5;

/** A chain that sags between two anchors, and a heavy ball that falls on its middle. */
export function buildBreakableChain(phys2D: Physics2DDevice, world: World, count = 12): BreakableChain {
  const links: RigidBody[] = [];
  const joints: PointConstraint[] = [];
  const broken: number[] = [];
  const { span, links: places } = hang(count, 0.5, 0.5);
  const ends = [-span / 2, span / 2].map((x) => phys2D.createRigidBody({ type: 'static', position: [x, 0] }));
  const join = (bodyA: RigidBody, anchorA: [number, number], bodyB: RigidBody, anchorB: [number, number]): void => {
    const maxForce = STRENGTH * (1 + STRONGER * Math.abs(joints.length - count / 2));
    const breaking = { breakUnderForce: true, maxForce, ignoreInteractions: true };
    const joint = phys2D.createPointConstraint({ bodyA, anchorA, bodyB, anchorB, ...breaking });
    const index = joints.push(joint) - 1;
    joint.addEventListener('break', () => broken.push(index));
    world.addConstraint(joint);
  };
  for (const place of places) {
    const shapes = [phys2D.createPolygonShape({ vertices: phys2D.createBoxVertices(0.5, 0.15) })];
    const link = phys2D.createRigidBody({ ...place, shapes });
    const last = links[links.length - 1];
    world.addRigidBody(link);
    join(last ?? ends[0]!, last === undefined ? [0, 0] : [0.25, 0], link, [-0.25, 0]);
    links.push(link);
  }
  join(links[count - 1]!, [0.25, 0], ends[1]!, [0, 0]);
  const ball = phys2D.createRigidBody({
    position: [0.1, -4],
    shapes: [phys2D.createCircleShape({ radius: 0.6, material: phys2D.createMaterial({ density: 15 }) })],
  });
  world.addRigidBody(ball);
  return { links, joints, ball, broken };
}
