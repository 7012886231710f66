import { JOINT_MOMENTUM } from '../../../config-joints.js';
import type { PointConstraint } from '../../../constraint/point.js';
import { recordAt, remember, type SolverData } from '../../data.js';
import * as d from '../../layout.js';
import type { Joint } from '../joint-data.js';
import * as j from '../joint-layout.js';
import * as plain from './point-loops.js';

/**
 * Rigid point joints that do not break. The error is C = Δ(x + r) between the bodies, and its rate C' = vB + ωB × rB − vA − ωA × rA.
 * Velocity iterations bring C' to zero at the start of the sub-step; position iterations bring C to zero at its end, and their corrections
 * become momentum, by the arms of the start. Together this is RATTLE (Andersen 1983), which neither gains nor loses energy.
 */

/**
 * A loop in WebAssembly over records, from one index to another, both even. @returns four times the index of the first record that it left
 * to the loop in TypeScript, plus what that returns.
 */
type FastLoop = (data: SolverData, from: number, to: number) => number;

export interface PointKernels {
  readonly warmStart: FastLoop;
  readonly solveVelocity: FastLoop;
  readonly push: FastLoop;
  readonly pushLinearly: FastLoop;
  readonly finish: FastLoop;
  /**
   * Adds the motion of the sub-step to the placements of bodies. @returns the index of the first body that it left to the loop in
   * TypeScript.
   */
  readonly advancePoses: FastLoop;
}

/**
 * The same in TypeScript: over each record or, with a `step` of 2, every second one, or back, with a negative one. @returns which errors
 * were worth another iteration, if any: 1 for one in an even slot, plus 2 for one in an odd slot.
 */
type Loop = (data: SolverData, from: number, to: number, step: number) => number;

/**
 * How many joints share the choice between an exact and a linear sweep where errors are large. With fewer the calls would be too many;
 * among more, seldom has none turned.
 */
const FAR_BLOCK = 8;

/** Writes what changes seldom: anchors, bodies, and the impulse to start with. */
export function packPoint(data: SolverData, joint: Joint): void {
  const { records: r } = data.joints;
  const { at, constraint } = joint;
  // Read first: reading it fetches the impulse of the last step from this very record, if that was not done yet.
  const { impulse } = constraint;
  r[at + j.KEPT_IMPULSE_X] = impulse[0]!;
  r[at + j.KEPT_IMPULSE_Y] = impulse[1]!;
  r[at + j.KEPT_SLOT] = joint.slot;
  packAnchor(data, joint, 0);
  packAnchor(data, joint, 1);
}

function packAnchor(data: SolverData, joint: Joint, k: number): void {
  const { records: r, bodies } = data.joints;
  const { at, first } = joint;
  const constraint = joint.constraint as PointConstraint;
  const { members, anchors } = constraint;
  const body = members[k]!;
  const slot = constraint.slotOf(body);
  const x = anchors[2 * k]!;
  const y = anchors[2 * k + 1]!;
  const isImmovable = slot === 0;
  r[at + j.KEPT_ANCHOR_AX + 2 * k] = isImmovable ? body.x + body.cos * x - body.sin * y : x;
  r[at + j.KEPT_ANCHOR_AY + 2 * k] = isImmovable ? body.y + body.sin * x + body.cos * y : y;
  r[at + j.KEPT_ORIGIN_AX + 2 * k] = isImmovable ? body.x : 0;
  r[at + j.KEPT_ORIGIN_AY + 2 * k] = isImmovable ? body.y : 0;
  bodies[first + k] = slot * d.BODY_STRIDE;
}

/** Starts a step. @returns whether one of the bodies is in contact. */
export function beginPoints(data: SolverData, start: number, end: number): boolean {
  const { records: kept, bodies, joints, h } = data.joints;
  const { drive, points: r, pointBodies } = data;
  const scale = data.impulseScale;
  const carry = JOINT_MOMENTUM / h;
  let o = joints[start]!.at;
  let n = joints[start]!.first;
  let touched = 0;
  for (let k = start; k < end; k += 1, o = (o + j.KEPT_STRIDE) & d.OFFSET, n = (n + 2) & d.OFFSET) {
    const slot = kept[o + j.KEPT_SLOT]! & d.OFFSET;
    const i = recordAt(slot, j.POINT_STRIDE) & d.OFFSET;
    const a = bodies[n]! & d.OFFSET;
    const b = bodies[n + 1]! & d.OFFSET;
    touched |= drive[a + d.TOUCHED]! | drive[b + d.TOUCHED]!;
    if ((slot & 1) === 0) {
      // Marked as missing; the next joint overwrites that if the slot is its own.
      missing(r, pointBodies, slot + 1, i + 1);
    }
    pointBodies[2 * slot] = a;
    pointBodies[2 * slot + 1] = b;
    r[i + j.ANCHOR_AX] = kept[o + j.KEPT_ANCHOR_AX]!;
    r[i + j.ANCHOR_AY] = kept[o + j.KEPT_ANCHOR_AY]!;
    r[i + j.ANCHOR_BX] = kept[o + j.KEPT_ANCHOR_BX]!;
    r[i + j.ANCHOR_BY] = kept[o + j.KEPT_ANCHOR_BY]!;
    r[i + j.IMPULSE_X] = kept[o + j.KEPT_IMPULSE_X]! * scale;
    r[i + j.IMPULSE_Y] = kept[o + j.KEPT_IMPULSE_Y]! * scale;
    r[i + j.SUM_X] = 0;
    r[i + j.SUM_Y] = 0;
    r[i + j.SUM_WA] = 0;
    r[i + j.SUM_WB] = 0;
    r[i + j.POINT_CARRY] = carry;
    r[i + j.POINT_SNAPS] = 0;
  }
  return touched !== 0;
}

/** Writes a record that belongs to no joint. */
function missing(r: Float64Array, pointBodies: Int32Array, slot: number, i: number): void {
  pointBodies[2 * slot] = d.MISSING;
  pointBodies[2 * slot + 1] = 0;
  r[i + j.ANCHOR_AX] = 0;
  r[i + j.ANCHOR_AY] = 0;
  r[i + j.ANCHOR_BX] = 0;
  r[i + j.ANCHOR_BY] = 0;
}

/** Ends a step: keeps the impulses for the next one, and what the step gave. */
export function keepPoints(data: SolverData, start: number, end: number): void {
  const { records: kept, joints } = data.joints;
  const { points: r, impulseScale: scale } = data;
  let o = joints[start]!.at;
  for (let k = start; k < end; k += 1, o = (o + j.KEPT_STRIDE) & d.OFFSET) {
    const slot = kept[o + j.KEPT_SLOT]! & d.OFFSET;
    const i = recordAt(slot, j.POINT_STRIDE) & d.OFFSET;
    kept[o + j.KEPT_IMPULSE_X] = remember(data, kept[o + j.KEPT_IMPULSE_X]! * scale, r[i + j.IMPULSE_X]!);
    kept[o + j.KEPT_IMPULSE_Y] = remember(data, kept[o + j.KEPT_IMPULSE_Y]! * scale, r[i + j.IMPULSE_Y]!);
    kept[o + j.KEPT_SUM_X] = r[i + j.SUM_X]!;
    kept[o + j.KEPT_SUM_Y] = r[i + j.SUM_Y]!;
    kept[o + j.KEPT_SUM_WA] = r[i + j.SUM_WA]!;
    kept[o + j.KEPT_SUM_WB] = r[i + j.SUM_WB]!;
  }
}

/** Widens `off` to the joints with a larger error than `asked`: from the first to the one after the last. */
export function findOff(data: SolverData, start: number, end: number): void {
  const { off, joints } = data.joints;
  let from = start;
  while (from < end && !isOff(data, joints[from]!)) {
    from += 1;
  }
  if (from === end) {
    return;
  }
  let to = end;
  while (!isOff(data, joints[to - 1]!)) {
    to -= 1;
  }
  off[0] = Math.min(off[0]!, from);
  off[1] = Math.max(off[1]!, to);
}

function isOff({ points: r, joints: { asked } }: SolverData, { slot }: Joint): boolean {
  const i = recordAt(slot, j.POINT_STRIDE);
  return r[i + j.ERROR_X]! * r[i + j.ERROR_X]! + r[i + j.ERROR_Y]! * r[i + j.ERROR_Y]! > asked[0]!;
}

/**
 * Runs a loop over joints from one to another: the fast one, if there is one, and the plain one over what that leaves, where it stops and
 * at the ends, where only one of two is asked for. Joints of two groups that lie side by side are solved at once if both groups are asked
 * for. Back it is always the plain loop.
 * @returns as `loop`.
 */
function runLoop(
  data: SolverData,
  start: number,
  end: number,
  isBack: boolean,
  fast: FastLoop | undefined,
  loop: Loop,
): number {
  const { pointBodies } = data;
  const { joints } = data.joints;
  const { slot, isPaired } = joints[start]!;
  const last = joints[end - 1]!.slot;
  const step = stepOf(data, start, end);
  if (isBack) {
    return loop(data, last, slot - step, -step);
  }
  if (fast === undefined || !isPaired || step === 2) {
    return loop(data, slot, last + step, step);
  }
  const to = last + 1;
  let k = slot;
  let found = 0;
  if (k % 2 === 1) {
    found = loop(data, k, k + 1, 1);
    k += 1;
  }
  const whole = to + (to & 1) * ((pointBodies[2 * to]! & d.MISSING) === 0 ? -1 : 1);
  while (k < whole) {
    const done = fast(data, k, whole);
    found |= done & 3;
    k = done >> 2;
    if (k < whole) {
      found |= loop(data, k, k + 2, 1);
      k += 2;
    }
  }
  return k < to ? loop(data, k, to, 1) | found : found;
}

/**
 * The step from one record to the next: 2 within one group that has another one beside it, as its slots are all even or all odd; else 1.
 */
function stepOf({ joints: { joints } }: SolverData, start: number, end: number): number {
  const { slot, isBeside } = joints[start]!;
  return isBeside && ((joints[end - 1]!.slot ^ slot) & 1) === 0 ? 2 : 1;
}

/** Starts a sub-step: finds arms, error and K⁻¹ for the present placement, and warm starts with the impulse of the last sub-step. */
export function warmStartPoints(data: SolverData, start: number, end: number): void {
  runLoop(data, start, end, false, data.pointKernels?.warmStart, plain.warmStartPoints);
}

/** One velocity sweep. */
export function solveVelocityPoints(data: SolverData, start: number, end: number, isBack: boolean): void {
  runLoop(data, start, end, isBack, data.pointKernels?.solveVelocity, plain.solveVelocityPoints);
}

/** One exact position sweep. @returns as `Loop`. */
export function pushPoints(data: SolverData, start: number, end: number, isBack: boolean): number {
  return runLoop(data, start, end, isBack, data.pointKernels?.push, plain.pushPoints);
}

/** Another position sweep, with errors linear in the motion since the last exact one. @returns as `Loop`. */
export function pushPointsLinearly(data: SolverData, start: number, end: number, isBack: boolean): number {
  return runLoop(data, start, end, isBack, data.pointKernels?.pushLinearly, plain.pushPointsLinearly);
}

/**
 * Another position sweep, where errors are large: exact for blocks of a few joints if a body of one has turned since the last exact sweep,
 * else linear. @returns as `Loop`.
 */
export function pushTurnedPoints(data: SolverData, start: number, end: number, isBack: boolean): number {
  let found = 0;
  const block = isBack ? 1 : FAR_BLOCK;
  for (let n = start; n < end; n += block) {
    const k = isBack ? start + end - 1 - n : n;
    const to = Math.min(k + block, end);
    found |= haveTurned(data, k, to) ? pushPoints(data, k, to, isBack) : pushPointsLinearly(data, k, to, isBack);
  }
  return found;
}

/** Writes to `left` the largest error now, m. */
export function measurePoints(data: SolverData, start: number, end: number): void {
  const { joints } = data.joints;
  const step = stepOf(data, start, end);
  plain.measurePoints(data, joints[start]!.slot, joints[end - 1]!.slot + step, step);
}

/** Turns the impulses with the bodies: see `energy/stress.ts`. */
export function turnPoints(data: SolverData, start: number, end: number): void {
  const { joints } = data.joints;
  const step = stepOf(data, start, end);
  plain.turnPoints(data, joints[start]!.slot, joints[end - 1]!.slot + step, step);
}

/** Ends a sub-step: makes momentum of a share of the corrections, and adds up what the joints gave. */
export function finishPoints(data: SolverData, start: number, end: number): void {
  runLoop(data, start, end, false, data.pointKernels?.finish, plain.finishPoints);
}

/** Whether a body of some joints has turned far since their last exact sweep. */
function haveTurned(data: SolverData, start: number, end: number): boolean {
  const { joints } = data.joints;
  const step = stepOf(data, start, end);
  return plain.haveTurned(data, joints[start]!.slot, joints[end - 1]!.slot + step, step);
}
