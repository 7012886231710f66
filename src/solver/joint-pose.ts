import { CustomConstraint } from '../constraint/custom.js';
import { ANGLE, COS, POSE, SIN, X, Y } from '../constraint/layout.js';
import { cos, sin } from '../math/trig.js';
import type { SolverData } from './data.js';
import * as d from './data.js';
import type { Joint } from './joint-data.js';

/** Placements of a joint's members at the start of the step, to its record. */
export function packPoses(data: SolverData, joint: Joint): void {
  const { records: r, bodies } = data.joints;
  const { at, layout, first, constraint } = joint;
  for (let k = 0; k < layout.members; k += 1) {
    const body = constraint.members[k]!;
    const p = at + layout.pose + k * POSE;
    r[p + X] = body.x;
    r[p + Y] = body.y;
    r[p + COS] = body.cos;
    r[p + SIN] = body.sin;
    r[p + ANGLE] = body.angle;
    bodies[first + k] = body.slot * d.BODY_STRIDE;
  }
}

/** Present placements of the members to `joints.pose`: those of the start of the sub-step or, if `moving`, those reached within it. */
function findPoses(data: SolverData, joint: Joint, moving: boolean): void {
  const { records: r, bodies, pose } = data.joints;
  const { velocity: v, motion: q } = data;
  const { at, layout, first } = joint;
  for (let k = 0; k < layout.members; k += 1) {
    const b = bodies[first + k]!;
    const p = at + layout.pose + k * POSE;
    const to = k * POSE;
    const share = moving ? 1 : 0;
    const turn = share * q[b + d.QW]!;
    let c = v[b + d.COS_LESS_ONE]! + 1;
    let s = v[b + d.SIN]!;
    if (turn !== 0) {
      const ct = cos(turn);
      const st = sin(turn);
      const c0 = c;
      c = c0 * ct - s * st;
      s = c0 * st + s * ct;
    }
    pose[to + X] = r[p + X]! + q[b + d.DX]! + share * q[b + d.QX]!;
    pose[to + Y] = r[p + Y]! + q[b + d.DY]! + share * q[b + d.QY]!;
    pose[to + COS] = r[p + COS]! * c - r[p + SIN]! * s;
    pose[to + SIN] = r[p + SIN]! * c + r[p + COS]! * s;
    pose[to + ANGLE] = r[p + ANGLE]! + q[b + d.DW]! + turn;
  }
}

/** Error and Jacobian for the present placement. */
export function measure(data: SolverData, joint: Joint, jacobian: number, moving: boolean, withError: boolean): void {
  const { records: r } = data.joints;
  const { at, layout, constraint } = joint;
  const { rows, members, error } = layout;
  r.fill(0, at + error, at + error + rows);
  r.fill(0, at + jacobian, at + jacobian + 3 * rows * members);
  if (constraint instanceof CustomConstraint) {
    showPoses(data, joint, moving);
  } else {
    findPoses(data, joint, moving);
  }
  constraint.measure(data.joints.pose, r, at + error, at + jacobian, withError);
  if (constraint instanceof CustomConstraint && constraint.failed) {
    data.joints.silence(joint);
    return;
  }
  mergeTwins(data, joint, jacobian);
  if (constraint.bounded) {
    compareWithBounds(r, joint);
  }
}

/** A body listed twice: its columns become one. */
function mergeTwins(data: SolverData, joint: Joint, jacobian: number): void {
  const { records: r } = data.joints;
  const { at, layout, twins } = joint;
  for (const [one, other] of twins) {
    for (let n = 0; n < layout.rows; n += 1) {
      const row = at + jacobian + 3 * n * layout.members;
      for (let c = 0; c < 3; c += 1) {
        r[row + 3 * one + c] = r[row + 3 * one + c]! + r[row + 3 * other + c]!;
        r[row + 3 * other + c] = 0;
      }
    }
  }
}

/**
 * The last row has been measured; its error is how far it is from the bound that it exceeds or, within, from the nearer one. Its impulse may
 * only push back, unless both bounds are one.
 */
function compareWithBounds(r: Float64Array, joint: Joint): void {
  const { at, layout, constraint } = joint;
  const { lower, upper } = constraint;
  const e = at + layout.error + layout.rows - 1;
  const value = r[e]!;
  const toUpper = upper - value;
  const toLower = value - lower;
  const isUpper = toUpper <= toLower;
  const isOpen = isUpper ? toUpper === Infinity : toLower === Infinity;
  r[e] = isOpen ? 0 : isUpper ? -toUpper : toLower;
  r[at + layout.low] = lower === upper || (isUpper && !isOpen) ? -Infinity : 0;
  r[at + layout.high] = lower === upper || (!isUpper && !isOpen) ? Infinity : 0;
}

/** Puts the members of a custom constraint to where the solver has them, for its callbacks. */
export function showPoses(data: SolverData, joint: Joint, moving: boolean): void {
  const { bodies, pose } = data.joints;
  const { velocity: v } = data;
  const { first, constraint } = joint;
  findPoses(data, joint, moving);
  constraint.members.forEach((body, k) => {
    const b = bodies[first + k]!;
    const p = k * POSE;
    if (b !== 0) {
      body.x = pose[p + X]!;
      body.y = pose[p + Y]!;
      body.cos = pose[p + COS]!;
      body.sin = pose[p + SIN]!;
      body.angle = pose[p + ANGLE]!;
      body.vx = v[b + d.VX]!;
      body.vy = v[b + d.VY]!;
      body.w = v[b + d.W]!;
    }
  });
}

/** Puts them back to where the step began; the end of the step adds their motion to that. */
export function hidePoses(data: SolverData, joint: Joint): void {
  const { records: r, bodies } = data.joints;
  const { at, layout, first, constraint } = joint;
  constraint.members.forEach((body, k) => {
    const p = at + layout.pose + k * POSE;
    if (constraint instanceof CustomConstraint && bodies[first + k] !== 0) {
      body.x = r[p + X]!;
      body.y = r[p + Y]!;
      body.cos = r[p + COS]!;
      body.sin = r[p + SIN]!;
      body.angle = r[p + ANGLE]!;
    }
  });
}
