import type { RigidBody } from '../body.js';
import { DYNAMIC } from '../body-kind.js';
import * as g from '../collide/layout.js';
import {
  BOUNCE_THRESHOLD,
  CONTACT_SLOP,
  IMPACT_ITERATIONS,
  IMPACT_TOLERANCE,
  MAX_CONDITION,
  STATIC_FRICTION_SPEED_SQUARED,
} from '../config.js';
import type { Arbiter } from '../contact/arbiter.js';
import { ACCEPTED, ACTIVE, FRESH, LISTED, PERSISTENT, USED } from '../contact/bits.js';
import { noteApproach } from '../contact/hit.js';
import * as c from '../contact/layout.js';
import { touch, touchAtPoint } from '../contact/touch.js';
import { FOUND_LATE } from '../events/events.js';
import { preSolve } from '../events/pre-solve.js';
import { BEGIN } from '../listeners.js';
import type { Shape } from '../shape/shape.js';
import type { World } from '../world.js';
import { joinLists } from './arbiter-lists.js';
import { normalGain } from './bounce.js';
import type { SolverData } from './data.js';
import * as d from './layout.js';
import type { Meeting } from './meeting-queue.js';
import { gains, lessen } from './no-gain.js';
import { isMoving } from './pack-contacts.js';
import { smoothMeeting } from './seams.js';
import { wakeBody } from './sleep.js';

/** An interaction begins in the course of a step. */
export function beginLate(world: World, pair: Arbiter): void {
  if (!pair.is(LISTED)) {
    world.pairs.list(pair);
    joinLists(world, pair);
  }
  pair.unmark(PERSISTENT);
  pair.mark(ACTIVE);
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
  if (!pair.is(ACCEPTED)) {
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
    pair.unmark(3 << FRESH);
    pair.mark(pair.usedPoints << FRESH);
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
      world.movers.of(body).slow(world.solver);
    }
  }
}

/** One point of an impact. */
class Point {
  /** Whether it takes part. */
  isUsed = false;
  /** Arms, as in the records of contacts. */
  rnA = 0.5;
  rnB = 0.5;
  rtA = 0.5;
  rtB = 0.5;
  /** What an impulse along the normal adds to the velocity there, and what impulse adds one along the tangent. */
  give = 0.5;
  tangentMass = 0.5;
  /** What has to be reached along the normal, with the sign changed. */
  leave = 0.5;
  friction = 0.5;
  /** Velocity of B against A there. */
  comes = 0.5;
  slides = 0.5;
  /** What has been given, and what is to be. */
  normal = 0.5;
  tangent = 0.5;
  nextNormal = 0.5;
  nextTangent = 0.5;
  /** What was given with friction, while it is solved without. */
  normalRubbed = 0.5;
  tangentRubbed = 0.5;
}

/** Both points, and the inverse masses and inertias of the bodies: scratch. */
const points = [new Point(), new Point()] as const;
const inverse = { massA: 0.5, massB: 0.5, inertiaA: 0.5, inertiaB: 0.5 };

/**
 * Gives both bodies the impulses of an impact at once: restitution and friction as in the solver, first the friction of each point, then both normals
 * together, until nothing changes. They are added to those of the step, and nothing is kept for the next one to start from, as an impact does not go on.
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
    setPoint(world.solver, pair, which, which < count && n[o + g.S0 + g.POINT * which]! <= CONTACT_SLOP);
  }
  noteVelocities(pair, before);
  solvePoints(pair);
  keepEnergy(pair);
  for (let which = 0; which < 2; which += 1) {
    const { isUsed, normal, tangent } = points[which]!;
    if (isUsed) {
      const at = c.IMPULSES * which;
      n[o + c.STEP_NORMAL + at] = n[o + c.STEP_NORMAL + at]! + normal;
      n[o + c.STEP_TANGENT + at] = n[o + c.STEP_TANGENT + at]! + tangent;
      pair.mark(1 << (USED + which));
    }
  }
}

function solvePoints(pair: Arbiter): void {
  for (let i = 0, changed = true; i < IMPACT_ITERATIONS && changed; i += 1) {
    const rubbed = rub(pair, points[0]);
    changed = rub(pair, points[1]) || rubbed;
    changed = solveNormals(pair) || changed;
  }
}

/** Of both bodies, `[vx, vy, w]` of each: before an impact, after it, and after it as it would be without friction; and their masses and inertias: scratch. */
const before = new Float64Array(6);
const after = new Float64Array(6);
const without = new Float64Array(6);
const weights = new Float64Array(6);

function noteVelocities({ bodyA: a, bodyB: b }: Arbiter, into: Float64Array): void {
  into[0] = a.vx;
  into[1] = a.vy;
  into[2] = a.w;
  into[3] = b.vx;
  into[4] = b.vy;
  into[5] = b.w;
}

function setVelocities({ bodyA: a, bodyB: b }: Arbiter, from: Float64Array): void {
  a.vx = from[0]!;
  a.vy = from[1]!;
  a.w = from[2]!;
  b.vx = from[3]!;
  b.vy = from[4]!;
  b.w = from[5]!;
}

/** Takes as much of friction from an impact as makes energy; what drives or is set to bounce higher may make it. */
function keepEnergy(pair: Arbiter): void {
  const { bodyA: a, bodyB: b, numbers: n, at: o } = pair;
  const { massA, massB, inertiaA, inertiaB } = inverse;
  weights[0] = massA > 0 ? 1 / massA : 0;
  weights[1] = weights[0];
  weights[2] = inertiaA > 0 ? 1 / inertiaA : 0;
  weights[3] = massB > 0 ? 1 / massB : 0;
  weights[4] = weights[3];
  weights[5] = inertiaB > 0 ? 1 / inertiaB : 0;
  noteVelocities(pair, after);
  if (drives(a) || drives(b) || n[o + c.ELASTICITY]! > 1 || !gains(weights, before, after, 6)) {
    return;
  }
  setVelocities(pair, before);
  for (let i = 0; i < 2; i += 1) {
    const point = points[i]!;
    point.normalRubbed = point.normal;
    point.tangentRubbed = point.tangent;
    point.normal = 0;
    point.tangent = 0;
    point.friction = 0;
  }
  solvePoints(pair);
  noteVelocities(pair, without);
  const kept = lessen(weights, before, without, after, 6);
  setVelocities(pair, without);
  for (let i = 0; i < 2; i += 1) {
    const point = points[i]!;
    point.normal += kept * (point.normalRubbed - point.normal);
    point.tangent = kept * point.tangentRubbed;
  }
}

/** By a motion that nothing stops, or by its surface. */
function drives(body: RigidBody): boolean {
  return body.kind === DYNAMIC ? body.surfaceX !== 0 || body.surfaceY !== 0 : isMoving(body);
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
  const nx = n[o + g.NX]!;
  const ny = n[o + g.NY]!;
  const across = n[o + g.DX]! * ny - n[o + g.DY]! * nx;
  const turning = a.kind === DYNAMIC ? across * b.w : across * a.w;
  const coming = nx * (a.vx - b.vx) + ny * (a.vy - b.vy) + turning;
  const mass = inverse.massA + inverse.massB;
  if (coming > 0 && mass > 0) {
    const x = (nx * coming) / mass;
    const y = (ny * coming) / mass;
    a.vx -= x * inverse.massA;
    a.vy -= y * inverse.massA;
    b.vx += x * inverse.massB;
    b.vy += y * inverse.massB;
    before.x += x;
    before.y += y;
  }
}

/** Velocities of B against A at a point. */
function measure({ bodyA: a, bodyB: b, numbers: n, at: o }: Arbiter, point: Point): void {
  const nx = n[o + g.NX]!;
  const ny = n[o + g.NY]!;
  const dvx = b.vx - a.vx;
  const dvy = b.vy - a.vy;
  point.comes = nx * dvx + ny * dvy + point.rnB * b.w - point.rnA * a.w;
  point.slides = nx * dvy - ny * dvx + point.rtB * b.w - point.rtA * a.w;
}

/** One that takes no part has no arms and no friction, and never comes. */
function setPoint(data: SolverData, pair: Arbiter, which: number, isUsed: boolean): void {
  const point = points[which]!;
  const { bodyA: a, bodyB: b, numbers: n, at: o } = pair;
  const { massA, massB, inertiaA, inertiaB } = inverse;
  const nx = n[o + g.NX]!;
  const ny = n[o + g.NY]!;
  const ax = isUsed ? n[o + g.X0 + g.POINT * which]! : 0;
  const ay = isUsed ? n[o + g.Y0 + g.POINT * which]! : 0;
  const bx = isUsed ? ax - n[o + g.DX]! : 0;
  const by = isUsed ? ay - n[o + g.DY]! : 0;
  const mass = massA + massB;
  point.isUsed = isUsed;
  point.rnA = ax * ny - ay * nx;
  point.rnB = bx * ny - by * nx;
  point.rtA = ax * nx + ay * ny;
  point.rtB = bx * nx + by * ny;
  const kn = mass + inertiaA * point.rnA * point.rnA + inertiaB * point.rnB * point.rnB;
  const kt = mass + inertiaA * point.rtA * point.rtA + inertiaB * point.rtB * point.rtB;
  measure(pair, point);
  const { comes, slides } = point;
  const gain = normalGain(data, a.slot * d.BODY_STRIDE, b.slot * d.BODY_STRIDE, nx, ny);
  point.give = kn > 0 ? kn : d.IMMOVABLE;
  point.tangentMass = kt > 0 ? 1 / kt : 0;
  point.leave = isUsed ? bounceSpeed(n[o + c.ELASTICITY]!, comes, gain) - (a.surfaceY + b.surfaceY) : Infinity;
  point.friction =
    slides * slides > STATIC_FRICTION_SPEED_SQUARED ? n[o + c.DYNAMIC_FRICTION]! : n[o + c.STATIC_FRICTION]!;
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

/** Friction at a point. @returns as `push`. */
function rub(pair: Arbiter, point: Point): boolean {
  measure(pair, point);
  const slide = point.slides - (pair.bodyA.surfaceX + pair.bodyB.surfaceX);
  const limit = point.friction * point.normal;
  point.nextNormal = point.normal;
  point.nextTangent = Math.max(-limit, Math.min(limit, point.tangent - slide * point.tangentMass));
  return push(pair, point);
}

/** Both normals, as `solveVelocityTwo`: one after the other they would come near very slowly where points lie close together. @returns as `push`. */
function solveNormals(pair: Arbiter): boolean {
  const [one, two] = points;
  const { massA, massB, inertiaA, inertiaB } = inverse;
  measure(pair, one);
  measure(pair, two);
  const k11 = one.give;
  const k22 = two.give;
  const k12 = massA + massB + inertiaA * one.rnA * two.rnA + inertiaB * one.rnB * two.rnB;
  const det = k11 * k22 - k12 * k12;
  const b1 = one.comes + one.leave - k11 * one.normal - k12 * two.normal;
  const b2 = two.comes + two.leave - k12 * one.normal - k22 * two.normal;
  one.nextNormal = (k12 * b2 - k22 * b1) / det;
  two.nextNormal = (k12 * b1 - k11 * b2) / det;
  if (!(k11 * k11 < MAX_CONDITION * det && one.nextNormal >= 0 && two.nextNormal >= 0)) {
    const first = Math.max(0, -b1 / k11);
    const second = Math.max(0, -b2 / k22);
    const isFirst = k12 * first + b2 >= 0 || k12 * second + b1 < 0;
    one.nextNormal = isFirst ? first : 0;
    two.nextNormal = isFirst ? 0 : second;
  }
  one.nextTangent = one.tangent;
  two.nextTangent = two.tangent;
  const pushed = push(pair, one);
  return push(pair, two) || pushed;
}

/** Gives B what a point is to have more than it has, and A the opposite. @returns whether that changed a velocity. */
function push({ bodyA: a, bodyB: b, numbers: n, at: o }: Arbiter, point: Point): boolean {
  const p = point.nextNormal - point.normal;
  const t = point.nextTangent - point.tangent;
  const x = n[o + g.NX]! * p - n[o + g.NY]! * t;
  const y = n[o + g.NY]! * p + n[o + g.NX]! * t;
  a.vx -= x * inverse.massA;
  a.vy -= y * inverse.massA;
  a.w -= (point.rnA * p + point.rtA * t) * inverse.inertiaA;
  b.vx += x * inverse.massB;
  b.vy += y * inverse.massB;
  b.w += (point.rnB * p + point.rtB * t) * inverse.inertiaB;
  point.normal = point.nextNormal;
  point.tangent = point.nextTangent;
  return Math.abs(p) * point.give > IMPACT_TOLERANCE || Math.abs(t) > IMPACT_TOLERANCE * point.tangentMass;
}
