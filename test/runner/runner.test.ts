import { describe, expect, it } from 'vitest';
import { phys2D, type World } from '../../src/index.js';
import { FixedStepRunner } from '../../src/runner.js';
import { Recorder, replay } from '../../src/state/index.js';
import { NOT_COUNT, NOT_NON_NEGATIVE, NOT_POSITIVE, refuses } from '../bad-input/refuses.js';
import { add, near, plainBody, weightless } from '../conformance/setting.js';
import { stateHash } from '../scenes/hash.js';
import { buildMixed } from '../scenes/mixed.js';

/** Runs for so many seconds at a frame rate. @returns the world. */
function play(framesPerSecond: number, seconds: number, params: { maxSteps?: number } = {}): World {
  const world = phys2D.createWorld();
  buildMixed(phys2D, world, 20, 4);
  const runner = FixedStepRunner.create({ world, ...params });
  for (let i = 0; i < framesPerSecond * seconds; i += 1) {
    runner.advance(1 / framesPerSecond);
  }
  return world;
}

describe('the pace', () => {
  it.each([24, 30, 50, 60, 75, 144, 240])('is the same on a screen of %d Hz, to a step', (framesPerSecond) => {
    const { timeStamp, simulatedTime } = play(framesPerSecond, 2);
    expect(timeStamp).toBeGreaterThanOrEqual(119);
    expect(timeStamp).toBeLessThanOrEqual(120);
    near(simulatedTime, timeStamp / 60, 1e-9);
  });

  it('gives the same bits after as many steps', () => {
    const [slow, fast] = [play(30, 2), play(144, 2)];
    for (const world of [slow, fast]) {
      while (world.timeStamp < 130) {
        world.step(1 / 60);
      }
    }
    expect(stateHash(fast)).toBe(stateHash(slow));
  });

  it('follows the deltaTime', () => {
    const world = weightless();
    const runner = FixedStepRunner.create({ world, deltaTime: 0.25 });
    expect([0.125, 0.125, 0, 0.5, 0.0625].map((elapsed) => runner.advance(elapsed))).toEqual([0, 1, 0, 2, 0]);
    expect(runner.interpolation).toBe(0.25);
    expect(world.simulatedTime).toBe(0.75);
  });

  it('drops what it can not catch up with, but not the part of a step', () => {
    const world = weightless();
    const runner = FixedStepRunner.create({ world, deltaTime: 0.25, maxSteps: 3 });
    expect(runner.advance(100.125)).toBe(3);
    expect(runner.interpolation).toBe(0.5);
    expect(runner.advance(0.125)).toBe(1);
    expect(world.timeStamp).toBe(4);
  });

  it('stays in bounds whatever time passes', () => {
    const runner = FixedStepRunner.create({ world: weightless() });
    for (const elapsed of [1e-300, 1 / 60, 1e9, 1e300, Number.MAX_VALUE, 1 / 60 - 1e-18, 0]) {
      expect(runner.advance(elapsed)).toBeLessThanOrEqual(5);
      expect(runner.interpolation).toBeGreaterThanOrEqual(0);
      expect(runner.interpolation).toBeLessThan(1);
    }
  });
});

describe('beforeStep', () => {
  it('is called before each step, with the world', () => {
    const world = weightless();
    const runner = FixedStepRunner.create({ world, deltaTime: 0.25 });
    const stamps: number[] = [];
    runner.advance(0.5, (it) => {
      expect(it).toBe(world);
      stamps.push(it.timeStamp);
    });
    expect(stamps).toEqual([0, 1]);
  });
});

describe('what throws', () => {
  const setting = (deltaTime: number, maxSteps?: number) => {
    const world = weightless();
    const body = plainBody();
    add(world, body);
    let awake = false;
    body.addEventListener('wake', () => {
      awake = true;
      throw new Error('a handler');
    });
    body.sleep();
    body.setVelocity([1, 0]);
    return { world, runner: FixedStepRunner.create({ world, deltaTime, maxSteps }), wasTold: () => awake };
  };

  it('a handler: its step is made, those after it are in the next frame', () => {
    const { world, runner, wasTold } = setting(0.25);
    expect(() => runner.advance(0.875)).toThrow('a handler');
    expect([wasTold(), world.timeStamp, runner.interpolation]).toEqual([true, 1, 0.5]);
    expect([runner.advance(0), world.timeStamp]).toEqual([2, 3]);
    expect([runner.advance(0.125), world.timeStamp]).toEqual([1, 4]);
  });

  it('a handler: no more than maxSteps are left over', () => {
    const { world, runner } = setting(0.25, 3);
    expect(() => runner.advance(0.75)).toThrow('a handler');
    expect([runner.advance(0.5), world.timeStamp]).toEqual([3, 4]);
    expect(runner.advance(0)).toBe(0);
  });

  it('beforeStep: its step is made in the next frame', () => {
    const world = weightless();
    const runner = FixedStepRunner.create({ world, deltaTime: 0.25 });
    const refuse = () => {
      throw new Error('no');
    };
    expect(() => runner.advance(0.5, refuse)).toThrow('no');
    expect(world.timeStamp).toBe(0);
    expect([runner.advance(0.25), world.timeStamp]).toEqual([3, 3]);
  });
});

describe('placements', () => {
  it('go from those before the last step to those after it', () => {
    const world = weightless();
    const body = plainBody({ velocity: [4, -8], angularVelocity: 2 });
    add(world, body);
    const runner = FixedStepRunner.create({ world, deltaTime: 0.25 });
    near([...runner.getPosition(body), runner.getRotation(body)], [0, 0, 0]);
    runner.advance(0.25);
    near([...runner.getPosition(body), runner.getRotation(body)], [0, 0, 0], 1e-12);
    runner.advance(0.125);
    near([...runner.getPosition(body), runner.getRotation(body)], [0.5, -1, 0.25], 1e-12);
    runner.advance(0.125);
    near([...runner.getPosition(body), runner.getRotation(body)], [1, -2, 0.5], 1e-12);
    const into = new Float64Array(3);
    expect(runner.getPosition(body, into)).toBe(into);
    near(into, [1, -2, 0], 1e-12);
  });

  it('move evenly on a fast screen', () => {
    const world = weightless();
    const body = plainBody({ velocity: [3, 0] });
    add(world, body);
    const runner = FixedStepRunner.create({ world });
    const places: number[] = [];
    for (let i = 0; i < 144; i += 1) {
      runner.advance(1 / 144);
      places.push(runner.getPosition(body)[0]);
    }
    const ways = places.slice(4).map((x, i) => x - places[i + 3]!);
    near(ways, Array(ways.length).fill(3 / 144), 1e-9);
  });

  it('are the present ones of what rests, was put elsewhere, or is in no world', () => {
    const world = weightless();
    const body = plainBody({ velocity: [4, 0] });
    const still = phys2D.createRigidBody({ type: 'static', position: [1, 2], rotation: 3 });
    add(world, body, still);
    const runner = FixedStepRunner.create({ world, deltaTime: 0.25 });
    runner.advance(0.375);
    near([...runner.getPosition(still), runner.getRotation(still)], [1, 2, 3], 0);
    body.setPosition([100, 0]);
    near(runner.getPosition(body), [99.5, 0], 1e-12);
    body.sleep();
    near(runner.getPosition(body), [100, 0], 0);
    world.removeRigidBody(body);
    near(runner.getPosition(body), [100, 0], 0);
  });
});

it('a Recorder is stepped in place of its world', () => {
  const world = weightless();
  const body = plainBody();
  add(world, body);
  const recorder = Recorder.create(world);
  const runner = FixedStepRunner.create({ world: recorder });
  expect(runner.world).toBe(world);
  const push = () => void recorder.call(body, 'applyImpulse', [1, 0]);
  for (let i = 0; i < 20; i += 1) runner.advance(1 / 50, push);
  expect(recorder.recording.frames).toHaveLength(world.timeStamp);
  const end = body.getPosition();
  expect(end[0]).toBeGreaterThan(1);
  expect(replay(world, recorder.recording)).toBe(-1);
  expect(body.getPosition()).toEqual(end);
});

describe('refusals', () => {
  const world = weightless();

  it('of create', () => {
    const where = 'FixedStepRunner.create';
    refuses((params) => FixedStepRunner.create(params), where, 'params', [undefined, TypeError]);
    refuses((value) => FixedStepRunner.create({ world: value }), where, 'world', [null, TypeError]);
    refuses((value) => FixedStepRunner.create({ world: value }), where, 'world', [{}, TypeError, 'an object']);
    const like = { step: () => {} };
    refuses((value) => FixedStepRunner.create({ world: value }), where, 'world', [like, TypeError, 'an object']);
    for (const bad of NOT_POSITIVE) {
      refuses((deltaTime) => FixedStepRunner.create({ world, deltaTime }), where, 'deltaTime', bad);
    }
    for (const bad of NOT_COUNT) {
      refuses((maxSteps) => FixedStepRunner.create({ world, maxSteps }), where, 'maxSteps', bad);
    }
  });

  it('of advance, before anything happens', () => {
    const runner = FixedStepRunner.create({ world });
    for (const bad of NOT_NON_NEGATIVE) {
      refuses((elapsed) => runner.advance(elapsed), 'FixedStepRunner.advance', 'elapsed', bad);
    }
    refuses((beforeStep) => runner.advance(1, beforeStep), 'FixedStepRunner.advance', 'beforeStep', [null, TypeError]);
    expect(world.timeStamp).toBe(0);
    expect(runner.interpolation).toBe(0);
  });

  it('of advance in a handler: its time does not pass later', () => {
    const stepped = weightless();
    const runner = FixedStepRunner.create({ world: stepped, deltaTime: 0.25 });
    let refusal: unknown;
    const nested = () => {
      stepped.poses = null;
      try {
        runner.advance(0.875);
      } catch (error) {
        refusal = error;
      }
    };
    stepped.poses = { update: nested };
    expect([runner.advance(0.625), stepped.timeStamp, runner.interpolation]).toEqual([2, 2, 0.5]);
    expect(String(refusal)).toBe(
      'Error: FixedStepRunner.advance: must not be called from a handler or callback of the same world',
    );
    expect([runner.advance(0), stepped.timeStamp]).toEqual([0, 2]);
  });

  it('of advance in beforeStep', () => {
    const stepped = weightless();
    const runner = FixedStepRunner.create({ world: stepped, deltaTime: 0.25 });
    const refusals: unknown[] = [];
    const nested = () => {
      try {
        runner.advance(0.5);
      } catch (error) {
        refusals.push(error);
      }
    };
    expect([runner.advance(0.5, nested), stepped.timeStamp]).toEqual([2, 2]);
    expect(refusals.map(String)).toEqual(
      Array(2).fill('Error: FixedStepRunner.advance: must not be called from beforeStep'),
    );
    expect([runner.advance(0.25), stepped.timeStamp]).toEqual([1, 3]);
  });

  it('of what is no body', () => {
    const runner = FixedStepRunner.create({ world });
    refuses((body) => runner.getPosition(body), 'FixedStepRunner.getPosition', 'body', [{}, TypeError, 'an object']);
    refuses((body) => runner.getRotation(body), 'FixedStepRunner.getRotation', 'body', [undefined, TypeError]);
  });
});
