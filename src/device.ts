import { RigidBody } from './body.js';
import type { RigidBodyParams } from './body-params.js';
import { BoxTreeBroadphase } from './broadphase/box-tree-broadphase.js';
import type { Broadphase } from './broadphase/broadphase.js';
import { SweepAndPrune } from './broadphase/sweep-and-prune.js';
import { createBoxVertices, createRectangleVertices, createRegularPolygonVertices } from './geometry/vertices.js';
import { DEFAULT_MATERIAL, Material, type MaterialParams } from './material.js';
import type { Vec2 } from './math/vectors.js';
import { Circle, type CircleParams } from './shape/circle.js';
import { Polygon, type PolygonParams } from './shape/polygon.js';
import { World, type WorldParams } from './world.js';

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
