import { MOST_GUESTS } from '../../../config-joints.js';
import { grown } from '../../../math/doubles.js';
import { rootOf, unite } from '../../../math/sets.js';
import type { World } from '../../../world.js';
import { type ContactBatch, recordAt, type SolverData } from '../../data.js';
import * as d from '../../layout.js';
import type { Group } from '../joint-data.js';
import { isMoving, markBodies } from '../joint-numbers.js';

// A company is all bodies that exchange energy: those that touch or are tied to each other, directly or by way of others. The guests of a
// group are the bodies of its company that are not its own.

// Scratch, by slot, for all worlds.

/** Disjoint sets of `math/sets.ts`, one for each company. */
let parent = /* @__PURE__ */ new Int32Array(0);
/** The next body of the same company; 0 at its end. */
let next = /* @__PURE__ */ new Int32Array(0);
/** For the body that stands for a company: the first body of that, and how many there are. */
let first = /* @__PURE__ */ new Int32Array(0);
let size = /* @__PURE__ */ new Int32Array(0);
/** 1 if something drives it. */
let driven = /* @__PURE__ */ new Uint8Array(0);
/** 1 if it touches or is tied to something that is not dynamic. */
let held = /* @__PURE__ */ new Uint8Array(0);

/** Finds the companies of all awake bodies, from the contacts and joints of this step. */
export function findCompanies({ solver, liveDynamics }: World): void {
  const count = solver.bodyCount;
  if (parent.length < count) {
    const room = grown(count);
    parent = new Int32Array(room);
    next = new Int32Array(room);
    first = new Int32Array(room);
    size = new Int32Array(room);
    driven = new Uint8Array(room);
    held = new Uint8Array(room);
  }
  for (let slot = 0; slot < count; slot += 1) {
    parent[slot] = slot;
    first[slot] = 0;
    size[slot] = 0;
    driven[slot] = slot > liveDynamics.length && isMoving(solver, slot * d.BODY_STRIDE) ? 1 : 0;
    held[slot] = 0;
  }
  joinTouching(solver.one, liveDynamics.length);
  joinTouching(solver.two, liveDynamics.length);
  joinTied(solver, liveDynamics.length);
  for (let slot = liveDynamics.length; slot > 0; slot -= 1) {
    const root = rootOf(parent, slot);
    driven[root] = driven[root]! | driven[slot]!;
    held[root] = held[root]! | held[slot]!;
    next[slot] = first[root]!;
    first[root] = slot;
    size[root] = size[root]! + 1;
  }
}

/**
 * Lists the guests of a group: those of the company of its first body that can be pushed. @returns whether nothing drives any of the
 * company, and it is not too large.
 */
export function findGuests(data: SolverData, group: Group): boolean {
  const { traits, velocity } = data;
  const { guests, bodies } = group;
  let at = 0;
  for (let n = 0; n < bodies.count && velocity[at + d.INV_MASS] === 0; n += 1) {
    at = bodies.items[n]!;
  }
  const root = rootOf(parent, at / d.BODY_STRIDE);
  group.isAfloat = held[root] === 0;
  if (driven[root] === 1 || size[root]! > group.end - group.start + 1 + MOST_GUESTS) {
    return false;
  }
  markBodies(data, group, d.MEMBER);
  for (let other = first[root]!; other > 0; other = next[other]!) {
    if ((traits[other]! & d.MEMBER) === 0) guests.add(other * d.BODY_STRIDE);
  }
  markBodies(data, group, 0);
  return true;
}

/** Joins the companies of two bodies if both are dynamic; else one of them holds the other, and may drive it. */
function join(a: number, b: number, dynamics: number): void {
  if (a > 0 && b > 0 && a <= dynamics && b <= dynamics) {
    unite(parent, a, b);
    return;
  }
  held[a] = 1;
  held[b] = 1;
  if (a > dynamics || b > dynamics) {
    driven[a] = driven[b] = driven[a]! | driven[b]!;
  }
}

function joinTouching({ records: r, bodies, count, stride }: ContactBatch, dynamics: number): void {
  for (let k = 0; k < count; k += 1) {
    const a = (bodies[2 * k]! & d.OFFSET) / d.BODY_STRIDE;
    const b = bodies[2 * k + 1]! / d.BODY_STRIDE;
    const at = recordAt(k, stride);
    join(a, b, dynamics);
    if (r[at + d.SURFACE_T] !== 0 || r[at + d.SURFACE_N] !== 0) {
      driven[a] = 1;
      driven[b] = 1;
    }
  }
  driven[0] = 0;
}

function joinTied({ joints: { joints, bodies } }: SolverData, dynamics: number): void {
  for (let k = 0; k < joints.length; k += 1) {
    const { drives, first: from, layout } = joints[k]!;
    for (let n = from; n < from + layout.members; n += 1) {
      const slot = bodies[n]! / d.BODY_STRIDE;
      join(bodies[from]! / d.BODY_STRIDE, slot, dynamics);
      if (drives) driven[slot] = 1;
    }
  }
  driven[0] = 0;
}
