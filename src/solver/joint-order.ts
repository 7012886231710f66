import type { RigidBody } from '../body.js';
import { DYNAMIC } from '../body-kind.js';
import type { Constraint } from '../constraint/constraint.js';
import type { World } from '../world.js';
import { BLOCK, BlockLayout, CUSTOM, POINT, ROW } from './joint-data.js';

/**
 * Lists the live constraints breadth-first from what cannot move, equals as they were added: so a sweep carries a load from where it
 * hangs to where it ends. In any other order a chain under a heavy ball stretches twice as far.
 */
export function orderJoints(world: World): void {
  const acting = world.liveConstraints.filter((constraint) => acts(world, constraint));
  const depths = findDepths(acting);
  acting.sort((a, b) => depths.get(a)! - depths.get(b)! || a.order - b.order);
  const { joints } = world.solver;
  joints.reset();
  for (const constraint of acting) {
    joints.add(constraint, kernelFor(constraint), new BlockLayout(constraint.dimension, constraint.members.length));
  }
  joints.allot();
}

function kernelFor({ type, dimension, members, stiff, breakUnderForce, breakUnderError }: Constraint): number {
  if (type === 'POINT' && stiff && !breakUnderForce && !breakUnderError) {
    return POINT;
  }
  if (type === 'CUSTOM') {
    return CUSTOM;
  }
  return dimension === 1 && members.length === 2 ? ROW : BLOCK;
}

/** A constraint with a dynamic body that is not in the world does nothing, nor does one between a body and itself. */
export function acts(world: World, { members, type }: Constraint): boolean {
  return (
    members.every((body) => body.kind !== DYNAMIC || body.owner === world) &&
    (members.length !== 2 || members[0] !== members[1] || type === 'CUSTOM')
  );
}

/** How many constraints lie between each and the nearest that is tied to something immovable; `Infinity` for those that hang on nothing. */
function findDepths(constraints: readonly Constraint[]): Map<Constraint, number> {
  const depths = new Map<Constraint, number>(constraints.map((constraint) => [constraint, Infinity]));
  const reached = new Set<RigidBody>();
  let ring = constraints.filter(({ members }) => members.some(({ kind }) => kind !== DYNAMIC));
  for (let depth = 0; ring.length > 0; depth += 1) {
    const next = new Set<Constraint>();
    for (const constraint of ring) {
      depths.set(constraint, depth);
    }
    for (const body of ring.flatMap(({ members }) => members)) {
      if (body.kind === DYNAMIC && !reached.has(body)) {
        reached.add(body);
        for (const constraint of body.constraints) {
          if (depths.get(constraint) === Infinity) {
            next.add(constraint);
          }
        }
      }
    }
    ring = [...next];
  }
  return depths;
}
