import type { RigidBody } from '../../../body.js';
import { DYNAMIC, KINEMATIC } from '../../../body-kind.js';
import { SETTLE_STEPS } from '../../../config-joints.js';
import type { Constraint } from '../../../constraint/constraint.js';
import type { PointConstraint } from '../../../constraint/point.js';
import type { World } from '../../../world.js';
import { Group, type JointData, resetJoints } from '../joint-data.js';
import { ANCHORED, BLOCK, BlockLayout, CUSTOM, LINE, POINT, ROW, TURN } from '../joint-layout.js';
import { angleBeside } from './pinned.js';
import { addJoint, allot } from './runs.js';

/**
 * Joints at the same distance from what cannot move are listed every third one, three times over: neighbours share a body, and the processor would wait for one before it can begin the next. If it were every second one nets would gape half as far again.
 */
const RING_STEP = 3;

/**
 * Lists the live constraints, those that hang together next to each other, breadth-first from what cannot move, equals as they were
 * added: so a sweep carries a load from where it hangs to where it ends. In any other order a chain under a heavy ball stretches twice as far.
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
      // What they are still open by makes no momentum either.
      if (forgetUnmet(together, group.anchors)) group.settling = SETTLE_STEPS;
      joints.groups.push(group);
      addTurnsLast(joints, breadthFirst(together, unlisted, passed));
    }
  }
  allot(joints);
}

/**
 * Joints that could not be met, and of what held them against each other something is gone, forget what they gave against it: a rope that a hand drew too far would be flung off as it lets go. What else leaves them, as a lamp does a taut rope, leaves
 * them what they bear. @returns whether they forget.
 */
function forgetUnmet(together: readonly Constraint[], anchors: number): boolean {
  const unmet = together.reduce((most, constraint) => Math.max(most, constraint.unmetAnchors), 0);
  for (const constraint of together) {
    constraint.unmetAnchors = unmet;
    if (unmet > anchors) constraint.forget();
  }
  return unmet > anchors;
}

/** How often joints hold on to something static or kinematic. */
function countAnchors(constraints: readonly Constraint[]): number {
  return constraints.reduce((count, { members }) => count + members.filter(isImmovable).length, 0);
}

/** What breaks, or has a kinematic body that another world may move at any time, has a kernel that looks at everything in each sub-step. */
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
      return isSpecial ? ROW : TURN;
    case 'MOTOR':
      return isSpecial ? BLOCK : TURN;
    case 'DISTANCE':
      return ROW;
    default:
      return BLOCK;
  }
}

/** A constraint with a dynamic body that is not in the world does nothing, nor does one between a body and itself. */
export function acts(world: World, { members, type }: Constraint): boolean {
  return (
    members.every((body) => body.kind !== DYNAMIC || body.owner === world) &&
    (members.length !== 2 || members[0] !== members[1] || type === 'CUSTOM')
  );
}

/** All constraints that are reached from one by way of dynamic bodies that they share; they leave the set `left`, and the bodies join `met`. */
function hangingTogether(start: Constraint, left: Set<Constraint>, met: Set<RigidBody>): Constraint[] {
  const found = [start];
  left.delete(start);
  for (const constraint of found) {
    addNeighbours(constraint, left, met, found);
  }
  return found.sort(byOrder);
}

/** Takes those that share a dynamic body with one out of a set, and lists them. Each body is looked at once, as all that it has is listed then: else a hub would be, with all its joints, for each of them. */
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
 * In the order of how many constraints lie between each and the nearest that is tied to something immovable; of the same number every third, and again.
 * They leave the set `left`, and their dynamic bodies join `met`.
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
  // What hangs together is reached from what is anchored, if anything of it is.
  return listed.length > 0 ? listed : constraints;
}

function isAnchored({ members }: Constraint): boolean {
  return members.some(isImmovable);
}

function isImmovable({ kind }: RigidBody): boolean {
  return kind !== DYNAMIC;
}

/** What only turns bodies comes last, where bounds have the last word: between the others it would cut them into short runs, and ragdolls take a fifth longer. */
function addTurnsLast(joints: JointData, constraints: readonly Constraint[]): void {
  const turns: [Constraint, angle: number][] = [];
  const points = new Set<Constraint>();
  for (const constraint of constraints) {
    const kernel = kernelFor(constraint);
    const angle = kernel === POINT ? angleBeside(constraint as PointConstraint, points) : Number.NaN;
    const keepsAngle = !Number.isNaN(angle);
    if (constraint.keepsAngle !== keepsAngle) {
      // What it gave it gave by other rows.
      constraint.forget();
      constraint.keepsAngle = keepsAngle;
    }
    if (kernel === TURN || keepsAngle) {
      turns.push([constraint, angle]);
      continue;
    }
    if (kernel === POINT) points.add(constraint);
    addJoint(joints, constraint, kernel, new BlockLayout(constraint.dimension, constraint.members.length));
  }
  for (const [constraint, angle] of turns) {
    addJoint(joints, constraint, TURN, new BlockLayout(1, 2), angle);
  }
}
