import { DYNAMIC, KINEMATIC } from '../body-kind.js';
import type { Constraint } from '../constraint/constraint.js';
import type { PointConstraint } from '../constraint/point.js';
import type { World } from '../world.js';
import { Group, type JointData } from './joint-data.js';
import { BLOCK, BlockLayout, CUSTOM, POINT, ROW, TURN } from './joint-layout.js';
import { addJoint, allot } from './joint-list.js';
import { angleBeside } from './pinned.js';

/**
 * Neighbours in a ring share a body, and the processor would wait for one before it can begin the next. With 2 nets gape half as far again.
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
  acting.sort((a, b) => a.order - b.order);
  const { joints } = world.solver;
  joints.reset();
  const left = new Set(acting);
  for (const constraint of acting) {
    if (left.has(constraint)) {
      joints.groups.push(new Group(joints.joints.length));
      addTurnsLast(joints, breadthFirst(hangingTogether(constraint, left)));
    }
  }
  allot(joints);
}

/** What breaks, or has a kinematic body that another world may move at any time, has a kernel that looks at everything in each sub-step. */
function kernelFor({ type, dimension, members, stiff, breakUnderForce, breakUnderError, owner }: Constraint): number {
  const isSpecial =
    breakUnderForce || breakUnderError || members.some((body) => body.kind === KINEMATIC && body.owner !== owner);
  if (type === 'POINT' && stiff && !isSpecial) {
    return POINT;
  }
  if ((type === 'ANGLE' || type === 'MOTOR') && !isSpecial) {
    return TURN;
  }
  if (type === 'CUSTOM') {
    return CUSTOM;
  }
  return dimension === 1 && members.length === 2 ? ROW : BLOCK;
}

/** A constraint with a dynamic body that is not in the world does nothing, nor does one between a body and itself. */
export function acts(world: World, { members, type }: Constraint): boolean {
  return (
    members.every((body) => body.kind !== DYNAMIC || body.owner === world) &&
    (members.length !== 2 || members[0] !== members[1] || type === 'CUSTOM')
  );
}

/** All constraints that are reached from one by way of dynamic bodies that they share; they leave the set `left`. */
function hangingTogether(start: Constraint, left: Set<Constraint>): Constraint[] {
  const found = [start];
  left.delete(start);
  for (const { members } of found) {
    for (const { kind, constraints } of members) {
      for (const next of kind === DYNAMIC ? constraints : []) {
        if (left.delete(next)) {
          found.push(next);
        }
      }
    }
  }
  return found.sort((a, b) => a.order - b.order);
}

/** In the order of how many constraints lie between each and the nearest that is tied to something immovable; of the same number every third, and again. */
function breadthFirst(constraints: readonly Constraint[]): Constraint[] {
  const left = new Set(constraints);
  const listed: Constraint[] = [];
  let ring = constraints.filter(({ members }) => members.some(({ kind }) => kind !== DYNAMIC));
  while (ring.length > 0) {
    for (let first = 0; first < RING_STEP; first += 1) {
      for (let i = first; i < ring.length; i += RING_STEP) {
        left.delete(ring[i]!);
        listed.push(ring[i]!);
      }
    }
    const bodies = new Set(ring.flatMap(({ members }) => members).filter(({ kind }) => kind === DYNAMIC));
    const next = new Set([...bodies].flatMap((body) => body.constraints.filter((constraint) => left.has(constraint))));
    ring = [...next].sort((a, b) => a.order - b.order);
  }
  return [...listed, ...left];
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
