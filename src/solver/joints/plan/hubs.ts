import { HUB_SHARE } from '../../../config-joints.js';
import { grown } from '../../../math/doubles.js';
import { backward, forward } from '../../../math/solve.js';
import { recordAt, type SolverData } from '../../data.js';
import * as d from '../../layout.js';
import type { Group, Joint, Run } from '../joint-data.js';
import * as j from '../joint-layout.js';

// A group is swept over from its first joint to its last, each sub-step starts with the impulses of the last one, and corrections make
// momentum. So what a sweep leaves of an error comes back in the next sub-steps. Where it goes round among joints on one body, as among the
// spokes of a wheel, it grows with each turn, however many sweeps there are and however short the sub-step is. Sweeps to and fro leave
// errors that never go round: their iteration, symmetric Gauss–Seidel, has real eigenvalues from 0 to 1 (Young, "Iterative Solution of
// Large Linear Systems", 1971). They take twice as long, and are only needed where one body gives way more easily than what hangs on it.

/**
 * How much of a joint's correction one of its bodies does is the matrix S = M^−½·Jᵀ·K⁻¹·J·M^−½ of that body: 3 × 3, with eigenvalues from
 * 0, if the other body does all, to 1. For each body by its slot: how many joints it has, and the sum of these matrices.
 */
const JOINTS = 0;
const XX = 1;
const XY = 2;
const XW = 3;
const YY = 4;
const YW = 5;
const WW = 6;
const SUM = 7;
let sums = /* @__PURE__ */ new Float64Array(0);

/** Scratch: a column of J·M^−½, then of K⁻¹·J·M^−½. */
let column = /* @__PURE__ */ new Float64Array(8);

/** Whether a group has a hub: a body with so many joints that gives way so easily that the group has to be swept over to and fro. */
export function hasHub(data: SolverData, group: Group): boolean {
  const { items, count } = group.bodies;
  if (sums.length < SUM * data.bodyCount) {
    sums = new Float64Array(SUM * grown(data.bodyCount));
  }
  for (let n = 0; n < count; n += 1) {
    clear(sumAt(items[n]!));
  }
  for (let i = 0; i < group.runs.length; i += 1) {
    addRun(data, group.runs[i]!);
  }
  for (let n = 0; n < count; n += 1) {
    const at = sumAt(items[n]!);
    if (sums[at + JOINTS]! > 2 && isHub(at)) {
      return true;
    }
  }
  return false;
}

function clear(at: number): void {
  for (let i = at; i < at + SUM; i += 1) {
    sums[i] = 0;
  }
}

/** Where the sum of a body begins, by the offset of its record; 0 for what cannot move. */
function sumAt(body: number): number {
  return (body / d.BODY_STRIDE) * SUM;
}

/** Adds the matrices of all members of the joints of a run. */
function addRun(data: SolverData, { kernel, start, end }: Run): void {
  const { joints } = data.joints;
  for (let k = start; k < end; k += 1) {
    if (kernel === j.POINT) {
      addPoint(data, joints[k]!, j.ARM_AX, 0);
      addPoint(data, joints[k]!, j.ARM_BX, 1);
    } else {
      addMembers(data, joints[k]!);
    }
  }
}

function addMembers(data: SolverData, joint: Joint): void {
  const { bodies } = data.joints;
  const { first, layout } = joint;
  for (let n = 0; n < layout.members; n += 1) {
    const at = sumAt(bodies[first + n]!);
    if (at === 0) {
      continue;
    }
    if (joint.kernel === j.TURN) {
      addTurn(data, joint, n, at);
    } else {
      addBlock(data, joint, n, at);
    }
  }
}

/** Adds a point: its J has the rows (1, 0, −y) and (0, 1, x), with the arm (x, y). */
function addPoint(
  { points: r, pointBodies, velocity: v }: SolverData,
  { slot }: Joint,
  arm: number,
  end: number,
): void {
  const i = recordAt(slot, j.POINT_STRIDE);
  const b = pointBodies[2 * slot + end]! & d.OFFSET;
  const x = r[i + arm]!;
  const y = r[i + arm + 2]!;
  const m = v[b + d.INV_MASS]!;
  const w = v[b + d.INV_INERTIA]!;
  const mixed = Math.sqrt(m * w);
  const i11 = r[i + j.I11]!;
  const i12 = r[i + j.I12]!;
  const i22 = r[i + j.I22]!;
  const at = sumAt(b);
  sums[at + JOINTS] = sums[at + JOINTS]! + 1;
  sums[at + XX] = sums[at + XX]! + m * i11;
  sums[at + XY] = sums[at + XY]! + m * i12;
  sums[at + XW] = sums[at + XW]! + mixed * (i12 * x - i11 * y);
  sums[at + YY] = sums[at + YY]! + m * i22;
  sums[at + YW] = sums[at + YW]! + mixed * (i22 * x - i12 * y);
  sums[at + WW] = sums[at + WW]! + w * (i11 * y * y - 2 * i12 * x * y + i22 * x * x);
}

/** Adds an angle or motor. One that could be held at a bound, but is not, does nothing. */
function addTurn(
  { velocity: v, joints: { records: r, bodies } }: SolverData,
  joint: Joint,
  member: number,
  at: number,
): void {
  const { at: i, first } = joint;
  const ratio = member === 0 ? 1 : r[i + j.TURN_RATIO]!;
  const isOneSided = r[i + j.TURN_LOW] !== -Infinity || r[i + j.TURN_HIGH] !== Infinity;
  if (isOneSided && r[i + j.TURN_IMPULSE] === 0) {
    return;
  }
  sums[at + JOINTS] = sums[at + JOINTS]! + 1;
  sums[at + WW] = sums[at + WW]! + v[bodies[first + member]! + d.INV_INERTIA]! * ratio * ratio * r[i + j.TURN_MASS]!;
}

function addBlock(
  { velocity: v, joints: { records: r, bodies } }: SolverData,
  joint: Joint,
  member: number,
  at: number,
): void {
  const { at: i, first, layout } = joint;
  const { rows, members, jacobian, matrix } = layout;
  const b = bodies[first + member]!;
  const m = Math.sqrt(v[b + d.INV_MASS]!);
  const w = Math.sqrt(v[b + d.INV_INERTIA]!);
  if (column.length < rows) {
    column = new Float64Array(rows);
  }
  sums[at + JOINTS] = sums[at + JOINTS]! + 1;
  // Goes through the elements from XX to WW.
  let to = at + XX;
  for (let c = 0; c < 3; c += 1) {
    for (let n = 0; n < rows; n += 1) {
      column[n] = (c < 2 ? m : w) * r[i + jacobian + 3 * (n * members + member) + c]!;
    }
    forward(r, i + matrix, rows, column, 0);
    backward(r, i + matrix, rows, column, 0);
    for (let other = c; other < 3; other += 1, to += 1) {
      for (let n = 0; n < rows; n += 1) {
        const p = i + jacobian + 3 * (n * members + member) + other;
        sums[to] = sums[to]! + (other < 2 ? m : w) * r[p]! * column[n]!;
      }
    }
  }
}

/**
 * Whether the largest eigenvalue of the sum S is too large: HUB_SHARE · 1 − S has leading minors that are not all positive (Sylvester's
 * criterion).
 */
function isHub(at: number): boolean {
  const xx = HUB_SHARE - sums[at + XX]!;
  const xy = sums[at + XY]!;
  const xw = sums[at + XW]!;
  const yy = HUB_SHARE - sums[at + YY]!;
  const yw = sums[at + YW]!;
  const ww = HUB_SHARE - sums[at + WW]!;
  const minor = xx * yy - xy * xy;
  return !(xx > 0 && minor > 0 && ww * minor - xx * yw * yw - yy * xw * xw - 2 * xy * xw * yw > 0);
}
