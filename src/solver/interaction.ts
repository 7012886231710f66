import type { RigidBody } from '../body.js';
import { DYNAMIC } from '../body-kind.js';
import { letsMeet } from '../broadphase/broadphase.js';
import type { Shape } from '../shape/shape.js';
import { areKeptApart } from './ties.js';

// Which shapes may interact.

/** Whether two shapes may interact: by their filters, joints, and bodies. */
export function mayInteract(a: Shape, b: Shape): boolean {
  return !areApart(a, b) && canInteract(a, b);
}

/** Whether filters or joints keep two shapes from interacting. That holds until either change, which `World.filters` counts. */
export function areApart(a: Shape, b: Shape): boolean {
  return !letsMeet(a, b) || areKeptApart(a.owner!, b.owner!);
}

/** Whether two shapes can interact: their bodies are two, not both asleep, and one of them is dynamic or one shape is a sensor. */
export function canInteract(a: Shape, b: Shape): boolean {
  const bodyA = a.owner!;
  const bodyB = b.owner!;
  return (
    bodyA !== bodyB &&
    (bodyA.kind === DYNAMIC || bodyB.kind === DYNAMIC || a.sensor || b.sensor) &&
    !(bodyA.asleep && bodyB.asleep)
  );
}

/** Whether the solver can move the body away: not if it is dynamic and asleep. */
export function canGiveWay({ kind, asleep }: RigidBody): boolean {
  return kind !== DYNAMIC || !asleep;
}
