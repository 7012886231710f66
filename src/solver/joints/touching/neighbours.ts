import type { RigidBody } from '../../../body.js';
import { CONTACT_SLOP } from '../../../config.js';
import { HEAVY } from '../../../config-joints.js';
import { grown } from '../../../math/doubles.js';
import type { World } from '../../../world.js';
import { type ContactBatch, recordAt, type SolverData } from '../../data.js';
import * as d from '../../layout.js';
import type { Group } from '../joint-data.js';
import { isMoving } from '../joint-numbers.js';

/** Bits for what the bodies of a group touch: something that is not part of it, … */
export const OTHERS = 1;
/** … something dynamic that is far heavier, … */
export const HEAVIER = 2;
/** … something dynamic of about their own mass; … */
export const ALIKE = 4;
/** … or each other, so deeply that they are pushed apart. */
export const ITSELF = 8;

/** For the slot of a dynamic body, one more than the index of its group, if that touches something; else 0. Scratch, for all worlds. */
let groupOf = /* @__PURE__ */ new Int32Array(0);

/** Finds what the bodies of all groups touch. Contacts are read from their records, as all lie in one place there. */
export function findNeighbours({ solver, liveDynamics }: World): void {
  const { one, two, bodyCount, joints } = solver;
  const { groups } = joints;
  if (groupOf.length < bodyCount) groupOf = new Int32Array(grown(bodyCount));
  groupOf.fill(0, 0, bodyCount);
  let isNeeded = false;
  for (let i = 0; i < groups.length; i += 1) {
    const group = groups[i]!;
    group.neighbours = 0;
    if (group.touched) {
      isNeeded = true;
      nameBodies(group, i + 1, liveDynamics.length);
    }
  }
  if (isNeeded) {
    readContacts(one, groups, liveDynamics);
    readContacts(two, groups, liveDynamics);
  }
}

function nameBodies({ bodies }: Group, name: number, dynamics: number): void {
  for (let n = 0; n < bodies.count; n += 1) {
    const slot = bodies.items[n]! / d.BODY_STRIDE;
    // A body that is not dynamic may be part of several groups.
    if (slot <= dynamics) groupOf[slot] = name;
  }
}

function readContacts(
  { records: r, bodies, count, stride }: ContactBatch,
  groups: readonly Group[],
  dynamics: RigidBody[],
): void {
  const second = stride === d.TWO_STRIDE ? d.SECOND : 0;
  for (let k = 0; k < count; k += 1) {
    const a = (bodies[2 * k]! & d.OFFSET) / d.BODY_STRIDE;
    const b = bodies[2 * k + 1]! / d.BODY_STRIDE;
    const nameA = groupOf[a]!;
    const nameB = groupOf[b]!;
    if (nameA === 0 && nameB === 0) {
      continue;
    }
    const isItself = nameA === nameB || isPart(groups, nameA, b) || isPart(groups, nameB, a);
    if (isItself) {
      const at = recordAt(k, stride);
      const separation = Math.min(r[at + d.START1]!, r[at + second + d.START1]!);
      if (separation < -CONTACT_SLOP) groups[(nameA || nameB) - 1]!.neighbours |= ITSELF;
    } else {
      if (nameA > 0) groups[nameA - 1]!.neighbours |= kindOf(dynamics, a, b);
      if (nameB > 0) groups[nameB - 1]!.neighbours |= kindOf(dynamics, b, a);
    }
  }
}

/** Whether a body that is not dynamic is part of a group, given by its name. */
function isPart(groups: readonly Group[], name: number, slot: number): boolean {
  return name > 0 && slot > 0 && groupOf[slot] === 0 && groups[name - 1]!.bodies.has(slot * d.BODY_STRIDE);
}

/** What another body is to one of a group; both are given by their slots. */
function kindOf(dynamics: readonly RigidBody[], slot: number, other: number): number {
  if (other === 0 || other > dynamics.length) {
    return OTHERS;
  }
  const { mass } = dynamics[slot - 1]!;
  const otherMass = dynamics[other - 1]!.mass;
  return otherMass > HEAVY * mass ? OTHERS | HEAVIER : otherMass * HEAVY >= mass ? OTHERS | ALIKE : OTHERS;
}

/**
 * Whether something that is not part of a group is in its way, and nothing far heavier lies on one of its bodies. A wrecking ball into
 * which its last link reaches does not lie on that.
 */
export function isBlocked({ neighbours }: Group): boolean {
  return (neighbours & (OTHERS | HEAVIER)) === OTHERS;
}

/** Whether a body of a blocked group goes on whatever it meets, and so draws the group into what is in its way. */
export function isJammed(data: SolverData, group: Group): boolean {
  const { items, count } = group.bodies;
  for (let n = 0; n < count && isBlocked(group); n += 1) {
    if (data.velocity[items[n]! + d.INV_MASS] === 0 && isMoving(data, items[n]!)) return true;
  }
  return false;
}
