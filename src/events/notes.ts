import type { RigidBody } from '../body.js';
import type { Constraint } from '../constraint/constraint.js';
import type { Arbiter } from '../contact/arbiter.js';
import type { Hit } from '../contact/hit.js';
import { type Listeners, NO_LISTENERS } from '../listeners.js';
import type { Shape } from '../shape/shape.js';
import type { World } from '../world.js';

/** An event, with the listeners present when it was noted, so that later changes do not affect it. */
export class Note {
  /** Whose event it is: a world, body or constraint, or shape A of an interaction. */
  own: Shape | RigidBody | Constraint | World | null = null;
  listeners: Listeners<unknown> = NO_LISTENERS;
  /** Events are sorted by these ids, then in the order in which they were noted. */
  idA = 0;
  idB = 0;
  /** The interaction; `null` for events of worlds, bodies and constraints. */
  arbiter: Arbiter | null = null;
  /** The body that an event of a world is about. */
  body: RigidBody | null = null;
  /** Shape B of an interaction, and its listeners. */
  other: Shape | null = null;
  otherListeners: Listeners<unknown> = NO_LISTENERS;
  /** The groups of shapes A and B. */
  group = 0;
  otherGroup = 0;
  hit: Hit | null = null;
  /** The listeners of the world of an interaction. */
  worldListeners: Listeners<unknown> = NO_LISTENERS;
}

function compare(a: Note, b: Note): number {
  return a.idA - b.idA || a.idB - b.idB;
}

/** The events of one type that are delivered together. Notes are used again and again. */
export class Notes {
  /** The first `count` are events; the rest are for reuse. */
  readonly all: Note[] = [];
  count = 0;
  private sorted = true;

  /** @param type which type, as a bit. */
  constructor(readonly type: number) {}

  /** Appends a note, for the caller to fill in. */
  add(idA: number, idB: number): Note {
    const { all, count } = this;
    if (count === all.length) {
      all.push(new Note());
    }
    const note = all[count]!;
    note.idA = idA;
    note.idB = idB;
    this.sorted &&= count === 0 || compare(all[count - 1]!, note) <= 0;
    this.count = count + 1;
    return note;
  }

  /** Sorts the list, which is mostly in order already. */
  sort(): void {
    if (!this.sorted) {
      const { all, count } = this;
      all
        .slice(0, count)
        .sort(compare)
        .forEach((note, i) => {
          all[i] = note;
        });
      this.sorted = true;
    }
  }

  /** Empties the list, and lets go of all objects. */
  clear(): void {
    for (let i = 0; i < this.count; i += 1) {
      const note = this.all[i]!;
      note.own = null;
      note.listeners = NO_LISTENERS;
      note.arbiter = null;
      note.body = null;
      note.other = null;
      note.otherListeners = NO_LISTENERS;
      note.hit = null;
      note.worldListeners = NO_LISTENERS;
    }
    this.count = 0;
    this.sorted = true;
  }
}
