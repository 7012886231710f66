import * as c from '../../../contact/layout.js';
import { canMove, keptAt, loadBefore, solveAround, UNSOLVABLE } from '../../contacts/shocks.js';
import { batchOf, recordAt, type SolverData } from '../../data.js';
import * as d from '../../layout.js';
import { type Group, hasCallbacks } from '../joint-data.js';
import { startAgain } from '../joint-numbers.js';
import type { JointSolver } from '../joints.js';
import { steadyFrame } from './momentum.js';

// The part of joints in shocks, see `contacts/shocks.ts`.

/**
 * Notes for each body the number of its group of joints, or that it cannot be solved, if custom constraints are in the group. Groups of
 * these alone are left out, as they may hold whatever they like.
 */
export function linkShocks(data: SolverData): void {
  const { groupOf } = data.shocks;
  const { groups } = data.joints;
  for (let index = 0; index < groups.length; index += 1) {
    const group = groups[index]!;
    if (group.runs.every(hasCallbacks)) {
      continue;
    }
    const known = group.hasCustoms ? UNSOLVABLE : index + 1;
    for (let n = 0; n < group.bodies.count; n += 1) {
      groupOf[group.bodies.items[n]! / d.BODY_STRIDE] = known;
    }
  }
}

/**
 * Called after the impulses of a sub-step have been added up: joints of what was struck forget theirs, but not those with which the step
 * began: without these, bridges drop for a moment, and kick.
 */
export function forgetShocks(data: SolverData): void {
  const { struckGroups } = data.shocks;
  const { groups, joints } = data.joints;
  for (let i = 0; i < struckGroups.count; i += 1) {
    const { start, end } = groups[struckGroups.items[i]!]!;
    for (let k = start; k < end; k += 1) {
      startAgain(data, joints[k]!);
    }
  }
  struckGroups.clear();
}

/**
 * Solves frames together with their contacts, see `momentum.ts`. Those that were found with something struck are solved already. Those that
 * bear each other are not solved, as so many joints would take too many sweeps, and towers of frames would fall.
 */
export function solveFrames(data: SolverData, jointSolver: JointSolver): void {
  const { shocks } = data;
  const { groups } = data.joints;
  for (let i = 0; i < groups.length; i += 1) {
    const body = someBodyOfFrame(data, groups[i]!);
    if (body > 0 && shocks.known[body / d.BODY_STRIDE] === shocks.round) steadyFrame(data, groups[i]!);
  }
  for (let i = 0; i < groups.length; i += 1) {
    const body = someBodyOfFrame(data, groups[i]!);
    if (body > 0 && solveAround(data, body, jointSolver, 1)) {
      steadyFrame(data, groups[i]!);
      keepContacts(data);
    }
  }
}

/** The offset of the record of a body of a frame that can be pushed; 0 if none can, or the group is no frame that has to be solved. */
function someBodyOfFrame(data: SolverData, group: Group): number {
  if (!(group.isBent && group.touched)) {
    return 0;
  }
  const { items, count } = group.bodies;
  for (let n = 0; n < count; n += 1) {
    if (canMove(data, items[n]!)) return items[n]!;
  }
  return 0;
}

/**
 * Keeps the impulses of the contacts that were just solved as those with which the step began, so that they are no shock in the sub-steps
 * that follow: else they would be forgotten in every second one, for ever.
 */
function keepContacts(data: SolverData): void {
  const { shocks, impulseScale } = data;
  for (let i = 0; i < shocks.contacts.count && impulseScale > 0; i += 1) {
    const contact = shocks.contacts.items[i]!;
    const batch = batchOf(data, contact);
    const { records: r, stride, numbers } = batch;
    const n = numbers[contact >> 1]!;
    const from = recordAt(contact >> 1, stride);
    const to = keptAt(batch, contact);
    n[to] = r[from + d.NORMAL1]! / impulseScale;
    if (stride === d.TWO_STRIDE) n[to + c.IMPULSES] = r[from + d.NORMAL2]! / impulseScale;
    shocks.before[contact] = loadBefore(data, batch, contact);
  }
}
