import { MIN_INVERSE_MASS } from '../../../config.js';
import { BOUND_SLOP, JOINT_MOMENTUM, JOINT_TOLERANCE } from '../../../config-joints.js';
import type { AngleConstraint } from '../../../constraint/angle.js';
import { ANGLE } from '../../../constraint/layout.js';
import type { MotorConstraint } from '../../../constraint/motor.js';
import type { PointConstraint } from '../../../constraint/point.js';
import { remember, type SolverData } from '../../data.js';
import * as d from '../../layout.js';
import { type Joint, packHead } from '../joint-data.js';
import * as j from '../joint-layout.js';
import { noteLag, shorterList } from '../joint-numbers.js';

/**
 * Angles and motors that do not break, and points that keep an angle. Method and record are like those of a block joint with the one row
 * (0, 0, −1, 0, 0, ratio), so only angular velocities count. K is the same in the whole step; and as the error is linear in the turns, each
 * position sweep has it exactly, and looks at both bounds.
 */

/** Writes what changes seldom: bodies, bounds, softness, and the impulse to start with. */
export function packTurn(data: SolverData, joint: Joint): void {
  const { records: r, bodies } = data.joints;
  const { at, first } = joint;
  const constraint = joint.constraint as AngleConstraint | MotorConstraint | PointConstraint;
  const { bodyA, bodyB, ratio, positional, lower, upper, type } = constraint;
  const a = constraint.slotOf(bodyA) * d.BODY_STRIDE;
  const b = constraint.slotOf(bodyB) * d.BODY_STRIDE;
  bodies[first] = a;
  bodies[first + 1] = b;
  packHead(data.joints, joint);
  r[at + j.TURN_IMPULSE] = constraint.impulse[0]!;
  r[at + j.TURN_LOW] = -Infinity;
  r[at + j.TURN_HIGH] = Infinity;
  r[at + j.TURN_RATIO] = ratio;
  r[at + j.TURN_BOUNDED] = positional ? 1 : 0;
  r[at + j.TURN_LOWER] = lower;
  r[at + j.TURN_UPPER] = upper;
  r[at + j.TURN_ANGLE] = joint.angle;
  // The part of the value that is due to bodies that cannot move.
  r[at + j.TURN_STILL] = (b === 0 ? ratio * bodyB.angle : 0) - (a === 0 ? bodyA.angle : 0);
  if (type === 'MOTOR') {
    r[at + j.TURN_RATE] = constraint.getRate();
    findStops(data, joint);
  }
}

/**
 * Finds the stops of a motor: the bounds of angle constraints between its bodies, beyond which it does not drive them. Else motor and bound
 * would undo each other's work, and the motor give more and more: one without a limit would have to take all of that back before it turned
 * the other way.
 */
function findStops({ joints: { records: r } }: SolverData, { constraint, at }: Joint): void {
  const motor = constraint as MotorConstraint;
  r[at + j.TURN_LOWER] = -Infinity;
  r[at + j.TURN_UPPER] = Infinity;
  for (const other of shorterList(motor.bodyA, motor.bodyB)) {
    if (other.type === 'ANGLE' && !other.isElastic && other.liveIndex >= 0 && other.owner === motor.owner) {
      const times = timesOf(motor, other as AngleConstraint);
      if (times !== 0) {
        const one = other.lower / times;
        const two = other.upper / times;
        r[at + j.TURN_LOWER] = Math.max(r[at + j.TURN_LOWER]!, Math.min(one, two));
        r[at + j.TURN_UPPER] = Math.min(r[at + j.TURN_UPPER]!, Math.max(one, two));
      }
    }
  }
}

/** The factor from the angle that a motor turns to that of an angle constraint; 0 if that is of something else. */
function timesOf({ bodyA, bodyB, ratio }: MotorConstraint, angle: AngleConstraint): number {
  if (angle.bodyA === bodyA && angle.bodyB === bodyB) {
    return angle.ratio === ratio ? 1 : 0;
  }
  return angle.bodyA === bodyB && angle.bodyB === bodyA && angle.ratio * ratio === 1 ? -angle.ratio : 0;
}

/** Starts a step. @returns whether one of the bodies is in contact. */
export function beginTurns(data: SolverData, start: number, end: number): boolean {
  const { records: r, joints, bodies, h } = data.joints;
  const { drive, velocity: v } = data;
  const scale = data.impulseScale;
  const carry = JOINT_MOMENTUM / h;
  let i = joints[start]!.at;
  let n = joints[start]!.first;
  let touched = 0;
  for (let k = start; k < end; k += 1, i = (i + j.TURN_STRIDE) & d.OFFSET, n = (n + 2) & d.OFFSET) {
    const a = bodies[n]! & d.OFFSET;
    const b = bodies[n + 1]! & d.OFFSET;
    touched |= drive[a + d.TOUCHED]! | drive[b + d.TOUCHED]!;
    const ratio = r[i + j.TURN_RATIO]!;
    const inverse = v[a + d.INV_INERTIA]! + ratio * ratio * v[b + d.INV_INERTIA]!;
    r[i + j.TURN_MASS] = inverse > MIN_INVERSE_MASS && inverse < Infinity ? 1 / inverse : 0;
    r[i + j.TURN_IMPULSE] = r[i + j.TURN_IMPULSE]! * scale;
    r[i + j.TURN_BEGAN] = r[i + j.TURN_IMPULSE]!;
    r[i + j.TURN_GIVEN_A] = 0;
    r[i + j.TURN_GIVEN_B] = 0;
    r[i + j.CARRY] = carry;
    if (!Number.isNaN(r[i + j.TURN_ANGLE]!)) {
      wind(data, i, a, b);
    }
  }
  return touched !== 0;
}

/** Ends a step: keeps the impulses for the next one. */
export function keepTurns(data: SolverData, start: number, end: number): void {
  const { records: r, joints } = data.joints;
  for (let k = start; k < end; k += 1) {
    const i = joints[k]!.at;
    r[i + j.TURN_IMPULSE] = remember(data, r[i + j.TURN_BEGAN]!, r[i + j.TURN_IMPULSE]!);
  }
}

/** Sets the bounds of a point that keeps an angle: of all angles that are whole turns apart, the nearest. */
function wind({ joints: { records: r }, pose: p }: SolverData, i: number, a: number, b: number): void {
  const angle = r[i + j.TURN_ANGLE]!;
  const value = r[i + j.TURN_STILL]! + p[b + ANGLE]! - p[a + ANGLE]!;
  const bound = angle + 2 * Math.PI * Math.round((value - angle) / (2 * Math.PI));
  r[i + j.TURN_LOWER] = bound;
  r[i + j.TURN_UPPER] = bound;
}

/** Starts a sub-step: finds the bias and the range of the impulse, and warm starts with the impulse of the last sub-step. */
export function warmStartTurns(data: SolverData, start: number, end: number): void {
  const { records: r, bodies, joints, h } = data.joints;
  const { velocity: v, pose: p } = data;
  let i = joints[start]!.at;
  let n = joints[start]!.first;
  for (let k = start; k < end; k += 1, i = (i + j.TURN_STRIDE) & d.OFFSET, n = (n + 2) & d.OFFSET) {
    const a = bodies[n]! & d.OFFSET;
    const b = bodies[n + 1]! & d.OFFSET;
    const ratio = r[i + j.TURN_RATIO]!;
    r[i + j.TURN_VALUE] = r[i + j.TURN_STILL]! + ratio * p[b + ANGLE]! - p[a + ANGLE]!;
    r[i + j.TURN_PUSH] = 0;
    if (r[i + j.TURN_BOUNDED] !== 0) {
      aimAtBound(data, k, i);
    } else {
      aimAtRate(r, i, h);
      noteLag(data, i, j.TURN_IMPULSE, ratio * v[b + d.W]! - v[a + d.W]! + r[i + j.TURN_BIAS]!, r[i + j.TURN_MASS]!);
    }
    const lambda = r[i + j.TURN_IMPULSE]!;
    v[a + d.W] = v[a + d.W]! - v[a + d.INV_INERTIA]! * lambda;
    v[b + d.W] = v[b + d.W]! + v[b + d.INV_INERTIA]! * lambda * ratio;
  }
}

/**
 * Aims at the nearer bound. Within it, the impulse may only keep it from being passed in the sub-step; beyond it, only push back, unless
 * both bounds are equal. A spring does nothing within, and beyond asks for the speed that brings it back.
 */
function aimAtBound({ joints: data }: SolverData, index: number, i: number): void {
  const { records: r, worst, asked, off, h } = data;
  const lower = r[i + j.TURN_LOWER]!;
  const upper = r[i + j.TURN_UPPER]!;
  const over = r[i + j.TURN_VALUE]! - upper;
  const under = r[i + j.TURN_VALUE]! - lower;
  const isUpper = -over <= under;
  const distance = isUpper ? over : under;
  const isBeyond = isUpper ? over > 0 : under < 0;
  const isStiff = r[i + j.PUSH] !== 0;
  const acts = (isBeyond || isStiff) && Math.abs(distance) < Infinity;
  const error = isBeyond ? distance : 0;
  r[i + j.TURN_LOW] = lower === upper || (acts && isUpper) ? -Infinity : 0;
  r[i + j.TURN_HIGH] = lower === upper || (acts && !isUpper) ? Infinity : 0;
  if (isStiff) {
    const rests = Math.abs(distance) < BOUND_SLOP && r[i + j.TURN_IMPULSE] !== 0;
    r[i + j.TURN_BIAS] = acts && !isBeyond && !rests ? distance / h : 0;
  } else {
    const speed = error * r[i + j.RATE]!;
    const most = r[i + j.MAX_BIAS]!;
    r[i + j.TURN_BIAS] = speed > most ? most : speed < -most ? -most : speed;
  }
  const square = error * error;
  if (isStiff && square > worst[0]!) {
    worst[0] = square;
  }
  if (isStiff && square > asked[0]!) {
    off[0] = index < off[0]! ? index : off[0]!;
    off[1] = index + 1;
  }
}

/** Writes the bias of a motor: its rate, but no further in this sub-step than to its stop. */
function aimAtRate(r: Float64Array, i: number, h: number): void {
  const rate = r[i + j.TURN_RATE]!;
  const way = r[i + (rate > 0 ? j.TURN_UPPER : j.TURN_LOWER)]! - r[i + j.TURN_VALUE]!;
  const most = way * rate > 0 ? Math.abs(way / h) : 0;
  r[i + j.TURN_BIAS] = Math.abs(rate) <= most ? -rate : -Math.sign(rate) * most;
}

/** One velocity sweep, from the first to the last, or back: λ → clamp(λ − (J·v + bias) · softness / K − feedback · λ). */
export function solveVelocityTurns(data: SolverData, start: number, end: number, isBack: boolean): void {
  const { records: r, bodies, joints } = data.joints;
  const { velocity: v } = data;
  const step = isBack ? -1 : 1;
  let k = isBack ? end - 1 : start;
  let i = joints[k]!.at;
  let n = joints[k]!.first;
  for (; k >= start && k < end; k += step, i = (i + step * j.TURN_STRIDE) & d.OFFSET, n = (n + 2 * step) & d.OFFSET) {
    const a = bodies[n]! & d.OFFSET;
    const b = bodies[n + 1]! & d.OFFSET;
    const ratio = r[i + j.TURN_RATIO]!;
    const wA = v[a + d.W]!;
    const wB = v[b + d.W]!;
    const c = ratio * wB - wA + r[i + j.TURN_BIAS]!;
    const old = r[i + j.TURN_IMPULSE]!;
    const least = r[i + j.TURN_LOW]!;
    const most = r[i + j.TURN_HIGH]!;
    const limit = r[i + j.LIMIT]!;
    let next = old - r[i + j.SOFTNESS]! * r[i + j.TURN_MASS]! * c - r[i + j.FEEDBACK]! * old;
    next = next < least ? least : next > most ? most : next;
    next = next > limit ? limit : next < -limit ? -limit : next;
    const lambda = next - old;
    r[i + j.TURN_IMPULSE] = next;
    v[a + d.W] = wA - v[a + d.INV_INERTIA]! * lambda;
    v[b + d.W] = wB + v[b + d.INV_INERTIA]! * lambda * ratio;
  }
}

/** One position sweep, from the first to the last, or back. @returns whether an error was worth another iteration. */
export function pushTurns(data: SolverData, start: number, end: number, isBack: boolean): boolean {
  const { records: r, bodies, joints } = data.joints;
  const { motion: q } = data;
  const step = isBack ? -1 : 1;
  let k = isBack ? end - 1 : start;
  let i = joints[k]!.at;
  let n = joints[k]!.first;
  let found = false;
  for (; k >= start && k < end; k += step, i = (i + step * j.TURN_STRIDE) & d.OFFSET, n = (n + 2 * step) & d.OFFSET) {
    if (r[i + j.PUSH] === 0) {
      continue;
    }
    const a = bodies[n]! & d.OFFSET;
    const b = bodies[n + 1]! & d.OFFSET;
    const ratio = r[i + j.TURN_RATIO]!;
    const wA = q[a + d.QW]!;
    const wB = q[b + d.QW]!;
    const value = r[i + j.TURN_VALUE]! + ratio * wB - wA;
    const over = value - r[i + j.TURN_UPPER]!;
    const under = value - r[i + j.TURN_LOWER]!;
    const old = r[i + j.TURN_PUSH]!;
    if (over > JOINT_TOLERANCE || under < -JOINT_TOLERANCE) {
      found = true;
    }
    // The total corrections that lead to either bound. If neither has to push, there is nothing to correct, and what was is taken back.
    const inverse = r[i + j.TURN_MASS]!;
    const down = old - inverse * over;
    const up = old - inverse * under;
    const next = down < 0 ? down : up > 0 ? up : 0;
    const lambda = next - old;
    r[i + j.TURN_PUSH] = next;
    q[a + d.QW] = wA - q[a + d.INV_INERTIA]! * lambda;
    q[b + d.QW] = wB + q[b + d.INV_INERTIA]! * lambda * ratio;
  }
  return found;
}

/** Writes to `left` how far beyond a bound the worst of them is now, rad. */
export function measureTurns({ joints: data, motion: q }: SolverData, start: number, end: number): void {
  const { records: r, bodies, joints, left } = data;
  let i = joints[start]!.at;
  let n = joints[start]!.first;
  let most = 0;
  for (let k = start; k < end; k += 1, i = (i + j.TURN_STRIDE) & d.OFFSET, n = (n + 2) & d.OFFSET) {
    const turned = r[i + j.TURN_RATIO]! * q[(bodies[n + 1]! & d.OFFSET) + d.QW]! - q[(bodies[n]! & d.OFFSET) + d.QW]!;
    const value = r[i + j.TURN_VALUE]! + turned;
    const over = r[i + j.PUSH]! * (value - r[i + j.TURN_UPPER]!);
    const under = r[i + j.PUSH]! * (r[i + j.TURN_LOWER]! - value);
    most = over > most ? over : most;
    most = under > most ? under : most;
  }
  left[0] = most;
}

/** Ends a sub-step: makes momentum of a share of the corrections, and adds up what the joints gave. */
export function finishTurns(data: SolverData, start: number, end: number): void {
  const { records: r, bodies, joints, share } = data.joints;
  const { velocity: v } = data;
  let i = joints[start]!.at;
  let n = joints[start]!.first;
  for (let k = start; k < end; k += 1, i = (i + j.TURN_STRIDE) & d.OFFSET, n = (n + 2) & d.OFFSET) {
    const a = bodies[n]! & d.OFFSET;
    const b = bodies[n + 1]! & d.OFFSET;
    const ratio = r[i + j.TURN_RATIO]!;
    const pushed = share[0]! * r[i + j.CARRY]! * r[i + j.TURN_PUSH]!;
    const lambda = r[i + j.TURN_IMPULSE]! + pushed;
    v[a + d.W] = v[a + d.W]! - v[a + d.INV_INERTIA]! * pushed;
    v[b + d.W] = v[b + d.W]! + v[b + d.INV_INERTIA]! * pushed * ratio;
    r[i + j.TURN_GIVEN_A] = r[i + j.TURN_GIVEN_A]! - lambda;
    r[i + j.TURN_GIVEN_B] = r[i + j.TURN_GIVEN_B]! + lambda * ratio;
  }
}
