import type { RigidBody } from '../body.js';
import { DYNAMIC } from '../body-kind.js';
import * as g from '../collide/layout.js';
import { BOUNCE_THRESHOLD, CONTACT_SLOP, IMPACT_ITERATIONS, STATIC_FRICTION_SPEED_SQUARED } from '../config.js';
import type { Arbiter } from '../contact/arbiter.js';
import { noteApproach } from '../contact/hit.js';
import * as c from '../contact/layout.js';
import { touch, touchAtPoint } from '../contact/touch.js';
import { FOUND_LATE } from '../events/events.js';
import { preSolve } from '../events/pre-solve.js';
import { BEGIN } from '../listeners.js';
import type { Shape } from '../shape/shape.js';
import type { World } from '../world.js';
import { normalGain } from './bounce.js';
import type { SolverData } from './data.js';
import * as d from './data.js';
import type { Meeting } from './meeting-queue.js';
import { smoothMeeting } from './seams.js';
import { joinLists, wakeBody } from './sleep.js';

/** An interaction begins in the course of a step. */
export function beginLate(world: World, pair: Arbiter): void {
  if (!pair.listed) {
    world.pairs.list(pair);
    joinLists(world, pair);
  }
  pair.persistent = false;
  pair.active = true;
  pair.began = world.timeStamp;
  pair.lastInteraction = world.timeStamp;
  world.events.interaction(BEGIN, pair, FOUND_LATE);
}

/** A sensor is crossed. */
export function beginSensing(world: World, a: Shape, b: Shape): void {
  beginLate(world, world.pairs.obtain(a, b));
}

/** Two shapes meet on their ways, where their bodies are now, or get too deep into each other. @returns the pair, or `null` if that has no effect. */
export function strike(world: World, { a, b }: Meeting): Arbiter | null {
  const pair = world.pairs.obtain(a, b);
  const begins = !pair.active;
  const { bodyA, bodyB } = pair;
  a.place(bodyA);
  b.place(bodyB);
  if (!begins) {
    pair.meetAgain(world.pairs.spare);
  }
  if (!touch(pair)) {
    touchAtPoint(pair);
  }
  smoothMeeting(world, pair);
  if (begins) {
    beginLate(world, pair);
    pair.dropPoints();
  }
  if (preSolve(world.events, pair)) {
    bodyA.wakeTime = world.timeStamp;
    bodyB.wakeTime = world.timeStamp;
  }
  if (!pair.accepted) {
    pair.dropPoints();
    return null;
  }
  rouse(world, bodyA, begins);
  rouse(world, bodyB, begins);
  if (begins) {
    noteApproach(pair);
  }
  if (world.profile !== null) {
    world.profile.impacts += 1;
  }
  solveImpact(world, pair);
  if (begins) {
    pair.freshPoints = pair.usedPoints;
    world.events.hit(pair, FOUND_LATE);
  } else if (bodyA.kind !== DYNAMIC || bodyB.kind !== DYNAMIC) {
    stopComing(pair);
  }
  return pair;
}

/** A dynamic body that is struck is awake; at the first impact of a pair it has the velocity of that time of the step. */
function rouse(world: World, body: RigidBody, begins: boolean): void {
  if (body.kind === DYNAMIC) {
    wakeBody(world, body, false);
    if (begins) {
      world.movers.of(body).slow(world.solver, world.substeps);
    }
  }
}

/** One point of an impact: arms, effective masses, what has to be reached, and what has been given. */
class Point {
  /** Whether it takes part. */
  isUsed = false;
  ax = 0.5;
  ay = 0.5;
  bx = 0.5;
  by = 0.5;
  normalMass = 0.5;
  tangentMass = 0.5;
  leave = 0.5;
  friction = 0.5;
  normal = 0.5;
  tangent = 0.5;
}

/** Both points, and the inverse masses and inertias of the bodies: scratch. */
const points = [new Point(), new Point()] as const;
const inverse = { massA: 0.5, massB: 0.5, inertiaA: 0.5, inertiaB: 0.5 };

/**
 * Gives both bodies the impulses of an impact at once: restitution and friction as in the solver, by sequential impulses (Catto, GDC 2006). They
 * are added to those of the step, and nothing is kept for the next one to start from, as an impact does not go on.
 */
export function solveImpact(world: World, pair: Arbiter): void {
  const { count, numbers: n, at: o } = pair;
  const { bodyA: a, bodyB: b } = pair;
  a.refreshMass();
  b.refreshMass();
  // As `inverseMass` and `inverseInertia`, which called from here would have to box what they return.
  inverse.massA = a.kind === DYNAMIC && a.mass > 0 ? 1 / a.mass : 0;
  inverse.massB = b.kind === DYNAMIC && b.mass > 0 ? 1 / b.mass : 0;
  inverse.inertiaA = a.kind === DYNAMIC && a.inertia > 0 ? 1 / a.inertia : 0;
  inverse.inertiaB = b.kind === DYNAMIC && b.inertia > 0 ? 1 / b.inertia : 0;
  for (let which = 0; which < 2; which += 1) {
    const point = points[which]!;
    point.isUsed = which < count && n[o + g.S0 + g.POINT * which]! <= CONTACT_SLOP;
    if (point.isUsed) {
      setPoint(world.solver, pair, which);
    }
  }
  let isSolved = false;
  for (let i = 0; i < IMPACT_ITERATIONS && !isSolved; i += 1) {
    isSolved = true;
    for (let which = 0; which < 2; which += 1) {
      if (points[which]!.isUsed && solvePoint(pair, points[which]!)) {
        isSolved = false;
      }
    }
  }
  for (let which = 0; which < 2; which += 1) {
    const { isUsed, normal, tangent } = points[which]!;
    if (isUsed) {
      const at = c.IMPULSES * which;
      n[o + c.STEP_NORMAL + at] = n[o + c.STEP_NORMAL + at]! + normal;
      n[o + c.STEP_TANGENT + at] = n[o + c.STEP_TANGENT + at]! + tangent;
      pair.usedPoints |= 1 << which;
    }
  }
}

/**
 * A body that touched before may whirl so fast that what touches is leaving, and so gets no impulse, while the rest of it comes on. Many impacts in a
 * step would stop that; here the velocity of its origin into the surface is taken from it.
 */
function stopComing(pair: Arbiter): void {
  const { numbers: n, at: o } = pair;
  const { bodyA: a, bodyB: b, before } = pair;
  if (n[o + c.STEP_NORMAL]! + n[o + c.STEP_NORMAL + c.IMPULSES]! > 0 || before === null) {
    return;
  }
  const point = points[0];
  const ofA = a.kind === DYNAMIC ? 0 : 1;
  point.ax = ofA * n[o + g.DX]!;
  point.ay = ofA * n[o + g.DY]!;
  point.bx = (ofA - 1) * n[o + g.DX]!;
  point.by = (ofA - 1) * n[o + g.DY]!;
  measureRelative(pair, point);
  const mass = inverse.massA + inverse.massB;
  const coming = -(n[o + g.NX]! * relative.x + n[o + g.NY]! * relative.y);
  if (coming > 0 && mass > 0) {
    const x = (n[o + g.NX]! * coming) / mass;
    const y = (n[o + g.NY]! * coming) / mass;
    a.vx -= x * inverse.massA;
    a.vy -= y * inverse.massA;
    b.vx += x * inverse.massB;
    b.vy += y * inverse.massB;
    before.x += x;
    before.y += y;
  }
}

/** Velocity of B against A at a point. */
const relative = { x: 0.5, y: 0.5 };
/** What `push` gives. */
const impulse = { x: 0.5, y: 0.5 };

function measureRelative({ bodyA: a, bodyB: b }: Arbiter, { ax, ay, bx, by }: Point): void {
  relative.x = b.vx - b.w * by - a.vx + a.w * ay;
  relative.y = b.vy + b.w * bx - a.vy - a.w * ax;
}

function setPoint(data: SolverData, pair: Arbiter, which: number): void {
  const point = points[which]!;
  const { numbers: n, at: o } = pair;
  const { bodyA: a, bodyB: b } = pair;
  const { massA, massB, inertiaA, inertiaB } = inverse;
  const nx = n[o + g.NX]!;
  const ny = n[o + g.NY]!;
  const ax = n[o + g.X0 + g.POINT * which]!;
  const ay = n[o + g.Y0 + g.POINT * which]!;
  const bx = ax - n[o + g.DX]!;
  const by = ay - n[o + g.DY]!;
  const mass = massA + massB;
  const rnA = ax * ny - ay * nx;
  const rnB = bx * ny - by * nx;
  const rtA = ax * nx + ay * ny;
  const rtB = bx * nx + by * ny;
  const kn = mass + inertiaA * rnA * rnA + inertiaB * rnB * rnB;
  const kt = mass + inertiaA * rtA * rtA + inertiaB * rtB * rtB;
  point.ax = ax;
  point.ay = ay;
  point.bx = bx;
  point.by = by;
  measureRelative(pair, point);
  const comes = nx * relative.x + ny * relative.y;
  const slide = nx * relative.y - ny * relative.x;
  const gain = normalGain(data, a.slot * d.BODY_STRIDE, b.slot * d.BODY_STRIDE, nx, ny);
  point.normalMass = kn > 0 ? 1 / kn : 0;
  point.tangentMass = kt > 0 ? 1 / kt : 0;
  point.leave = bounceSpeed(n[o + c.ELASTICITY]!, comes, gain) - (a.surfaceY + b.surfaceY);
  point.friction =
    slide * slide > STATIC_FRICTION_SPEED_SQUARED ? n[o + c.DYNAMIC_FRICTION]! : n[o + c.STATIC_FRICTION]!;
  point.normal = 0;
  point.tangent = 0;
}

/**
 * The least velocity that a bounce ends with, with the sign changed: −e times the one before, also for a point that is leaving and that the bounce of
 * another turns back, to bounce in its turn (Moreau 1988). If it had to keep from coming back, both would leave faster than they came.
 * A velocity that the next sub-step starts from is by half of what forces add in one behind the true one: so that is added for the bounce, which
 * keeps the height of a bouncing ball.
 */
function bounceSpeed(elasticity: number, comes: number, gain: number): number {
  const leaves = elasticity * comes;
  return leaves > BOUNCE_THRESHOLD ? leaves : leaves < -BOUNCE_THRESHOLD ? leaves + 0.5 * (elasticity + 1) * gain : 0;
}

/** @returns whether that changed an impulse. */
function solvePoint(pair: Arbiter, point: Point): boolean {
  const { bodyA: a, bodyB: b } = pair;
  const { numbers: n, at: o } = pair;
  const nx = n[o + g.NX]!;
  const ny = n[o + g.NY]!;
  measureRelative(pair, point);
  const { tangent: before } = point;
  const limit = point.friction * point.normal;
  const slide = nx * relative.y - ny * relative.x - (a.surfaceX + b.surfaceX);
  const tangent = Math.max(-limit, Math.min(limit, point.tangent - slide * point.tangentMass));
  if (tangent !== before) {
    impulse.x = -ny * (tangent - before);
    impulse.y = nx * (tangent - before);
    push(pair, point);
    point.tangent = tangent;
    measureRelative(pair, point);
  }
  const approach = nx * relative.x + ny * relative.y + point.leave;
  const normal = Math.max(0, point.normal - approach * point.normalMass);
  if (normal === point.normal) {
    return tangent !== before;
  }
  impulse.x = nx * (normal - point.normal);
  impulse.y = ny * (normal - point.normal);
  push(pair, point);
  point.normal = normal;
  return true;
}

/** Gives B the impulse and A the opposite. */
function push({ bodyA: a, bodyB: b }: Arbiter, { ax, ay, bx, by }: Point): void {
  const { x, y } = impulse;
  a.vx -= x * inverse.massA;
  a.vy -= y * inverse.massA;
  a.w -= (ax * y - ay * x) * inverse.inertiaA;
  b.vx += x * inverse.massB;
  b.vy += y * inverse.massB;
  b.w += (bx * y - by * x) * inverse.inertiaB;
}
