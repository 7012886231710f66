import type { RigidBody } from '../../../body.js';
import { DYNAMIC, KINEMATIC } from '../../../body-kind.js';
import { SETTLE_STEPS } from '../../../config-joints.js';
import type { Constraint } from '../../../constraint/constraint.js';
import type { PointConstraint } from '../../../constraint/point.js';
import type { World } from '../../../world.js';
import { Group, type JointData, resetJoints } from '../joint-data.js';
import { ANCHORED, BLOCK, BlockLayout, CUSTOM, DISTANCE, DISTANCE_OWN, LINE, POINT, TURN } from '../joint-layout.js';
import { angleBeside } from './pinned.js';
import { addJoint, allot } from './runs.js';

/**
 * Of joints at the same distance from what cannot move, every third one is listed, three times over. Neighbours share a body, so the
 * processor would wait for one before it can begin the next. With every second one, nets would gape half as far again.
 */
const RING_STEP = 3;

/**
 * Lists the live constraints, group by group. Within a group they are listed breadth-first from what cannot move, and otherwise in the
 * order they were added: so a sweep carries a load from where it hangs to where it ends. In any other order, a chain under a heavy ball
 * stretches twice as far.
 */
export function orderJoints(world: World): void {
  const acting: Constraint[] = [];
  for (const constraint of world.liveConstraints) {
    if (acts(world, constraint)) {
      acting.push(constraint);
    } else {
      constraint.forget();
    }
  }
  acting.sort(byOrder);
  const { joints } = world.solver;
  resetJoints(joints);
  const left = new Set(acting);
  const unlisted = new Set(acting);
  const met = new Set<RigidBody>();
  const passed = new Set<RigidBody>();
  for (const constraint of acting) {
    if (left.has(constraint)) {
      const group = new Group(joints.joints.length);
      const together = hangingTogether(constraint, left, met);
      group.anchors = countAnchors(together);
      // The errors that are left make no momentum either.
      if (forgetUnmet(together, group.anchors)) group.settling = SETTLE_STEPS;
      joints.groups.push(group);
      addTurnsLast(joints, breadthFirst(together, unlisted, passed));
    }
  }
  allot(joints);
}

/**
 * Lets joints that could not be met forget their impulses if something that held them against each other is gone: else a rope that a hand
 * drew too far would be flung off as it lets go. If something else leaves them, as a lamp leaves a taut rope, they keep what they bear.
 * @returns whether they forget.
 */
function forgetUnmet(together: readonly Constraint[], anchors: number): boolean {
  const unmet = together.reduce((most, constraint) => Math.max(most, constraint.unmetAnchors), 0);
  for (const constraint of together) {
    constraint.unmetAnchors = unmet;
    if (unmet > anchors) constraint.forget();
  }
  return unmet > anchors;
}

/** How many members of constraints are static or kinematic. */
function countAnchors(constraints: readonly Constraint[]): number {
  return constraints.reduce((count, { members }) => count + members.filter(isImmovable).length, 0);
}

/**
 * The kernel for a constraint. One that breaks, or has a kinematic body that another world may move at any time, gets a kernel that reads
 * everything anew in each sub-step.
 */
function kernelFor({ type, members, stiff, breakUnderForce, breakUnderError, owner }: Constraint): number {
  const isSpecial =
    breakUnderForce || breakUnderError || members.some((body) => body.kind === KINEMATIC && body.owner !== owner);
  switch (type) {
    case 'POINT':
      return stiff && !isSpecial ? POINT : ANCHORED;
    case 'WELD':
      return ANCHORED;
    case 'LINE':
      return LINE;
    case 'CUSTOM':
      return CUSTOM;
    case 'ANGLE':
    case 'MOTOR':
      return isSpecial ? BLOCK : TURN;
    case 'DISTANCE':
      return DISTANCE;
    default:
      return BLOCK;
  }
}

/** Whether a constraint acts in a world: not with a dynamic body that is not in it, nor between a body and itself, unless it is custom. */
export function acts(world: World, { members, type }: Constraint): boolean {
  return (
    members.every((body) => body.kind !== DYNAMIC || body.owner === world) &&
    (members.length !== 2 || members[0] !== members[1] || type === 'CUSTOM')
  );
}

/**
 * All constraints that are reached from one by way of dynamic bodies that they share, in the order they were added. They are removed from
 * `left`, and the bodies are added to `met`.
 */
function hangingTogether(start: Constraint, left: Set<Constraint>, met: Set<RigidBody>): Constraint[] {
  const found = [start];
  left.delete(start);
  for (const constraint of found) {
    addNeighbours(constraint, left, met, found);
  }
  return found.sort(byOrder);
}

/**
 * Moves the constraints that share a dynamic body with one from `left` to `found`. Each body is looked at only once, as all its constraints
 * are listed then: else a hub would be searched for each of its joints.
 */
function addNeighbours({ members }: Constraint, left: Set<Constraint>, met: Set<RigidBody>, found: Constraint[]): void {
  for (const body of members) {
    if (body.kind === DYNAMIC && !met.has(body)) {
      met.add(body);
      for (const next of body.constraints) {
        if (left.delete(next)) found.push(next);
      }
    }
  }
}

function byOrder(a: Constraint, b: Constraint): number {
  return a.order - b.order;
}

/**
 * Sorts constraints by how many of them lie between each and the nearest that is tied to something immovable; of those with the same
 * number, every third is listed, then the next third, and so on. They are removed from `left`, and their dynamic bodies are added to `met`.
 */
function breadthFirst(
  constraints: readonly Constraint[],
  left: Set<Constraint>,
  met: Set<RigidBody>,
): readonly Constraint[] {
  const listed: Constraint[] = [];
  let ring = constraints.filter(isAnchored);
  for (const constraint of ring) {
    left.delete(constraint);
  }
  while (ring.length > 0) {
    for (let first = 0; first < RING_STEP; first += 1) {
      for (let i = first; i < ring.length; i += RING_STEP) {
        listed.push(ring[i]!);
      }
    }
    const next: Constraint[] = [];
    for (const constraint of ring) {
      addNeighbours(constraint, left, met, next);
    }
    ring = next.sort(byOrder);
  }
  // Everything in a group is reached from what is anchored, if any of it is.
  return listed.length > 0 ? listed : constraints;
}

function isAnchored({ members }: Constraint): boolean {
  return members.some(isImmovable);
}

function isImmovable({ kind }: RigidBody): boolean {
  return kind !== DYNAMIC;
}

/**
 * Adds constraints, those that only turn bodies last, where bounds have the last word. Between the others they would cut these into short
 * runs: ragdolls take a fifth longer.
 */
function addTurnsLast(joints: JointData, constraints: readonly Constraint[]): void {
  const turns: [Constraint, angle: number][] = [];
  const points = new Set<Constraint>();
  for (const constraint of constraints) {
    const kernel = kernelFor(constraint);
    const angle = kernel === POINT ? angleBeside(constraint as PointConstraint, points) : Number.NaN;
    const keepsAngle = !Number.isNaN(angle);
    if (constraint.keepsAngle !== keepsAngle) {
      // Its impulses belong to other rows.
      constraint.forget();
      constraint.keepsAngle = keepsAngle;
    }
    if (kernel === TURN || keepsAngle) {
      turns.push([constraint, angle]);
      continue;
    }
    if (kernel === POINT) points.add(constraint);
    const own = kernel === DISTANCE ? DISTANCE_OWN : 0;
    addJoint(joints, constraint, kernel, new BlockLayout(constraint.dimension, constraint.members.length, own));
  }
  for (const [constraint, angle] of turns) {
    addJoint(joints, constraint, TURN, new BlockLayout(1, 2), angle);
  }
}
