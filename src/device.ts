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
 * The factory for everything else. It holds no state: all devices are equal, and `phys2D` is one that is ready to use. Bad arguments throw
 * before anything is made; the message names the function, the argument, the rule and the value. Each method is also a function to import:
 * with these a bundle contains only what it uses, with a device it contains everything.
 */
export class Physics2DDevice {
  /** Of the class, as in Turbulenz. */
  static get version(): number {
    return 1;
  }

  /** The vendor of the engine. */
  readonly vendor = 'phys2d';

  /** Makes a device; all devices are equal. */
  static create(): Physics2DDevice {
    return new Physics2DDevice();
  }

  /** Makes an empty world, which can be saved, restored and hashed. */
  createWorld(params?: WorldParams): World {
    return new World(params, worldState, simdKernels);
  }

  /** Makes a broadphase for any scene; the default of `createWorld`. */
  createBoxTreeBroadphase(): Broadphase {
    return create.createBoxTreeBroadphase();
  }

  /** Makes a broadphase for scenes that are spread out along x. */
  createSweepAndPruneBroadphase(): Broadphase {
    return create.createSweepAndPruneBroadphase();
  }

  /** Makes a body, in no world yet; dynamic unless `params.type` says otherwise. */
  createRigidBody(params?: RigidBodyParams): RigidBody {
    return create.createRigidBody(params);
  }

  /** The material of shapes that are made without one: always the same object. */
  getDefaultMaterial(): Material {
    return create.getDefaultMaterial();
  }

  /** Makes a material: density, elasticity, friction. Shapes may share it. */
  createMaterial(params?: MaterialParams): Material {
    return create.createMaterial(params);
  }

  /** Makes a circle, on no body yet. */
  createCircleShape(params: CircleParams): Circle {
    return create.createCircleShape(params);
  }

  /** Makes a convex polygon, on no body yet. */
  createPolygonShape(params: PolygonParams): Polygon {
    return create.createPolygonShape(params);
  }

  /** Makes an object for distances, intersections, rays and sweeps of shapes, without a world. */
  createCollisionUtils(): CollisionUtils {
    return create.createCollisionUtils();
  }

  /** Makes a hinge: holds a point of one body on a point of another. */
  createPointConstraint(params: PointConstraintParams): PointConstraint {
    return create.createPointConstraint(params);
  }

  /** Makes a weld: holds a point of one body on a point of another, and the angle between the bodies. */
  createWeldConstraint(params: WeldConstraintParams): WeldConstraint {
    return create.createWeldConstraint(params);
  }

  /** Makes a constraint that keeps the angle between two bodies within bounds; with a ratio, a gear. */
  createAngleConstraint(params: AngleConstraintParams): AngleConstraint {
    return create.createAngleConstraint(params);
  }

  /** Makes a constraint that keeps the distance between points of two bodies within bounds: rod, rope, spring. */
  createDistanceConstraint(params: DistanceConstraintParams): DistanceConstraint {
    return create.createDistanceConstraint(params);
  }

  /** Makes a slider: keeps a point of body B on a line of body A, within bounds along it. */
  createLineConstraint(params: LineConstraintParams): LineConstraint {
    return create.createLineConstraint(params);
  }

  /** Makes a motor: turns two bodies against each other at a rate. */
  createMotorConstraint(params: MotorConstraintParams): MotorConstraint {
    return create.createMotorConstraint(params);
  }

  /** Makes a pulley: a rope over two bodies, with bounds on the length of its two links together. */
  createPulleyConstraint(params: PulleyConstraintParams): PulleyConstraint {
    return create.createPulleyConstraint(params);
  }

  /** Makes a constraint of your own, defined by its error and its Jacobian. */
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

/** The engine: `phys2D.createWorld()`, `phys2D.createRigidBody()` and so on make everything. A bundle that imports it contains everything. */
export const phys2D: Physics2DDevice = /* @__PURE__ */ Physics2DDevice.create();
