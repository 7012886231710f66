import type { RigidBody } from '../body.js';
import { DYNAMIC } from '../body-kind.js';
import { NEW_SHARE, NEW_SPEED, NEW_STEPS, STRAIN_SHARE, STRAIN_STEPS } from '../config.js';
import type { SolverData } from './data.js';

/**
 * Puts those of a window of contacts first that are hard to solve and are to be swept over more often, in their order. All are if many of them are new
 * and slow, or if the load of one was just taken away; else those that bear far more than their bodies weigh, and what is next to them.
 *
 * @returns how many.
 */
export function gatherHard(data: SolverData, count: number, stamp: number): number {
  const { window } = data;
  let fresh = 0;
  let strained = 0;
  for (let i = 0; i < count; i += 1) {
    const { active, began, strained: latest, bodyA, bodyB } = window[i]!;
    if (bodyA.unloaded === stamp || bodyB.unloaded === stamp) {
      return count;
    }
    strained += stamp - latest < STRAIN_STEPS ? 1 : 0;
    fresh += active && stamp - began < NEW_STEPS && isSlow(bodyA) && isSlow(bodyB) ? 1 : 0;
  }
  if (fresh > NEW_SHARE * count) {
    return count;
  }
  return strained > STRAIN_SHARE * count ? gatherStrained(data, count, stamp) : 0;
}

function isSlow({ vx, vy }: RigidBody): boolean {
  return vx * vx + vy * vy < NEW_SPEED * NEW_SPEED;
}

/** The strained ones, those that share a body with one, and those that share one with these. */
function gatherStrained(data: SolverData, count: number, stamp: number): number {
  const { window, others, marks } = data;
  data.mark += 2;
  const { mark } = data;
  for (let i = 0; i < count; i += 1) {
    const { strained, bodyA, bodyB } = window[i]!;
    if (stamp - strained < STRAIN_STEPS) {
      note(marks, bodyA, mark);
      note(marks, bodyB, mark);
    }
  }
  for (let i = 0; i < count; i += 1) {
    const { bodyA, bodyB } = window[i]!;
    const isNearA = marks[bodyA.slot] === mark;
    if (isNearA !== (marks[bodyB.slot] === mark)) {
      note(marks, isNearA ? bodyB : bodyA, mark + 1);
    }
  }
  let first = 0;
  let rest = 0;
  for (let i = 0; i < count; i += 1) {
    const pair = window[i]!;
    if (marks[pair.bodyA.slot]! >= mark || marks[pair.bodyB.slot]! >= mark) {
      window[first] = pair;
      first += 1;
    } else {
      others[rest] = pair;
      rest += 1;
    }
  }
  for (let i = 0; i < rest; i += 1) {
    window[first + i] = others[i]!;
  }
  return first;
}

/** What is not dynamic passes no load on. */
function note(marks: Int32Array, { kind, slot }: RigidBody, mark: number): void {
  if (kind === DYNAMIC) {
    marks[slot] = mark;
  }
}
