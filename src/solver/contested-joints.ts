import type { RigidBody } from '../body.js';
import { DYNAMIC } from '../body-kind.js';
import { CLOSING_ROUNDS, CONTESTED_KEEP, JOINT_CONTESTED, JOINT_OPEN } from '../config.js';
import type { Constraint } from '../constraint/constraint.js';
import { isOpenBlock, lineariseBlock, noteBlock, pushBlock } from './block-joints.js';
import type { SolverData } from './data.js';
import { type Group, impulseOf, type Joint, steady } from './joint-data.js';
import { CUSTOM, POINT, TURN } from './joint-layout.js';
import { isOpenPoint, notePoints, pushPoints } from './point-joints.js';
import { isOpenTurn, noteTurns, pushTurns } from './turn-joints.js';

/**
 * Where joints and contacts want different things. Contacts push without momentum, so joints that correct what they did must make none either; and as
 * contacts are solved last in a position iteration, they would keep a joint open for ever that has something on its wrong side.
 */

/** Of joints in contact: notes their errors and, after contacts were solved, what these made of them. */
export function noteErrors(data: SolverData, group: Group, isAfterContacts: boolean): void {
  const { joints, isTouched, worst } = data.joints;
  if (!isTouched) {
    return;
  }
  worst[2] = 0;
  for (let i = 0; i < group.runs.length; i += 1) {
    const { kernel, start, end } = group.runs[i]!;
    if (kernel === POINT) {
      notePoints(data, start, end, isAfterContacts);
    } else if (kernel === TURN) {
      noteTurns(data, start, end, isAfterContacts);
    } else {
      for (let k = start; k < end; k += 1) {
        noteBlock(data, joints[k]!, isAfterContacts);
      }
    }
  }
  group.left = worst[2];
}

/**
 * Joints next to one that corrects what contacts did see only that it moved a body, and would make momentum of that: where contacts undo much, none
 * of the joints that hang together makes any until all errors are small. If they do not become small the joints also forget a part of their
 * impulses, which would grow without end. Else a chain that is pulled against a wall is thrown about with thousands of metres per second.
 */
export function dropMomentum(data: SolverData, group: Group): void {
  const { joints, records, worst } = data.joints;
  worst[0] = 0;
  noteErrors(data, group, true);
  const isContested = worst[0] > JOINT_CONTESTED * JOINT_CONTESTED;
  if (isContested || group.contested) {
    data.joints.isTouched = true;
    for (let k = group.start; k < group.end; k += 1) {
      steady(joints[k]!, records, 1);
    }
    noteErrors(data, group, false);
  }
  group.contested = isContested || (group.contested && isOpen(group));
}

/** An error was large when the sub-step began. */
function isOpen({ error }: Group): boolean {
  return error > JOINT_OPEN * JOINT_OPEN;
}

/** All but a share of what a joint gave is forgotten by the next sub-step. */
function forgetPart(joint: Joint, records: Float64Array): void {
  const from = impulseOf(joint);
  for (let n = from; n < from + joint.layout.rows; n += 1) {
    records[n] = records[n]! * CONTESTED_KEEP;
  }
}

/** Ends a sub-step, when what joints gave has been added up: those that contacts hold open have the last word. */
export function closeOpen(data: SolverData, group: Group): void {
  const { joints, records } = data.joints;
  if (group.contested && isOpen(group)) {
    for (let k = group.start; k < group.end; k += 1) {
      forgetPart(joints[k]!, records);
    }
  }
  for (let round = 0; round < CLOSING_ROUNDS && group.contested && closeOnce(data, group); round += 1) {
    noteErrors(data, group, true);
  }
}

/** @returns whether there was something to close. */
function closeOnce(data: SolverData, { start, end, left }: Group): boolean {
  const { joints } = data.joints;
  let found = false;
  for (let k = start; k < end && left > JOINT_OPEN * JOINT_OPEN; k += 1) {
    const joint = joints[k]!;
    if (!isToClose(data, joint)) {
      continue;
    }
    found = true;
    if (joint.kernel === POINT) {
      pushPoints(data, k, k + 1);
    } else if (joint.kernel === TURN) {
      pushTurns(data, k, k + 1);
    } else {
      lineariseBlock(data, joint);
      pushBlock(data, joint);
    }
  }
  return found;
}

/**
 * Far from being met as of the last note. Joints with something immovable are left as they are, as these would drag bodies through a wall at once, and so
 * are those whose own bodies lie in each other's way.
 */
function isToClose({ joints: { records } }: SolverData, joint: Joint): boolean {
  return isFar(records, joint) && joint.constraint.members.every(canBeMoved) && !hasContact(joint.constraint);
}

function isFar(r: Float64Array, joint: Joint): boolean {
  const { kernel } = joint;
  if (kernel === POINT) {
    return isOpenPoint(r, joint.at);
  }
  return kernel === TURN ? isOpenTurn(r, joint.at) : kernel !== CUSTOM && isOpenBlock(r, joint);
}

function canBeMoved(body: RigidBody): boolean {
  body.refreshMass();
  return body.kind === DYNAMIC && body.mass > 0 && body.mass < Infinity;
}

/** Between its own bodies; the last one has none with itself. */
function hasContact({ members }: Constraint): boolean {
  for (let i = 0; i + 1 < members.length; i += 1) {
    const { shapes } = members[i]!;
    for (let k = 0; k < shapes.length; k += 1) {
      const { arbiters } = shapes[k]!;
      for (let n = 0; n < arbiters.length; n += 1) {
        const pair = arbiters[n]!;
        if (pair.isSolved() && members.includes(pair.shapeA.owner!) && members.includes(pair.shapeB.owner!)) {
          return true;
        }
      }
    }
  }
  return false;
}
