import type { Arbiter } from '../contact/arbiter.js';
import { DEAD } from '../contact/bits.js';
import { isBefore, NOT_REPORTED, type Pairs } from '../contact/pairs.js';
import type { Shape } from '../shape/shape.js';

// The pairs of a world that is being restored. Pairs that are still there are claimed, missing ones are made, and the rest is dropped.

/** Stands for the step in which the broadphase reported a pair: the pair was claimed. */
const CLAIMED = -2;

/** Index at which the next pair is looked for among the pairs that were awake, as both lists are in the order of their shapes' ids. */
let next = 0;
/** How many pairs in the table are not claimed yet. */
let unclaimed = 0;

/** Takes all pairs out of the lists. Those in the table can be claimed. */
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

/** Claims the pair of two shapes, or makes one. It is in no list yet, and what a step sets anyway is not set here. */
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

/** Finds the pair of two shapes; mostly it is the one after the last that was found. */
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

/** Makes a pair that was cut off, and that an `end` event names. */
export function claimCut(pairs: Pairs, shapeA: Shape, shapeB: Shape): Arbiter {
  const pair = pairs.make(shapeA, shapeB);
  pair.mark(DEAD);
  pairs.cut.push(pair);
  return pair;
}

/** Drops the pairs that were not claimed. What moves up in the table has been looked at, or will be. */
export function endClaims(pairs: Pairs): void {
  const { earlier, table, sightings } = pairs;
  // Mostly these are pairs that were awake, which lie in memory in this order.
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
