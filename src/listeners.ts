/** All event types, in the order in which the events of one step are delivered; `preSolve` handlers run at once. */
const TYPES: readonly unknown[] = [
  'wake',
  'begin',
  'hit',
  'progress',
  'end',
  'sleep',
  'break',
  'preSolve',
  'nonfinite',
];

/** Event types as bits, so that one number says which ones an object has listeners for. */
export const WAKE = 1;
export const BEGIN = 2;
export const HIT = 4;
export const PROGRESS = 8;
export const END = 16;
export const SLEEP = 32;
export const BREAK = 64;
export const PRE_SOLVE = 128;
export const NON_FINITE = 256;

/** The types that an object of each kind has, as bits. */
export const OF_SHAPES = BEGIN | HIT | PROGRESS | END | PRE_SOLVE;
export const OF_BODIES = WAKE | SLEEP;
export const OF_CONSTRAINTS = WAKE | SLEEP | BREAK;
export const OF_WORLDS = BEGIN | HIT | PROGRESS | END | NON_FINITE;

/** The bit of a type by its name; 0 if it is not among those allowed. */
export function bitOf(name: unknown, allowed: number): number {
  const rank = TYPES.indexOf(name);
  return rank < 0 ? 0 : (1 << rank) & allowed;
}

/** The place of a type in the order of delivery, by its bit. */
export function rankOf(type: number): number {
  return 31 - Math.clz32(type);
}

/** How many ranks there are. */
export const RANKS = TYPES.length;

/** A listener as it was added. */
export interface Listener<H> {
  /** The event type, as a bit. */
  readonly type: number;
  readonly handler: H;
  /** Only for other shapes in these groups; `undefined`: for all. */
  readonly mask: number | undefined;
  /** For `preSolve`: the handler always decides alike. */
  readonly deterministic: boolean;
  /** For `hit`: slower ones are left out, m/s. */
  readonly minimumSpeed: number;
}

/** What identifies a listener of an object. */
type Key<H> = Pick<Listener<H>, 'type' | 'handler' | 'mask'>;

/**
 * The listeners of an object in the order in which they were added. Never changed in place: adding and removing make a new list, so an
 * event that keeps the list it found when it was queued is not touched by what happens later.
 */
export class Listeners<H> {
  /** The types that there are listeners for, as bits. */
  readonly types: number;

  constructor(readonly entries: readonly Listener<H>[]) {
    this.types = entries.reduce((types, { type }) => types | type, 0);
  }

  /** The list with a listener appended, or `null` if the same (type, handler, mask) is in it. */
  with(added: Listener<H>): Listeners<H> | null {
    return this.find(added) ? null : new Listeners([...this.entries, added]);
  }

  /** The list without the listener, or `null` if it is not in it. */
  without(removed: Key<H>): Listeners<H> | null {
    const found = this.find(removed);
    return found ? new Listeners(this.entries.filter((entry) => entry !== found)) : null;
  }

  private find({ type, handler, mask }: Key<H>): Listener<H> | undefined {
    return this.entries.find((entry) => entry.type === type && entry.handler === handler && entry.mask === mask);
  }
}

/** The empty list, shared by all objects without listeners. */
export const NO_LISTENERS = /* @__PURE__ */ new Listeners<never>([]);

/** A listener of a world, body or constraint, which has only type and handler. */
export function plainListener<H>(type: number, handler: H): Listener<H> {
  return { type, handler, mask: undefined, deterministic: false, minimumSpeed: 0 };
}

/** Whether a listener is for other shapes of this group. */
export function admits({ mask }: Listener<unknown>, group: number): boolean {
  return mask === undefined || (mask & group) !== 0;
}

/** An object with listeners. */
interface Heard<H> {
  listeners: Listeners<H>;
}

/**
 * Adds a listener to an object, and wakes `wakes`.
 *
 * @returns `false`, without effect, for type 0 and if the same (type, handler, mask) is present.
 */
export function addListener<H>(object: Heard<H>, added: Listener<H>, wakes: { wake(): void } | null): boolean {
  return added.type !== 0 && replace(object, object.listeners.with(added), wakes);
}

/** Removes a listener, and wakes `wakes`. @returns `false`, without effect, if it is not there. */
export function removeListener<H>(object: Heard<H>, removed: Key<H>, wakes: { wake(): void } | null): boolean {
  return replace(object, object.listeners.without(removed), wakes);
}

function replace<H>(object: Heard<H>, list: Listeners<H> | null, wakes: { wake(): void } | null): boolean {
  if (list === null) {
    return false;
  }
  object.listeners = list;
  wakes?.wake();
  return true;
}
