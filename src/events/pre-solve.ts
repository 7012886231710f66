import type { Arbiter } from '../contact/arbiter.js';
import { ACCEPTED, PERSISTENT } from '../contact/bits.js';
import { admits, type Listeners, PRE_SOLVE } from '../listeners.js';
import type { HitHandler, Shape, ShapeHandler } from '../shape/shape.js';
import type { World } from '../world.js';
import type { EventQueue } from './events.js';

/** Whether some `preSolve` handler has to be asked about the pair. */
export function asksFirst({ shapeA, shapeB }: Arbiter): boolean {
  return wants(shapeA, shapeB) || wants(shapeB, shapeA);
}

function wants({ listeners }: Shape, other: Shape): boolean {
  return (
    (listeners.types & PRE_SOLVE) !== 0 &&
    listeners.entries.some((entry) => entry.type === PRE_SOLVE && admits(entry, other.group))
  );
}

/**
 * Calls the `preSolve` handlers of a colliding pair, at once. Unless its state is persistent, it starts as accepted. What a handler throws
 * waits until the step is over, so that no step is left half done. A handler that is not deterministic keeps the bodies awake.
 *
 * @returns whether the collision takes effect; if not, its points are dropped.
 */
export function preSolve(world: World, arbiter: Arbiter): boolean {
  if (!arbiter.is(PERSISTENT)) {
    arbiter.mark(ACCEPTED);
    askBoth(world, arbiter);
  }
  if (!arbiter.is(ACCEPTED)) arbiter.dropPoints();
  return arbiter.is(ACCEPTED);
}

function askBoth({ events, timeStamp }: World, arbiter: Arbiter): void {
  const { shapeA, shapeB, bodyA, bodyB } = arbiter;
  const { listeners: a } = shapeA;
  const { listeners: b } = shapeB;
  if (((a.types | b.types) & PRE_SOLVE) === 0) {
    return;
  }
  const unsteadyA = ask(events, arbiter, a, shapeA, shapeB);
  const unsteadyB = ask(events, arbiter, b, shapeB, shapeA);
  if ((unsteadyA || unsteadyB) && !arbiter.is(PERSISTENT)) {
    bodyA.wakeTime = timeStamp;
    bodyB.wakeTime = timeStamp;
  }
}

/** Calls the handlers of one side. @returns whether one of them is not deterministic. */
function ask(events: EventQueue, arbiter: Arbiter, list: Listeners<HitHandler>, own: Shape, other: Shape): boolean {
  let unsteady = false;
  for (const entry of list.entries) {
    if (entry.type === PRE_SOLVE && admits(entry, other.group)) {
      unsteady ||= !entry.deterministic;
      try {
        (entry.handler as ShapeHandler).call(own, arbiter, other);
      } catch (error) {
        events.fail(error);
      }
    }
  }
  return unsteady;
}
