import { describe, expect, it, vi } from 'vitest';
import type { Arbiter, RigidBody, Shape } from '../../src/index.js';
import { add, addFloor, arbiterOf, box, boxBody, disc, heavy, near, plainBody, steps, weightless } from './setting.js';

/** A body that comes from the left at 5 m/s, and one that is hit by it in the first step; `older` is the first of the two. */
function meeting(movingIsOlder: boolean, shapes: readonly [Shape, Shape] = [disc(0.5), disc(0.5)]) {
  const world = weightless();
  const [older, newer] = shapes;
  const moving = plainBody({
    shapes: [movingIsOlder ? older : newer],
    position: [-0.99, 0],
    velocity: [5, 0],
    inertia: 1e9,
  });
  const still = plainBody({ shapes: [movingIsOlder ? newer : older], inertia: 1e9 });
  add(world, moving, still);
  return { world, moving, still, older, newer };
}

const reject = (arbiter: Arbiter) => arbiter.setAcceptedState(false);
const accept = () => {};

/** A box on the floor with a `preSolve` handler on one of their shapes. */
function onFloor(listener: 'floor' | 'body', handler: (arbiter: Arbiter) => void, isDeterministic?: boolean) {
  const world = heavy();
  const floor = addFloor(world);
  const body = boxBody(1, 1);
  const shape = (listener === 'floor' ? floor : body).shapes[0]!;
  shape.addEventListener('preSolve', handler, undefined, isDeterministic);
  add(world, body);
  return { world, body, floor };
}

describe('preSolve', () => {
  it('C-136 is called in each step of contact, on the owner, with the arbiter and the other shape [R-04]', () => {
    for (const heard of ['older', 'newer'] as const) {
      const pair = meeting(true);
      pair.moving.setVelocity([0, 0]);
      const calls: unknown[][] = [];
      pair[heard].addEventListener('preSolve', function (this: Shape, arbiter: Arbiter, other: Shape) {
        calls.push([this, other, arbiter.shapeA, arbiter.shapeB, pair.world.timeStamp]);
      });
      steps(pair.world, 3);
      const other = heard === 'older' ? pair.newer : pair.older;
      expect(calls).toEqual([1, 2, 3].map((stamp) => [pair[heard], other, pair.older, pair.newer, stamp]));
    }
  });

  it('C-136 … those of shapeA first; the last word counts', () => {
    for (const verdicts of [
      [true, false],
      [false, true],
    ] as const) {
      const { world, still, older, newer } = meeting(true);
      const calls: string[] = [];
      newer.addEventListener('preSolve', (arbiter) => {
        calls.push('newer');
        arbiter.setAcceptedState(verdicts[1]);
      });
      older.addEventListener('preSolve', (arbiter) => {
        calls.push('older');
        arbiter.setAcceptedState(verdicts[0]);
      });
      steps(world, 1);
      expect(calls).toEqual(['older', 'newer']);
      expect(still.getVelocity()[0] > 0).toBe(verdicts[1]);
    }
  });

  it('C-137 a mask filters by the group of the other shape [D-11]', () => {
    for (const [group, heard] of [
      [1, 0],
      [8, 1],
      [12, 1],
    ] as const) {
      for (const listener of ['older', 'newer'] as const) {
        const pair = meeting(true);
        pair[listener === 'older' ? 'newer' : 'older'].setGroup(group);
        const handler = vi.fn();
        pair[listener].addEventListener('preSolve', handler, 8);
        steps(pair.world, 1);
        expect(handler, `${group} ${listener}`).toHaveBeenCalledTimes(heard);
      }
    }
  });

  it('C-138 is never called for sensors', () => {
    for (const senses of [
      [true, false],
      [false, true],
      [true, true],
    ] as const) {
      const { world, older, newer } = meeting(true, [
        disc(0.5, { sensor: senses[0] }),
        box(1, 1, { sensor: senses[1] }),
      ]);
      const handler = vi.fn();
      const begin = vi.fn();
      for (const shape of [older, newer]) {
        shape.addEventListener('preSolve', handler);
        shape.addEventListener('begin', begin);
      }
      steps(world, 5);
      expect(begin).toHaveBeenCalledTimes(2);
      expect(handler).not.toHaveBeenCalled();
    }
  });

  it('C-139 what is rejected passes through, with its events', () => {
    for (const movingIsOlder of [true, false]) {
      for (const shapes of [
        [disc(0.5), disc(0.5)],
        [box(1, 1), disc(0.5)],
        [box(1, 1), box(1, 1)],
      ] as const) {
        const { world, moving, still, older, newer } = meeting(movingIsOlder, shapes);
        const calls: string[] = [];
        for (const type of ['begin', 'progress', 'end'] as const) {
          older.addEventListener(type, (arbiter) => {
            calls.push(type);
            expect(arbiter.active).toBe(type !== 'end');
            if (type !== 'end') {
              expect(arbiter.isStateAccepted()).toBe(false);
              expect(arbiter.contacts.length).toBeGreaterThan(0);
              expect(arbiter.getImpulseForBody(moving).map(Math.abs)).toEqual([0, 0, 0]);
            }
          });
        }
        newer.addEventListener('preSolve', reject);
        steps(world, 40);
        expect(moving.getVelocity()).toEqual([5, 0]);
        expect([still.getVelocity(), still.getPosition()]).toEqual([
          [0, 0],
          [0, 0],
        ]);
        near(moving.getPosition()[0], -0.99 + (5 * 40) / 60);
        expect([calls[0], calls.at(-1)]).toEqual(['begin', 'end']);
        expect(new Set(calls.slice(1, -1))).toEqual(new Set(['progress']));
      }
    }
  });

  it('C-140 a persistent decision is asked for once an interaction', () => {
    const { world, moving, still, older } = meeting(false);
    const handler = vi.fn((arbiter: Arbiter) => {
      arbiter.setAcceptedState(false);
      arbiter.setPersistentState(true);
    });
    older.addEventListener('preSolve', handler);
    steps(world, 40);
    expect(handler).toHaveBeenCalledTimes(1);
    expect(moving.getVelocity()).toEqual([5, 0]);
    moving.setVelocity([-5, 0]);
    steps(world, 40);
    expect(handler).toHaveBeenCalledTimes(2);
    expect([moving.getVelocity(), still.getVelocity()]).toEqual([
      [-5, 0],
      [0, 0],
    ]);
  });

  it('C-140 … also when they meet again one step after they parted', () => {
    const { world, moving, older } = meeting(false);
    const handler = vi.fn((arbiter: Arbiter) => arbiter.setPersistentState(true));
    older.addEventListener('preSolve', handler);
    moving.setVelocity([0, 0]);
    steps(world, 3);
    expect(handler).toHaveBeenCalledTimes(1);
    moving.setPosition([-3, 0]);
    steps(world, 1);
    moving.setPosition([-0.99, 0]);
    steps(world, 3);
    expect(handler).toHaveBeenCalledTimes(2);
  });

  it('C-140 a decision that is not persistent holds for one step', () => {
    const { world, moving, still, older } = meeting(true);
    const handler = (arbiter: Arbiter) => arbiter.setAcceptedState(false);
    older.addEventListener('preSolve', handler);
    steps(world, 2);
    expect(still.getVelocity()).toEqual([0, 0]);
    older.removeEventListener('preSolve', handler);
    arbiterOf(world, moving, still)!.setAcceptedState(false);
    steps(world, 1);
    expect(still.getVelocity()[0]).toBeGreaterThan(1);
    expect(arbiterOf(world, moving, still)!.isStateAccepted()).toBe(true);
  });

  it('C-140 a decision made from outside holds if it is persistent', () => {
    const { world, moving, still, older } = meeting(true);
    moving.setVelocity([0, 0]);
    const handler = vi.fn();
    older.addEventListener('preSolve', handler);
    steps(world, 1);
    const arbiter = arbiterOf(world, moving, still)!;
    arbiter.setAcceptedState(false);
    arbiter.setPersistentState(true);
    moving.setVelocity([5, 0]);
    steps(world, 10);
    expect(still.getVelocity()[0]).toBeLessThan(0.1);
    expect(handler).toHaveBeenCalledTimes(1);
    arbiter.setPersistentState(false);
    steps(world, 1);
    expect(handler).toHaveBeenCalledTimes(2);
    expect(arbiter.isStateAccepted()).toBe(true);
  });

  it('C-141 a value set at the first contact takes effect at once', () => {
    for (const movingIsOlder of [true, false]) {
      for (const shapes of [
        [disc(0.5), disc(0.5)],
        [box(1, 1), box(1, 1)],
      ] as const) {
        const { world, moving, still, newer } = meeting(movingIsOlder, shapes);
        still.setAsStatic();
        newer.addEventListener('preSolve', (arbiter) => arbiter.setElasticity(1));
        steps(world, 10);
        near(moving.getVelocity(), [-5, 0], 0.01);
      }
    }
  });

  it('C-141 … so that an approach at any distance ends in the bounce', () => {
    for (const distance of [1.001, 1.01, 1.03, 1.2]) {
      const { world, moving, still, newer } = meeting(true);
      still.setAsStatic();
      moving.setPosition([-distance, 0]);
      newer.addEventListener('preSolve', (arbiter) => arbiter.setElasticity(1));
      steps(world, 10);
      near(moving.getVelocity(), [-5, 0], 0.01);
    }
  });

  it('C-142 the first call sees contacts and no impulse [D-03]', () => {
    for (const shapes of [
      [disc(0.5), disc(0.5)],
      [box(1, 1), disc(0.5)],
      [disc(0.5), box(1, 1)],
      [box(1, 1), box(1, 1)],
    ] as const) {
      const { world, moving, still, older } = meeting(true, shapes);
      let calls = 0;
      older.addEventListener('preSolve', (arbiter) => {
        calls += 1;
        expect([arbiter.isStateAccepted(), arbiter.isStatePersistent()]).toEqual([true, false]);
        near(arbiter.getNormal(), [1, 0]);
        expect(arbiter.contacts.length).toBeGreaterThanOrEqual(1);
        for (const contact of arbiter.contacts) {
          near(contact.getPosition()[0], -0.495);
          near(contact.getPenetration(), 0.01);
        }
        for (const body of [moving, still]) {
          expect(arbiter.getImpulseForBody(body).map(Math.abs)).toEqual([0, 0, 0]);
        }
        expect(arbiter.getRollingImpulse()).toBe(0);
      });
      steps(world, 1);
      expect(calls).toBe(1);
    }
  });

  it('C-142 later ones see the impulses of the step before', () => {
    const { world, body, floor } = onFloor('body', (arbiter) => {
      seen = arbiter.getImpulseForBody(body)[1];
      near(arbiter.getImpulseForBody(floor)[1], -seen);
    });
    let seen = 0;
    steps(world, 30);
    near(seen, -body.getMass() / 6, 1e-3);
  });

  it('C-143 a deterministic handler lets a body sleep', () => {
    for (const listener of ['floor', 'body'] as const) {
      const { world, body } = onFloor(listener, accept, true);
      steps(world, 200);
      expect(body.sleeping).toBe(true);
    }
  });

  it('C-144 another one keeps it awake', () => {
    for (const listener of ['floor', 'body'] as const) {
      for (const isDeterministic of [false, undefined]) {
        const { world, body, floor } = onFloor(listener, accept, isDeterministic);
        floor.shapes[0]!.addEventListener('preSolve', () => {}, undefined, true);
        steps(world, 200);
        expect(body.sleeping).toBe(false);
      }
    }
  });

  it('C-144 … not if its mask leaves the other shape out', () => {
    const { world, body, floor } = onFloor('body', accept, true);
    floor.shapes[0]!.addEventListener('preSolve', () => {}, 8);
    steps(world, 200);
    expect(body.sleeping).toBe(true);
  });

  it('C-145 unless its decision is persistent', () => {
    for (const listener of ['floor', 'body'] as const) {
      const { world, body } = onFloor(listener, (arbiter) => arbiter.setPersistentState(true));
      steps(world, 200);
      expect(body.sleeping).toBe(true);
    }
  });

  it('C-146 a handler that may change its mind keeps both bodies awake [D-15]', () => {
    for (const heard of ['older', 'newer'] as const) {
      const pair = meeting(true);
      pair.moving.setVelocity([0, 0]);
      pair[heard].addEventListener('preSolve', reject);
      steps(pair.world, 200);
      expect([pair.moving.sleeping, pair.still.sleeping]).toEqual([false, false]);
    }
  });

  it('C-146 a deterministic rejection lets them sleep, each for itself', () => {
    const { world, moving, still, older } = meeting(true);
    moving.setVelocity([0, 0]);
    older.addEventListener('preSolve', reject, undefined, true);
    steps(world, 30);
    still.wake();
    steps(world, 40);
    expect([moving.sleeping, still.sleeping]).toEqual([true, false]);
    steps(world, 40);
    expect([moving.sleeping, still.sleeping]).toEqual([true, true]);
    still.setVelocity([0.1, 0]);
    steps(world, 5);
    expect(moving.sleeping).toBe(true);
  });

  it('changes of the world are refused', () => {
    const { world, moving, still, older } = meeting(true);
    const refused = (body: RigidBody) => [
      world.addRigidBody(plainBody()),
      world.removeRigidBody(body),
      body.removeShape(older),
      body.addShape(disc(1)),
    ];
    const handler = vi.fn(() => {
      for (const body of [moving, still]) {
        expect(refused(body)).toEqual([false, false, false, false]);
        body.setPosition([9, 9]);
        body.setRotation(1);
      }
      world.clear();
    });
    older.addEventListener('preSolve', handler);
    steps(world, 1);
    expect(handler).toHaveBeenCalledTimes(1);
    expect(world.rigidBodies).toEqual([moving, still]);
    expect([moving.getRotation(), still.getRotation()]).toEqual([0, 0]);
    expect(still.getPosition()[0]).toBeLessThan(1);
    expect(arbiterOf(world, moving, still)!.isStateAccepted()).toBe(true);
  });
});
