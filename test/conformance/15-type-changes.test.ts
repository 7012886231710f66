import { describe, expect, it, vi } from 'vitest';
import { phys2D, type RigidBody, type World } from '../../src/index.js';
import { add, addFloor, arbiterOf, boxBody, disc, heavy, near, plainBody, steps, weightless } from './setting.js';

const TYPES = ['setAsDynamic', 'setAsKinematic', 'setAsStatic'] as const;

/** The live lists that a body is in. */
function lists(world: World, body: RigidBody): string[] {
  return (['liveDynamics', 'liveKinematics'] as const).filter((name) => world[name].includes(body));
}

describe('type changes', () => {
  it('C-174 a body can be frozen and let go', () => {
    const world = heavy();
    const body = plainBody({ velocity: [1, 0], angularVelocity: 1 });
    const wake = vi.fn();
    body.addEventListener('wake', wake);
    add(world, body);
    steps(world, 30);
    expect(body.getVelocity()[1]).toBeGreaterThan(4);
    body.setAsStatic();
    expect(body.getVelocity()).toEqual([0, 0]);
    expect(body.getAngularVelocity()).toBe(0);
    expect([body.isStatic(), body.sleeping, lists(world, body)]).toEqual([true, true, []]);
    const placement = [body.getPosition(), body.getRotation()];
    steps(world, 30);
    expect([body.getPosition(), body.getRotation()]).toEqual(placement);
    expect(wake).not.toHaveBeenCalled();
    body.setAsDynamic();
    expect(lists(world, body)).toEqual(['liveDynamics']);
    steps(world, 1);
    expect(wake).toHaveBeenCalledTimes(1);
    steps(world, 29);
    expect(wake).toHaveBeenCalledTimes(1);
    near(body.getVelocity(), [0, 5]);
  });

  it('C-175 a kinematic body keeps its velocity, and gravity does not matter', () => {
    const world = heavy();
    const body = plainBody({ velocity: [1, -2], angularVelocity: 3 });
    add(world, body);
    body.setAsKinematic();
    expect([body.isKinematic(), body.sleeping, lists(world, body)]).toEqual([true, false, ['liveKinematics']]);
    steps(world, 60);
    expect([body.getVelocity(), body.getAngularVelocity()]).toEqual([[1, -2], 3]);
    near(body.getPosition(), [1, -2]);
    near(body.getRotation(), 3);
    body.setAsDynamic();
    expect([body.getVelocity(), lists(world, body)]).toEqual([[1, -2], ['liveDynamics']]);
    steps(world, 6);
    near(body.getVelocity(), [1, -1]);
  });

  it('what was dragged as a kinematic body hangs on its constraints again', () => {
    for (const from of ['setAsKinematic', 'setAsStatic'] as const) {
      const world = heavy();
      const hook = phys2D.createRigidBody({ type: 'static' });
      const bob = plainBody({ position: [2, 0] });
      add(world, bob);
      const rope = phys2D.createDistanceConstraint({ bodyA: hook, bodyB: bob, upperBound: 2 });
      world.addConstraint(rope);
      bob[from]();
      for (let i = 0; i < 30; i += 1) {
        bob.setVelocityFromPosition([1.5, 0.02 * i], 0, 1 / 60);
        steps(world, 1);
      }
      expect(rope.sleeping).toBe(true);
      bob.setAsDynamic();
      expect(rope.sleeping).toBe(false);
      steps(world, 120);
      expect(Math.hypot(...bob.getPosition())).toBeLessThan(2.01);
    }
  });

  it('C-175 from any type to any other, asleep or awake', () => {
    for (const from of TYPES) {
      for (const to of TYPES) {
        for (const asleep of [false, true]) {
          const world = weightless();
          const body = plainBody();
          const wake = vi.fn();
          add(world, body);
          body[from]();
          steps(world, asleep ? 70 : 0);
          body.sleep();
          body.addEventListener('wake', wake);
          if (asleep) {
            steps(world, 70);
          }
          const before = [body.sleeping, lists(world, body)];
          body[to]();
          const expected = { setAsDynamic: ['liveDynamics'], setAsKinematic: ['liveKinematics'], setAsStatic: [] }[to];
          const name = `${from} ${to} ${asleep}`;
          expect([body.sleeping, lists(world, body)], name).toEqual(
            from === to ? before : [to === 'setAsStatic', expected],
          );
          steps(world, 2);
          expect(wake, name).toHaveBeenCalledTimes(to === 'setAsDynamic' && from !== to ? 1 : 0);
        }
      }
    }
  });

  it('C-176 a change in a preSolve handler is ignored', () => {
    const world = heavy();
    const floor = addFloor(world);
    const body = boxBody(1, 1);
    add(world, body);
    const handler = vi.fn(() => {
      body.setAsStatic();
      body.setAsKinematic();
      floor.setAsDynamic();
      expect([body.isDynamic(), floor.isStatic()]).toEqual([true, true]);
    });
    body.shapes[0]!.addEventListener('preSolve', handler);
    steps(world, 20);
    expect(handler).toHaveBeenCalled();
    expect([body.isDynamic(), floor.isStatic()]).toEqual([true, true]);
  });

  it('interactions that stay possible go on, in the list they belong to', () => {
    const world = weightless();
    const a = plainBody();
    const b = plainBody({ position: [0.999, 0] });
    const calls: string[] = [];
    for (const type of ['begin', 'progress', 'end'] as const) {
      a.shapes[0]!.addEventListener(type, () => calls.push(type));
    }
    add(world, a, b);
    steps(world, 1);
    const arbiter = arbiterOf(world, a, b)!;
    const changes = [
      () => a.setAsKinematic(),
      () => a.setAsStatic(),
      () => a.setAsKinematic(),
      () => a.setAsDynamic(),
      () => b.setAsStatic(),
    ];
    for (const [i, change] of changes.entries()) {
      change();
      const dynamic = i === 3;
      expect([world.dynamicArbiters, world.staticArbiters]).toEqual(dynamic ? [[arbiter], []] : [[], [arbiter]]);
      steps(world, 1);
      expect([world.dynamicArbiters, world.staticArbiters]).toEqual(dynamic ? [[arbiter], []] : [[], [arbiter]]);
    }
    expect(calls).toEqual(['begin', ...changes.map(() => 'progress')]);
    a.setAsKinematic();
    expect([world.dynamicArbiters, world.staticArbiters, a.shapes[0]!.arbiters]).toEqual([[], [], []]);
    steps(world, 3);
    expect(calls.slice(-2)).toEqual(['progress', 'end']);
    a.setAsDynamic();
    steps(world, 1);
    expect(calls.slice(-2)).toEqual(['end', 'begin']);
  });

  it('those of a sensor end when both bodies are static', () => {
    const world = weightless();
    const a = plainBody({ shapes: [disc(0.5, { sensor: true })] });
    const b = plainBody({ position: [0.9, 0] });
    const calls: string[] = [];
    for (const type of ['begin', 'progress', 'end'] as const) {
      b.shapes[0]!.addEventListener(type, () => calls.push(type));
    }
    add(world, a, b);
    steps(world, 1);
    a.setAsKinematic();
    b.setAsStatic();
    a.setVelocity([0.01, 0]);
    steps(world, 2);
    expect(calls).toEqual(['begin', 'progress', 'progress']);
    a.setAsStatic();
    steps(world, 2);
    expect(calls).toEqual(['begin', 'progress', 'progress', 'end']);
    b.setAsDynamic();
    steps(world, 1);
    expect(calls.at(-1)).toBe('begin');
  });

  it('what rests on a body wakes when its type changes', () => {
    for (const change of ['setAsKinematic', 'setAsDynamic'] as const) {
      const world = heavy();
      const floor = addFloor(world);
      const body = boxBody(1, 1);
      add(world, body);
      steps(world, 200);
      const wake = vi.fn();
      body.addEventListener('wake', wake);
      steps(world, 70);
      expect(body.sleeping).toBe(true);
      floor[change]();
      expect(body.sleeping).toBe(false);
      steps(world, 1);
      expect(wake).toHaveBeenCalledTimes(1);
    }
  });
});
