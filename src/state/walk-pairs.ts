import { Arbiter } from '../contact/arbiter.js';
import { isBefore } from '../contact/pairs.js';
import { BEFORE_STEP } from '../events/events.js';
import { END } from '../listeners.js';
import type { World } from '../world.js';
import { claim, claimCut, endClaims } from './claims.js';
import { Order } from './order.js';
import { beginPairs, keepPair } from './rows.js';
import type { Scene } from './scene.js';
import type { Tape } from './tape.js';

/** Where the pairs are: in the lists of their shapes, and in those of the world. */
interface Places {
  readonly ofShapes: Order;
  readonly ofWorld: Order;
}

/** Scratch. */
const places: Places = { ofShapes: new Order(), ofWorld: new Order() };

/** All pairs: awake ones in order, sleeping ones, then those that only events name. */
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
      scratch.dead = isCut;
      pairs[i] = scratch;
    } else if (tape.reads) {
      pairs[i] = (isCut ? claimCut : claim)(world.pairs, shapes[a]!, shapes[b]!);
    }
    const pair = pairs[i]!;
    keepPair(tape, pair);
    if (pair.listed) {
      keepPlaces(tape, world, pair, a, b, i);
    }
    if (tape.reads) {
      enlist(world, pair, i < awake, isCut);
    }
  }
  tape.checksOnto(false);
  if (tape.reads) {
    endClaims(world.pairs);
  }
  link(tape, world, scene, places);
}

/**
 * Where a pair is in the lists of its shapes `a` and `b`, of which the order has a say in which wakes first, and in the world's, whose order has none: the dynamic one is 0, the static one 1; place −1: in none.
 */
function keepPlaces(tape: Tape, world: World, pair: Arbiter, a: number, b: number, i: number): void {
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
  if (tape.holds) {
    places.ofShapes.add(a, pair.indexA, i);
    places.ofShapes.add(b, pair.indexB, i);
    if (where >= 0) {
      places.ofWorld.add(where & 1, where >> 1, i);
    }
  }
}

function enlist(world: World, pair: Arbiter, isAwake: boolean, isCut: boolean): void {
  if (isCut) {
    world.events.interaction(END, pair, BEFORE_STEP);
  } else if (isAwake) {
    pair.awake = true;
    world.pairs.sorted.add(pair);
  }
}

/** Puts the pairs into their lists. */
function link(tape: Tape, world: World, { pairs, shapes, attached }: Scene, { ofShapes, ofWorld }: Places): void {
  tape.require(ofShapes.sort(attached) && ofWorld.sort(2));
  if (!tape.reads) {
    return;
  }
  for (let shape = 0; shape < attached; shape += 1) {
    const { arbiters } = shapes[shape]!;
    for (let at = ofShapes.start(shape); at < ofShapes.start(shape + 1); at += 1) {
      arbiters.push(pairs[ofShapes.item(at)]!);
    }
  }
  for (let list = 0; list < 2; list += 1) {
    const arbiters = list === 0 ? world.dynamicArbiters : world.staticArbiters;
    for (let at = ofWorld.start(list); at < ofWorld.start(list + 1); at += 1) {
      const pair = pairs[ofWorld.item(at)]!;
      pair.listIndex = arbiters.push(pair) - 1;
    }
  }
}
