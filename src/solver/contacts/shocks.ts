import { SHOCK_CONTACTS, SHOCK_SPEED, SHOCK_WORK } from '../../config.js';
import { JOINT_TORN } from '../../config-joints.js';
import * as c from '../../contact/layout.js';
import { widened } from '../../math/doubles.js';
import { batchOf, type ContactBatch, IMPULSES, recordAt, type ShockList, type SolverData } from '../data.js';
import type { JointSolver } from '../joints/joints.js';
import * as d from '../layout.js';
import { solveVelocityTwo } from '../loops.js';
import { solveVelocityOne } from './one-point.js';

// What strikes something is stopped within one sub-step, and the next one would start with the same impulses once more: they throw it back,
// and a few sweeps cannot undo that where one body lies between two others. So, where what was struck is no heap, its contacts, and the
// joints of what hangs on it, are swept over until they are solved, and their impulses are forgotten, except those with which the step
// began. Frames that stand on something, such as a table under a load, are solved as well, but keep their impulses: see `isBent` in
// `joint-data.ts`.

/** The end of a list of ends. */
export const NONE = -1;
/** In `groupOf`: the body hangs on joints that cannot be solved once more. */
export const UNSOLVABLE = -1;
/** In `known`, marks a body that is part of a heap or a mechanism, for the whole step. */
const REFUSED = 1;

/** Notes a contact that may be struck in this step, as it is packed. */
export function noteStruck(data: SolverData, contact: number): void {
  const { shocks } = data;
  shocks.struck.add(contact);
  if (contact >= shocks.before.length) {
    shocks.before = widened(shocks.before, new Float64Array(2 * contact));
  }
  shocks.before[contact] = loadOf(batchOf(data, contact), contact);
}

/** Ends the velocity sweeps of a sub-step: solves what was struck in it, and frames that stand on something and are bent. */
export function solveShocks(data: SolverData, jointSolver: JointSolver | null): void {
  const { shocks } = data;
  shocks.round += 1;
  for (let i = 0; i < shocks.struck.count; i += 1) {
    const contact = shocks.struck.items[i]!;
    if (isShock(data, contact)) {
      const { bodies } = batchOf(data, contact);
      const a = bodies[contact & d.EVEN]! & d.OFFSET;
      const body = canMove(data, a) ? a : bodies[contact | 1]!;
      if (solveAround(data, body, jointSolver, SHOCK_CONTACTS)) forgetAll(data);
    }
  }
  jointSolver?.solveFrames(data, jointSolver);
}

/**
 * Solves what hangs together with a body, given by the offset of its record. @returns whether it was solved: not if it is a heap, has too
 * many groups of joints, or was found before.
 */
export function solveAround(
  data: SolverData,
  body: number,
  jointSolver: JointSolver | null,
  mostGroups: number,
): boolean {
  link(data, jointSolver?.linkShocks);
  const isSolved = gather(data, body / d.BODY_STRIDE) > 0 && data.shocks.groups.count <= mostGroups;
  if (isSolved) solve(data, jointSolver);
  return isSolved;
}

/** Lists the contacts of each body, and by `linkJoints` its group of joints, unless that was done in this step. */
export function link(data: SolverData, linkJoints: ((data: SolverData) => void) | undefined): void {
  const { shocks, one, two, bodyCount } = data;
  if (shocks.isLinked) {
    return;
  }
  shocks.reserve(bodyCount, 4 * Math.max(one.count, two.count));
  shocks.first.fill(NONE, 0, bodyCount);
  shocks.known.fill(0, 0, bodyCount);
  shocks.groupOf.fill(0, 0, bodyCount);
  shocks.round = REFUSED + 1;
  shocks.isLinked = true;
  linkAll(shocks, two, 0);
  linkAll(shocks, one, 1);
  linkJoints?.(data);
}

function linkAll({ first, next }: ShockList, { count, bodies }: ContactBatch, kind: number): void {
  for (let i = 0; i < 2 * count; i += 1) {
    const slot = (bodies[i]! & d.OFFSET) / d.BODY_STRIDE;
    const end = 2 * (i & d.EVEN) + 2 * kind + (i & 1);
    next[end] = first[slot]!;
    first[slot] = end;
  }
}

/**
 * Finds what hangs together with a body: contacts that bear something, and joints. @returns how many contacts there are; 0 if it is a heap,
 * or was found before.
 */
function gather(data: SolverData, start: number): number {
  const { shocks } = data;
  const { known, slots, contacts, groups } = shocks;
  if (known[start] === shocks.round || known[start] === REFUSED) {
    return 0;
  }
  slots.clear();
  contacts.clear();
  groups.clear();
  shocks.room = SHOCK_CONTACTS;
  visit(shocks, start);
  for (let i = 0; i < slots.count && shocks.room >= 0; i += 1) {
    gatherJoints(data, slots.items[i]!);
    gatherContacts(data, slots.items[i]!);
  }
  if (shocks.room < 0) {
    for (let i = 0; i < slots.count; i += 1) known[slots.items[i]!] = REFUSED;
    return 0;
  }
  return contacts.count;
}

function visit(shocks: ShockList, slot: number): void {
  const { known, slots, round } = shocks;
  if (known[slot] === REFUSED) shocks.room = -1;
  if (known[slot] !== round) {
    known[slot] = round;
    slots.add(slot);
  }
}

/** Adds the joints of a body. Those that have callbacks, or cannot be met, cannot be solved once more. */
function gatherJoints(data: SolverData, slot: number): void {
  const { shocks, joints } = data;
  const { groupOf, groups } = shocks;
  const index = groupOf[slot]!;
  if (index === UNSOLVABLE) {
    shocks.room = -1;
  } else if (index > 0 && !groups.has(index - 1)) {
    const group = joints.groups[index - 1]!;
    groups.add(index - 1);
    shocks.room = group.errorSquare > JOINT_TORN * JOINT_TORN ? -1 : shocks.room - (group.end - group.start);
    const count = shocks.room < 0 ? 0 : group.bodies.count;
    for (let n = 0; n < count; n += 1) {
      visit(shocks, group.bodies.items[n]! / d.BODY_STRIDE);
    }
  }
}

function gatherContacts(data: SolverData, slot: number): void {
  const { shocks } = data;
  const { first, next, contacts } = shocks;
  for (let end = first[slot]!; end !== NONE && shocks.room >= 0; end = next[end]!) {
    const contact = end >> 1;
    const batch = batchOf(data, contact);
    if (loadOf(batch, contact) === 0) {
      continue;
    }
    const other = batch.bodies[(contact & d.EVEN) + 1 - (end & 1)]! & d.OFFSET;
    const moves = canMove(data, other);
    // A contact of two bodies that can move is added from one of them.
    if (!moves || (end & 1) === 0) {
      contacts.add(contact);
      shocks.room -= 1;
    }
    if (moves) visit(shocks, other / d.BODY_STRIDE);
  }
}

/** Whether the body whose record has this offset can be moved. */
export function canMove({ velocity }: SolverData, body: number): boolean {
  return velocity[body + d.INV_MASS]! > 0;
}

/** The normal impulse of a contact in the sub-step, N·s. */
function loadOf({ records, stride }: ContactBatch, contact: number): number {
  const i = recordAt(contact >> 1, stride);
  return records[i + d.NORMAL1]! + (stride === d.TWO_STRIDE ? records[i + d.NORMAL2]! : 0);
}

/** Where a pair keeps the normal impulse of a contact, or of its first point. */
export function keptAt({ at, point }: ContactBatch, contact: number): number {
  const k = contact >> 1;
  return at[k]! + c.NORMAL + ((contact & 1) === 1 ? c.IMPULSES * (point[k]! & 1) : 0);
}

/** The normal impulse with which the step began, or that it bore when a frame was solved since, N·s. */
export function loadBefore({ contactScale }: SolverData, batch: ContactBatch, contact: number): number {
  const n = batch.numbers[contact >> 1]!;
  const first = keptAt(batch, contact);
  const isOne = (contact & 1) === 1;
  return isOne ? n[first]! * contactScale : n[first]! * contactScale + n[first + c.IMPULSES]! * contactScale;
}

/**
 * Whether a contact bears so much more than when the step began that it has stopped one of its bodies. The lighter one, as what lies
 * between two heavy ones lets pass only what stops itself, sub-step by sub-step; with joints the heavier one, else decks that tremble under
 * a load never come to rest.
 */
function isShock(data: SolverData, contact: number): boolean {
  const batch = batchOf(data, contact);
  const { velocity: v, traits } = data;
  const a = batch.bodies[contact & d.EVEN]! & d.OFFSET;
  const b = batch.bodies[contact | 1]! & d.OFFSET;
  const mA = v[a + d.INV_MASS]!;
  const mB = v[b + d.INV_MASS]!;
  let ease = Math.max(mA, mB);
  if (mA > 0 && mB > 0 && ((traits[a / d.BODY_STRIDE]! | traits[b / d.BODY_STRIDE]!) & d.LINKED) !== 0) {
    ease = Math.min(mA, mB);
  }
  return (loadOf(batch, contact) - data.shocks.before[contact]!) * ease > SHOCK_SPEED;
}

/** Sweeps over the contacts and joints that were found, until no contact changes a velocity by more than is worth it. */
function solve(data: SolverData, jointSolver: JointSolver | null): void {
  const { shocks } = data;
  const { contacts, groups } = shocks;
  const size = SHOCK_CONTACTS - shocks.room;
  let changed = true;
  for (let work = size; work <= SHOCK_WORK && changed; work += size) {
    changed = false;
    for (let i = 0; i < groups.count; i += 1) {
      jointSolver!.sweepShock(data, groups.items[i]!);
    }
    for (let i = 0; i < contacts.count; i += 1) {
      const contact = contacts.items[i]!;
      const k = contact >> 1;
      const solveVelocity = (contact & 1) === 1 ? solveVelocityOne : solveVelocityTwo;
      // As in a sub-step of 1 s: until nothing changes by more than CALM_ACCELERATION would change it in 1 s.
      changed = solveVelocity(data, k, k + 1, 1) || changed;
    }
  }
}

/** Makes everything that was just solved forget its impulses: joints are told, and do so when the sub-step ends. */
function forgetAll(data: SolverData): void {
  const { contacts, groups, struckGroups } = data.shocks;
  for (let i = 0; i < groups.count; i += 1) {
    struckGroups.add(groups.items[i]!);
  }
  for (let i = 0; i < contacts.count; i += 1) {
    forget(data, contacts.items[i]!);
  }
}

/** Counts towards the step what a contact bears beyond what it bore as the step began, so that nothing starts with it. */
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
  for (const impulse of IMPULSES) {
    const at = i + impulse;
    const was = r[at]!;
    r[at] = kept * was;
    r[at + d.SUM] = r[at + d.SUM]! + (was - kept * was);
  }
}
