import type { RigidBody } from '../body.js';
import * as g from '../collide/layout.js';
import { FAR, MAX_JOINT_SWEEPS, MAX_SIZE, NEW_JOINT_SWEEPS, SETTLE_STEPS } from '../config.js';
import type { Arbiter } from '../contact/arbiter.js';
import * as c from '../contact/layout.js';
import { polygonArea } from '../geometry/mass.js';
import { repeatedVertex } from '../geometry/vertices.js';
import type { Material } from '../material.js';
import type { Polygon } from '../shape/polygon.js';
import type { Shape } from '../shape/shape.js';
import type { Group } from '../solver/joint-data.js';
import { Row, type Tape } from './tape.js';

// What of each object influences the future, field by field. What can be worked out from other fields is not there, nor are listeners and user data.

const MOST = 0x3fffffff;
/** Numbers that name features of shapes. */
const FEATURES = 0xffffff;

/** How many numbers of a manifold lie before the impulses, and how many impulses there are. */
const BEFORE = c.NORMAL;
const IMPULSES = c.ELASTICITY - c.NORMAL;
const MATERIAL = 4;

const bodyRow = /* @__PURE__ */ new Row(1, 23);
const shapeRow = /* @__PURE__ */ new Row(1, 6);
const pairRow = /* @__PURE__ */ new Row(8, 8);
/** … for those that have not met yet: rows of either kind are like others of that. */
const nearRow = /* @__PURE__ */ new Row(8, 8);
const contactRow = /* @__PURE__ */ new Row(0, g.FACE_DX + IMPULSES + MATERIAL);
const againRow = /* @__PURE__ */ new Row(0, 4);

/** All there are, for a tape. */
export const ROWS: readonly Row[] = [bodyRow, shapeRow, pairRow, nearRow, contactRow, againRow];

/** The numbers of a material, which cannot change. */
export function materialNumbers(material: Material): Float64Array {
  const { elasticity, staticFriction, dynamicFriction, rollingFriction, density } = material;
  return Float64Array.of(elasticity, staticFriction, dynamicFriction, rollingFriction, density);
}

function isUnit(x: number, y: number): boolean {
  return Math.abs(x * x + y * y - 1) <= 1e-9;
}

/** Distances and angles are not beyond all bounds. */
function isNear(...values: number[]): boolean {
  return values.every((value) => Math.abs(value) <= FAR);
}

/** @returns whether its mass has to be worked out anew. */
export function keepBody(tape: Tape, b: RigidBody): boolean {
  const { fixedMass, fixedInertia } = b;
  const { numbers: n, integers } = bodyRow;
  if (tape.writes) {
    integers[0] = (b.asleep ? 1 : 0) | (b.woken ? 2 : 0) | (b.bullet ? 4 : 0) | (b.kind << 3);
    n[0] = b.x;
    n[1] = b.y;
    n[2] = b.angle;
    n[3] = b.cos;
    n[4] = b.sin;
    n[5] = b.vx;
    n[6] = b.vy;
    n[7] = b.w;
    n[8] = b.lastDx;
    n[9] = b.lastDy;
    n[10] = b.lastTurn;
    n[11] = b.fx;
    n[12] = b.fy;
    n[13] = b.appliedTorque;
    n[14] = b.surfaceX;
    n[15] = b.surfaceY;
    n[16] = b.clearance;
    n[17] = b.linearDrag;
    n[18] = b.angularDrag;
    n[19] = fixedMass;
    n[20] = fixedInertia;
    n[21] = b.wakeTime;
    n[22] = b.unloaded;
  }
  tape.pass(bodyRow);
  const flags = integers[0]!;
  if (tape.checks) {
    tape.require(flags >= 0 && flags >> 3 <= 2);
    tape.require(isNear(n[0]!, n[1]!, n[2]!) && isUnit(n[3]!, n[4]!));
  }
  if (tape.takes) {
    b.asleep = (flags & 1) !== 0;
    b.woken = (flags & 2) !== 0;
    b.bullet = (flags & 4) !== 0;
    b.kind = flags >> 3;
    b.x = n[0]!;
    b.y = n[1]!;
    b.angle = n[2]!;
    b.cos = n[3]!;
    b.sin = n[4]!;
    b.vx = n[5]!;
    b.vy = n[6]!;
    b.w = n[7]!;
    b.lastDx = n[8]!;
    b.lastDy = n[9]!;
    b.lastTurn = n[10]!;
    b.fx = n[11]!;
    b.fy = n[12]!;
    b.appliedTorque = n[13]!;
    b.surfaceX = n[14]!;
    b.surfaceY = n[15]!;
    b.clearance = n[16]!;
    b.linearDrag = n[17]!;
    b.angularDrag = n[18]!;
    b.fixedMass = n[19]!;
    b.fixedInertia = n[20]!;
    b.wakeTime = n[21]!;
    b.unloaded = n[22]!;
  }
  return fixedMass !== b.fixedMass || fixedInertia !== b.fixedInertia;
}

/** @returns whether it is another shape now. */
export function keepShape(tape: Tape, shape: Shape): boolean {
  const { numbers: n, integers } = shapeRow;
  const circle = shape.kind === 0 ? shape : null;
  const polygon = shape.kind === 0 ? null : shape;
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
  const [stamp, group, mask, entered] = [integers[0]!, n[0]!, n[1]!, n[2]!];
  const [radius, x, y] = [n[3]!, n[4]!, n[5]!];
  tape.require(stamp >= 1 && stamp <= MOST && radius > 0 && Math.max(radius, Math.abs(x), Math.abs(y)) <= MAX_SIZE);
  if (tape.takes) {
    shape.group = group | 0;
    shape.mask = mask | 0;
    shape.entered = entered;
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
  if (stored !== vertices) {
    tape.require(!tape.checks || (polygonArea(stored) > 0 && repeatedVertex(stored) < 0));
    polygon.takeVertices(stored);
  }
  if (tape.takes) {
    polygon.geometryStamp = stamp;
  }
  return stored !== vertices;
}

/** Bits of the first integer of a pair. */
const ACTIVE = 1;
const SLEEPING = 2;
const ACCEPTED = 4;
const PERSISTENT = 8;
const AGAIN = 16;
/** There is more than where to look first. */
const SOLVED = 32;
const COUNT = 6;
const FACE = 8;
const FIXED = 10;
const USED = 14;
const FRESH = 16;
const SHOWN = 18;
const FLAGS_END = 20;

/** What the solver and whoever asks know of two shapes. The numbers of points that are not there mean nothing. */
export function keepPair(tape: Tape, pair: Arbiter): void {
  const { numbers: n, at: o } = pair;
  const isKnown = pair.listed || pair.dead;
  const row = isKnown ? pairRow : nearRow;
  const { numbers, integers } = row;
  if (tape.writes) {
    integers[0] =
      (pair.active ? ACTIVE : 0) |
      (pair.sleeping ? SLEEPING : 0) |
      (pair.accepted ? ACCEPTED : 0) |
      (pair.persistent ? PERSISTENT : 0) |
      (pair.metAgain() ? AGAIN : 0) |
      (isKnown || hasImpulse(n, o) ? SOLVED : 0) |
      (pair.count << COUNT) |
      ((n[o + g.FACE]! + 1) << FACE) |
      (pair.fixed << FIXED) |
      (pair.usedPoints << USED) |
      (pair.freshPoints << FRESH) |
      (pair.shown << SHOWN);
    integers[1] = n[o + g.ID0]!;
    integers[2] = n[o + g.ID1]!;
    integers[3] = n[o + g.EDGE_A]!;
    integers[4] = n[o + g.EDGE_B]!;
    integers[5] = n[o + g.AXIS]!;
    integers[6] = n[o + g.FACE_STAMP]!;
    integers[7] = pair.strain;
    numbers[0] = pair.seen;
    numbers[1] = pair.began;
    numbers[2] = pair.strained;
    numbers[3] = pair.lastInteraction;
    for (let i = 0; i < 4 && n[o + g.FACE]! >= 0; i += 1) {
      numbers[4 + i] = n[o + g.FACE_DX + i]!;
    }
  }
  tape.pass(row);
  const flags = integers[0]!;
  if (tape.checks) {
    checkPair(tape, flags, integers);
  }
  if (tape.takes) {
    pair.active = (flags & ACTIVE) !== 0;
    pair.sleeping = (flags & SLEEPING) !== 0;
    pair.accepted = (flags & ACCEPTED) !== 0;
    pair.persistent = (flags & PERSISTENT) !== 0;
    n[o + g.COUNT] = (flags >> COUNT) & 3;
    n[o + g.FACE] = ((flags >> FACE) & 3) - 1;
    pair.fixed = (flags >> FIXED) & 15;
    pair.usedPoints = (flags >> USED) & 3;
    pair.freshPoints = (flags >> FRESH) & 3;
    pair.shown = (flags >> SHOWN) & 3;
    n[o + g.ID0] = integers[1]!;
    n[o + g.ID1] = integers[2]!;
    n[o + g.EDGE_A] = integers[3]!;
    n[o + g.EDGE_B] = integers[4]!;
    n[o + g.AXIS] = integers[5]!;
    n[o + g.FACE_STAMP] = integers[6]!;
    pair.strain = integers[7]!;
    pair.seen = numbers[0]!;
    pair.began = numbers[1]!;
    pair.strained = numbers[2]!;
    pair.lastInteraction = numbers[3]!;
    for (let i = 0; i < 4; i += 1) {
      n[o + g.FACE_DX + i] = numbers[4 + i]!;
    }
  }
  if ((flags & AGAIN) !== 0) {
    keepMetAgain(tape, pair);
  }
  if ((flags & SOLVED) !== 0) {
    keepContacts(tape, pair, isKnown);
  } else if (tape.takes && hasImpulse(n, o)) {
    pair.dropPoints();
  }
}

function checkPair(tape: Tape, flags: number, integers: Int32Array): void {
  const isRight =
    flags >> FLAGS_END === 0 && ((flags >> COUNT) & 3) < 3 && ((flags >> FACE) & 3) < 3 && ((flags >> SHOWN) & 3) < 3;
  tape.require(isRight);
  for (let i = 1; i < integers.length; i += 1) {
    tape.require(integers[i]! >= -1 && integers[i]! <= (i < 6 ? FEATURES : MOST));
  }
}

function hasImpulse(n: Float64Array, o: number): boolean {
  let isSolved = false;
  for (let i = o + c.NORMAL; i < o + c.ELASTICITY && !isSolved; i += 1) {
    isSolved = n[i] !== 0;
  }
  return isSolved;
}

/** Where the points are, if it is known, impulses, and the combined material. */
function keepContacts(tape: Tape, { count, numbers: n, at: o }: Arbiter, isKnown: boolean): void {
  const { numbers } = contactRow;
  const from = count > 0 ? g.DX : g.NX;
  const to = isKnown ? g.X0 + g.POINT * count : from;
  if (tape.writes) {
    for (let i = 0; i < g.FACE_DX; i += 1) {
      numbers[i] = i >= from && i < to ? n[o + i]! : 0;
    }
    for (let i = BEFORE; i < BEFORE + IMPULSES + MATERIAL; i += 1) {
      numbers[i - BEFORE + g.FACE_DX] = isKnown || i < c.ELASTICITY ? n[o + i]! : 0;
    }
  }
  tape.pass(contactRow);
  if (tape.takes) {
    for (let i = from; i < to; i += 1) {
      n[o + i] = numbers[i]!;
    }
    for (let i = BEFORE; i < BEFORE + IMPULSES + (isKnown ? MATERIAL : 0); i += 1) {
      n[o + i] = numbers[i - BEFORE + g.FACE_DX]!;
    }
  }
}

/** What was given in the latest step before the points became others. */
function keepMetAgain(tape: Tape, pair: Arbiter): void {
  const { numbers: n } = againRow;
  const { before } = pair;
  if (tape.writes) {
    n[0] = before!.x;
    n[1] = before!.y;
    n[2] = before!.wA;
    n[3] = before!.wB;
  }
  tape.pass(againRow);
  if (tape.takes) {
    pair.noteBefore(n[0]!, n[1]!, n[2]!, n[3]!);
  }
}

/** What joints that hang together carry over from step to step. */
export function keepGroup(tape: Tape, group: Group): void {
  tape.begins();
  group.fresh = tape.flag(group.fresh);
  group.contested = tape.flag(group.contested);
  group.sweeps = tape.integer(group.sweeps, 0, Math.max(MAX_JOINT_SWEEPS, NEW_JOINT_SWEEPS));
  group.settling = tape.integer(group.settling, 0, SETTLE_STEPS);
  group.from = tape.integer(group.from, -MOST, MOST);
  group.to = tape.integer(group.to, -MOST, MOST);
}
