import { STRAIN_SPEED } from '../../../config.js';
import {
  ALONE_ERROR,
  FIRM_FEET,
  FIRM_FEW,
  FRAME_BENT,
  FRAME_JOINTS,
  JOINT_OPEN,
  ROPE_JOINTS,
  TOUCHED_MOMENTUM,
  TOUCHED_QUIET,
} from '../../../config-joints.js';
import type { SolverData } from '../../data.js';
import { INV_MASS, TOUCHED } from '../../layout.js';
import type { Group, Joint } from '../joint-data.js';
import { CUSTOM, TURN } from '../joint-layout.js';
import { carryAt, impulseAt, numbersOf, steady } from '../joint-numbers.js';
import { ALIKE, HEAVIER, ITSELF, isBlocked, OTHERS } from './neighbours.js';

// How much momentum the corrections of joints make where something is touched.

/**
 * Sets how much momentum corrections make in a group that touches something; also finds whether it stands on that. Contacts push without
 * momentum, so such a group makes none either: it would be made of what contacts undo again and again. Heaps of ragdolls would tremble for
 * ever; and if only the joints of bodies that touch something made none, those next to them would make it.
 *
 * Three kinds of joints still make most of theirs, see TOUCHED_MOMENTUM: those that hold an angle, and those that bear much under a weight,
 * both unless the group overlaps itself; and those of ropes that bear something heavy, and lie on nothing that is as light as they are.
 * Joints that hold an angle lose it again while they are few and solved together with their contacts, see `isBent`; and where they are
 * pulled into what is in their way, see `isPulledIn`.
 *
 * If errors are as small as those of what swings freely, contacts undo nothing: then joints with a body that touches nothing make all of
 * theirs. So do all joints of a group that touches nothing but itself, such as welded blocks and coiled chains.
 */
export function steadyTouched(data: SolverData, group: Group): void {
  const { neighbours, errorSquare } = group;
  const isAlone = neighbours === 0 && errorSquare < ALONE_ERROR * ALONE_ERROR;
  const isBeam = (neighbours & (OTHERS | ITSELF)) === OTHERS && !isPulledIn(group);
  group.isBent = isBeam && errorSquare > FRAME_BENT * FRAME_BENT && isFrame(data, group);
  group.stands = group.isMechanism && !isAlone && (neighbours & ITSELF) === 0 && countTouched(data, group) <= FIRM_FEET;
  if (!isAlone) {
    const isRope = group.burdened && group.end - group.start >= ROPE_JOINTS;
    const isTaut = isRope && (neighbours & (ITSELF | ALIKE)) === 0;
    const isPressed = (neighbours & (HEAVIER | ITSELF)) === HEAVIER;
    steadyJoints(data, group, isTaut, isBeam, isPressed);
  }
}

/**
 * Whether something that does not move, or moves on, pulls a group into what is in its way. As contacts undo all of the corrections then,
 * no angle may make momentum of them: a box on a weld of a hand that went on into a wall stood, and had 19 m/s. What contacts hold open by
 * less than JOINT_OPEN makes some, as beams do.
 */
function isPulledIn(group: Group): boolean {
  return group.anchors > 0 && group.errorSquare > JOINT_OPEN * JOINT_OPEN && isBlocked(group);
}

/** Lets all joints of a taut rope make most of their momentum; of a beam, those that hold an angle; under a weight, those that bear much. */
function steadyJoints(data: SolverData, group: Group, isTaut: boolean, isBeam: boolean, isPressed: boolean): void {
  const { joints } = data.joints;
  for (let k = group.start; k < group.end; k += 1) {
    const joint = joints[k]!;
    if (isQuiet(group) && reachesOut(data, joint)) {
      continue;
    }
    if (isTaut || (isBeam && holdsAngle(data, joint)) || (isPressed && bearsMuch(data, joint))) {
      const numbers = numbersOf(data, joint);
      const carry = carryAt(joint);
      numbers[carry] = numbers[carry]! * TOUCHED_MOMENTUM;
    } else {
      steady(data, joint, 0);
    }
  }
}

/** After a frame was solved with its contacts: its joints that hold an angle need no momentum, but for those of what swings. */
export function steadyFrame(data: SolverData, group: Group): void {
  for (let k = group.start; k < group.end; k += 1) {
    const joint = data.joints.joints[k]!;
    if (holdsAngle(data, joint) && !(isQuiet(group) && reachesOut(data, joint))) steady(data, joint, 0);
  }
}

/** Whether errors are as small as those of what swings freely. */
function isQuiet({ errorSquare }: Group): boolean {
  return errorSquare <= TOUCHED_QUIET * TOUCHED_QUIET;
}

/** Whether one of the bodies of a joint can move and is in no contact. */
function reachesOut({ drive, joints: { bodies } }: SolverData, { first, layout }: Joint): boolean {
  for (let n = first; n < first + layout.members; n += 1) {
    const i = bodies[n]!;
    if (i > 0 && drive[i + TOUCHED] === 0) {
      return true;
    }
  }
  return false;
}

type Test = (data: SolverData, joint: Joint) => boolean;

function hasSome(data: SolverData, { start, end }: Group, test: Test): boolean {
  const { joints } = data.joints;
  for (let k = start; k < end; k += 1) {
    if (test(data, joints[k]!)) {
      return true;
    }
  }
  return false;
}

/** Whether a joint keeps its bodies at one angle to each other: many bodies with such joints bend and bear like a beam. */
function holdsAngle(_data: SolverData, { constraint }: Joint): boolean {
  return (
    constraint.type === 'WELD' ||
    constraint.keepsAngle ||
    (constraint.type === 'ANGLE' && constraint.lower === constraint.upper)
  );
}

function isAngle(_data: SolverData, { constraint }: Joint): boolean {
  return constraint.type === 'ANGLE';
}

function breaks(_data: SolverData, { constraint }: Joint): boolean {
  return constraint.breakUnderForce;
}

/**
 * Whether a group is like a hammer: few joints, some of them angles, and a heavy body, so that the handle stands on its limit as firmly as
 * on a weld.
 */
function isHammer(data: SolverData, group: Group): boolean {
  return group.burdened && group.end - group.start <= FIRM_FEW && hasSome(data, group, isAngle);
}

/**
 * Whether a group is a frame: few and rigid joints, some of which hold an angle, and none of which may break, as sweeps that try out
 * impulses would break them. Where a body is far heavier than another, very few joints may limit an angle instead. More, as in cranes and
 * chains, would take ten times as long, and some would come to rest later.
 */
function isFrame(data: SolverData, group: Group): boolean {
  return (
    group.frequency === 0 &&
    group.end - group.start <= FRAME_JOINTS &&
    (hasSome(data, group, holdsAngle) || isHammer(data, group)) &&
    !hasSome(data, group, breaks)
  );
}

/**
 * Whether a joint bears as much as a contact that is strained: about a hundred times the weight of its bodies. Joints that only turn bear
 * nothing.
 */
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
  const ease = v[bodies[first]! + INV_MASS]! + v[bodies[first + 1]! + INV_MASS]!;
  return kernel !== TURN && kernel !== CUSTOM && square * ease * ease > STRAIN_SPEED * STRAIN_SPEED;
}

/** Counts the bodies of a group that are in contact. */
function countTouched({ drive }: SolverData, { bodies }: Group): number {
  let count = 0;
  for (let n = 0; n < bodies.count; n += 1) {
    count += drive[bodies.items[n]! + TOUCHED]!;
  }
  return count;
}
