import {
  EASY_TURN,
  EXCESS_FADES,
  EXCESS_REMOVED,
  EXCESS_SHARE,
  EXCESS_WILD,
  HEAVY,
  STUCK_ERROR,
  TOUCHED_EXCESS,
} from '../../../config-joints.js';
import type { List } from '../../../math/list.js';
import { recordAt, type SolverData } from '../../data.js';
import * as d from '../../layout.js';
import type { Group, Joint } from '../joint-data.js';
import { ARM_AX, ARM_BX, POINT, POINT_STRIDE, TURN } from '../joint-layout.js';
import { goAsMoved } from './motion.js';

// Rigid joints do no work. If they do all the same, because sub-steps are too long for how fast light bodies swing and turn on them, the
// energy is taken back: so no group whirls by itself, whatever it is made of.

/** Scratch: sums over the bodies of a group. J, kg, N·s. */
const sums = /* @__PURE__ */ new Float64Array(14);
/** Kinetic energy, and its correction for velocities that are half a sub-step ahead of the place, see `add` … */
const KINETIC = 0;
const AHEAD = 1;
/**
 * … the work of gravity, forces and springs in the step so far, and the energy that gravity and forces give to bodies at rest in one
 * sub-step …
 */
const WORK = 2;
const LEAST = 3;
/** … the mass of the bodies, infinite if something holds them, and their momentum … */
const MASS = 4;
const PX = 5;
const PY = 6;
/** 1/kg. … and the inverse mass of the lightest. */
const LIGHTEST = 7;
/** kg. The mass of the group alone, without its guests. */
const OWN_MASS = 8;
/** J. Twice the kinetic energy of the light bodies. */
const LIGHT_TWICE = 9;
/** N·s. The momentum that the light bodies lose. */
const LOST_X = 10;
const LOST_Y = 11;
/** m/s. The velocity that all bodies have in common; 0 if something holds them. */
const COMMON_X = 12;
const COMMON_Y = 13;

/**
 * Bodies are summed up so many at a time, by a function that is called often and so is soon compiled. A long loop that runs once a step may
 * never be compiled but in its middle, where V8 boxes its sums: half a megabyte in each step for 10,000 bodies. Refused: one body at a
 * time, as the sums would be loaded and stored for each, which takes a tenth of a step of a net.
 */
const BATCH = 64;

/** One of the bodies is moved by something else. */
let isCarried = false;

/**
 * Whether the joints of a group may make energy: if they close rings, as between two banks; if a body is far heavier than another; or if
 * one is turned easily by a point joint, as thin links are. Joints of other kinds may in any case, but for those that only turn.
 */
export function mayMakeEnergy(data: SolverData, group: Group): boolean {
  const { joints } = data.joints;
  const { start, end, bodies } = group;
  let isFound = group.burdened || end - start > bodies.count;
  for (let k = start; k < end && !isFound; k += 1) {
    const joint = joints[k]!;
    const { kernel } = joint;
    isFound = kernel === POINT ? turnsEasily(data, joint, 0) || turnsEasily(data, joint, 1) : kernel !== TURN;
  }
  return isFound;
}

/** Whether the impulse of a point joint turns one of its bodies far more than it moves it. */
function turnsEasily(
  { velocity: v, points: p, joints: { bodies } }: SolverData,
  joint: Joint,
  member: number,
): boolean {
  const b = bodies[joint.first + member]!;
  const arm = recordAt(joint.slot, POINT_STRIDE) + (member === 0 ? ARM_AX : ARM_BX);
  const square = p[arm]! * p[arm]! + p[arm + 2]! * p[arm + 2]!;
  return b > 0 && v[b + d.INV_INERTIA]! * square > EASY_TURN * v[b + d.INV_MASS]!;
}

/** Called as a step begins. */
export function noteEnergy(data: SolverData, group: Group): void {
  measure(data, group);
  group.energy = sums[KINETIC]! + sums[AHEAD]!;
}

/** Called as the step ends. */
export function takeExcesses(data: SolverData): void {
  const { groups } = data.joints;
  for (let k = 0; k < groups.length; k += 1) {
    const group = groups[k]!;
    if (group.isUnmet || group.touched) goAsMoved(data, group);
    else group.untrueSteps = 0;
    noteUnmet(data, group);
    if (group.isWatched) {
      takeExcess(data, group);
    } else if (!group.touched) {
      group.excess = 0;
    }
  }
}

/**
 * Notes in the constraints of a group how many anchors held them against each other, if they could not be met in this step, else 0. It is
 * the same number in all of them.
 */
function noteUnmet({ joints: { joints } }: SolverData, { isUnmet, errorSquare, anchors, start, end }: Group): void {
  const unmet = isUnmet && errorSquare > STUCK_ERROR * STUCK_ERROR ? anchors : 0;
  if (joints[start]!.constraint.unmetAnchors !== unmet) {
    for (let k = start; k < end; k += 1) {
      joints[k]!.constraint.unmetAnchors = unmet;
    }
  }
}

/**
 * Takes back the energy that the joints of a group made beyond a share of all there is, bit by bit, so that nothing halts in the air: from
 * the velocities of the light bodies, and what is far beyond from all. Not in steps in which a joint of the group was changed. Bodies that
 * nothing holds keep their common velocity.
 */
function takeExcess(data: SolverData, group: Group): void {
  measure(data, group);
  const kinetic = sums[KINETIC]!;
  const grown = kinetic + sums[AHEAD]! - group.energy;
  const made = grown - sums[WORK]!;
  if (isCarried || !Number.isFinite(made)) {
    group.excess = 0;
    return;
  }
  const { touched, settling } = group;
  // Contacts, and corrections without momentum, may raise bodies, which counts as energy made.
  const flung = touched || settling > 0 ? Math.min(made, grown) : made;
  const before = touched ? 0 : group.excess < 0 ? EXCESS_FADES * group.excess : group.excess;
  const excess = before + (settling > 0 ? flung : made);
  sums[COMMON_X] = sums[PX]! / sums[MASS]!;
  sums[COMMON_Y] = sums[PY]! / sums[MASS]!;
  const isCalm = kinetic - 0.5 * (sums[COMMON_X]! * sums[PX]! + sums[COMMON_Y]! * sums[PY]!) <= sums[LEAST]!;
  const right = Math.max(0, kinetic - excess);
  let removed = 0;
  if (!isCalm) {
    const { bodies, guests } = group;
    removed = slowDown(data, bodies, excess - (touched ? TOUCHED_EXCESS : EXCESS_SHARE) * right, made);
    // What the light bodies do not have was made in the heavy ones. From here on, all count as light.
    sums[LIGHTEST] = 0;
    const wild = before + flung - EXCESS_WILD * right;
    removed += slowDown(data, bodies, wild - removed, made - removed);
    // What these do not have either went into guests, or comes back to them after it was lost.
    sums[OWN_MASS] = sums[MASS]! - sums[OWN_MASS]!;
    removed += slowDown(data, guests, wild + group.lost - removed, made - removed);
  }
  group.lost = touched ? Math.min(0, EXCESS_FADES * group.lost + made - removed) : 0;
  if (!touched) {
    group.excess = isCalm ? Math.min(0, excess) : excess - removed;
  }
}

/** Whether a body counts as light. These are the ones that whirl: of a ball on a thin chain the links, not the ball. */
function isLight({ velocity: v }: SolverData, offset: number): boolean {
  return v[offset + d.INV_MASS]! * HEAVY >= sums[LIGHTEST]!;
}

/** J. The kinetic energy of the light bodies relative to the common velocity. */
function energyOfLight(data: SolverData, { items, count }: List<number>): number {
  sums[LIGHT_TWICE] = 0;
  for (let n = 0; n < count; n += 1) {
    addEnergyOfLight(data, items[n]!);
  }
  return sums[LIGHT_TWICE]! / 2;
}

function addEnergyOfLight(data: SolverData, i: number): void {
  if (isLight(data, i)) {
    const { velocity: v } = data;
    const vx = v[i + d.VX]! - sums[COMMON_X]!;
    const vy = v[i + d.VY]! - sums[COMMON_Y]!;
    const w = v[i + d.W]!;
    sums[LIGHT_TWICE] = sums[LIGHT_TWICE]! + (vx * vx + vy * vy) / v[i + d.INV_MASS]!;
    if (v[i + d.INV_INERTIA]! > 0) {
      sums[LIGHT_TWICE] = sums[LIGHT_TWICE]! + (w * w) / v[i + d.INV_INERTIA]!;
    }
  }
}

/**
 * Takes the energy `over` from the light bodies, relative to the common velocity, but at most a share of what they have and all that was made
 * in this step. What nothing holds keeps its momentum: what the light bodies lose is given back to all.
 * @returns how much energy was taken, J.
 */
function slowDown(data: SolverData, bodies: List<number>, over: number, made: number): number {
  const own = over > 0 ? energyOfLight(data, bodies) : 0;
  const removed = Math.min(over, own, EXCESS_REMOVED * own + Math.max(0, made));
  if (!(removed > 0)) {
    return 0;
  }
  const keep = Math.sqrt(1 - removed / own);
  const { items, count } = bodies;
  sums[LOST_X] = 0;
  sums[LOST_Y] = 0;
  for (let n = 0; n < count; n += 1) {
    slowLight(data, items[n]!, keep);
  }
  if (sums[MASS]! < Infinity) {
    giveBack(data, bodies);
  }
  return removed;
}

function slowLight(data: SolverData, i: number, keep: number): void {
  if (isLight(data, i)) {
    const { velocity: v } = data;
    const x = sums[COMMON_X]!;
    const y = sums[COMMON_Y]!;
    sums[LOST_X] = sums[LOST_X]! + ((1 - keep) * (v[i + d.VX]! - x)) / v[i + d.INV_MASS]!;
    sums[LOST_Y] = sums[LOST_Y]! + ((1 - keep) * (v[i + d.VY]! - y)) / v[i + d.INV_MASS]!;
    v[i + d.VX] = x + keep * (v[i + d.VX]! - x);
    v[i + d.VY] = y + keep * (v[i + d.VY]! - y);
    v[i + d.W] = keep * v[i + d.W]!;
  }
}

function giveBack({ velocity: v }: SolverData, { items, count }: List<number>): void {
  for (let n = 0; n < count; n += 1) {
    const i = items[n]!;
    v[i + d.VX] = v[i + d.VX]! + sums[LOST_X]! / sums[OWN_MASS]!;
    v[i + d.VY] = v[i + d.VY]! + sums[LOST_Y]! / sums[OWN_MASS]!;
  }
}

function measure(data: SolverData, group: Group): void {
  const { bodies, guests, isAnchored, touched, isAfloat } = group;
  sums.fill(0);
  isCarried = false;
  add(data, bodies);
  if (isAnchored) {
    sums[MASS] = Infinity;
  }
  const least = sums[LEAST]!;
  const lightest = sums[LIGHTEST]!;
  sums[OWN_MASS] = sums[MASS]!;
  if (guests.count > 0) add(data, guests);
  sums[LEAST] = least;
  sums[LIGHTEST] = lightest;
  if (touched && !isAfloat) {
    sums[MASS] = Infinity;
  }
}

/**
 * Adds bodies to the sums. A velocity is that at the end of a sub-step, half a sub-step ahead of the place: ½·m·v² + ½·h·m·a·v − m·a·x is
 * what the scheme keeps of the energy (Hairer, Lubich, Wanner, "Geometric Numerical Integration", 2006, IX).
 */
function add(data: SolverData, { items, count }: List<number>): void {
  for (let from = 0; from < count; from += BATCH) {
    addBatch(data, items, from, Math.min(from + BATCH, count));
  }
}

function addBatch({ velocity: v, motion: q, drive: f, joints }: SolverData, items: number[], from: number, to: number) {
  const { h, hasSprings, work: worked } = joints;
  let kinetic = sums[KINETIC]!;
  let ahead = sums[AHEAD]!;
  let work = sums[WORK]!;
  let least = sums[LEAST]!;
  let mass = sums[MASS]!;
  let px = sums[PX]!;
  let py = sums[PY]!;
  let lightest = sums[LIGHTEST]!;
  for (let n = from; n < to; n += 1) {
    const i = items[n]! & d.OFFSET;
    if (hasSprings) work += worked[i / d.BODY_STRIDE]!;
    const inverseMass = v[i + d.INV_MASS]!;
    const inverseInertia = v[i + d.INV_INERTIA]!;
    const vx = v[i + d.VX]!;
    const vy = v[i + d.VY]!;
    const w = v[i + d.W]!;
    const gainX = f[i + d.GAIN_X]!;
    const gainY = f[i + d.GAIN_Y]!;
    const gainW = f[i + d.GAIN_W]!;
    lightest = inverseMass > lightest ? inverseMass : lightest;
    if (inverseMass > 0) {
      const m = 1 / inverseMass;
      kinetic += 0.5 * m * (vx * vx + vy * vy);
      ahead += 0.5 * m * (gainX * vx + gainY * vy);
      work += (m * (gainX * q[i + d.DX]! + gainY * q[i + d.DY]!)) / h;
      least += 0.5 * m * (gainX * gainX + gainY * gainY);
      px += m * vx;
      py += m * vy;
      mass += m;
    } else {
      isCarried ||= vx !== 0 || vy !== 0;
      mass = Infinity;
    }
    if (inverseInertia > 0) {
      const inertia = 1 / inverseInertia;
      kinetic += 0.5 * inertia * w * w;
      ahead += 0.5 * inertia * gainW * w;
      work += (inertia * gainW * q[i + d.DW]!) / h;
    } else {
      isCarried ||= w !== 0;
    }
  }
  sums[KINETIC] = kinetic;
  sums[AHEAD] = ahead;
  sums[WORK] = work;
  sums[LEAST] = least;
  sums[MASS] = mass;
  sums[PX] = px;
  sums[PY] = py;
  sums[LIGHTEST] = lightest;
}
