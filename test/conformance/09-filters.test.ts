import { describe, expect, it } from 'vitest';
import { phys2D } from '../../src/index.js';
import { add, arbiterOf, plainBody, steps, tie, weightless } from './setting.js';

describe('filters', () => {
  it('C-106 a constraint keeps its bodies from interacting while it is enabled', () => {
    const world = weightless();
    const a = plainBody();
    const b = plainBody({ position: [0.5, 0] });
    add(world, a, b);
    const constraint = phys2D.createAngleConstraint({ bodyA: a, bodyB: b, ignoreInteractions: true });
    tie(world, constraint);
    steps(world, 2);
    expect(a.shapes[0]!.arbiters).toEqual([]);
    constraint.disable();
    steps(world, 1);
    expect(arbiterOf(world, a, b)).toBeDefined();
  });
});
