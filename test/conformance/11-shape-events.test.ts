import { describe, expect, it, vi } from 'vitest';
import type { Arbiter, RigidBody, Shape, World } from '../../src/index.js';
import { add, addFloor, box, boxBody, disc, heavy, plainBody, steps, weightless } from './setting.js';

const TYPES = ['begin', 'progress', 'end'] as const;

/** Notes the types of the events of a shape. */
function listen(shape: Shape): string[] {
  const calls: string[] = [];
  for (const type of TYPES) {
    shape.addEventListener(type, () => calls.push(type));
  }
  return calls;
}

/** Two plain bodies that overlap, before the first step. */
function overlapping() {
  const world = weightless();
  const a = plainBody();
  const b = plainBody({ position: [0.9, 0] });
  add(world, a, b);
  return { world, a, b, older: a.shapes[0]!, newer: b.shapes[0]! };
}

/** A box above the floor; its events are noted with the state of the arbiter. */
function resting() {
  const world = heavy();
  const floor = addFloor(world);
  const body = boxBody(1, 1);
  add(world, body);
  const calls: string[] = [];
  for (const type of TYPES) {
    body.shapes[0]!.addEventListener(type, ({ sleeping, active }) => {
      calls.push(`${type}${sleeping ? ' sleeping' : ''}${active ? ' active' : ''}`);
    });
  }
  return { world, floor, body, calls };
}

function untilAsleep(world: World, body: RigidBody): void {
  for (let i = 0; i < 200 && !body.sleeping; i += 1) {
    steps(world, 1);
  }
  expect(body.sleeping).toBe(true);
}

describe('shape events', () => {
  it('C-119 one begin, a progress per step, one end [D-75]', () => {
    const shapes: (() => Shape)[] = [
      () => disc(0.5),
      () => disc(0.5, { sensor: true }),
      () => box(1, 1, { sensor: true }),
    ];
    const pairs = [
      [0, 1],
      [1, 0],
      [1, 1],
      [0, 2],
      [2, 0],
    ] as const;
    for (const [still, moving] of pairs) {
      for (const heard of [0, 1] as const) {
        const world = weightless();
        const bodies = [
          plainBody({ shapes: [shapes[still]!()] }),
          plainBody({ shapes: [shapes[moving]!()], position: [-2.03, 0], velocity: [3, 0] }),
        ] as const;
        add(world, ...bodies);
        let inStep: string[] = [];
        for (const type of TYPES) {
          bodies[heard].shapes[0]!.addEventListener(type, (arbiter) => {
            inStep.push(type);
            expect([arbiter.active, arbiter.sleeping]).toEqual([type !== 'end', false]);
          });
        }
        let overlapped = false;
        let seen = 0;
        for (let i = 0; i < 90; i += 1) {
          const overlaps = Math.abs(bodies[1].getPosition()[0]) < 1;
          inStep = [];
          steps(world, 1);
          const expected = overlaps ? (overlapped ? 'progress' : 'begin') : 'end';
          expect(inStep, `step ${i}`).toEqual(overlaps || overlapped ? [expected] : []);
          seen += inStep.length;
          overlapped = overlaps;
        }
        expect(seen).toBeGreaterThan(30);
        expect(overlapped).toBe(false);
      }
    }
  });

  it('C-120 the older shape is told of the newer one', () => {
    const { world, a, b, older, newer } = overlapping();
    const calls: unknown[][] = [];
    for (const type of TYPES) {
      older.addEventListener(type, function (this: Shape, arbiter: Arbiter, other: Shape) {
        calls.push([type, this, other, arbiter.shapeA, arbiter.shapeB]);
      });
    }
    steps(world, 2);
    world.removeRigidBody(b);
    steps(world, 1);
    expect(calls).toEqual(TYPES.map((type) => [type, older, newer, older, newer]));
    expect(a.world).toBe(world);
  });

  it('C-121 the newer shape is told of the older one [D-10]', () => {
    const { world, b, older, newer } = overlapping();
    const calls: unknown[][] = [];
    for (const type of TYPES) {
      newer.addEventListener(type, function (this: Shape, arbiter: Arbiter, other: Shape) {
        calls.push([type, this, other, arbiter.shapeA, arbiter.shapeB]);
      });
    }
    steps(world, 2);
    world.removeRigidBody(b);
    steps(world, 1);
    expect(calls).toEqual(TYPES.map((type) => [type, newer, older, older, newer]));
  });

  it('C-122 a listener with a mask hears of the groups in it', () => {
    for (const [group, heard] of [
      [4, true],
      [6, true],
      [1, false],
    ] as const) {
      for (const listener of ['older', 'newer'] as const) {
        const pair = overlapping();
        const other = listener === 'older' ? pair.newer : pair.older;
        other.setGroup(group);
        const calls: string[] = [];
        for (const type of TYPES) {
          pair[listener].addEventListener(type, () => calls.push(type), 4);
        }
        steps(pair.world, 2);
        pair.world.removeRigidBody(pair.b);
        steps(pair.world, 1);
        expect(calls, `${group} ${listener}`).toEqual(heard ? TYPES : []);
      }
    }
  });

  it('C-123 handlers are called in the order in which they were added', () => {
    const { world, newer } = overlapping();
    const calls: string[] = [];
    const f = () => calls.push('f');
    const g = () => calls.push('g');
    newer.addEventListener('begin', f);
    newer.addEventListener('begin', g, 1);
    newer.addEventListener('begin', f, 1);
    newer.addEventListener('begin', g);
    newer.removeEventListener('begin', f);
    newer.addEventListener('begin', f);
    steps(world, 1);
    expect(calls).toEqual(['g', 'f', 'g', 'f']);
  });

  it('C-124 handlers are called after the step and may change everything', () => {
    const { world, a, b, older } = overlapping();
    const added = plainBody({ position: [0, 9] });
    older.addEventListener('begin', () => {
      a.setPosition([0, -9]);
      expect(a.getPosition()).toEqual([0, -9]);
      expect(world.addRigidBody(added)).toBe(true);
      expect(world.removeRigidBody(b)).toBe(true);
      expect(world.rigidBodies).toEqual([a, added]);
    });
    steps(world, 1);
    expect([a.world, b.world, added.world]).toEqual([world, null, world]);
    expect(a.getPosition()).toEqual([0, -9]);
  });

  it('C-125 a begin handler that removes a body causes one end [D-12]', () => {
    for (const removed of ['a', 'b'] as const) {
      const pair = overlapping();
      const calls = [listen(pair.older), listen(pair.newer)];
      pair.older.addEventListener('begin', () => pair.world.removeRigidBody(pair[removed]));
      steps(pair.world, 1);
      expect(calls).toEqual([['begin'], ['begin']]);
      steps(pair.world, 1);
      expect(calls).toEqual([
        ['begin', 'end'],
        ['begin', 'end'],
      ]);
      steps(pair.world, 5);
      expect(calls[0]).toHaveLength(2);
    }
  });

  it('C-126 a body removed between steps causes one end', () => {
    for (const removed of ['a', 'b'] as const) {
      const pair = overlapping();
      const calls = [listen(pair.older), listen(pair.newer)];
      const active: boolean[] = [];
      pair.newer.addEventListener('end', (arbiter) => {
        active.push(arbiter.active);
        expect([arbiter.shapeA, arbiter.shapeB]).toEqual([pair.older, pair.newer]);
        expect(pair[removed].world).toBe(null);
      });
      steps(pair.world, 3);
      pair.world.removeRigidBody(pair[removed]);
      expect(calls[0]).toEqual(['begin', 'progress', 'progress']);
      steps(pair.world, 40);
      expect(calls[0]).toEqual(['begin', 'progress', 'progress', 'end']);
      expect(calls[1]).toEqual(calls[0]);
      expect(active).toEqual([false]);
    }
  });

  it('C-127 an interaction that is over does not end again [D-14]', () => {
    const cuts: ((pair: ReturnType<typeof overlapping>) => unknown)[] = [
      ({ world, a }) => world.removeRigidBody(a),
      ({ world, b }) => world.removeRigidBody(b),
      ({ a, older }) => a.removeShape(older),
      ({ a, b }) => [a, b].map((body) => body.setAsStatic()),
    ];
    for (const cut of cuts) {
      const pair = overlapping();
      const calls = listen(pair.older);
      steps(pair.world, 1);
      pair.b.setPosition([5, 0]);
      steps(pair.world, 5);
      expect(calls).toEqual(['begin', 'end']);
      cut(pair);
      steps(pair.world, 40);
      expect(calls).toEqual(['begin', 'end']);
    }
  });

  it('C-128 clear() in a handler ends the delivery [D-04]', () => {
    for (const type of TYPES) {
      const { world, a, b, older, newer } = overlapping();
      add(world, plainBody({ position: [0, 5] }), plainBody({ position: [0.9, 5] }));
      const bodies = [...world.rigidBodies];
      steps(world, type === 'begin' ? 0 : 1);
      if (type === 'end') {
        b.setPosition([3, 0]);
        bodies[3]!.setPosition([3, 5]);
      }
      const later = vi.fn();
      const clear = () => world.clear();
      older.addEventListener(type, clear);
      older.addEventListener(type, later);
      newer.addEventListener(type, later);
      bodies[3]!.shapes[0]!.addEventListener(type, later);
      steps(world, 1);
      expect(world.rigidBodies).toEqual([]);
      steps(world, 2);
      expect(later).not.toHaveBeenCalled();
      expect([older.arbiters, world.dynamicArbiters, a.world]).toEqual([[], [], null]);
      older.removeEventListener(type, clear);
      b.setPosition([0.9, 0]);
      add(world, a, b);
      const calls = listen(newer);
      steps(world, 2);
      expect(calls).toEqual(['begin', 'progress']);
    }
  });

  it('C-129 one progress tells that a pair falls asleep', () => {
    const { world, body, calls } = resting();
    untilAsleep(world, body);
    expect(calls.filter((call) => call.includes('sleeping'))).toEqual(['progress sleeping']);
    expect(calls.at(-1)).toBe('progress sleeping');
    expect(calls.at(-2)).toBe('progress active');
    const count = calls.length;
    steps(world, 100);
    expect(calls).toHaveLength(count);
  });

  it('C-130 a pair that wakes goes on', () => {
    const { world, body, calls } = resting();
    untilAsleep(world, body);
    calls.length = 0;
    body.applyImpulse([0, -20]);
    steps(world, 10);
    expect(calls.at(0)).toBe('progress active');
    expect(calls.at(-1)).toBe('end');
    expect(new Set(calls.slice(0, -1))).toEqual(new Set(['progress active']));
  });

  it('C-131 a shape that is taken from its body ends its interactions', () => {
    const { world, a, b, older, newer } = overlapping();
    const calls = [listen(older), listen(newer)];
    steps(world, 2);
    expect(a.removeShape(older)).toBe(true);
    expect([older.arbiters, newer.arbiters, world.dynamicArbiters]).toEqual([[], [], []]);
    steps(world, 3);
    expect(calls[0]).toEqual(['begin', 'progress', 'end']);
    expect(calls[1]).toEqual(calls[0]);
    expect(b.world).toBe(world);
  });

  it('C-131 … and only them', () => {
    const { world, a, older, newer } = overlapping();
    const second = disc(0.5);
    a.addShape(second);
    const calls = [listen(older), listen(second)];
    steps(world, 1);
    a.removeShape(older);
    steps(world, 1);
    expect(calls).toEqual([
      ['begin', 'end'],
      ['begin', 'progress'],
    ]);
    expect(newer.arbiters).toEqual(second.arbiters);
  });

  it('C-132 a body that becomes static leaves the static floor', () => {
    for (const count of [10, 200]) {
      const { world, body, calls } = resting();
      steps(world, count);
      calls.length = 0;
      body.setAsStatic();
      expect([body.shapes[0]!.arbiters, world.staticArbiters]).toEqual([[], []]);
      steps(world, 5);
      expect(calls).toEqual(['end']);
    }
  });

  it('C-133 a pair that parts for one step begins anew', () => {
    const { world, a, b, older } = overlapping();
    const calls = listen(older);
    steps(world, 1);
    b.setPosition([3, 0]);
    steps(world, 1);
    a.setPosition([0, 0]);
    b.setPosition([0.9, 0]);
    steps(world, 1);
    expect(calls).toEqual(['begin', 'end', 'begin']);
  });

  it('C-134 what was caused before the step comes first', () => {
    const { world, b, older } = overlapping();
    const calls: string[] = [];
    older.addEventListener('end', () => calls.push('end'));
    older.addEventListener('begin', () => calls.push('begin'));
    const sleeper = plainBody({ position: [0, 5] });
    add(world, sleeper);
    sleeper.addEventListener('wake', () => calls.push('wake'));
    steps(world, 1);
    sleeper.sleep();
    calls.length = 0;
    sleeper.setVelocity([0, 1]);
    add(world, plainBody({ position: [-0.9, 0] }));
    world.removeRigidBody(b);
    steps(world, 1);
    expect(calls).toEqual(['end', 'wake', 'begin']);
  });

  it('C-135 handlers are those of the moment when the event was caused', () => {
    const { world, older, newer } = overlapping();
    const removed = vi.fn();
    const added = vi.fn();
    older.addEventListener('begin', () => {
      expect(newer.removeEventListener('begin', removed)).toBe(true);
      newer.addEventListener('begin', added);
      older.addEventListener('begin', added);
    });
    newer.addEventListener('begin', removed);
    steps(world, 1);
    expect(removed).toHaveBeenCalledTimes(1);
    expect(added).not.toHaveBeenCalled();
  });

  it('C-135 … also for what is caused between steps', () => {
    const { world, b, older } = overlapping();
    const removed = vi.fn();
    const added = vi.fn();
    older.addEventListener('end', removed);
    steps(world, 1);
    world.removeRigidBody(b);
    older.removeEventListener('end', removed);
    older.addEventListener('end', added);
    steps(world, 1);
    expect(removed).toHaveBeenCalledTimes(1);
    expect(added).not.toHaveBeenCalled();
  });

  it('a listener is known by its type, handler and mask', () => {
    const shape = disc(0.5);
    const f = vi.fn();
    expect(shape.addEventListener('begin', f)).toBe(true);
    expect(shape.addEventListener('begin', f)).toBe(false);
    expect(shape.addEventListener('begin', f, 0xffffffff)).toBe(true);
    expect(shape.addEventListener('begin', f, -1)).toBe(false);
    expect(shape.addEventListener('end', f)).toBe(true);
    expect(shape.addEventListener('nonsense' as 'begin', f)).toBe(false);
    expect(shape.removeEventListener('begin', f, 1)).toBe(false);
    expect(shape.removeEventListener('begin', f)).toBe(true);
    expect(shape.removeEventListener('begin', f)).toBe(false);
    const world = weightless();
    add(world, plainBody({ shapes: [shape] }), plainBody({ position: [0.9, 0], shapes: [shape.clone()] }));
    steps(world, 1);
    expect(f).toHaveBeenCalledTimes(1);
  });
});
