import type { RigidBody } from '../../../body.js';
import { MAX_SPEED } from '../../../config.js';
import { WHIRL } from '../../../config-joints.js';
import { type Constraint, isCustom } from '../../../constraint/constraint.js';
import { ANGLE, COS, POSE, ROW_AW, ROW_BW, ROW_SIZE, SIN, X, Y } from '../../../constraint/layout.js';
import { cosSin } from '../../../math/trig.js';
import type { World } from '../../../world.js';
import type { SolverData } from '../../data.js';
import * as d from '../../layout.js';
import { inPieces } from '../../pieces.js';
import { type Joint, silence } from '../joint-data.js';
import { forgetImpulse } from '../joint-numbers.js';
import { clear } from './jacobian.js';

/** Angle, cosine, sine: scratch. */
export const around = /* @__PURE__ */ new Float64Array(3);

/** As `cosSin`, for the turn of a sub-step in `around`, which is seldom large. */
export function turnAround(): void {
  const turn = around[0]!;
  const square = turn * turn;
  if (square > d.SMALL_TURN * d.SMALL_TURN) {
    cosSin(around);
    return;
  }
  around[1] = 1 - square * (1 / 2 - square * (1 / 24 - square * (1 / 720 - square / 40320)));
  around[2] = turn * (1 - square * (1 / 6 - square * (1 / 120 - square * (1 / 5040 - square / 362880))));
}

/** Writes the placements of all awake bodies as the step begins. */
export function packPoses(world: World): void {
  const { liveDynamics, liveKinematics } = world;
  const { pose } = world.solver;
  pose.fill(0, 0, POSE);
  pose[COS] = 1;
  writePoses(liveDynamics, pose);
  writePoses(liveKinematics, pose);
}

function writePoses(bodies: readonly RigidBody[], pose: Float64Array): void {
  for (let i = 0; i < bodies.length; i += 1) {
    writePose(bodies[i]!, pose, bodies[i]!.slot * POSE);
  }
}

function writePose(body: RigidBody, pose: Float64Array, at: number): void {
  pose[at + X] = body.x;
  pose[at + Y] = body.y;
  pose[at + COS] = body.cos;
  pose[at + SIN] = body.sin;
  pose[at + ANGLE] = body.angle;
}

function placeBody(body: RigidBody, pose: Float64Array, at: number): void {
  body.x = pose[at + X]!;
  body.y = pose[at + Y]!;
  body.cos = pose[at + COS]!;
  body.sin = pose[at + SIN]!;
  body.angle = pose[at + ANGLE]!;
}

/** Lets the joints of bodies that are too fast forget their impulses. */
function forgetImpulses(data: SolverData): void {
  const { joints, bodies } = data.joints;
  for (const joint of joints) {
    const { first, layout } = joint;
    for (let k = 0; k < layout.members; k += 1) {
      if (!isBelow(data.velocity, bodies[first + k]!, MAX_SPEED)) {
        forgetImpulse(data, joint, 0);
      }
    }
  }
}

/**
 * Adds the motion of the sub-step to the placements. Speeds from MAX_SPEED on, which cannot be meant, are clamped to it first, and the
 * joints of such bodies forget their impulses.
 */
export function advancePoses(data: SolverData): void {
  if (inPieces(data, 1, data.bodyCount, advancePosesPiece)) {
    forgetImpulses(data);
  }
}

/** @returns whether something was cut. */
function advancePosesPiece(data: SolverData, from: number, to: number): boolean {
  const { pointKernels } = data;
  if (pointKernels === null) {
    return advancePlain(data, from, to);
  }
  let isCut = false;
  for (let k = from; k < to; k += 1) {
    k = pointKernels.advancePoses(data, k, to);
    isCut = (k < to && advancePlain(data, k, k + 1)) || isCut;
  }
  return isCut;
}

function advancePlain(data: SolverData, from: number, to: number): boolean {
  const { pose: p, velocity: v, motion: q } = data;
  const most = MAX_SPEED * data.joints.h;
  let isCut = false;
  for (let k = from; k < to; k += 1) {
    const i = (k * d.BODY_STRIDE) & d.OFFSET;
    if (!(isBelow(v, i, MAX_SPEED) && isBelow(q, i, most))) {
      isCut = true;
      cut(v, i, MAX_SPEED);
      cut(q, i, most);
    }
    const turn = q[i + d.QW]!;
    around[0] = turn;
    turnAround();
    const c = around[1]!;
    const s = around[2]!;
    const c0 = p[i + COS]!;
    const s0 = p[i + SIN]!;
    p[i + COS] = c0 * c - s0 * s;
    p[i + SIN] = s0 * c + c0 * s;
    p[i + X] = p[i + X]! + q[i + d.QX]!;
    p[i + Y] = p[i + Y]! + q[i + d.QY]!;
    p[i + ANGLE] = p[i + ANGLE]! + turn;
  }
  return isCut;
}

/** Whether all of the first three numbers of a record are below a value. False if one is not a number. */
function isBelow(numbers: Float64Array, i: number, most: number): boolean {
  return Math.abs(numbers[i]!) < most && Math.abs(numbers[i + 1]!) < most && Math.abs(numbers[i + 2]!) < most;
}

function cut(numbers: Float64Array, i: number, most: number): void {
  for (let c = i; c < i + 3; c += 1) {
    numbers[c] = Math.max(-most, Math.min(most, numbers[c]!));
  }
}

/**
 * Writes the placements of a joint's members to `joints.pose`: those of the start of the sub-step or, if `moving`, those reached within it.
 */
function findPoses(data: SolverData, joint: Joint, moving: boolean): void {
  const { bodies, pose: to } = data.joints;
  const { motion: q, pose } = data;
  const { layout, first, constraint } = joint;
  for (let k = 0; k < layout.members; k += 1) {
    const b = bodies[first + k]!;
    const at = k * POSE;
    if (b === 0) {
      writePose(constraint.members[k]!, to, at);
      continue;
    }
    if (!moving) {
      to[at + X] = pose[b + X]!;
      to[at + Y] = pose[b + Y]!;
      to[at + COS] = pose[b + COS]!;
      to[at + SIN] = pose[b + SIN]!;
      to[at + ANGLE] = pose[b + ANGLE]!;
      continue;
    }
    const turn = q[b + d.QW]!;
    around[0] = turn;
    turnAround();
    const c = around[1]!;
    const s = around[2]!;
    to[at + X] = pose[b + X]! + q[b + d.QX]!;
    to[at + Y] = pose[b + Y]! + q[b + d.QY]!;
    to[at + COS] = pose[b + COS]! * c - pose[b + SIN]! * s;
    to[at + SIN] = pose[b + SIN]! * c + pose[b + COS]! * s;
    to[at + ANGLE] = pose[b + ANGLE]! + turn;
  }
}

/** Writes error and Jacobian for the placement with which the sub-step begins or, if `moving`, that reached within it. */
export function measure(data: SolverData, joint: Joint, moving: boolean): void {
  const { records: r } = data.joints;
  const { at, layout, constraint } = joint;
  const { rows, members, error } = layout;
  const jacobian = moving ? layout.turned : layout.jacobian;
  clear(r, at + error, rows);
  if (isCustom(constraint) || joint.twins.length > 0) clear(r, at + jacobian, 3 * rows * members);
  if (isCustom(constraint)) {
    showPoses(data, joint, moving);
  } else {
    findPoses(data, joint, moving);
  }
  constraint.measure(data.joints.pose, r, at + error, at + jacobian, moving || constraint.isElastic);
  if (isCustom(constraint) && constraint.failed) {
    silence(data.joints, joint);
    return;
  }
  mergeTwins(data, joint, jacobian);
  if (constraint.bounded) {
    compareWithBounds(r, joint, constraint.lowerLimit(), constraint.upper);
  }
  if (!moving && givesAtOnePlace(constraint)) {
    moveToOnePlace(data, joint);
  }
}

/** Adds up the columns of a body that is listed twice. */
function mergeTwins(data: SolverData, joint: Joint, jacobian: number): void {
  const { records: r } = data.joints;
  const { at, layout, twins } = joint;
  for (let i = 0; i < twins.length; i += 1) {
    const [one, other] = twins[i]!;
    for (let n = 0; n < layout.rows; n += 1) {
      const row = at + jacobian + 3 * n * layout.members;
      for (let c = 0; c < 3; c += 1) {
        r[row + 3 * one + c] = r[row + 3 * one + c]! + r[row + 3 * other + c]!;
        r[row + 3 * other + c] = 0;
      }
    }
  }
}

/**
 * Turns the measured value of the last row into its error: the value minus the bound that it exceeds or, within, minus the nearer one; 0 if
 * that is infinite. The impulse may only push back, unless both bounds are equal.
 */
export function compareWithBounds(
  r: Float64Array,
  { at, layout, constraint }: Joint,
  lower: number,
  upper: number,
): void {
  const e = at + layout.error + layout.rows - 1;
  const value = r[e]!;
  const toUpper = upper - value;
  const toLower = value - lower;
  const isUpper = toUpper <= toLower;
  const isOpen = isUpper ? toUpper === Infinity : toLower === Infinity;
  r[e] = isOpen ? 0 : isUpper ? -toUpper : toLower;
  r[at + layout.low] = lower === upper || (isUpper && !isOpen) ? -Infinity : 0;
  r[at + layout.high] = lower === upper || (!isUpper && !isOpen) ? Infinity : 0;
  r[at + layout.farError] = constraint.isElastic ? Infinity : upper - lower;
}

/** Moves the members of a custom constraint to where the solver has them, for its callbacks. */
export function showPoses(data: SolverData, joint: Joint, moving: boolean): void {
  const { bodies, pose, shown } = data.joints;
  const { velocity: v } = data;
  const { first, constraint } = joint;
  findPoses(data, joint, moving);
  constraint.members.forEach((body, k) => {
    const b = bodies[first + k]!;
    if (b !== 0) {
      if (!shown.has(body)) {
        const start = new Float64Array(POSE);
        writePose(body, start, 0);
        shown.set(body, start);
      }
      placeBody(body, pose, k * POSE);
      body.vx = v[b + d.VX]!;
      body.vy = v[b + d.VY]!;
      body.w = v[b + d.W]!;
    }
  });
}

/** Moves them back to where the step began; the end of the step adds their motion to that. */
export function hidePoses(data: SolverData): void {
  const { shown } = data.joints;
  if (shown.size === 0) {
    return;
  }
  for (const [body, start] of shown) {
    placeBody(body, start, 0);
  }
  shown.clear();
}

/**
 * Whether a joint that holds two points together applies its impulse to both bodies at one place between the points. Where these are apart,
 * as a soft joint lets them be, an impulse at each point would turn both bodies together, out of nothing. Rigid points do not do this:
 * pendulums keep their energy only if rigid points, and their corrections, have their own arms.
 */
function givesAtOnePlace({ type, isElastic }: Constraint): boolean {
  return type === 'WELD' || (type === 'POINT' && isElastic);
}

/**
 * Moves the arms of the first two rows of the velocity Jacobian to that place. It is chosen so that a soft joint damps as seen from a frame
 * that turns as the line between the anchors does, at a rate between those of A and B: so a wheel on a soft joint that gives way turns on,
 * and what hangs on the rim of a wheel goes with it. But what turns faster than the joint swings would be whirled ever farther, as a shaft
 * is by damping that turns with it: there the arms are moved by less.
 */
function moveToOnePlace(data: SolverData, { at, layout, first, constraint }: Joint): void {
  const { velocity: v, joints } = data;
  const { records: r, bodies } = joints;
  const a = bodies[first]!;
  const b = bodies[first + 1]!;
  // A body that cannot be turned takes whatever the other one gives.
  if (v[a + d.INV_INERTIA] === 0 || v[b + d.INV_INERTIA] === 0) return;
  const one = at + layout.jacobian;
  const two = one + ROW_SIZE;
  const wA = v[a + d.W]!;
  const wB = v[b + d.W]!;
  const x = r[at + layout.error]!;
  const y = r[at + layout.error + 1]!;
  const square = x * x + y * y;
  const vx = v[b + d.VX]! - v[a + d.VX]! + r[one + ROW_AW]! * wA + r[one + ROW_BW]! * wB;
  const vy = v[b + d.VY]! - v[a + d.VY]! + r[two + ROW_AW]! * wA + r[two + ROW_BW]! * wB;
  const turns = square > 0 ? (x * vy - y * vx) / square : 0;
  // The place, as a share of the way from A's anchor to B's.
  const between = wA === wB ? 0.5 : (turns - wB) / (wA - wB);
  // Also 0 for NaN, which numbers that are too large give.
  const share = between > 0 ? Math.min(1, between) : 0;
  const turning = Math.abs(share * wA + (1 - share) * wB);
  const most = constraint.isElastic ? WHIRL * 2 * Math.PI * constraint.frequency : Infinity;
  const part = turning > most ? most / turning : 1;
  const partA = part * share;
  const partB = part - partA;
  r[one + ROW_AW] = r[one + ROW_AW]! + partA * y;
  r[one + ROW_BW] = r[one + ROW_BW]! + partB * y;
  r[two + ROW_AW] = r[two + ROW_AW]! - partA * x;
  r[two + ROW_BW] = r[two + ROW_BW]! - partB * x;
}
