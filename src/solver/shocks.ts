import { SHOCK_CONTACTS, SHOCK_SPEED, SHOCK_TURNS } from '../config.js';
import * as c from '../contact/layout.js';
import { type ContactBatch, recordAt, type ShockList, type SolverData } from './data.js';
import * as d from './layout.js';
import { solveVelocityOne } from './one-point.js';
import { solveVelocityTwo } from './two-point.js';

// What strikes something is stopped in one sub-step, whose impulses the next one would start with once more: they throw it back, and a few sweeps cannot take that away again where one body lies between two others.
// So where what was struck is no heap its contacts are swept over until they are solved, and what they bear is forgotten, but for what they bore as the step began.

/** The end of a chain of ends. */
const NONE = -1;
/** Of a body that is part of a heap or a mechanism, for the whole step. */
const REFUSED = 1;

/** Ends the velocity sweeps of a sub-step: solves what was struck in it. */
export function settleShocks(data: SolverData): void {
  const { shocks } = data;
  shocks.round += 1;
  for (let i = 0; i < shocks.count; i += 1) {
    const contact = shocks.struck[i]!;
    if (!isShock(data, contact)) {
      continue;
    }
    if (!shocks.isLinked) link(data);
    const { bodies } = batchOf(data, contact);
    const a = bodies[contact & -2]! & d.OFFSET;
    const count = gather(data, (canMove(data, a) ? a : bodies[contact | 1]!) / d.BODY_STRIDE);
    solve(data, shocks.contacts, count);
  }
}

function link({ shocks, one, two, bodyCount }: SolverData): void {
  shocks.reserve(bodyCount, 4 * Math.max(one.count, two.count));
  shocks.first.fill(NONE, 0, bodyCount);
  shocks.known.fill(0, 0, bodyCount);
  shocks.round = REFUSED + 1;
  shocks.isLinked = true;
  linkAll(shocks, two, 0);
  linkAll(shocks, one, 1);
}

function linkAll({ first, next }: ShockList, { count, bodies }: ContactBatch, kind: number): void {
  for (let i = 0; i < 2 * count; i += 1) {
    const slot = (bodies[i]! & d.OFFSET) / d.BODY_STRIDE;
    const end = 2 * (i & -2) + 2 * kind + (i & 1);
    next[end] = first[slot]!;
    first[slot] = end;
  }
}

/** Finds the contacts that bear something and hang together with a body. @returns how many they are; 0 for those of a heap or a mechanism, and those that were found before. */
function gather(data: SolverData, start: number): number {
  const { known, round, first, next, slots, contacts } = data.shocks;
  if (known[start] === round || known[start] === REFUSED) {
    return 0;
  }
  known[start] = round;
  slots[0] = start;
  let bodies = 1;
  let count = 0;
  let isRefused = false;
  for (let i = 0; i < bodies && !isRefused; i += 1) {
    const here = slots[i]!;
    isRefused = (data.traits[here]! & d.LINKED) !== 0;
    for (let end = first[here]!; end !== NONE && !isRefused; end = next[end]!) {
      const contact = end >> 1;
      const batch = batchOf(data, contact);
      if (loadOf(batch, contact) === 0) {
        continue;
      }
      const other = batch.bodies[(contact & -2) + 1 - (end & 1)]! & d.OFFSET;
      const moves = canMove(data, other);
      if (!moves || (end & 1) === 0) {
        contacts[count] = contact;
        count += 1;
      }
      const there = other / d.BODY_STRIDE;
      isRefused = count > SHOCK_CONTACTS || (moves && known[there] === REFUSED);
      if (moves && known[there] !== round) {
        known[there] = round;
        slots[bodies] = there;
        bodies += 1;
      }
    }
  }
  if (isRefused) {
    for (let i = 0; i < bodies; i += 1) known[slots[i]!] = REFUSED;
    return 0;
  }
  return count;
}

function batchOf({ one, two }: SolverData, contact: number): ContactBatch {
  return (contact & 1) === 1 ? one : two;
}

/** By the offset of its record. */
function canMove({ velocity }: SolverData, body: number): boolean {
  return velocity[body + d.INV_MASS]! > 0;
}

/** N·s. The normal impulse of the sub-step. */
function loadOf({ records, stride }: ContactBatch, contact: number): number {
  const i = recordAt(contact >> 1, stride);
  return records[i + d.NORMAL1]! + (stride === d.TWO_STRIDE ? records[i + d.NORMAL2]! : 0);
}

/** N·s. That with which the step began. */
function loadBefore({ impulseScale }: SolverData, { numbers, at, point }: ContactBatch, contact: number): number {
  const k = contact >> 1;
  const n = numbers[k]!;
  const first = at[k]! + c.NORMAL;
  return (contact & 1) === 1
    ? n[first + c.IMPULSES * (point[k]! & 1)]! * impulseScale
    : n[first]! * impulseScale + n[first + c.IMPULSES]! * impulseScale;
}

/** Whether it bears so much more than as the step began that the heavier of what moves was stopped by it. */
function isShock(data: SolverData, contact: number): boolean {
  const batch = batchOf(data, contact);
  const { velocity: v } = data;
  const mA = v[(batch.bodies[contact & -2]! & d.OFFSET) + d.INV_MASS]!;
  const mB = v[batch.bodies[contact | 1]! + d.INV_MASS]!;
  const least = mA > 0 && mB > 0 ? Math.min(mA, mB) : mA + mB;
  return (loadOf(batch, contact) - loadBefore(data, batch, contact)) * least > SHOCK_SPEED;
}

/** Sweeps over some contacts until none of them changes a velocity by more than is worth it. */
function solve(data: SolverData, contacts: readonly number[], count: number): void {
  let changed = count > 0;
  for (let turns = count; turns <= SHOCK_TURNS && changed; turns += count) {
    changed = false;
    for (let i = 0; i < count; i += 1) {
      const contact = contacts[i]!;
      const k = contact >> 1;
      const solveVelocity = (contact & 1) === 1 ? solveVelocityOne : solveVelocityTwo;
      // To be exact in a sub-step of one second is exact enough.
      changed = solveVelocity(data, k, k + 1, 1) || changed;
    }
  }
  for (let i = 0; i < count; i += 1) {
    forget(data, contacts[i]!);
  }
}

/** What a contact bears beyond what it bore as the step began is counted, but nothing starts with it. */
function forget(data: SolverData, contact: number): void {
  const batch = batchOf(data, contact);
  const { records: r, stride } = batch;
  const load = loadOf(batch, contact);
  const before = loadBefore(data, batch, contact);
  if (load <= before) {
    return;
  }
  const i = recordAt(contact >> 1, stride);
  const kept = before / load;
  lessen(r, i + d.NORMAL1, i + d.NORMAL_SUM1, kept);
  lessen(r, i + d.TANGENT, i + d.TANGENT_SUM, kept);
  if (stride === d.TWO_STRIDE) {
    lessen(r, i + d.NORMAL2, i + d.NORMAL_SUM2, kept);
  } else {
    lessen(r, i + d.ROLL, i + d.ROLL_SUM, kept);
  }
}

function lessen(records: Float64Array, impulse: number, sum: number, kept: number): void {
  const was = records[impulse]!;
  records[impulse] = kept * was;
  records[sum] = records[sum]! + (was - kept * was);
}
