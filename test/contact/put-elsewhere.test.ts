import { describe, expect, it } from 'vitest';
import { type Arbiter, phys2D, type RigidBody } from '../../src/index.js';
import { add, addFloor, box, boxBody, DT, heavy, plainBody, steps, weightless } from '../conformance/setting.js';

// What is told of a contact is that of the end of the step, wherever its bodies are put since: a handler that sent a ball through a portal made sparks of the next one fly half-way there.

/** Normal, and position and penetration of each point. */
function told(arbiter: Arbiter): number[] {
  return [
    ...arbiter.getNormal(),
    ...arbiter.contacts.flatMap((contact) => [...contact.getPosition(), contact.getPenetration()]),
  ];
}

describe('a contact whose bodies are put elsewhere after the step', () => {
  const changes: Record<string, (body: RigidBody) => void> = {
    'by setPosition': (body) => body.setPosition([50, 50]),
    'by setRotation': (body) => body.setRotation(1),
    twice: (body) => {
      body.setPosition([50, 50]);
      body.setPosition([-3, 20]);
    },
  };
  for (const [how, change] of Object.entries(changes)) {
    it(`is told as it was, ${how}`, () => {
      const world = heavy();
      addFloor(world);
      const box = boxBody(1, 1, { position: [0, 0], rotation: 0.001 });
      world.addRigidBody(box);
      for (let i = 0; i < 5; i += 1) {
        world.step(DT);
      }
      const [arbiter] = world.staticArbiters;
      const before = told(arbiter!);
      expect(before).toHaveLength(8);
      change(box);
      expect(told(arbiter!)).toEqual(before);
      box.setPosition([1, 0]);
      box.setRotation(0);
      world.step(DT);
      expect(told(world.staticArbiters[0]!)).not.toEqual(before);
      expect(world.staticArbiters[0]!.contacts[0]!.getPosition()[0]).toBeGreaterThan(0.4);
    });
  }

  it.each([
    ['put elsewhere', (body: RigidBody) => body.setPosition([50, 50])],
    [
      'taken away and put elsewhere',
      (body: RigidBody) => {
        body.world!.removeRigidBody(body);
        body.setPosition([50, 50]);
      },
    ],
  ])('is told alike to the handler that comes next, %s by the first', (_, act) => {
    const world = weightless();
    const [one, two] = [plainBody(), plainBody({ position: [0.9, 0] })];
    const heard: number[][] = [];
    one.shapes[0]!.addEventListener('begin', (arbiter) => {
      heard.push(told(arbiter));
      act(two);
    });
    two.shapes[0]!.addEventListener('begin', (arbiter) => {
      heard.push(told(arbiter));
    });
    world.addRigidBody(one);
    world.addRigidBody(two);
    world.step(DT);
    expect(heard).toHaveLength(2);
    // Of what was taken away only the normal is left.
    expect(heard[1]).toEqual(heard[0]!.slice(0, heard[1]!.length));
  });

  it('is that of now again once the world was restored', () => {
    const world = weightless();
    const [one, two] = [plainBody(), plainBody({ position: [0.9, 0] })];
    world.addRigidBody(one);
    world.addRigidBody(two);
    world.step(DT);
    const before = told(world.dynamicArbiters[0]!);
    const snapshot = world.snapshot();
    two.setPosition([0.8, 0]);
    world.restore(snapshot);
    expect(told(world.dynamicArbiters[0]!)).toEqual(before);
    two.setPosition([0.8, 0]);
    expect(told(world.dynamicArbiters[0]!)).toEqual(before);
  });
});

it('nothing hangs beside what it stood on, with a gap between them', () => {
  // Turned by less than it takes to look for other edges, a rod of 20 m comes to be 7 mm beside its post.
  const post = box(0.02, 0.02);
  const rod = box(0.004, 20);
  const world = heavy();
  const body = plainBody({ shapes: [rod], position: [0, -10.0095], inertia: Infinity });
  add(world, phys2D.createRigidBody({ type: 'static', shapes: [post] }), body);
  steps(world, 1);
  expect(rod.arbiters[0]!.active).toBe(true);
  body.setRotation(0.0019);
  steps(world, 120);
  expect(body.getPosition()[1]).toBeGreaterThan(0);
});
