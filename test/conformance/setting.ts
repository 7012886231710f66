import { expect } from 'vitest';
import {
  type Circle,
  type Constraint,
  type PointConstraint,
  type Polygon,
  phys2D,
  type RigidBody,
  type RigidBodyParams,
  type ShapeParams,
  type Vec2,
  type World,
  type WorldParams,
} from '../../src/index.js';

// The common setting of the conformance statements.

export const DT = 1 / 60;

/** A world without gravity. */
export function weightless(params: WorldParams = {}): World {
  return phys2D.createWorld({ gravity: [0, 0], ...params });
}

/** A world with default options. */
export function heavy(params: WorldParams = {}): World {
  return phys2D.createWorld(params);
}

export function steps(world: World, count: number): void {
  for (let i = 0; i < count; i += 1) {
    world.step(DT);
  }
}

export function box(width: number, height: number, params: ShapeParams = {}): Polygon {
  return phys2D.createPolygonShape({ vertices: phys2D.createBoxVertices(width, height), ...params });
}

export function disc(radius: number, params: ShapeParams = {}): Circle {
  return phys2D.createCircleShape({ radius, ...params });
}

/** The plain body B: a dynamic disc of radius 0.5, mass 1, inertia 1, without drag, at the origin. */
export function plainBody(params: RigidBodyParams = {}): RigidBody {
  return phys2D.createRigidBody({ shapes: [disc(0.5)], mass: 1, inertia: 1, linearDrag: 0, angularDrag: 0, ...params });
}

/** A dynamic body with one box. */
export function boxBody(
  width: number,
  height: number,
  params: RigidBodyParams = {},
  shape: ShapeParams = {},
): RigidBody {
  return phys2D.createRigidBody({ shapes: [box(width, height, shape)], ...params });
}

/** The static floor: 20 × 1 m, its top at y = 0.5. */
export function addFloor(world: World, params: RigidBodyParams = {}, shape: ShapeParams = {}): RigidBody {
  const floor = phys2D.createRigidBody({ type: 'static', position: [0, 1], shapes: [box(20, 1, shape)], ...params });
  world.addRigidBody(floor);
  return floor;
}

export function add(world: World, ...bodies: RigidBody[]): void {
  for (const body of bodies) {
    expect(world.addRigidBody(body)).toBe(true);
  }
}

/** A static body without shapes, to tie others to. */
export function staticBody(params: RigidBodyParams = {}): RigidBody {
  return phys2D.createRigidBody({ type: 'static', ...params });
}

/** Joins two bodies, which do not interact if nothing else is said, at a point of either. */
export function pin(
  world: World,
  bodyA: RigidBody,
  anchorA: Vec2,
  bodyB: RigidBody,
  anchorB: Vec2,
  ignoreInteractions = true,
): PointConstraint {
  const joint = phys2D.createPointConstraint({ bodyA, anchorA, bodyB, anchorB, ignoreInteractions });
  tie(world, joint);
  return joint;
}

/** The same, where a point of the world is. */
export function pinAt(
  world: World,
  bodyA: RigidBody,
  bodyB: RigidBody,
  at: Vec2,
  ignoreInteractions = true,
): PointConstraint {
  const [anchorA, anchorB] = [bodyA, bodyB].map((body) => body.transformWorldPointToLocal(at));
  return pin(world, bodyA, anchorA!, bodyB, anchorB!, ignoreInteractions);
}

export function tie(world: World, ...constraints: Constraint[]): void {
  for (const constraint of constraints) {
    expect(world.addConstraint(constraint)).toBe(true);
  }
}

/** Compares a number or the numbers of a vector with an absolute tolerance. */
export function near(actual: number | ArrayLike<number>, expected: number | readonly number[], tolerance = 1e-6): void {
  const got = typeof actual === 'number' ? [actual] : Array.from(actual);
  const wanted = typeof expected === 'number' ? [expected] : expected;
  expect(got).toHaveLength(wanted.length);
  wanted.forEach((value, i) => {
    const off = Math.abs(got[i]! - value);
    expect(off, `component ${i}: got ${got[i]}, expected ${value} ± ${tolerance}`).toBeLessThanOrEqual(tolerance);
  });
}

export function speed(body: RigidBody): number {
  const [x, y] = body.getVelocity();
  return Math.sqrt(x * x + y * y);
}

/** The active arbiter between two bodies. */
export function arbiterOf(world: World, a: RigidBody, b: RigidBody) {
  const all = [...world.dynamicArbiters, ...world.staticArbiters];
  return all.find((arbiter) => arbiter.active && new Set([arbiter.bodyA, arbiter.bodyB, a, b]).size === 2);
}

/** J. Of motion. */
export function kineticOf(world: World): number {
  return world.rigidBodies.reduce((sum, body) => {
    const [vx, vy] = body.getVelocity();
    const w = body.getAngularVelocity();
    return body.isDynamic() ? sum + 0.5 * body.getMass() * (vx * vx + vy * vy) + 0.5 * body.getInertia() * w * w : sum;
  }, 0);
}

/** J. With that of height, 10 m/s². */
export function energyOf(world: World): number {
  const heights = world.rigidBodies.reduce((sum, body) => sum - 10 * body.getMass() * body.getPosition()[1], 0);
  return kineticOf(world) + heights;
}
