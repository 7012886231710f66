import type { Constraint } from '../../constraint/constraint.js';
import { recordAt, type SolverData } from '../data.js';
import { BODY_STRIDE, MEMBER, SEEN } from '../layout.js';
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
  TURN_PUSH,
} from './joint-layout.js';

// Where the numbers of a joint are in a step, whatever kernel it has.

export function numbersOf({ joints, points }: SolverData, { kernel }: Joint): Float64Array {
  return kernel === POINT ? points : joints.records;
}

/** Of one of its rows. */
export function impulseAt({ kernel, at, slot, layout }: Joint, row: number): number {
  if (kernel === POINT) {
    return recordAt(slot, POINT_STRIDE) + IMPULSE_X + 2 * row;
  }
  return at + (kernel === TURN ? TURN_IMPULSE : layout.impulse) + row;
}

/** How many of its rows hold: the last one does not where its bounds lie apart. */
export function heldRows({ dimension, bounded, lower, upper, keepsAngle }: Constraint): number {
  return keepsAngle ? 1 : dimension - (bounded && lower < upper ? 1 : 0);
}

/** What position sweeps have corrected of it in this sub-step. */
export function pushAt({ kernel, at, slot, layout }: Joint, row: number): number {
  if (kernel === POINT) {
    return recordAt(slot, POINT_STRIDE) + PUSH_X + 2 * row;
  }
  return at + (kernel === TURN ? TURN_PUSH : layout.push) + row;
}

export function carryAt({ kernel, at, slot }: Joint): number {
  return kernel === POINT ? recordAt(slot, POINT_STRIDE) + POINT_CARRY : at + CARRY;
}

/** In this step corrections of the joint make no momentum; with `snaps` = 1 large ones do not turn its bodies either. */
export function steady(data: SolverData, joint: Joint, snaps: number): void {
  const numbers = numbersOf(data, joint);
  const { kernel, at, slot } = joint;
  numbers[carryAt(joint)] = 0;
  numbers[kernel === POINT ? recordAt(slot, POINT_STRIDE) + POINT_SNAPS : at + SNAPS] = snaps;
}

/** Leaves a share of what a joint gave for the next sub-step. */
export function forgetImpulse(data: SolverData, joint: Joint, share: number): void {
  const numbers = numbersOf(data, joint);
  for (let row = 0; row < joint.layout.rows; row += 1) {
    const n = impulseAt(joint, row);
    // What is not finite goes, too.
    numbers[n] = share === 0 ? 0 : numbers[n]! * share;
  }
}

/** Lets the next sub-step start with what the step started with. What is elastic or drives goes on. */
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

/** Lists the bodies of a group that have a slot, which are those that are awake and move: in the order of its joints. */
export function listBodies(data: SolverData, group: Group): void {
  const { joints, bodies } = data.joints;
  const { first, layout } = joints[group.end - 1]!;
  group.bodies.clear();
  group.isAnchored = false;
  for (let n = joints[group.start]!.first; n < first + layout.members; n += 1) {
    if (bodies[n] === 0) {
      group.isAnchored = true;
    } else if (visit(data, bodies[n]!, MEMBER)) {
      group.bodies.add(bodies[n]!);
    }
  }
  markBodies(data, group, 0);
}

/** Sets a mark in the slots of all bodies of a group, and clears MEMBER and SEEN unless it is one of them. */
export function markBodies({ traits }: SolverData, { bodies }: Group, mark: number): void {
  for (let n = 0; n < bodies.count; n += 1) {
    const slot = bodies.items[n]! / BODY_STRIDE;
    traits[slot] = (traits[slot]! & ~(MEMBER | SEEN)) | mark;
  }
}

/** Whether a body that has a slot comes for the first time: it is marked for that. */
export function visit({ traits }: SolverData, offset: number, mark: number): boolean {
  const slot = offset / BODY_STRIDE;
  const isFirst = (traits[slot]! & mark) === 0;
  traits[slot] = traits[slot]! | mark;
  return isFirst;
}

/**
 * By what speed a motor misses its rate, if it gives less than it may, and did so still if it closed that by itself: a weak one that only brakes need not be swept to what it cannot give. Its impulse is at that
 * offset of its record, `mass` what it turns.
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
