import { RigidBody } from './body.js';
import type { RigidBodyParams } from './body-params.js';
import { BoxTreeBroadphase } from './broadphase/box-tree-broadphase.js';
import type { Broadphase } from './broadphase/broadphase.js';
import { SweepAndPrune } from './broadphase/sweep-and-prune.js';
import { CollisionUtils } from './collide/utils.js';
import { AngleConstraint, type AngleConstraintParams } from './constraint/angle.js';
import { CustomConstraint, type CustomConstraintParams } from './constraint/custom.js';
import { DistanceConstraint, type DistanceConstraintParams } from './constraint/distance.js';
import { LineConstraint, type LineConstraintParams } from './constraint/line.js';
import { MotorConstraint, type MotorConstraintParams } from './constraint/motor.js';
import { PointConstraint, type PointConstraintParams } from './constraint/point.js';
import { PulleyConstraint, type PulleyConstraintParams } from './constraint/pulley.js';
import { WeldConstraint, type WeldConstraintParams } from './constraint/weld.js';
import { createBoxVertices, createRectangleVertices, createRegularPolygonVertices } from './geometry/vertices.js';
import { DEFAULT_MATERIAL, Material, type MaterialParams } from './material.js';
import type { Vec2 } from './math/vectors.js';
import { Circle, type CircleParams } from './shape/circle.js';
import { Polygon, type PolygonParams } from './shape/polygon.js';
import { World } from './world.js';
import type { WorldParams } from './world-state.js';

/**
 * The factory for everything else. Holds no state: all devices are equal, and `phys2D` is one that is ready to use. Bad
 * arguments throw before anything is made; the message names the function, the argument, the rule and the value.
 */
export class Physics2DDevice {
  static readonly version = 1;

  readonly vendor = 'phys2d';

  /** A device; one is as good as another. */
  static create(): Physics2DDevice {
    return new Physics2DDevice();
  }

  createWorld(params?: WorldParams): World {
    return new World(params);
  }

  /** A broadphase for any scene; the default of `createWorld`. */
  createBoxTreeBroadphase(): Broadphase {
    return new BoxTreeBroadphase();
  }

  /** A broadphase for scenes spread out along x. */
  createSweepAndPruneBroadphase(): Broadphase {
    return new SweepAndPrune();
  }

  createRigidBody(params?: RigidBodyParams): RigidBody {
    return new RigidBody(params);
  }

  /** The material of shapes made without one: always the same object. */
  getDefaultMaterial(): Material {
    return DEFAULT_MATERIAL;
  }

  createMaterial(params?: MaterialParams): Material {
    return new Material(params);
  }

  createCircleShape(params: CircleParams): Circle {
    return new Circle(params);
  }

  createPolygonShape(params: PolygonParams): Polygon {
    return new Polygon(params);
  }

  /** Distances, intersections, rays and sweeps of shapes, without a world. */
  createCollisionUtils(): CollisionUtils {
    return new CollisionUtils();
  }

  /** Two points of two bodies coincide. */
  createPointConstraint(params: PointConstraintParams): PointConstraint {
    return new PointConstraint(params);
  }

  /** Two points of two bodies coincide, and the bodies keep their angle. */
  createWeldConstraint(params: WeldConstraintParams): WeldConstraint {
    return new WeldConstraint(params);
  }

  /** The angle between two bodies stays between bounds; with a ratio, a gear. */
  createAngleConstraint(params: AngleConstraintParams): AngleConstraint {
    return new AngleConstraint(params);
  }

  /** The distance of two points of two bodies stays between bounds: rod, rope, spring. */
  createDistanceConstraint(params: DistanceConstraintParams): DistanceConstraint {
    return new DistanceConstraint(params);
  }

  /** A point of body B stays on a line of body A, between bounds along it. */
  createLineConstraint(params: LineConstraintParams): LineConstraint {
    return new LineConstraint(params);
  }

  /** Two bodies turn against each other at a rate. */
  createMotorConstraint(params: MotorConstraintParams): MotorConstraint {
    return new MotorConstraint(params);
  }

  /** A rope over two bodies: its two links have a length together. */
  createPulleyConstraint(params: PulleyConstraintParams): PulleyConstraint {
    return new PulleyConstraint(params);
  }

  /** A constraint of your own, given by its error and its Jacobian. */
  createCustomConstraint(params: CustomConstraintParams): CustomConstraint {
    return new CustomConstraint(params);
  }

  /** Corners of a `width` × `height` box around the origin, clockwise from the upper left. m, > 0. */
  createBoxVertices(width: number, height: number): Vec2[] {
    return createBoxVertices(width, height);
  }

  /** Corners of the rectangle between two opposite corners in any order, clockwise from the upper left. m. */
  createRectangleVertices(x1: number, y1: number, x2: number, y2: number): Vec2[] {
    return createRectangleVertices(x1, y1, x2, y2);
  }

  /** `numVertices` (>= 3) corners on an ellipse around the origin, clockwise from the positive x-axis. Diameters in m, > 0. */
  createRegularPolygonVertices(diameterX: number, diameterY: number, numVertices: number): Vec2[] {
    return createRegularPolygonVertices(diameterX, diameterY, numVertices);
  }
}

/** A device that is ready to use. */
export const phys2D: Physics2DDevice = Physics2DDevice.create();
