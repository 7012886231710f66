import { expect, it } from 'vitest';
import { validate } from '../../src/audit/index.js';
import { phys2D } from '../../src/index.js';
import { add, box, heavy, plainBody, staticBody, steps, tie } from '../conformance/setting.js';

it('goes on to the bit after a restore, whatever constraints of other worlds are between its bodies', () => {
  const [world, other] = [heavy(), heavy()];
  const ground = staticBody();
  const [first, second] = [plainBody({ position: [1, 0] }), plainBody({ position: [2, 0] })];
  add(world, first, second);
  for (const [bodyA, bodyB] of [
    [ground, first],
    [first, second],
  ] as const) {
    tie(world, phys2D.createPointConstraint({ bodyA, bodyB, anchorB: [-1, 0] }));
  }
  steps(world, 30);
  tie(other, phys2D.createWeldConstraint({ bodyA: first, bodyB: second }));
  const snapshot = world.snapshot();
  steps(world, 60);
  const hash = world.hash();
  world.restore(snapshot);
  steps(world, 60);
  expect(world.hash()).toBe(hash);
});

it('a constraint that is restored is listed by its bodies, also by one that left another world since', () => {
  for (const joins of [false, true]) {
    const [world, other] = [heavy(), heavy()];
    const [body, anchor] = [plainBody(), plainBody({ type: 'kinematic', position: [1, 0] })];
    add(world, body);
    add(other, anchor);
    const constraint = phys2D.createDistanceConstraint({ bodyA: body, bodyB: anchor, upperBound: 1 });
    world.addConstraint(constraint);
    steps(world, 1);
    const snapshot = world.snapshot();
    other.removeRigidBody(anchor);
    if (joins) world.addRigidBody(anchor);
    world.restore(snapshot);
    expect(anchor.constraints).toEqual([constraint]);
    expect(constraint.world).toBe(world);
    validate(world);
    add(world, anchor);
    world.removeRigidBody(anchor);
    expect(constraint.world).toBeNull();
  }
});

it('contacts are told as before after a restore, where a body was put elsewhere since the step', () => {
  const world = heavy();
  const shape = box(1, 1);
  const body = phys2D.createRigidBody({ shapes: [shape] });
  add(world, staticBody({ position: [0, 1], shapes: [box(20, 1)] }), body);
  steps(world, 30);
  const read = () => {
    const [arbiter] = shape.arbiters;
    return [arbiter!.getNormal(), ...arbiter!.contacts.map((point) => [point.getPosition(), point.getPenetration()])];
  };
  const before = read();
  body.setPosition([3, -5]);
  body.setRotation(0.5);
  expect(read()).toEqual(before);
  const hash = world.hash();
  world.restore(world.snapshot());
  expect(read()).toEqual(before);
  expect(world.hash()).toBe(hash);
});
