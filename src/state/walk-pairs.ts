import { Arbiter } from '../contact/arbiter.js';
import { BEFORE_STEP } from '../events/events.js';
import { END } from '../listeners.js';
import type { World } from '../world.js';
import { Order } from './order.js';
import { keepPair } from './rows.js';
import type { Scene } from './scene.js';
import { Row, type Tape } from './tape.js';

/** Where the pairs are: in the lists of their shapes, and in those of the world. */
interface Places {
  readonly ofShapes: Order;
  readonly ofWorld: Order;
}

/** Scratch. */
const places: Places = { ofShapes: new Order(), ofWorld: new Order() };

/** Which shapes, and where in lists. */
const A = 0;
const B = 1;
const LISTED = 2;
const PLACE_A = 3;
const PLACE_B = 4;
/** Which of the world's lists, 0 the dynamic one; −1 for the place: in none. */
const LIST = 5;
const PLACE = 6;
export const endsRow = /* @__PURE__ */ new Row(7, 0);

/** All pairs: awake ones in order, sleeping ones, then those that only events name. */
export function walkPairs(tape: Tape, world: World, scene: Scene): void {
  const { pairs, shapes, attached } = scene;
  const awake = tape.count(
    tape.holds ? 0 : pairs.reduce((count, pair) => count + (pair.awake && !pair.dead ? 1 : 0), 0),
  );
  const cut = tape.count(tape.holds ? 0 : world.events.ended.count);
  const count = tape.count(pairs.length);
  tape.require(awake + cut <= count && (count === 0 || shapes.length > 1));
  places.ofShapes.clear();
  places.ofWorld.clear();
  const scratch = tape.checks && count > 0 ? new Arbiter(shapes[0]!, shapes[1]!, 0) : null;
  tape.checksOnto(true);
  const { integers: ends } = endsRow;
  for (let i = 0; i < count; i += 1) {
    const isCut = i >= count - cut;
    if (tape.writes) {
      putEnds(tape, world, pairs[i]!);
    }
    tape.pass(endsRow);
    const limit = isCut ? shapes.length : attached;
    tape.require(isWithin(ends[A]!, limit) && isWithin(ends[B]!, limit));
    if (tape.holds) {
      pairs[i] = takeEnds(tape, world, scene, scratch, i, i < awake, isCut);
    }
    keepPair(tape, pairs[i]!);
    if (tape.reads) {
      enlist(world, pairs[i]!, i < awake, isCut);
    }
  }
  tape.checksOnto(false);
  if (tape.reads) {
    world.pairs.dropUnclaimed();
  }
  link(tape, world, scene, places);
}

function isWithin(place: number, end: number): boolean {
  return place >= 0 && place < end;
}

/** Which shapes a pair is of, and where it is in their lists, of which the order has a say in which wakes first; that of the world's has none. */
function putEnds(tape: Tape, world: World, pair: Arbiter): void {
  const { integers: ends } = endsRow;
  const { listed, listIndex } = pair;
  const isDynamic = listed && world.dynamicArbiters[listIndex] === pair;
  const isInList = isDynamic || (listed && world.staticArbiters[listIndex] === pair);
  ends[A] = pair.shapeA.stateIndex;
  ends[B] = pair.shapeB.stateIndex;
  ends[LISTED] = listed ? 1 : 0;
  if (listed) {
    ends[PLACE_A] = pair.indexA;
    ends[PLACE_B] = pair.indexB;
    ends[LIST] = isDynamic && !tape.hashes ? 0 : 1;
    ends[PLACE] = isInList && !tape.hashes ? listIndex : -1;
  }
}

/** The pair that is meant; on a check `scratch` in its place. */
function takeEnds(
  tape: Tape,
  world: World,
  { shapes }: Scene,
  scratch: Arbiter | null,
  i: number,
  isAwake: boolean,
  isCut: boolean,
): Arbiter {
  const { integers: ends } = endsRow;
  const shapeA = shapes[ends[A]!]!;
  const shapeB = shapes[ends[B]!]!;
  tape.require(isCut || shapeA.id < shapeB.id);
  let pair = scratch;
  if (pair === null) {
    pair = isCut ? world.pairs.restoreCut(shapeA, shapeB) : world.pairs.restore(shapeA, shapeB);
  } else {
    tape.require(i === 0 || !isAwake || isBefore(pair, shapeA.id, shapeB.id));
    pair.reuse(shapeA, shapeB);
    pair.dead = isCut;
  }
  pair.listed = !isCut && ends[LISTED] === 1;
  if (pair.listed) {
    pair.indexA = ends[PLACE_A]!;
    pair.indexB = ends[PLACE_B]!;
    places.ofShapes.add(ends[A]!, pair.indexA, i);
    places.ofShapes.add(ends[B]!, pair.indexB, i);
    if (ends[PLACE] !== -1) {
      places.ofWorld.add(ends[LIST] === 0 ? 0 : 1, ends[PLACE]!, i);
    }
  }
  return pair;
}

function isBefore({ shapeA, shapeB }: Arbiter, a: number, b: number): boolean {
  return shapeA.id < a || (shapeA.id === a && shapeB.id < b);
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
