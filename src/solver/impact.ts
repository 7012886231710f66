import type { RigidBody } from '../body.js';
import { DYNAMIC } from '../body-kind.js';
import * as g from '../collide/layout.js';
import { BOUNCE_THRESHOLD, CONTACT_SLOP, IMPACT_ITERATIONS, STATIC_FRICTION_SPEED_SQUARED } from '../config.js';
import type { Arbiter } from '../contact/arbiter.js';
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
import { noteApproach } from './find-pairs.js';
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
export function strike(world: World, a: Shape, b: Shape, time: number): Arbiter | null {
  const pair = world.pairs.obtain(a, b);
  const begins = !pair.active;
  const { bodyA, bodyB } = pair;
  a.place(bodyA);
  b.place(bodyB);
  if (!begins) {
    pair.meetAgain();
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
  for (const body of [bodyA, bodyB]) {
    if (body.isDynamic()) {
      wakeBody(world, body, false);
      if (begins) {
        slowTo(world, body, time);
      }
    }
  }
  noteApproach(pair);
  if (world.profile !== null) {
    world.profile.impacts += 1;
  }
  solveImpact(world, pair);
  if (!begins && (bodyA.kind !== DYNAMIC || bodyB.kind !== DYNAMIC)) {
    stopComing(pair);
  }
  if (begins) {
    pair.freshPoints = pair.usedPoints;
    world.events.hit(pair, FOUND_LATE);
  }
  return pair;
}

/** Gives a body the velocity it has at a time of the step. */
function slowTo({ solver, substeps, movers }: World, body: RigidBody, time: number): void {
  const at = body.slot * d.BODY_STRIDE;
  const gain = (which: number): number => substeps * solver.drive[at + which]!;
  movers.of(body).slowTo(time, gain(d.GAIN_X), gain(d.GAIN_Y), gain(d.GAIN_W));
}

/** One point of an impact: arms, effective masses, what has to be reached, and what has been given. */
interface Point {
  readonly which: 0 | 1;
  readonly ax: number;
  readonly ay: number;
  readonly bx: number;
  readonly by: number;
  readonly normalMass: number;
  readonly tangentMass: number;
  readonly leave: number;
  readonly friction: number;
  normal: number;
  tangent: number;
}

/**
 * Gives both bodies the impulses of an impact at once: restitution and friction as in the solver, by sequential impulses (Catto, GDC 2006). They
 * are added to those of the step, and nothing is kept for the next one to start from, as an impact does not go on.
 */
export function solveImpact(world: World, pair: Arbiter): void {
  const points: Point[] = [];
  const { numbers: n, count } = pair.manifold;
  for (const which of [0, 1] as const) {
    if (which < count && n[g.S0 + g.POINT * which]! <= CONTACT_SLOP) {
      points.push(makePoint(world.solver, pair, which));
    }
  }
  for (let i = 0; i < IMPACT_ITERATIONS; i += 1) {
    for (const point of points) {
      solvePoint(pair, point);
    }
  }
  for (const { which, normal, tangent } of points) {
    const at = c.IMPULSES * which;
    n[c.STEP_NORMAL + at] = n[c.STEP_NORMAL + at]! + normal;
    n[c.STEP_TANGENT + at] = n[c.STEP_TANGENT + at]! + tangent;
    pair.usedPoints |= 1 << which;
  }
}

/**
 * A body that touched before may whirl so fast that what touches is leaving, and so gets no impulse, while the rest of it comes on. Many impacts in a
 * step would stop that; here the velocity of its origin into the surface is taken from it.
 */
function stopComing(pair: Arbiter): void {
  const n = pair.manifold.numbers;
  const { bodyA: a, bodyB: b, before } = pair;
  if (n[c.STEP_NORMAL]! + n[c.STEP_NORMAL + c.IMPULSES]! > 0 || before === null) {
    return;
  }
  const ofA = a.kind === DYNAMIC ? 0 : 1;
  measureRelative(pair, ofA * n[g.DX]!, ofA * n[g.DY]!, (ofA - 1) * n[g.DX]!, (ofA - 1) * n[g.DY]!);
  const mass = a.inverseMass() + b.inverseMass();
  const coming = -(n[g.NX]! * relative.x + n[g.NY]! * relative.y);
  if (coming > 0 && mass > 0) {
    const x = (n[g.NX]! * coming) / mass;
    const y = (n[g.NY]! * coming) / mass;
    a.vx -= x * a.inverseMass();
    a.vy -= y * a.inverseMass();
    b.vx += x * b.inverseMass();
    b.vy += y * b.inverseMass();
    before.x += x;
    before.y += y;
  }
}

/** Velocity of B against A at a point. */
const relative = { x: 0.5, y: 0.5 };

function measureRelative({ bodyA: a, bodyB: b }: Arbiter, ax: number, ay: number, bx: number, by: number): void {
  relative.x = b.vx - b.w * by - a.vx + a.w * ay;
  relative.y = b.vy + b.w * bx - a.vy - a.w * ax;
}

function makePoint(data: SolverData, pair: Arbiter, which: 0 | 1): Point {
  const n = pair.manifold.numbers;
  const { bodyA: a, bodyB: b } = pair;
  const nx = n[g.NX]!;
  const ny = n[g.NY]!;
  const ax = n[g.X0 + g.POINT * which]!;
  const ay = n[g.Y0 + g.POINT * which]!;
  const bx = ax - n[g.DX]!;
  const by = ay - n[g.DY]!;
  const mass = a.inverseMass() + b.inverseMass();
  const iA = a.inverseInertia();
  const iB = b.inverseInertia();
  const [rnA, rnB] = [ax * ny - ay * nx, bx * ny - by * nx];
  const [rtA, rtB] = [ax * nx + ay * ny, bx * nx + by * ny];
  const kn = mass + iA * rnA * rnA + iB * rnB * rnB;
  const kt = mass + iA * rtA * rtA + iB * rtB * rtB;
  measureRelative(pair, ax, ay, bx, by);
  const comes = nx * relative.x + ny * relative.y;
  const gain = normalGain(data, a.slot * d.BODY_STRIDE, b.slot * d.BODY_STRIDE, nx, ny);
  const slide = nx * relative.y - ny * relative.x;
  return {
    which,
    ax,
    ay,
    bx,
    by,
    normalMass: kn > 0 ? 1 / kn : 0,
    tangentMass: kt > 0 ? 1 / kt : 0,
    leave: bounceSpeed(n[c.ELASTICITY]!, comes, gain) - (a.surfaceY + b.surfaceY),
    friction: slide * slide > STATIC_FRICTION_SPEED_SQUARED ? n[c.DYNAMIC_FRICTION]! : n[c.STATIC_FRICTION]!,
    normal: 0,
    tangent: 0,
  };
}

/**
 * The velocity that a bounce ends with, with the sign changed. A velocity that the next sub-step starts from is by half of what forces add in one
 * behind the true one: so that is added for the bounce, which keeps the height of a bouncing ball.
 */
function bounceSpeed(elasticity: number, comes: number, gain: number): number {
  return elasticity * comes < -BOUNCE_THRESHOLD ? elasticity * (comes + 0.5 * gain) + 0.5 * gain : 0;
}

function solvePoint(pair: Arbiter, point: Point): void {
  const { bodyA: a, bodyB: b } = pair;
  const nx = pair.manifold.numbers[g.NX]!;
  const ny = pair.manifold.numbers[g.NY]!;
  const { ax, ay, bx, by } = point;
  measureRelative(pair, ax, ay, bx, by);
  const limit = point.friction * point.normal;
  const slide = nx * relative.y - ny * relative.x - (a.surfaceX + b.surfaceX);
  const tangent = Math.max(-limit, Math.min(limit, point.tangent - slide * point.tangentMass));
  push(pair, point, -ny * (tangent - point.tangent), nx * (tangent - point.tangent));
  point.tangent = tangent;
  measureRelative(pair, ax, ay, bx, by);
  const approach = nx * relative.x + ny * relative.y + point.leave;
  const normal = Math.max(0, point.normal - approach * point.normalMass);
  push(pair, point, nx * (normal - point.normal), ny * (normal - point.normal));
  point.normal = normal;
}

/** Gives B an impulse and A the opposite. */
function push({ bodyA: a, bodyB: b }: Arbiter, { ax, ay, bx, by }: Point, x: number, y: number): void {
  const mA = a.inverseMass();
  const mB = b.inverseMass();
  a.vx -= x * mA;
  a.vy -= y * mA;
  a.w -= (ax * y - ay * x) * a.inverseInertia();
  b.vx += x * mB;
  b.vy += y * mB;
  b.w += (bx * y - by * x) * b.inverseInertia();
}
