import type { RigidBody } from '../../body.js';
import type { Constraint } from '../../constraint/constraint.js';
import { recordAt, type SolverData } from '../data.js';
import { BODY_STRIDE, MEMBER, VX, VY, W } from '../layout.js';
import type { Group, Joint } from './joint-data.js';
import {
  CARRY,
  IMPULSE_X,
  KEPT_IMPULSE_X,
  LIMIT,
  POINT,
  POINT_CARRY,
  POINT_SNAPS,
  POINT_STRIDE,
  PUSH_X,
  SNAPS,
  TURN,
  TURN_BEGAN,
  TURN_IMPULSE,
} from './joint-layout.js';

// Where the numbers of a joint are within a step, whatever kernel it has.

export function numbersOf({ joints, points }: SolverData, { kernel }: Joint): Float64Array {
  return kernel === POINT ? points : joints.records;
}

/** Where its record begins in that array. */
function recordOf({ kernel, at, slot }: Joint): number {
  return kernel === POINT ? recordAt(slot, POINT_STRIDE) : at;
}

/** The index there of the impulse of one of its rows. */
export function impulseAt(joint: Joint, row: number): number {
  const { kernel, layout } = joint;
  return recordOf(joint) + (kernel === POINT ? IMPULSE_X + 2 * row : layout.impulse + row);
}

/** The index of what position sweeps have corrected of a row in this sub-step. */
export function pushAt(joint: Joint, row: number): number {
  const { kernel, layout } = joint;
  return recordOf(joint) + (kernel === POINT ? PUSH_X + 2 * row : layout.push + row);
}

export function carryAt(joint: Joint): number {
  return recordOf(joint) + (joint.kernel === POINT ? POINT_CARRY : CARRY);
}

/** The shorter of two bodies' lists of constraints: those between them are in both. */
export function shorterList(a: RigidBody, b: RigidBody): readonly Constraint[] {
  return a.constraints.length < b.constraints.length ? a.constraints : b.constraints;
}

/** How many of its rows act all the time. The last one does not if its bounds are apart. */
export function heldRows({ dimension, bounded, lower, upper, keepsAngle }: Constraint): number {
  return keepsAngle ? 1 : dimension - (bounded && lower < upper ? 1 : 0);
}

/** In this step, corrections of the joint make no momentum. With `snaps` = 1, large ones do not turn its bodies either. */
export function steady(data: SolverData, joint: Joint, snaps: number): void {
  const numbers = numbersOf(data, joint);
  numbers[carryAt(joint)] = 0;
  numbers[recordOf(joint) + (joint.kernel === POINT ? POINT_SNAPS : SNAPS)] = snaps;
}

/** Scales the impulse of a joint, for the next sub-step, by `share`. */
export function forgetImpulse(data: SolverData, joint: Joint, share: number): void {
  const numbers = numbersOf(data, joint);
  for (let row = 0; row < joint.layout.rows; row += 1) {
    const n = impulseAt(joint, row);
    // With 0 it is set, not multiplied, so that numbers that are not finite go, too.
    numbers[n] = share === 0 ? 0 : numbers[n]! * share;
  }
}

/** Resets the impulse of a joint to that with which the step began. Springs and motors keep theirs. */
export function startAgain(data: SolverData, joint: Joint): void {
  const { kernel, at, layout, constraint } = joint;
  const { records } = data.joints;
  if (constraint.isElastic || constraint.drives) {
    return;
  }
  if (kernel === TURN) {
    records[at + TURN_IMPULSE] = records[at + TURN_BEGAN]!;
    return;
  }
  const numbers = numbersOf(data, joint);
  for (let row = 0; row < layout.rows; row += 1) {
    const before = kernel === POINT ? records[at + KEPT_IMPULSE_X + row]! : constraint.impulse[row]!;
    numbers[impulseAt(joint, row)] = before * data.impulseScale;
  }
}

/** Lists the bodies of a group that have a slot, those that are awake and move, in the order of its joints. */
export function listBodies(data: SolverData, group: Group): void {
  const { joints, bodies } = data.joints;
  const { first, layout } = joints[group.end - 1]!;
  group.bodies.clear();
  group.isAnchored = false;
  for (let n = joints[group.start]!.first; n < first + layout.members; n += 1) {
    if (bodies[n] === 0) {
      group.isAnchored = true;
    } else if (visit(data, bodies[n]!)) {
      group.bodies.add(bodies[n]!);
    }
  }
  markBodies(data, group, 0);
}

/** Clears MEMBER in the traits of all bodies of a group, then sets `mark`; with 0, nothing. */
export function markBodies({ traits }: SolverData, { bodies }: Group, mark: number): void {
  for (let n = 0; n < bodies.count; n += 1) {
    const slot = bodies.items[n]! / BODY_STRIDE;
    traits[slot] = (traits[slot]! & ~MEMBER) | mark;
  }
}

/** Whether a body, given by the offset of its record, moves or turns. */
export function isMoving({ velocity: v }: SolverData, body: number): boolean {
  return v[body + VX] !== 0 || v[body + VY] !== 0 || v[body + W] !== 0;
}

/** Sets MEMBER in the traits of a body, given by the offset of its record. @returns whether it did not have that yet. */
export function visit({ traits }: SolverData, offset: number): boolean {
  const slot = offset / BODY_STRIDE;
  const isFirst = (traits[slot]! & MEMBER) === 0;
  traits[slot] = traits[slot]! | MEMBER;
  return isFirst;
}

/**
 * Raises `lag` to the speed by which a motor misses its rate, if it gives less than it may, and would still if it made up for that by
 * itself: a weak motor that only brakes need not be swept for what it cannot give. Its impulse is at the offset `impulse` of its record;
 * `mass` is the effective mass that it turns.
 */
export function noteLag(
  { joints: { records: r, lag } }: SolverData,
  i: number,
  impulse: number,
  speed: number,
  mass: number,
): void {
  const miss = Math.abs(speed);
  if (miss > lag[0]! && Math.abs(r[i + impulse]!) < r[i + LIMIT]! && mass * miss < r[i + LIMIT]!) {
    lag[0] = miss;
  }
}
