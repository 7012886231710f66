import type { RigidBody } from '../body.js';
import type { Constraint } from '../constraint/constraint.js';
import type { Arbiter } from '../contact/arbiter.js';
import type { Hit } from '../contact/hit.js';
import { type Listeners, NO_LISTENERS } from '../listeners.js';
import type { Shape } from '../shape/shape.js';
import type { World } from '../world.js';

/** An event, with the listeners present when it was noted, so that later changes do not touch it. */
export class Note {
  /** A world, body or constraint, or shape A of an interaction. */
  own: Shape | RigidBody | Constraint | World | null = null;
  listeners: Listeners<unknown> = NO_LISTENERS;
  /** Events are delivered by these ids, then as they were noted. */
  idA = 0;
  idB = 0;
  /** Of an interaction; `null` for worlds, bodies and constraints. */
  arbiter: Arbiter | null = null;
  /** Whom a world's event is about. */
  body: RigidBody | null = null;
  /** Shape B, and its listeners. */
  other: Shape | null = null;
  otherListeners: Listeners<unknown> = NO_LISTENERS;
  /** Their groups. */
  group = 0;
  otherGroup = 0;
  hit: Hit | null = null;
  /** Those of the world that an interaction is in. */
  worldListeners: Listeners<unknown> = NO_LISTENERS;
}

function compare(a: Note, b: Note): number {
  return a.idA - b.idA || a.idB - b.idB;
}

/** The events of one type that are delivered together. Its notes are used again and again. */
export class Notes {
  /** What lies beyond the count is for later. */
  readonly all: Note[] = [];
  count = 0;
  private sorted = true;

  /** @param type which type, as a bit. */
  constructor(readonly type: number) {}

  /** A note to be filled in, at the end of the list. */
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

  /** Orders the list; most come in order. */
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

  /** Drops everything, and holds on to nothing. */
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
