import { shareOfTwo } from '../../contacts/pack-contacts.js';
import { batchOf, recordAt, type SolverData } from '../../data.js';
import * as d from '../../layout.js';
import { markBodies } from '../joint-numbers.js';

/**
 * Pushes contacts of groups that are held at two places or more, such as the planks of a bridge, like those of single bodies. Such a group
 * gives way little, so what lies on it is not hooked into it, but carried: pushed only as far as what is hooked, wheels sank through it,
 * and so did everything that has several shapes or hangs together. Not done for groups that are held at one place: heaps around puppets on
 * a rope would shake.
 */
export function pushHeld(data: SolverData): void {
  const { hooked, traits, velocity: v, joints } = data;
  if (hooked.count === 0) {
    return;
  }
  for (let i = 0; i < joints.groups.length; i += 1) {
    if (joints.groups[i]!.isHeldTwice) markBodies(data, joints.groups[i]!, d.HELD);
  }
  for (let i = 0; i < hooked.count; i += 1) {
    const contact = hooked.items[i]!;
    const { records, bodies, arbiters, stride } = batchOf(data, contact);
    const a = bodies[contact & d.EVEN]! & d.OFFSET;
    const b = bodies[contact | 1]!;
    if (((traits[a / d.BODY_STRIDE]! | traits[b / d.BODY_STRIDE]!) & d.HELD) !== 0) {
      const index = contact >> 1;
      records[recordAt(index, stride) + d.SHARE] = -shareOfTwo(
        arbiters[index]!,
        v[a + d.INV_MASS]!,
        v[b + d.INV_MASS]!,
      );
    }
  }
}
