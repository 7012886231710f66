import type { RigidBody } from '../body.js';
import { DYNAMIC } from '../body-kind.js';
import { letsMeet } from '../broadphase/broadphase.js';
import type { Shape } from '../shape/shape.js';
import { areKeptApart } from './ties.js';

// Which shapes may have to do with each other.

/** Filters, and what makes an interaction possible at all. */
export function mayInteract(a: Shape, b: Shape): boolean {
  return !areApart(a, b) && canInteract(a, b);
}

/** Filters or joints keep two shapes from interacting: until either change, which `World.filters` counts. */
export function areApart(a: Shape, b: Shape): boolean {
  const bodyA = a.owner!;
  const bodyB = b.owner!;
  return !letsMeet(a, b) || (bodyA.ignoring > 0 && bodyB.ignoring > 0 && areKeptApart(bodyA, bodyB));
}

/** Of two bodies that are not of one kind that never does, or asleep both. */
export function canInteract(a: Shape, b: Shape): boolean {
  const bodyA = a.owner!;
  const bodyB = b.owner!;
  return (
    bodyA !== bodyB &&
    (bodyA.kind === DYNAMIC || bodyB.kind === DYNAMIC || a.sensor || b.sensor) &&
    !(bodyA.asleep && bodyB.asleep)
  );
}

/** It is no dynamic body that sleeps: the solver would not move that. */
export function canGiveWay({ kind, asleep }: RigidBody): boolean {
  return kind !== DYNAMIC || !asleep;
}
