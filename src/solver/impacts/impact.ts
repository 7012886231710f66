import type { RigidBody } from '../../body.js';
import { DYNAMIC } from '../../body-kind.js';
import * as g from '../../collide/layout.js';
import {
  BOUNCE_THRESHOLD,
  CONTACT_SLOP,
  IMPACT_ITERATIONS,
  IMPACT_TOLERANCE,
  MAX_CONDITION,
  STATIC_FRICTION_SPEED_SQUARED,
} from '../../config.js';
import type { PointConstraint } from '../../constraint/point.js';
import type { Arbiter } from '../../contact/arbiter.js';
import { USED } from '../../contact/bits.js';
import * as c from '../../contact/layout.js';
import { List, release } from '../../math/list.js';
import type { World } from '../../world.js';
import { normalGain } from '../contacts/bounce.js';
import { Ledger } from '../contacts/no-gain.js';
import type { SolverData } from '../data.js';
import type { JointSolver } from '../joints/joints.js';
import * as d from '../layout.js';

/** One point of an impact. */
class Point {
  /** Whether it takes part in the impact. */
  isUsed = false;
  /** Arms, as in the records of contacts. */
  rnA = 0.5;
  rnB = 0.5;
  rtA = 0.5;
  rtB = 0.5;
  /** The inverse effective mass along the normal, and the effective mass along the tangent. */
  inverseNormalMass = 0.5;
  tangentMass = 0.5;
  /** The normal velocity to be reached, with the sign changed. */
  bias = 0.5;
  friction = 0.5;
  /** Velocity of B relative to A there. */
  normalSpeed = 0.5;
  tangentSpeed = 0.5;
  /** The impulses so far, and those to be reached. */
  normal = 0.5;
  tangent = 0.5;
  nextNormal = 0.5;
  nextTangent = 0.5;
  /** The impulses with friction, while it is solved without. */
  normalWithFriction = 0.5;
  tangentWithFriction = 0.5;
}

/**
 * A body, as an impact moves it: a free one with its inverse mass and inertia, and arms from its origin; or one on a hinge, which is held
 * there and can only turn about it, with arms from the hinge.
 */
class Side {
  body!: RigidBody;
  inverseMass = 0.5;
  inverseInertia = 0.5;
  hinge: PointConstraint | null = null;
  /** Where arms begin, relative to the origin of the body. */
  x = 0.5;
  y = 0.5;

  begin(body: RigidBody, joints: JointSolver | null): void {
    body.refreshMass();
    this.body = body;
    // As `inverseMass` and `inverseInertia`, which would have to box what they return if they were called from here.
    this.inverseMass = body.kind === DYNAMIC && body.mass > 0 ? 1 / body.mass : 0;
    this.inverseInertia = body.kind === DYNAMIC && body.inertia > 0 ? 1 / body.inertia : 0;
    this.hinge =
      joints !== null && this.inverseMass > 0 && this.inverseInertia > 0 ? joints.findHinge(body, this) : null;
    if (this.hinge !== null) {
      this.inverseMass = 0;
      this.inverseInertia = 1 / (body.inertia + body.mass * (this.x * this.x + this.y * this.y));
      // Keeps the angular momentum about the hinge, also where the velocity does not fit a turn about it.
      body.w = this.inverseInertia * (body.inertia * body.w + body.mass * (this.y * body.vx - this.x * body.vy));
      this.hold();
    } else {
      this.x = 0;
      this.y = 0;
    }
  }

  forget(): void {
    this.body = null!;
    this.hinge = null;
  }

  /** While an impact is solved, the velocity of a body on a hinge is that at the hinge, which is 0. */
  hold(): void {
    if (this.hinge !== null) {
      this.body.vx = 0;
      this.body.vy = 0;
    }
  }

  /** After that it is the velocity at the origin again, of turning about the hinge. */
  release(): void {
    const { body } = this;
    if (this.hinge !== null) {
      body.vx = body.w * this.y;
      body.vy = -body.w * this.x;
    }
  }
}

/** The impact of two shapes that meet. */
export class Impact {
  pair!: Arbiter;
  readonly points = [new Point(), new Point()] as const;
  readonly a = new Side();
  readonly b = new Side();
}

/** The impacts that are solved at once: scratch. What lies beyond the count is used again. */
const impacts: Impact[] = [];
let count = 0;

/** All bodies that these move, and their energies: scratch. */
const bodies = /* @__PURE__ */ new List<RigidBody>();
const ledger = /* @__PURE__ */ new Ledger();

/**
 * Solves the impacts of pairs that meet at once and share bodies. Restitution and friction as in the solver: of each pair first the
 * friction of each point, then both normals together, and so on, until nothing changes. Solved one after the other, the first of two tiles
 * would turn over a box that falls flat on both. The impulses are added to those of the step, and none are kept for warm start, as an
 * impact does not go on.
 */
export function solveImpacts({ solver, jointSolver }: World, pairs: List<Arbiter>): void {
  count = pairs.count;
  bodies.clear();
  for (let i = 0; i < count; i += 1) {
    if (i === impacts.length) {
      impacts.push(new Impact());
    }
    begin(solver, jointSolver, impacts[i]!, pairs.items[i]!);
  }
  ledger.open(bodies.count);
  noteVelocities(ledger.before);
  solve();
  noteVelocities(ledger.after);
  if (!ledger.isFinite()) {
    // With masses up to 1e308 impulses overflow.
    setVelocities(ledger.before);
    return;
  }
  keepEnergy();
  for (let i = 0; i < count; i += 1) {
    storeImpulses(impacts[i]!);
  }
  jointSolver?.noteHinges(impacts, count, bodies, ledger.before);
}

/** Releases the bodies and hinges of impacts that are over. */
export function releaseImpacts(): void {
  release(bodies.items, 0);
  for (const impact of impacts) {
    impact.pair = null!;
    impact.a.forget();
    impact.b.forget();
  }
}

function begin(data: SolverData, joints: JointSolver | null, impact: Impact, pair: Arbiter): void {
  const { bodyA: a, bodyB: b, numbers: n, at: o } = pair;
  impact.pair = pair;
  impact.a.begin(a, joints);
  impact.b.begin(b, joints);
  for (let which = 0; which < 2; which += 1) {
    setPoint(data, impact, which, which < pair.count && n[o + g.S0 + g.POINT * which]! <= CONTACT_SLOP);
  }
  // Another impact of the same body begins with all of its velocity.
  impact.a.release();
  impact.b.release();
  listBody(a);
  listBody(b);
}

function listBody(body: RigidBody): void {
  if (body.kind === DYNAMIC && !bodies.has(body)) {
    bodies.add(body);
  }
}

function noteVelocities(into: Float64Array): void {
  for (let k = 0; k < bodies.count; k += 1) {
    const { vx, vy, w } = bodies.items[k]!;
    into[3 * k] = vx;
    into[3 * k + 1] = vy;
    into[3 * k + 2] = w;
  }
}

function setVelocities(from: Float64Array): void {
  for (let k = 0; k < bodies.count; k += 1) {
    const body = bodies.items[k]!;
    body.vx = from[3 * k]!;
    body.vy = from[3 * k + 1]!;
    body.w = from[3 * k + 2]!;
  }
}

function noteWeights(): void {
  const { weights } = ledger;
  for (let k = 0; k < bodies.count; k += 1) {
    const { mass, inertia } = bodies.items[k]!;
    weights[3 * k] = mass < Infinity ? mass : 0;
    weights[3 * k + 1] = weights[3 * k]!;
    weights[3 * k + 2] = inertia < Infinity ? inertia : 0;
  }
}

function solve(): void {
  const most = IMPACT_ITERATIONS * count;
  for (let i = 0; i < count; i += 1) {
    impacts[i]!.a.hold();
    impacts[i]!.b.hold();
  }
  for (let i = 0, changed = true; i < most && changed; i += 1) {
    changed = false;
    for (let k = 0; k < count; k += 1) {
      changed = solveOne(impacts[k]!) || changed;
    }
  }
  for (let i = 0; i < count; i += 1) {
    impacts[i]!.a.release();
    impacts[i]!.b.release();
  }
}

/** One iteration over an impact. @returns as `push`. */
function solveOne(impact: Impact): boolean {
  const [one, two] = impact.points;
  const first = one.isUsed && solveFriction(impact, one);
  const second = two.isUsed && solveFriction(impact, two);
  const normals = one.isUsed && two.isUsed ? solveNormals(impact) : solveNormal(impact, one.isUsed ? one : two);
  return normals || first || second;
}

/**
 * If the impacts make energy, takes away as much of the friction as makes it. Not where something drives a body, or is set to bounce faster
 * than it came: these may make energy.
 */
function keepEnergy(): void {
  noteWeights();
  for (let i = 0; i < count; i += 1) {
    if (mayGain(impacts[i]!)) return;
  }
  if (!ledger.gains()) {
    return;
  }
  setVelocities(ledger.before);
  for (let i = 0; i < count; i += 1) {
    impacts[i]!.points.forEach(beginWithoutFriction);
  }
  solve();
  noteVelocities(ledger.without);
  const kept = ledger.lessen();
  setVelocities(ledger.without);
  for (let i = 0; i < count; i += 1) {
    for (const point of impacts[i]!.points) {
      // By rounding it might be negative where hardly anything is left.
      point.normal = Math.max(0, point.normal + kept * (point.normalWithFriction - point.normal));
      point.tangent = kept * point.tangentWithFriction;
    }
  }
}

function mayGain({ pair: { bodyA, bodyB, numbers: n, at: o } }: Impact): boolean {
  return addsEnergy(bodyA) || addsEnergy(bodyB) || n[o + c.ELASTICITY]! > 1;
}

/** Whether a body may add energy, by a motion that nothing stops or by its surface velocity. */
function addsEnergy(body: RigidBody): boolean {
  return body.kind === DYNAMIC ? body.surfaceX !== 0 || body.surfaceY !== 0 : body.drives();
}

function beginWithoutFriction(point: Point): void {
  point.normalWithFriction = point.normal;
  point.tangentWithFriction = point.tangent;
  point.normal = 0;
  point.tangent = 0;
  point.friction = 0;
}

function storeImpulses({ pair, points }: Impact): void {
  const { numbers: n, at: o } = pair;
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

/** Finds the velocities of B relative to A at a point. */
function measure({ pair }: Impact, point: Point): void {
  const { bodyA: a, bodyB: b, numbers: n, at: o } = pair;
  const nx = n[o + g.NX]!;
  const ny = n[o + g.NY]!;
  const dvx = b.vx - a.vx;
  const dvy = b.vy - a.vy;
  point.normalSpeed = nx * dvx + ny * dvy + point.rnB * b.w - point.rnA * a.w;
  point.tangentSpeed = nx * dvy - ny * dvx + point.rtB * b.w - point.rtA * a.w;
}

/** Prepares a point. One that takes no part gets no arms and no friction, and never approaches. */
function setPoint(data: SolverData, impact: Impact, which: number, isUsed: boolean): void {
  const { pair, points, a: sideA, b: sideB } = impact;
  const point = points[which]!;
  const { bodyA: a, bodyB: b, numbers: n, at: o } = pair;
  const nx = n[o + g.NX]!;
  const ny = n[o + g.NY]!;
  const x = n[o + g.X0 + g.POINT * which]!;
  const y = n[o + g.Y0 + g.POINT * which]!;
  const ax = isUsed ? x - sideA.x : 0;
  const ay = isUsed ? y - sideA.y : 0;
  const bx = isUsed ? x - n[o + g.DX]! - sideB.x : 0;
  const by = isUsed ? y - n[o + g.DY]! - sideB.y : 0;
  const inverseMass = sideA.inverseMass + sideB.inverseMass;
  point.isUsed = isUsed;
  point.rnA = ax * ny - ay * nx;
  point.rnB = bx * ny - by * nx;
  point.rtA = ax * nx + ay * ny;
  point.rtB = bx * nx + by * ny;
  const kn = inverseMass + sideA.inverseInertia * point.rnA * point.rnA + sideB.inverseInertia * point.rnB * point.rnB;
  const kt = inverseMass + sideA.inverseInertia * point.rtA * point.rtA + sideB.inverseInertia * point.rtB * point.rtB;
  measure(impact, point);
  const { normalSpeed, tangentSpeed } = point;
  const gain = normalGain(data, a.slot * d.BODY_STRIDE, b.slot * d.BODY_STRIDE, nx, ny);
  point.inverseNormalMass = kn > 0 ? kn : d.IMMOVABLE;
  point.tangentMass = kt > 0 ? 1 / kt : 0;
  point.bias = isUsed ? bounceBias(n[o + c.ELASTICITY]!, normalSpeed, gain) - (a.surfaceY + b.surfaceY) : Infinity;
  point.friction =
    tangentSpeed * tangentSpeed > STATIC_FRICTION_SPEED_SQUARED
      ? n[o + c.DYNAMIC_FRICTION]!
      : n[o + c.STATIC_FRICTION]!;
  point.normal = 0;
  point.tangent = 0;
}

/**
 * The least normal velocity with which a bounce ends, with the sign changed: −e times the one before. That also holds for a point that is
 * leaving and is turned back by the bounce of another point, to bounce in its turn (Moreau 1988); if it only had to keep from coming back,
 * both would leave faster than they came. The velocity with which the next sub-step starts is behind the true one by half of what forces
 * add in a sub-step. So that is added for the bounce, which keeps the height of a bouncing ball.
 */
function bounceBias(elasticity: number, speed: number, gain: number): number {
  const bias = elasticity * speed;
  return bias > BOUNCE_THRESHOLD ? bias : bias < -BOUNCE_THRESHOLD ? bias + 0.5 * (elasticity + 1) * gain : 0;
}

/** Solves the friction of a point. @returns as `push`. */
function solveFriction(impact: Impact, point: Point): boolean {
  const { pair } = impact;
  measure(impact, point);
  const slide = point.tangentSpeed - (pair.bodyA.surfaceX + pair.bodyB.surfaceX);
  const limit = point.friction * point.normal;
  point.nextNormal = point.normal;
  point.nextTangent = Math.max(-limit, Math.min(limit, point.tangent - slide * point.tangentMass));
  return push(impact, point);
}

/** Solves the normal of the only point that takes part. @returns as `push`. */
function solveNormal(impact: Impact, point: Point): boolean {
  measure(impact, point);
  const { normal, inverseNormalMass } = point;
  point.nextNormal = Math.max(0, -(point.normalSpeed + point.bias - inverseNormalMass * normal) / inverseNormalMass);
  point.nextTangent = point.tangent;
  return push(impact, point);
}

/**
 * Solves both normals together, as `solveVelocityTwo`: one after the other they would converge very slowly where points lie close together.
 * @returns as `push`.
 */
function solveNormals(impact: Impact): boolean {
  const { points, a, b } = impact;
  const [one, two] = points;
  measure(impact, one);
  measure(impact, two);
  const k11 = one.inverseNormalMass;
  const k22 = two.inverseNormalMass;
  const k12 =
    a.inverseMass + b.inverseMass + a.inverseInertia * one.rnA * two.rnA + b.inverseInertia * one.rnB * two.rnB;
  const det = k11 * k22 - k12 * k12;
  const b1 = one.normalSpeed + one.bias - k11 * one.normal - k12 * two.normal;
  const b2 = two.normalSpeed + two.bias - k12 * one.normal - k22 * two.normal;
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
  const pushed = push(impact, one);
  return push(impact, two) || pushed;
}

/**
 * Applies the difference between the impulses to be reached and those so far, to B, and the opposite to A. @returns whether that changed a
 * velocity.
 */
function push({ pair, a, b }: Impact, point: Point): boolean {
  const { bodyA, bodyB, numbers: n, at: o } = pair;
  const p = point.nextNormal - point.normal;
  const t = point.nextTangent - point.tangent;
  const x = n[o + g.NX]! * p - n[o + g.NY]! * t;
  const y = n[o + g.NY]! * p + n[o + g.NX]! * t;
  // What overflows must not reach bodies that cannot move.
  if (bodyA.kind === DYNAMIC) {
    bodyA.vx -= x * a.inverseMass;
    bodyA.vy -= y * a.inverseMass;
    bodyA.w -= (point.rnA * p + point.rtA * t) * a.inverseInertia;
  }
  if (bodyB.kind === DYNAMIC) {
    bodyB.vx += x * b.inverseMass;
    bodyB.vy += y * b.inverseMass;
    bodyB.w += (point.rnB * p + point.rtB * t) * b.inverseInertia;
  }
  point.normal = point.nextNormal;
  point.tangent = point.nextTangent;
  return Math.abs(p) * point.inverseNormalMass > IMPACT_TOLERANCE || Math.abs(t) > IMPACT_TOLERANCE * point.tangentMass;
}
