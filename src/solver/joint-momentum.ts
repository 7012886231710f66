import type { RigidBody } from '../body.js';
import { DYNAMIC } from '../body-kind.js';
import { HEAVY, STRAIN_SPEED, TOUCHED_MOMENTUM } from '../config.js';
import type { SolverData } from './data.js';
import type { Group, Joint } from './joint-data.js';
import { CUSTOM, TURN } from './joint-layout.js';
import { carryAt, impulseAt, numbersOf, steady } from './joint-numbers.js';
import { INV_MASS } from './layout.js';

// What joints keep of the momentum of their corrections.

/**
 * Of a group that touches something. Contacts push without momentum: there joints make none of their corrections either, as it would be made of what contacts undo
 * again and again. Heaps of ragdolls would tremble for ever; and if only the joints of what touches made none, those next to them would. Those that hold an angle,
 * and those that bear much under a weight, still make the most of theirs, see TOUCHED_MOMENTUM.
 */
export function steadyTouched(data: SolverData, group: Group): void {
  const { joints } = data.joints;
  const isPressed = hasMuchToBear(data, group) && isUnderWeight(joints, group);
  for (let k = group.start; k < group.end; k += 1) {
    const joint = joints[k]!;
    if (holdsAngle(joint) || (isPressed && bearsMuch(data, joint))) {
      const numbers = numbersOf(data, joint);
      const carry = carryAt(joint);
      numbers[carry] = numbers[carry]! * TOUCHED_MOMENTUM;
    } else {
      steady(data, joint, 0);
    }
  }
}

function hasMuchToBear(data: SolverData, { start, end }: Group): boolean {
  for (let k = start; k < end; k += 1) {
    if (bearsMuch(data, data.joints.joints[k]!)) {
      return true;
    }
  }
  return false;
}

/** Whether it keeps its bodies at one angle to each other: what such joints make of many bodies bends and bears like a beam. */
function holdsAngle({ constraint }: Joint): boolean {
  return constraint.type === 'WELD' || (constraint.type === 'ANGLE' && constraint.lower === constraint.upper);
}

/** Whether it bears as much as a contact that is strained: about a hundred times what its bodies weigh. What turns bears nothing. */
function bearsMuch(data: SolverData, joint: Joint): boolean {
  const { kernel, first, layout } = joint;
  const { bodies } = data.joints;
  const v = data.velocity;
  const numbers = numbersOf(data, joint);
  let square = 0;
  for (let row = 0; row < layout.rows; row += 1) {
    const n = impulseAt(joint, row);
    square += numbers[n]! * numbers[n]!;
  }
  const mass = v[bodies[first]! + INV_MASS]! + v[bodies[first + 1]! + INV_MASS]!;
  return kernel !== TURN && kernel !== CUSTOM && square * mass * mass > STRAIN_SPEED * STRAIN_SPEED;
}

/** Whether something far heavier touches one of its bodies, and is none of them: a wrecking ball that its last link reaches into does not lie on that. */
export function isUnderWeight(joints: readonly Joint[], group: Group): boolean {
  for (let k = group.start; k < group.end; k += 1) {
    const { members } = joints[k]!.constraint;
    for (let n = 0; n < members.length; n += 1) {
      if (touchesHeavy(members[n]!, joints, group)) {
        return true;
      }
    }
  }
  return false;
}

function hasMember(joints: readonly Joint[], { start, end }: Group, body: RigidBody): boolean {
  for (let k = start; k < end; k += 1) {
    if (joints[k]!.constraint.members.includes(body)) {
      return true;
    }
  }
  return false;
}

function touchesHeavy({ shapes, kind, mass }: RigidBody, joints: readonly Joint[], group: Group): boolean {
  for (let i = 0; i < shapes.length && kind === DYNAMIC; i += 1) {
    const shape = shapes[i]!;
    for (let k = 0; k < shape.arbiters.length; k += 1) {
      const pair = shape.arbiters[k]!;
      const other = pair.shapeA === shape ? pair.bodyB : pair.bodyA;
      const isHeavy = pair.isSolved() && other.kind === DYNAMIC && other.mass > HEAVY * mass;
      if (isHeavy && !hasMember(joints, group, other)) {
        return true;
      }
    }
  }
  return false;
}
