import { describe, expect, it } from 'vitest';
import { phys2D, type RigidBody, type RigidBodyParams, type World } from '../../src/index.js';
import { add, addFloor, box, boxBody, DT, heavy, near, plainBody, steps, weightless } from '../conformance/setting.js';

// Forces that act in the next step, and no longer.

const pose = (body: RigidBody) => [
  ...body.getPosition(),
  body.getRotation(),
  ...body.getVelocity(),
  body.getAngularVelocity(),
];

/** A board that is held up by thrust amid its length, and what lies on it. */
function hover(thrust: (board: RigidBody, force: number) => void): {
  board: RigidBody;
  load: RigidBody[];
  run(): void;
} {
  const world = heavy();
  const free = { linearDrag: 0, angularDrag: 0 };
  const board = boxBody(4, 0.2, { mass: 8, ...free });
  const load = [-1.2, 0, 1.2].map((x) => boxBody(0.5, 0.5, { position: [x, -0.35], mass: 1, ...free }));
  add(world, board, ...load);
  return {
    board,
    load,
    run() {
      thrust(board, -110);
      world.step(DT);
    },
  };
}

/** m. The longest way of what rests within `count` steps. */
function farthest(load: readonly RigidBody[], run: () => void, count: number): number {
  const from = load.map((body) => body.getPosition());
  let way = 0;
  for (let i = 0; i < count; i += 1) {
    run();
    load.forEach((body, k) => {
      const [x, y] = body.getPosition();
      way = Math.max(way, Math.hypot(x - from[k]![0], y - from[k]![1]));
    });
  }
  return way;
}

describe('a force for one step', () => {
  it('acts as one that lasts, which is taken off after the step, to the bit', () => {
    const bodies = [0, 1].map(() => plainBody({ velocity: [1, 2], angularVelocity: 0.5 }));
    const [one, two] = bodies as [RigidBody, RigidBody];
    const worlds = bodies.map((body) => {
      const world = heavy();
      add(world, body);
      return world;
    });
    for (let i = 0; i < 30; i += 1) {
      const [x, y] = two.getPosition();
      one.setForce([3, i - 20]);
      one.setTorque((x + 0.3 - x) * (i - 20) - (y - 0.2 - y) * 3);
      two.applyForce([3, i - 20], [x + 0.3, y - 0.2]);
      worlds[0]!.step(DT);
      one.setForce([0, 0]);
      one.setTorque(0);
      worlds[1]!.step(DT);
      expect(pose(two)).toEqual(pose(one));
      worlds.forEach((world) => void world.step(DT));
      expect(pose(two)).toEqual(pose(one));
    }
  });

  it('adds to those that are there, and to what lasts, and is not told as that', () => {
    const world = weightless();
    const body = plainBody();
    add(world, body);
    body.setForce([60, 0]);
    body.applyForce([60, 0]);
    body.applyForce([0, 120], [0.5, 0]);
    body.applyTorque(-30);
    expect(body.getForce()).toEqual([60, 0]);
    expect(body.getTorque()).toBe(0);
    expect(body.getVelocity()).toEqual([0, 0]);
    world.step(DT);
    expect(body.getVelocity()[0]).toBeCloseTo(2, 12);
    expect(body.getVelocity()[1]).toBeCloseTo(2, 12);
    expect(body.getAngularVelocity()).toBeCloseTo(0.5, 12);
    world.step(DT);
    expect(body.getVelocity()[0]).toBeCloseTo(3, 12);
    expect(body.getAngularVelocity()).toBeCloseTo(0.5, 12);
  });

  it('leaves in peace what lies on the body, which impulses shake', () => {
    const byForce = hover((board, force) => board.applyForce([0, force], board.getPosition()));
    const byImpulse = hover((board, force) => board.applyImpulse([0, force * DT], board.getPosition()));
    expect(farthest([byForce.board, ...byForce.load], byForce.run, 300)).toBeLessThan(0.0005);
    expect(farthest(byImpulse.load, byImpulse.run, 300)).toBeGreaterThan(0.002);
  });

  it('may bring a body far at once: it meets what is there as with a force that lasts, to the bit', () => {
    for (const force of [3e2, 3e3, 3e4, 3e5, 3e6]) {
      const [one, two] = [false, true].map((isApplied) => {
        const world = heavy();
        addFloor(world);
        const wall = phys2D.createRigidBody({ type: 'static', shapes: [box(0.01, 4)], position: [2, 0] });
        const body = plainBody();
        add(world, wall, body);
        if (isApplied) {
          body.applyForce([force, force / 10], [0, 0.1]);
        } else {
          body.setForce([force, force / 10]);
          body.setTorque(-0.1 * force);
        }
        const poses = [];
        for (let i = 0; i < 10; i += 1) {
          world.step(DT);
          body.setForce([0, 0]);
          body.setTorque(0);
          poses.push(pose(body));
          expect(body.getPosition()[0]).toBeLessThan(1.51);
        }
        return poses;
      });
      expect(two, `${force} N`).toEqual(one);
    }
  });

  it('does nothing to what is static or kinematic, and goes with falling asleep, leaving and changes of type', () => {
    for (const stop of [
      (body: RigidBody) => {
        body.sleep();
        body.wake();
      },
      (body: RigidBody, world: World) => {
        world.removeRigidBody(body);
        world.addRigidBody(body);
      },
      (body: RigidBody, world: World) => {
        world.clear();
        world.addRigidBody(body);
      },
      (body: RigidBody) => {
        body.setAsKinematic();
        body.setAsDynamic();
      },
      (body: RigidBody) => {
        body.setAsKinematic();
        body.applyForce([60, 0]);
        body.setAsDynamic();
      },
    ]) {
      const world = weightless();
      const body = plainBody();
      add(world, body);
      body.applyForce([60, 0]);
      stop(body, world);
      world.step(DT);
      expect(body.getVelocity()).toEqual([0, 0]);
    }
    for (const stop of [
      (body: RigidBody) => {
        body.sleep();
      },
      (body: RigidBody) => {
        body.setAsStatic();
        body.setAsDynamic();
      },
    ]) {
      const world = weightless();
      const body = plainBody();
      body.applyForce([60, 0]);
      stop(body);
      add(world, body);
      steps(world, 3);
      body.wake();
      world.step(DT);
      expect(body.getVelocity()).toEqual([0, 0]);
    }
    const outside = plainBody();
    outside.applyForce([60, 0]);
    const world = weightless();
    add(world, outside);
    world.step(DT);
    expect(outside.getVelocity()[0]).toBeCloseTo(1, 12);
  });

  it('is refused with a clear error where sums overflow, and nothing changes', () => {
    const world = weightless();
    const body = plainBody();
    add(world, body);
    body.applyForce([6e149, 0]);
    expect(() => body.applyForce([6e149, 0])).toThrow('RigidBody.applyForce: force must be');
    expect(() => body.applyForce([1e100, 0], [0, 1e100])).toThrow('RigidBody.applyForce: force must be');
    expect(() => body.applyForce([1, 0], [NaN, 0])).toThrow('RigidBody.applyForce: position[0] must be');
    expect(() => body.applyTorque(1e151)).toThrow('RigidBody.applyTorque: torque must be');
    body.applyForce([-6e149, 0]);
    world.step(DT);
    expect(pose(body)).toEqual([0, 0, 0, 0, 0, 0]);
  });
});

describe('sleep', () => {
  it('comes where what pushes hardly changes, ends with a push, and loses none', () => {
    const world = heavy();
    const crate = boxBody(1, 1, { mass: 1 });
    addFloor(world);
    add(world, crate);
    const events: string[] = [];
    crate.addEventListener('sleep', () => void events.push('sleep'));
    crate.addEventListener('wake', () => void events.push('wake'));
    for (let i = 0; i < 300; i += 1) {
      crate.applyForce([1 + 0.001 * (i % 2), 0]);
      world.step(DT);
    }
    expect(crate.sleeping).toBe(true);
    expect(events).toEqual(['sleep']);
    crate.applyForce([1, -600]);
    world.step(DT);
    expect(events).toEqual(['sleep', 'wake']);
    expect(crate.getVelocity()[1]).toBeLessThan(-9);
  });

  it.each([
    ['grows bit by bit', (i: number) => 0.05 * i],
    ['comes all at once', () => 12],
    ['changes sides', (i: number) => (i < 90 ? 9 : -12)],
  ])('ends for what slides once what pushes it %s', (_, forceOf) => {
    const world = heavy();
    const material = phys2D.createMaterial({ staticFriction: 1, dynamicFriction: 0.5 });
    const crate = boxBody(1, 1, { mass: 1 }, { material });
    addFloor(world, {}, { material });
    add(world, crate);
    let slept = 0;
    for (let i = 0; i < 300; i += 1) {
      crate.applyForce([forceOf(i), 0]);
      world.step(DT);
      slept += crate.sleeping ? 1 : 0;
    }
    expect(Math.abs(crate.getPosition()[0])).toBeGreaterThan(1);
    expect(slept > 0).toBe(forceOf(0) < 10);
  });

  it('ends where what pushed is not there any more, but not where only what is awake is pushed', () => {
    for (const [isAsked, falls] of [
      [false, true],
      [true, false],
    ]) {
      const world = heavy();
      const body = plainBody();
      add(world, body);
      for (let i = 0; i < 100; i += 1) {
        if (!(isAsked && body.sleeping)) body.applyForce([0, -10]);
        world.step(DT);
      }
      expect(body.sleeping).toBe(true);
      expect(body.getPosition()[1]).toBeCloseTo(0, 9);
      steps(world, 30);
      expect(body.getPosition()[1] > 1, `asked: ${isAsked}`).toBe(falls);
    }
  });

  it('begins for what weak forces push anew', () => {
    const world = weightless();
    const body = plainBody();
    add(world, body);
    steps(world, 100);
    expect(body.sleeping).toBe(true);
    body.applyForce([0.01, 0]);
    world.step(DT);
    expect(body.getVelocity()[0]).toBeCloseTo(0.01 / 60, 9);
  });

  it('that something else ends has all of the force in that step', () => {
    const world = heavy();
    const body = plainBody();
    add(world, body);
    for (let i = 0; i < 100; i += 1) {
      body.applyForce([0, -10]);
      world.step(DT);
    }
    expect(body.sleeping).toBe(true);
    const striker = plainBody({ position: [-0.999, 0], velocity: [3, 0] });
    add(world, striker);
    striker.applyForce([0, -10]);
    body.applyForce([0, -10]);
    world.step(DT);
    expect(body.sleeping).toBe(false);
    expect(body.getVelocity()[0]).toBeGreaterThan(1);
    expect(body.getVelocity()[1]).toBeCloseTo(0, 9);
  });

  it('waits for a force that comes in the very step in which the body would have fallen asleep', () => {
    const fallen = (() => {
      const world = heavy();
      const crate = boxBody(1, 1, { mass: 1 });
      addFloor(world);
      add(world, crate);
      let count = 0;
      for (; !crate.sleeping; count += 1) world.step(DT);
      return count;
    })();
    for (let wait = fallen - 3; wait < fallen + 2; wait += 1) {
      const world = heavy();
      const crate = boxBody(1, 1, { mass: 1 });
      addFloor(world);
      add(world, crate);
      steps(world, wait);
      crate.applyForce([0, -600]);
      world.step(DT);
      expect(crate.getVelocity()[1], `after ${wait} steps`).toBeLessThan(-9);
    }
  });

  it('waits for a force on what has no inertia, as a particle, and for a torque', () => {
    const push = (params: RigidBodyParams, wait: number, act: (body: RigidBody) => void) => {
      const world = weightless();
      const body = phys2D.createRigidBody({ linearDrag: 0, angularDrag: 0, mass: 1, ...params });
      add(world, body);
      steps(world, wait);
      act(body);
      world.step(DT);
      return body;
    };
    for (let wait = 58; wait < 65; wait += 1) {
      const particle = push({}, wait, (body) => body.applyForce([60, 0]));
      expect(particle.getVelocity()[0], `after ${wait} steps`).toBeCloseTo(1, 12);
      const wheel = push({ inertia: 1, shapes: [box(1, 1)] }, wait, (body) => body.applyTorque(60));
      expect(wheel.getAngularVelocity(), `after ${wait} steps`).toBeCloseTo(1, 12);
    }
    expect(push({}, 70, () => {}).sleeping).toBe(true);
  });

  it('comes to what floats', () => {
    const world = heavy();
    const crate = boxBody(1, 1, { mass: 0.5, position: [0, -1] });
    add(world, crate);
    let count = 0;
    for (; count < 1200 && !crate.sleeping; count += 1) {
      const depth = Math.min(1, Math.max(0, crate.getPosition()[1] + 0.5));
      const [vx, vy] = crate.getVelocity();
      crate.applyForce([-2 * vx * depth, (-2 * vy - 10) * depth]);
      world.step(DT);
    }
    expect(count).toBeLessThan(900);
    expect(crate.getPosition()[1]).toBeCloseTo(0, 2);
  });
});

describe('what is to push in the next step', () => {
  function pushed(): { world: World; body: RigidBody } {
    const world = heavy();
    const body = plainBody();
    addFloor(world);
    add(world, body);
    steps(world, 20);
    body.applyForce([2, 0]);
    world.step(DT);
    body.applyForce([3, -70], [0.1, 0.2]);
    body.applyTorque(4);
    return { world, body };
  }

  it('is in snapshots and in the hash', () => {
    const { world, body } = pushed();
    const { world: other, body: without } = pushed();
    without.applyTorque(-1);
    expect(other.hash()).not.toBe(world.hash());
    const snapshot = world.snapshot();
    const hash = world.hash();
    steps(world, 5);
    const after = pose(body);
    world.restore(snapshot);
    expect(world.hash()).toBe(hash);
    steps(world, 5);
    expect(pose(body)).toEqual(after);
    expect(world.hash()).not.toBe(hash);
  });

  it('is known of what sleeps after a restore, in this world or a copy', () => {
    const world = heavy();
    const body = plainBody();
    add(world, body);
    for (let i = 0; i < 100; i += 1) {
      body.applyForce([0, -10]);
      world.step(DT);
    }
    expect(body.sleeping).toBe(true);
    for (const force of [-10, -11, 0]) {
      for (const isLate of [false, true]) {
        if (!isLate && force < 0) body.applyForce([0, force]);
        const snapshot = world.snapshot();
        const hash = world.hash();
        const run = () => {
          if (isLate && force < 0) body.applyForce([0, force]);
          world.step(DT);
          body.applyForce([0, force]);
          world.step(DT);
          return world.hash();
        };
        const after = run();
        steps(world, 3);
        world.restore(snapshot);
        expect(world.hash()).toBe(hash);
        expect(run(), `${force} N`).toBe(after);
        expect(body.sleeping, `${force} N`).toBe(force === -10);
        world.restore(snapshot.slice(0));
        expect(run(), `${force} N, of a copy`).toBe(after);
        world.restore(snapshot);
        world.step(DT);
        world.restore(snapshot);
        if (!isLate && force < 0) world.step(DT);
      }
    }
  });

  it('is not there after a restore to where it was not', () => {
    const { world, body } = pushed();
    steps(world, 2);
    const [snapshot, hash] = [world.snapshot(), world.hash()];
    body.applyForce([100, 0]);
    world.restore(snapshot);
    expect(world.hash()).toBe(hash);
  });
});

describe('what else moves a body by hand', () => {
  it('an angular impulse turns it at once', () => {
    const body = plainBody({ inertia: 2 });
    body.applyAngularImpulse(3);
    expect(body.getAngularVelocity()).toBe(1.5);
    expect(() => body.applyAngularImpulse(1e151)).toThrow('RigidBody.applyAngularImpulse: impulse must be');
    body.setAsKinematic();
    body.applyAngularImpulse(3);
    expect(body.getAngularVelocity()).toBe(1.5);
  });

  it('the velocity at a point is that of the body there', () => {
    const body = plainBody({ position: [3, -0.5], velocity: [2, 0], angularVelocity: 4 });
    expect(body.getVelocityAtPoint([3, 0])).toEqual([0, 0]);
    expect(body.getVelocityAtPoint([3, -1])).toEqual([4, 0]);
    const out = new Float64Array(2);
    expect(body.getVelocityAtPoint([3.5, -0.5], out)).toBe(out);
    expect([...out]).toEqual([2, 2]);
  });
});

describe('a force for one step on what sleeps', () => {
  /** The upper one of two boxes on a floor, at rest, and the events of its world from then on. */
  function rest(allowSleeping: boolean): { world: World; upper: RigidBody; told: string[] } {
    const world = heavy({ allowSleeping });
    addFloor(world);
    const boxes = [0, 1].map((i) => boxBody(1, 1, { position: [0, -0.5 - i] }));
    add(world, ...boxes);
    steps(world, 300);
    const told: string[] = [];
    for (const type of ['begin', 'progress', 'end', 'hit'] as const) {
      world.addEventListener(type, () => told.push(type));
    }
    return { world, upper: boxes[1]!, told };
  }

  it.each([
    ['a force', (body: RigidBody) => body.applyForce([600, 0])],
    ['a torque', (body: RigidBody) => body.applyTorque(3)],
  ])('does what it would if that was awake: %s', (_, push) => {
    const [asleep, awake] = [rest(true), rest(false)];
    expect([asleep.upper.sleeping, awake.upper.sleeping]).toEqual([true, false]);
    for (const { world, upper, told } of [asleep, awake]) {
      push(upper);
      world.step(DT);
      // Their contacts go on. They began anew, with a hit, and lost the impulses of before.
      expect(told).toEqual(['progress', 'progress']);
      steps(world, 60);
    }
    near(pose(asleep.upper), pose(awake.upper), 1e-6);
  });
});
