import { MIN_LENGTH } from '../../../config.js';
import { ROW_TURN } from '../../../config-joints.js';
import type { DistanceConstraint } from '../../../constraint/distance.js';
import { COS, ROW_AW, ROW_AX, ROW_AY, ROW_BW, ROW_BX, ROW_BY, SIN, X, Y } from '../../../constraint/layout.js';
import type { SolverData } from '../../data.js';
import * as d from '../../layout.js';
import type { Joint } from '../joint-data.js';
import * as j from '../joint-layout.js';
import { beginBound, beginSpring, clampToBounds, isSlack, lineariseMeasured, noteError } from './blocks.js';
import { tear } from './breaking.js';
import { applyRows, length, writeMatrix } from './jacobian.js';
import { around, compareWithBounds, turnAround } from './pose.js';

/**
 * Distances: block joints with one row between two bodies, straight-line, whose anchors, bounds and direction are in their records. What is
 * not here is done in `blocks.ts`.
 */

/** The place of each body, and the arm of its anchor: scratch of `findArm`. */
const arms = /* @__PURE__ */ new Float64Array(8);
const ARM_X = 0;
const ARM_Y = 1;
const PLACE_X = 2;
const PLACE_Y = 3;
const ARM = 4;

/** Writes the own numbers of a distance, after `packBlock`. */
export function packDistance({ joints: { records: r } }: SolverData, { at, layout, constraint }: Joint): void {
  const { link, anchors, upper } = constraint as DistanceConstraint;
  const o = at + layout.own;
  for (let k = 0; k < 4; k += 1) {
    r[o + j.DISTANCE_ANCHORS + k] = anchors[k]!;
  }
  r[o + j.DISTANCE_NX] = link.nx;
  r[o + j.DISTANCE_NY] = link.ny;
  r[o + j.DISTANCE_LOWER] = constraint.lowerLimit();
  r[o + j.DISTANCE_UPPER] = upper;
}

/** Ends a step: keeps the direction. */
export function storeDistance({ joints: { records: r } }: SolverData, { at, layout, constraint }: Joint): void {
  const { link } = constraint as DistanceConstraint;
  link.nx = r[at + layout.own + j.DISTANCE_NX]!;
  link.ny = r[at + layout.own + j.DISTANCE_NY]!;
}

/** Finds where member `k` of a joint is, at the start of the sub-step or, if `moving`, within it, and the arm of its anchor. */
function findArm(data: SolverData, { at, layout, first, constraint }: Joint, k: number, moving: boolean): void {
  const { records: r, bodies } = data.joints;
  const { pose: p, motion: q } = data;
  const b = bodies[first + k]! & d.OFFSET;
  const o = (at + layout.own + j.DISTANCE_ANCHORS + 2 * k) & d.OFFSET;
  const to = ARM * k;
  let x = p[b + X]!;
  let y = p[b + Y]!;
  let cos = p[b + COS]!;
  let sin = p[b + SIN]!;
  if (b === 0) {
    const body = constraint.members[k]!;
    x = body.x;
    y = body.y;
    cos = body.cos;
    sin = body.sin;
  } else if (moving) {
    around[0] = q[b + d.QW]!;
    turnAround();
    const c = around[1]!;
    const s = around[2]!;
    const c0 = cos;
    x += q[b + d.QX]!;
    y += q[b + d.QY]!;
    cos = cos * c - sin * s;
    sin = sin * c + c0 * s;
  }
  arms[to + ARM_X] = cos * r[o]! - sin * r[o + 1]!;
  arms[to + ARM_Y] = sin * r[o]! + cos * r[o + 1]!;
  arms[to + PLACE_X] = x;
  arms[to + PLACE_Y] = y;
}

/**
 * Writes error, range and Jacobian for the placement with which the sub-step begins or, if `moving`, that reached within it: as its
 * namesake in `pose.ts`.
 */
function measure(data: SolverData, joint: Joint, moving: boolean): void {
  const { records: r } = data.joints;
  const { layout } = joint;
  findArm(data, joint, 0, moving);
  findArm(data, joint, 1, moving);
  const i = joint.at & d.OFFSET;
  const o = (i + layout.own) & d.OFFSET;
  const ax = arms[ARM_X]!;
  const ay = arms[ARM_Y]!;
  const bx = arms[ARM + ARM_X]!;
  const by = arms[ARM + ARM_Y]!;
  const dx = arms[ARM + PLACE_X]! + bx - arms[PLACE_X]! - ax;
  const dy = arms[ARM + PLACE_Y]! + by - arms[PLACE_Y]! - ay;
  const distance = Math.sqrt(dx * dx + dy * dy);
  if (distance > MIN_LENGTH) {
    r[o + j.DISTANCE_NX] = dx / distance;
    r[o + j.DISTANCE_NY] = dy / distance;
  }
  const nx = r[o + j.DISTANCE_NX]!;
  const ny = r[o + j.DISTANCE_NY]!;
  const p = (i + (moving ? layout.turned : layout.jacobian)) & d.OFFSET;
  r[p + ROW_AX] = -nx;
  r[p + ROW_AY] = -ny;
  r[p + ROW_AW] = ay * nx - ax * ny;
  r[p + ROW_BX] = nx;
  r[p + ROW_BY] = ny;
  r[p + ROW_BW] = bx * ny - by * nx;
  r[i + layout.error] = distance;
  compareWithBounds(r, joint, r[o + j.DISTANCE_LOWER]!, r[o + j.DISTANCE_UPPER]!);
}

/** Starts a sub-step, as `warmStartBlock`. */
export function warmStartDistances(data: SolverData, start: number, end: number): void {
  const { records: r, joints } = data.joints;
  const { impulse, push, error, jacobian } = joints[start]!.layout;
  for (let m = start; m < end; m += 1) {
    const joint = joints[m]!;
    const i = joint.at & d.OFFSET;
    measure(data, joint, false);
    writeMatrix(data, joint, jacobian);
    r[i + push] = 0;
    if (joint.constraint.isElastic) {
      beginSpring(data, joint);
    } else {
      beginBound(data, joint);
    }
    if (r[i + j.PUSH] !== 0) {
      length[0] = isSlack(r, joint, error) ? 0 : Math.abs(r[i + error]!);
      noteError(data, m);
    }
    applyRows(data, joint, jacobian, impulse, 1, false);
  }
}

/** As `lineariseBlock`. */
export function lineariseDistance(data: SolverData, joint: Joint): void {
  if (data.joints.records[joint.at + j.PUSH] !== 0) {
    measure(data, joint, true);
    lineariseMeasured(data, joint);
  }
}

/**
 * One sweep, from the first to the last, or back. Over velocities: λ → clamp(λ − (J·v + bias) · softness / K − feedback · λ); or, if
 * `isPush`, over the motion of the sub-step, with C as linear in it.
 */
export function sweepDistances(data: SolverData, start: number, end: number, isBack: boolean, isPush: boolean): void {
  const { records: r, bodies, joints } = data.joints;
  const v = isPush ? data.motion : data.velocity;
  const { size, impulse, push, bias, error, jacobian, turned, matrix, low, high, farBias, farError, total } =
    joints[start]!.layout;
  const step = isBack ? -1 : 1;
  let m = isBack ? end - 1 : start;
  let i = joints[m]!.at & d.OFFSET;
  let n = joints[m]!.first & d.OFFSET;
  for (; m >= start && m < end; m += step, i = (i + step * size) & d.OFFSET, n = (n + 2 * step) & d.OFFSET) {
    if (isPush && r[i + j.PUSH] === 0) {
      continue;
    }
    const a = bodies[n]! & d.OFFSET;
    const b = bodies[n + 1]! & d.OFFSET;
    const p = (i + (isPush ? turned : jacobian)) & d.OFFSET;
    const o = (i + (isPush ? push : impulse)) & d.OFFSET;
    const softness = isPush ? 1 : r[i + j.SOFTNESS]!;
    const feedback = isPush ? 0 : r[i + j.FEEDBACK]!;
    const ax = r[p]!;
    const ay = r[p + 1]!;
    const aw = r[p + 2]!;
    const bx = r[p + 3]!;
    const by = r[p + 4]!;
    const bw = r[p + 5]!;
    const vax = v[a + d.VX]!;
    const vay = v[a + d.VY]!;
    const wA = v[a + d.W]!;
    const vbx = v[b + d.VX]!;
    const vby = v[b + d.VY]!;
    const wB = v[b + d.W]!;
    // In pairs: one sum after the other takes twice as long.
    const c = ax * vax + ay * vay + (bx * vbx + by * vby) + (aw * wA + bw * wB + r[i + (isPush ? error : bias)]!);
    const old = r[o]!;
    const least = r[i + low]!;
    const most = r[i + high]!;
    let next = old - feedback * old - softness * r[i + matrix]! * c;
    next = clampToBounds(next, least, most, r[i + matrix]! * r[i + (isPush ? farError : farBias)]!);
    if (!isPush && r[i + j.CHECKED] !== 0) {
      const sum = r[i + total]! + next;
      const breaking = r[i + j.BREAK]!;
      if (sum > breaking || sum < -breaking) {
        tear(data, joints[m]!);
        continue;
      }
      const limit = r[i + j.LIMIT]!;
      // One that was spared gives way: see `breaking.ts`.
      if (Math.abs(next) > limit && joints[m]!.constraint.breakUnderForce) r[i + j.PUSH] = 0;
      next = next > limit ? limit : next < -limit ? -limit : next;
    }
    const lambda = next - old;
    r[o] = next;
    const mA = v[a + d.INV_MASS]! * lambda;
    const mB = v[b + d.INV_MASS]! * lambda;
    v[a + d.VX] = vax + mA * ax;
    v[a + d.VY] = vay + mA * ay;
    v[a + d.W] = wA + v[a + d.INV_INERTIA]! * lambda * aw;
    v[b + d.VX] = vbx + mB * bx;
    v[b + d.VY] = vby + mB * by;
    v[b + d.W] = wB + v[b + d.INV_INERTIA]! * lambda * bw;
  }
}

/** Ends a sub-step, as `finishBlock`. */
export function finishDistances(data: SolverData, start: number, end: number): void {
  const { records: r, joints, share } = data.joints;
  const { push, impulse, jacobian, turned, total, carried, given } = joints[start]!.layout;
  for (let m = start; m < end; m += 1) {
    const joint = joints[m]!;
    const i = joint.at & d.OFFSET;
    const p = (i + jacobian) & d.OFFSET;
    const t = (i + turned) & d.OFFSET;
    const g = (i + given) & d.OFFSET;
    const ax = r[p]!;
    const ay = r[p + 1]!;
    const bx = r[p + 3]!;
    const by = r[p + 4]!;
    // As `hasTurnedFar`.
    const dot = ax * r[t]! + ay * r[t + 1]! + (bx * r[t + 3]! + by * r[t + 4]!);
    const along = dot < ROW_TURN * (ax * ax + ay * ay + (bx * bx + by * by)) ? t : p;
    const carry = share[0]! * r[i + j.CARRY]!;
    const held = r[i + impulse]!;
    const pushed = carry * r[i + push]!;
    if (carry !== 0) {
      applyRows(data, joint, along - i, push, carry, false);
    }
    r[i + total] = r[i + total]! + held;
    r[i + carried] = r[i + carried]! + pushed;
    for (let c = 0; c < 6; c += 1) {
      r[g + c] = r[g + c]! + r[p + c]! * held + r[along + c]! * pushed;
    }
  }
}
