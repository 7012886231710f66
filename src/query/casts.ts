import type { RigidBody } from '../body.js';
import type { BroadphaseHandle } from '../broadphase/broadphase.js';
import { RayTest, rayShape } from '../collide/rays.js';
import { SPECULATIVE_MARGIN } from '../config.js';
import { crosses, crossing } from '../geometry/crossing.js';
import type { Distance } from '../geometry/distance.js';
import { Sweep, type Travel, timeOfImpact } from '../geometry/sweep.js';
import type { Ray, RectLike, Vec2 } from '../math/vectors.js';
import { presentBounds, presently } from '../shape/presently.js';
import type { Shape } from '../shape/shape.js';
import { isUnderWay, refreshPlaces } from '../solver/refresh.js';
import type { World } from '../world.js';
import { shapesNear } from './queries.js';

/** Makes the limit longer by more than rounding. */
const LIMIT_SLACK = 1 + 1e-6;

/** For the next cast; one made within the callback of another takes a new one. */
let spareSweep: Sweep | null = null;

/** What a cast hit. */
export interface CastResult {
  /** What was hit. */
  shape: Shape;
  /** Where it was hit, in world coordinates, m. */
  hitPoint: Vec2;
  /** Unit normal of the surface hit, against the ray or towards the swept shape. */
  hitNormal: Vec2;
  /** For a ray, the distance to the hit in lengths of its direction. For a swept shape, the time until the hit, s. */
  factor: number;
}

/** Whether a hit is accepted; `false`: look for another. */
export type Accept = (found: CastResult) => boolean;

function emptyResult(shape: Shape): CastResult {
  return { shape, hitPoint: [0, 0], hitNormal: [0, 0], factor: 0 };
}

/** A ray cast. The ray is copied, as callbacks may change theirs. */
class RayWalk {
  /** The scaled ray, relative to the body that is being asked. */
  readonly test = new RayTest();
  private readonly x: number;
  private readonly y: number;

  constructor(ray: Ray, outerOnly: boolean) {
    this.x = ray.origin[0]!;
    this.y = ray.origin[1]!;
    this.test.aim(ray, outerOnly);
  }

  /** The factor at which the ray hits a shape, in units of the scaled direction; −1 if it does not. */
  meet(shape: Shape): number {
    const { test } = this;
    const body = shape.owner!;
    test.ox = this.x - body.x;
    test.oy = this.y - body.y;
    const isMet = body.owner!.stepping ? presently(shape, () => rayShape(shape, test)) : rayShape(shape, test);
    return isMet ? test.factor : -1;
  }

  /** Fills in the hit that `meet` has just found. */
  write(shape: Shape, result: CastResult): void {
    const { test } = this;
    result.shape = shape;
    result.factor = test.share;
    result.hitPoint[0] = this.x + test.dx * test.factor;
    result.hitPoint[1] = this.y + test.dy * test.factor;
    result.hitNormal[0] = test.nx + 0;
    result.hitNormal[1] = test.ny + 0;
  }

  /** Visits the shapes whose bounds the ray meets; `visit` returns the factor up to which others still matter. */
  visit(world: World, visit: (shape: Shape) => number): void {
    const { x, y } = this;
    const { dx, dy, most } = this.test;
    visitOnWay(world, [x, y, x, y], dx, dy, most, visit);
  }
}

/**
 * Visits the shapes whose bounds meet the bounds `start` on their way by (dx, dy) · f, 0 ≤ f ≤ `most`; `visit` returns the f up to which
 * others still matter.
 */
function visitOnWay(
  world: World,
  start: RectLike,
  dx: number,
  dy: number,
  most: number,
  visit: (shape: Shape) => number,
): void {
  const { broadphase } = world;
  if (broadphase.cast !== undefined && !isUnderWay(world)) {
    refreshPlaces(world);
    broadphase.cast(start, [dx, dy], most, (handle: BroadphaseHandle) => visit(handle.data as Shape));
    return;
  }
  // A broadphase without casts, or in a step, where it does not know the present placements: ask for everything within the bounds of the whole way.
  const x = dx === 0 ? 0 : dx * most;
  const y = dy === 0 ? 0 : dy * most;
  const minX = start[0]! + Math.min(x, 0);
  const minY = start[1]! + Math.min(y, 0);
  const maxX = start[2]! + Math.max(x, 0);
  const maxY = start[3]! + Math.max(y, 0);
  for (const shape of shapesNear(world, [minX, minY, maxX, maxY])) {
    // A visit may have taken it out of the world.
    if (shape.owner?.owner === world) visit(shape);
  }
}

/** The nearest hit that is accepted. Of equally near ones the older shape counts, whatever the order in which they are found. */
export function castRay(world: World, ray: Ray, outerOnly: boolean, accept: Accept | null): CastResult | null {
  const walk = new RayWalk(ray, outerOnly);
  let best: CastResult | null = null;
  let temporary: CastResult | null = null;
  let limit = walk.test.most;
  walk.visit(world, (shape) => {
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

/** All hits, one a shape, nearest first. */
export function castRayThrough(world: World, ray: Ray, outerOnly: boolean): CastResult[] {
  const walk = new RayWalk(ray, outerOnly);
  const found: CastResult[] = [];
  walk.visit(world, (shape) => {
    if (walk.meet(shape) >= 0) {
      const result = emptyResult(shape);
      walk.write(shape, result);
      found.push(result);
    }
    return walk.test.most;
  });
  return found.sort((a, b) => a.factor - b.factor || a.shape.id - b.shape.id);
}

/**
 * Sweeps a shape with its body's velocities for `deltaTime` seconds against all shapes of other bodies, which stand still; the first hit
 * that is accepted, or `null`. Shapes that touch at the start are left out. Of equally early hits, the older shape counts.
 */
export function castShape(world: World, shape: Shape, deltaTime: number, accept: Accept | null): CastResult | null {
  const body = shape.owner!;
  const sweep = spareSweep ?? new Sweep();
  spareSweep = null;
  sweep.a.start(shape, body, body);
  const start = startBounds(shape);
  const { vx, vy } = sweep.a;
  let best: CastResult | null = null;
  let limit = deltaTime;
  visitOnWay(world, start, vx, vy, deltaTime, (other) => {
    const { owner } = other;
    if (owner === body || !(isUnderWay(world) || mayMeet(start, sweep.a, other, limit))) {
      return limit;
    }
    sweep.b.stand(other, owner!, body);
    // A hit before the limit is computed again without it: else the time would depend on the limit to the last bit, and so on the order of
    // the visits.
    let time = timeOfImpact(sweep, Math.min(deltaTime, limit * LIMIT_SLACK));
    if (time > 0 && best !== null) time = timeOfImpact(sweep, deltaTime);
    const isNearer = time < limit || (time === limit && best !== null && other.id < best.shape.id);
    if (time > 0 && isNearer && (accept === null || accept(resultOf(sweep.distance, body, other, time)))) {
      best = resultOf(sweep.distance, body, other, time);
      limit = time;
    }
    return limit;
  });
  sweep.release();
  spareSweep = sweep;
  return best;
}

/** Whether bounds that move with the velocity of a body may meet those of a shape within a time. */
function mayMeet(start: RectLike, { vx, vy }: Travel, { numbers: n, at }: Shape, limit: number): boolean {
  // The same margin as for the bounds in the broadphase: more than the gap that shapes may have when a cast ends, and more than rounding.
  crossing[0] = vx * limit;
  crossing[1] = vy * limit;
  crossing[2] = SPECULATIVE_MARGIN / 2;
  return crosses(start, 0, n, at);
}

function resultOf(distance: Distance, { x, y }: RigidBody, shape: Shape, factor: number): CastResult {
  return {
    shape,
    hitPoint: [x + distance.bx, y + distance.by],
    hitNormal: [0 - distance.axisX, 0 - distance.axisY],
    factor,
  };
}

/** Bounds of a shape where its body is; if the body turns, of all rotations about its origin. */
function startBounds(shape: Shape): ArrayLike<number> {
  const body = shape.owner!;
  if (body.w === 0) {
    return presentBounds(shape);
  }
  const reach = shape.reach();
  return [body.x - reach, body.y - reach, body.x + reach, body.y + reach];
}
