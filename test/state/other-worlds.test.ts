import { describe, expect, it } from 'vitest';
import { validate } from '../../src/audit/index.js';
import { phys2D, type RigidBody, type World } from '../../src/index.js';
import { add, box, heavy, near, plainBody, staticBody, steps, tie, weightless } from '../conformance/setting.js';

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

describe('what hangs on a body of another world and sleeps wakes', () => {
  it.each<[string, (anchor: RigidBody, there: World) => void]>([
    ['as that is put elsewhere', (anchor) => anchor.setPosition([2, 0])],
    ['as that is set in motion', (anchor) => anchor.setVelocity([1, 0])],
    [
      'as a restore puts that elsewhere',
      (anchor, there) => {
        const before = there.snapshot();
        there.removeRigidBody(anchor);
        anchor.setPosition([2, 0]);
        there.addRigidBody(anchor);
        steps(there, 200);
        there.restore(before);
      },
    ],
  ])('%s', (_, change) => {
    const [here, there] = [weightless(), weightless()];
    const anchor = plainBody({ type: 'kinematic' });
    const body = plainBody();
    add(there, anchor);
    add(here, body);
    const joint = phys2D.createPointConstraint({ bodyA: anchor, bodyB: body, ignoreInteractions: true });
    tie(here, joint);
    for (let i = 0; i < 100; i += 1) steps(here, 1);
    expect(body.sleeping).toBe(true);
    change(anchor, there);
    for (let i = 0; i < 120; i += 1) {
      steps(there, 1);
      steps(here, 1);
    }
    near(body.getPosition(), anchor.getPosition(), 0.02);
  });

  it('as a body in no world that it hangs on becomes static elsewhere', () => {
    const world = weightless();
    const anchor = plainBody({ position: [5, 0] });
    const body = plainBody();
    add(world, body);
    tie(world, phys2D.createPointConstraint({ bodyA: anchor, bodyB: body, ignoreInteractions: true }));
    steps(world, 100);
    expect(body.sleeping).toBe(true);
    anchor.setAsStatic();
    steps(world, 120);
    near(body.getPosition(), [5, 0], 0.01);
  });
});
