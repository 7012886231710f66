import type { BodyEventType, RigidBody } from '../body.js';
import type { Constraint, ConstraintEventType } from '../constraint/constraint.js';
import type { Arbiter } from '../contact/arbiter.js';
import type { Shape, ShapeEventType, ShapeHandler } from '../shape/shape.js';
import type { Listener, Listeners } from './listeners.js';

type EventType = ShapeEventType | BodyEventType | ConstraintEventType;

/** Events of one delivery come in this order, then by the ids of their shapes, then as they were queued. */
const ORDER: Readonly<Record<EventType, number>> = {
  wake: 0,
  begin: 1,
  progress: 2,
  end: 3,
  sleep: 4,
  break: 5,
  preSolve: 6,
};

/** Events caused before the step come before those of the step. */
export const BEFORE_STEP = 0;
export const IN_STEP = 1;
/** … and those before what the solver found out. */
export const FOUND_LATE = 2;

/** Stands where shape ids do, above all of them. */
const AFTER_BODIES = Number.MAX_SAFE_INTEGER;

/** One handler to be called for an event; noted when the event is, so that later changes of the listeners do not touch it. */
interface QueuedEvent {
  readonly group: number;
  readonly type: EventType;
  readonly idA: number;
  readonly idB: number;
  readonly call: () => void;
}

function meets(entry: Listener<ShapeHandler>, type: string, other: Shape): boolean {
  return entry.type === type && (entry.mask === undefined || (entry.mask & other.group) !== 0);
}

function compare(a: QueuedEvent, b: QueuedEvent): number {
  return a.group - b.group || ORDER[a.type] - ORDER[b.type] || a.idA - b.idA || a.idB - b.idB;
}

/**
 * Deferred delivery: events are noted while a step runs (or between steps) together with the handlers present at that
 * moment, and handed out at the end of the step, when the world may be changed freely.
 */
export class EventQueue {
  private queue: QueuedEvent[] = [];
  private delivering: QueuedEvent[] | null = null;
  private failure: { readonly error: unknown } | null = null;

  /** Notes `begin`, `progress` or `end` of an interaction. */
  interaction(type: 'begin' | 'progress' | 'end', arbiter: Arbiter, group: number): void {
    const { shapeA, shapeB } = arbiter;
    const a = shapeA.listeners;
    const b = shapeB.listeners;
    if (a.length > 0) {
      this.note(type, arbiter, group, a, shapeA, shapeB);
    }
    if (b.length > 0) {
      this.note(type, arbiter, group, b, shapeB, shapeA);
    }
  }

  private note(
    type: 'begin' | 'progress' | 'end',
    arbiter: Arbiter,
    group: number,
    list: Listeners<ShapeHandler>,
    own: Shape,
    other: Shape,
  ): void {
    const { id: idA } = arbiter.shapeA;
    const { id: idB } = arbiter.shapeB;
    for (const entry of list) {
      if (meets(entry, type, other)) {
        const call = () => entry.handler.call(own, arbiter, other);
        this.queue.push({ group, type, idA, idB, call });
      }
    }
  }

  /** Notes `wake` or `sleep` of a body. */
  body(type: BodyEventType, body: RigidBody): void {
    this.object(type, body, body.shapes.length > 0 ? body.shapes[0]!.id : -1, -1);
  }

  /** Notes `wake`, `sleep` or `break` of a constraint; bodies come before constraints. */
  constraint(type: ConstraintEventType, constraint: Constraint): void {
    this.object(type, constraint, AFTER_BODIES, constraint.order);
  }

  private object<T extends { listeners: Listeners<(this: T) => void> }>(
    type: EventType,
    object: T,
    idA: number,
    idB: number,
  ): void {
    for (const { type: wanted, handler } of object.listeners) {
      if (wanted === type) {
        this.queue.push({ group: IN_STEP, type, idA, idB, call: () => handler.call(object) });
      }
    }
  }

  /**
   * Calls the handlers of everything queued so far; what they cause waits for the next delivery. If a handler throws, the
   * rest is delivered all the same.
   */
  deliver(): void {
    if (this.queue.length === 0) {
      return;
    }
    const events = this.queue;
    this.queue = [];
    events.sort(compare);
    this.delivering = events;
    for (const event of events) {
      if (this.delivering !== events) {
        break;
      }
      this.attempt(event.call);
    }
    this.delivering = null;
  }

  /** Calls a handler; the first exception is kept for `rethrow`. */
  attempt(call: () => void): void {
    try {
      call();
    } catch (error) {
      this.fail(error);
    }
  }

  /** Keeps the first error for `rethrow`. */
  fail(error: unknown): void {
    this.failure ??= { error };
  }

  /** Throws what a handler threw since the last call, if any did. */
  rethrow(): void {
    const failure = this.failure;
    if (failure !== null) {
      this.failure = null;
      throw failure.error;
    }
  }

  /** Forgets everything queued, and ends a delivery in progress. */
  clear(): void {
    this.queue = [];
    this.delivering = null;
  }
}

/** Some `preSolve` handler wants to decide about the pair. */
export function asksFirst(arbiter: Arbiter): boolean {
  const { shapeA, shapeB } = arbiter;
  return (
    shapeA.listeners.some((entry) => meets(entry, 'preSolve', shapeB)) ||
    shapeB.listeners.some((entry) => meets(entry, 'preSolve', shapeA))
  );
}

/**
 * Runs the `preSolve` handlers of a pair that collides, at once. Unless it is persistent its state starts as "accepted". What a
 * handler throws waits until the step is over, so that it cannot leave one half done.
 *
 * @returns whether a handler that may change its mind keeps the bodies awake.
 */
export function preSolve(events: EventQueue, arbiter: Arbiter): boolean {
  const { shapeA, shapeB } = arbiter;
  if (arbiter.persistent) {
    return false;
  }
  arbiter.accepted = true;
  const a = shapeA.listeners;
  const b = shapeB.listeners;
  if (a.length === 0 && b.length === 0) {
    return false;
  }
  let unsteady = false;
  for (const [list, own, other] of [
    [a, shapeA, shapeB],
    [b, shapeB, shapeA],
  ] as const) {
    for (const entry of list) {
      if (meets(entry, 'preSolve', other)) {
        unsteady ||= !entry.deterministic;
        events.attempt(() => entry.handler.call(own, arbiter, other));
      }
    }
  }
  return unsteady && !arbiter.persistent;
}
