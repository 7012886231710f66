import { RigidBody } from './body.js';
import type { RigidBodyParams } from './body-params.js';
import { BoxTreeBroadphase } from './broadphase/box-tree-broadphase.js';
import type { Broadphase } from './broadphase/broadphase.js';
import { SweepAndPrune } from './broadphase/sweep-and-prune.js';
import { bringPolygons } from './collide/polygon-works.js';
import { CollisionUtils } from './collide/utils.js';
import { AngleConstraint, type AngleConstraintParams } from './constraint/angle.js';
import type { Constraint } from './constraint/constraint.js';
import { CustomConstraint, type CustomConstraintParams } from './constraint/custom.js';
import { DistanceConstraint, type DistanceConstraintParams } from './constraint/distance.js';
import { LineConstraint, type LineConstraintParams } from './constraint/line.js';
import { MotorConstraint, type MotorConstraintParams } from './constraint/motor.js';
import { PointConstraint, type PointConstraintParams } from './constraint/point.js';
import { PulleyConstraint, type PulleyConstraintParams } from './constraint/pulley.js';
import { WeldConstraint, type WeldConstraintParams } from './constraint/weld.js';
import { DEFAULT_MATERIAL, Material, type MaterialParams } from './material.js';
import { Circle, type CircleParams } from './shape/circle.js';
import { Polygon, type PolygonParams } from './shape/polygon.js';
import { jointSolver } from './solver/joints/joints.js';
import { polygonWorks } from './solver/polygons.js';
import { World } from './world.js';
import type { WorldParams } from './world-state.js';

// One function for each kind of object, so that a bundler leaves out what a game does not make. The methods of `Physics2DDevice` are the same.

/** A world without bodies. To save, restore and hash it, pass `state: worldState`; to solve contacts in WebAssembly, `kernels: simdKernels`. */
export function createWorld(params?: WorldParams): World {
  return new World(params);
}

/** A broadphase for any scene; the default of `createWorld`. */
export function createBoxTreeBroadphase(): Broadphase {
  return new BoxTreeBroadphase();
}

/** A broadphase for scenes spread out along x. */
export function createSweepAndPruneBroadphase(): Broadphase {
  return new SweepAndPrune();
}

/** A body, in no world yet; dynamic unless `params.type` says otherwise. */
export function createRigidBody(params?: RigidBodyParams): RigidBody {
  return new RigidBody(params);
}

/** The material of shapes made without one: always the same object. */
export function getDefaultMaterial(): Material {
  return DEFAULT_MATERIAL;
}

/** What surfaces are made of: density, elasticity, friction. Shapes may share it. */
export function createMaterial(params?: MaterialParams): Material {
  return new Material(params);
}

/** A disc, of no body yet. */
export function createCircleShape(params: CircleParams): Circle {
  return new Circle(params);
}

/** A convex polygon, of no body yet. */
export function createPolygonShape(params: PolygonParams): Polygon {
  bringPolygons(polygonWorks);
  return new Polygon(params);
}

/** Distances, intersections, rays and sweeps of shapes, without a world. */
export function createCollisionUtils(): CollisionUtils {
  return new CollisionUtils();
}

/** Two points of two bodies coincide. */
export function createPointConstraint(params: PointConstraintParams): PointConstraint {
  return solvable(new PointConstraint(params));
}

/** Two points of two bodies coincide, and the bodies keep their angle. */
export function createWeldConstraint(params: WeldConstraintParams): WeldConstraint {
  return solvable(new WeldConstraint(params));
}

/** The angle between two bodies stays between bounds; with a ratio, a gear. */
export function createAngleConstraint(params: AngleConstraintParams): AngleConstraint {
  return solvable(new AngleConstraint(params));
}

/** The distance of two points of two bodies stays between bounds: rod, rope, spring. */
export function createDistanceConstraint(params: DistanceConstraintParams): DistanceConstraint {
  return solvable(new DistanceConstraint(params));
}

/** A point of body B stays on a line of body A, between bounds along it. */
export function createLineConstraint(params: LineConstraintParams): LineConstraint {
  return solvable(new LineConstraint(params));
}

/** Two bodies turn against each other at a rate. */
export function createMotorConstraint(params: MotorConstraintParams): MotorConstraint {
  return solvable(new MotorConstraint(params));
}

/** A rope over two bodies: its two links have a length together. */
export function createPulleyConstraint(params: PulleyConstraintParams): PulleyConstraint {
  return solvable(new PulleyConstraint(params));
}

/** A constraint of your own, given by its error and its Jacobian. */
export function createCustomConstraint(params: CustomConstraintParams): CustomConstraint {
  return solvable(new CustomConstraint(params));
}

function solvable<T extends Constraint>(constraint: T): T {
  constraint.solver = jointSolver;
  return constraint;
}
