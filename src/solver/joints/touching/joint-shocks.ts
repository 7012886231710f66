import type { SolverData } from '../../data.js';
import { BODY_STRIDE } from '../../layout.js';
import { hasCallbacks } from '../joint-data.js';
import { startAgain } from '../joint-numbers.js';

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
      groupOf[group.bodies.items[n]! / BODY_STRIDE] = known;
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
