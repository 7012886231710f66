import { DYNAMIC } from '../body-kind.js';
import * as g from '../collide/layout.js';
import type { Arbiter } from '../contact/arbiter.js';
import { AWAKE, DEAD, LISTED } from '../contact/bits.js';
import * as c from '../contact/layout.js';
import type { Shape } from '../shape/shape.js';
import type { Audit } from './audit.js';
import { UNIT_TOLERANCE } from './bodies.js';

/** Checks arbiters, the table of pairs, the list of awake ones, and the pools. */
export function auditPairs(audit: Audit): void {
  const { world } = audit;
  auditSorted(audit);
  auditTable(audit);
  auditPools(audit);
  for (const body of world.rigidBodies) {
    for (const shape of body.shapes) {
      shape.arbiters.forEach((pair, i) => {
        const index = pair.shapeA === shape ? pair.indexA : pair.shapeB === shape ? pair.indexB : -1;
        audit.demand(index === i, pair, `its index in the arbiters of shape ${shape.id} must be ${i}, got ${index}`);
        auditListed(audit, pair);
      });
    }
  }
  for (const list of [world.dynamicArbiters, world.staticArbiters]) {
    list.forEach((pair, i) => {
      audit.demand(
        pair.is(LISTED) && !pair.sleeping,
        pair,
        'is in a list of the world, but asleep or in none of its shapes',
      );
      const belongs = list === listOf(audit, pair);
      audit.demand(belongs, pair, 'is in a list of the world that it does not belong to');
      audit.demand(pair.listIndex === i, pair, `listIndex must be ${i}, got ${pair.listIndex}`);
    });
  }
}

/** The world's list that a pair is in, unless it sleeps. */
function listOf({ world }: Audit, { bodyA, bodyB }: Arbiter): readonly Arbiter[] {
  return bodyA?.kind === DYNAMIC && bodyB?.kind === DYNAMIC ? world.dynamicArbiters : world.staticArbiters;
}

/** Checks a pair that its shapes list. */
function auditListed(audit: Audit, pair: Arbiter): void {
  const { world } = audit;
  const { shapeA, shapeB, bodyA, bodyB } = pair;
  audit.demand(pair.is(LISTED) && !pair.is(DEAD), pair, 'is listed by a shape, but not as it is');
  audit.demand(shapeA.id < shapeB.id && bodyA !== bodyB, pair, 'must be of two bodies, the shape of lower id first');
  audit.demand(bodyA?.owner === world && bodyB?.owner === world, pair, 'must be of bodies in the world');
  const isListed = shapeA.arbiters[pair.indexA] === pair && shapeB.arbiters[pair.indexB] === pair;
  audit.demand(isListed, pair, 'must be listed by both shapes');
  audit.demand(pair.sensor === (shapeA.sensor || shapeB.sensor), pair, 'must know whether one is a sensor');
  audit.demand(!(pair.active && pair.sleeping), pair, 'cannot be both active and asleep');
  audit.demand(world.pairs.find(shapeA, shapeB) === pair, pair, 'must be in the table of pairs');
  if (pair.sleeping) {
    audit.demand(bodyA.asleep && bodyB.asleep, pair, 'is asleep, but a body of it is not');
  } else {
    const isThere = listOf(audit, pair)[pair.listIndex] === pair;
    audit.demand(isThere, pair, 'must be in the list of the world that it belongs to');
    audit.demand(pair.is(AWAKE), pair, 'is not asleep, but not among the awake pairs either');
  }
  auditContacts(audit, pair);
}

function auditContacts(audit: Audit, pair: Arbiter): void {
  const { shown, sensor, count, numbers: n, at: o } = pair;
  audit.demand(shown >= 0 && shown <= 2 && !(sensor && shown > 0), pair, `cannot have ${shown} contacts`);
  if (sensor || !pair.active) {
    return;
  }
  const length = n[o + g.NX]! * n[o + g.NX]! + n[o + g.NY]! * n[o + g.NY]!;
  audit.demand(count === 0 || Math.abs(length - 1) < UNIT_TOLERANCE, pair, 'normal must be a unit vector');
  for (let i = 0; i < count; i += 1) {
    audit.finite(pair, `x of contact ${i}`, n[o + g.X0 + g.POINT * i]!);
    audit.finite(pair, `y of contact ${i}`, n[o + g.Y0 + g.POINT * i]!);
    audit.finite(pair, `separation of contact ${i}`, n[o + g.S0 + g.POINT * i]!);
  }
  for (const at of [0, c.IMPULSES]) {
    audit.nonNegative(pair, 'normal impulse', n[o + c.STEP_NORMAL + at]!);
    for (const of of [c.NORMAL, c.TANGENT, c.STEP_NORMAL, c.STEP_TANGENT]) {
      audit.finite(pair, 'impulse', n[o + of + at]!);
    }
  }
  audit.finite(pair, 'rolling impulse', n[o + c.STEP_ROLL]!);
  audit.demand(!Number.isNaN(n[o + c.ELASTICITY]), pair, 'elasticity must be a number');
  audit.nonNegative(pair, 'static friction', n[o + c.STATIC_FRICTION]!);
  audit.nonNegative(pair, 'dynamic friction', n[o + c.DYNAMIC_FRICTION]!);
  audit.nonNegative(pair, 'rolling friction', n[o + c.ROLLING_FRICTION]!);
}

/** Checks that awake pairs are in order, each once; those that were cut off wait there to be dropped. */
function auditSorted(audit: Audit): void {
  const { world } = audit;
  const { table, reportedCount } = world.pairs;
  const sorted = world.pairs.sorted.items.slice(0, world.pairs.sorted.count);
  const arriving = world.pairs.arriving.items.slice(0, world.pairs.arriving.count);
  audit.demand(reportedCount === 0, world, 'reported pairs must be made within the step');
  audit.distinct([...sorted, ...arriving], world, 'the list of awake pairs');
  let before: Arbiter | null = null;
  for (const pair of sorted) {
    if (pair.is(DEAD)) {
      continue;
    }
    const isLater =
      before === null ||
      pair.shapeA.id > before.shapeA.id ||
      (pair.shapeA.id === before.shapeA.id && pair.shapeB.id > before.shapeB.id);
    audit.demand(isLater, pair, 'awake pairs must be in the order of their shapes');
    before = pair;
  }
  for (const pair of [...sorted, ...arriving]) {
    audit.demand(pair.is(AWAKE), pair, 'is in the list of awake pairs, and must know it');
    audit.demand(pair.is(DEAD) || table.find(pair.shapeA, pair.shapeB) === pair, pair, 'must be in the table of pairs');
  }
}

function auditTable(audit: Audit): void {
  const { world } = audit;
  const { table } = world.pairs;
  let count = 0;
  table.arbiters.forEach((pair) => {
    if (pair !== null) {
      count += 1;
      audit.demand(!pair.is(DEAD), pair, 'is in the table of pairs, though it was cut off');
      audit.demand(table.find(pair.shapeA, pair.shapeB) === pair, pair, 'must be found in the table of pairs');
      audit.demand(pair.is(AWAKE) || pair.sleeping, pair, 'is in the table, but neither awake nor asleep');
      const isListed = pair.shapeA.arbiters[pair.indexA] === pair && pair.shapeB.arbiters[pair.indexB] === pair;
      audit.demand(!pair.is(LISTED) || isListed, pair, 'must be listed by both shapes');
    }
  });
  audit.demand(table.size === count, world, `the table of pairs must count ${count}, got ${table.size}`);
}

/** Checks that pairs in a pool are not in use. */
function auditPools(audit: Audit): void {
  const { world } = audit;
  const { pool, cut, cutBefore, table } = world.pairs;
  const waiting = new Set<Arbiter>();
  const note = (pair: Arbiter): void => {
    audit.demand(!waiting.has(pair), pair, 'is in a pool twice');
    waiting.add(pair);
  };
  [...cut, ...cutBefore].forEach(note);
  for (let pair = pool; pair !== null; pair = pair.next) {
    note(pair);
  }
  for (const pair of waiting) {
    if (pair.shapeA === null) continue;
    audit.demand(table.find(pair.shapeA, pair.shapeB) !== pair, pair, 'is in a pool and in the table of pairs');
    audit.demand(
      !isIn(pair.shapeA, pair.indexA, pair) && !isIn(pair.shapeB, pair.indexB, pair),
      pair,
      'is in use and in a pool',
    );
  }
  for (let pair = pool; pair !== null; pair = pair.next) {
    audit.demand(!pair.is(AWAKE), pair, 'is in the pool and among the awake pairs');
  }
}

function isIn(shape: Shape, index: number, pair: Arbiter): boolean {
  return shape.arbiters[index] === pair;
}
