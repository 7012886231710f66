import { describe, expect, it } from 'vitest';
import { type Constraint, phys2D, type RigidBody, type World } from '../../src/index.js';
import { add, box, energyOf, heavy, staticBody, tie } from '../conformance/setting.js';

// A load falls until the rope is taut that ties it to light links, and pulls these straight. Then links turn by more in a sub-step than is small, and slide from one bound to the other.

const LENGTH = 0.5;
const ROPE = 1;
/** m. How far a rod of the distances holds links apart. */
const ROD = 0.1;

type Kind = 'point' | 'line' | 'distance';

function join(kind: Kind, bodyA: RigidBody, bodyB: RigidBody, end: number, play: number): Constraint {
  const both = { bodyA, bodyB, anchorB: [0, -LENGTH / 2] as const, ignoreInteractions: true };
  if (kind === 'point') {
    return phys2D.createPointConstraint({ ...both, anchorA: [0, end] });
  }
  if (kind === 'line') {
    const bounds = { lowerBound: -play, upperBound: play };
    return phys2D.createLineConstraint({ ...both, anchorA: [0, end], axis: [1, 0], ...bounds });
  }
  const bounds = { lowerBound: ROD - play, upperBound: ROD + play };
  return phys2D.createDistanceConstraint({ ...both, anchorA: [0, end - ROD], ...bounds });
}

/** Links of 75 g below each other, and a load that falls at 10 m/s and is tied to the last one. */
function drop(world: World, kind: Kind, links: number, play: number, mass: number): RigidBody {
  let last = staticBody();
  const free = { linearDrag: 0, angularDrag: 0 };
  for (let i = 0; i < links; i += 1) {
    const link = phys2D.createRigidBody({ ...free, shapes: [box(0.15, LENGTH)], position: [0, (i + 0.5) * LENGTH] });
    add(world, link);
    tie(world, join(kind, last, link, i === 0 ? 0 : LENGTH / 2, play));
    last = link;
  }
  const position = [0, links * LENGTH + 0.3] as const;
  const load = phys2D.createRigidBody({ ...free, shapes: [box(1, 1)], mass, position, velocity: [2, 10] });
  add(world, load);
  const rope = { upperBound: ROPE, ignoreInteractions: true };
  tie(world, phys2D.createDistanceConstraint({ bodyA: last, bodyB: load, anchorA: [0, LENGTH / 2], ...rope }));
  return load;
}

describe('a load that jerks a rope on light links taut makes no energy', () => {
  const cases = (['point', 'line', 'distance'] as const).flatMap((kind) =>
    [1, 2, 5].flatMap((links) => (kind === 'point' ? [0] : [0, 0.02, 0.1]).map((play) => ({ kind, links, play }))),
  );
  it.each(cases)('$links on a $kind each, of ± $play m', ({ kind, links, play }) => {
    for (const mass of [1, 5, 30, 100]) {
      for (const rate of [30, 60]) {
        const world = heavy();
        const load = drop(world, kind, links, play, mass);
        const lowest = links * (LENGTH + play) + ROPE;
        // Energy is counted from where all of it hangs.
        const rest = 10 * (mass + links * 0.075) * lowest;
        const start = energyOf(world) + rest;
        let most = 0;
        let farthest = 0;
        for (let i = 0; i < 5 * rate; i += 1) {
          world.step(1 / rate);
          most = Math.max(most, energyOf(world) + rest);
          farthest = Math.max(farthest, Math.hypot(...load.getPosition()));
        }
        const which = `${mass} kg, steps of 1/${rate} s`;
        expect(most, which).toBeLessThan(1.3 * start);
        expect(farthest - lowest, which).toBeLessThan(0.1 + 0.025 * mass);
      }
    }
  });
});
