import { DYNAMIC } from '../../../body-kind.js';
import * as g from '../../../collide/layout.js';
import { findLeastSeparation, leastSeparation } from '../../../collide/manifold.js';
import { CLOSING_ROUNDS, INTO_WALL, JOINT_OPEN, JOINT_TORN, TORN_KEEP } from '../../../config-joints.js';
import type { Arbiter } from '../../../contact/arbiter.js';
import type { Shape } from '../../../shape/shape.js';
import { canMove, link, NONE } from '../../contacts/shocks.js';
import { batchOf, IMPULSES, recordAt, type SolverData } from '../../data.js';
import * as d from '../../layout.js';
import type { Group, Joint } from '../joint-data.js';
import { CUSTOM, POINT, TURN } from '../joint-layout.js';
import { forgetImpulse, markBodies } from '../joint-numbers.js';
import { lineariseBlock, measureBlock, pushBlock } from '../kernels/blocks.js';
import { measurePoints, pushPoints } from '../kernels/points.js';
import { measureTurns, pushTurns } from '../kernels/turns.js';
import { linkShocks } from './joint-shocks.js';
import { isJammed } from './neighbours.js';

/** Scratch: x, y and turn of a joint's members in the sub-step, before it is closed; pulleys have four members. */
const before = /* @__PURE__ */ new Float64Array(12);
/** Scratch: x and y by which a member was moved, and how much of that at least has to be into a wall. */
const way = /* @__PURE__ */ new Float64Array(3);

/**
 * Ends a sub-step, after impulses have been added up: groups that are torn forget part of these, and joints that contacts hold open are
 * closed. As contacts are solved last in a position iteration, they would keep a joint open for ever that has something on its wrong side.
 */
export function closeOpen(data: SolverData, group: Group): void {
  if (group.isTorn || (group.touched && group.errorSquare > JOINT_TORN * JOINT_TORN)) {
    forgetPart(data, group);
  }
  let rounds = 0;
  while (rounds < CLOSING_ROUNDS && group.touched && closeOnce(data, group)) {
    rounds += 1;
  }
}

/**
 * Scales the impulses of all joints of a group by TORN_KEEP, for the next sub-step; and those of its contacts, if something that goes on
 * draws it into what is in its way. If joints alone forgot some, they would make up for that in each sub-step, and both would grow without
 * end: a row of three crates that a hand had pressed against a wall for 10 s came off it at 20 m/s when that let go.
 */
function forgetPart(data: SolverData, group: Group): void {
  for (let k = group.start; k < group.end; k += 1) {
    forgetImpulse(data, data.joints.joints[k]!, TORN_KEEP);
  }
  if (isJammed(data, group)) forgetContacts(data, group);
}

/** Only where a body of the group can be moved: what else lies on the one that draws it keeps its impulses. */
function forgetContacts(data: SolverData, group: Group): void {
  const { shocks, traits } = data;
  link(data, linkShocks);
  const { first, next } = shocks;
  markBodies(data, group, d.MEMBER);
  for (let n = 0; n < group.bodies.count; n += 1) {
    const body = group.bodies.items[n]!;
    for (let end = canMove(data, body) ? first[body / d.BODY_STRIDE]! : NONE; end !== NONE; end = next[end]!) {
      const contact = end >> 1;
      const other = batchOf(data, contact).bodies[(contact & d.EVEN) + 1 - (end & 1)]! & d.OFFSET;
      const isMember = (traits[other / d.BODY_STRIDE]! & d.MEMBER) !== 0 && canMove(data, other);
      // A contact of two of them is found twice.
      if (!isMember || (end & 1) === 0) forgetContact(data, contact);
    }
  }
  markBodies(data, group, 0);
}

/** What is taken away was applied in this sub-step, and goes to the sums. */
function forgetContact(data: SolverData, contact: number): void {
  const { records: r, stride } = batchOf(data, contact);
  for (const impulse of IMPULSES) {
    const at = recordAt(contact >> 1, stride) + impulse;
    r[at + d.SUM] = r[at + d.SUM]! + (1 - TORN_KEEP) * r[at]!;
    r[at] = TORN_KEEP * r[at]!;
  }
}

/** Closes the open joints of a group once. @returns whether there were any. */
function closeOnce(data: SolverData, { runs }: Group): boolean {
  const { joints, left } = data.joints;
  let found = false;
  for (let i = 0; i < runs.length; i += 1) {
    const { kernel, start, end } = runs[i]!;
    measure(data, kernel, start, end);
    const isOpen = left[0]! > JOINT_OPEN;
    for (let k = start; k < end && isOpen; k += 1) {
      measure(data, kernel, k, k + 1);
      if (left[0]! > JOINT_OPEN && mayClose(data, joints[k]!)) {
        found = true;
        closePart(data, k);
      }
    }
  }
  return found;
}

/** Writes to `left` the largest error in a part of a run; 0 for custom constraints. */
function measure(data: SolverData, kernel: number, start: number, end: number): void {
  if (kernel === POINT) {
    measurePoints(data, start, end);
  } else if (kernel === TURN) {
    measureTurns(data, start, end);
  } else {
    data.joints.left[0] = 0;
    for (let k = start; k < end && kernel !== CUSTOM; k += 1) {
      measureBlock(data, data.joints.joints[k]!);
    }
  }
}

/**
 * Corrects only the part of the error beyond JOINT_OPEN: else a joint at that limit would be closed in one sub-step and opened in the next.
 */
function closePart(data: SolverData, index: number): void {
  const { joints, bodies, left } = data.joints;
  const { motion: q } = data;
  const joint = joints[index]!;
  const wanted = 1 - JOINT_OPEN / left[0]!;
  const { first, layout } = joint;
  for (let k = 0; k < layout.members; k += 1) {
    for (let c = 0; c < 3; c += 1) {
      before[3 * k + c] = q[bodies[first + k]! + c]!;
    }
  }
  if (joint.kernel === POINT) {
    pushPoints(data, index, index + 1, false);
  } else if (joint.kernel === TURN) {
    pushTurns(data, index, index + 1, false);
  } else {
    lineariseBlock(data, joint);
    pushBlock(data, joint);
  }
  const share = goesIntoWalls(data, joint) ? 0 : wanted;
  for (let k = 0; k < layout.members; k += 1) {
    const b = bodies[first + k]!;
    for (let c = 0; c < 3; c += 1) {
      const start = before[3 * k + c]!;
      q[b + c] = start + share * (q[b + c]! - start);
    }
  }
}

/**
 * Whether each body that was just moved went deeper into something immovable that it is in already: two bodies on either side of a wall
 * would be pulled into it, and through. If one of them is not in front of a wall, it is the one that moves in the end, as do the links of a
 * track that goes over a stone.
 */
function goesIntoWalls({ motion: q, joints: { bodies } }: SolverData, { constraint, first }: Joint): boolean {
  const { members } = constraint;
  for (let k = 0; k < members.length; k += 1) {
    const b = bodies[first + k]!;
    const x = q[b + d.QX]! - before[3 * k]!;
    const y = q[b + d.QY]! - before[3 * k + 1]!;
    way[0] = x;
    way[1] = y;
    way[2] = INTO_WALL * Math.sqrt(x * x + y * y);
    if (!members[k]!.shapes.some(isGoneInto)) {
      return false;
    }
  }
  return true;
}

/** Whether a shape went along `way` deeper into a wall that it is in already. */
function isGoneInto(shape: Shape): boolean {
  for (let i = 0; i < shape.arbiters.length; i += 1) {
    const pair = shape.arbiters[i]!;
    const isFirst = pair.shapeA === shape;
    const wall = isFirst ? pair.bodyB : pair.bodyA;
    if (wall.kind !== DYNAMIC && pair.isSolid() && goesInto(pair, isFirst ? 1 : -1)) {
      return true;
    }
  }
  return false;
}

function goesInto({ numbers: n, at: o }: Arbiter, sign: number): boolean {
  findLeastSeparation(n, o);
  return leastSeparation[0]! < -JOINT_OPEN && sign * (n[o + g.NX]! * way[0]! + n[o + g.NY]! * way[1]!) > way[2]!;
}

/** Whether a joint may be closed. Not if it has something immovable, which would drag bodies through a wall at once. */
function mayClose(data: SolverData, { first, layout }: Joint): boolean {
  for (let n = first; n < first + layout.members; n += 1) {
    if (!canMove(data, data.joints.bodies[n]!)) return false;
  }
  return true;
}
