/**
 * A listener as it was added. The lists are never changed in place: adding and removing make a new one, so an event that
 * keeps the list it found when it was queued is not touched by what happens later.
 */
export interface Listener<H> {
  readonly type: string;
  readonly handler: H;
  readonly mask: number | undefined;
  readonly deterministic: boolean;
}

export type Listeners<H> = readonly Listener<H>[];

/** The list of an object without listeners, one for all. */
export const NO_LISTENERS: readonly never[] = [];

function indexOf<H>(list: Listeners<H>, type: string, handler: H, mask: number | undefined): number {
  return list.findIndex((entry) => entry.type === type && entry.handler === handler && entry.mask === mask);
}

/** The list with the listener appended, or `null` if the same (type, handler, mask) is in it. */
export function withListener<H>(list: Listeners<H>, added: Listener<H>): Listeners<H> | null {
  return indexOf(list, added.type, added.handler, added.mask) >= 0 ? null : [...list, added];
}

/** The list without the listener, or `null` if it is not in it. */
export function withoutListener<H>(
  list: Listeners<H>,
  type: string,
  handler: H,
  mask: number | undefined,
): Listeners<H> | null {
  const index = indexOf(list, type, handler, mask);
  return index < 0 ? null : list.filter((_, i) => i !== index);
}

/** Gives an object a list that was made for it and wakes it; `null` means that nothing changed. @returns whether it did. */
export function takeListeners<H>(
  object: { listeners: Listeners<H> },
  list: Listeners<H> | null,
  wakes: { wake(): void } | null,
): boolean {
  if (list === null) {
    return false;
  }
  object.listeners = list;
  wakes?.wake();
  return true;
}
