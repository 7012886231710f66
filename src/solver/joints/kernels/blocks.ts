import { MIN_INVERSE_MASS } from '../../../config.js';
import { BLOCK_FAR_TURN, BOUND_SLOP, JOINT_SNAP, ROW_TURN } from '../../../config-joints.js';
import { isCustom } from '../../../constraint/constraint.js';
import type { CustomConstraint } from '../../../constraint/custom.js';
import { backward, forward } from '../../../math/solve.js';
import { remember, type SolverData } from '../../data.js';
import * as d from '../../layout.js';
import { breakJoint, type Joint, silence } from '../joint-data.js';
import * as j from '../joint-layout.js';
import { noteLag } from '../joint-numbers.js';
import { cutOrBreak } from './breaking.js';
import { applyRows, clear, findLength, length, multiplyRows, writeMatrix } from './jacobian.js';
import { measure, showPoses } from './pose.js';

/**
 * Block joints: joints with any number of rows and bodies, whose Jacobian J is written out. The method is that of point joints. The last
 * row may be one-sided: as K is factored with it last, the other rows are solved exactly for whatever impulse it ends at.
 */

/** Writes which bodies a joint has, and the impulse to start with. @returns whether one of the bodies is in contact. */
export function packBlock(data: SolverData, joint: Joint): boolean {
  const { records: r, bodies } = data.joints;
  const { at, layout, constraint, first } = joint;
  r.fill(0, at + layout.impulse, at + layout.size);
  if (isCustom(constraint)) {
    constraint.failed = false;
  }
  r[at + layout.low] = -Infinity;
  r[at + layout.high] = Infinity;
  r[at + layout.farBias] = Infinity;
  r[at + layout.farError] = Infinity;
  for (let n = 0; n < layout.rows; n += 1) {
    r[at + layout.impulse + n] = constraint.impulse[n]! * data.impulseScale;
  }
  let isTouched = false;
  for (let k = 0; k < layout.members; k += 1) {
    const b = constraint.slotOf(constraint.members[k]!) * d.BODY_STRIDE;
    bodies[first + k] = b;
    isTouched ||= data.drive[b + d.TOUCHED] === 1;
  }
  return isTouched;
}

/** Starts a sub-step: finds error, Jacobian and K for the present placement, and warm starts with the impulse of the last sub-step. */
export function warmStartBlock(data: SolverData, index: number, isFirst: boolean): void {
  const { records: r, joints } = data.joints;
  const joint = joints[index]!;
  const { at, layout, constraint } = joint;
  const { rows } = layout;
  const { isElastic } = constraint;
  if (isFirst || !isCustom(constraint)) {
    measure(data, joint, false);
  } else if (isElastic) {
    advanceError(data, joint);
  }
  clear(r, at + layout.push, rows);
  writeMatrix(data, joint, layout.jacobian);
  if (!constraint.positional) {
    r.copyWithin(at + layout.bias, at + layout.error, at + layout.error + rows);
    if (!isCustom(constraint)) {
      multiplyRows(data, joint, layout.jacobian, false);
      noteLag(data, at, layout.impulse, r[at + layout.work]! + r[at + layout.bias]!, r[at + layout.matrix]!);
    }
  } else if (isElastic) {
    beginSpring(data, joint);
  } else {
    beginBound(data, joint);
  }
  if (r[at + j.PUSH] !== 0) {
    findLength(r, at + layout.error, violatedRows(r, joint, layout.error));
    noteError(data, index);
  }
  applyRows(data, joint, layout.jacobian, layout.impulse, 1, false);
}

/** Starts a sub-step of a rigid joint: if its last row has bounds, it may go up to these, but no farther. */
export function beginBound({ joints: { records: r, h } }: SolverData, joint: Joint): void {
  const { at, layout } = joint;
  const last = layout.rows - 1;
  const distance = r[at + layout.error + last]!;
  const rests = Math.abs(distance) < BOUND_SLOP && r[at + layout.impulse + last] !== 0;
  const bias = isSlack(r, joint, layout.error) && !rests ? distance / h : 0;
  const beyond = distance / h - bias;
  r[at + layout.bias + last] = bias;
  r[at + layout.farBias] = r[at + layout.farError]! / h + (r[at + layout.high] === 0 ? beyond : -beyond);
}

/** Starts a sub-step of a spring: writes its bias, or makes it only damp. */
export function beginSpring(data: SolverData, joint: Joint): void {
  const { records: r } = data.joints;
  const { at, layout, constraint } = joint;
  writeElasticBias(data, joint);
  if (constraint.stored < 0 && isGiving(data, joint)) {
    // It owes energy, so it only damps: see `energy/springs.ts`.
    clear(r, at + layout.bias, layout.rows);
    clear(r, at + layout.impulse, layout.rows);
  }
}

/** Notes the error of a joint, which is in `length`, for the sweeps of its group. */
export function noteError({ joints }: SolverData, index: number): void {
  const { worst, asked, off } = joints;
  const error = length[0]!;
  worst[0] = Math.max(worst[0]!, error * error);
  if (error * error > asked[0]!) {
    off[0] = Math.min(off[0]!, index);
    off[1] = index + 1;
  }
}

/** Advances the error of an elastic custom joint by its linear part, as its callbacks are asked only once per step. */
function advanceError(data: SolverData, joint: Joint): void {
  const { records: r } = data.joints;
  const { at, layout } = joint;
  multiplyRows(data, joint, layout.jacobian, true);
  for (let n = 0; n < layout.rows; n += 1) {
    r[at + layout.error + n] = r[at + layout.error + n]! + r[at + layout.work + n]!;
  }
}

/**
 * Whether the last row is within its bounds, by the errors at the offset `errors`: it gives nothing, or only as much as keeps it from
 * passing the bound.
 */
export function isSlack(r: Float64Array, { at, layout }: Joint, errors: number): boolean {
  const error = r[at + errors + layout.rows - 1]!;
  return (r[at + layout.high] === 0 && error < 0) || (r[at + layout.low] === 0 && error > 0);
}

/** How many rows have an error, of those at the offset `errors`: a slack last row has none. */
function violatedRows(r: Float64Array, joint: Joint, errors: number): number {
  return isSlack(r, joint, errors) ? joint.layout.rows - 1 : joint.layout.rows;
}

/** Writes the velocity towards the target as bias; a slack last row has none. Breaks the joint if its error is too large. */
function writeElasticBias(data: SolverData, joint: Joint): void {
  const { records: r } = data.joints;
  const { at, layout } = joint;
  const { rows } = layout;
  const last = at + layout.error + rows - 1;
  if (isSlack(r, joint, layout.error)) {
    r[at + layout.low] = 0;
    r[at + layout.high] = 0;
    r[last] = 0;
  }
  findLength(r, at + layout.error, rows);
  const error = length[0]!;
  if (error > r[at + j.MAX_ERROR]!) {
    breakJoint(data.joints, joint);
    return;
  }
  const rate = r[at + j.RATE]!;
  const most = r[at + j.MAX_BIAS]!;
  const scale = error * rate > most ? most / error : rate;
  for (let n = 0; n < rows; n += 1) {
    r[at + layout.bias + n] = r[at + layout.error + n]! * scale;
  }
}

/** Whether the error of a spring is decreasing by itself: C · K⁻¹ · J · v < 0. */
function isGiving(data: SolverData, joint: Joint): boolean {
  multiplyRows(data, joint, joint.layout.jacobian, false);
  weighByError(data, joint);
  return length[0]! < 0;
}

/** Writes C · K⁻¹ · w to `length`, with w from the numbers at `work`. */
export function weighByError({ joints: { records: r } }: SolverData, { at, layout }: Joint): void {
  const { rows, error, work, matrix } = layout;
  forward(r, at + matrix, rows, r, at + work);
  backward(r, at + matrix, rows, r, at + work);
  let sum = 0;
  for (let n = 0; n < rows; n += 1) {
    sum += r[at + error + n]! * r[at + work + n]!;
  }
  length[0] = sum;
}

/** One velocity sweep: λ → clamp(λ − K⁻¹(J·v + bias) · softness − feedback · λ). */
export function solveVelocityBlock(data: SolverData, joint: Joint): void {
  const { records: r } = data.joints;
  const { at, layout, constraint } = joint;
  const { rows, work, impulse, jacobian } = layout;
  const softness = r[at + j.SOFTNESS]!;
  const feedback = r[at + j.FEEDBACK]!;
  multiplyRows(data, joint, jacobian, false);
  for (let n = 0; n < rows; n += 1) {
    r[at + work + n] = -softness * (r[at + work + n]! + r[at + layout.bias + n]!);
  }
  solveBounded(r, joint, impulse, layout.farBias, feedback);
  for (let n = 0; n < rows; n += 1) {
    const old = r[at + impulse + n]!;
    r[at + work + n] = (1 - feedback) * old + r[at + work + n]!;
  }
  if (isCustom(constraint)) {
    clampCustom(data, joint, constraint);
  }
  if (r[at + j.CHECKED] !== 0 && cutOrBreak(data, joint)) {
    return;
  }
  for (let n = 0; n < rows; n += 1) {
    const next = r[at + work + n]!;
    r[at + work + n] = next - r[at + impulse + n]!;
    r[at + impulse + n] = next;
  }
  applyRows(data, joint, jacobian, work, 1, false);
}

/**
 * Clamps an impulse to its range, which is that of the nearer bound. If it is out of it, and to get to the farther bound takes the impulse
 * `way` more in the other direction, that may still leave one which pushes back from there: then this is the result.
 */
export function clampToBounds(impulse: number, low: number, high: number, way: number): number {
  // If `way` is not a number, as for rows that nothing can move, the comparisons with it are false.
  if (impulse < low) return impulse + way < low ? impulse + way : low;
  if (impulse > high) return impulse - way > high ? impulse - way : high;
  return impulse;
}

/**
 * Multiplies the numbers at `work` by K⁻¹, but so that the last row's impulse stays within its range. At the offset `impulse` are those so
 * far, or corrections; at `far` is `farBias` or `farError`.
 */
function solveBounded(r: Float64Array, joint: Joint, impulse: number, far: number, feedback: number): void {
  const { at, layout, constraint } = joint;
  const { rows, work, matrix } = layout;
  forward(r, at + matrix, rows, r, at + work);
  if (constraint.bounded) {
    const last = rows - 1;
    const kept = (1 - feedback) * r[at + impulse + last]!;
    const next = kept + r[at + work + last]!;
    const low = r[at + layout.low]!;
    const high = r[at + layout.high]!;
    const way = r[at + matrix + rows * rows - 1]! * r[at + far]!;
    r[at + work + last] = clampToBounds(next, low, high, way) - kept;
  }
  backward(r, at + matrix, rows, r, at + work);
}

/** Lets the callback clamp the impulse. It is shown that of the whole step: as if all sub-steps were as strong as this one. */
function clampCustom(data: SolverData, joint: Joint, constraint: CustomConstraint): void {
  const { records: r, substeps } = data.joints;
  const { at, layout } = joint;
  const { rows, work } = layout;
  if (constraint.callbacks.velocityClamp === undefined) {
    return;
  }
  for (let n = 0; n < rows; n += 1) {
    r[at + work + n] = r[at + work + n]! * substeps;
  }
  showPoses(data, joint, false);
  constraint.clamp('velocityClamp', r, at + work);
  for (let n = 0; n < rows; n += 1) {
    r[at + work + n] = r[at + work + n]! / substeps;
  }
  if (constraint.failed) {
    silence(data.joints, joint);
  }
}

/**
 * Finds the error and Jacobian, from which the sweeps that follow take the error as linear, and raises `left` to the error. A joint whose
 * error breaks it is not corrected. This is done in each iteration, though it takes a third of a step. Refused: leaving it out in the
 * second one where errors were below 4 mm: small pulleys gained up to 28 times as much energy; and with a bound so low that none gains,
 * hardly any joint is left out.
 */
export function lineariseBlock(data: SolverData, joint: Joint): void {
  const { records: r } = data.joints;
  if (r[joint.at + j.PUSH] === 0) {
    return;
  }
  measure(data, joint, true);
  if (r[joint.at + j.PUSH] !== 0) {
    lineariseMeasured(data, joint);
  }
}

/** The same for a joint whose error and Jacobian are written already. */
export function lineariseMeasured(data: SolverData, joint: Joint): void {
  const { records: r, left } = data.joints;
  const { at, layout } = joint;
  for (let k = 0; k < layout.members; k += 1) {
    r[at + layout.placed + k] = data.motion[data.joints.bodies[joint.first + k]! + d.QW]!;
  }
  findLength(r, at + layout.error, violatedRows(r, joint, layout.error));
  const error = length[0]!;
  if (error > r[at + j.MAX_ERROR]!) {
    breakJoint(data.joints, joint);
    return;
  }
  left[0] = Math.max(left[0]!, error);
  correct(data, joint, error);
}

/**
 * Whether a member of a joint has turned by more than BLOCK_FAR_TURN since the joint was linearised. Not if that would allow it more than it
 * may be corrected by at once.
 */
export function hasTurned({ joints, motion: q }: SolverData, { at, layout, first }: Joint): boolean {
  const { records: r, bodies } = joints;
  const reach = r[at + j.REACH]!;
  if (r[at + j.PUSH] === 0 || (reach > 0 && reach < Infinity)) return false;
  let n = first & d.OFFSET;
  const from = (at + layout.placed) & d.OFFSET;
  const to = from + layout.members;
  for (let i = from; i < to; i += 1, n += 1) {
    const turn = q[(bodies[n]! & d.OFFSET) + d.QW]! - r[i]!;
    if (turn > BLOCK_FAR_TURN || turn < -BLOCK_FAR_TURN) return true;
  }
  return false;
}

/** Writes K for corrections, and the part of an error of the length `error` that is to be corrected, without its linear part. */
function correct(data: SolverData, joint: Joint, error: number): void {
  const { records: r } = data.joints;
  const { at, layout } = joint;
  const { rows, turned, work } = layout;
  r[at + j.SNAPPED] = error > JOINT_SNAP && r[at + j.SNAPS] !== 0 ? 1 : 0;
  if (r[at + j.SNAPPED] !== 0) {
    dropTurning(data, joint);
  }
  writeMatrix(data, joint, turned);
  const reach = r[at + j.REACH]!;
  const share = reach < 0 ? Math.max(0, 1 + reach / error) : reach / error;
  multiplyRows(data, joint, turned, true);
  for (let n = 0; n < rows; n += 1) {
    const e = at + layout.error + n;
    r[e] = (share < 1 ? share * r[e]! : r[e]!) - r[at + work + n]!;
  }
}

/** Drops the turning from all rows that can be corrected without it. */
function dropTurning(data: SolverData, joint: Joint): void {
  const { records: r, bodies } = data.joints;
  const { at, layout, first } = joint;
  const { rows, members, turned } = layout;
  for (let n = 0; n < rows; n += 1) {
    const row = at + turned + 3 * n * members;
    let mass = 0;
    for (let k = 0; k < members; k += 1) {
      const x = r[row + 3 * k]!;
      const y = r[row + 3 * k + 1]!;
      mass += data.motion[bodies[first + k]! + d.INV_MASS]! * (x * x + y * y);
    }
    for (let k = 0; k < members && mass > MIN_INVERSE_MASS; k += 1) {
      r[row + 3 * k + 2] = 0;
    }
  }
}

/** One position sweep: moves the bodies by −M⁻¹·Jᵀ·K⁻¹·C, with C as linear in the motion. */
export function pushBlock(data: SolverData, joint: Joint): void {
  const { records: r } = data.joints;
  const { at, layout, constraint } = joint;
  const { rows, work, push, turned } = layout;
  if (r[at + j.PUSH] === 0) {
    return;
  }
  multiplyRows(data, joint, turned, true);
  for (let n = 0; n < rows; n += 1) {
    r[at + work + n] = -(r[at + layout.error + n]! + r[at + work + n]!);
  }
  solveBounded(r, joint, push, layout.farError, 0);
  if (isCustom(constraint) && constraint.callbacks.positionClamp !== undefined) {
    showPoses(data, joint, true);
    constraint.clamp('positionClamp', r, at + work);
    if (constraint.failed) {
      silence(data.joints, joint);
    }
  }
  for (let n = 0; n < rows; n += 1) {
    r[at + push + n] = r[at + push + n]! + r[at + work + n]!;
  }
  applyRows(data, joint, turned, work, 1, true);
}

/** Raises `left` to the error now, as linear in the motion, if that is larger. */
export function measureBlock(data: SolverData, joint: Joint): void {
  const { records: r, left } = data.joints;
  const { at, layout } = joint;
  if (r[at + j.PUSH] !== 0) {
    multiplyRows(data, joint, layout.turned, true);
    for (let n = 0; n < layout.rows; n += 1) {
      r[at + layout.work + n] = r[at + layout.error + n]! + r[at + layout.work + n]!;
    }
    findLength(r, at + layout.work, violatedRows(r, joint, layout.work));
    left[0] = Math.max(left[0]!, length[0]!);
  }
}

/**
 * Whether the one row of a joint points elsewhere than at the start of the sub-step, as that of a short rope that swings does. Momentum
 * along the row of the start keeps energy as long as both are about the same (RATTLE); far from it, that would make any amount of energy,
 * and momentum is made along the row of the correction instead.
 */
function hasTurnedFar({ joints: { records: r } }: SolverData, { at, layout }: Joint): boolean {
  const { members, jacobian, turned } = layout;
  let dot = 0;
  let square = 0;
  for (let k = 0; k < members; k += 1) {
    const p = at + jacobian + 3 * k;
    const t = at + turned + 3 * k;
    dot += r[p]! * r[t]! + r[p + 1]! * r[t + 1]!;
    square += r[p]! * r[p]! + r[p + 1]! * r[p + 1]!;
  }
  return dot < ROW_TURN * square;
}

/** Ends a sub-step: makes momentum of a share of the corrections, and adds up what the joint gave. */
export function finishBlock(data: SolverData, joint: Joint): void {
  const { records: r, share } = data.joints;
  const { at, layout, constraint } = joint;
  const { rows, members, push, impulse, jacobian, total, carried, given, turned } = layout;
  const carry = share[0]! * r[at + j.CARRY]!;
  const along = rows === 1 && hasTurnedFar(data, joint) ? turned : jacobian;
  if (carry !== 0) {
    applyRows(data, joint, along, push, carry, false);
  }
  for (let n = 0; n < rows; n += 1) {
    const held = r[at + impulse + n]!;
    const pushed = carry * r[at + push + n]!;
    r[at + total + n] = r[at + total + n]! + held;
    r[at + carried + n] = r[at + carried + n]! + pushed;
    let p = at + jacobian + 3 * n * members;
    let q = at + along + 3 * n * members;
    for (let g = at + given; g < at + given + 3 * members; g += 1, p += 1, q += 1) {
      r[g] = r[g]! + r[p]! * held + r[q]! * pushed;
    }
  }
  if (isCustom(constraint) && r[at + j.PUSH] !== 0 && r[at + j.SNAPPED] === 0) {
    r.copyWithin(at + jacobian, at + turned, at + turned + 3 * members * rows);
  }
}

/** Ends a step: writes the results back to the constraint. */
export function storeBlock(data: SolverData, joint: Joint): void {
  const { records: r } = data.joints;
  const { at, layout } = joint;
  const { impulse, given } = joint.constraint;
  for (let n = 0; n < layout.rows; n += 1) {
    impulse[n] = remember(data, impulse[n]! * data.impulseScale, r[at + layout.impulse + n]!);
  }
  for (let k = 0; k < 3 * layout.members; k += 1) {
    given[k] = r[at + layout.given + k]!;
  }
}
