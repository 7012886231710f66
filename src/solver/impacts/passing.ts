import type { RigidBody } from '../../body.js';
import { setPoint } from '../../collide/circles.js';
import * as g from '../../collide/layout.js';
import { works } from '../../collide/polygon-works.js';
import { faces, Round } from '../../collide/round.js';
import { MEET_PATIENCE, PASS_SHARE, SWEEP_TOLERANCE } from '../../config.js';
import { type Arbiter, hasCircle } from '../../contact/arbiter.js';
import * as c from '../../contact/layout.js';
import { CENTRE_X, CENTRE_Y } from '../../geometry/layout.js';
import { findImpact, Sweep } from '../../geometry/sweep.js';
import { halfWidthOf, type Shape } from '../../shape/shape.js';
import { CIRCLE } from '../../shape/shape-kind.js';
import { goesFar } from './movers.js';

// Two shapes that seem to collide and bounce may only pass each other: a contact keeps its normal for the whole step, and the bodies may
// approach along it all the same.

/** Scratch of `passes`. */
const way = /* @__PURE__ */ new Sweep(MEET_PATIENCE, true);
const one = /* @__PURE__ */ new Round();
const two = /* @__PURE__ */ new Round();

/**
 * Whether two elastic shapes pass each other within a step, as their bodies move now. If a circle will meet another one or a corner, their
 * contact gets the normal with which they do.
 */
export function passes(pair: Arbiter, dt: number): boolean {
  const { shapeA, shapeB, numbers, at } = pair;
  const a = shapeA.owner!;
  const b = shapeB.owner!;
  if (numbers[at + c.ELASTICITY]! <= 0 || !slipsBy(pair, a, b, dt, 0)) {
    return false;
  }
  if (findRounds(pair) && meetRound(pair, a, b, dt)) {
    return false;
  }
  if (shapeA.kind === CIRCLE && shapeB.kind === CIRCLE) {
    return true;
  }
  if (!(goesFar(a, dt) || goesFar(b, dt)) || !slipsBy(pair, a, b, dt, PASS_SHARE)) {
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

/** Whether a circle is near another one or a corner, which are `one` and `two` then. */
function findRounds(pair: Arbiter): boolean {
  if (!hasCircle(pair)) {
    return false;
  }
  const { shapeA, shapeB, numbers: n, at: o } = pair;
  const half = 0.5 * n[o + g.S0]!;
  const x = n[o + g.X0]!;
  const y = n[o + g.Y0]!;
  const nx = half * n[o + g.NX]!;
  const ny = half * n[o + g.NY]!;
  return findRound(one, shapeA, x - nx, y - ny) && findRound(two, shapeB, x + nx - n[o + g.DX]!, y + ny - n[o + g.DY]!);
}

/** Finds what is round of a shape at one of its points, `(x, y)` relative to the origin of its body. @returns whether there is anything. */
function findRound(round: Round, shape: Shape, x: number, y: number): boolean {
  if (shape.kind !== CIRCLE) {
    return works!.findCorner(round, shape, x, y);
  }
  round.x = shape.numbers[shape.at + CENTRE_X]!;
  round.y = shape.numbers[shape.at + CENTRE_Y]!;
  round.radius = shape.radius;
  round.sides.fill(0);
  return true;
}

/**
 * Whether `one` and `two` meet within a step: |d + v·t| = r. If so, turns their contact so that it closes when they meet, along the line of
 * their centres then. The origins of the bodies are taken to be apart as they are then, too: so the arms of both lead along that line.
 */
function meetRound({ numbers: n, at: o }: Arbiter, a: RigidBody, b: RigidBody, dt: number): boolean {
  const dx = n[o + g.DX]! + two.x - one.x;
  const dy = n[o + g.DY]! + two.y - one.y;
  const vx = b.vx - b.w * two.y - a.vx + a.w * one.y;
  const vy = b.vy + b.w * two.x - a.vy - a.w * one.x;
  const reach = one.radius + two.radius;
  const comes = -(dx * vx + dy * vy);
  const square = vx * vx + vy * vy;
  const left = comes * comes - square * (dx * dx + dy * dy - reach * reach);
  if (!(comes > 0 && left >= 0)) {
    return false;
  }
  const time = (comes - Math.sqrt(left)) / square;
  const nx = (dx + vx * time) / reach;
  const ny = (dy + vy * time) / reach;
  if (time > dt || !faces(one, nx, ny) || !faces(two, -nx, -ny)) {
    return false;
  }
  const separation = -time * (vx * nx + vy * ny);
  setPoint(n, o, nx, ny, one.x + nx * one.radius, one.y + ny * one.radius, separation);
  n[o + g.DX] = one.x - two.x + nx * (reach + separation);
  n[o + g.DY] = one.y - two.y + ny * (reach + separation);
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
