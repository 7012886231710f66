import { PINS_APART, PINS_UNLIKE } from '../../../config-joints.js';
import type { Constraint } from '../../../constraint/constraint.js';
import { holdsBoth, type PointConstraint } from '../../../constraint/point.js';
import { atan2 } from '../../../math/trig.js';
import { shorterList } from '../joint-numbers.js';

// Two bodies that are held together by two rigid points cannot move relative to each other, as if they were welded. Solved as two points,
// both would ask for the same along the line between them, and across it would take the more sweeps the closer they lie: a door on two
// hinges 4 cm apart sprang by 5 mm, and stayed turned the wrong way round. So the first one is solved as a point, and the other one as the
// angle at which both are met.

/**
 * rad. The angle of `bodyB` relative to `bodyA` at which this point and one of the others between the same two bodies are both met; NaN if
 * there is no such other.
 */
export function angleBeside(point: PointConstraint, others: ReadonlySet<Constraint>): number {
  const { bodyA, bodyB } = point;
  for (const other of shorterList(bodyA, bodyB)) {
    if (others.has(other) && holdsBoth(other, bodyA, bodyB)) {
      const angle = angleBetween(point, other as PointConstraint);
      if (!Number.isNaN(angle)) return angle;
    }
  }
  return Number.NaN;
}

/**
 * The angle between the ways from one point to the other on both bodies; NaN if these differ in length, as then both points cannot be met,
 * or are very short.
 */
function angleBetween(
  { anchors, bodyA }: PointConstraint,
  { anchors: others, bodyA: otherA }: PointConstraint,
): number {
  const swap = bodyA === otherA ? 0 : 2;
  const ax = anchors[0]! - others[swap]!;
  const ay = anchors[1]! - others[swap + 1]!;
  const bx = anchors[2]! - others[2 - swap]!;
  const by = anchors[3]! - others[3 - swap]!;
  const onA = Math.sqrt(ax * ax + ay * ay);
  const onB = Math.sqrt(bx * bx + by * by);
  return Math.abs(onA - onB) <= PINS_UNLIKE && onA >= PINS_APART
    ? atan2(bx * ay - by * ax, bx * ax + by * ay)
    : Number.NaN;
}
