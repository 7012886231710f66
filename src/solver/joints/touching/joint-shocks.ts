import * as c from '../../../contact/layout.js';
import { canMove, keptAt, solveAround } from '../../contacts/shocks.js';
import { batchOf, recordAt, type SolverData } from '../../data.js';
import * as d from '../../layout.js';
import { type Group, hasCallbacks } from '../joint-data.js';
import { startAgain } from '../joint-numbers.js';
import type { JointSolver } from '../joints.js';
import { steadyFrame } from './momentum.js';

// What joints have to do with `contacts/shocks.ts`.

/** Tells of each body which group of joints it hangs on. Custom constraints hold whatever they like: by themselves they do not count. */
export function linkShocks(data: SolverData): void {
  const { groupOf } = data.shocks;
  const { groups } = data.joints;
  for (let index = 0; index < groups.length; index += 1) {
    const group = groups[index]!;
    if (group.runs.every(hasCallbacks)) {
      continue;
    }
    const known = group.hasCustoms ? -1 : index + 1;
    for (let n = 0; n < group.bodies.count; n += 1) {
      groupOf[group.bodies.items[n]! / d.BODY_STRIDE] = known;
    }
  }
}

/** When what joints gave in a sub-step has been added up: what was struck forgets it, but for what it gave as the step began: without that bridges drop for a moment, and kick. */
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

/** Those that were found with what was struck are solved already; and those that bear each other are not, as few sweeps are enough for so many joints, and towers of frames would fall. */
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
      goOn(data);
    }
  }
}

/** The offset of one that can be pushed; 0 if none can, or it is no frame that is to be solved. */
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

/** What the contacts that were just solved bear is no shock in the sub-steps that follow: else it would be forgotten in every second one, for ever. */
function goOn(data: SolverData): void {
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
  }
}
