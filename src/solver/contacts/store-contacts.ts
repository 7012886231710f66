import * as g from '../../collide/layout.js';
import {
  COLUMN_PART,
  IMPULSE_MEMORY,
  ROCK_SPIN,
  STRAIN_DELAY,
  STRAIN_PART,
  STRAIN_SPEED,
  STRAIN_STEPS,
  STRAIN_UNLIKE,
  STRAIN_UNLIKE_ONE,
  TUMBLE_SPIN,
} from '../../config.js';
import { clearPoint } from '../../contact/arbiter.js';
import { FRESH, NOTED, ROCKS, STRAINS, USED, USED_BEFORE } from '../../contact/bits.js';
import * as c from '../../contact/layout.js';
import { type ContactBatch, recordAt, remember, type SolverData } from '../data.js';
import * as d from '../layout.js';

// Straight-line, like packing: these functions run once a step for every contact. Zeros are never negative, as users and snapshots read
// them. The warm start of the next step does not take over all of the change in this one, see IMPULSE_MEMORY; of an impact, which is over,
// it takes nothing.

/** Writes the outcome of a contact of two points back to its pair. A point that was apart from the start and met nothing was not used. */
export function storeTwo(data: SolverData, index: number, stamp: number): void {
  const batch = data.two;
  const { records: r, bodies } = batch;
  const i = recordAt(index, d.TWO_STRIDE) & d.OFFSET;
  const a = bodies[2 * index]! & d.OFFSET;
  const b = bodies[2 * index + 1]!;
  const n = batch.numbers[index]!;
  const o = batch.at[index]! & d.OFFSET;
  const scale = data.contactScale;
  const p1 = r[i + d.NORMAL1]! + 0;
  const p2 = r[i + d.NORMAL2]! + 0;
  const tangent = r[i + d.TANGENT]!;
  const part = r[i + d.PART]!;
  const sum2 = r[i + d.NORMAL_SUM2]!;
  const total1 = r[i + d.NORMAL_SUM1]! + p1;
  const total2 = sum2 + p2;
  const both = total1 + sum2 + p2;
  const slid = r[i + d.TANGENT_SUM]! + tangent;
  const slid1 = (both > 0 ? total1 / both : part) * slid + 0;
  const slid2 = (both > 0 ? total2 / both : 1 - part) * slid + 0;
  const before1 = n[o + c.NORMAL]! * scale;
  const before2 = n[o + c.NORMAL + c.IMPULSES]! * scale;
  n[o + c.NORMAL] = remember(data, before1, Math.min(before1 + IMPULSE_MEMORY * (p1 - before1), 2 * p1));
  n[o + c.TANGENT] = remember(data, n[o + c.TANGENT]! * scale, part * tangent);
  n[o + c.STEP_NORMAL] = total1;
  n[o + c.STEP_TANGENT] = slid1;
  n[o + c.NORMAL + c.IMPULSES] = remember(data, before2, Math.min(before2 + IMPULSE_MEMORY * (p2 - before2), 2 * p2));
  n[o + c.TANGENT + c.IMPULSES] = remember(data, n[o + c.TANGENT + c.IMPULSES]! * scale, (1 - part) * tangent);
  n[o + c.STEP_NORMAL + c.IMPULSES] = total2;
  n[o + c.STEP_TANGENT + c.IMPULSES] = slid2;
  const isUsed1 = total1 !== 0 || slid1 !== 0 || !(n[o + g.S0]! > 0);
  const isUsed2 = total2 !== 0 || slid2 !== 0 || !(n[o + g.S1]! > 0);
  noteUse(batch, index, (isUsed1 ? 1 : 0) | (isUsed2 ? 2 : 0), isRocking(data, a, b, p1 + p2));
  const bearsMuch = p1 * r[i + d.K11]! + p2 * r[i + d.K22]! > STRAIN_SPEED;
  const isUnlike = bearsMuch && areUnlike(data, a, b, STRAIN_UNLIKE);
  const isStrained =
    isUnlike || (bearsMuch && p1 + p2 > STRAIN_PART * Math.min(data.drive[a + d.LOAD]!, data.drive[b + d.LOAD]!));
  noteStrain(batch, index, isStrained, isUnlike, stamp);
}

/** The same for a contact of one point; a second point that the solver did not see has no impulse. */
export function storeOne(data: SolverData, index: number, stamp: number): void {
  const batch = data.one;
  const { records: r, bodies, point } = batch;
  const i = recordAt(index, d.ONE_STRIDE) & d.OFFSET;
  const n = batch.numbers[index]!;
  const o = batch.at[index]! & d.OFFSET;
  const which = point[index]! & 1;
  let usedBefore = (batch.bits[index]! >> USED) & 3;
  if ((point[index]! & d.ONE_OF_TWO) !== 0) {
    clearPoint(n, o, 1 - which);
    usedBefore &= 1 << which;
  }
  const to = o + c.IMPULSES * which;
  const p = r[i + d.NORMAL1]!;
  const tangent = r[i + d.TANGENT]!;
  const total = r[i + d.NORMAL_SUM1]! + p;
  const slid = r[i + d.TANGENT_SUM]! + tangent + 0;
  const roll = r[i + d.ROLL]! + 0;
  const scale = data.contactScale;
  const before = n[to + c.NORMAL]! * scale;
  n[to + c.NORMAL] = remember(data, before, Math.min(before + IMPULSE_MEMORY * (p - before), 2 * p));
  n[to + c.TANGENT] = remember(data, n[to + c.TANGENT]! * scale, tangent);
  n[to + c.STEP_NORMAL] = total;
  n[to + c.STEP_TANGENT] = slid;
  n[o + c.ROLL] = remember(data, n[o + c.ROLL]! * scale, roll);
  n[o + c.STEP_ROLL] = r[i + d.ROLL_SUM]! + roll;
  const isUsed = total !== 0 || slid !== 0 || !(n[o + g.S0 + g.POINT * which]! > 0);
  noteUse(batch, index, (usedBefore & ~(1 << which)) | (isUsed ? 1 << which : 0), false);
  const isStrained =
    p > STRAIN_SPEED * r[i + d.NORMAL_MASS]! &&
    areUnlike(data, bodies[2 * index]! & d.OFFSET, bodies[2 * index + 1]!, STRAIN_UNLIKE_ONE);
  noteStrain(batch, index, isStrained, true, stamp);
}

/** Notes which points the solver used, and whether it rocks. The memory of the arbiter is waited for only if something changed. */
function noteUse({ bits, arbiters }: ContactBatch, index: number, used: number, rocks: boolean): void {
  const was = bits[index]!;
  const before = (was >> USED) & 3;
  const found = (used << USED) | ((used & ~before) << FRESH) | (before << USED_BEFORE) | (rocks ? ROCKS : 0);
  const is = (was & ~NOTED) | found;
  if (is !== was) {
    const pair = arbiters[index]!;
    pair.bits = (pair.bits & ~NOTED) | found;
  }
}

/**
 * Notes for how many steps on end the contact has been strained: it bears far more than its bodies weigh, and these are of unlike mass, or
 * it bears much of what one of them bears. From this follows for how long it counts as strained; the arbiter is read only if it was.
 */
function noteStrain(
  { bits, arbiters }: ContactBatch,
  index: number,
  isStrained: boolean,
  isUnlike: boolean,
  stamp: number,
): void {
  if (isStrained || (bits[index]! & STRAINS) !== 0) {
    const pair = arbiters[index]!;
    pair.strainFor(isStrained ? pair.strain + 1 : 0);
    if (pair.strain >= STRAIN_DELAY) {
      const memory = isUnlike ? STRAIN_STEPS : Math.min(pair.strain, STRAIN_STEPS);
      pair.strainedUntil = Math.max(pair.strainedUntil, stamp + memory);
    }
  }
}

function areUnlike({ velocity: v }: SolverData, a: number, b: number, share: number): boolean {
  const mA = v[a + d.INV_MASS]!;
  const mB = v[b + d.INV_MASS]!;
  return Math.abs(mA - mB) > share * (mA + mB);
}

/**
 * Whether two edges rock: they turn slowly relative to each other, and bear about half of all that either body does, as in a column that
 * sways.
 */
function isRocking({ velocity: v, drive }: SolverData, a: number, b: number, load: number): boolean {
  const spin = Math.abs(v[b + d.W]! - v[a + d.W]!);
  const loadA = drive[a + d.LOAD]!;
  const loadB = drive[b + d.LOAD]!;
  return (
    spin > ROCK_SPIN &&
    spin < TUMBLE_SPIN &&
    load > COLUMN_PART * Math.min(a === 0 ? Infinity : loadA, b === 0 ? Infinity : loadB) &&
    load < (1 - COLUMN_PART) * Math.max(a === 0 ? 0 : loadA, b === 0 ? 0 : loadB)
  );
}
