import { DYNAMIC } from '../../body-kind.js';
import * as g from '../../collide/layout.js';
import { works } from '../../collide/polygon-works.js';
import {
  MAX_CONDITION,
  MIN_INVERSE_MASS,
  PUSH_SHARE_CIRCLES,
  PUSH_SHARE_DYNAMIC,
  PUSH_SHARE_HOOKED,
  PUSH_SHARE_STATIC,
  PUSH_SHARE_UNEVEN,
  SHOCK_SPEED,
  SPECULATIVE_MARGIN,
  SQUEEZE_DEPTH,
  STATIC_FRICTION_SPEED_SQUARED,
  TURNS_TOGETHER,
  UNEVEN,
} from '../../config.js';
import { HEAVY } from '../../config-joints.js';
import { type Arbiter, hasCircle } from '../../contact/arbiter.js';
import { AWAKE, LISTED, NEAR } from '../../contact/bits.js';
import * as c from '../../contact/layout.js';
import type { List } from '../../math/list.js';
import { POLYGON } from '../../shape/shape-kind.js';
import type { World } from '../../world.js';
import { type ContactBatch, recordAt, type SolverData } from '../data.js';
import { canGiveWay } from '../interaction.js';
import * as d from '../layout.js';
import { markHard, markOf } from './hard-contacts.js';
import { noteStruck } from './shocks.js';
import { keepNormal } from './turning.js';

/**
 * Brings the world's lists of arbiters up to date, in the order of their shapes and without those that fell asleep in this step. Also
 * writes the records of all contacts, a window at a time, while the pairs are in the caches. A body that fell asleep in this step cannot
 * give way to another that comes near: they meet, and it wakes, when they touch.
 */
export function packContacts(world: World): void {
  const { solver, dynamicArbiters, staticArbiters, timeStamp } = world;
  const { sorted } = world.pairs;
  const { items } = sorted;
  const { window } = solver;
  solver.clearContacts();
  if (sorted.count > 2 * solver.roomFor) {
    solver.roomFor = sorted.count;
    makeRoom(solver, sorted);
  }
  let dynamics = 0;
  let statics = 0;
  let kept = 0;
  let count = 0;
  for (let i = 0; i < sorted.count; i += 1) {
    const pair = items[i]!;
    if (pair.sleeping) {
      pair.unmark(AWAKE);
      continue;
    }
    if (kept < i) items[kept] = pair;
    kept += 1;
    if (pair.is(NEAR) && !(canGiveWay(pair.bodyA) && canGiveWay(pair.bodyB))) pair.unmark(NEAR);
    if (pair.is(LISTED)) {
      if (pair.bodyA.kind === DYNAMIC && pair.bodyB.kind === DYNAMIC) {
        dynamicArbiters[dynamics] = pair;
        pair.listIndex = dynamics;
        dynamics += 1;
      } else {
        staticArbiters[statics] = pair;
        pair.listIndex = statics;
        statics += 1;
      }
    }
    if (pair.isSolved()) {
      window[count] = pair;
      count += 1;
      if (count === d.WINDOW) {
        packWindow(solver, count, timeStamp);
        count = 0;
      }
    }
  }
  if (count > 0) packWindow(solver, count, timeStamp);
  // Where nothing is awake the arrays are not this world's.
  if (solver.bodyCount > 1) solver.drive[d.TOUCHED] = 0;
  sorted.count = kept;
  // Tested first, here and elsewhere: to set a length takes time even where it changes nothing.
  if (dynamicArbiters.length > dynamics) dynamicArbiters.length = dynamics;
  if (staticArbiters.length > statics) staticArbiters.length = statics;
}

/**
 * Makes all of the room at once. Else it would be doubled again and again as contacts come, and everything copied each time, which for
 * 60,000 contacts took a second.
 */
function makeRoom(data: SolverData, { items, count }: List<Arbiter>): void {
  let ones = 0;
  let twos = 0;
  for (let i = 0; i < count; i += 1) {
    const pair = items[i]!;
    if (pair.isSolved()) {
      if (hasTwoPoints(pair)) twos += 1;
      else ones += 1;
    }
  }
  data.makeRoomForContacts(ones, twos);
}

/**
 * Writes the records of a window of contacts. The impulses kept from the last sub-step are scaled by `contactScale`.
 *
 * The order is that of the shapes' ids. But neighbours in it share a body, and the processor would wait for one contact before it can begin
 * the next. So each window of the list is split into four runs, which take turns. That saves a quarter of an iteration and changes no
 * result that matters. Refused: greedy colouring, so that no neighbours share a body. Solving, say, all left supports before all right ones
 * leaves the same error in all rows of a pyramid: one of base 20 slides 0.3 m and never rests (with this order: 0.02 m, and it rests). What
 * is hard to solve comes first, as it is swept over more often, and loops run over what lies side by side.
 */
function packWindow(data: SolverData, count: number, stamp: number): void {
  const mark = markHard(data, count, stamp);
  if (mark < d.NONE_HARD) {
    const { hard, hardCount, two, one } = data;
    hard[hardCount + d.FROM_TWO] = two.count;
    hard[hardCount + d.FROM_ONE] = one.count;
    packRuns(data, count, mark, true);
    hard[hardCount + d.TO_TWO] = two.count;
    hard[hardCount + d.TO_ONE] = one.count;
    data.hardCount += d.HARD_STRIDE;
  }
  packRuns(data, count, mark, false);
}

/** Packs those contacts of a window that are hard, or the others. */
function packRuns(data: SolverData, count: number, mark: number, areHard: boolean): void {
  const { window } = data;
  for (let first = 0; first < d.RUN && first < count; first += 1) {
    for (let i = first; i < count; i += d.RUN) {
      const pair = window[i]!;
      if (mark < d.NONE_HARD && (markOf(data, pair.bodyA) >= mark || markOf(data, pair.bodyB) >= mark) !== areHard) {
        continue;
      }
      if (hasTwoPoints(pair)) {
        works!.packTwo(data, data.two.add(pair));
      } else {
        packOne(data, data.one.add(pair));
      }
    }
  }
}

/** Whether a contact has two points that are both near enough to matter. */
function hasTwoPoints(pair: Arbiter): boolean {
  const { count, numbers: n, at: o } = pair;
  const limit = SPECULATIVE_MARGIN + (pair.foreseen > 0 ? Math.min(n[o + g.S0]!, n[o + g.S1]!) : 0);
  return count === 2 && n[o + g.S0]! <= limit && n[o + g.S1]! <= limit;
}

/**
 * Writes arms, effective masses, friction and kept impulses of both points. Straight-line: this runs once a step for every contact.
 * Friction acts between the points as their loads share it; where nothing is carried yet, at the deeper one.
 */
export function packTwo(data: SolverData, index: number): void {
  const batch = data.two;
  const at = recordAt(index, d.TWO_STRIDE) & d.OFFSET;
  const pair = batch.arbiters[index]!;
  const { numbers: n } = pair;
  const o = pair.at & d.OFFSET;
  const r = batch.records;
  const v = data.velocity;
  const a = (pair.bodyA.slot * d.BODY_STRIDE) & d.OFFSET;
  const b = (pair.bodyB.slot * d.BODY_STRIDE) & d.OFFSET;
  const nx = n[o + g.NX]!;
  const ny = n[o + g.NY]!;
  const x1 = n[o + g.X0]!;
  const y1 = n[o + g.Y0]!;
  const x2 = n[o + g.X1]!;
  const y2 = n[o + g.Y1]!;
  const dn = n[o + g.DX]! * nx + n[o + g.DY]! * ny;
  const dc = n[o + g.DX]! * ny - n[o + g.DY]! * nx;
  const rnA1 = x1 * ny - y1 * nx;
  const rnA2 = x2 * ny - y2 * nx;
  const rnB1 = rnA1 - dc;
  const rnB2 = rnA2 - dc;
  r[at + d.RN_A1] = rnA1;
  r[at + d.RN_B1] = rnB1;
  r[at + d.RN_A2] = rnA2;
  r[at + d.RN_B2] = rnB2;
  const p1 = n[o + c.NORMAL]!;
  const p2 = n[o + c.NORMAL + c.IMPULSES]!;
  const s1 = n[o + g.S0]!;
  const s2 = n[o + g.S1]!;
  const part = p1 > 0 && p2 >= 0 ? p1 / (p1 + p2) : p2 > 0 || s2 < s1 ? 0 : 1;
  const rtA = (x2 + part * (x1 - x2)) * nx + (y2 + part * (y1 - y2)) * ny;
  const rtB = rtA - dn;
  r[at + d.PART] = part;
  r[at + d.RT_A] = rtA;
  r[at + d.RT_B] = rtB;

  const mass = v[a + d.INV_MASS]! + v[b + d.INV_MASS]!;
  const iA = v[a + d.INV_INERTIA]!;
  const iB = v[b + d.INV_INERTIA]!;
  const kn1 = mass + iA * rnA1 * rnA1 + iB * rnB1 * rnB1;
  const kn2 = mass + iA * rnA2 * rnA2 + iB * rnB2 * rnB2;
  const k11 = kn1 > MIN_INVERSE_MASS ? kn1 : d.IMMOVABLE;
  const k22 = kn2 > MIN_INVERSE_MASS ? kn2 : d.IMMOVABLE;
  const k12 = mass + iA * rnA1 * rnA2 + iB * rnB1 * rnB2;
  const det = k11 * k22 - k12 * k12;
  const together = k11 * k11 < MAX_CONDITION * det;
  const inverse = together ? 1 / det : 1 / (k11 * k22);
  r[at + d.K11] = k11;
  r[at + d.K22] = k22;
  r[at + d.K12] = together ? k12 : 0;
  r[at + d.I11] = k22 * inverse;
  r[at + d.I12] = together ? -k12 * inverse : 0;
  r[at + d.I22] = k11 * inverse;
  r[at + d.START1] = together || s1 <= s2 ? s1 : d.OUT_OF_REACH;
  r[at + d.START2] = together || s2 < s1 ? s2 : d.OUT_OF_REACH;

  const scale = data.contactScale;
  const tangent = (n[o + c.TANGENT]! + n[o + c.TANGENT + c.IMPULSES]!) * scale;
  r[at + d.TANGENT] = tangent;
  r[at + d.TANGENT_SUM] = -tangent;
  r[at + d.NORMAL1] = p1 * scale;
  r[at + d.NORMAL2] = p2 * scale;
  r[at + d.NORMAL_SUM1] = -p1 * scale;
  r[at + d.NORMAL_SUM2] = -p2 * scale;
  packPair(data, batch, index, a, b);
}

/**
 * The same for a contact of one point, or for the deeper of two. Points lie half-way between the surfaces. Where a circle is yet to get
 * there, the friction acts on the surface of either body, as in a contact that is foreseen. Refused: the same for polygons, as heaps of rods
 * come to rest less often (16 of 216 do not within 15 s, instead of 9).
 */
function packOne(data: SolverData, index: number): void {
  const batch = data.one;
  const at = recordAt(index, d.ONE_STRIDE) & d.OFFSET;
  const pair = batch.arbiters[index]!;
  const { count, numbers: n, at: o } = pair;
  const r = batch.records;
  const v = data.velocity;
  const which = count === 2 && n[o + g.S1]! < n[o + g.S0]! ? 1 : 0;
  batch.point[index] = count === 2 ? which | d.ONE_OF_TWO : which;
  const a = (pair.bodyA.slot * d.BODY_STRIDE) & d.OFFSET;
  const b = (pair.bodyB.slot * d.BODY_STRIDE) & d.OFFSET;
  const nx = n[o + g.NX]!;
  const ny = n[o + g.NY]!;
  const ax = n[o + g.X0 + g.POINT * which]!;
  const ay = n[o + g.Y0 + g.POINT * which]!;
  const bx = ax - n[o + g.DX]!;
  const by = ay - n[o + g.DY]!;
  const separation = n[o + g.S0 + g.POINT * which]!;
  const gap = pair.foreseen > 0 ? 0 : separation;
  const half = hasCircle(pair) && pair.is(NEAR) && pair.foreseen === 0 ? 0.5 * gap : 0;
  const rnA = ax * ny - ay * nx;
  const rnB = bx * ny - by * nx;
  const alongA = ax * nx + ay * ny;
  const alongB = bx * nx + by * ny;
  const rtA = alongA - half;
  const rtB = alongB + half;
  r[at + d.RN_A1] = rnA;
  r[at + d.RN_B1] = rnB;
  r[at + d.RT_A] = rtA;
  r[at + d.RT_B] = rtB;
  // As `roundness`, which would have to box its numbers if it were called from here.
  const { shapeA, shapeB } = pair;
  r[at + d.PIVOT_A] = alongA;
  r[at + d.PIVOT_B] = alongB;
  if (shapeA.kind !== POLYGON) {
    r[at + d.PIVOT_A] = alongA - shapeA.radius - 0.5 * gap;
  }
  if (shapeB.kind !== POLYGON) {
    r[at + d.PIVOT_B] = alongB + shapeB.radius + 0.5 * gap;
  }

  const mass = v[a + d.INV_MASS]! + v[b + d.INV_MASS]!;
  const iA = v[a + d.INV_INERTIA]!;
  const iB = v[b + d.INV_INERTIA]!;
  const kn = mass + iA * rnA * rnA + iB * rnB * rnB;
  const rolls = count === 1 && iA + iB > MIN_INVERSE_MASS;
  const normalMass = kn > MIN_INVERSE_MASS ? 1 / kn : 0;
  const rollMass = rolls ? 1 / (iA + iB) : 0;
  r[at + d.NORMAL_MASS] = normalMass;
  r[at + d.ROLL_MASS] = rollMass;
  r[at + d.NORMAL_OF_TANGENT] = normalMass * (iA * rnA * rtA + iB * rnB * rtB);
  r[at + d.NORMAL_OF_ROLL] = normalMass * (iA * rnA + iB * rnB);
  r[at + d.ROLL_OF_TANGENT] = rollMass * (iA * rtA + iB * rtB);
  r[at + d.ROLL_FRICTION] = rolls ? n[o + c.ROLLING_FRICTION]! : 0;
  r[at + d.START1] = separation;

  const scale = data.contactScale;
  r[at + d.NORMAL1] = n[o + c.NORMAL + c.IMPULSES * which]! * scale;
  r[at + d.TANGENT] = n[o + c.TANGENT + c.IMPULSES * which]! * scale;
  r[at + d.ROLL] = n[o + c.ROLL]! * scale;
  r[at + d.NORMAL_SUM1] = -r[at + d.NORMAL1]!;
  r[at + d.TANGENT_SUM] = -r[at + d.TANGENT]!;
  r[at + d.ROLL_SUM] = -r[at + d.ROLL]!;
  packPair(data, batch, index, a, b);
}

/** Writes what the points of a pair share, once their arms are in the record; `a` and `b` are the offsets of the bodies' records. */
function packPair(data: SolverData, batch: ContactBatch, index: number, a: number, b: number): void {
  const { records: r, bodies, arbiters, stride } = batch;
  const { velocity: v, drive, traits } = data;
  const at = recordAt(index, stride) & d.OFFSET;
  const pair = arbiters[index]!;
  const { bodyA, bodyB, numbers: n } = pair;
  const o = pair.at & d.OFFSET;
  bodies[2 * index] = (index & 1) === 1 && waits(bodies, index, a, b) ? a | d.WAITS : a;
  bodies[2 * index + 1] = b;
  const nx = n[o + g.NX]!;
  const ny = n[o + g.NY]!;
  r[at + d.NX] = nx;
  r[at + d.NY] = ny;
  const mA = v[a + d.INV_MASS]!;
  const mB = v[b + d.INV_MASS]!;
  const rtA = r[at + d.RT_A]!;
  const rtB = r[at + d.RT_B]!;
  const kt = mA + mB + v[a + d.INV_INERTIA]! * rtA * rtA + v[b + d.INV_INERTIA]! * rtB * rtB;
  r[at + d.TANGENT_MASS] = kt > MIN_INVERSE_MASS ? 1 / kt : 0;
  const vx = v[b + d.VX]! - v[a + d.VX]!;
  const vy = v[b + d.VY]! - v[a + d.VY]!;
  const wA = v[a + d.W]!;
  const wB = v[b + d.W]!;
  const slide = nx * vy - ny * vx + rtB * wB - rtA * wA;
  const slides = slide * slide > STATIC_FRICTION_SPEED_SQUARED;
  r[at + d.FRICTION] = slides ? n[o + c.DYNAMIC_FRICTION]! : n[o + c.STATIC_FRICTION]!;

  const both = traits[bodyA.slot]! & traits[bodyB.slot]!;
  const either = traits[bodyA.slot]! | traits[bodyB.slot]!;

  const isTwo = stride === d.TWO_STRIDE;
  const contact = 2 * index + (isTwo ? 0 : 1);
  const comes = nx * vx + ny * vy;
  const other = isTwo ? at + d.SECOND : at;
  if (
    (either & d.LINKED) !== 0 ||
    comes + r[at + d.RN_B1]! * wB - r[at + d.RN_A1]! * wA < -SHOCK_SPEED ||
    comes + r[other + d.RN_B1]! * wB - r[other + d.RN_A1]! * wA < -SHOCK_SPEED
  ) {
    noteStruck(data, contact);
  }

  let share = PUSH_SHARE_STATIC;
  if (mA > 0 && mB > 0) {
    // What has several shapes or joints may hook into its like; what is far heavier would fall through.
    const mayHook = (either & d.COMPOUND) !== 0 || (both & d.LINKED) !== 0;
    if (mayHook && mA < HEAVY * mB && mB < HEAVY * mA) {
      share = PUSH_SHARE_HOOKED;
      data.hooked.add(contact);
    } else {
      share = shareOfTwo(pair, mA, mB);
    }
  }
  // Joints would have to bear for longer what is deep in them, and what is weightless does not fall back.
  const isHeap = mA > 0 && mB > 0 && (either & d.LINKED) === 0 && (isDrawn(drive, a) || isDrawn(drive, b));
  r[at + d.SHARE] = isHeap ? share : -share;
  if (Math.min(r[at + d.START1]!, r[other + d.START1]!) < -SQUEEZE_DEPTH) {
    data.squeezes.contacts.add(contact);
  }
  r[at + d.SURFACE_T] = -0;
  r[at + d.SURFACE_N] = -0;
  const load = (n[o + c.NORMAL]! + n[o + c.NORMAL + c.IMPULSES]!) * data.contactScale;
  drive[a + d.TOUCHED] = 1;
  drive[b + d.TOUCHED] = 1;
  drive[a + d.LOAD]! += load;
  drive[b + d.LOAD]! += load;
  if (bodyA.kind !== DYNAMIC || bodyB.kind !== DYNAMIC || (either & d.RUBS) !== 0) {
    packSurfaces(data, batch, index, pair);
  }
  // Not in heaps of single dynamic bodies, where it would only cost time.
  if (wA * wB > TURNS_TOGETHER && (mA === 0 || mB === 0 || (either & (d.LINKED | d.COMPOUND)) !== 0)) {
    keepNormal(data, contact);
  }
  if (n[o + c.ELASTICITY]! > 0) {
    data.bounces.add(batch, index, 0);
    if (isTwo) data.bounces.add(batch, index, d.SECOND);
  }
}

/** Whether gravity or forces accelerate the body whose record begins there. */
function isDrawn(drive: Float64Array, at: number): boolean {
  return drive[at + d.GAIN_X]! !== 0 || drive[at + d.GAIN_Y]! !== 0;
}

/** Whether a contact shares a body, other than slot 0, with the one before. */
function waits(bodies: Int32Array, index: number, a: number, b: number): boolean {
  const otherA = bodies[2 * index - 2]!;
  const otherB = bodies[2 * index - 1]!;
  return (a !== 0 && (a === otherA || a === otherB)) || (b !== 0 && (b === otherA || b === otherB));
}

/**
 * Writes surface velocities, where a body is not dynamic or its surface moves; and turns rest damping off for what such a body carries or
 * drives, however slowly.
 */
function packSurfaces({ drive }: SolverData, batch: ContactBatch, index: number, { bodyA, bodyB }: Arbiter): void {
  const at = recordAt(index, batch.stride);
  batch.records[at + d.SURFACE_T] = -(bodyA.surfaceX + bodyB.surfaceX);
  batch.records[at + d.SURFACE_N] = -(bodyA.surfaceY + bodyB.surfaceY);
  if (bodyA.kind !== DYNAMIC && bodyA.drives()) {
    drive[bodyB.slot * d.BODY_STRIDE + d.REST_RADIUS] = -1;
  }
  if (bodyB.kind !== DYNAMIC && bodyB.drives()) {
    drive[bodyA.slot * d.BODY_STRIDE + d.REST_RADIUS] = -1;
  }
}

/** Share of the overlap that a position iteration removes between two bodies that move, of these inverse masses. */
export function shareOfTwo({ shapeA, shapeB }: Arbiter, mA: number, mB: number): number {
  if (shapeA.kind !== POLYGON && shapeB.kind !== POLYGON) {
    return PUSH_SHARE_CIRCLES;
  }
  return mA > UNEVEN * mB || mB > UNEVEN * mA ? PUSH_SHARE_UNEVEN : PUSH_SHARE_DYNAMIC;
}
