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

  it('C-106 so does every kind, and none without the option', () => {
    for (const ignoreInteractions of [true, false]) {
      for (let kind = 0; kind < 8; kind += 1) {
        const world = weightless();
        const a = plainBody();
        const b = plainBody({ position: [0.9, 0] });
        add(world, a, b);
        const bodies = { bodyA: b, bodyB: a, ignoreInteractions };
        const constraint = [
          phys2D.createPointConstraint({ ...bodies, anchorB: [0.9, 0] }),
          phys2D.createWeldConstraint({ ...bodies, anchorB: [0.9, 0] }),
          phys2D.createAngleConstraint(bodies),
          phys2D.createDistanceConstraint({ ...bodies, upperBound: 1 }),
          phys2D.createLineConstraint({ ...bodies, axis: [1, 0] }),
          phys2D.createMotorConstraint(bodies),
          phys2D.createPulleyConstraint({ ...bodies, bodyC: a, bodyD: b, upperBound: 3 }),
          phys2D.createCustomConstraint({ dimension: 1, bodies: [a, b], jacobian() {}, ignoreInteractions }),
        ][kind]!;
        tie(world, constraint);
        steps(world, 1);
        expect(arbiterOf(world, a, b) === undefined, constraint.type).toBe(ignoreInteractions);
        constraint.disable();
        steps(world, 1);
        expect(arbiterOf(world, a, b), constraint.type).toBeDefined();
      }
    }
  });
});
