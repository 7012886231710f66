import type { RigidBody } from '../body.js';
import type { Constraint } from '../constraint/constraint.js';
import type { Arbiter } from '../contact/arbiter.js';
import { Hit } from '../contact/hit.js';
import { admits, END, HIT, type Listeners, NON_FINITE, RANKS, rankOf, WAKE } from '../listeners.js';
import type { Shape } from '../shape/shape.js';
import type { World } from '../world.js';
import { type Note, Notes } from './notes.js';

/** Groups of events, in the order of delivery: caused before the step, … */
export const BEFORE_STEP = 0;
export const IN_STEP = 1;
/** … found by the solver in the step. */
export const FOUND_LATE = 2;
const GROUPS = 3;

/** In place of a shape id: above all of them. */
const AFTER_BODIES = Number.MAX_SAFE_INTEGER;

/** A type that all handlers can be called as. */
type Handler = (this: unknown, subject?: Arbiter | RigidBody, other?: Shape | Hit, hit?: Hit) => void;

/** The lists of events in the order of delivery: by group, then by type. */
function makeLists(): Notes[] {
  return Array.from({ length: GROUPS * RANKS }, (_, i) => new Notes(1 << (i % RANKS)));
}

/**
 * Deferred delivery: events are noted within a step (or between steps), together with the listeners present at that moment, and delivered
 * at the end of the step, when handlers may change the world freely.
 */
export class EventQueue {
  private lists = makeLists();
  /** The lists that are being handed out, while `lists` takes what handlers cause. */
  private handed = makeLists();
  /** Whether anything was noted since the last delivery: most steps of most worlds have no events. */
  private stirred = false;
  private readonly hits: Hit[] = [];
  /** The arbiters of the hits of this step: that of `hits[i]` is `struck[i]`. */
  private readonly struck: Arbiter[] = [];
  /** @internal bodies and constraints that woke since `noteWoken` was last called */
  readonly woken = new Set<RigidBody | Constraint>();
  private failure: { readonly error: unknown } | null = null;

  constructor(private readonly world: Pick<World, 'listeners'>) {}

  /** Notes an event of an interaction. `type` is a bit, `group` says when it was found. */
  interaction(type: number, arbiter: Arbiter, group: number): void {
    const { shapeA, shapeB } = arbiter;
    const { listeners } = this.world;
    if (((shapeA.listeners.types | shapeB.listeners.types | listeners.types) & type) !== 0) {
      const note = this.list(type, group).add(shapeA.id, shapeB.id);
      note.own = shapeA;
      note.listeners = shapeA.listeners;
      note.group = shapeA.group;
      note.arbiter = arbiter;
      note.other = shapeB;
      note.otherListeners = shapeB.listeners;
      note.otherGroup = shapeB.group;
      note.hit = type === HIT ? this.hits[this.struck.length - 1]! : null;
      note.worldListeners = listeners;
    }
  }

  /** Notes that a collision which takes effect has begun. */
  hit(arbiter: Arbiter, group: number): void {
    if (this.isHitHeard(arbiter)) {
      this.struck.push(arbiter);
      if (this.hits.length < this.struck.length) {
        this.hits.push(new Hit());
      }
      this.interaction(HIT, arbiter, group);
    }
  }

  /** Whether someone listens to how hard the shapes of a pair collide. */
  isHitHeard({ shapeA, shapeB }: Arbiter): boolean {
    return ((shapeA.listeners.types | shapeB.listeners.types | this.world.listeners.types) & HIT) !== 0;
  }

  /** The `end` events of pairs that were removed since the last step: between steps, no other interactions are noted. */
  get ended(): Notes {
    return this.list(END, BEFORE_STEP);
  }

  private list(type: number, group: number): Notes {
    this.stirred = true;
    return this.lists[group * RANKS + rankOf(type)]!;
  }

  /** Notes `wake` or `sleep` of a body. */
  body(type: number, body: RigidBody): void {
    this.object(type, body, placeOf(body), -1);
  }

  /** Notes that a world has frozen one of its bodies. */
  frozen(world: World, body: RigidBody): void {
    const note = this.object(NON_FINITE, world, placeOf(body), -1);
    if (note !== null) {
      note.body = body;
    }
  }

  /** Notes `wake`, `sleep` or `break` of a constraint. Constraints come after bodies. */
  constraint(type: number, constraint: Constraint): void {
    this.object(type, constraint, AFTER_BODIES, constraint.order);
  }

  private object(type: number, object: RigidBody | Constraint | World, idA: number, idB: number): Note | null {
    if ((object.listeners.types & type) === 0) {
      return null;
    }
    const note = this.list(type, IN_STEP).add(idA, idB);
    note.own = object;
    note.listeners = object.listeners;
    return note;
  }

  /** Notes that a body or constraint woke. Its event is noted by `noteWoken`, if it is still awake and in this world then. */
  woke(object: RigidBody | Constraint): void {
    if (!object.woken) {
      object.woken = true;
      // It goes to the end, even if it is still there from earlier, when its event was dropped.
      this.woken.delete(object);
      this.woken.add(object);
    }
  }

  /** Notes the `wake` events of all that woke since the last call. */
  noteWoken(world: World): void {
    if (this.woken.size === 0) {
      return;
    }
    for (const object of this.woken) {
      if (object.woken && object.owner === world) {
        object.woken = false;
        if (object.asleep) {
          continue;
        }
        if (!('shapes' in object)) {
          this.constraint(WAKE, object);
        } else if (object.isDynamic()) {
          this.body(WAKE, object);
        }
      }
    }
    this.woken.clear();
  }

  /** Copies the outcome of the step to the hits, before handlers may change anything. */
  readHits(): void {
    for (let i = 0; i < this.struck.length; i += 1) {
      this.hits[i]!.read(this.struck[i]!);
    }
    this.struck.length = 0;
  }

  /**
   * Calls the handlers of all events noted so far; the events these cause wait for the next delivery. If a handler throws, the rest is
   * delivered all the same.
   */
  deliver(): void {
    if (!this.stirred) {
      return;
    }
    this.stirred = false;
    const lists = this.lists;
    this.lists = this.handed;
    this.handed = lists;
    for (const list of lists) {
      this.handOut(list);
    }
  }

  private handOut(list: Notes): void {
    list.sort();
    for (let i = 0; i < list.count; i += 1) {
      const note = list.all[i]!;
      const { own, other, arbiter, hit } = note;
      this.hand(list, note.listeners, note.otherGroup, own, arbiter ?? note.body, other, hit);
      if (other !== null) {
        this.hand(list, note.otherListeners, note.group, other, arbiter, own as Shape, hit);
        this.hand(list, note.worldListeners, note.group, this.world, arbiter, hit, null);
      }
    }
    list.clear();
  }

  /** Calls the handlers of one object for an event. If one of them calls `World.clear`, the list is emptied, and no more are called. */
  private hand(
    list: Notes,
    { entries }: Listeners<unknown>,
    group: number,
    own: unknown,
    subject: Arbiter | RigidBody | null,
    other: Shape | Hit | null,
    hit: Hit | null,
  ): void {
    for (let i = 0; i < entries.length && list.count > 0; i += 1) {
      const entry = entries[i]!;
      if (
        entry.type === list.type &&
        admits(entry, group) &&
        (hit === null || hit.approachSpeed >= entry.minimumSpeed)
      ) {
        this.call(entry.handler as Handler, own, subject, other, hit);
      }
    }
  }

  /** Calls a handler. What it throws waits for `rethrow`. */
  call(
    handler: Handler,
    own: unknown,
    subject: Arbiter | RigidBody | null,
    other: Shape | Hit | null,
    hit: Hit | null,
  ): void {
    try {
      if (subject === null) {
        handler.call(own);
      } else if (other === null) {
        handler.call(own, subject);
      } else if (hit === null) {
        handler.call(own, subject, other);
      } else {
        handler.call(own, subject, other, hit);
      }
    } catch (error) {
      this.fail(error);
    }
  }

  /** Keeps the first error for `rethrow`. */
  fail(error: unknown): void {
    this.failure ??= { error };
  }

  /** Throws the first error of a handler since the last call, if there was one. */
  rethrow(): void {
    const failure = this.failure;
    if (failure !== null) {
      this.failure = null;
      throw failure.error;
    }
  }

  /** Drops all events, and ends a delivery in progress. */
  clear(): void {
    for (const list of [...this.lists, ...this.handed]) {
      list.clear();
    }
    this.woken.clear();
  }
}

/** The place of a body in the order of events: the id of its first shape, −1 without shapes. */
function placeOf({ shapes }: RigidBody): number {
  return shapes[0]?.id ?? -1;
}
