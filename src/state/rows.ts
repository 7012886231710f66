import type { RigidBody } from '../body.js';
import * as g from '../collide/layout.js';
import { FAR, MAX_JOINT_SWEEPS, MAX_SIZE, NEW_JOINT_SWEEPS, SETTLE_STEPS } from '../config.js';
import type { Arbiter } from '../contact/arbiter.js';
import * as c from '../contact/layout.js';
import { polygonArea } from '../geometry/mass.js';
import { repeatedVertex } from '../geometry/vertices.js';
import type { Material } from '../material.js';
import type { Circle } from '../shape/circle.js';
import type { Polygon } from '../shape/polygon.js';
import type { Shape } from '../shape/shape.js';
import type { Group } from '../solver/joint-data.js';
import type { Tape } from './tape.js';

// What of each object influences the future, field by field. What can be worked out from other fields is not there, nor are listeners and user data.

/** Rows of a tape. */
export const WORLD = 0;
export const BODY = 1;
export const SHAPE = 2;
export const CONSTRAINT = 3;
export const PAIR = 4;
export const GROUP = 5;
export const LISTED = 6;

const MOST = 0x3fffffff;
/** Numbers that name features of shapes. */
const FEATURES = 0xffffff;

/** The numbers of a material, which cannot change. */
export function materialNumbers(material: Material): Float64Array {
  const { elasticity, staticFriction, dynamicFriction, rollingFriction, density } = material;
  return Float64Array.of(elasticity, staticFriction, dynamicFriction, rollingFriction, density);
}

function isUnit(x: number, y: number): boolean {
  return Math.abs(x * x + y * y - 1) <= 1e-9;
}

/** @returns whether its mass has to be worked out anew. */
export function keepBody(tape: Tape, b: RigidBody): boolean {
  const { fixedMass, fixedInertia } = b;
  tape.begins(BODY);
  b.asleep = tape.flag(b.asleep);
  b.woken = tape.flag(b.woken);
  b.bullet = tape.flag(b.bullet);
  b.kind = tape.integer(b.kind, 0, 2);
  b.x = tape.number(b.x, -FAR, FAR);
  b.y = tape.number(b.y, -FAR, FAR);
  b.angle = tape.number(b.angle, -FAR, FAR);
  b.cos = tape.number(b.cos, -1, 1);
  const cos = tape.latest;
  b.sin = tape.number(b.sin, -1, 1);
  tape.require(!tape.checks || isUnit(cos, tape.latest), 'cosine and sine are of no angle');
  b.vx = tape.sparse(b.vx);
  b.vy = tape.sparse(b.vy);
  b.w = tape.sparse(b.w);
  b.lastDx = tape.sparse(b.lastDx);
  b.lastDy = tape.sparse(b.lastDy);
  b.lastTurn = tape.sparse(b.lastTurn);
  b.fx = tape.sparse(b.fx);
  b.fy = tape.sparse(b.fy);
  b.appliedTorque = tape.sparse(b.appliedTorque);
  b.surfaceX = tape.sparse(b.surfaceX);
  b.surfaceY = tape.sparse(b.surfaceY);
  b.clearance = tape.sparse(b.clearance);
  b.linearDrag = tape.number(b.linearDrag);
  b.angularDrag = tape.number(b.angularDrag);
  b.fixedMass = tape.number(b.fixedMass);
  b.fixedInertia = tape.number(b.fixedInertia);
  b.wakeTime = tape.number(b.wakeTime);
  b.unloaded = tape.number(b.unloaded);
  return fixedMass !== b.fixedMass || fixedInertia !== b.fixedInertia;
}

/** @returns whether it is another shape now. */
export function keepShape(tape: Tape, shape: Shape): boolean {
  tape.begins(SHAPE);
  shape.group = tape.number(shape.group);
  shape.mask = tape.number(shape.mask);
  shape.entered = tape.number(shape.entered);
  return shape.kind === 0 ? keepCircle(tape, shape) : keepPolygon(tape, shape);
}

function keepCircle(tape: Tape, circle: Circle): boolean {
  const { radius, originX, originY } = circle;
  circle.radius = tape.number(radius, Number.MIN_VALUE, MAX_SIZE);
  circle.originX = tape.number(originX, -MAX_SIZE, MAX_SIZE);
  circle.originY = tape.number(originY, -MAX_SIZE, MAX_SIZE);
  return radius !== circle.radius || originX !== circle.originX || originY !== circle.originY;
}

function keepPolygon(tape: Tape, polygon: Polygon): boolean {
  const { vertices, geometryStamp } = polygon;
  const stamp = tape.integer(geometryStamp, 1, MOST);
  const stored = tape.shared(vertices, MAX_SIZE);
  tape.require(stored.length >= 6 && stored.length % 2 === 0, 'a polygon has no corners');
  if (stored !== vertices) {
    tape.require(polygonArea(stored) > 0 && repeatedVertex(stored) < 0, 'corners of a polygon are those of none');
    polygon.takeVertices(stored);
  }
  polygon.geometryStamp = stamp;
  return stored !== vertices;
}

/** What the solver and whoever asks know of two shapes. The numbers of points that are not there mean nothing. */
export function keepPair(tape: Tape, pair: Arbiter): void {
  const { manifold: m } = pair;
  const { numbers: n } = m;
  tape.begins(PAIR);
  pair.active = tape.flag(pair.active);
  pair.sleeping = tape.flag(pair.sleeping);
  pair.accepted = tape.flag(pair.accepted);
  pair.persistent = tape.flag(pair.persistent);
  m.count = tape.integer(m.count, 0, 2);
  m.id0 = tape.integer(m.id0, 0, FEATURES);
  m.id1 = tape.integer(m.id1, 0, FEATURES);
  m.edgeA = tape.integer(m.edgeA, -1, FEATURES);
  m.edgeB = tape.integer(m.edgeB, -1, FEATURES);
  m.axis = tape.integer(m.axis, -1, FEATURES);
  m.face = tape.integer(m.face, -1, 1);
  m.faceStamp = tape.integer(m.faceStamp, 0, MOST);
  pair.fixed = tape.integer(pair.fixed, 0, 15);
  pair.usedPoints = tape.integer(pair.usedPoints, 0, 3);
  pair.freshPoints = tape.integer(pair.freshPoints, 0, 3);
  pair.seen = tape.number(pair.seen);
  pair.began = tape.number(pair.began);
  pair.strained = tape.number(pair.strained);
  pair.lastInteraction = tape.number(pair.lastInteraction);
  pair.shown = tape.integer(pair.shown, 0, 2);
  pair.strain = tape.integer(pair.strain, 0, MOST);
  const isKnown = pair.listed || pair.dead;
  for (let i = c.ELASTICITY; i <= c.ROLLING_FRICTION && isKnown; i += 1) {
    n[i] = tape.number(n[i]!);
  }
  keepMetAgain(tape, pair);
  // The numbers lie side by side: those of the points, of which there may be none, for what the edges were chosen, and impulses.
  if (isKnown) {
    tape.span(n, m.count > 0 ? g.DX : g.NX, m.count === 2 ? g.FACE_DX : m.count === 1 ? g.X1 : g.X0);
  }
  tape.span(n, m.face >= 0 ? g.FACE_DX : c.NORMAL, c.ELASTICITY);
}

/** What was given in the latest step before the points became others. */
function keepMetAgain(tape: Tape, pair: Arbiter): void {
  if (tape.flag(pair.metAgain())) {
    const before = pair.before ?? { step: pair.lastInteraction, x: 0, y: 0, wA: 0, wB: 0 };
    before.x = tape.sparse(before.x);
    before.y = tape.sparse(before.y);
    before.wA = tape.sparse(before.wA);
    before.wB = tape.sparse(before.wB);
    pair.before = before;
  }
}

/** What joints that hang together carry over from step to step. */
export function keepGroup(tape: Tape, group: Group): void {
  tape.begins(GROUP);
  group.fresh = tape.flag(group.fresh);
  group.contested = tape.flag(group.contested);
  group.sweeps = tape.integer(group.sweeps, 0, Math.max(MAX_JOINT_SWEEPS, NEW_JOINT_SWEEPS));
  group.settling = tape.integer(group.settling, 0, SETTLE_STEPS);
  group.from = tape.integer(group.from, -MOST, MOST);
  group.to = tape.integer(group.to, -MOST, MOST);
}
