import type { RigidBody } from '../../body.js';
import { DYNAMIC } from '../../body-kind.js';
import { NEW_SHARE, NEW_SPEED, NEW_STEPS, ROCK_LEAST, ROCK_SHARE, ROCK_SPIN, STRAIN_SHARE } from '../../config.js';
import type { Arbiter } from '../../contact/arbiter.js';
import { ROCKS } from '../../contact/bits.js';
import type { SolverData } from '../data.js';
import { ALL_HARD, BODY_STRIDE, MARK, NONE_HARD } from '../layout.js';

/**
 * Marks the bodies of those contacts of a window that are hard to solve, and are to be swept over more often. All contacts are hard if many
 * of them are new and slow, if columns sway, if a load was just taken from one of the bodies, or if there is no warm start. Else those are
 * that bear far more than their bodies weigh, those that share a body with one, and those that share one with these.
 *
 * @returns the threshold of marks: a contact is hard if the mark of either body is no lower.
 */
export function markHard(data: SolverData, count: number, stamp: number): number {
  const { window } = data;
  if (data.impulseScale === 0) {
    return ALL_HARD;
  }
  let fresh = 0;
  let strained = 0;
  let rocking = 0;
  // Higher than the marks of the windows before.
  const mark = 1 + 2 * (data.one.count + data.two.count);
  for (let i = 0; i < count; i += 1) {
    const pair = window[i]!;
    const { began, strainedUntil, bodyA, bodyB } = pair;
    if (data.unloads && (bodyA.unloaded === stamp || bodyB.unloaded === stamp)) {
      return ALL_HARD;
    }
    if (stamp < strainedUntil) {
      strained += 1;
      setMark(data, bodyA, mark);
      setMark(data, bodyB, mark);
    }
    rocking += pair.is(ROCKS) ? 1 : 0;
    fresh += stamp - began < NEW_STEPS && pair.active && isSlow(bodyA) && isSlow(bodyB) ? 1 : 0;
  }
  if (
    fresh > NEW_SHARE * count ||
    (rocking > ROCK_LEAST * count && rocking > ROCK_SHARE * countTurning(window, count))
  ) {
    return ALL_HARD;
  }
  if (strained <= STRAIN_SHARE * count) {
    return NONE_HARD;
  }
  for (let i = 0; i < count; i += 1) {
    const { bodyA, bodyB } = window[i]!;
    const isNearA = markOf(data, bodyA) === mark;
    if (isNearA !== (markOf(data, bodyB) === mark)) {
      setMark(data, isNearA ? bodyB : bodyA, mark + 1);
    }
  }
  return mark;
}

function countTurning(window: readonly Arbiter[], count: number): number {
  let turning = 0;
  for (let i = 0; i < count; i += 1) {
    const { bodyA, bodyB } = window[i]!;
    turning += Math.abs(bodyB.w - bodyA.w) > ROCK_SPIN ? 1 : 0;
  }
  return turning;
}

function isSlow({ vx, vy }: RigidBody): boolean {
  return vx * vx + vy * vy < NEW_SPEED * NEW_SPEED;
}

/** Sets the mark of a dynamic body. Others pass no load on. */
function setMark({ velocity }: SolverData, { kind, slot }: RigidBody, mark: number): void {
  if (kind === DYNAMIC) {
    velocity[slot * BODY_STRIDE + MARK] = mark;
  }
}

export function markOf({ velocity }: SolverData, { slot }: RigidBody): number {
  return velocity[slot * BODY_STRIDE + MARK]!;
}
