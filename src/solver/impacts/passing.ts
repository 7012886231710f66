import type { RigidBody } from '../../body.js';
import { setPoint } from '../../collide/circles.js';
import * as g from '../../collide/layout.js';
import { MEET_PATIENCE, PASS_SHARE, SWEEP_TOLERANCE } from '../../config.js';
import type { Arbiter } from '../../contact/arbiter.js';
import * as c from '../../contact/layout.js';
import { CENTRE_X, CENTRE_Y } from '../../geometry/layout.js';
import { findImpact, Sweep } from '../../geometry/sweep.js';
import { halfWidthOf } from '../../shape/shape.js';
import { CIRCLE } from '../../shape/shape-kind.js';
import { goesFar } from './movers.js';

// Two shapes that seem to collide and bounce may only pass each other: a contact keeps its normal for the whole step, and the bodies may
// approach along it all the same.

/** Scratch of `passes`. */
const way = /* @__PURE__ */ new Sweep(MEET_PATIENCE, true);

/**
 * Whether two elastic shapes pass each other within a step, as their bodies move now. If two circles will meet, their contact gets the
 * normal with which they do.
 */
export function passes(pair: Arbiter, dt: number): boolean {
  const { shapeA, shapeB, numbers, at } = pair;
  const a = shapeA.owner!;
  const b = shapeB.owner!;
  const areRound = shapeA.kind === CIRCLE && shapeB.kind === CIRCLE;
  if (numbers[at + c.ELASTICITY]! <= 0 || !slipsBy(pair, a, b, dt, areRound ? 0 : PASS_SHARE)) {
    return false;
  }
  if (areRound) {
    return !circlesMeet(pair, a, b, dt);
  }
  if (!(goesFar(a, dt) || goesFar(b, dt))) {
    return false;
  }
  way.a.start(shapeA, a, a);
  way.b.start(shapeB, b, a);
  way.target = 0;
  way.tolerance = SWEEP_TOLERANCE;
  way.time = 0;
  way.most = dt;
  const isPassed = !findImpact(way);
  way.release();
  return isPassed;
}

/**
 * Whether two circles meet within a step: |d + v·t| = r. If so, turns their contact so that it closes when they meet, along the line of
 * their centres then. The origins of the bodies are taken to be apart as they are then, too: so the arms of both lead along that line.
 */
function circlesMeet({ shapeA, shapeB, numbers: n, at: o }: Arbiter, a: RigidBody, b: RigidBody, dt: number): boolean {
  const ax = shapeA.numbers[shapeA.at + CENTRE_X]!;
  const ay = shapeA.numbers[shapeA.at + CENTRE_Y]!;
  const bx = shapeB.numbers[shapeB.at + CENTRE_X]!;
  const by = shapeB.numbers[shapeB.at + CENTRE_Y]!;
  const dx = n[o + g.DX]! + bx - ax;
  const dy = n[o + g.DY]! + by - ay;
  const vx = b.vx - b.w * by - a.vx + a.w * ay;
  const vy = b.vy + b.w * bx - a.vy - a.w * ax;
  const reach = halfWidthOf(shapeA) + halfWidthOf(shapeB);
  const comes = -(dx * vx + dy * vy);
  const square = vx * vx + vy * vy;
  const left = comes * comes - square * (dx * dx + dy * dy - reach * reach);
  if (!(comes > 0 && left >= 0)) {
    return false;
  }
  const time = (comes - Math.sqrt(left)) / square;
  if (time > dt) {
    return false;
  }
  const nx = (dx + vx * time) / reach;
  const ny = (dy + vy * time) / reach;
  const radius = halfWidthOf(shapeA);
  const separation = -time * (vx * nx + vy * ny);
  setPoint(n, o, nx, ny, ax + nx * radius, ay + ny * radius, separation);
  n[o + g.DX] = ax - bx + nx * (reach + separation);
  n[o + g.DY] = ay - by + ny * (reach + separation);
  return true;
}

/**
 * Whether a contact seems to close in a step in which its surfaces slide along each other by more than a share of the thinner one's
 * half-width: else it does no harm, or there is no doubt.
 */
function slipsBy(
  { shapeA, shapeB, count, numbers: n, at: o }: Arbiter,
  a: RigidBody,
  b: RigidBody,
  dt: number,
  share: number,
): boolean {
  const nx = n[o + g.NX]!;
  const ny = n[o + g.NY]!;
  const least = share * Math.min(halfWidthOf(shapeA), halfWidthOf(shapeB));
  for (let p = o; p < o + count * g.POINT; p += g.POINT) {
    const x = n[p + g.X0]!;
    const y = n[p + g.Y0]!;
    const vx = b.vx - b.w * (y - n[o + g.DY]!) - a.vx + a.w * y;
    const vy = b.vy + b.w * (x - n[o + g.DX]!) - a.vy - a.w * x;
    if (-(nx * vx + ny * vy) * dt > n[p + g.S0]! && Math.abs(nx * vy - ny * vx) * dt > least) {
      return true;
    }
  }
  return false;
}
