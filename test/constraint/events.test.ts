import { describe, expect, it, vi } from 'vitest';
import { type Constraint, type DistanceConstraint, phys2D } from '../../src/index.js';
import { add, DT, heavy, near, plainBody, staticBody, steps, tie, weightless } from '../conformance/setting.js';
import { awake, listen, roped, sleeping } from './roped.js';

// Events of constraints: which, when, in what order, and what is silent.

describe('events', () => {
  it('handlers get no arguments, `this`, and their turn in the order in which they were added', () => {
    const { world, rope } = sleeping();
    const calls: unknown[][] = [];
    for (const name of ['first', 'second']) {
      rope.addEventListener('sleep', function (this: Constraint, ...args: unknown[]) {
        calls.push([name, this, args.length]);
      });
    }
    steps(world, 63);
    expect(calls).toEqual([
      ['first', rope, 0],
      ['second', rope, 0],
    ]);
  });

  it('wake() and listeners are silent for the constraint, not for its bodies', () => {
    const calls: Record<string, (rope: DistanceConstraint) => unknown> = {
      wake: (rope) => rope.wake(),
      addEventListener: (rope) => rope.addEventListener('break', () => {}),
    };
    for (const [name, call] of Object.entries(calls)) {
      const { world, a, b, rope, log } = sleeping();
      call(rope);
      expect(awake(a, b, rope), name).toEqual([true, true, true]);
      expect(log, name).toEqual([]);
      steps(world, 1);
      expect([...log].sort(), name).toEqual(['a wake', 'b wake']);
      steps(world, 5);
      expect(log, name).toHaveLength(2);
    }
  });

  it('removing a listener wakes silently, a failed change of listeners does not wake', () => {
    const { world, a, rope, log } = sleeping();
    const handler = (): void => {};
    expect(rope.removeEventListener('break', handler)).toBe(false);
    expect(rope.addEventListener('nonsense' as 'break', handler)).toBe(false);
    expect(awake(a, rope)).toEqual([false, false]);
    rope.addEventListener('break', handler);
    steps(world, 63);
    log.length = 0;
    expect(rope.addEventListener('break', handler)).toBe(false);
    expect(awake(a, rope)).toEqual([false, false]);
    expect(rope.removeEventListener('break', handler)).toBe(true);
    expect(awake(a, rope)).toEqual([true, true]);
    steps(world, 1);
    expect([...log].sort()).toEqual(['a wake', 'b wake']);
  });

  it('changes are not silent: setters, configure, and what happens to a body', () => {
    const calls: Record<string, (all: ReturnType<typeof sleeping>) => unknown> = {
      setUpperBound: ({ rope }) => rope.setUpperBound(4),
      configure: ({ rope }) => rope.configure({}),
      applyImpulse: ({ a }) => a.applyImpulse([0, 0]),
      setGravity: ({ world }) => world.setGravity([0, 1e-9]),
    };
    for (const [name, call] of Object.entries(calls)) {
      const all = sleeping();
      call(all);
      expect(awake(all.a, all.b, all.rope), name).toEqual([true, true, true]);
      steps(all.world, 1);
      expect([...all.log].sort(), name).toEqual(['a wake', 'b wake', 'rope wake']);
    }
    const { world, a, log } = sleeping();
    a.wake();
    steps(world, 1);
    expect([...log].sort()).toEqual(['b wake', 'rope wake']);
  });

  it('come in the order wake, sleep, break', () => {
    const { world, rope, log } = sleeping({ breakUnderError: true, maxError: 0.5 });
    const lonely = phys2D.createAngleConstraint({ bodyA: staticBody(), bodyB: staticBody() });
    lonely.addEventListener('sleep', () => log.push('lonely sleep'));
    tie(world, lonely);
    rope.setUpperBound(1);
    steps(world, 1);
    expect(log.slice(0, 3).sort()).toEqual(['a wake', 'b wake', 'rope wake']);
    expect(log.slice(3)).toEqual(['lonely sleep', 'rope break']);
  });

  it('what woke between steps is told to the handlers present when the step begins', () => {
    const { world, rope } = sleeping();
    const [kept, late] = [vi.fn(), vi.fn()];
    rope.addEventListener('wake', kept);
    steps(world, 63);
    rope.setUpperBound(4);
    rope.removeEventListener('wake', kept);
    rope.addEventListener('wake', late);
    steps(world, 1);
    expect(kept).not.toHaveBeenCalled();
    expect(late).toHaveBeenCalledTimes(1);
  });

  it('adding, enabling, disabling, removing and sleep() by hand are silent for the constraint', () => {
    const { world, rope } = roped();
    const log = listen({ rope });
    tie(world, rope);
    rope.disable();
    rope.enable();
    rope.sleep();
    rope.wake();
    world.removeConstraint(rope);
    tie(world, rope);
    steps(world, 2);
    expect(log).toEqual([]);
  });

  it('without dynamic bodies it falls asleep in the next step, with an event', () => {
    const world = weightless();
    const platform = plainBody({ type: 'kinematic', velocity: [1, 0] });
    add(world, platform);
    const rope = phys2D.createDistanceConstraint({ bodyA: platform, bodyB: staticBody(), upperBound: 0.1 });
    const log = listen({ rope });
    tie(world, rope);
    steps(world, 1);
    expect(log).toEqual(['rope sleep']);
    expect(world.liveConstraints).toEqual([]);
    steps(world, 5);
    expect(log).toHaveLength(1);
  });

  it('a break handler may add the constraint again, and finds it in no world', () => {
    for (const removeOnBreak of [true, false]) {
      const world = heavy();
      const body = plainBody({ position: [0, 1] });
      add(world, body);
      const params = { maxForce: 5, breakUnderForce: true, removeOnBreak };
      const hinge = phys2D.createPointConstraint({ bodyA: staticBody(), bodyB: body, anchorB: [0, -1], ...params });
      const seen: unknown[] = [];
      hinge.addEventListener('break', () => {
        seen.push([hinge.world, hinge.isEnabled(), body.constraints.length, ...hinge.getImpulseForBody(body)]);
        hinge.configure({ maxForce: Infinity });
        if (removeOnBreak) expect(world.addConstraint(hinge)).toBe(true);
        else hinge.enable();
      });
      tie(world, hinge);
      steps(world, 40);
      expect(seen).toEqual([[removeOnBreak ? null : world, removeOnBreak, removeOnBreak ? 0 : 1, 0, 0, 0]]);
      expect(world.liveConstraints).toEqual([hinge]);
      near(body.transformLocalPointToWorld([0, -1]), [0, 0], 1e-3);
    }
  });

  it('a handler that throws: the error comes out of step, the next step works', () => {
    const { world, a, rope } = roped({ upperBound: 1, breakUnderError: true, maxError: 0.5 });
    rope.addEventListener('break', () => {
      throw new Error('mine');
    });
    const other = vi.fn();
    rope.addEventListener('break', other);
    tie(world, rope);
    expect(() => world.step(DT)).toThrow('mine');
    expect(other).toHaveBeenCalledTimes(1);
    world.step(DT);
    expect(world.timeStamp).toBe(2);
    expect(a.constraints).toEqual([]);
  });

  it('a constraint woken in its own sleep handler gets its wake event after the next step', () => {
    const { world, rope, log } = sleeping();
    rope.addEventListener('sleep', () => rope.setUpperBound(rope.getUpperBound() + 1));
    steps(world, 62);
    log.length = 0;
    steps(world, 1);
    expect(log.filter((entry) => entry.startsWith('rope'))).toEqual(['rope wake']);
    expect(awake(rope)).toEqual([true]);
  });
});
