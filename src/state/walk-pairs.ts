import { Arbiter } from '../contact/arbiter.js';
import { AWAKE, DEAD, LISTED } from '../contact/bits.js';
import { isBefore } from '../contact/pairs.js';
import { BEFORE_STEP } from '../events/events.js';
import { END } from '../listeners.js';
import type { World } from '../world.js';
import { claim, claimCut, endClaims } from './claims.js';
import { Order } from './order.js';
import { beginPairs, keepPair } from './rows.js';
import type { Scene } from './scene.js';
import type { Tape } from './tape.js';

/** The places of pairs in lists: in those of their shapes, and in those of the world. */
interface Places {
  readonly ofShapes: Order;
  readonly ofWorld: Order;
}

/** Scratch. */
const places: Places = { ofShapes: /* @__PURE__ */ new Order(), ofWorld: /* @__PURE__ */ new Order() };

/** Passes all pairs: awake ones in order, sleeping ones, then those that only events name. */
export function walkPairs(tape: Tape, world: World, scene: Scene): void {
  const { pairs, shapes, attached } = scene;
  const awake = tape.count(scene.awake);
  const cut = tape.count(tape.holds ? 0 : world.events.ended.count);
  const count = tape.count(pairs.length);
  tape.require(awake + cut <= count && (count === 0 || shapes.length > 1));
  places.ofShapes.clear();
  places.ofWorld.clear();
  const scratch = tape.checks && count > 0 ? new Arbiter(shapes[0]!, shapes[1]!, 0) : null;
  beginPairs();
  tape.checksOnto(true);
  for (let i = 0; i < count; i += 1) {
    const isCut = i >= count - cut;
    const limit = isCut ? shapes.length : attached;
    const a = tape.index(tape.writes ? pairs[i]!.shapeA.stateIndex : 0, limit);
    const b = tape.index(tape.writes ? pairs[i]!.shapeB.stateIndex : 0, limit);
    if (scratch !== null) {
      const isNext = i === 0 || i >= awake || isBefore(scratch, shapes[a]!, shapes[b]!);
      tape.require(isNext && (isCut || shapes[a]!.id < shapes[b]!.id));
      scratch.reuse(shapes[a]!, shapes[b]!);
      scratch.put(DEAD, isCut);
    }
    const pair = scratch ?? (tape.reads ? (isCut ? claimCut : claim)(world.pairs, shapes[a]!, shapes[b]!) : pairs[i]!);
    keepPair(tape, pair);
    if (pair.is(LISTED)) {
      keepPlaces(tape, world, pair, a, b);
    }
    if (tape.reads) {
      enlist(world, pair, i < awake, isCut);
    }
  }
  tape.checksOnto(false);
  if (tape.reads) {
    endClaims(world.pairs);
  }
  if (tape.checks) {
    tape.require(places.ofShapes.isRight(attached) && places.ofWorld.isRight(2));
  }
}

/**
 * Passes the places of a pair. In the lists of its shapes `a` and `b`, as their order influences what wakes first; and in those of the
 * world, whose order has no influence: list 0 has the dynamic pairs, 1 the static ones, and place −1 means neither.
 */
function keepPlaces(tape: Tape, world: World, pair: Arbiter, a: number, b: number): void {
  const { listIndex } = pair;
  pair.indexA = tape.word(pair.indexA);
  pair.indexB = tape.word(pair.indexB);
  if (tape.hashes) {
    return;
  }
  let list = 0;
  let place = -1;
  if (tape.writes) {
    list = world.dynamicArbiters[listIndex] === pair ? 0 : 1;
    place = list === 0 || world.staticArbiters[listIndex] === pair ? listIndex : -1;
  }
  const where = tape.word(2 * place + list);
  if (tape.checks) {
    places.ofShapes.add(a, pair.indexA);
    places.ofShapes.add(b, pair.indexB);
    if (where >= 0) {
      places.ofWorld.add(where & 1, where >> 1);
    }
  } else if (tape.reads) {
    put(pair.shapeA.arbiters, pair.indexA, pair);
    put(pair.shapeB.arbiters, pair.indexB, pair);
    if (where >= 0) {
      pair.listIndex = where >> 1;
      put((where & 1) === 0 ? world.dynamicArbiters : world.staticArbiters, pair.listIndex, pair);
    }
  }
}

/**
 * Puts a pair at its place in a list that has no holes in the end. Until then others stand in for what is missing, as engines make a list
 * with holes slow for good.
 */
function put(list: Arbiter[], place: number, pair: Arbiter): void {
  while (list.length <= place) {
    list.push(pair);
  }
  list[place] = pair;
}

function enlist(world: World, pair: Arbiter, isAwake: boolean, isCut: boolean): void {
  if (isCut) {
    world.events.interaction(END, pair, BEFORE_STEP);
  } else if (isAwake) {
    pair.mark(AWAKE);
    world.pairs.sorted.add(pair);
  }
}
