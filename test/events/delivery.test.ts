import { describe, expect, it, vi } from 'vitest';
import { Arbiter, Hit, phys2D, type RigidBody, type Shape } from '../../src/index.js';
import { add, addFloor, boxBody, DT, disc, heavy, plainBody, steps, tie, weightless } from '../conformance/setting.js';

// In what order handlers are called, and what they may do meanwhile.

const OF_SHAPES = ['begin', 'progress', 'end'] as const;
const ALL = [...OF_SHAPES, 'hit', 'wake', 'sleep'] as const;

function listen(log: string[], name: string, shape: Shape): void {
  for (const type of OF_SHAPES) {
    shape.addEventListener(type, () => log.push(`${name} ${type}`));
  }
  shape.addEventListener('hit', () => log.push(`${name} hit`));
}

/** Adds a handler for any type of event to a body or its first shape. */
function on(body: RigidBody, type: (typeof ALL)[number], handler: () => void): void {
  if (type === 'wake' || type === 'sleep') {
    body.addEventListener(type, handler);
  } else if (type === 'hit') {
    body.shapes[0]!.addEventListener(type, handler);
  } else {
    body.shapes[0]!.addEventListener(type, handler);
  }
}

/** Two overlapping bodies, and what leads to an event of `a` in the step after it. */
function about(type: (typeof ALL)[number]) {
  const world = weightless();
  const a = plainBody();
  const b = plainBody({ position: [0.99, 0] });
  const other = plainBody({ position: [9, 0] });
  add(world, a, b, other);
  const prepare = {
    begin: () => {},
    hit: () => {},
    progress: () => steps(world, 1),
    end: () => {
      steps(world, 1);
      b.setPosition([5, 0]);
    },
    sleep: () => {
      b.setPosition([5, 0]);
      steps(world, 61);
    },
    wake: () => {
      steps(world, 100);
      a.setVelocity([0, 1]);
    },
  };
  return { world, a, b, other, prepare: prepare[type] };
}

describe('an `end` by the removal of a shape', () => {
  it('has the bodies that met, whichever shape left', () => {
    for (const which of [0, 1]) {
      const { world, a, b } = about('end');
      const seen: unknown[] = [];
      const shapes = [a.shapes[0]!, b.shapes[0]!];
      for (const shape of shapes) {
        shape.addEventListener('end', function (arbiter, other) {
          seen.push([arbiter.bodyA, arbiter.bodyB, this.body, other.body]);
        });
      }
      steps(world, 1);
      [a, b][which]!.removeShape(shapes[which]!);
      steps(world, 1);
      const left = which === 0 ? [null, b] : [a, null];
      expect(seen).toEqual([
        [a, b, ...left],
        [a, b, ...[...left].reverse()],
      ]);
    }
  });
});

describe('order', () => {
  it('is by type, then by the ids of the shapes, shapeA first', () => {
    const world = weightless();
    const log: string[] = [];
    const bodies = [0, 1, 2, 3, 4, 5].map((i) => plainBody({ position: [0, 5 * i] }));
    bodies.forEach((body, i) => {
      listen(log, String(i), body.shapes[0]!);
    });
    add(world, ...[3, 1, 5, 0, 2, 4].map((i) => bodies[i]!));
    bodies[5]!.setPosition([0.9, 0]);
    bodies[3]!.setPosition([0.9, 10]);
    steps(world, 1);
    expect(log).toEqual(['0 begin', '5 begin', '2 begin', '3 begin', '0 hit', '5 hit', '2 hit', '3 hit']);
    log.length = 0;
    bodies[4]!.setPosition([0.9, 5]);
    bodies[3]!.setPosition([9, 9]);
    steps(world, 1);
    expect(log).toEqual([
      ...['1 begin', '4 begin', '1 hit', '4 hit'],
      ...['0 progress', '5 progress', '2 end', '3 end'],
    ]);
  });

  it('is wake, begin, progress, end, sleep, break; then what the solver found', () => {
    const world = weightless();
    const log: string[] = [];
    const [woken, coming, going, fast] = [0, 1, 2, 3].map((i) => {
      const wall = phys2D.createRigidBody({ type: 'static', position: [0.99, 10 * i], shapes: [disc(0.5)] });
      const body = plainBody({ position: [i % 2 === 0 ? 0 : -9, 10 * i] });
      listen(log, ['woken', 'coming', 'going', 'fast'][i]!, wall.shapes[0]!);
      add(world, wall, body);
      return body;
    }) as [RigidBody, RigidBody, RigidBody, RigidBody];
    const sleepy = plainBody({ position: [0, 60] });
    const tied = plainBody({ position: [0, 80] });
    woken.addEventListener('wake', () => log.push('woken wake'));
    sleepy.addEventListener('sleep', () => log.push('sleepy sleep'));
    add(world, sleepy, tied);
    steps(world, 61);
    woken.sleep();
    woken.setVelocity([1e-3, 0]);
    coming.setPosition([0, 10]);
    going.setPosition([-9, 20]);
    fast.setPosition([-0.02, 30]);
    fast.setVelocity([5, 0]);
    const rope = phys2D.createDistanceConstraint({
      bodyA: phys2D.createRigidBody({ type: 'static' }),
      bodyB: tied,
      upperBound: 1,
      stiff: false,
      maxError: 1,
      breakUnderError: true,
    });
    rope.addEventListener('break', () => log.push('rope break'));
    tie(world, rope);
    log.length = 0;
    steps(world, 1);
    expect(log).toEqual([
      'woken wake',
      'coming begin',
      'coming hit',
      'woken progress',
      'going end',
      'sleepy sleep',
      'rope break',
      'fast begin',
      'fast hit',
    ]);
  });

  it('removals come before everything, in the order of the shapes', () => {
    const world = weightless();
    const log: string[] = [];
    const bodies = [0, 1, 2, 3].map((i) => plainBody({ position: [0.9 * (i % 2), 5 * Math.floor(i / 2)] }));
    bodies.forEach((body, i) => {
      listen(log, String(i), body.shapes[0]!);
    });
    const sleeper = plainBody({ position: [9, 9], sleeping: true });
    add(world, ...bodies, sleeper);
    sleeper.addEventListener('wake', () => log.push('wake'));
    sleeper.sleep();
    steps(world, 1);
    log.length = 0;
    sleeper.setVelocity([1, 0]);
    world.removeRigidBody(bodies[3]!);
    world.removeRigidBody(bodies[0]!);
    steps(world, 1);
    expect(log).toEqual(['0 end', '1 end', '2 end', '3 end', 'wake']);
  });

  it('of what wakes and falls asleep is that of first shapes, and bodies without any come before', () => {
    const world = weightless();
    const log: string[] = [];
    const shapes = [0, 1, 2].map(() => disc(0.5));
    const bodies = [2, 0, -1, 1].map((first, i) =>
      plainBody({ shapes: first < 0 ? [] : [shapes[first]!], position: [0, 5 * i], sleeping: true }),
    );
    ['third', 'first', 'bare', 'second'].forEach((name, i) => {
      for (const type of ['wake', 'sleep'] as const) {
        bodies[i]!.addEventListener(type, () => log.push(`${name} ${type}`));
      }
    });
    add(world, ...bodies);
    for (const body of bodies) {
      body.sleep();
    }
    steps(world, 1);
    log.length = 0;
    for (const body of bodies) {
      body.setVelocity([1e-3, 0]);
    }
    steps(world, 1);
    expect(log).toEqual(['bare wake', 'first wake', 'second wake', 'third wake']);
    log.length = 0;
    steps(world, 100);
    expect(log).toEqual(['bare sleep', 'first sleep', 'second sleep', 'third sleep']);
  });

  it('an end may be followed by a begin of the same step, if the surfaces met within it', () => {
    const world = weightless();
    const a = plainBody();
    const b = plainBody({ position: [0.999, 0] });
    const log: string[] = [];
    add(world, a, b);
    steps(world, 1);
    listen(log, 'a', a.shapes[0]!);
    a.setPosition([0, 0]);
    b.setPosition([1.01, 0]);
    b.setVelocity([-3, 0]);
    steps(world, 1);
    expect(log).toEqual(['a end', 'a begin', 'a hit']);
  });
});

describe('handlers', () => {
  for (const type of ALL) {
    it(`of ${type} may remove bodies, clear the world, or throw`, () => {
      for (const deed of ['remove', 'clear', 'throw'] as const) {
        const { world, a, b, other, prepare } = about(type);
        const log: string[] = [];
        const deeds = {
          remove: () => expect([world.removeRigidBody(a), world.removeRigidBody(b)]).toEqual([true, true]),
          clear: () => world.clear(),
          throw: () => {
            throw new Error('out of a handler');
          },
        };
        let armed = false;
        on(a, type, () => {
          if (armed) {
            log.push('first');
            deeds[deed]();
          }
        });
        on(a, type, () => log.push('second'));
        prepare();
        log.length = 0;
        armed = true;
        const step = () => world.step(DT);
        if (deed === 'throw') {
          expect(step).toThrow('out of a handler');
        } else {
          step();
        }
        armed = false;
        expect(log).toEqual(deed === 'clear' ? ['first'] : ['first', 'second']);
        expect([a.world, b.world, other.world]).toEqual(
          { remove: [null, null, world], clear: [null, null, null], throw: [world, world, world] }[deed],
        );
        if (deed === 'throw') {
          expect([world.removeRigidBody(a), world.removeRigidBody(b)]).toEqual([true, true]);
        }
        steps(world, 1);
        a.setPosition([0, 0]);
        b.setPosition([0.99, 0]);
        add(world, a, b);
        const begin = vi.fn();
        b.shapes[0]!.addEventListener('begin', begin);
        steps(world, 3);
        expect(begin).toHaveBeenCalledTimes(1);
      }
    });
  }

  it.each(ALL)('of %s are called on their object, with what is promised and no more', (type) => {
    const { a, b, world, prepare } = about(type);
    const calls: unknown[][] = [];
    on(a, type, function (this: unknown, ...given: unknown[]): void {
      calls.push([this, ...given]);
    });
    prepare();
    steps(world, 1);
    const [own, arbiter, other, hit, ...rest] = calls[0]!;
    if (type === 'wake' || type === 'sleep') {
      expect(calls[0]).toHaveLength(1);
      expect(own).toBe(a);
      return;
    }
    expect(calls[0]).toHaveLength(type === 'hit' ? 4 : 3);
    expect([own, other]).toEqual([a.shapes[0], b.shapes[0]]);
    expect(arbiter).toBeInstanceOf(Arbiter);
    expect(rest).toEqual([]);
    expect(hit instanceof Hit).toBe(type === 'hit');
  });

  it('of wake are not called for a body that has left the world by then', () => {
    const [first, second] = [weightless(), weightless()];
    const body = plainBody();
    const log: string[] = [];
    add(first, body);
    body.sleep();
    steps(first, 1);
    body.addEventListener('wake', () => log.push('wake'));
    const move = (): void => body.setVelocity([body.getVelocity()[0] + 1, 0]);
    move();
    first.removeRigidBody(body);
    add(second, body);
    steps(first, 1);
    expect(log).toEqual([]);
    body.sleep();
    move();
    steps(second, 1);
    expect(log).toEqual(['wake']);
  });

  it('the first exception reaches the caller, every handler is called, once', () => {
    const world = weightless();
    const [a, b] = [plainBody(), plainBody({ position: [0.9, 0] })];
    const calls: string[] = [];
    const fail = (what: string) => () => {
      calls.push(what);
      throw new Error(what);
    };
    a.shapes[0]!.addEventListener('begin', fail('begin of a'));
    b.shapes[0]!.addEventListener('begin', fail('begin of b'));
    b.shapes[0]!.addEventListener('preSolve', fail('preSolve'), undefined, true);
    add(world, a, b);
    expect(() => world.step(DT)).toThrow('preSolve');
    expect(calls).toEqual(['preSolve', 'begin of a', 'begin of b']);
    expect(b.getPosition()[0]).toBeGreaterThan(0.9);
    a.setPosition([-5, 0]);
    expect(() => world.step(DT)).not.toThrow();
    expect(calls).toHaveLength(3);
  });

  it('may step and change another world', () => {
    const [first, second] = [weightless(), weightless()];
    const [a, b] = [plainBody(), plainBody({ position: [0.9, 0] })];
    const c = plainBody({ position: [0.5, 0.5] });
    add(first, a, b);
    add(second, c);
    const log: string[] = [];
    a.shapes[0]!.addEventListener('begin', (_, other) => {
      log.push(other === c.shapes[0] ? 'begin c' : 'begin b');
      if (a.world === first) {
        first.removeRigidBody(a);
        add(second, a);
        second.step(DT);
      }
    });
    a.shapes[0]!.addEventListener('end', (_, other) => log.push(other === c.shapes[0] ? 'end c' : 'end b'));
    steps(first, 1);
    expect(log).toEqual(['begin b', 'begin c']);
    steps(second, 1);
    steps(first, 1);
    expect(log).toEqual(['begin b', 'begin c', 'end b']);
  });

  it('what they cause comes with the next step', () => {
    const world = heavy();
    addFloor(world);
    const [first, second] = [boxBody(1, 1), boxBody(1, 1, { position: [5, 0] })];
    add(world, first, second);
    steps(world, 200);
    const log: string[] = [];
    second.addEventListener('wake', () => log.push(`wake ${world.timeStamp}`));
    steps(world, 70);
    expect(second.sleeping).toBe(true);
    first.shapes[0]!.addEventListener('progress', () => second.applyImpulse([0, -1]));
    const stamp = world.timeStamp;
    steps(world, 1);
    expect([second.sleeping, log]).toEqual([false, []]);
    steps(world, 1);
    expect(log).toEqual([`wake ${stamp + 2}`]);
  });
});
