import { DYNAMIC } from '../body-kind.js';
import type { Arbiter } from '../contact/arbiter.js';
import { takeOut } from '../math/list.js';
import type { World } from '../world.js';

// The lists of arbiters that users see in a world. `pack-contacts.ts` sorts them in each step.

/** Puts an arbiter into the world's list that it belongs to. */
export function joinLists(world: World, pair: Arbiter): void {
  const dynamic = pair.bodyA.kind === DYNAMIC && pair.bodyB.kind === DYNAMIC;
  pair.listIndex = (dynamic ? world.dynamicArbiters : world.staticArbiters).push(pair) - 1;
}

/** Takes an arbiter out of the world's list that it is in. */
export function leaveLists(world: World, pair: Arbiter): void {
  removeFrom(world.dynamicArbiters, pair);
  removeFrom(world.staticArbiters, pair);
}

function removeFrom(list: Arbiter[], pair: Arbiter): void {
  const at = pair.listIndex;
  const moved = list[at] === pair ? takeOut(list, at) : null;
  if (moved !== null) moved.listIndex = at;
}
