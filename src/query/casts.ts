import type { RigidBody } from '../body.js';
import type { Broadphase, BroadphaseHandle } from '../broadphase/broadphase.js';
import { RayTest, rayShape } from '../collide/rays.js';
import { CAST_TOLERANCE } from '../config.js';
import type { Distance } from '../geometry/distance.js';
import { Sweep, timeOfImpact } from '../geometry/sweep.js';
import type { Ray, Vec2 } from '../math/vectors.js';
import type { Shape } from '../shape/shape.js';
import { refreshPlaces } from '../solver/refresh.js';
import type { World } from '../world.js';
import { near } from './queries.js';

/** What a cast hit. */
export interface CastResult {
  shape: Shape;
  /** World point on the shape, m. */
  hitPoint: Vec2;
  /** Unit normal of the shape's surface, against the ray or towards the swept shape. */
  hitNormal: Vec2;
  /** Of a ray: how often its direction fits into the way to the hit. Of a swept shape: seconds until the hit. */
  factor: number;
}

/** Whether a candidate counts; `false` looks on for another. */
export type Accept = (found: CastResult) => boolean;

function emptyResult(shape: Shape): CastResult {
  return { shape, hitPoint: [0, 0], hitNormal: [0, 0], factor: 0 };
}

/** A ray whose larger component is 1, so that directions of any length are as good, with what it hits on its way. */
class RayWalk {
  private readonly test = new RayTest();
  readonly scale: number;
  readonly ux: number;
  readonly uy: number;

  constructor(
    readonly ray: Ray,
    outerOnly: boolean,
  ) {
    const dx = ray.direction[0]!;
    const dy = ray.direction[1]!;
    this.scale = Math.max(Math.abs(dx), Math.abs(dy));
    this.ux = dx / this.scale;
    this.uy = dy / this.scale;
    this.test.dx = this.ux;
    this.test.dy = this.uy;
    this.test.outerOnly = outerOnly;
    this.test.most = ray.maxFactor * this.scale;
  }

  /** Where the ray meets a shape, in units of the scaled direction; −1 if it does not. */
  meet(shape: Shape): number {
    const { test, ray } = this;
    const body = shape.owner!;
    test.ox = ray.origin[0]! - body.x;
    test.oy = ray.origin[1]! - body.y;
    return rayShape(shape, test) && test.factor / this.scale < ray.maxFactor ? test.factor : -1;
  }

  /** Fills in the hit that `meet` just found. */
  write(shape: Shape, result: CastResult): void {
    const { test, ray, scale } = this;
    result.shape = shape;
    result.factor = test.factor / scale + 0;
    result.hitPoint[0] = ray.origin[0]! + this.ux * test.factor;
    result.hitPoint[1] = ray.origin[1]! + this.uy * test.factor;
    result.hitNormal[0] = test.nx + 0;
    result.hitNormal[1] = test.ny + 0;
  }

  /** Visits the shapes whose bounds the ray meets; `visit` returns up to where it still matters. */
  walk(world: World, visit: (shape: Shape) => number): void {
    refreshPlaces(world);
    const { ray, ux, uy } = this;
    const { broadphase } = world;
    const most = ray.maxFactor * this.scale;
    const meet = (handle: BroadphaseHandle) => visit(handle.data as Shape);
    if (broadphase.castRay !== undefined) {
      broadphase.castRay(ray.origin, [ux, uy], most, meet);
    } else {
      sampleAlong(broadphase, ray, ux, uy, most, meet);
    }
  }
}

/** For a broadphase that knows no rays: everything within the bounds of the ray. */
function sampleAlong(
  broadphase: Broadphase,
  { origin }: Ray,
  ux: number,
  uy: number,
  most: number,
  meet: (handle: BroadphaseHandle) => number,
): void {
  const x = origin[0]!;
  const y = origin[1]!;
  const endX = ux === 0 ? x : x + ux * most;
  const endY = uy === 0 ? y : y + uy * most;
  const found: BroadphaseHandle[] = [];
  const bounds = [Math.min(x, endX), Math.min(y, endY), Math.max(x, endX), Math.max(y, endY)];
  broadphase.sample(bounds, (handle) => found.push(handle));
  found.forEach(meet);
}

/** The nearest hit that is accepted; of equal ones that of the older shape, whatever the order in which they are found. */
export function castRay(world: World, ray: Ray, outerOnly: boolean, accept: Accept | null): CastResult | null {
  const walk = new RayWalk(ray, outerOnly);
  let best: CastResult | null = null;
  let temporary: CastResult | null = null;
  let limit = ray.maxFactor * walk.scale;
  walk.walk(world, (shape) => {
    const factor = walk.meet(shape);
    if (factor >= 0 && (factor < limit || (factor === limit && best !== null && shape.id < best.shape.id))) {
      if (accept !== null) {
        temporary ??= emptyResult(shape);
        walk.write(shape, temporary);
      }
      if (accept === null || accept(temporary!)) {
        best ??= emptyResult(shape);
        walk.write(shape, best);
        limit = factor;
      }
    }
    return limit;
  });
  return best;
}

/** All hits, one for each shape, nearest first. */
export function castRayThrough(world: World, ray: Ray, outerOnly: boolean): CastResult[] {
  const walk = new RayWalk(ray, outerOnly);
  const most = ray.maxFactor * walk.scale;
  const found: CastResult[] = [];
  walk.walk(world, (shape) => {
    if (walk.meet(shape) >= 0) {
      const result = emptyResult(shape);
      walk.write(shape, result);
      found.push(result);
    }
    return most;
  });
  return found.sort((a, b) => a.factor - b.factor || a.shape.id - b.shape.id);
}

/**
 * Sweeps a shape with its body's velocities for `deltaTime` against all shapes of other bodies, which stand still; the first hit that is
 * accepted, or `null`. Shapes that touch at the start are left out; of equal hits that of the older shape counts.
 */
export function castShape(world: World, shape: Shape, deltaTime: number, accept: Accept | null): CastResult | null {
  const body = shape.owner!;
  const sweep = new Sweep();
  sweep.a.start(shape, body, body);
  let best: CastResult | null = null;
  let limit = deltaTime;
  for (const other of near(world, sweptBounds(shape, deltaTime)).sort((a, b) => a.id - b.id)) {
    const { owner } = other;
    if (owner === body) {
      continue;
    }
    sweep.b.stand(other, owner!, body);
    const time = timeOfImpact(sweep, 0, CAST_TOLERANCE, 0, limit);
    if (time > 0 && (accept === null || accept(resultOf(sweep.distance, body, other, time)))) {
      best = resultOf(sweep.distance, body, other, time);
      limit = time;
    }
  }
  return best;
}

function resultOf(distance: Distance, { x, y }: RigidBody, shape: Shape, factor: number): CastResult {
  return {
    shape,
    hitPoint: [x + distance.bx, y + distance.by],
    hitNormal: [0 - distance.axisX, 0 - distance.axisY],
    factor,
  };
}

/** Bounds of a shape on its way: those of its start and end, or of all its turns about the body origin. */
function sweptBounds(shape: Shape, deltaTime: number): number[] {
  const body = shape.owner!;
  body.place();
  const { bounds } = shape;
  const x = body.vx * deltaTime;
  const y = body.vy * deltaTime;
  const reach = shape.reach();
  const [minX, minY, maxX, maxY] =
    body.w === 0
      ? [bounds[0]!, bounds[1]!, bounds[2]!, bounds[3]!]
      : [body.x - reach, body.y - reach, body.x + reach, body.y + reach];
  return [minX! + Math.min(x, 0), minY! + Math.min(y, 0), maxX! + Math.max(x, 0), maxY! + Math.max(y, 0)];
}
