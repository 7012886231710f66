import { GRADIENT_LOST, GRADIENT_SHARE, JOINT_STILL } from '../../../config-joints.js';
import { grown, widened } from '../../../math/doubles.js';
import { recordAt, type SolverData } from '../../data.js';
import * as d from '../../layout.js';
import type { Group, Joint } from '../joint-data.js';
import {
  ARM_AX,
  ARM_AY,
  ARM_BX,
  OFFSET_X,
  POINT,
  POINT_STRIDE,
  TURN,
  TURN_BIAS,
  TURN_LOWER,
  TURN_PUSH,
  TURN_RATIO,
  TURN_UPPER,
  TURN_VALUE,
} from '../joint-layout.js';
import { heldRows, impulseAt, pushAt } from '../joint-numbers.js';

// Solves joints that hang together to their end, by conjugate gradients, with sweeps as preconditioner: each gradient is what one sweep
// changes (Hestenes and Stiefel 1952; Golub and Ye, "Inexact Preconditioned Conjugate Gradient Method", 1999). The direction of the last
// sweep is taken out of it, and it is followed to the least energy, so the energy of the error never grows: ten sweeps do what hundreds
// would.

// Written by `beginGradients`, and valid until it is called again.

/** Offsets of the bodies of the group that can move, each once, … */
let movers = /* @__PURE__ */ new Int32Array(0);
/** … and their masses, kg, and inertias, kg·m². */
let masses = /* @__PURE__ */ new Float64Array(0);
let moverCount = 0;
/**
 * Where the impulse or push of each row of each joint is: an index into the records or, for points, whose records are another array,
 * −1 − index; …
 */
let rowAt = /* @__PURE__ */ new Int32Array(0);
/** … what a unit of it changes of the row's own velocity, kg⁻¹, (kg·m²)⁻¹; … */
let eases = /* @__PURE__ */ new Float64Array(0);
/** … and 1 if it acts only at a bound, else 0. */
let isBounded = /* @__PURE__ */ new Uint8Array(0);
let rowCount = 0;

// Carried from sweep to sweep.

/** The constant part of each row's equation, besides J·v: bias, or error. Of a row with two bounds, that of the one which acts. */
let constants = /* @__PURE__ */ new Float64Array(0);
/** They are found after the first sweep, and again once a bound took hold or let go. */
let areKnown = false;
/** The conjugate direction: velocities or motions of the movers, three numbers each, then impulses or pushes of the rows. */
let direction = /* @__PURE__ */ new Float64Array(0);
/** It was followed after the last sweep. */
let hasDirection = false;

/** The same numbers as in `direction`, as they were before the present sweep. */
let start = /* @__PURE__ */ new Float64Array(0);

/**
 * Scratch, as results would be boxed. Energies, each twice: that of the bodies as a sweep begins, that of what the sweep changed, the
 * product of that with the direction, and that of the direction; how the energy of the error changes along the direction; the mass of all
 * movers; and the energy that the direction would have if each row acted alone.
 */
const sums = /* @__PURE__ */ new Float64Array(7);
const KINETIC = 0;
const CHANGED = 1;
const ALONG = 2;
const SQUARE = 3;
const SLOPE = 4;
const MASS = 5;
const ALONE = 6;

/** Called before the first of several sweeps over velocities or, with `isPush`, positions. */
export function beginGradients(data: SolverData, group: Group, isPush: boolean): void {
  const { joints } = data.joints;
  findMovers(data, group);
  rowCount = 0;
  for (let k = group.start; k < group.end; k += 1) {
    const joint = joints[k]!;
    const { rows } = joint.layout;
    const held = heldRows(joint.constraint);
    makeRoom(3 * moverCount + rowCount + rows);
    for (let row = 0; row < rows; row += 1) {
      const at = isPush ? pushAt(joint, row) : impulseAt(joint, row);
      rowAt[rowCount] = joint.kernel === POINT ? -1 - at : at;
      isBounded[rowCount] = row < held ? 0 : 1;
      findEase(data, joint, row);
      rowCount += 1;
    }
  }
  areKnown = false;
  hasDirection = false;
}

/** Writes K of a row by itself. */
function findEase({ joints: data, velocity: v, points: p }: SolverData, joint: Joint, row: number): void {
  const { bodies, records: r } = data;
  const { kernel, at, slot, first, layout } = joint;
  const { members, jacobian } = layout;
  let sum = 0;
  for (let k = 0; k < members; k += 1) {
    const b = bodies[first + k]!;
    if (kernel === POINT) {
      const arm = p[recordAt(slot, POINT_STRIDE) + (k === 0 ? ARM_AX : ARM_BX) + (row === 0 ? ARM_AY - ARM_AX : 0)]!;
      sum += v[b + d.INV_MASS]! + v[b + d.INV_INERTIA]! * arm * arm;
    } else if (kernel === TURN) {
      const ratio = k === 0 ? 1 : r[at + TURN_RATIO]!;
      sum += v[b + d.INV_INERTIA]! * ratio * ratio;
    } else {
      const i = at + jacobian + 3 * (row * members + k);
      sum +=
        v[b + d.INV_MASS]! * (r[i]! * r[i]! + r[i + 1]! * r[i + 1]!) + v[b + d.INV_INERTIA]! * r[i + 2]! * r[i + 2]!;
    }
  }
  eases[rowCount] = sum;
}

/** Lists the bodies of a group that can move. @returns how many they are. */
export function findMovers({ velocity: v }: SolverData, { bodies }: Group): number {
  makeRoom(3 * bodies.count);
  moverCount = 0;
  sums[MASS] = 0;
  for (let n = 0; n < bodies.count; n += 1) {
    const b = bodies.items[n]!;
    if (v[b + d.INV_MASS]! + v[b + d.INV_INERTIA]! > 0) {
      movers[moverCount] = b;
      masses[2 * moverCount] = inverse(v[b + d.INV_MASS]!);
      sums[MASS] = sums[MASS]! + masses[2 * moverCount]!;
      masses[2 * moverCount + 1] = inverse(v[b + d.INV_INERTIA]!);
      moverCount += 1;
    }
  }
  return moverCount;
}

function makeRoom(count: number): void {
  if (start.length < count) {
    const size = grown(count);
    movers = widened(movers, new Int32Array(size));
    masses = widened(masses, new Float64Array(2 * size));
    rowAt = widened(rowAt, new Int32Array(size));
    isBounded = widened(isBounded, new Uint8Array(size));
    eases = widened(eases, new Float64Array(size));
    constants = new Float64Array(size);
    start = new Float64Array(size);
    direction = new Float64Array(size);
  }
}

/** A mass or inertia; 0 if it is infinite. */
function inverse(inverseMass: number): number {
  return inverseMass > 0 ? 1 / inverseMass : 0;
}

/** Called before each sweep: notes where it starts from. */
export function beginSweep({ velocity, motion, points, joints }: SolverData, isPush: boolean): void {
  const v = isPush ? motion : velocity;
  const { records } = joints;
  let n = 0;
  for (let m = 0; m < moverCount; m += 1, n += 3) {
    const b = movers[m]! & d.OFFSET;
    start[n] = v[b]!;
    start[n + 1] = v[b + 1]!;
    start[n + 2] = v[b + 2]!;
  }
  for (let row = 0; row < rowCount; row += 1, n += 1) {
    const at = rowAt[row]!;
    start[n] = at < 0 ? points[-1 - at]! : records[at]!;
  }
}

/**
 * Called after a sweep that is not the last one: goes on along the conjugate direction. @returns whether the sweep changed enough to be
 * worth another one.
 */
export function followGradient(data: SolverData, group: Group, isPush: boolean): boolean {
  const v = isPush ? data.motion : data.velocity;
  measureSweep(v);
  const changed = sums[CHANGED]!;
  if (!(changed > JOINT_STILL * (sums[KINETIC]! + JOINT_STILL * sums[MASS]!))) {
    return false;
  }
  if (!areKnown) findConstants(data, group, isPush);
  const hasSwitched = turnDirection(data, v);
  const isClear = sums[SQUARE]! > Math.max(GRADIENT_LOST * changed, GRADIENT_SHARE * sums[ALONE]!);
  // A direction that bounds would cut short is not followed: the next sweep begins anew where this one ended.
  hasDirection = sums[SLOPE]! < 0 && isClear && !(hasSwitched || switches(data));
  areKnown = !hasSwitched;
  if (hasDirection) {
    follow(data, v);
  }
  return true;
}

/** Measures the energy of what the sweep changed, and its product with the direction before. */
function measureSweep(v: Float64Array): void {
  let kinetic = 0;
  let changed = 0;
  let along = 0;
  for (let m = 0, n = 0; m < moverCount; m += 1, n += 3) {
    const b = movers[m]! & d.OFFSET;
    const vx = start[n]!;
    const vy = start[n + 1]!;
    const vw = start[n + 2]!;
    const x = v[b]! - vx;
    const y = v[b + 1]! - vy;
    const w = v[b + 2]! - vw;
    const mass = masses[2 * m]!;
    const inertia = masses[2 * m + 1]!;
    kinetic += mass * (vx * vx + vy * vy) + inertia * vw * vw;
    changed += mass * (x * x + y * y) + inertia * w * w;
    along += mass * (x * direction[n]! + y * direction[n + 1]!) + inertia * w * direction[n + 2]!;
  }
  sums[KINETIC] = kinetic;
  sums[CHANGED] = changed;
  sums[ALONG] = along;
}

/** Finds the constant part of each row. If a row has bounds, it is that of the bound that holds it. */
function findConstants({ joints: data, points }: SolverData, group: Group, isPush: boolean): void {
  const { joints, records: r } = data;
  let n = 0;
  for (let k = group.start; k < group.end; k += 1) {
    const { kernel, at, slot, layout } = joints[k]!;
    for (let row = 0; row < layout.rows; row += 1, n += 1) {
      if (kernel === POINT) {
        constants[n] = isPush ? points[recordAt(slot, POINT_STRIDE) + OFFSET_X + 2 * row]! : 0;
      } else if (kernel === TURN) {
        const bound = r[at + (r[at + TURN_PUSH]! > 0 ? TURN_LOWER : TURN_UPPER)]!;
        constants[n] = isPush ? r[at + TURN_VALUE]! - bound : r[at + TURN_BIAS]!;
      } else {
        constants[n] = r[at + (isPush ? layout.error : layout.bias) + row]!;
        const held = r[rowAt[n]!]!;
        const apart = r[at + (isPush ? layout.farError : layout.farBias)]!;
        if (isBounded[n] === 1 && held > 0 && r[at + layout.high] === 0) constants[n] = constants[n]! + apart;
        if (isBounded[n] === 1 && held < 0 && r[at + layout.low] === 0) constants[n] = constants[n]! - apart;
      }
    }
  }
}

/**
 * Finds the new direction: what the sweep changed, less the part of it that is along the direction before. Also its energy, and how the
 * energy of the error changes along it. @returns whether a bound took hold or let go in the sweep.
 */
function turnDirection({ points, joints }: SolverData, v: Float64Array): boolean {
  const { records } = joints;
  const share = hasDirection && sums[SQUARE]! > 0 ? sums[ALONG]! / sums[SQUARE]! : 0;
  let slope = 0;
  let square = 0;
  let alone = 0;
  let hasSwitched = false;
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
  for (let row = 0; row < rowCount; row += 1, n += 1) {
    const at = rowAt[row]!;
    const now = at < 0 ? points[-1 - at]! : records[at]!;
    const change = now - start[n]! - share * direction[n]!;
    direction[n] = change;
    slope += change * constants[row]!;
    alone += eases[row]! * change * change;
    hasSwitched ||= isBounded[row] === 1 && Math.sign(now) !== Math.sign(start[n]!);
  }
  sums[SLOPE] = slope;
  sums[SQUARE] = square;
  sums[ALONE] = alone;
  return hasSwitched;
}

/** Whether a bound would take hold or let go on the way along the direction. */
function switches({ points, joints }: SolverData): boolean {
  const { records } = joints;
  const far = -sums[SLOPE]! / sums[SQUARE]!;
  let n = 3 * moverCount;
  for (let row = 0; row < rowCount; row += 1, n += 1) {
    const at = rowAt[row]!;
    const now = at < 0 ? points[-1 - at]! : records[at]!;
    if (isBounded[row] === 1 && Math.sign(start[n]! + far * direction[n]!) !== Math.sign(now)) return true;
  }
  return false;
}

/** Goes from where the sweep began to the least energy along the direction. */
function follow({ points, joints }: SolverData, v: Float64Array): void {
  const { records } = joints;
  const far = -sums[SLOPE]! / sums[SQUARE]!;
  let n = 0;
  for (let m = 0; m < moverCount; m += 1, n += 3) {
    const b = movers[m]! & d.OFFSET;
    v[b] = start[n]! + far * direction[n]!;
    v[b + 1] = start[n + 1]! + far * direction[n + 1]!;
    v[b + 2] = start[n + 2]! + far * direction[n + 2]!;
  }
  for (let row = 0; row < rowCount; row += 1, n += 1) {
    const at = rowAt[row]!;
    const next = start[n]! + far * direction[n]!;
    if (at < 0) points[-1 - at] = next;
    else records[at] = next;
  }
}
