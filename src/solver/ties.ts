import type { RigidBody } from '../body.js';
import { DYNAMIC, KINEMATIC, STATIC } from '../body-kind.js';
import type { Constraint } from '../constraint/constraint.js';
import { BREAK, SLEEP } from '../listeners.js';
import { takeOut } from '../math/list.js';
import { unite } from '../math/sets.js';
import type { World } from '../world.js';
import { acts } from './joints/order/order.js';
import { enliven, enlivenConstraint, isLiveDynamic, quietenConstraint, wakeBody, wakeConstraint } from './sleep.js';

// Constraints that are added and removed, switched on and off, and sleep with what they join.

/** The bodies of a constraint, each once. */
function distinct(constraint: Constraint): Iterable<RigidBody> {
  return new Set(constraint.members);
}

/** Puts a constraint into the world's lists and those of its bodies. */
export function tie(world: World, constraint: Constraint): void {
  constraint.owner = world;
  world.jointSolver = constraint.solver;
  constraint.index = world.constraints.push(constraint) - 1;
  constraint.order = world.nextOrder;
  world.nextOrder += 1;
  for (const body of distinct(constraint)) {
    body.constraints.push(constraint);
  }
  listIgnoring(constraint, true);
  if (constraint.enabled && !constraint.asleep) {
    enlivenConstraint(world, constraint);
    wakeMembers(world, constraint);
  }
}

/** Takes a constraint out of all lists. */
export function untie(world: World, constraint: Constraint): void {
  if (constraint.liveIndex >= 0) {
    quietenConstraint(world, constraint);
  }
  const moved = takeOut(world.constraints, constraint.index);
  if (moved !== null) moved.index = constraint.index;
  leaveWorld(constraint);
}

/** Resets what a constraint had from its world. */
export function leaveWorld(constraint: Constraint): void {
  listIgnoring(constraint, false);
  for (const { constraints } of distinct(constraint)) {
    // The others keep their order, which is part of hashes: a body that is in no world may have constraints of several.
    constraints.splice(constraints.indexOf(constraint), 1);
  }
  constraint.owner!.someLeft = true;
  constraint.owner = null;
  constraint.asleep = false;
  constraint.woken = false;
  constraint.index = -1;
  constraint.liveIndex = -1;
  constraint.island = null;
  constraint.forget();
}

/** Wakes the dynamic bodies of a constraint, with events. */
function wakeMembers(world: World, { members }: Constraint): void {
  for (const body of members) {
    if (body.kind === DYNAMIC && body.owner === world) {
      wakeBody(world, body, false);
    }
  }
}

/** Lets a constraint act again. */
export function switchOn(world: World, constraint: Constraint): void {
  if (constraint.ignoreInteractions) world.changeFilters();
  constraint.enabled = true;
  listIgnoring(constraint, true);
  enlivenConstraint(world, constraint);
  wakeMembers(world, constraint);
}

/** Stops a constraint from acting. */
export function switchOff(world: World, constraint: Constraint): void {
  listIgnoring(constraint, false);
  constraint.enabled = false;
  if (constraint.liveIndex >= 0) {
    quietenConstraint(world, constraint);
    constraint.asleep = false;
  }
  constraint.forget();
}

/** Removes or disables a constraint that broke in this step. */
export function breakOff(world: World, constraint: Constraint): void {
  world.events.constraint(BREAK, constraint);
  if (constraint.removeOnBreak) {
    untie(world, constraint);
  } else {
    switchOff(world, constraint);
  }
}

/**
 * Updates the lists that bodies keep of those that enabled constraints keep them from interacting with, as that is asked of each pair in
 * each step: `begins` if the constraint does so from now on, else it does not any more.
 */
export function listIgnoring(constraint: Constraint, begins: boolean): void {
  if (!constraint.enabled || !constraint.ignoreInteractions) {
    return;
  }
  constraint.owner!.changeFilters();
  const bodies = [...distinct(constraint)];
  for (const body of bodies) {
    body.ignoring ??= [];
    for (const other of bodies) {
      if (begins) {
        body.ignoring.push(other);
      } else {
        takeOut(body.ignoring, body.ignoring.indexOf(other));
      }
    }
  }
}

/** Whether the constraint has a kinematic body that moves, in whatever world. Then it does not rest, even while it is slack. */
function isDriven({ members }: Constraint): boolean {
  return members.some((body) => body.kind === KINEMATIC && body.owner !== null && body.isGoing());
}

/** Keeps awake what is joined to a kinematic body that moves. */
export function keepDriven(world: World): void {
  const { liveConstraints } = world;
  for (let i = 0; i < liveConstraints.length; i += 1) {
    if (isDriven(liveConstraints[i]!) && acts(world, liveConstraints[i]!)) {
      keepAwake(liveConstraints[i]!, world.timeStamp);
    }
  }
}

function keepAwake({ members }: Constraint, stamp: number): void {
  for (let i = 0; i < members.length; i += 1) {
    const body = members[i]!;
    if (isLiveDynamic(body)) body.wakeTime = stamp;
  }
}

/** Joins the bodies of each constraint into islands, see `islands.ts`. */
export function joinTied(world: World, parent: Int32Array): void {
  const { liveConstraints } = world;
  for (let i = 0; i < liveConstraints.length; i += 1) {
    if (acts(world, liveConstraints[i]!)) {
      const { members } = liveConstraints[i]!;
      let joined = -1;
      for (let k = 0; k < members.length; k += 1) {
        if (isLiveDynamic(members[k]!)) {
          const { liveIndex } = members[k]!;
          if (joined >= 0) unite(parent, joined, liveIndex);
          joined = liveIndex;
        }
      }
    }
  }
}

/** Puts live constraints to sleep that have no awake body. */
export function sleepIdle(world: World): void {
  const live = world.liveConstraints;
  for (let i = live.length - 1; i >= 0; i -= 1) {
    const constraint = live[i]!;
    if (!constraint.members.some((body) => isLiveDynamic(body) && body.owner === world)) {
      quietenConstraint(world, constraint);
      world.events.constraint(SLEEP, constraint);
    }
  }
}

/** Whether some constraint of the world keeps the two from interacting. */
export function areKeptApart(a: RigidBody, b: RigidBody): boolean {
  if (a.ignoring === null || !a.ignoring.includes(b)) {
    return false;
  }
  // It may be a constraint of another world, which both have left.
  return a.constraints.some(
    ({ enabled, ignoreInteractions, owner, members }) =>
      enabled && ignoreInteractions && owner === a.owner && members.includes(b),
  );
}

/** Whether the body has an enabled constraint of its world. */
export function isTied(body: RigidBody): boolean {
  return body.constraints.some(ties, body);
}

function ties(this: RigidBody, { enabled, owner }: Constraint): boolean {
  return enabled && owner === this.owner;
}

/**
 * Whether an enabled constraint of its world joins the body to another one that may move: if the body were put back on its way, it would
 * leave that one behind.
 */
export function isInTrain(body: RigidBody): boolean {
  return body.constraints.some(draws, body);
}

function draws(this: RigidBody, constraint: Constraint): boolean {
  return ties.call(this, constraint) && constraint.members.some(isLoose, this);
}

function isLoose(this: RigidBody, other: RigidBody): boolean {
  return other !== this && other.kind !== STATIC;
}

/** Makes a body awake in the world, and its constraints with it. */
export function enlivenTied(world: World, body: RigidBody): void {
  enliven(world, body);
  for (const constraint of body.constraints) {
    if (constraint.owner === world && constraint.asleep) {
      wakeConstraint(world, constraint, false);
    }
  }
}
