import type { RigidBody } from '../../body.js';
import { DYNAMIC } from '../../body-kind.js';
import type { Arbiter } from '../../contact/arbiter.js';
import { FOUND_LATE } from '../../events/events.js';
import { grown } from '../../math/doubles.js';
import { List } from '../../math/list.js';
import type { World } from '../../world.js';
import { solveImpacts } from './impact.js';
import { beginLate } from './strike.js';

// Surfaces that were apart when the step began and met during it, as the solver expected: the interaction begins late in the step. If they
// met in the last sub-step, they still have the speed at which they approached at its end. That is an impact, solved together with all
// others at once that are of the same bodies.

/** The pairs that met: scratch, like everything below. */
const met = /* @__PURE__ */ new List<Arbiter>();
/** For each whether its impact is solved; and those that are solved at once. */
const isSolved: boolean[] = [];
const pairs = /* @__PURE__ */ new List<Arbiter>();
/**
 * The sides of pair k are 2 k and 2 k + 1. Linked lists of the sides of each dynamic body: by slot the last side, plus 1, and by side the
 * one before.
 */
let lastSide = /* @__PURE__ */ new Int32Array(0);
const sideBefore: number[] = [];

export function noteMet(pair: Arbiter): void {
  met.add(pair);
}

/** Solves the impacts of all pairs that met, and tells of them. */
export function strikeMet(world: World): void {
  if (met.count === 0) {
    return;
  }
  if (lastSide.length <= world.liveDynamics.length) {
    lastSide = new Int32Array(grown(world.liveDynamics.length + 1));
  }
  for (let k = 0; k < met.count; k += 1) {
    isSolved[k] = false;
    link(2 * k, met.items[k]!.bodyA);
    link(2 * k + 1, met.items[k]!.bodyB);
  }
  for (let k = 0; k < met.count; k += 1) {
    if (!isSolved[k]) {
      listTogether(k);
      solveImpacts(world, pairs);
    }
  }
  for (let k = 0; k < met.count; k += 1) {
    const pair = met.items[k]!;
    pair.noteImpact();
    beginLate(world, pair);
    world.events.hit(pair, FOUND_LATE);
  }
  lastSide.fill(0);
  met.clear();
}

function link(side: number, { kind, slot }: RigidBody): void {
  if (kind === DYNAMIC) {
    sideBefore[side] = lastSide[slot]!;
    lastSide[slot] = side + 1;
  }
}

/**
 * Lists in `pairs` a pair and all others of its dynamic body with the same partner or, if that partner does not give way, with any other
 * that does not.
 */
function listTogether(first: number): void {
  pairs.clear();
  const { bodyA, bodyB } = met.items[first]!;
  const isA = bodyA.kind === DYNAMIC;
  const body = isA ? bodyA : bodyB;
  const partner = isA ? bodyB : bodyA;
  for (let side = lastSide[body.slot]!; side > 0; side = sideBefore[side - 1]!) {
    const k = (side - 1) >> 1;
    const other = met.items[k]!.bodyA === body ? met.items[k]!.bodyB : met.items[k]!.bodyA;
    if (!isSolved[k] && (other === partner || (other.kind !== DYNAMIC && partner.kind !== DYNAMIC))) {
      isSolved[k] = true;
      pairs.add(met.items[k]!);
    }
  }
}
