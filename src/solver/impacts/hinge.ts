import type { RigidBody } from '../../body.js';
import { STATIC } from '../../body-kind.js';
import * as g from '../../collide/layout.js';
import { CONTACT_SLOP } from '../../config.js';
import { HINGE_GAPE } from '../../config-joints.js';
import type { Constraint } from '../../constraint/constraint.js';
import type { PointConstraint } from '../../constraint/point.js';
import type { List } from '../../math/list.js';
import type { Impact } from './impact.js';

// A pendulum, a door, a flipper: what hangs on one point of something static can only turn about that point, also when it is struck. As a
// free body it would come away from its hinge, and lose a quarter of its energy when it is put back.

/** A position relative to the origin of a body, m; or an impulse, N·s. */
interface Spot {
  x: number;
  y: number;
}

/** The impulse of a hinge: scratch. */
const reaction: Spot = { x: 0.5, y: 0.5 };

/**
 * Finds the only point at which a body is held, if what holds it is static, rigid and does not break; writes the position of the point to
 * `at`. Motors and angles do not count. @returns the constraint, or `null`.
 */
export function findHinge(body: RigidBody, at: Spot): PointConstraint | null {
  let point: PointConstraint | null = null;
  for (let i = 0; i < body.constraints.length; i += 1) {
    const constraint = body.constraints[i]!;
    if (constraint.owner !== body.owner || !constraint.enabled || turnsOnly(constraint)) {
      continue;
    }
    if (point !== null || !isFirm(constraint)) {
      return null;
    }
    point = constraint as PointConstraint;
  }
  return point !== null && isOn(point, body, at) ? point : null;
}

/**
 * Adds the impulses of the hinges of all bodies that were moved by impacts: of all that such a body got, the part that did not come from
 * its contacts. `before` has the velocities before, three numbers a body.
 */
export function noteHinges(
  impacts: readonly Impact[],
  count: number,
  { count: bodyCount, items }: List<RigidBody>,
  before: Float64Array,
): void {
  for (let k = 0; k < bodyCount; k += 1) {
    const body = items[k]!;
    let hinge: PointConstraint | null = null;
    reaction.x = body.mass * (body.vx - before[3 * k]!);
    reaction.y = body.mass * (body.vy - before[3 * k + 1]!);
    for (let i = 0; i < count; i += 1) {
      hinge = takeContacts(impacts[i]!, body) ?? hinge;
    }
    if (hinge !== null) noteReaction(hinge, body);
  }
}

/** Subtracts from `reaction` the impulses of an impact on a body, if it is one of the two. @returns its hinge. */
function takeContacts({ pair, points, a, b }: Impact, body: RigidBody): PointConstraint | null {
  const side = a.body === body ? a : b;
  if (side.body !== body) {
    return null;
  }
  const { numbers: n, at: o } = pair;
  const sign = side === a ? -1 : 1;
  for (const { normal, tangent } of points) {
    reaction.x -= sign * (n[o + g.NX]! * normal - n[o + g.NY]! * tangent);
    reaction.y -= sign * (n[o + g.NY]! * normal + n[o + g.NX]! * tangent);
  }
  return side.hinge;
}

/** Adds `reaction` to what a hinge gave the body that hangs on it, and the opposite to what it hangs on. */
function noteReaction({ members, anchors, given }: PointConstraint, body: RigidBody): void {
  const { x, y } = reaction;
  for (let k = 0; k < 2; k += 1) {
    const { cos, sin } = members[k]!;
    const sign = members[k] === body ? 1 : -1;
    const armX = cos * anchors[2 * k]! - sin * anchors[2 * k + 1]!;
    const armY = sin * anchors[2 * k]! + cos * anchors[2 * k + 1]!;
    given[3 * k] = given[3 * k]! + sign * x;
    given[3 * k + 1] = given[3 * k + 1]! + sign * y;
    given[3 * k + 2] = given[3 * k + 2]! + sign * (armX * y - armY * x);
  }
}

function turnsOnly({ type }: Constraint): boolean {
  return type === 'MOTOR' || type === 'ANGLE';
}

/** Whether a constraint is a point that holds whatever comes. */
function isFirm({ type, stiff, maxForce, breakUnderForce, breakUnderError }: Constraint): boolean {
  return type === 'POINT' && stiff && maxForce === Infinity && !breakUnderForce && !breakUnderError;
}

/** Whether a point holds a body to something static, and is closed. */
function isOn({ bodyA, bodyB, anchors }: PointConstraint, body: RigidBody, at: Spot): boolean {
  const own = bodyA === body ? 0 : 2;
  const other = bodyA === body ? bodyB : bodyA;
  const held = 2 - own;
  const { cos, sin } = body;
  at.x = cos * anchors[own]! - sin * anchors[own + 1]!;
  at.y = sin * anchors[own]! + cos * anchors[own + 1]!;
  const x = other.x + other.cos * anchors[held]! - other.sin * anchors[held + 1]! - body.x - at.x;
  const y = other.y + other.sin * anchors[held]! + other.cos * anchors[held + 1]! - body.y - at.y;
  const most = CONTACT_SLOP + HINGE_GAPE * Math.sqrt(at.x * at.x + at.y * at.y);
  return other.kind === STATIC && x * x + y * y <= most * most;
}
