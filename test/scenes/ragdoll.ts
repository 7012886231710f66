import type {
  AngleConstraint,
  MotorConstraint,
  Physics2DDevice,
  PointConstraint,
  RigidBody,
  Vec2,
  World,
} from '../../src/index.js';

export interface Ragdoll {
  readonly parts: readonly RigidBody[];
  readonly joints: readonly PointConstraint[];
  readonly limits: readonly AngleConstraint[];
  /** Motors of rate 0: what brakes the joints. */
  readonly brakes: readonly MotorConstraint[];
}

/** N·m. Without it an arm that hangs free swings for a minute. */
const FRICTION = 0.05;

/** Name, centre, size, what it hangs on and where, and how far it turns against that. */
const PARTS: readonly (readonly [string, Vec2, Vec2, string | null, Vec2, Vec2])[] = [
  ['torso', [0, 0], [0.5, 0.9], null, [0, 0], [0, 0]],
  ['head', [0, -0.7], [0.35, 0.4], 'torso', [0, -0.48], [-0.5, 0.5]],
  ['upper arm left', [-0.45, -0.35], [0.5, 0.16], 'torso', [-0.24, -0.35], [-1.5, 1.5]],
  ['lower arm left', [-0.9, -0.35], [0.45, 0.14], 'upper arm left', [-0.68, -0.35], [-0.1, 2]],
  ['upper arm right', [0.45, -0.35], [0.5, 0.16], 'torso', [0.24, -0.35], [-1.5, 1.5]],
  ['lower arm right', [0.9, -0.35], [0.45, 0.14], 'upper arm right', [0.68, -0.35], [-2, 0.1]],
  ['thigh left', [-0.14, 0.72], [0.2, 0.56], 'torso', [-0.14, 0.46], [-0.8, 1]],
  ['shin left', [-0.14, 1.26], [0.17, 0.54], 'thigh left', [-0.14, 1], [0, 1.8]],
  ['thigh right', [0.14, 0.72], [0.2, 0.56], 'torso', [0.14, 0.46], [-0.8, 1]],
  ['shin right', [0.14, 1.26], [0.17, 0.54], 'thigh right', [0.14, 1], [0, 1.8]],
];

/** A puppet whose hips are at `at`: boxes on point joints with limits of angle. Parts next to each other do not interact. */
export function buildRagdoll(phys2D: Physics2DDevice, world: World, at: Vec2): Ragdoll {
  const bodies = new Map<string, RigidBody>();
  const joints: PointConstraint[] = [];
  const limits: AngleConstraint[] = [];
  const brakes: MotorConstraint[] = [];
  for (const [name, centre, size, parentName, point, range] of PARTS) {
    const shapes = [phys2D.createPolygonShape({ vertices: phys2D.createBoxVertices(size[0], size[1]) })];
    const bodyB = phys2D.createRigidBody({ position: [at[0] + centre[0], at[1] + centre[1]], shapes });
    world.addRigidBody(bodyB);
    bodies.set(name, bodyB);
    const bodyA = parentName === null ? undefined : bodies.get(parentName);
    if (bodyA !== undefined) {
      const [px, py] = bodyA.getPosition();
      const joint = phys2D.createPointConstraint({
        bodyA,
        bodyB,
        anchorA: [at[0] + point[0] - px, at[1] + point[1] - py],
        anchorB: [point[0] - centre[0], point[1] - centre[1]],
        ignoreInteractions: true,
      });
      const limit = phys2D.createAngleConstraint({ bodyA, bodyB, lowerBound: range[0], upperBound: range[1] });
      world.addConstraint(joint);
      const brake = phys2D.createMotorConstraint({ bodyA, bodyB, maxForce: FRICTION });
      world.addConstraint(limit);
      world.addConstraint(brake);
      joints.push(joint);
      limits.push(limit);
      brakes.push(brake);
    }
  }
  return { parts: [...bodies.values()], joints, limits, brakes };
}

/** Steps that go down to the right, and the floor they end on. */
export function buildStairs(phys2D: Physics2DDevice, world: World): void {
  const add = (x: number, y: number, width: number, height: number): void => {
    const shapes = [phys2D.createPolygonShape({ vertices: phys2D.createBoxVertices(width, height) })];
    world.addRigidBody(phys2D.createRigidBody({ type: 'static', position: [x, y], shapes }));
  };
  for (let i = 0; i < 6; i += 1) {
    add(-4 + i, 2 + 0.5 * i, 1, 1);
  }
  add(4, 5.5, 20, 1);
}
