import { describe, expect, it } from 'vitest';
import { type Constraint, phys2D, type RigidBody, type World } from '../../src/index.js';
import { add, DT, heavy, near, plainBody, speed, staticBody, steps, tie } from '../conformance/setting.js';
import { awake, listen, roped, sleeping } from './roped.js';

// What constraints do beyond the conformance statements: impulses, sleep, switching, lists.

/** Everything that two equal worlds have to have in common, to the bit. */
function placements(world: World): number[][] {
  return world.rigidBodies.map((body) => [
    ...body.getPosition(),
    ...body.getVelocity(),
    body.getRotation(),
    body.getAngularVelocity(),
  ]);
}

describe('impulses of earlier steps', () => {
  const anchor = (): RigidBody => staticBody();
  const held: Record<string, (body: RigidBody) => Constraint> = {
    'a rigid point': (bodyB) => phys2D.createPointConstraint({ bodyA: anchor(), bodyB, anchorB: [0.3, -1] }),
    'an elastic point': (bodyB) =>
      phys2D.createPointConstraint({ bodyA: anchor(), bodyB, anchorB: [0.3, -1], stiff: false }),
    'a distance': (bodyB) =>
      phys2D.createDistanceConstraint({ bodyA: anchor(), bodyB, lowerBound: 1, upperBound: 1, anchorB: [0.3, 0] }),
    'a weld': (bodyB) => phys2D.createWeldConstraint({ bodyA: anchor(), bodyB, anchorB: [0.3, -1] }),
    'a custom constraint': (bodyB) =>
      phys2D.createCustomConstraint({
        dimension: 1,
        bodies: [bodyB],
        position(data, index) {
          data[index] = bodyB.getPosition()[1] - 1;
        },
        jacobian(data, index) {
          data[index + 1] = 1;
        },
      }),
  };

  for (const [name, make] of Object.entries(held)) {
    it(`${name} that is added again moves its body like a new one, to the bit [D-59]`, () => {
      const run = (isNew: boolean): number[][] => {
        const world = heavy();
        const body = plainBody({ position: [0, 1] });
        add(world, body);
        const first = make(body);
        tie(world, first);
        steps(world, 30);
        world.removeConstraint(first);
        near(first.getImpulseForBody(body), [0, 0, 0], 0);
        steps(world, 2);
        const second = isNew ? make(body) : first;
        tie(world, second);
        steps(world, 1);
        const early = placements(world);
        steps(world, 30);
        return [...early, ...placements(world)];
      };
      expect(run(false)).toEqual(run(true));
    });

    it(`${name} that is enabled again moves its body like a new one, to the bit`, () => {
      const run = (isNew: boolean): number[][] => {
        const world = heavy();
        const body = plainBody({ position: [0, 1] });
        add(world, body);
        const first = make(body);
        tie(world, first);
        steps(world, 30);
        first.disable();
        near(first.getImpulseForBody(body), [0, 0, 0], 0);
        steps(world, 2);
        if (isNew) tie(world, make(body));
        else first.enable();
        steps(world, 20);
        return placements(world);
      };
      expect(run(false)).toEqual(run(true));
    });
  }

  const limited: Record<string, (body: RigidBody) => Constraint> = {
    'a rope': (bodyB) => phys2D.createDistanceConstraint({ bodyA: anchor(), bodyB, upperBound: 1 }),
    'an elastic rope': (bodyB) =>
      phys2D.createDistanceConstraint({ bodyA: anchor(), bodyB, upperBound: 1, stiff: false }),
    'a pulley': (bodyB) =>
      phys2D.createPulleyConstraint({
        bodyA: bodyB,
        bodyB: anchor(),
        bodyC: anchor(),
        bodyD: staticBody({ position: [2, 0] }),
        upperBound: 3,
      }),
    'a line with an end': (bodyB) =>
      phys2D.createLineConstraint({ bodyA: anchor(), bodyB, axis: [0, 1], upperBound: 1 }),
  };
  for (const [name, make] of Object.entries(limited)) {
    it(`${name} forgets its pull while it is slack [D-22]`, () => {
      const run = (isNew: boolean): number[][] => {
        const world = heavy();
        const body = plainBody({ position: [0, 1] });
        add(world, body);
        const first = make(body);
        tie(world, first);
        steps(world, 60);
        near(first.getImpulseForBody(body), [0, -1 / 6, 0], 0.01);
        body.setPosition([0, 0.5]);
        body.setVelocity([0, -1]);
        for (let i = 0; i < 5; i += 1) {
          world.step(DT);
          near(first.getImpulseForBody(body), [0, 0, 0], 0);
        }
        if (isNew) {
          world.removeConstraint(first);
          tie(world, make(body));
        }
        const path: number[][] = [];
        for (let i = 0; i < 40; i += 1) {
          world.step(DT);
          path.push(...placements(world));
        }
        return path;
      };
      const [old, fresh] = [run(false), run(true)];
      old.forEach((numbers, i) => {
        near(numbers, fresh[i]!, 1e-9);
      });
    });
  }
});

describe('sleep by hand', () => {
  it('takes the constraint alone out of the simulation, until it is woken', () => {
    const world = heavy();
    const body = plainBody({ position: [0, 1] });
    add(world, body);
    const hinge = phys2D.createPointConstraint({ bodyA: staticBody(), bodyB: body, anchorB: [0, -1] });
    const log = listen({ hinge });
    tie(world, hinge);
    steps(world, 10);
    hinge.sleep();
    expect([awake(hinge, body), world.liveConstraints]).toEqual([[false, true], []]);
    near(hinge.getImpulseForBody(body), [0, 0, 0], 0);
    steps(world, 30);
    near(body.getVelocity(), [0, 5], 0.01);
    expect(world.constraints).toEqual([hinge]);
    hinge.wake();
    steps(world, 60);
    near(body.transformLocalPointToWorld([0, -1]), [0, 0], 1e-3);
    expect(log).toEqual([]);
  });

  it('lasts while its bodies are awake, ends when one of them goes from asleep to awake', () => {
    const { world, a, b, rope } = roped();
    tie(world, rope);
    const log = listen({ rope });
    a.setVelocity([0, 0.1]);
    rope.sleep();
    steps(world, 10);
    a.setVelocity([0, 0.2]);
    a.wake();
    expect(awake(rope)).toEqual([false]);
    a.setVelocity([0, 0]);
    steps(world, 70);
    expect(awake(a, b, rope)).toEqual([false, false, false]);
    expect(log).toEqual([]);
    b.applyImpulse([0, 1]);
    expect(awake(a, b, rope)).toEqual([true, true, true]);
    steps(world, 1);
    expect(log).toEqual(['rope wake']);
  });

  it('added asleep it stays asleep, and leaves its bodies alone', () => {
    const { world, a, b, rope } = roped({ sleeping: true, upperBound: 1 });
    steps(world, 63);
    tie(world, rope);
    expect(awake(a, b, rope)).toEqual([false, false, false]);
    steps(world, 5);
    near(b.getPosition(), [3, 0], 0);
    rope.wake();
    steps(world, 5);
    near(b.getPosition()[0] - a.getPosition()[0], 1, 0.01);
  });

  it('outside a world both only set the flag; after removal it is awake', () => {
    const { world, rope } = roped();
    rope.sleep();
    expect(rope.sleeping).toBe(true);
    rope.wake();
    expect(rope.sleeping).toBe(false);
    rope.sleep();
    rope.setUpperBound(4);
    expect(rope.sleeping).toBe(false);
    rope.sleep();
    tie(world, rope);
    expect(rope.sleeping).toBe(true);
    world.removeConstraint(rope);
    expect(rope.sleeping).toBe(false);
  });

  it('a body put to sleep holds what is tied to it; the constraint, woken, wakes it', () => {
    const { world, a, b, rope } = roped();
    tie(world, rope);
    b.sleep();
    steps(world, 70);
    expect(awake(a, b, rope)).toEqual([false, false, false]);
    a.applyImpulse([0, 0.1]);
    expect(awake(a, rope)).toEqual([true, true]);
    expect(awake(b)).toEqual([true]);
  });

  it('a constraint woken by a setter wakes a body put to sleep before the rest', () => {
    const { world, a, b, rope } = roped();
    tie(world, rope);
    b.sleep();
    steps(world, 70);
    rope.setUpperBound(4);
    expect(awake(a, b, rope)).toEqual([true, true, true]);
  });

  it('a body added asleep stays asleep, whatever is tied to it', () => {
    for (const asleep of [false, true]) {
      const { world, a } = roped();
      const late = plainBody({ position: [0, 3], sleeping: true });
      const rope = phys2D.createDistanceConstraint({ bodyA: a, bodyB: late, upperBound: 5, sleeping: asleep });
      tie(world, rope);
      add(world, late);
      expect(awake(late), `constraint asleep: ${asleep}`).toEqual([false]);
    }
  });

  it('a body added awake wakes the sleeping constraints that use it, with an event', () => {
    const { world, a } = roped();
    const late = plainBody({ position: [0, 3] });
    const rope = phys2D.createDistanceConstraint({ bodyA: a, bodyB: late, upperBound: 5, sleeping: true });
    const log = listen({ rope });
    rope.sleep();
    tie(world, rope);
    expect(awake(rope)).toEqual([false]);
    add(world, late);
    expect(awake(rope)).toEqual([true]);
    steps(world, 1);
    expect(log).toEqual(['rope wake']);
  });
});

describe('switching', () => {
  it('disable() wakes the sleeping bodies, with events for them alone', () => {
    const { world, a, b, rope, log } = sleeping();
    rope.disable();
    expect(awake(a, b)).toEqual([true, true]);
    expect([rope.isEnabled(), rope.isDisabled(), rope.world, world.liveConstraints]).toEqual([false, true, world, []]);
    expect([world.constraints, a.constraints, b.constraints]).toEqual([[rope], [rope], [rope]]);
    steps(world, 1);
    expect([...log].sort()).toEqual(['a wake', 'b wake']);
  });

  it('disable() when awake leaves the bodies as they are', () => {
    const { world, rope } = roped({ upperBound: 1 });
    tie(world, rope);
    rope.disable();
    rope.disable();
    steps(world, 62);
    expect(world.liveDynamics).toEqual([]);
  });

  it('a disabled constraint cannot be woken, and wakes nothing', () => {
    const { world, a, b, rope } = roped();
    tie(world, rope);
    rope.disable();
    steps(world, 63);
    expect(awake(a, b)).toEqual([false, false]);
    rope.wake();
    rope.sleep();
    rope.setUpperBound(4);
    rope.configure({ damping: 2 });
    rope.addEventListener('break', () => {});
    expect(rope.getUpperBound()).toBe(4);
    expect([awake(a, b), world.liveConstraints]).toEqual([[false, false], []]);
    a.applyImpulse([0, 0]);
    expect([awake(a, b), world.liveConstraints]).toEqual([[true, false], []]);
    world.removeConstraint(rope);
    expect(awake(b)).toEqual([false]);
  });

  it('enable() wakes the bodies, with events, and acts', () => {
    const { world, a, b, rope } = roped({ disabled: true, upperBound: 2 });
    tie(world, rope);
    const log = listen({ a, b, rope });
    steps(world, 63);
    log.length = 0;
    rope.enable();
    rope.enable();
    expect([awake(a, b, rope), world.liveConstraints]).toEqual([[true, true, true], [rope]]);
    steps(world, 1);
    expect([...log].sort()).toEqual(['a wake', 'b wake']);
    steps(world, 5);
    near(b.getPosition()[0] - a.getPosition()[0], 2, 0.01);
  });

  it('one that a callback of another disables forgets what it gave', () => {
    for (const stiff of [true, false]) {
      const world = phys2D.createWorld({ gravity: [0, 10] });
      const anchor = phys2D.createRigidBody({ type: 'static' });
      const body = phys2D.createRigidBody({ shapes: [phys2D.createCircleShape({ radius: 1 })] });
      const other = phys2D.createRigidBody({ shapes: [phys2D.createCircleShape({ radius: 1 })], position: [5, 0] });
      const hinge = phys2D.createPointConstraint({ bodyA: anchor, bodyB: body, stiff });
      let isTime = false;
      const custom = phys2D.createCustomConstraint({
        bodies: [other],
        dimension: 1,
        jacobian(data, index) {
          data[index] = 1;
          if (isTime) hinge.disable();
        },
      });
      for (const object of [body, other]) world.addRigidBody(object);
      for (const object of [hinge, custom]) world.addConstraint(object);
      for (let i = 0; i < 10; i += 1) world.step(1 / 60);
      expect(hinge.getImpulseForBody(body)[1]).toBeLessThan(-0.1);
      isTime = true;
      world.step(1 / 60);
      expect(hinge.isDisabled()).toBe(true);
      expect(hinge.getImpulseForBody(body)).toEqual([0, 0, 0]);
      expect([...hinge.impulse]).toEqual([0, 0]);
    }
  });

  it('outside a world both only set the flag', () => {
    const { world, rope } = roped({ upperBound: 1 });
    rope.disable();
    expect(rope.isDisabled()).toBe(true);
    tie(world, rope);
    expect(world.liveConstraints).toEqual([]);
    world.removeConstraint(rope);
    rope.enable();
    tie(world, rope);
    expect(world.liveConstraints).toEqual([rope]);
  });

  it('removing a sleeping constraint wakes its bodies, with events for them alone', () => {
    const { world, a, b, rope, log } = sleeping();
    world.removeConstraint(rope);
    expect(awake(a, b, rope)).toEqual([true, true, true]);
    steps(world, 1);
    expect([...log].sort()).toEqual(['a wake', 'b wake']);
  });

  it('removing a body wakes what was tied to it', () => {
    const { world, a, b, rope, log } = sleeping();
    world.removeRigidBody(a);
    expect(awake(b)).toEqual([true]);
    expect([rope.world, world.constraints, b.constraints]).toEqual([null, [], []]);
    steps(world, 1);
    expect(log).toContain('b wake');
    expect(log).not.toContain('rope break');
  });

  it('a body that changes its type keeps its constraints', () => {
    const world = heavy();
    const [a, b] = [plainBody(), plainBody({ position: [0, 1] })];
    add(world, a, b);
    const hinge = phys2D.createPointConstraint({ bodyA: a, bodyB: b, anchorB: [0, -1] });
    tie(world, hinge);
    steps(world, 10);
    a.setAsStatic();
    const [x, y] = a.getPosition();
    steps(world, 60);
    near(b.getPosition(), [x, y + 1], 0.01);
    expect(speed(b)).toBeLessThan(0.01);
    a.setAsDynamic();
    steps(world, 30);
    near([b.getPosition()[1] - a.getPosition()[1], a.getVelocity()[1]], [1, 5], 0.02);
    a.setAsKinematic();
    a.setVelocity([1, 0]);
    a.setAngularVelocity(0);
    steps(world, 60);
    near(b.transformLocalPointToWorld([0, -1]), [...a.getPosition()], 0.01);
  });
});

describe('clear()', () => {
  it('frees the constraints, without events, and they can be added elsewhere', () => {
    const { world, a, b, rope, log } = sleeping({ breakUnderForce: true, maxForce: 1e3 });
    const off = phys2D.createAngleConstraint({ bodyA: a, bodyB: b, disabled: true });
    tie(world, off);
    world.clear();
    expect([world.constraints, world.liveConstraints, a.constraints, b.constraints]).toEqual([[], [], [], []]);
    expect([rope.world, rope.sleeping, off.world, off.isDisabled()]).toEqual([null, false, null, true]);
    steps(world, 2);
    expect(log).toEqual([]);
    const other = heavy();
    add(other, a, b);
    rope.setUpperBound(2);
    tie(other, rope);
    steps(other, 5);
    near(Math.abs(b.getPosition()[0] - a.getPosition()[0]), 2, 0.01);
    expect(rope.world).toBe(other);
  });

  it('works in a break handler', () => {
    const { world, a, b, rope } = roped({ upperBound: 1, breakUnderError: true, maxError: 0.5 });
    const other = phys2D.createAngleConstraint({ bodyA: a, bodyB: b });
    rope.addEventListener('break', () => world.clear());
    tie(world, rope, other);
    steps(world, 2);
    expect([world.constraints, world.liveConstraints, world.rigidBodies]).toEqual([[], [], []]);
    expect([rope.world, other.world, a.world]).toEqual([null, null, null]);
    add(world, a, b);
    rope.configure({ breakUnderError: false });
    tie(world, rope);
    steps(world, 5);
    near(b.getPosition()[0] - a.getPosition()[0], 1, 0.01);
  });
});
