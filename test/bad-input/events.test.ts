import { describe, expect, it } from 'vitest';
import { phys2D } from '../../src/index.js';
import { add, disc, plainBody, steps, weightless } from '../conformance/setting.js';
import { type Bad, NOT_BITS, NOT_BOOLEAN, NOT_NON_NEGATIVE, NOT_NUMBERS, refuses } from './refuses.js';

// Listeners and arbiters refuse bad arguments before anything changes.

const NOT_FUNCTION: Bad[] = [
  [1, TypeError],
  ['begin', TypeError, '"begin"'],
  [null, TypeError],
  [undefined, TypeError],
];

describe('listeners', () => {
  const shape = disc(1);
  const body = phys2D.createRigidBody();
  const constraint = phys2D.createMotorConstraint({ bodyA: body, bodyB: phys2D.createRigidBody() });
  const handler = () => {};

  it('refuse what is no function', () => {
    for (const bad of NOT_FUNCTION) {
      for (const method of ['addEventListener', 'removeEventListener'] as const) {
        refuses((value) => shape[method]('begin', value), `Shape.${method}`, 'handler', bad);
        refuses((value) => body[method]('wake', value), `RigidBody.${method}`, 'handler', bad);
        refuses((value) => constraint[method]('break', value), `Constraint.${method}`, 'handler', bad);
      }
    }
  });

  it('refuse bad masks, flags and speeds', () => {
    const where = 'Shape.addEventListener';
    for (const bad of NOT_BITS) {
      refuses((mask) => shape.addEventListener('begin', handler, mask), where, 'mask', bad);
      refuses((mask) => shape.removeEventListener('end', handler, mask), 'Shape.removeEventListener', 'mask', bad);
    }
    for (const bad of NOT_BOOLEAN) {
      refuses((flag) => shape.addEventListener('preSolve', handler, 1, flag), where, 'isDeterministic', bad);
    }
    for (const bad of [...NOT_NON_NEGATIVE, [true, TypeError]] as Bad[]) {
      refuses((speed) => shape.addEventListener('hit', handler, 1, speed), where, 'minimumSpeed', bad);
    }
    expect(shape.removeEventListener('begin', handler)).toBe(false);
    expect(shape.removeEventListener('hit', handler, 1)).toBe(false);
  });

  it('answer false for unknown types', () => {
    for (const type of ['wake', 'collide', 'toString', '', undefined, 3]) {
      expect(shape.addEventListener(type as 'begin', handler)).toBe(false);
    }
    expect(body.addEventListener('begin' as 'wake', handler)).toBe(false);
    expect(constraint.addEventListener('hit' as 'break', handler)).toBe(false);
  });
});

describe('arbiters', () => {
  const world = weightless();
  const a = plainBody();
  add(world, a, plainBody({ position: [0.9, 0] }));
  steps(world, 1);
  const arbiter = a.shapes[0]!.arbiters[0]!;

  it('refuse bad values', () => {
    for (const bad of [...NOT_NUMBERS, [NaN, RangeError]] as Bad[]) {
      refuses((value) => arbiter.setElasticity(value), 'Arbiter.setElasticity', 'elasticity', bad);
    }
    for (const bad of NOT_NON_NEGATIVE) {
      for (const method of ['setStaticFriction', 'setDynamicFriction', 'setRollingFriction'] as const) {
        refuses((value) => arbiter[method](value), `Arbiter.${method}`, 'friction', bad);
      }
    }
    for (const bad of NOT_BOOLEAN) {
      refuses((value) => arbiter.setAcceptedState(value), 'Arbiter.setAcceptedState', 'accepted', bad);
      refuses((value) => arbiter.setPersistentState(value), 'Arbiter.setPersistentState', 'persistent', bad);
    }
    expect([arbiter.isStateAccepted(), arbiter.isStatePersistent(), arbiter.getElasticity()]).toEqual([true, false, 0]);
  });

  it('refuse what is no body, and no place for numbers', () => {
    for (const bad of [
      [undefined, TypeError],
      [null, TypeError],
      [{}, TypeError, 'an object'],
    ] as Bad[]) {
      refuses((value) => arbiter.getImpulseForBody(value), 'Arbiter.getImpulseForBody', 'body', bad);
    }
    expect(() => arbiter.getNormal(null as never)).toThrow(
      'Arbiter.getNormal: dst must be an array to write 2 numbers',
    );
    expect(() => arbiter.contacts[0]!.getPosition(5 as never)).toThrow(
      'Contact.getPosition: dst must be an array to write 2 numbers into, got 5',
    );
  });
});
