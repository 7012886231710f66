import { describe, expect, it } from 'vitest';
import { phys2D, type RigidBody, type World } from '../../src/index.js';
import { deserialize, serialize } from '../../src/state/index.js';
import { add, addFloor, boxBody, heavy, steps } from '../conformance/setting.js';

// Bodies that do not fall asleep by themselves.

/** Three boxes on a floor: a pair that touches, and one for itself. */
function boxes(allowSleeping: boolean) {
  const world = heavy();
  addFloor(world);
  const first = boxBody(1, 1, { position: [0, -0.5], allowSleeping });
  const beside = boxBody(1, 1, { position: [0, -1.5] });
  const alone = boxBody(1, 1, { position: [5, -0.5] });
  add(world, first, beside, alone);
  return { world, first, beside, alone };
}

describe('a body', () => {
  it('may sleep unless told otherwise', () => {
    expect(phys2D.createRigidBody().allowSleeping).toBe(true);
    expect(phys2D.createRigidBody({ allowSleeping: false }).allowSleeping).toBe(false);
    const { world, first, beside, alone } = boxes(true);
    steps(world, 200);
    expect([first, beside, alone].map(({ sleeping }) => sleeping)).toEqual([true, true, true]);
  });

  it('that may not sleep stays awake with what lies on it, and nothing else does', () => {
    const { world, first, beside, alone } = boxes(false);
    steps(world, 1000);
    expect([first, beside, alone].map(({ sleeping }) => sleeping)).toEqual([false, false, true]);
    world.removeRigidBody(first);
    world.removeRigidBody(beside);
    beside.setPosition([0, -0.5]);
    world.addRigidBody(beside);
    steps(world, 200);
    expect(beside.sleeping).toBe(true);
  });

  it('wakes with its island when that changes, as by other setters, and sleeps after the whole delay', () => {
    const { world, first, beside, alone } = boxes(true);
    let heard = 0;
    first.addEventListener('wake', () => (heard += 1));
    steps(world, 200);
    first.allowSleeping = true;
    expect(first.sleeping).toBe(true);
    first.allowSleeping = false;
    expect([first, beside, alone].map(({ sleeping }) => sleeping)).toEqual([false, false, true]);
    steps(world, 200);
    expect(first.sleeping).toBe(false);
    first.allowSleeping = true;
    steps(world, 59);
    expect(first.sleeping).toBe(false);
    steps(world, 3);
    expect([first.sleeping, beside.sleeping, heard]).toEqual([true, true, 1]);
  });

  it('may still be put to sleep by hand, and added asleep', () => {
    const { world, first, beside } = boxes(false);
    first.sleep();
    expect(first.sleeping).toBe(true);
    const added = boxBody(1, 1, { position: [-5, -0.5], sleeping: true, allowSleeping: false });
    add(world, added);
    steps(world, 10);
    expect(added.sleeping).toBe(true);
    added.wake();
    steps(world, 300);
    expect([added.sleeping, beside.sleeping]).toEqual([false, false]);
  });

  it('that is kinematic stays awake where it stands, with what lies on it', () => {
    const world = heavy();
    const floorAt = (x: number, allowSleeping: boolean): RigidBody =>
      boxBody(4, 1, { type: 'kinematic', position: [x, 0.5], allowSleeping });
    const riderAt = (x: number): RigidBody => boxBody(1, 1, { position: [x, -0.5] });
    const [floor, rider] = [floorAt(0, false), riderAt(0)];
    const [other, sleeper] = [floorAt(20, true), riderAt(20)];
    add(world, floor, rider, other, sleeper);
    steps(world, 300);
    expect([floor, rider, other, sleeper].map(({ sleeping }) => sleeping)).toEqual([false, false, true, true]);
    floor.allowSleeping = true;
    steps(world, 300);
    expect([floor.sleeping, rider.sleeping]).toEqual([true, true]);
  });

  it('that is static sleeps as ever', () => {
    const body = boxBody(1, 1, { type: 'static', allowSleeping: false });
    const world = heavy();
    add(world, body);
    steps(world, 3);
    expect([body.sleeping, world.liveKinematics.length]).toEqual([true, 0]);
    body.allowSleeping = true;
    expect(body.sleeping).toBe(true);
  });
});

it('all bodies of which none may sleep go as in a world in which nothing may, to the bit', () => {
  const run = (ofWorld: boolean): string => {
    const world = phys2D.createWorld({ allowSleeping: !ofWorld });
    addFloor(world);
    const bodies = Array.from({ length: 12 }, (_, i) =>
      boxBody(0.5, 0.4, { position: [0.1 * (i % 3), -0.6 * i - 0.5], rotation: 0.1 * i, allowSleeping: ofWorld }),
    );
    add(world, ...bodies);
    steps(world, 400);
    return bodies.map((body) => [...body.getPosition(), ...body.getVelocity(), body.getRotation()].join()).join(';');
  };
  expect(run(true)).toBe(run(false));
});

it('it is part of hashes, snapshots and saved worlds', () => {
  const { world, first } = boxes(false);
  steps(world, 10);
  const [hash, snapshot, data] = [world.hash(), world.snapshot(), serialize(world)];
  const sleepersAfter = (of: World): number => {
    steps(of, 300);
    return of.rigidBodies.filter((body) => body.isDynamic() && body.sleeping).length;
  };
  const copy = deserialize(phys2D, JSON.parse(JSON.stringify(data)));
  first.allowSleeping = true;
  expect(world.hash()).not.toBe(hash);
  expect(sleepersAfter(world)).toBe(3);
  world.restore(snapshot);
  expect([first.allowSleeping, world.hash()]).toEqual([false, hash]);
  expect([sleepersAfter(world), sleepersAfter(copy)]).toEqual([1, 1]);
});
