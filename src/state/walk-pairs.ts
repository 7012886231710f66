import { Arbiter } from '../contact/arbiter.js';
import { BEFORE_STEP } from '../events/events.js';
import { END } from '../listeners.js';
import type { World } from '../world.js';
import { Order } from './order.js';
import { keepPair, LISTED } from './rows.js';
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
  const awake = tape.count(
    tape.holds ? 0 : pairs.reduce((count, pair) => count + (pair.awake && !pair.dead ? 1 : 0), 0),
  );
  const cut = tape.count(tape.holds ? 0 : world.events.ended.count);
  const count = tape.count(pairs.length);
  tape.require(awake + cut <= count && (count === 0 || shapes.length > 1), 'it has more pairs than there can be');
  places.ofShapes.clear();
  places.ofWorld.clear();
  const scratch = tape.checks && count > 0 ? new Arbiter(shapes[0]!, shapes[1]!) : null;
  tape.checksOnto(true);
  for (let i = 0; i < count; i += 1) {
    const isCut = i >= count - cut;
    const limit = isCut ? shapes.length : attached;
    const a = tape.index(tape.holds ? 0 : pairs[i]!.shapeA.stateIndex, limit);
    const b = tape.index(tape.holds ? 0 : pairs[i]!.shapeB.stateIndex, limit);
    const shapeA = shapes[a]!;
    const shapeB = shapes[b]!;
    tape.require(isCut || shapeA.id < shapeB.id, 'the shapes of a pair are not in order');
    if (tape.reads) {
      pairs[i] = isCut ? world.pairs.restoreCut(shapeA, shapeB) : world.pairs.restore(shapeA, shapeB);
    } else if (scratch !== null) {
      tape.require(i === 0 || i >= awake || isBefore(scratch, shapeA.id, shapeB.id), 'pairs are not in order');
      scratch.reuse(shapeA, shapeB);
      scratch.dead = isCut;
    }
    const pair = scratch ?? pairs[i]!;
    if (!isCut) {
      walkPlaces(tape, world, pair, a, b, i, places);
    }
    keepPair(tape, pair);
    if (tape.reads) {
      enlist(world, pair, i < awake, isCut);
    }
  }
  tape.checksOnto(false);
  link(tape, world, scene, places);
}

function isBefore({ shapeA, shapeB }: Arbiter, a: number, b: number): boolean {
  return shapeA.id < a || (shapeA.id === a && shapeB.id < b);
}

function enlist(world: World, pair: Arbiter, isAwake: boolean, isCut: boolean): void {
  if (isCut) {
    world.events.interaction(END, pair, BEFORE_STEP);
  } else if (isAwake) {
    pair.awake = true;
    world.pairs.sorted.push(pair);
  }
}

/** The order of the lists of shapes has a say in which wakes first; that of the world's has none. */
function walkPlaces(tape: Tape, world: World, pair: Arbiter, a: number, b: number, i: number, places: Places): void {
  tape.begins(LISTED);
  pair.listed = tape.flag(pair.listed);
  if (!pair.listed) {
    return;
  }
  pair.indexA = tape.integer(pair.indexA, 0, 0x3fffffff);
  pair.indexB = tape.integer(pair.indexB, 0, 0x3fffffff);
  if (tape.holds) {
    places.ofShapes.add(a, pair.indexA, i);
    places.ofShapes.add(b, pair.indexB, i);
  }
  if (!tape.hashes) {
    const { dynamicArbiters, staticArbiters } = world;
    const isInList = dynamicArbiters[pair.listIndex] === pair || staticArbiters[pair.listIndex] === pair;
    const place = tape.integer(isInList ? pair.listIndex : -1, -1, 0x3fffffff);
    const list = tape.flag(isInList && dynamicArbiters[pair.listIndex] === pair) ? 0 : 1;
    if (tape.holds && place >= 0) {
      places.ofWorld.add(list, place, i);
    }
  }
}

/** Puts the pairs into their lists. */
function link(tape: Tape, world: World, { pairs, shapes, attached }: Scene, { ofShapes, ofWorld }: Places): void {
  tape.require(ofShapes.sort(attached) && ofWorld.sort(2), 'pairs have no place in a list');
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
