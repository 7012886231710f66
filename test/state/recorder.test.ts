import { describe, expect, it, vi } from 'vitest';
import { phys2D, type RigidBody, type Shape, type World } from '../../src/index.js';
import { POSE_STRIDE, PoseBuffer, Recorder, replay } from '../../src/state/index.js';
import { NOT_COUNT, refuses } from '../bad-input/refuses.js';
import { buildPyramid } from '../scenes/pyramid.js';

function scene(): { world: World; ball: RigidBody } {
  const world = phys2D.createWorld();
  buildPyramid(phys2D, world, 5);
  const ball = phys2D.createRigidBody({ position: [-8, -2], shapes: [phys2D.createCircleShape({ radius: 0.5 })] });
  return { world, ball };
}

function record(world: World, ball: RigidBody): Recorder {
  const recorder = Recorder.create(world);
  for (let i = 0; i < 100; i += 1) {
    if (i === 10) {
      expect(recorder.call(world, 'addRigidBody', ball)).toBe(true);
      recorder.call(ball, 'setVelocity', [12, 0]);
    }
    if (i === 60) {
      recorder.call(ball, 'applyImpulse', [0, -3], ball.getPosition());
      recorder.call(ball.shapes[0]!, 'scale', 1.2);
    }
    recorder.step(1 / 60);
  }
  return recorder;
}

describe('a recording', () => {
  it('is replayed to the bit', () => {
    const { world, ball } = scene();
    const { recording } = record(world, ball);
    const end = world.hash();
    world.step(1 / 30);
    expect(replay(world, recording)).toBe(-1);
    expect(world.hash()).toBe(end);
    expect(recording.frames).toHaveLength(100);
  });

  it('keeps what typed arrays and arrays in arrays had when they were given', () => {
    const { world, ball } = scene();
    world.addRigidBody(ball);
    const box = phys2D.createPolygonShape({ vertices: phys2D.createBoxVertices(1, 1) });
    world.addRigidBody(phys2D.createRigidBody({ position: [-12, -2], shapes: [box] }));
    const recorder = Recorder.create(world);
    const wind = new Float32Array(2);
    const vertices = phys2D.createBoxVertices(1, 1);
    for (let i = 0; i < 30; i += 1) {
      wind[0] = i % 7;
      vertices[2]![0] = 0.5 + 0.01 * i;
      recorder.call(ball, 'setForce', wind);
      recorder.call(box, 'setVertices', vertices);
      recorder.step(1 / 60);
    }
    expect(replay(world, recorder.recording)).toBe(-1);
  });

  it('keeps what options had when they were given', () => {
    const { world, ball } = scene();
    world.addRigidBody(ball);
    const other = phys2D.createRigidBody({ position: [-10, -2] });
    world.addRigidBody(other);
    const rod = phys2D.createDistanceConstraint({ bodyA: ball, bodyB: other, lowerBound: 1, upperBound: 1 });
    world.addConstraint(rod);
    const recorder = Recorder.create(world);
    const options = { stiff: false, frequency: 1 };
    for (let i = 0; i < 10; i += 1) {
      options.frequency = 1 + i;
      recorder.call(rod, 'configure', options);
      recorder.step(1 / 60);
    }
    expect(replay(world, recorder.recording)).toBe(-1);
  });

  it('has the properties that were set', () => {
    const { world, ball } = scene();
    world.addRigidBody(ball);
    const recorder = Recorder.create(world);
    recorder.step(1 / 60);
    recorder.set(ball, 'bullet', true);
    recorder.set(world, 'substeps', 2);
    recorder.set(world, 'velocityIterations', 3);
    recorder.set(world, 'positionIterations', 5);
    recorder.set(world, 'allowSleeping', false);
    recorder.step(1 / 60);
    expect([ball.bullet, world.substeps, world.allowSleeping]).toEqual([true, 2, false]);
    expect(replay(world, recorder.recording)).toBe(-1);
    expect([ball.bullet, world.substeps, world.allowSleeping]).toEqual([true, 2, false]);
  });

  it('has no other property', () => {
    const { world, ball } = scene();
    const recorder = Recorder.create(world);
    const set = (object: World | RigidBody, setting: string, value: unknown) => () =>
      recorder.set(object, setting as 'substeps', value as number);
    for (const name of ['substep', 'step', '__proto__', 'gravityX', 'userData', 'timeStamp']) {
      expect(set(world, name, 2)).toThrow('Recorder.set: setting must be one of substeps, ');
    }
    expect(set(ball, 'substeps', 2)).toThrow('Recorder.set: object must be something that has substeps');
    expect(set(world, 'substeps', 0)).toThrow('Recorder.set: value must be an integer from 1 to 1e9, got 0');
    expect(set(world, 'substeps', 2 ** 30)).toThrow('Recorder.set: value must be an integer from 1 to 1e9');
    expect(set(ball, 'bullet', 1)).toThrow('Recorder.set: value must be a boolean, got 1');
    recorder.step(1 / 60);
    expect(recorder.recording.frames[0]!.calls).toEqual([]);
  });

  it('has the step in which a handler threw', () => {
    const { world, ball } = scene();
    world.addRigidBody(ball);
    const recorder = Recorder.create(world);
    let left = 1;
    ball.shapes[0]!.addEventListener('begin', () => {
      left -= 1;
      if (left >= 0) {
        throw new Error('in a handler');
      }
    });
    let thrown = 0;
    for (let i = 0; i < 100; i += 1) {
      recorder.call(ball, 'applyImpulse', [0.1, 0]);
      try {
        recorder.step(1 / 60);
      } catch {
        thrown += 1;
      }
    }
    expect(() => recorder.step(-1)).toThrow(RangeError);
    expect(thrown).toBe(1);
    expect(recorder.recording.frames).toHaveLength(100);
    left = 1;
    expect(replay(world, recorder.recording)).toBe(-1);
    expect(left).toBeLessThan(1);
  });

  it('has no listeners: those that are there when it is replayed would be heard from its beginning on', () => {
    const { world, ball } = scene();
    world.addRigidBody(ball);
    const recorder = Recorder.create(world);
    const [shape] = ball.shapes as [Shape];
    const handler = () => ball.applyImpulse([0.1, 0]);
    for (const call of [
      () => recorder.call(shape, 'addEventListener', 'progress', handler),
      () => recorder.call(shape, 'removeEventListener', 'progress', handler),
      () => recorder.call(ball, 'addEventListener', 'wake', handler),
      () => recorder.call(world, 'addEventListener', 'nonfinite', handler),
    ]) {
      expect(call).toThrow(
        /^Recorder.call: (?:add|remove)EventListener is not to be called so: .* listeners cannot be/,
      );
    }
    expect(shape.addEventListener('progress', handler)).toBe(true);
    recorder.step(1 / 60);
    expect(recorder.recording.frames[0]!.calls).toEqual([]);
  });

  it('has nothing of what handlers do, though they do it through the recorder', () => {
    const { world, ball } = scene();
    world.addRigidBody(ball);
    const recorder = Recorder.create(world);
    let heard = 0;
    ball.shapes[0]!.addEventListener('progress', () => {
      heard += 1;
      recorder.call(ball, 'applyImpulse', [0.1, 0]);
      recorder.set(ball, 'bullet', heard % 2 === 0);
    });
    for (let i = 0; i < 100; i += 1) {
      recorder.step(1 / 60);
    }
    expect(heard).toBeGreaterThan(1);
    expect(recorder.recording.frames.flatMap(({ calls }) => calls)).toEqual([]);
    heard = 0;
    expect(replay(world, recorder.recording)).toBe(-1);
  });

  it('goes on after a replay, in which handlers did what they do through the recorder', () => {
    const { world, ball } = scene();
    world.addRigidBody(ball);
    const recorder = Recorder.create(world);
    ball.shapes[0]!.addEventListener('progress', () => {
      recorder.call(ball, 'applyImpulse', [0.1, 0]);
      recorder.set(ball, 'bullet', !ball.bullet);
    });
    for (let i = 0; i < 100; i += 1) {
      recorder.step(1 / 60);
    }
    expect(replay(world, recorder.recording)).toBe(-1);
    for (let i = 0; i < 5; i += 1) {
      recorder.step(1 / 60);
    }
    expect(recorder.recording.frames.flatMap(({ calls }) => calls)).toEqual([]);
    expect(replay(world, recorder.recording)).toBe(-1);
  });

  it('has nothing of what handlers do after a step of the recorder that was refused there', () => {
    const { world, ball } = scene();
    world.addRigidBody(ball);
    const recorder = Recorder.create(world);
    let refused = 0;
    ball.shapes[0]!.addEventListener('begin', () => {
      try {
        recorder.step(1 / 60);
      } catch {
        refused += 1;
      }
      recorder.call(ball, 'applyImpulse', [0.1, 0]);
    });
    for (let i = 0; i < 100; i += 1) {
      recorder.step(1 / 60);
    }
    expect(refused).toBeGreaterThan(0);
    expect(recorder.recording.frames).toHaveLength(100);
    expect(recorder.recording.frames.flatMap(({ calls }) => calls)).toEqual([]);
    expect(replay(world, recorder.recording)).toBe(-1);
  });

  it('goes on where handlers add something through the recorder, and has nothing of it', () => {
    const { world, ball } = scene();
    world.addRigidBody(ball);
    const recorder = Recorder.create(world);
    const [shape] = ball.shapes as [Shape];
    const added: unknown[] = [];
    shape.addEventListener('begin', () => {
      const other = phys2D.createRigidBody({ position: [-8, -6], shapes: [phys2D.createCircleShape({ radius: 0.2 })] });
      const rod = phys2D.createPointConstraint({ bodyA: ball, bodyB: other, anchorB: [0, 2], stiff: false });
      added.push(recorder.call(world, 'addRigidBody', other));
      added.push(recorder.call(other, 'addShape', phys2D.createCircleShape({ radius: 0.3, origin: [0.3, 0] })));
      added.push(recorder.call(world, 'addConstraint', rod));
    });
    for (let i = 0; i < 100; i += 1) {
      recorder.step(1 / 60);
    }
    expect(added.slice(0, 3)).toEqual([true, true, true]);
    expect(recorder.recording.frames.flatMap(({ calls }) => calls)).toEqual([]);
    expect(replay(world, recorder.recording)).toBe(-1);
  });

  it('has one snapshot for a frame, however much is added in it, and is replayed whatever became of that', () => {
    const { world, ball } = scene();
    world.addRigidBody(ball);
    const snapshot = vi.spyOn(world, 'snapshot');
    const recorder = Recorder.create(world);
    const added: RigidBody[] = [];
    for (let i = 0; i < 60; i += 1) {
      recorder.call(ball, 'applyImpulse', [0.1, 0]);
      for (let k = 0; k < 10 && i % 20 === 0; k += 1) {
        const body = phys2D.createRigidBody({ position: [k - 4, -8], sleeping: k % 2 === 0 });
        recorder.call(body, 'addShape', phys2D.createCircleShape({ radius: 0.3 }));
        added.push(body);
        recorder.call(world, 'addRigidBody', body);
        recorder.call(body, 'applyImpulse', [0, 1]);
      }
      recorder.step(1 / 60);
    }
    expect(snapshot).toHaveBeenCalledTimes(4);
    const { recording } = recorder;
    expect(recording.frames.flatMap((frame, i) => (frame.added === null ? [] : i))).toEqual([0, 20, 40]);
    const end = world.hash();
    world.removeRigidBody(added[0]!);
    added[0]!.removeShape(added[0]!.shapes[0]!);
    added[1]!.setPosition([0, -20]);
    expect(replay(world, recording)).toBe(-1);
    expect(world.hash()).toBe(end);
    const frames = [...recording.frames];
    const [push, ...others] = frames[20]!.calls;
    frames[20] = { ...frames[20]!, calls: [{ ...push!, args: [[0.2, 0]] }, ...others] };
    expect(replay(world, { ...recording, frames })).toBe(20);
  });

  it.each([
    [
      'setMaterial',
      (recorder: Recorder, { shapes }: RigidBody) =>
        recorder.call(shapes[0]!, 'setMaterial', phys2D.createMaterial({ density: 3 })),
    ],
    ['removeShape', (recorder: Recorder, anchor: RigidBody) => recorder.call(anchor, 'removeShape', anchor.shapes[0]!)],
  ] as const)('has what %s did to a body that is in no world', (_, act) => {
    const world = phys2D.createWorld();
    const disc = () => phys2D.createCircleShape({ radius: 0.5 });
    const anchor = phys2D.createRigidBody({ type: 'static', position: [0, -4], shapes: [disc()] });
    const load = phys2D.createRigidBody({ position: [0, -2], shapes: [disc()] });
    world.addRigidBody(load);
    world.addConstraint(phys2D.createDistanceConstraint({ bodyA: anchor, bodyB: load, upperBound: 2.2 }));
    const recorder = Recorder.create(world);
    for (let i = 0; i < 10; i += 1) {
      if (i === 5) act(recorder, anchor);
      recorder.step(1 / 60);
    }
    expect(replay(world, recorder.recording)).toBe(-1);
  });

  it('tells the first step that went another way', () => {
    const { world, ball } = scene();
    const { recording } = record(world, ball);
    const frames = recording.frames.map((frame, i) => (i === 60 ? { ...frame, calls: frame.calls.slice(1) } : frame));
    expect(replay(world, { ...recording, frames })).toBe(60);
  });

  it('refuses what it cannot repeat', () => {
    const { world } = scene();
    const recorder = Recorder.create(world);
    expect(() => recorder.call(world, 'restore', world.snapshot())).toThrow(
      'Recorder.call: restore is not to be called',
    );
    expect(() => recorder.call(world, 'timeStamp' as 'hash')).toThrow(
      'Recorder.call: method must be the name of a method of object, got "timeStamp"',
    );
    expect(() => Recorder.create({} as World)).toThrow('Recorder.create: world must be a World');
    expect(() => replay(null as never, recorder.recording)).toThrow('replay: world must be a World');
  });
});

describe('a pose buffer', () => {
  it('is up to date after each step, and before events', () => {
    const { world, ball } = scene();
    world.addRigidBody(ball);
    const memory = new SharedArrayBuffer(8 * POSE_STRIDE * 100);
    const poses = PoseBuffer.create({ capacity: 100, poses: new Float64Array(memory) });
    const index = poses.track(ball);
    for (const body of world.rigidBodies) {
      poses.track(body);
    }
    expect(poses.track(ball)).toBe(index);
    expect(poses.indexOf(ball)).toBe(index);
    world.poses = poses;
    const reader = new Float64Array(memory);
    let heard = 0;
    ball.shapes[0]!.addEventListener('begin', () => {
      heard += 1;
      expect(reader[POSE_STRIDE * index + 1]).toBe(ball.getPosition()[1]);
    });
    for (let i = 0; i < 60; i += 1) {
      world.step(1 / 60);
    }
    expect(heard).toBeGreaterThan(0);
    for (const body of world.rigidBodies) {
      const at = POSE_STRIDE * poses.indexOf(body);
      expect([...reader.subarray(at, at + 2)]).toEqual(body.getPosition());
      expect(Math.atan2(reader[at + 3]!, reader[at + 2]!)).toBeCloseTo(
        Math.atan2(Math.sin(body.getRotation()), Math.cos(body.getRotation())),
        12,
      );
    }
  });

  it('uses a free place again, and is refused when full', () => {
    const poses = PoseBuffer.create({ capacity: 2 });
    const [a, b, c] = [0, 1, 2].map((x) => phys2D.createRigidBody({ position: [x, 5] })) as [
      RigidBody,
      RigidBody,
      RigidBody,
    ];
    expect([poses.track(a), poses.track(b)]).toEqual([0, 1]);
    expect(() => poses.track(c)).toThrow('PoseBuffer.track: there is room for 2 bodies');
    expect(poses.untrack(a)).toBe(true);
    expect(poses.untrack(a)).toBe(false);
    expect([...poses.poses.subarray(0, 5)]).toEqual([0, 0, 0, 0, 1]);
    expect(poses.track(c)).toBe(0);
    expect([...poses.poses]).toEqual([2, 5, 1, 0, 1, 5, 1, 0]);
    for (const bad of NOT_COUNT) {
      refuses((capacity) => PoseBuffer.create({ capacity }), 'PoseBuffer.create', 'capacity', bad);
    }
    expect(() => PoseBuffer.create({ capacity: 3, poses: new Float32Array(8) })).toThrow(
      'PoseBuffer.create: poses must be a float array of 12 numbers',
    );
    expect(PoseBuffer.create({ poses: new Float32Array(8) }).capacity).toBe(2);
    expect(PoseBuffer.create().capacity).toBe(1024);
  });

  it('that is one of yours may throw: the events of the step are told all the same, in their order', () => {
    const run = (throws: boolean): string[] => {
      const { world, ball } = scene();
      world.addRigidBody(ball);
      const told: string[] = [];
      const [shape] = ball.shapes as [Shape];
      for (const type of ['begin', 'progress', 'end'] as const) {
        shape.addEventListener(type, (_arbiter, other) => void told.push(`${world.timeStamp} ${type} ${other.type}`));
      }
      shape.addEventListener('hit', (_arbiter, other) => void told.push(`${world.timeStamp} hit ${other.type}`));
      world.poses = {
        update() {
          if (throws) {
            throw new Error(`no room in step ${world.timeStamp}`);
          }
        },
      };
      for (let i = 1; i <= 60; i += 1) {
        if (throws) {
          expect(() => world.step(1 / 60)).toThrow(`no room in step ${i}`);
        } else {
          world.step(1 / 60);
        }
      }
      return told;
    };
    const told = run(true);
    expect(told.length).toBeGreaterThan(3);
    expect(told).toEqual(run(false));
  });

  it('that is one of yours is called as a handler is: it cannot step the world, nor save it', () => {
    const { world } = scene();
    for (const call of [() => world.step(1 / 60), () => world.hash(), () => world.snapshot()]) {
      world.poses = { update: call };
      expect(() => world.step(1 / 60)).toThrow('must not be called from a handler or callback of the same world');
    }
    expect(world.timeStamp).toBe(3);
    world.poses = null;
    world.step(1 / 60);
    expect(world.timeStamp).toBe(4);
  });
});

describe('replay refuses, before anything is done,', () => {
  function refused(frame: unknown, message: string): void {
    const world = phys2D.createWorld();
    world.addRigidBody(phys2D.createRigidBody());
    const { snapshot, recording } = Recorder.create(world);
    expect(recording.frames).toEqual([]);
    world.step(1 / 60);
    const before = world.hash();
    const given = typeof frame === 'function' ? frame(world) : frame;
    expect(() => replay(world, { snapshot, frames: [given] })).toThrow(message);
    expect(world.hash()).toBe(before);
  }
  const good = { calls: [], added: null, deltaTime: 1 / 60, hash: '' };

  it('frames that are none', () => {
    const calls = [{}];
    for (const bad of [
      undefined,
      {},
      { ...good, calls },
      { ...good, calls: [null] },
      { ...good, added: {} },
      { ...good, hash: 5 },
      5,
    ]) {
      refused(bad, 'replay: recording.frames[0] must be a frame of a Recorder, got');
    }
  });

  it('frames without a time', () => {
    for (const deltaTime of ['x', undefined, NaN, 0]) {
      refused({ ...good, deltaTime }, 'replay: recording.frames[0].deltaTime must be a finite number > 0, got');
    }
  });

  it('calls that cannot be made', () => {
    const calling = (method: string, ...args: unknown[]) => {
      return (object: World) => ({ ...good, calls: [{ object, method, args }] });
    };
    refused(calling('explode'), 'replay: method must be the name of a method of object, got "explode"');
    refused(calling('step', 1), 'replay: step is not to be called so');
    refused(calling('bullet', true), 'replay: object must be something that has bullet');
    refused(calling('substeps', 0), 'replay: value must be an integer from 1 to 1e9, got 0');
  });
});

it('a Recorder refuses methods whose names are no strings', () => {
  const world = phys2D.createWorld();
  const recorder = Recorder.create(world);
  for (const bad of [Object.create(null), 5, null, undefined]) {
    expect(() => recorder.call(world, bad as never)).toThrow(
      'Recorder.call: method must be the name of a method of object',
    );
  }
});
