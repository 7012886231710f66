import type { Arbiter } from '../contact/arbiter.js';
import { DEAD } from '../contact/bits.js';
import { isBefore, NOT_REPORTED, type Pairs } from '../contact/pairs.js';
import type { Shape } from '../shape/shape.js';

// The pairs of a world that is restored: those that are there are brought back, what is missing is made, and what is left over goes.

/** In place of a step in which the broadphase reported a pair: it was brought back. */
const CLAIMED = -2;

/** Where among the awake pairs that there were the next one is looked for, as both are in the order of their shapes' ids. */
let next = 0;
/** How many are left in the table that were not brought back. */
let unclaimed = 0;

/** Takes all pairs out of the lists; those in the table may be brought back. */
export function beginClaims(pairs: Pairs): void {
  const { sorted, earlier } = pairs;
  for (let i = 0; i < sorted.count; i += 1) {
    earlier.add(sorted.items[i]!);
  }
  next = 0;
  unclaimed = pairs.table.size;
  pairs.freeCut();
  pairs.sightings.fill(NOT_REPORTED);
  sorted.clear();
  pairs.arriving.clear();
}

/** A pair that is in no list yet, made unless there is one. Where a step sets all, nothing of it is set here. */
export function claim(pairs: Pairs, shapeA: Shape, shapeB: Shape): Arbiter {
  let pair = find(pairs, shapeA, shapeB);
  if (pair !== null && pairs.sightings[pair.number] === NOT_REPORTED) {
    unclaimed -= 1;
    pair.revive();
  } else {
    pair = pairs.make(shapeA, shapeB);
    pairs.table.add(pair);
  }
  pairs.sightings[pair.number] = CLAIMED;
  return pair;
}

/** Mostly it is the one after the last. */
function find(pairs: Pairs, shapeA: Shape, shapeB: Shape): Arbiter | null {
  const { items, count } = pairs.earlier;
  for (; next < count; next += 1) {
    const pair = items[next]!;
    if (pair.shapeA === shapeA && pair.shapeB === shapeB && !pair.is(DEAD)) {
      next += 1;
      return pair;
    }
    if (!isBefore(pair, shapeA, shapeB)) {
      break;
    }
  }
  return pairs.find(shapeA, shapeB);
}

/** A pair that was cut off, and is named by an `end` event. */
export function claimCut(pairs: Pairs, shapeA: Shape, shapeB: Shape): Arbiter {
  const pair = pairs.make(shapeA, shapeB);
  pair.mark(DEAD);
  pairs.cut.push(pair);
  return pair;
}

/** Drops the pairs that were not brought back. What is moved up in the table has been looked at, or will be. */
export function endClaims(pairs: Pairs): void {
  const { earlier, table, sightings } = pairs;
  // Mostly those that were awake, which lie in memory as they are walked through.
  for (let i = 0; i < earlier.count && unclaimed > 0; i += 1) {
    const pair = earlier.items[i]!;
    if (!pair.is(DEAD) && sightings[pair.number] === NOT_REPORTED) {
      unclaimed -= 1;
      pairs.retire(pair);
    }
  }
  earlier.clear();
  const { arbiters } = table;
  for (let i = 0; unclaimed > 0; i += 1) {
    for (let pair = arbiters[i]!; pair !== null && sightings[pair.number] === NOT_REPORTED; pair = arbiters[i]!) {
      unclaimed -= 1;
      pairs.retire(pair);
    }
  }
  sightings.fill(NOT_REPORTED);
}
