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

// One function for each kind of object, so that a bundler leaves out what a game does not make. The methods of `Physics2DDevice` do the same.

/**
 * Makes an empty world. To save, restore and hash it, pass `state: worldState`; to solve contacts and joints in WebAssembly, `kernels:
 * simdKernels`.
 */
export function createWorld(params?: WorldParams): World {
  return new World(params);
}

/** Makes a broadphase for any scene; the default of `createWorld`. */
export function createBoxTreeBroadphase(): Broadphase {
  return new BoxTreeBroadphase();
}

/** Makes a broadphase for scenes that are spread out along x. */
export function createSweepAndPruneBroadphase(): Broadphase {
  return new SweepAndPrune();
}

/** Makes a body, in no world yet; dynamic unless `params.type` says otherwise. */
export function createRigidBody(params?: RigidBodyParams): RigidBody {
  return new RigidBody(params);
}

/** The material of shapes that are made without one: always the same object. */
export function getDefaultMaterial(): Material {
  return DEFAULT_MATERIAL;
}

/** Makes a material: density, elasticity, friction. Shapes may share it. */
export function createMaterial(params?: MaterialParams): Material {
  return new Material(params);
}

/** Makes a circle, on no body yet. */
export function createCircleShape(params: CircleParams): Circle {
  return new Circle(params);
}

/** Makes a convex polygon, on no body yet. */
export function createPolygonShape(params: PolygonParams): Polygon {
  bringPolygons(polygonWorks);
  return new Polygon(params);
}

/** Makes an object for distances, intersections, rays and sweeps of shapes, without a world. */
export function createCollisionUtils(): CollisionUtils {
  return new CollisionUtils();
}

/** Makes a hinge: holds a point of one body on a point of another. */
export function createPointConstraint(params: PointConstraintParams): PointConstraint {
  return solvable(new PointConstraint(params));
}

/** Makes a weld: holds a point of one body on a point of another, and the angle between the bodies. */
export function createWeldConstraint(params: WeldConstraintParams): WeldConstraint {
  return solvable(new WeldConstraint(params));
}

/** Makes a constraint that keeps the angle between two bodies within bounds; with a ratio, a gear. */
export function createAngleConstraint(params: AngleConstraintParams): AngleConstraint {
  return solvable(new AngleConstraint(params));
}

/** Makes a constraint that keeps the distance between points of two bodies within bounds: rod, rope, spring. */
export function createDistanceConstraint(params: DistanceConstraintParams): DistanceConstraint {
  return solvable(new DistanceConstraint(params));
}

/** Makes a slider: keeps a point of body B on a line of body A, within bounds along it. */
export function createLineConstraint(params: LineConstraintParams): LineConstraint {
  return solvable(new LineConstraint(params));
}

/** Makes a motor: turns two bodies against each other at a rate. */
export function createMotorConstraint(params: MotorConstraintParams): MotorConstraint {
  return solvable(new MotorConstraint(params));
}

/** Makes a pulley: a rope over two bodies, with bounds on the length of its two links together. */
export function createPulleyConstraint(params: PulleyConstraintParams): PulleyConstraint {
  return solvable(new PulleyConstraint(params));
}

/** Makes a constraint of your own, defined by its error and its Jacobian. */
export function createCustomConstraint(params: CustomConstraintParams): CustomConstraint {
  return solvable(new CustomConstraint(params));
}

function solvable<T extends Constraint>(constraint: T): T {
  constraint.solver = jointSolver;
  return constraint;
}
