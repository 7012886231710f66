import { SQUEEZE_ACCELERATION, SQUEEZE_DEPTH, SQUEEZE_GRAVITY, SQUEEZE_LEVERAGE } from '../config.js';
import type { Constraint } from '../constraint/constraint.js';
import { rootOf, unite } from '../math/sets.js';
import type { World } from '../world.js';
import { batchOf, type ContactBatch, recordAt, type SolverData } from './data.js';
import * as d from './layout.js';

// What is squeezed between a kinematic body and something else that does not give way cannot do what its contacts ask for: each sweep only
// adds to their normal impulses. As each sub-step starts with those of the last one, they grew without end: crates in a press bore 18,000 N
// each for as long as they were in it, and shot out at 30 m/s once one of them slipped. So, where the contacts of what is squeezed overlap
// deeply, a sub-step starts with smaller impulses; but with no less than the weight of all that hangs together there, which a lift has to
// carry, and than what a claw needs to hold what it lifts.

/** Finds which of the deep contacts are of what is squeezed, and the impulse with which each may start a sub-step in any case. */
export function findSqueezes(world: World, h: number): void {
  const { solver } = world;
  const { squeezes } = solver;
  const { contacts } = squeezes;
  let some = false;
  for (let i = 0; i < contacts.count && !some; i += 1) {
    some = isOneSided(solver, contacts.items[i]!);
  }
  if (!some) {
    contacts.clear();
    return;
  }
  squeezes.reserve(world.liveDynamics.length, contacts.count);
  const { pressed, weight, tied, least } = squeezes;
  joinAll(world);
  weigh(world, h);
  pressed.fill(0);
  for (let i = 0; i < contacts.count; i += 1) {
    const contact = contacts.items[i]!;
    if (isOneSided(solver, contact)) pressed[setOf(solver, contact)] = 1;
  }
  let kept = 0;
  for (let i = 0; i < contacts.count; i += 1) {
    const contact = contacts.items[i]!;
    const set = setOf(solver, contact);
    if (set >= 0 && pressed[set] === 1) {
      const { records: r, stride } = batchOf(solver, contact);
      const at = recordAt(contact >> 1, stride);
      const isTwo = stride === d.TWO_STRIDE;
      const mass = isTwo ? 1 / r[at + d.K11]! : r[at + d.NORMAL_MASS]!;
      const weighs = (tied[set] === 1 ? SQUEEZE_LEVERAGE : 1) * weight[set]!;
      contacts.items[kept] = contact;
      least[2 * kept] = Math.max(weighs, SQUEEZE_ACCELERATION * h * mass);
      least[2 * kept + 1] = isTwo ? Math.max(weighs, (SQUEEZE_ACCELERATION * h) / r[at + d.K22]!) : 0;
      kept += 1;
    }
  }
  contacts.count = kept;
}

/** Before a sub-step: lessens the impulses with which the deep contacts start it. */
export function easeSqueezes(data: SolverData): void {
  const { contacts, least } = data.squeezes;
  for (let i = 0; i < contacts.count; i += 1) {
    const contact = contacts.items[i]!;
    const { records, stride } = batchOf(data, contact);
    const at = recordAt(contact >> 1, stride);
    ease(records, at, least, 2 * i);
    if (stride === d.TWO_STRIDE) ease(records, at + d.SECOND, least, 2 * i + 1);
  }
}

/**
 * Lessens the normal impulse of a point. What is taken away was applied in the last sub-step, and goes to its sum; in this order of the
 * terms the sum is never below 0.
 */
function ease(r: Float64Array, at: number, least: Float64Array, which: number): void {
  const p = r[at + d.NORMAL1]!;
  const share = SQUEEZE_DEPTH / -r[at + d.START1]!;
  if (p > least[which]! && share > 0 && share < 1) {
    const next = Math.max(least[which]!, share * share * p);
    r[at + d.NORMAL1] = next;
    r[at + d.NORMAL_SUM1] = r[at + d.NORMAL_SUM1]! + p - next;
  }
}

/** Whether one body of the contact gives way and the other does not, as it is kinematic or of infinite mass. */
function isOneSided(data: SolverData, contact: number): boolean {
  const { bodies } = batchOf(data, contact);
  const a = bodies[contact & d.EVEN]! & d.OFFSET;
  const b = bodies[contact | 1]! & d.OFFSET;
  return a > 0 && b > 0 && givesWay(data, a) !== givesWay(data, b);
}

/** Whether a body, by the offset of its record, can be moved or turned: a seesaw of infinite mass can be turned. */
function givesWay({ velocity: v }: SolverData, at: number): boolean {
  return v[at + d.INV_MASS]! > 0 || v[at + d.INV_INERTIA]! > 0;
}

/** The set of the first body of a contact that gives way; −1 if none does. */
function setOf(data: SolverData, contact: number): number {
  const { bodies } = batchOf(data, contact);
  const a = bodies[contact & d.EVEN]! & d.OFFSET;
  const b = bodies[contact | 1]! & d.OFFSET;
  const at = givesWay(data, a) ? a : b;
  return givesWay(data, at) ? rootOf(data.squeezes.parent, indexOf(at)) : -1;
}

/** The index in `liveDynamics` of a body, by the offset of its record: the slots of live dynamic bodies are the first. */
function indexOf(at: number): number {
  return at / d.BODY_STRIDE - 1;
}

/** Makes sets of the dynamic bodies that press on each other or are joined. */
function joinAll(world: World): void {
  const { solver, liveDynamics } = world;
  const { parent } = solver.squeezes;
  for (let i = 0; i < liveDynamics.length; i += 1) {
    parent[i] = i;
  }
  joinContacts(solver, solver.two, parent);
  joinContacts(solver, solver.one, parent);
  world.jointSolver?.joinTied(world, parent);
}

function joinContacts(data: SolverData, { records, bodies, count, stride }: ContactBatch, parent: Int32Array): void {
  for (let k = 0; k < count; k += 1) {
    const a = bodies[2 * k]! & d.OFFSET;
    const b = bodies[2 * k + 1]! & d.OFFSET;
    const at = recordAt(k, stride);
    const bears = records[at + d.NORMAL1]! > 0 || (stride === d.TWO_STRIDE && records[at + d.NORMAL2]! > 0);
    if (bears && givesWay(data, a) && givesWay(data, b)) {
      unite(parent, indexOf(a), indexOf(b));
    }
  }
}

/**
 * Finds for each set the impulse of its weight in a sub-step of length h, N·s, and whether constraints hold something in it. The weight is
 * from forces and gravity, but no less than by SQUEEZE_GRAVITY, as it may be pushed.
 */
function weigh(world: World, h: number): void {
  const { solver, liveDynamics } = world;
  const { velocity: v, drive } = solver;
  const { parent, weight, tied } = solver.squeezes;
  const count = liveDynamics.length;
  weight.fill(0, 0, count);
  tied.fill(0, 0, count);
  for (let i = 0; i < count; i += 1) {
    const at = (i + 1) * d.BODY_STRIDE;
    const root = rootOf(parent, i);
    const inverseMass = v[at + d.INV_MASS]!;
    if (inverseMass > 0) {
      const gain = Math.abs(drive[at + d.GAIN_X]!) + Math.abs(drive[at + d.GAIN_Y]!);
      weight[root]! += Math.max(gain, SQUEEZE_GRAVITY * h) / inverseMass;
    }
    if (liveDynamics[i]!.constraints.some(isLive, world)) tied[root] = 1;
  }
}

/** In this world, enabled and awake: others do nothing. */
function isLive(this: World, { owner, liveIndex }: Constraint): boolean {
  return owner === this && liveIndex >= 0;
}
