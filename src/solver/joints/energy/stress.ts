import type { RigidBody } from '../../../body.js';
import { DYNAMIC } from '../../../body-kind.js';
import { FEW_JOINTS, STRESS_FADES, STRESS_SLOW, STRESS_STILL } from '../../../config-joints.js';
import type { Constraint } from '../../../constraint/constraint.js';
import { holdsBoth } from '../../../constraint/point.js';
import type { World } from '../../../world.js';
import type { SolverData } from '../../data.js';
import * as d from '../../layout.js';
import type { Group, Joint } from '../joint-data.js';
import { POINT } from '../joint-layout.js';
import { heldRows, impulseAt, markBodies, shorterList, visit } from '../joint-numbers.js';
import { turnPoints } from '../kernels/points.js';

// Where there are more welds or points than it takes to hold bodies together, as in frames, wheels and nets, and between two bodies that
// are hinged twice, joints may pull against each other. That moves nothing, so no sweep sees such a stress, and it stays. As the bodies
// turn, the impulses would go on pulling the old way, and that would be corrected by more stress, until the whole stops turning, or tears
// itself apart. So the impulses are turned with the bodies, and fade as these turn.

/**
 * Finds whether a group has more rigid joints than are needed: they have more rows than their bodies have degrees of freedom, or those
 * between two bodies do. Then they may pull against each other. Points alone may with as many rows, too: a net of 3 × 3 folds all the same.
 */
export function lookAtStress(data: SolverData, group: Group): void {
  const { joints, bodies } = data.joints;
  let rows = 0;
  let movers = 0;
  let isHeld = false;
  let hasWelds = false;
  let onlyWelds = true;
  let anchors = 0;
  for (let k = group.start; k < group.end; k += 1) {
    const joint = joints[k]!;
    const { constraint, first, layout } = joint;
    const isWeld = constraint.type === 'WELD';
    joint.turns = isRigid(constraint) && isFixed(constraint);
    if (isRigid(constraint)) {
      rows += heldRows(constraint);
      hasWelds ||= isWeld;
    }
    onlyWelds &&= isWeld;
    for (let n = 0; n < layout.members; n += 1) {
      const body = bodies[first + n]!;
      const moves = body > 0 && constraint.members[n]!.kind === DYNAMIC;
      movers += moves && visit(data, body) ? 1 : 0;
      isHeld ||= !moves;
      anchors += !moves && holdsPlace(constraint) ? 1 : 0;
    }
  }
  markBodies(data, group, 0);
  group.isHeldTwice = anchors > 1;
  const most = 3 * (movers - (isHeld ? 0 : 1));
  group.isWhole = onlyWelds && rows >= most;
  group.isIndeterminate = rows > most || hasOverheldPair(data, group);
  group.isMixed = group.isIndeterminate && group.runs.some(({ kernel }) => kernel !== group.runs[0]!.kernel);
  group.isOverheld = group.isIndeterminate || (rows === most && !hasWelds);
}

function hasOverheldPair({ joints: { joints } }: SolverData, { start, end }: Group): boolean {
  for (let k = start; k < end; k += 1) {
    const { members, owner } = joints[k]!.constraint;
    if (members.length === 2 && rowsBetween(members[0]!, members[1]!, owner) > 3) return true;
  }
  return false;
}

/** How many rows of rigid joints that act in a world hold two bodies together. */
function rowsBetween(a: RigidBody, b: RigidBody, world: World | null): number {
  const constraints = shorterList(a, b);
  let rows = 0;
  for (let i = 0; i < constraints.length; i += 1) {
    const constraint = constraints[i]!;
    const { members, liveIndex, owner } = constraint;
    if (
      members.length === 2 &&
      holdsBoth(constraint, a, b) &&
      owner === world &&
      liveIndex >= 0 &&
      isRigid(constraint)
    ) {
      rows += heldRows(constraint);
    }
  }
  return rows;
}

function holdsPlace({ positional, isElastic, type }: Constraint): boolean {
  return positional && !isElastic && type !== 'ANGLE';
}

function isRigid({ isElastic, drives }: Constraint): boolean {
  return !isElastic && !drives;
}

/**
 * Ends a sub-step: turns the impulses of welds and points of a group as their bodies turned in it, and lets all of them fade alike. Where
 * bars are pinned twice, so that one of the pins keeps their angle, frames would lose all their spin if that did not fade. Refused: turning
 * by the velocities, which corrections have a part in: a truss of bars that is at rest would turn the impulses to and fro, and correct what
 * that makes, for ever.
 */
export function turnStress(data: SolverData, group: Group): void {
  if (!isTurning(data, group)) {
    return;
  }
  const { joints } = data.joints;
  for (let i = 0; i < group.runs.length; i += 1) {
    const { kernel, start, end } = group.runs[i]!;
    if (kernel === POINT) turnPoints(data, start, end);
    for (let k = start; k < end && kernel !== POINT; k += 1) {
      if (joints[k]!.turns) turnImpulse(data, joints[k]!);
    }
  }
}

/** Whether a joint holds the same relation of its bodies however they turn together; gears do not. */
function isFixed(constraint: Constraint): boolean {
  const { type, lower, upper } = constraint;
  const isOfOneValue = lower === upper && (type === 'DISTANCE' || (type === 'ANGLE' && constraint.ratio === 1));
  return type === 'WELD' || type === 'POINT' || isOfOneValue;
}

/** Whether some body of a group turned so much that it matters. */
function isTurning(data: SolverData, group: Group): boolean {
  const { motion: q, joints } = data;
  const { bodies } = group;
  const least = group.end - group.start > FEW_JOINTS ? STRESS_SLOW * joints.h : STRESS_STILL;
  for (let n = 0; n < bodies.count; n += 1) {
    if (Math.abs(q[bodies.items[n]! + d.QW]!) > least) return true;
  }
  return false;
}

/** Turns the impulse of a joint by the mean turn of its bodies. The sine of the angle need not be exact for this. */
function turnImpulse(data: SolverData, joint: Joint): void {
  const { motion: q, joints } = data;
  const { bodies, records: r } = joints;
  const { first, layout } = joint;
  const half = 0.25 * (q[bodies[first]! + d.QW]! + q[bodies[first + 1]! + d.QW]!);
  const kept = 1 - STRESS_FADES * Math.min(1, 2 * Math.abs(half));
  if (layout.rows !== 2) {
    const last = impulseAt(joint, layout.rows - 1);
    r[last] = kept * r[last]!;
  }
  if (layout.rows === 1) return;
  const share = kept / (1 + half * half);
  const c = share * (1 - half * half);
  const s = share * 2 * half;
  const atX = impulseAt(joint, 0);
  const atY = impulseAt(joint, 1);
  const x = r[atX]!;
  const y = r[atY]!;
  r[atX] = c * x - s * y;
  r[atY] = s * x + c * y;
}
