import { GRADIENT_LOST, JOINT_STILL } from '../config-joints.js';
import { grown } from '../math/doubles.js';
import type { SolverData } from './data.js';
import type { Group } from './joint-data.js';
import { POINT, TURN } from './joint-layout.js';
import { boundAt, constantAt, impulseAt, numbersOf, pushAt } from './joint-numbers.js';
import * as d from './layout.js';

// Joints that hang together, solved to their end: conjugate gradients, of which each is what a sweep changes (Hestenes and Stiefel 1952; Golub and Ye, "Inexact Preconditioned Conjugate Gradient Method", 1999). What the last sweep did
// is taken out of it, and it is followed as far as leaves the least energy, so that the energy of the error never grows: ten sweeps do what hundreds would.

/** Offsets of the bodies of the group that can move, each once, … */
let movers = new Int32Array(0);
/** … and their masses, kg, and inertias, kg·m². */
let masses = new Float64Array(0);
let moverCount = 0;
/** … by slot, in which call a body was found last, … */
let found = new Int32Array(0);
let call = 0;
/** … and velocities or motions of these, three numbers each, then impulses or pushes of all rows: before a sweep, and the direction in which the last one went on. */
let start = new Float64Array(0);
let direction = new Float64Array(0);
let hasDirection = false;

/** Energies, twice: of the bodies as a sweep begins, of what it changed, the product of that with the direction, that of the direction, and how the energy of the error changes along it. */
const sums = new Float64Array(6);
const KINETIC = 0;
const CHANGED = 1;
const ALONG = 2;
const SQUARE = 3;
const SLOPE = 4;
const MASS = 5;

/** Before the first of several sweeps. @returns how many bodies can move. */
export function beginGradients({ joints: data, bodyCount, velocity: v }: SolverData, group: Group): number {
  const { joints, bodies } = data;
  if (found.length < bodyCount) found = new Int32Array(grown(bodyCount));
  call += 1;
  moverCount = 0;
  let rows = 0;
  for (let k = group.start; k < group.end; k += 1) {
    const { first, layout } = joints[k]!;
    rows += layout.rows;
    makeRoom(3 * (moverCount + layout.members) + rows);
    for (let m = first; m < first + layout.members; m += 1) {
      const b = bodies[m]!;
      const slot = b / d.BODY_STRIDE;
      if (found[slot] !== call && v[b + d.INV_MASS]! + v[b + d.INV_INERTIA]! > 0) {
        found[slot] = call;
        movers[moverCount] = b;
        masses[2 * moverCount] = inverse(v[b + d.INV_MASS]!);
        masses[2 * moverCount + 1] = inverse(v[b + d.INV_INERTIA]!);
        moverCount += 1;
      }
    }
  }
  hasDirection = false;
  return moverCount;
}

function makeRoom(count: number): void {
  if (start.length < count) {
    const size = grown(count);
    const before = movers;
    movers = new Int32Array(size);
    movers.set(before);
    const known = masses;
    masses = new Float64Array(2 * size);
    masses.set(known);
    start = new Float64Array(size);
    direction = new Float64Array(size);
  }
}

/** Before each sweep. */
export function noteStart(data: SolverData, group: Group, isPush: boolean): void {
  const v = isPush ? data.motion : data.velocity;
  const { joints } = data.joints;
  let n = 0;
  for (let m = 0; m < moverCount; m += 1, n += 3) {
    const b = movers[m]!;
    start[n] = v[b]!;
    start[n + 1] = v[b + 1]!;
    start[n + 2] = v[b + 2]!;
  }
  for (let k = group.start; k < group.end; k += 1) {
    const joint = joints[k]!;
    const numbers = numbersOf(data, joint);
    for (let row = 0; row < joint.layout.rows; row += 1, n += 1) {
      start[n] = numbers[isPush ? pushAt(joint, row) : impulseAt(joint, row)]!;
    }
  }
}

/** After a sweep that is not the last one. @returns whether it changed anything worth another one. */
export function goOn(data: SolverData, group: Group, isPush: boolean): boolean {
  const v = isPush ? data.motion : data.velocity;
  measureChange(v);
  const changed = sums[CHANGED]!;
  if (!(changed > JOINT_STILL * (sums[KINETIC]! + JOINT_STILL * sums[MASS]!))) {
    return false;
  }
  turn(data, group, isPush, hasDirection && sums[SQUARE]! > 0 ? sums[ALONG]! / sums[SQUARE]! : 0);
  const far = -sums[SLOPE]! / sums[SQUARE]!;
  // Where bounds hold it back it is none: the next sweep begins anew where this one ended.
  hasDirection = far > 0 && sums[SQUARE]! > GRADIENT_LOST * changed;
  if (hasDirection) {
    follow(data, group, isPush, far);
  }
  return true;
}

/** Of what the sweep changed its energy, and its product with the direction before. */
function measureChange(v: Float64Array): void {
  let kinetic = 0;
  let changed = 0;
  let along = 0;
  let square = 0;
  let total = 0;
  for (let m = 0, n = 0; m < moverCount; m += 1, n += 3) {
    const b = movers[m]! & d.OFFSET;
    const vx = start[n]!;
    const vy = start[n + 1]!;
    const vw = start[n + 2]!;
    const x = v[b]! - vx;
    const y = v[b + 1]! - vy;
    const w = v[b + 2]! - vw;
    const px = direction[n]!;
    const py = direction[n + 1]!;
    const pw = direction[n + 2]!;
    const mass = masses[2 * m]!;
    const inertia = masses[2 * m + 1]!;
    total += mass;
    kinetic += mass * (vx * vx + vy * vy) + inertia * vw * vw;
    changed += mass * (x * x + y * y) + inertia * w * w;
    along += mass * (x * px + y * py) + inertia * w * pw;
    square += mass * (px * px + py * py) + inertia * pw * pw;
  }
  sums[KINETIC] = kinetic;
  sums[CHANGED] = changed;
  sums[ALONG] = along;
  sums[SQUARE] = square;
  sums[MASS] = total;
}

/** The direction: what the sweep changed, less such a share of the direction before. Its energy, and how the energy of the error changes along it. */
function turn(data: SolverData, group: Group, isPush: boolean, share: number): void {
  const v = isPush ? data.motion : data.velocity;
  const { joints } = data.joints;
  let slope = 0;
  let square = 0;
  let n = 0;
  for (let m = 0; m < moverCount; m += 1, n += 3) {
    const b = movers[m]! & d.OFFSET;
    const px = v[b]! - start[n]! - share * direction[n]!;
    const py = v[b + 1]! - start[n + 1]! - share * direction[n + 1]!;
    const pw = v[b + 2]! - start[n + 2]! - share * direction[n + 2]!;
    const mass = masses[2 * m]!;
    const inertia = masses[2 * m + 1]!;
    slope += mass * (start[n]! * px + start[n + 1]! * py) + inertia * start[n + 2]! * pw;
    square += mass * (px * px + py * py) + inertia * pw * pw;
    direction[n] = px;
    direction[n + 1] = py;
    direction[n + 2] = pw;
  }
  for (let k = group.start; k < group.end; k += 1) {
    const joint = joints[k]!;
    const numbers = numbersOf(data, joint);
    for (let row = 0; row < joint.layout.rows; row += 1, n += 1) {
      const at = isPush ? pushAt(joint, row) : impulseAt(joint, row);
      direction[n] = numbers[at]! - start[n]! - share * direction[n]!;
      if (isPush || joint.kernel !== POINT) slope += direction[n]! * numbers[constantAt(joint, row, isPush)]!;
      if (isPush && joint.kernel === TURN) slope -= direction[n]! * numbers[boundAt(data, joint)]!;
    }
  }
  sums[SLOPE] = slope;
  sums[SQUARE] = square;
}

/** Goes so many times the direction from where the sweep began. */
function follow(data: SolverData, group: Group, isPush: boolean, far: number): void {
  const v = isPush ? data.motion : data.velocity;
  const { joints } = data.joints;
  let n = 0;
  for (let m = 0; m < moverCount; m += 1, n += 3) {
    const b = movers[m]!;
    v[b] = start[n]! + far * direction[n]!;
    v[b + 1] = start[n + 1]! + far * direction[n + 1]!;
    v[b + 2] = start[n + 2]! + far * direction[n + 2]!;
  }
  for (let k = group.start; k < group.end; k += 1) {
    const joint = joints[k]!;
    const numbers = numbersOf(data, joint);
    for (let row = 0; row < joint.layout.rows; row += 1, n += 1) {
      numbers[isPush ? pushAt(joint, row) : impulseAt(joint, row)] = start[n]! + far * direction[n]!;
    }
  }
}

/** A mass; 0 of what does not move. */
function inverse(inverseMass: number): number {
  return inverseMass > 0 ? 1 / inverseMass : 0;
}
