import {
  JAMMED_STEPS,
  STUCK_APART,
  STUCK_STANDS,
  UNTRUE_ERROR,
  UNTRUE_SHARE,
  UNTRUE_STEPS,
} from '../../../config-joints.js';
import type { SolverData } from '../../data.js';
import * as d from '../../layout.js';
import type { Group } from '../joint-data.js';
import { isJammed } from '../touching/neighbours.js';

// Compares the velocities of a group with how it moved.

/** Scratch, for a group. J, each twice: the energy of its velocities, of its motion, and of the difference. */
const energies = /* @__PURE__ */ new Float64Array(3);
const TOLD = 0;
const MOVED = 1;
const APART = 2;

/**
 * Gives the bodies of a group the velocities with which they moved in the step, if theirs are wrong. Each sub-step corrects the same errors
 * once more, and contacts or other joints undo the momentum that this makes. A group whose joints cannot all be met gets them as soon as
 * its motion differs from its velocities by a share of their energy, and has less energy; one that something draws into what is in its way,
 * if that goes on; any other that touches something, such as a belt or a track around wheels, if its motion has hardly any energy for some
 * steps in a row.
 */
export function goAsMoved(data: SolverData, group: Group): void {
  measureMotion(data, group);
  const told = energies[TOLD]!;
  const moved = energies[MOVED]!;
  const isWrong = energies[APART]! > STUCK_APART * told && moved < (group.touched ? STUCK_STANDS : 1) * told;
  const jams = isJammed(data, group);
  const isUntrue = jams ? isWrong : moved < UNTRUE_SHARE * told;
  const isOpen = group.errorSquare > UNTRUE_ERROR * UNTRUE_ERROR;
  group.untrueSteps = isUntrue && isOpen ? Math.min(group.untrueSteps + 1, UNTRUE_STEPS) : 0;
  if (group.untrueSteps >= (jams ? JAMMED_STEPS : UNTRUE_STEPS) || (isWrong && group.isUnmet)) {
    takeMotion(data, group);
  }
}

/** Finds twice the energy of the velocities, of the motion in the step, and of the difference. */
function measureMotion(data: SolverData, { bodies }: Group): void {
  energies.fill(0);
  for (let n = 0; n < bodies.count; n += 1) {
    addMotion(data, bodies.items[n]!);
  }
}

/** A function of its own, which is soon compiled, see BATCH in `energy.ts`. */
function addMotion({ velocity: v, motion: q, joints: { h, substeps } }: SolverData, i: number): void {
  const dt = h * substeps;
  const m = v[i + d.INV_MASS]! > 0 ? 1 / v[i + d.INV_MASS]! : 0;
  const inertia = v[i + d.INV_INERTIA]! > 0 ? 1 / v[i + d.INV_INERTIA]! : 0;
  const vx = v[i + d.VX]!;
  const vy = v[i + d.VY]!;
  const vw = v[i + d.W]!;
  const x = q[i + d.DX]! / dt;
  const y = q[i + d.DY]! / dt;
  const w = turnOf(q[i + d.DW]!, vw * dt) / dt;
  energies[TOLD] = energies[TOLD]! + (m * (vx * vx + vy * vy) + inertia * vw * vw);
  energies[MOVED] = energies[MOVED]! + (m * (x * x + y * y) + inertia * w * w);
  const apart = m * ((vx - x) * (vx - x) + (vy - y) * (vy - y)) + inertia * (vw - w) * (vw - w);
  energies[APART] = energies[APART]! + apart;
}

function takeMotion({ velocity: v, motion: q, joints: { h, substeps } }: SolverData, { bodies }: Group): void {
  const dt = h * substeps;
  for (let n = 0; n < bodies.count; n += 1) {
    const i = bodies.items[n]!;
    if (v[i + d.INV_MASS]! + v[i + d.INV_INERTIA]! > 0) {
      v[i + d.VX] = q[i + d.DX]! / dt;
      v[i + d.VY] = q[i + d.DY]! / dt;
      v[i + d.W] = turnOf(q[i + d.DW]!, v[i + d.W]! * dt) / dt;
    }
  }
}

/** rad. The turn of a body in the step, without full turns that do not fit its velocity: corrections of straight chains make some. */
function turnOf(angle: number, told: number): number {
  if (Math.abs(angle) < Math.PI) {
    return angle;
  }
  const all = Math.round(angle / (2 * Math.PI));
  const untold = Math.round((angle - told) / (2 * Math.PI));
  return angle - 2 * Math.PI * Math.max(Math.min(0, all), Math.min(Math.max(0, all), untold));
}
