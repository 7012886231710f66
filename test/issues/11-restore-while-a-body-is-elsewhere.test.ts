import { expect, it } from 'vitest';
import { validate } from '../../src/audit/index.js';
import { phys2D } from '../../src/index.js';

// A body that went to another world while it touched something was still named by an `end` event of the first: that could not be restored to where
// it was. Found by random programs.

const disc = (x: number, group: number) =>
  phys2D.createRigidBody({ position: [x, 0], shapes: [phys2D.createCircleShape({ radius: 0.5, group })] });

it('a world is restored though a body that an event still names is in another world', () => {
  const [world, other] = [phys2D.createWorld({ gravity: [0, 0] }), phys2D.createWorld({ gravity: [0, 0] })];
  const bodies = [disc(0, 1), disc(0.9, 2)] as const;
  const [stays, goes] = bodies.map(({ shapes }) => shapes[0]!) as [(typeof bodies)[0]['shapes'][0], never];
  bodies.forEach((body) => void world.addRigidBody(body));
  const met: unknown[] = [];
  world.step(1 / 60);
  stays.addEventListener('end', (_, shape) => void met.push(shape));
  world.removeRigidBody(bodies[1]);
  const neighbour = disc(1.8, 4);
  other.addRigidBody(bodies[1]);
  other.addRigidBody(neighbour);
  other.step(1 / 60);

  const saved = world.snapshot();
  const hash = world.hash();
  bodies[1].shapes[0]!.setGroup(8);
  other.step(1 / 60);
  const otherHash = other.hash();
  world.restore(saved);
  validate(world);
  validate(other);
  expect(world.hash()).not.toBe(hash);
  expect(other.hash()).toBe(otherHash);
  bodies[1].shapes[0]!.setGroup(2);
  expect(world.hash()).toBe(hash);

  world.step(1 / 60);
  other.step(1 / 60);
  validate(world);
  validate(other);
  expect(met).toEqual([goes]);
  expect(other.dynamicArbiters).toHaveLength(1);
});

it('a pair that never touched, of a body that is in another world now, is not restored', () => {
  const [world, other] = [phys2D.createWorld({ gravity: [0, 0] }), phys2D.createWorld({ gravity: [0, 0] })];
  const bodies = [disc(0, 1), disc(1.91, 2), disc(0.9, 4)] as const;
  bodies.forEach((body) => void world.addRigidBody(body));
  world.step(1 / 60);
  expect(world.dynamicArbiters).toHaveLength(1);
  world.removeRigidBody(bodies[1]);
  other.addRigidBody(bodies[1]);
  const hash = world.hash();
  world.restore(world.snapshot());
  validate(world);
  expect(world.hash()).toBe(hash);
});
