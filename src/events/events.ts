import type { RigidBody } from '../body.js';
import type { Constraint } from '../constraint/constraint.js';
import type { Arbiter } from '../contact/arbiter.js';
import { Hit } from '../contact/hit.js';
import { admits, END, HIT, type Listeners, NON_FINITE, RANKS, rankOf, WAKE } from '../listeners.js';
import type { Shape } from '../shape/shape.js';
import type { World } from '../world.js';
import { type Note, Notes } from './notes.js';

/** Events caused before the step come before those of the step. */
export const BEFORE_STEP = 0;
export const IN_STEP = 1;
/** … and those before what the solver found out. */
export const FOUND_LATE = 2;
const GROUPS = 3;

/** Stands where shape ids do, above all of them. */
const AFTER_BODIES = Number.MAX_SAFE_INTEGER;

/** What all handlers of the API can be called as. */
type Handler = (this: unknown, subject?: Arbiter | RigidBody, other?: Shape | Hit, hit?: Hit) => void;

/** Lists in the order of delivery: by group, then by type. */
function makeLists(): Notes[] {
  return Array.from({ length: GROUPS * RANKS }, (_, i) => new Notes(1 << (i % RANKS)));
}

/**
 * Deferred delivery: events are noted while a step runs (or between steps) together with the handlers present at that
 * moment, and handed out at the end of the step, when the world may be changed freely.
 */
export class EventQueue {
  private lists = makeLists();
  /** The lists that are being handed out, while the others take what handlers cause. */
  private handed = makeLists();
  /** Whether a list was asked for since the last delivery: most steps of most worlds have nothing to tell. */
  private stirred = false;
  private readonly hits: Hit[] = [];
  /** The arbiters of the hits of this step, each at the place of its hit. */
  private readonly struck: Arbiter[] = [];
  /** @internal bodies and constraints that woke since this was last looked at */
  readonly woken = new Set<RigidBody | Constraint>();
  private failure: { readonly error: unknown } | null = null;

  constructor(private readonly world: Pick<World, 'listeners'>) {}

  /** Notes an event of an interaction: its type as a bit, and when it was found. */
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

  /** Someone wants to know how hard the shapes of a pair meet. */
  isHitHeard({ shapeA, shapeB }: Arbiter): boolean {
    return ((shapeA.listeners.types | shapeB.listeners.types | this.world.listeners.types) & HIT) !== 0;
  }

  /** The `end` events of what was removed since the last step: between steps no others wait. */
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

  /** Notes that a world has frozen a body of its own. */
  frozen(world: World, body: RigidBody): void {
    const note = this.object(NON_FINITE, world, placeOf(body), -1);
    if (note !== null) {
      note.body = body;
    }
  }

  /** Notes `wake`, `sleep` or `break` of a constraint; bodies come before constraints. */
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

  /** A body or constraint woke; its event is noted when the step next looks, if it is then still awake in this world. */
  woke(object: RigidBody | Constraint): void {
    if (!object.woken) {
      object.woken = true;
      // Last, even if it is still there from a time of which nobody is to be told any more.
      this.woken.delete(object);
      this.woken.add(object);
    }
  }

  /** Notes the `wake` events of what woke since the last call. */
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

  /** Reads of collisions that have begun what the step made of them, before anyone may change that. */
  readHits(): void {
    for (let i = 0; i < this.struck.length; i += 1) {
      this.hits[i]!.read(this.struck[i]!);
    }
    this.struck.length = 0;
  }

  /**
   * Calls the handlers of everything noted so far; what they cause waits for the next delivery. If a handler throws, the
   * rest is delivered all the same.
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

  /** Calls the handlers of one object of an event. `World.clear` called by one of them empties the list, and nothing more is called. */
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

  /** What it throws waits for `rethrow`. */
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

  /** Throws what a handler threw since the last call, if any did. */
  rethrow(): void {
    const failure = this.failure;
    if (failure !== null) {
      this.failure = null;
      throw failure.error;
    }
  }

  /** Forgets everything noted, and ends a delivery in progress. */
  clear(): void {
    for (const list of [...this.lists, ...this.handed]) {
      list.clear();
    }
    this.woken.clear();
  }
}

/** Stands for a body in the order of events. */
function placeOf({ shapes }: RigidBody): number {
  return shapes[0]?.id ?? -1;
}
