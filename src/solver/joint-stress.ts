import { DYNAMIC } from '../body-kind.js';
import { STRESS_FADES } from '../config-joints.js';
import { cos, sin } from '../math/trig.js';
import type { SolverData } from './data.js';
import type { Group, Joint } from './joint-data.js';
import { visit } from './joint-energy.js';
import { heldRows, markMembers } from './joint-numbers.js';
import * as d from './layout.js';

// Where there are more welds than hold the bodies together, as in frames and wheels, they may pull against each other, which moves nothing: no sweep sees such a stress, and it stays. As the bodies turn what welds give
// would pull the old way, and be put right by more stress, until the whole stops turning, or tears itself apart. So it is turned with them, and fades as it turns.

/** Whether what rigid joints of a group give may be against each other, welds among them: they have more rows than their bodies can move. */
export function isOverheld(data: SolverData, group: Group): boolean {
  const { joints, bodies } = data.joints;
  let rows = 0;
  let movers = 0;
  let hasWelds = false;
  let isHeld = false;
  for (let k = group.start; k < group.end; k += 1) {
    const { constraint, first, layout } = joints[k]!;
    if (!constraint.isElastic && !constraint.drives) {
      rows += heldRows(joints[k]!);
      hasWelds ||= constraint.type === 'WELD';
    }
    for (let n = 0; n < layout.members; n += 1) {
      const body = bodies[first + n]!;
      const moves = body > 0 && constraint.members[n]!.kind === DYNAMIC;
      movers += moves && visit(data, body) ? 1 : 0;
      isHeld ||= !moves;
    }
  }
  markMembers(data, group, 0);
  return hasWelds && rows > 3 * (movers - (isHeld ? 0 : 1));
}

/** Turns what the welds of a group gave in the last sub-step as their bodies turned in it. */
export function turnStress(data: SolverData, { start, end }: Group): void {
  const { joints } = data.joints;
  for (let k = start; k < end; k += 1) {
    if (joints[k]!.constraint.type === 'WELD') turnImpulse(data, joints[k]!);
  }
}

function turnImpulse({ velocity: v, joints }: SolverData, { at, layout, first }: Joint): void {
  const { records: r, bodies, h } = joints;
  const turn = 0.5 * h * (v[bodies[first]! + d.W]! + v[bodies[first + 1]! + d.W]!);
  const kept = 1 - STRESS_FADES * Math.min(1, Math.abs(turn));
  const c = kept * cos(turn);
  const s = kept * sin(turn);
  const i = at + layout.impulse;
  const x = r[i]!;
  const y = r[i + 1]!;
  r[i] = c * x - s * y;
  r[i + 1] = s * x + c * y;
  r[i + 2] = kept * r[i + 2]!;
}
