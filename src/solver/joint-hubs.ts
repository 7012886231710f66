import { HUB_SHARE } from '../config-joints.js';
import { backward, forward } from '../math/solve.js';
import { recordAt, type SolverData } from './data.js';
import type { Group, Joint } from './joint-data.js';
import * as j from './joint-layout.js';
import * as d from './layout.js';

// A group is swept over from its first joint to its last, each sub-step starts with the impulses of the last one, and of corrections momentum is made. So what a sweep leaves of an
// error comes back in the next sub-steps, and where it goes round among joints on one body, as among the spokes of a wheel, it grows with each turn, however many sweeps there are and
// however short the sub-step. Sweeps to and fro leave errors that never turn: their iteration, symmetric Gauss–Seidel, has real eigenvalues from 0 to 1 (Young, "Iterative Solution of Large
// Linear Systems", 1971). They take twice as long, and are only needed where one body gives way more easily than what hangs on it.

/**
 * How much of what a joint asks for is done by one of its bodies is S = M^−½·Jᵀ·K⁻¹·J·M^−½ of that body: 3 × 3, with eigenvalues from 0, the other does all, to 1. Of each body by its slot: how
 * many joints it has, and the sum of these matrices, [xx, xy, xw, yy, yw, ww].
 */
const SUM = 7;
let sums = new Float64Array(0);

/** Rounds of the power method. */
const ROUNDS = 12;

/** A column of J·M^−½, then of K⁻¹·J·M^−½: scratch. */
let column = new Float64Array(8);

/** Whether a group has a body with so many joints, and gives way so easily, that it has to be swept over to and fro. */
export function hasHub(data: SolverData, group: Group): boolean {
  const { joints, bodies } = data.joints;
  if (sums.length < SUM * data.bodyCount) {
    sums = new Float64Array(2 * SUM * data.bodyCount);
  }
  for (let k = group.start; k < group.end; k += 1) {
    const { first, layout } = joints[k]!;
    for (let n = first; n < first + layout.members; n += 1) {
      const at = sumAt(bodies[n]!);
      for (let i = at; i < at + SUM; i += 1) sums[i] = 0;
    }
  }
  let isFound = false;
  for (let k = group.start; k < group.end && !isFound; k += 1) {
    const joint = joints[k]!;
    const { first, layout } = joint;
    for (let n = 0; n < layout.members; n += 1) {
      const at = sumAt(bodies[first + n]!);
      if (at > 0 && add(data, joint, n, at)) {
        sums[at] = sums[at]! + 1;
        isFound ||= sums[at]! > 2 && isHub(at);
      }
    }
  }
  return isFound;
}

/** By the offset of its records; 0 for what cannot move. */
function sumAt(body: number): number {
  return (body / d.BODY_STRIDE) * SUM;
}

/** Adds what a member of a joint does. @returns whether it does anything. */
function add(data: SolverData, joint: Joint, member: number, at: number): boolean {
  if (joint.kernel === j.POINT) {
    addPoint(data, joint, member, at);
    return true;
  }
  if (joint.kernel === j.TURN) {
    return addTurn(data, joint, member, at);
  }
  addBlock(data, joint, member, at);
  return true;
}

/** J of a point is (1, 0, −y) and (0, 1, x), with the arm (x, y). */
function addPoint(
  { points: r, velocity: v, joints: { bodies } }: SolverData,
  joint: Joint,
  member: number,
  at: number,
): void {
  const i = recordAt(joint.slot, j.POINT_STRIDE);
  const arm = i + (member === 0 ? j.ARM_AX : j.ARM_BX);
  const b = bodies[joint.first + member]!;
  const x = r[arm]!;
  const y = r[arm + 2]!;
  const m = v[b + d.INV_MASS]!;
  const w = v[b + d.INV_INERTIA]!;
  const mixed = Math.sqrt(m * w);
  const i11 = r[i + j.I11]!;
  const i12 = r[i + j.I12]!;
  const i22 = r[i + j.I22]!;
  sums[at + 1] = sums[at + 1]! + m * i11;
  sums[at + 2] = sums[at + 2]! + m * i12;
  sums[at + 3] = sums[at + 3]! + mixed * (i12 * x - i11 * y);
  sums[at + 4] = sums[at + 4]! + m * i22;
  sums[at + 5] = sums[at + 5]! + mixed * (i22 * x - i12 * y);
  sums[at + 6] = sums[at + 6]! + w * (i11 * y * y - 2 * i12 * x * y + i22 * x * x);
}

/** One that may be held at a bound, but is not, does nothing. */
function addTurn(
  { velocity: v, joints: { records: r, bodies } }: SolverData,
  joint: Joint,
  member: number,
  at: number,
): boolean {
  const { at: i, first } = joint;
  const ratio = member === 0 ? 1 : r[i + j.TURN_RATIO]!;
  const isOneSided = r[i + j.TURN_LOW] !== -Infinity || r[i + j.TURN_HIGH] !== Infinity;
  if (isOneSided && r[i + j.TURN_IMPULSE] === 0) {
    return false;
  }
  sums[at + 6] = sums[at + 6]! + v[bodies[first + member]! + d.INV_INERTIA]! * ratio * ratio * r[i + j.TURN_MASS]!;
  return true;
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
  let to = at + 1;
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

/** Whether the largest eigenvalue of the sum is too large, by the power method. */
function isHub(at: number): boolean {
  const xx = sums[at + 1]!;
  const xy = sums[at + 2]!;
  const xw = sums[at + 3]!;
  const yy = sums[at + 4]!;
  const yw = sums[at + 5]!;
  const ww = sums[at + 6]!;
  if (xx + yy + ww <= HUB_SHARE) {
    return false;
  }
  let x = 0.6;
  let y = 0.5;
  let w = 0.7;
  let most = 0;
  for (let round = 0; round < ROUNDS; round += 1) {
    const size = Math.sqrt(x * x + y * y + w * w) || 1;
    const nextX = (xx * x + xy * y + xw * w) / size;
    const nextY = (xy * x + yy * y + yw * w) / size;
    w = (xw * x + yw * y + ww * w) / size;
    x = nextX;
    y = nextY;
    most = Math.sqrt(x * x + y * y + w * w);
  }
  return most > HUB_SHARE;
}
