import type { RigidBody } from '../body.js';
import { DYNAMIC, STATIC } from '../body-kind.js';
import type { Arbiter } from '../contact/arbiter.js';
import { holdAtEnd } from '../contact/at-end.js';
import { BEFORE_STEP } from '../events/events.js';
import { END } from '../listeners.js';
import type { Shape } from '../shape/shape.js';
import type { World } from '../world.js';
import { joinLists, leaveLists } from './arbiter-lists.js';
import { neighboursOf, quieten, wakeBody } from './sleep.js';
import { enlivenTied } from './ties.js';

/** Wakes, with events, the dynamic bodies that a body interacts with. */
export function rouseNeighbours(world: World, body: RigidBody): void {
  for (const other of neighboursOf(body)) {
    other.unloaded = world.timeStamp + 1;
    wakeBody(world, other, false);
  }
}

/** Ends every interaction of a shape that goes, with an `end` for those that run. */
export function cutPairs(world: World, shape: Shape): void {
  while (shape.arbiters.length > 0) {
    cutPair(world, shape.arbiters[shape.arbiters.length - 1]!);
  }
}

function cutPair(world: World, pair: Arbiter): void {
  holdAtEnd(pair);
  if (pair.active || pair.sleeping) {
    world.events.interaction(END, pair, BEFORE_STEP);
  }
  leaveLists(world, pair);
  world.pairs.cutOff(pair);
}

/**
 * Changes the type of a body in this world, outside a step. Interactions that the new type cannot have end, the others go on, some in the
 * world's other list.
 */
export function changeKind(world: World, body: RigidBody, kind: number): void {
  wakeBody(world, body, true);
  rouseNeighbours(world, body);
  if (body.liveIndex >= 0) {
    quieten(world, body);
  }
  body.kind = kind;
  world.jointsStale ||= body.constraints.length > 0;
  for (const constraint of body.constraints) {
    if (constraint.owner !== world) {
      // In another world it acts on what cannot move there, and on nothing dynamic.
      constraint.touch();
    }
  }
  for (const shape of body.shapes) {
    for (const pair of [...shape.arbiters]) {
      if (!isPossible(pair)) {
        cutPair(world, pair);
      } else if (!pair.sleeping) {
        leaveLists(world, pair);
        joinLists(world, pair);
      }
    }
  }
  if (kind === STATIC) {
    body.asleep = true;
    return;
  }
  // Constraints of a kinematic body that moved slept if nothing else of them was dynamic.
  enlivenTied(world, body);
  if (kind === DYNAMIC) {
    world.events.woke(body);
  }
}

/** Whether a pair can still interact: a sensor with anything, but not static with static; in a collision one side has to be dynamic. */
function isPossible({ sensor, bodyA, bodyB }: Arbiter): boolean {
  return sensor ? bodyA.kind !== STATIC || bodyB.kind !== STATIC : bodyA.kind === DYNAMIC || bodyB.kind === DYNAMIC;
}
