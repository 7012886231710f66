import { describe, expect, it, vi } from 'vitest';
import { type Arbiter, type Hit, phys2D, type RigidBody, type Shape, type World } from '../../src/index.js';
import { add, arbiterOf, box, disc, near, plainBody, steps, weightless } from '../conformance/setting.js';

// What `hit` handlers are told.

interface Seen {
  readonly speed: number;
  readonly impulse: number;
  readonly position: number[];
  readonly normal: number[];
  readonly contacts: number;
}

function listen(shape: Shape, mask?: number, minimumSpeed?: number): Seen[] {
  const seen: Seen[] = [];
  shape.addEventListener(
    'hit',
    (arbiter, _, hit) => {
      seen.push({
        speed: hit.approachSpeed,
        impulse: hit.impulse,
        position: hit.getPosition(),
        normal: hit.getNormal(),
        contacts: arbiter.contacts.length,
      });
    },
    mask,
    minimumSpeed,
  );
  return seen;
}

/** A body that comes from the left, at 3 m/s, to one at the origin; their surfaces are apart by `gap`. */
function coming(gap: number, target: Parameters<typeof plainBody>[0] = {}) {
  const world = weightless();
  const moving = plainBody({ position: [-1 - gap, 0], velocity: [3, 0] });
  const still = plainBody(target);
  add(world, moving, still);
  return { world, moving, still, seen: listen(still.shapes[0]!) };
}

function until(world: World, done: () => boolean): void {
  for (let i = 0; i < 100 && !done(); i += 1) {
    steps(world, 1);
  }
  expect(done()).toBe(true);
}

describe('hit', () => {
  it('tells how fast, how hard and where, found at any moment of the step', () => {
    for (const gap of [-0.001, 0, 0.001, 0.01, 0.03, 0.06, 0.3]) {
      const { world, moving, still, seen } = coming(gap);
      const older = listen(moving.shapes[0]!);
      until(world, () => seen.length > 0);
      steps(world, 5);
      expect(seen).toHaveLength(1);
      near([seen[0]!.speed, seen[0]!.impulse], [3, 1.5]);
      near(seen[0]!.position, [-0.5, 0], 0.05);
      near(seen[0]!.normal, [1, 0]);
      expect(older).toEqual(seen);
      near(still.getVelocity(), [1.5, 0]);
    }
  });

  it('of a box is in the middle of its side', () => {
    const world = weightless();
    const moving = plainBody({ shapes: [box(1, 1)], position: [-1.1, 0.2], velocity: [3, 0] });
    const wall = phys2D.createRigidBody({ type: 'static', shapes: [box(1, 5)] });
    const seen = listen(moving.shapes[0]!);
    add(world, moving, wall);
    until(world, () => seen.length > 0);
    near([seen[0]!.speed, seen[0]!.impulse], [3, 3]);
    near(seen[0]!.position, [-0.5, 0.2], 0.05);
    expect(seen[0]!.contacts).toBe(2);
  });

  it('has `this`, the arbiter and the other shape; both are of the step', () => {
    const { world, moving, still } = coming(0);
    const calls: unknown[][] = [];
    still.shapes[0]!.addEventListener('hit', function (this: Shape, arbiter: Arbiter, other: Shape, hit: Hit) {
      calls.push([this, other, arbiter.active]);
      const destination = [0, 0];
      expect(hit.getPosition(destination)).toBe(destination);
      near(hit.impulse, Math.abs(arbiter.getImpulseForBody(still)[0]));
    });
    steps(world, 3);
    expect(calls).toEqual([[still.shapes[0], moving.shapes[0], true]]);
  });

  it('tells the same where `poses` removes the body before', () => {
    const tell = (removes: boolean) => {
      const { world, moving, seen } = coming(0.001);
      world.poses = { update: () => void (removes && seen.length === 0 && world.timeStamp > 0 && remove()) };
      const remove = () => moving.shapes[0]!.arbiters.length > 0 && world.removeRigidBody(moving);
      until(world, () => seen.length > 0);
      return seen.map(({ speed, impulse, position, normal }) => ({ speed, impulse, position, normal }));
    };
    expect(tell(true)).toEqual(tell(false));
    near(tell(true)[0]!.impulse, 1.5);
  });

  it('is not called for slower ones, or other groups', () => {
    const { world, moving, still } = coming(0.1);
    const shape = still.shapes[0]!;
    const seen = [listen(shape, undefined, 3.001), listen(shape, undefined, 2.999), listen(shape, 4), listen(shape, 1)];
    steps(world, 10);
    expect(seen.map((list) => list.length)).toEqual([0, 1, 0, 1]);
    moving.setPosition([-1.2, 0]);
    moving.setVelocity([3, 0]);
    still.setVelocity([0, 0]);
    still.setPosition([0, 0]);
    steps(world, 10);
    expect(seen[3]).toHaveLength(2);
  });

  it('takes one handler with several speeds only once', () => {
    const shape = disc(1);
    const handler = vi.fn();
    expect(shape.addEventListener('hit', handler, undefined, 2)).toBe(true);
    expect(shape.addEventListener('hit', handler, undefined, 3)).toBe(false);
    expect(shape.removeEventListener('hit', handler)).toBe(true);
    expect(shape.addEventListener('hit', handler, undefined, 3)).toBe(true);
  });

  it('is not called for what is rejected, or a sensor', () => {
    for (const sensor of [true, false]) {
      const { world, still, seen } = coming(0.1, { shapes: [disc(0.5, { sensor })] });
      const begin = vi.fn();
      still.shapes[0]!.addEventListener('begin', begin);
      still.shapes[0]!.addEventListener('preSolve', (arbiter) => arbiter.setAcceptedState(false));
      steps(world, 30);
      expect(begin).toHaveBeenCalledTimes(1);
      expect(seen).toEqual([]);
    }
  });

  it('tells of a sleeping body, in the step in which it wakes', () => {
    const { world, still, seen } = coming(3);
    const wake = vi.fn();
    still.addEventListener('wake', wake);
    still.sleep();
    until(world, () => seen.length > 0);
    expect(wake).toHaveBeenCalledTimes(1);
    near([seen[0]!.speed, seen[0]!.impulse], [3, 1.5]);
  });

  /** The step in which the body at the origin has been at rest for long enough to fall asleep. */
  const LAST = 62;

  it('tells of a body that would have fallen asleep in the very step', () => {
    for (const type of ['dynamic', 'kinematic'] as const) {
      for (const gap of [-0.001, 0.01, 0.03]) {
        const { world, moving, still, seen } = coming(9);
        steps(world, LAST - 1);
        moving[type === 'dynamic' ? 'setAsDynamic' : 'setAsKinematic']();
        moving.setPosition([-1 - gap, 0]);
        until(world, () => seen.length > 0);
        steps(world, 2);
        const both = type === 'dynamic' ? 1.5 : 3;
        near([seen[0]!.speed, seen[0]!.impulse], [3, both]);
        near(still.getVelocity(), [both, 0]);
        near(moving.getVelocity(), [both, 0]);
      }
    }
  });

  it('tells of an old pair, whatever is left of its arbiter', () => {
    for (let pause = 28; pause < 34; pause += 1) {
      const { world, moving, still } = coming(-0.001);
      steps(world, 1);
      moving.setPosition([-9, 0]);
      moving.setVelocity([0, 0]);
      still.setVelocity([0, 0]);
      steps(world, pause);
      const seen = listen(still.shapes[0]!);
      still.setPosition([0, 0]);
      moving.setPosition([-1.01, 0]);
      moving.setVelocity([3, 0]);
      steps(world, 1);
      near([seen[0]!.speed, seen[0]!.impulse, seen[0]!.contacts], [3, 1.5, 1]);
      near(seen[0]!.position, [-0.5, 0], 0.05);
      expect(arbiterOf(world, moving, still)!.contacts).toHaveLength(1);
    }
  });

  it('comes with every begin of a bouncing ball, as hard as the bounce', () => {
    const rubber = phys2D.createMaterial({ elasticity: 0.8 });
    const world = phys2D.createWorld();
    const ground = phys2D.createRigidBody({
      type: 'static',
      position: [0, 1],
      shapes: [box(20, 1, { material: rubber })],
    });
    const ball: RigidBody = plainBody({ shapes: [disc(0.5, { material: rubber })], position: [0, -3] });
    const seen = listen(ball.shapes[0]!);
    const begin = vi.fn();
    ball.shapes[0]!.addEventListener('begin', begin);
    add(world, ground, ball);
    let before = 0;
    for (let i = 0; i < 600; i += 1) {
      const count = seen.length;
      before = ball.getVelocity()[1];
      steps(world, 1);
      expect(seen).toHaveLength(begin.mock.calls.length);
      if (seen.length > count && before > 1) {
        near(seen[count]!.speed, before, 10 / 60);
        near(seen[count]!.impulse, before - ball.getVelocity()[1], 0.2);
      }
    }
    expect(seen.length).toBeGreaterThan(5);
  });

  it.each([
    [40, 10, -1.2, 0, 0],
    [60, 10, -1.5, 0, 0],
    [60, 10, -1.5, 0.3, 0.5],
  ])('tells of all that a bar gets that strikes twice in a step, and of the first time how fast, %#', (...numbers) => {
    const [speed, spin, y, rotation, elasticity] = numbers;
    const world = weightless();
    const material = phys2D.createMaterial({ elasticity });
    add(world, phys2D.createRigidBody({ type: 'static', position: [0, 0.5], shapes: [box(20, 1)] }));
    const bar = phys2D.createRigidBody({
      position: [0, y],
      rotation,
      velocity: [0, speed],
      angularVelocity: spin,
      linearDrag: 0,
      angularDrag: 0,
      shapes: [box(2, 0.2, { material })],
    });
    add(world, bar);
    const seen = listen(bar.shapes[0]!);
    until(world, () => seen.length > 0);
    near(seen[0]!.impulse, bar.getMass() * (speed - bar.getVelocity()[1]), 1e-9);
    expect(seen[0]!.speed).toBeGreaterThan(speed - spin);
    expect(seen[0]!.speed).toBeLessThan(speed + 1.01 * spin);
  });
});
