import type { RigidBody } from './body.js';
import type { RigidBodyParams } from './body-params.js';
import type { Broadphase } from './broadphase/broadphase.js';
import type { CollisionUtils } from './collide/utils.js';
import type { AngleConstraint, AngleConstraintParams } from './constraint/angle.js';
import type { CustomConstraint, CustomConstraintParams } from './constraint/custom.js';
import type { DistanceConstraint, DistanceConstraintParams } from './constraint/distance.js';
import type { LineConstraint, LineConstraintParams } from './constraint/line.js';
import type { MotorConstraint, MotorConstraintParams } from './constraint/motor.js';
import type { PointConstraint, PointConstraintParams } from './constraint/point.js';
import type { PulleyConstraint, PulleyConstraintParams } from './constraint/pulley.js';
import type { WeldConstraint, WeldConstraintParams } from './constraint/weld.js';
import * as create from './create.js';
import { createBoxVertices, createRectangleVertices, createRegularPolygonVertices } from './geometry/vertices.js';
import type { Material, MaterialParams } from './material.js';
import type { Vec2 } from './math/vectors.js';
import type { Circle, CircleParams } from './shape/circle.js';
import type { Polygon, PolygonParams } from './shape/polygon.js';
import { simdKernels } from './simd.js';
import { worldState } from './state/snapshot.js';
import { World } from './world.js';
import type { WorldParams } from './world-state.js';

/**
 * The factory for everything else. Holds no state: all devices are equal, and `phys2D` is one that is ready to use. Bad
 * arguments throw before anything is made; the message names the function, the argument, the rule and the value. Each method is a function to
 * import as well: a bundle has of those what it uses, and of a device everything.
 */
export class Physics2DDevice {
  /** Of the class, as in Turbulenz. */
  static get version(): number {
    return 1;
  }

  /** Who made the engine. */
  readonly vendor = 'phys2d';

  /** A device; one is as good as another. */
  static create(): Physics2DDevice {
    return new Physics2DDevice();
  }

  /** A world without bodies, that can be saved, restored and hashed. */
  createWorld(params?: WorldParams): World {
    return new World(params, worldState, simdKernels);
  }

  /** A broadphase for any scene; the default of `createWorld`. */
  createBoxTreeBroadphase(): Broadphase {
    return create.createBoxTreeBroadphase();
  }

  /** A broadphase for scenes spread out along x. */
  createSweepAndPruneBroadphase(): Broadphase {
    return create.createSweepAndPruneBroadphase();
  }

  /** A body, in no world yet; dynamic unless `params.type` says otherwise. */
  createRigidBody(params?: RigidBodyParams): RigidBody {
    return create.createRigidBody(params);
  }

  /** The material of shapes made without one: always the same object. */
  getDefaultMaterial(): Material {
    return create.getDefaultMaterial();
  }

  /** What surfaces are made of: density, elasticity, friction. Shapes may share it. */
  createMaterial(params?: MaterialParams): Material {
    return create.createMaterial(params);
  }

  /** A disc, of no body yet. */
  createCircleShape(params: CircleParams): Circle {
    return create.createCircleShape(params);
  }

  /** A convex polygon, of no body yet. */
  createPolygonShape(params: PolygonParams): Polygon {
    return create.createPolygonShape(params);
  }

  /** Distances, intersections, rays and sweeps of shapes, without a world. */
  createCollisionUtils(): CollisionUtils {
    return create.createCollisionUtils();
  }

  /** Two points of two bodies coincide. */
  createPointConstraint(params: PointConstraintParams): PointConstraint {
    return create.createPointConstraint(params);
  }

  /** Two points of two bodies coincide, and the bodies keep their angle. */
  createWeldConstraint(params: WeldConstraintParams): WeldConstraint {
    return create.createWeldConstraint(params);
  }

  /** The angle between two bodies stays between bounds; with a ratio, a gear. */
  createAngleConstraint(params: AngleConstraintParams): AngleConstraint {
    return create.createAngleConstraint(params);
  }

  /** The distance of two points of two bodies stays between bounds: rod, rope, spring. */
  createDistanceConstraint(params: DistanceConstraintParams): DistanceConstraint {
    return create.createDistanceConstraint(params);
  }

  /** A point of body B stays on a line of body A, between bounds along it. */
  createLineConstraint(params: LineConstraintParams): LineConstraint {
    return create.createLineConstraint(params);
  }

  /** Two bodies turn against each other at a rate. */
  createMotorConstraint(params: MotorConstraintParams): MotorConstraint {
    return create.createMotorConstraint(params);
  }

  /** A rope over two bodies: its two links have a length together. */
  createPulleyConstraint(params: PulleyConstraintParams): PulleyConstraint {
    return create.createPulleyConstraint(params);
  }

  /** A constraint of your own, given by its error and its Jacobian. */
  createCustomConstraint(params: CustomConstraintParams): CustomConstraint {
    return create.createCustomConstraint(params);
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

/** The engine: `phys2D.createWorld()`, `phys2D.createRigidBody()` and so on make all there is. A bundle that imports it has everything. */
export const phys2D: Physics2DDevice = /* @__PURE__ */ Physics2DDevice.create();
