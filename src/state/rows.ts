import type { RigidBody } from '../body.js';
import { Applied } from '../body-applied.js';
import { LAST_MOTION, LAST_MOTION_END, LASTING, LASTING_END, MOTION } from '../body-numbers.js';
import * as g from '../collide/layout.js';
import { FAR, MAX_SIZE } from '../config.js';
import {
  FIRM_STEPS,
  FIRM_SWEEPS,
  MAX_JOINT_SWEEPS,
  NEW_JOINT_SWEEPS,
  SETTLE_STEPS,
  STUCK_STEPS,
  UNTRUE_STEPS,
} from '../config-joints.js';
import type { Arbiter } from '../contact/arbiter.js';
import { DEAD, KEPT, LISTED, SHOWN } from '../contact/bits.js';
import * as c from '../contact/layout.js';
import { polygonArea } from '../geometry/mass.js';
import { repeatedVertex } from '../geometry/vertices.js';
import type { Material } from '../material.js';
import type { Polygon } from '../shape/polygon.js';
import type { Shape } from '../shape/shape.js';
import { CIRCLE } from '../shape/shape-kind.js';
import type { Group } from '../solver/joints/joint-data.js';
import type { World } from '../world.js';
import { AGAIN, COUNT, FACE, FLAGS_END, HELD, ROLLED, SOLVED, USUAL } from './layout.js';
import { areSame, Row, type Tape } from './tape.js';

// The fields of each object that influence the future. Fields that can be derived from others are left out, and so are listeners and user
// data.

const MOST = 0x3fffffff;
/** The largest number of a feature: a corner, edge or axis. */
const FEATURES = 0xffffff;

const bodyRow = /* @__PURE__ */ new Row(1, 12);
const appliedRow = /* @__PURE__ */ new Row(1, 6);
const shapeRow = /* @__PURE__ */ new Row(1, 6);

/** All rows, for a tape. */
export const ROWS: readonly Row[] = [bodyRow, appliedRow, shapeRow];

/**
 * The numbers of the last pair that most pairs have in common, see `takeUsual`; and those of the last pair whose shapes have not met yet,
 * without a material.
 */
const usual = /* @__PURE__ */ new Float64Array(10);
const usualNear = /* @__PURE__ */ new Float64Array(6);

/** The numbers of a material, which cannot change. */
export function materialNumbers(material: Material): Float64Array {
  const { elasticity, staticFriction, dynamicFriction, rollingFriction, density } = material;
  return Float64Array.of(elasticity, staticFriction, dynamicFriction, rollingFriction, density);
}

/** Passes the settings and counters of a world. */
export function keepWorld(tape: Tape, world: World): void {
  const { solver } = world;
  world.gravityX = tape.number(world.gravityX);
  world.gravityY = tape.number(world.gravityY);
  world.time = tape.number(world.time);
  world.stamp = tape.number(world.stamp) | 0;
  world.velocityTotal = tape.integer(world.velocityTotal, 1, MOST);
  world.positionTotal = tape.integer(world.positionTotal, 1, MOST);
  world.substepCount = tape.integer(world.substepCount, 1, MOST);
  world.mayRest = tape.flag(world.mayRest);
  solver.previousH = tape.number(solver.previousH);
  solver.span = tape.number(solver.span);
  solver.spans = tape.number(solver.spans);
}

/** Passes a body. @returns whether its mass has to be computed anew. */
export function keepBody(tape: Tape, b: RigidBody): boolean {
  const { fixedMass, fixedInertia, numbers, at } = b;
  tape.block(numbers, at, at + MOTION);
  if (tape.checks) {
    checkPlace(tape);
  }
  tape.block(numbers, at + LAST_MOTION, at + LAST_MOTION_END);
  const { numbers: n, integers } = bodyRow;
  if (tape.writes) {
    const isPushed = b.applied !== null && (b.applied.pushes() || b.applied.pushedBefore());
    integers[0] =
      (b.asleep ? 1 : 0) |
      (b.woken ? 2 : 0) |
      (b.isBullet ? 4 : 0) |
      (b.kind << 3) |
      (isPushed ? 32 : 0) |
      (b.mayRest ? 64 : 0);
    for (let i = LASTING; i < LASTING_END; i += 1) {
      n[i - LASTING] = numbers[at + i]!;
    }
    n[9] = b.wakeTime;
    n[10] = b.unloaded;
    n[11] = b.gravityScale;
  }
  tape.pass(bodyRow);
  const flags = integers[0]!;
  tape.require(flags >= 0 && flags < 128 && ((flags >> 3) & 3) <= 2);
  keepApplied(tape, b, (flags & 32) !== 0);
  if (tape.takes) {
    b.asleep = (flags & 1) !== 0;
    b.woken = (flags & 2) !== 0;
    b.isBullet = (flags & 4) !== 0;
    b.kind = (flags >> 3) & 3;
    b.mayRest = (flags & 64) !== 0;
    for (let i = LASTING; i < LASTING_END; i += 1) {
      numbers[at + i] = n[i - LASTING]!;
    }
    b.wakeTime = n[9]! | 0;
    b.unloaded = n[10]! | 0;
    b.gravityScale = n[11]!;
  }
  return fixedMass !== b.fixedMass || fixedInertia !== b.fixedInertia;
}

/** Passes what pushes a body for one step. Most bodies have nothing like that. */
function keepApplied(tape: Tape, b: RigidBody, isSome: boolean): void {
  if (!isSome) {
    if (tape.takes) b.applied?.clear();
    return;
  }
  const applied = b.applied ?? new Applied();
  const { numbers: n, integers } = appliedRow;
  if (tape.writes) {
    integers[0] = applied.isKept ? 1 : 0;
    n[0] = applied.x;
    n[1] = applied.y;
    n[2] = applied.torque;
    n[3] = applied.lastX;
    n[4] = applied.lastY;
    n[5] = applied.lastTorque;
  }
  tape.pass(appliedRow);
  tape.require(integers[0] === 0 || integers[0] === 1);
  for (let i = 0; i < n.length; i += 1) {
    tape.require(Math.abs(n[i]!) <= FAR);
  }
  if (tape.takes) {
    b.applied = applied;
    applied.isKept = integers[0] === 1;
    applied.x = n[0]!;
    applied.y = n[1]!;
    applied.torque = n[2]!;
    applied.lastX = n[3]!;
    applied.lastY = n[4]!;
    applied.lastTorque = n[5]!;
  }
}

/**
 * Checks the numbers that passed last, which are x, y, angle, cosine, sine and the three of the velocity: the place is within bounds, and
 * cosine and sine are those of an angle.
 */
function checkPlace(tape: Tape): void {
  const [cos, sin] = [tape.latest(4), tape.latest(3)];
  for (let i = 5; i < MOTION; i += 1) {
    tape.require(Math.abs(tape.latest(i)) <= FAR);
  }
  tape.require(Math.abs(cos * cos + sin * sin - 1) <= 1e-9);
}

/** Passes a shape. @returns whether its geometry is another now. */
export function keepShape(tape: Tape, shape: Shape): boolean {
  const { numbers: n, integers } = shapeRow;
  const circle = shape.kind === CIRCLE ? shape : null;
  const polygon = shape.kind === CIRCLE ? null : shape;
  if (tape.writes) {
    integers[0] = polygon === null ? 1 : polygon.geometryStamp;
    n[0] = shape.getGroup();
    n[1] = shape.getMask();
    n[2] = shape.entered;
    n[3] = circle === null ? 1 : circle.radius;
    n[4] = circle === null ? 0 : circle.originX;
    n[5] = circle === null ? 0 : circle.originY;
  }
  tape.pass(shapeRow);
  const stamp = integers[0]!;
  const radius = n[3]!;
  const x = n[4]!;
  const y = n[5]!;
  tape.require(stamp >= 1 && stamp <= MOST && radius > 0 && Math.max(radius, Math.abs(x), Math.abs(y)) <= MAX_SIZE);
  if (tape.takes) {
    shape.setFilter(n[0]! | 0, n[1]! | 0);
    shape.entered = n[2]! | 0;
  }
  if (polygon !== null) {
    return keepVertices(tape, polygon, stamp);
  }
  const isOther = circle!.radius !== radius || circle!.originX !== x || circle!.originY !== y;
  if (tape.takes) {
    circle!.radius = radius;
    circle!.originX = x;
    circle!.originY = y;
  }
  return isOther;
}

function keepVertices(tape: Tape, polygon: Polygon, stamp: number): boolean {
  const { vertices } = polygon;
  const stored = tape.shared(vertices, MAX_SIZE);
  tape.require(stored.length >= 6 && stored.length % 2 === 0);
  const isOther = stored !== vertices;
  if (isOther && !tape.takes) {
    // Convexity is not required, as stretching may lose it to rounding.
    tape.require(polygonArea(stored) > 0 && repeatedVertex(stored) < 0);
  }
  if (tape.takes) {
    if (isOther) polygon.takeVertices(stored);
    polygon.geometryStamp = stamp;
  }
  return isOther && tape.takes;
}

/** Called before the first pair. */
export function beginPairs(): void {
  usual.fill(NaN);
  usualNear.fill(NaN);
}

/**
 * Passes a pair: what the solver keeps of two shapes, and what can be asked. The numbers of contact points beyond the count mean nothing.
 */
export function keepPair(tape: Tape, pair: Arbiter): void {
  const { numbers: n, at: o } = pair;
  const flags = tape.word(tape.writes ? flagsOf(pair) : 0);
  if (tape.checks) {
    checkFlags(tape, flags, pair);
  }
  if (tape.takes) {
    takeFlags(pair, flags);
  }
  keepFeatures(tape, n, o);
  if (n[o + g.FACE]! >= 0) {
    tape.block(n, o + g.FACE_X, o + g.FACE_TURN + 1);
  }
  const isKnown = pair.is(LISTED) || pair.is(DEAD);
  const as = isKnown ? usual : usualNear;
  if ((flags & USUAL) === 0) {
    passUsual(tape, pair, as);
  }
  if (tape.takes) {
    takeUsual(tape, pair, as);
  }
  if (isKnown) {
    tape.block(n, o + (pair.count > 0 ? g.DX : g.NX), o + g.X0 + g.POINT * pair.count);
  }
  if ((flags & AGAIN) !== 0) {
    keepMetAgain(tape, pair);
  }
  if ((flags & HELD) !== 0) {
    tape.block(pair.hold(), 0, c.HELD_NUMBERS);
  }
  if ((flags & SOLVED) !== 0) {
    const rolled = (flags & ROLLED) !== 0;
    tape.block(n, o + c.NORMAL, o + (rolled ? c.ELASTICITY : c.ROLL));
    if (tape.takes && !rolled) {
      n[o + c.ROLL] = 0;
      n[o + c.STEP_ROLL] = 0;
    }
  } else if (tape.takes && hasImpulse(n, o)) {
    n.fill(0, o + c.NORMAL, o + c.ELASTICITY);
  }
}

function flagsOf(pair: Arbiter): number {
  const { numbers: n, at: o } = pair;
  const isKnown = pair.is(LISTED) || pair.is(DEAD);
  return (
    (pair.bits & KEPT) |
    (pair.metAgain() ? AGAIN : 0) |
    (pair.isHeld() ? HELD : 0) |
    (hasImpulse(n, o) ? SOLVED : 0) |
    (hasRoll(n, o) ? ROLLED : 0) |
    (isUsual(pair, isKnown ? usual : usualNear) ? USUAL : 0) |
    (pair.count << COUNT) |
    ((n[o + g.FACE]! + 1) << FACE)
  );
}

function checkFlags(tape: Tape, flags: number, pair: Arbiter): void {
  const isRight =
    flags >> FLAGS_END === 0 && ((flags >> COUNT) & 3) < 3 && ((flags >> FACE) & 3) < 3 && ((flags >> SHOWN) & 3) < 3;
  tape.require(isRight && !(pair.is(DEAD) && (flags & LISTED) !== 0));
}

function takeFlags(pair: Arbiter, flags: number): void {
  const { numbers: n, at: o } = pair;
  pair.bits = (pair.bits & ~KEPT) | (flags & KEPT);
  n[o + g.COUNT] = (flags >> COUNT) & 3;
  n[o + g.FACE] = ((flags >> FACE) & 3) - 1;
}

/** Whether some impulse is not 0. Written out, as for most pairs all of them have to be read. */
function hasImpulse(n: Float64Array, o: number): boolean {
  return (
    n[o + c.NORMAL] !== 0 ||
    n[o + c.TANGENT] !== 0 ||
    n[o + c.STEP_NORMAL] !== 0 ||
    n[o + c.STEP_TANGENT] !== 0 ||
    n[o + c.NORMAL + c.IMPULSES] !== 0 ||
    n[o + c.TANGENT + c.IMPULSES] !== 0 ||
    n[o + c.STEP_NORMAL + c.IMPULSES] !== 0 ||
    n[o + c.STEP_TANGENT + c.IMPULSES] !== 0 ||
    hasRoll(n, o)
  );
}

function hasRoll(n: Float64Array, o: number): boolean {
  return n[o + c.ROLL] !== 0 || n[o + c.STEP_ROLL] !== 0;
}

/**
 * Passes corners, edges and axis, each −1 or more: in one word if all are below 63, as for shapes with few corners, else −1 and a word for
 * each.
 */
function keepFeatures(tape: Tape, n: Float64Array, o: number): void {
  const word = tape.word(tape.writes ? smallFeatures(n, o) : 0);
  if (word < 0) {
    for (let i = o + g.ID0; i <= o + g.AXIS; i += 1) {
      n[i] = tape.integer(n[i]!, -1, FEATURES);
    }
  } else if (tape.takes) {
    n[o + g.ID0] = ((word >> 24) & 63) - 1;
    n[o + g.ID1] = ((word >> 18) & 63) - 1;
    n[o + g.EDGE_A] = ((word >> 12) & 63) - 1;
    n[o + g.EDGE_B] = ((word >> 6) & 63) - 1;
    n[o + g.AXIS] = (word & 63) - 1;
  }
}

function smallFeatures(n: Float64Array, o: number): number {
  const id0 = n[o + g.ID0]! + 1;
  const id1 = n[o + g.ID1]! + 1;
  const edgeA = n[o + g.EDGE_A]! + 1;
  const edgeB = n[o + g.EDGE_B]! + 1;
  const axis = n[o + g.AXIS]! + 1;
  const areSmall = (id0 | id1 | edgeA | edgeB | axis) < 64;
  return areSmall ? (id0 << 24) | (id1 << 18) | (edgeA << 12) | (edgeB << 6) | axis : -1;
}

function isUsual(
  { numbers: n, at: o, seen, began, strainedUntil, lastInteraction, strain }: Arbiter,
  as: Float64Array,
): boolean {
  return (
    seen === as[0] &&
    began === as[1] &&
    strainedUntil === as[2] &&
    lastInteraction === as[3] &&
    strain === as[4] &&
    n[o + g.FACE_STAMP] === as[5] &&
    (as.length === 6 ||
      (areSame(n[o + c.ELASTICITY]!, as[6]!) &&
        areSame(n[o + c.STATIC_FRICTION]!, as[7]!) &&
        areSame(n[o + c.DYNAMIC_FRICTION]!, as[8]!) &&
        areSame(n[o + c.ROLLING_FRICTION]!, as[9]!)))
  );
}

/**
 * Passes the usual numbers of a pair: in what steps the shapes met, for which shapes the reference face was chosen and, if they have met,
 * the combined material.
 */
function passUsual(tape: Tape, pair: Arbiter, as: Float64Array): void {
  const { numbers: n, at: o } = pair;
  if (tape.writes) {
    as[0] = pair.seen;
    as[1] = pair.began;
    as[2] = pair.strainedUntil;
    as[3] = pair.lastInteraction;
    as[4] = pair.strain;
    as[5] = n[o + g.FACE_STAMP]!;
    for (let i = 6; i < as.length; i += 1) {
      as[i] = n[o + c.ELASTICITY - 6 + i]!;
    }
  }
  tape.block(as, 0, as.length);
}

/**
 * Takes over the usual numbers. Steps are made integers by `| 0`: else each becomes a boxed double here, and all steps that follow take 6 %
 * longer.
 */
function takeUsual(tape: Tape, pair: Arbiter, as: Float64Array): void {
  const { numbers: n, at: o } = pair;
  tape.require(as[4]! >= 0 && as[4]! <= MOST && as[5]! >= 0 && as[5]! <= MOST);
  pair.seen = as[0]! | 0;
  pair.began = as[1]! | 0;
  pair.strainedUntil = as[2]! | 0;
  pair.lastInteraction = as[3]! | 0;
  pair.strainFor(as[4]! | 0);
  n[o + g.FACE_STAMP] = as[5]!;
  for (let i = 6; i < as.length; i += 1) {
    n[o + c.ELASTICITY - 6 + i] = as[i]!;
  }
}

/** Passes the impulses that were given in the latest step before the contact points changed. */
function keepMetAgain(tape: Tape, pair: Arbiter): void {
  const { before } = pair;
  const x = tape.number(before?.x ?? 0);
  const y = tape.number(before?.y ?? 0);
  const wA = tape.number(before?.wA ?? 0);
  const wB = tape.number(before?.wB ?? 0);
  if (tape.takes) {
    pair.noteBefore(x, y, wA, wB);
  }
}

/** Passes what a group of joints carries over from step to step. */
export function keepGroup(tape: Tape, group: Group): void {
  tape.begins();
  group.fresh = tape.flag(group.fresh);
  group.isNew = tape.flag(group.isNew);
  group.toAndFro = tape.flag(group.toAndFro);
  group.burdened = tape.flag(group.burdened);
  group.mayGain = tape.flag(group.mayGain);
  group.isMechanism = tape.flag(group.isMechanism);
  group.isSmallAndHeld = tape.flag(group.isSmallAndHeld);
  group.untouchedSteps = tape.integer(group.untouchedSteps, 0, FIRM_STEPS);
  group.sweeps = tape.integer(group.sweeps, 0, Math.max(MAX_JOINT_SWEEPS, NEW_JOINT_SWEEPS, FIRM_SWEEPS));
  group.span = tape.number(group.span);
  group.excess = tape.number(group.excess);
  group.lost = tape.number(group.lost);
  group.settling = tape.integer(group.settling, 0, SETTLE_STEPS);
  group.stuckSteps = tape.integer(group.stuckSteps, 0, STUCK_STEPS);
  group.untrueSteps = tape.integer(group.untrueSteps, 0, UNTRUE_STEPS);
  group.from = tape.integer(group.from, -MOST, MOST);
  group.to = tape.integer(group.to, -MOST, MOST);
}
