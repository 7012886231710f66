import { expect } from 'vitest';
import { type Constraint, type ConstraintParams, phys2D, type RigidBody, type World } from '../../src/index.js';
import { add, plainBody, steps, tie, weightless } from '../conformance/setting.js';

/** Two bodies 3 m apart, the second optionally moved, with a rope of 5 m between them. */
export function roped(params: Partial<Parameters<typeof phys2D.createDistanceConstraint>[0]> = {}) {
  const world = weightless();
  const [a, b] = [plainBody(), plainBody({ position: [3, 0] })];
  add(world, a, b);
  const rope = phys2D.createDistanceConstraint({ bodyA: a, bodyB: b, upperBound: 5, ...params });
  return { world, a, b, rope };
}

/** The same, all asleep. */
export function sleeping(params: ConstraintParams = {}) {
  const all = roped(params);
  tie(all.world, all.rope);
  const log = listen(all);
  steps(all.world, 63);
  expect([all.a.sleeping, all.b.sleeping, all.rope.sleeping]).toEqual([true, true, true]);
  log.length = 0;
  return { ...all, log };
}

/** Notes the events of everything, in order. */
export function listen(parts: Record<string, World | Constraint | RigidBody>): string[] {
  const log: string[] = [];
  for (const [name, part] of Object.entries(parts)) {
    if ('addRigidBody' in part) {
      continue;
    }
    for (const type of ['wake', 'sleep'] as const) {
      part.addEventListener(type, () => log.push(`${name} ${type}`));
    }
    if ('configure' in part) {
      part.addEventListener('break', () => log.push(`${name} break`));
    }
  }
  return log;
}

export const awake = (...parts: (Constraint | RigidBody)[]): boolean[] => parts.map((part) => !part.sleeping);
