import { describe, expect, it, vi } from 'vitest';
import { phys2D, type RigidBody, type Shape, type World } from '../../src/index.js';
import { add, addFloor, boxBody, disc, heavy, plainBody, steps, tie, weightless } from '../conformance/setting.js';

// Interactions of bodies that fall asleep, wake, or never do: events, lists, states.

const TYPES = ['begin', 'progress', 'end'] as const;

/** Notes types of events, with an S where the arbiter sleeps and an A where it is active. */
function listen(shape: Shape): string[] {
  const log: string[] = [];
  for (const type of TYPES) {
    shape.addEventListener(type, ({ sleeping, active }) =>
      log.push(type + (sleeping ? 'S' : '') + (active ? 'A' : '')),
    );
  }
  return log;
}

/** Two bodies that overlap; the first has the given shape. */
function overlapping(type: 'dynamic' | 'kinematic' | 'static', shape: Shape = disc(0.5, { sensor: true })) {
  const world = weightless();
  const a = plainBody({ shapes: [shape] });
  const b = plainBody({ type, position: [0.99, 0] });
  add(world, a, b);
  return { world, a, b, log: listen(shape) };
}

const counts = (world: World) => [world.dynamicArbiters.length, world.staticArbiters.length];

describe('sleep() and wake() by hand', () => {
  it('one progress tells that both sleep, none follows, and waking goes on', () => {
    for (const type of ['dynamic', 'kinematic', 'static'] as const) {
      for (const shape of [disc(0.5), disc(0.5, { sensor: true })]) {
        const { world, a, b, log } = overlapping(type, shape);
        steps(world, 2);
        b.sleep();
        a.sleep();
        steps(world, 3);
        const { arbiters } = shape;
        expect([arbiters.length, arbiters[0]!.sleeping, arbiters[0]!.active], type).toEqual([1, true, false]);
        expect(counts(world)).toEqual([0, 0]);
        expect(log, type).toEqual(['beginA', 'progressA', 'progressS']);
        a.wake();
        expect([arbiters[0]!.sleeping, arbiters[0]!.active], type).toEqual([false, true]);
        expect(counts(world), type).toEqual(type === 'dynamic' ? [1, 0] : [0, 1]);
        steps(world, 1);
        expect(log, type).toEqual(['beginA', 'progressA', 'progressS', 'progressA']);
      }
    }
  });

  it('while both sleep all impulses read 0, and the next step has them again', () => {
    const world = heavy();
    addFloor(world);
    const shape = disc(0.5);
    const body = phys2D.createRigidBody({ velocity: [1, 0], shapes: [shape] });
    add(world, body);
    steps(world, 30);
    const [arbiter] = shape.arbiters;
    const [contact] = arbiter!.contacts;
    const impulses = () => [
      ...arbiter!.getImpulseForBody(body),
      arbiter!.getRollingImpulse(),
      contact!.getNormalImpulse(),
      contact!.getTangentImpulse(),
    ];
    expect(impulses()).not.toContain(0);
    body.sleep();
    steps(world, 1);
    expect([arbiter!.sleeping, arbiter!.contacts.length]).toEqual([true, 1]);
    expect(impulses().map(Math.abs)).toEqual(Array(6).fill(0));
    body.wake();
    steps(world, 1);
    expect(impulses()).not.toContain(0);
  });

  it('within one pause nothing is lost or told twice', () => {
    const programs: [string, ((a: RigidBody) => void)[], string[]][] = [
      ['sleep, wake', [(a) => a.sleep(), (a) => a.wake()], ['progressA']],
      ['sleep, wake, sleep', [(a) => a.sleep(), (a) => a.wake(), (a) => a.sleep()], ['progressS']],
      ['sleep, move away', [(a) => a.sleep(), (a) => a.setPosition([0, 9])], ['end']],
      ['sleep, remove', [(a) => a.sleep(), (a) => a.world!.removeRigidBody(a)], ['end']],
      ['sleep, become static', [(a) => a.sleep(), (a) => a.setAsStatic()], ['end']],
      [
        'sleep, become kinematic, move',
        [(a) => a.sleep(), (a) => a.setAsKinematic(), (a) => a.setVelocity([0, 1])],
        ['progressA'],
      ],
    ];
    for (const [name, program, expected] of programs) {
      const { world, a, log } = overlapping('static');
      steps(world, 1);
      log.length = 0;
      for (const act of program) {
        act(a);
      }
      steps(world, 1);
      expect(log, name).toEqual(expected);
    }
  });

  it('a body put to sleep beside an awake one is woken with an event; beside a sensor it is not', () => {
    for (const sensor of [false, true]) {
      const { world, a, b } = overlapping('dynamic', disc(0.5, { sensor }));
      const wake = vi.fn();
      b.addEventListener('wake', wake);
      a.setVelocity([0, 0.1]);
      steps(world, 1);
      b.sleep();
      steps(world, 1);
      expect(b.sleeping).toBe(sensor);
      expect(wake).toHaveBeenCalledTimes(sensor ? 0 : 1);
    }
  });

  it('sleep() in a preSolve handler leaves one event per step', () => {
    const world = heavy();
    const floor = addFloor(world);
    const body = boxBody(1, 1);
    add(world, body);
    const perStep: string[][] = [];
    for (const type of TYPES) {
      floor.shapes[0]!.addEventListener(type, () => perStep.at(-1)!.push(type));
    }
    body.shapes[0]!.addEventListener('preSolve', () => {
      if (world.timeStamp === 5) {
        body.sleep();
      }
    });
    for (let i = 1; i <= 8; i += 1) {
      perStep.push([]);
      steps(world, 1);
    }
    expect(perStep.flatMap((events) => (events.length > 1 ? [events] : []))).toEqual([]);
  });

  it('the world cleared while a last progress is due does not spoil later pairs', () => {
    const { world, a } = overlapping('static');
    steps(world, 1);
    a.sleep();
    world.removeRigidBody(a);
    world.clear();
    steps(world, 3);
    const shape = disc(0.5, { sensor: true });
    const c = plainBody({ shapes: [shape] });
    const log = listen(shape);
    add(world, plainBody({ type: 'static' }), c);
    steps(world, 1);
    c.sleep();
    steps(world, 2);
    expect(log).toEqual(['beginA', 'progressS']);
  });
});

describe('kinematic bodies', () => {
  it('a begin tells of an active arbiter, also to a sensor that stands still', () => {
    for (const moves of [true, false]) {
      const world = weightless();
      const zone = plainBody({ type: 'kinematic', shapes: [disc(0.5, { sensor: true })] });
      const log = listen(zone.shapes[0]!);
      zone.setVelocity(moves ? [0.1, 0] : [0, 0]);
      add(world, plainBody({ type: 'static', position: [0.9, 0] }), zone);
      steps(world, 1);
      expect(log).toEqual(['beginA']);
    }
  });

  it('progress ends with one that tells of sleep, and comes again with motion', () => {
    const world = weightless();
    const zone = plainBody({ type: 'kinematic', velocity: [0.1, 0], shapes: [disc(0.5, { sensor: true })] });
    const log = listen(zone.shapes[0]!);
    add(world, plainBody({ type: 'static', position: [0.9, 0] }), zone);
    steps(world, 2);
    zone.setVelocity([0, 0]);
    steps(world, 5);
    expect(log.filter((event) => event.includes('S'))).toEqual(['progressS']);
    const { length } = log;
    expect(length).toBeLessThanOrEqual(4);
    zone.setVelocity([0.1, 0]);
    steps(world, 2);
    expect(log.slice(length)).toEqual(['progressA', 'progressA']);
  });

  it('one that is put into a body pushes it out, whenever it comes', () => {
    for (let before = 58; before < 66; before += 1) {
      const world = weightless();
      const body = plainBody();
      const door = plainBody({ type: 'kinematic', position: [5, 0] });
      add(world, body, door);
      steps(world, before);
      door.setPosition([0.6, 0]);
      steps(world, 100);
      expect(body.getPosition()[0], `after ${before} steps`).toBeLessThan(-0.38);
    }
  });

  it('stay awake where nothing may sleep', () => {
    const world = weightless({ allowSleeping: false });
    const body = plainBody({ type: 'kinematic' });
    add(world, body);
    steps(world, 3);
    expect(body.sleeping).toBe(false);
  });
});

describe('falling asleep', () => {
  it('an interaction does so in the step of its bodies, whose last progress tells', () => {
    const world = heavy();
    addFloor(world);
    const bodies = [0, 1].map((i) => boxBody(1, 1, { position: [0, -i] }));
    const sensor = disc(0.6, { sensor: true });
    bodies[0]!.addShape(sensor);
    add(world, ...bodies);
    const log = bodies.map(({ shapes }) => listen(shapes[0]!));
    log.push(listen(sensor));
    while (!bodies[0]!.sleeping) {
      log.forEach((events) => {
        events.length = 0;
      });
      steps(world, 1);
    }
    expect(bodies[1]!.sleeping).toBe(true);
    const pairs = new Set(bodies.flatMap(({ shapes }) => shapes.flatMap(({ arbiters }) => arbiters)));
    expect([...pairs].map(({ sleeping, active }) => [sleeping, active])).toEqual(Array(4).fill([true, false]));
    expect(counts(world)).toEqual([0, 0]);
    // The lower box touches the floor and the other, the upper one that and the sensor, the sensor the upper one and the floor.
    expect(log).toEqual([Array(2).fill('progressS'), Array(2).fill('progressS'), Array(2).fill('progressS')]);
    steps(world, 3);
    expect(log.flat()).toHaveLength(6);
  });

  it('an interaction with what goes on moving does not', () => {
    for (const zoneFirst of [true, false]) {
      const world = weightless();
      const shapes = [0, 1].map((i) => disc(0.5, { sensor: (i === 0) === zoneFirst }));
      const [zone, shape] = zoneFirst ? [shapes[0]!, shapes[1]!] : [shapes[1]!, shapes[0]!];
      const still = plainBody({ shapes: [shape] });
      const log = listen(zone);
      add(world, still, plainBody({ type: 'kinematic', angularVelocity: 1, shapes: [zone] }));
      while (!still.sleeping) {
        steps(world, 1);
      }
      expect([zone.arbiters[0]!.sleeping, zone.arbiters[0]!.active]).toEqual([false, true]);
      log.length = 0;
      steps(world, 2);
      expect(log).toEqual(['progressA', 'progressA']);
    }
  });

  it('what parted slowly a moment before stays apart', () => {
    const world = weightless();
    const [still, leaving] = [plainBody(), plainBody({ position: [1 - 0.0015, 0], velocity: [0.002, 0] })];
    const log = listen(leaving.shapes[0]!);
    add(world, still, leaving);
    while (!leaving.sleeping) {
      steps(world, 1);
    }
    const { arbiters } = leaving.shapes[0]!;
    expect(arbiters.map(({ sleeping, active }) => [sleeping, active])).toEqual([[false, false]]);
    expect(log.at(-1)).toBe('end');
  });

  it('in the step in which another body arrives loses no momentum', () => {
    for (let before = 58; before < 66; before += 1) {
      for (const gap of [0.003, 0.015, 0.03]) {
        const world = weightless();
        const still = plainBody();
        const ball = plainBody({ position: [1 + gap, 0], velocity: [-1, 0] });
        add(world, still);
        steps(world, before);
        add(world, ball);
        steps(world, 5);
        const [moved, left] = [still.getVelocity()[0], ball.getVelocity()[0]];
        expect(moved + left, `gap ${gap} after ${before} steps`).toBeCloseTo(-1, 9);
        expect(moved).toBeCloseTo(-0.5, 9);
      }
    }
  });
});

describe('waking', () => {
  it('no wake event for a body that is removed, or asleep again, before the step', () => {
    for (const undo of [
      (body: RigidBody) => body.world!.removeRigidBody(body),
      (body: RigidBody) => body.sleep(),
      (body: RigidBody) => body.setAsStatic(),
      (body: RigidBody) => body.setAsKinematic(),
    ]) {
      const world = weightless();
      const other = weightless();
      const body = plainBody();
      const wake = vi.fn();
      body.addEventListener('wake', wake);
      add(world, body);
      steps(world, 70);
      body.setForce([1e-9, 0]);
      undo(body);
      steps(world, 2);
      if (body.world === null) {
        add(other, body);
        steps(other, 2);
      }
      expect(wake, String(undo)).not.toHaveBeenCalled();
    }
  });

  it('is silent for the body only, not for the rest of its stack', () => {
    const world = heavy();
    addFloor(world);
    const bodies = [0, 1, 2].map((i) => boxBody(1, 1, { position: [0, -i] }));
    const log: string[] = [];
    bodies.forEach((body, i) => {
      body.addEventListener('wake', () => log.push(`wake ${i}`));
    });
    add(world, ...bodies);
    const shape = bodies[1]!.shapes[0]!;
    const handler = () => {};
    const calls: [() => unknown, string[]][] = [
      [() => bodies[1]!.wake(), ['wake 0', 'wake 2']],
      [() => shape.addEventListener('end', handler), ['wake 0', 'wake 2']],
      [() => shape.removeEventListener('end', handler), ['wake 0', 'wake 2']],
      [() => shape.arbiters[0]!.setElasticity(0), ['wake 2']],
      [() => shape.removeEventListener('end', handler), []],
      [() => shape.setMask(0xffffffff), ['wake 0', 'wake 1', 'wake 2']],
    ];
    for (const [call, expected] of calls) {
      for (let i = 0; i < 300 && !bodies.every((body) => body.sleeping); i += 1) {
        steps(world, 1);
      }
      expect(bodies.map((body) => body.sleeping)).toEqual([true, true, true]);
      log.length = 0;
      call();
      steps(world, 1);
      expect(log, String(call)).toEqual(expected);
    }
  });

  it('in a callback of a custom constraint keeps velocities and lists', () => {
    const world = weightless();
    const sleeper = plainBody({ velocity: [0, -2] });
    const busy = plainBody({ position: [5, 0] });
    const calls: (() => void)[] = [];
    add(
      world,
      plainBody({ type: 'static', position: [0, 0.99], shapes: [disc(0.5, { sensor: true })] }),
      sleeper,
      busy,
    );
    tie(world, phys2D.createCustomConstraint({ dimension: 1, bodies: [busy], jacobian: () => calls.pop()?.() }));
    sleeper.setVelocity([0, 0]);
    steps(world, 1);
    sleeper.setVelocity([0, -2]);
    sleeper.sleep();
    busy.setVelocity([1, 0]);
    steps(world, 1);
    calls.push(() => sleeper.wake());
    steps(world, 1);
    expect(calls).toEqual([]);
    expect([sleeper.sleeping, sleeper.getVelocity()]).toEqual([false, [0, -2]]);
    expect(world.staticArbiters).toEqual(sleeper.shapes[0]!.arbiters);
    steps(world, 1);
    expect(sleeper.getPosition()[1]).toBeCloseTo(-2 / 60, 9);
  });

  it('does not spread to what else lies on the same floor, or no longer touches', () => {
    const world = heavy();
    addFloor(world);
    const bodies = [-3, 0, 3].map((x) => boxBody(1, 1, { position: [x, 0] }));
    add(world, ...bodies);
    steps(world, 10);
    for (const body of bodies) {
      body.sleep();
    }
    steps(world, 1);
    bodies[1]!.wake();
    expect(bodies.map(({ sleeping }) => sleeping)).toEqual([true, false, true]);

    const empty = weightless();
    const [still, gone] = [plainBody(), plainBody({ position: [0.9, 0] })];
    add(empty, still, gone);
    steps(empty, 1);
    gone.setPosition([2, 0]);
    steps(empty, 1);
    still.sleep();
    gone.sleep();
    expect(still.shapes[0]!.arbiters).toHaveLength(1);
    still.wake();
    expect([still.sleeping, gone.sleeping]).toEqual([false, true]);
  });

  it('of what a body that goes touched comes with an event, and only of what it touched', () => {
    const remove = (world: World, body: RigidBody) => world.removeRigidBody(body);
    const hold = (_: World, body: RigidBody) => body.setAsKinematic();
    for (const [leave, sleeps] of [
      [remove, true],
      [remove, false],
      [hold, true],
      [hold, false],
    ] as const) {
      const world = weightless();
      const middle = plainBody();
      const touching = plainBody({ position: [0.999, 0] });
      const through = plainBody({ position: [0, 0.9], shapes: [disc(0.5)] });
      const parted = plainBody({ position: [-0.9, 0] });
      through.shapes[0]!.addEventListener('preSolve', (arbiter) => arbiter.setAcceptedState(false), undefined, true);
      const all = [touching, through, parted];
      const woken: RigidBody[] = [];
      for (const body of all) {
        body.addEventListener('wake', () => woken.push(body));
      }
      add(world, middle, ...all);
      steps(world, 1);
      parted.setPosition([-2, 0]);
      steps(world, 1);
      for (const body of all) {
        body.sleep();
      }
      if (sleeps) {
        middle.sleep();
        steps(world, 1);
      }
      expect(middle.shapes[0]!.arbiters).toHaveLength(3);
      woken.length = 0;
      leave(world, middle);
      expect(all.map(({ sleeping }) => sleeping)).toEqual([false, true, true]);
      steps(world, 1);
      expect(woken).toEqual([touching]);
    }
  });

  it('of a constraint wakes dynamic bodies of its world alone', () => {
    const [world, other] = [weightless(), weightless()];
    const [body, lift, stranger] = [plainBody(), plainBody({ type: 'kinematic', position: [3, 0] }), plainBody()];
    add(world, body, lift);
    add(other, stranger);
    const joints = [lift, stranger].map((bodyB) =>
      phys2D.createDistanceConstraint({ bodyA: body, bodyB, upperBound: 5 }),
    );
    tie(world, ...joints);
    const wake = vi.fn();
    const all = [body, lift, stranger];
    for (const each of all) {
      each.addEventListener('wake', wake);
    }
    steps(world, 100);
    steps(other, 100);
    wake.mockClear();
    expect(all.map(({ sleeping }) => sleeping)).toEqual([true, true, true]);
    for (const joint of joints) {
      joint.wake();
    }
    expect(all.map(({ sleeping }) => sleeping)).toEqual([false, true, true]);
    steps(world, 1);
    steps(other, 1);
    expect(wake.mock.contexts).toEqual([body]);
  });

  it('by a hit makes what touched go on in that very step', () => {
    const world = heavy();
    const floor = addFloor(world);
    const body = boxBody(1, 1);
    add(world, body);
    const log = listen(floor.shapes[0]!);
    steps(world, 100);
    expect(body.sleeping).toBe(true);
    log.length = 0;
    add(world, boxBody(0.5, 0.5, { position: [0, -0.9], velocity: [0, 2] }));
    while (body.sleeping) {
      expect(log).toEqual([]);
      steps(world, 1);
    }
    expect(log).toEqual(['progressA']);
    steps(world, 1);
    expect(log).toEqual(['progressA', 'progressA']);
  });

  it('by a bullet wakes in that very step, before the interaction begins, also if it is removed afterwards', () => {
    const world = weightless();
    const log: string[] = [];
    const body = plainBody();
    body.addEventListener('wake', () => log.push(`wake ${world.timeStamp}`));
    body.shapes[0]!.addEventListener('begin', () => log.push(`begin ${world.timeStamp}`));
    add(world, plainBody({ velocity: [200, 0], position: [-11.2, 0], bullet: true }), body);
    body.sleep();
    while (body.sleeping) {
      steps(world, 1);
    }
    const { timeStamp } = world;
    world.removeRigidBody(body);
    steps(world, 2);
    expect(log).toEqual([`wake ${timeStamp}`, `begin ${timeStamp}`]);
  });

  it.each([
    ['static', (zone: Shape) => zone.setMask(0)],
    ['static', (zone: Shape) => zone.setGroup(0)],
    ['kinematic', (zone: Shape) => zone.setMask(0)],
  ] as const)('in a sensor of a %s body ends in the next step once that is switched off', (type, switchOff) => {
    const world = heavy();
    addFloor(world);
    const zone = disc(3, { sensor: true });
    const visitor = boxBody(1, 1);
    add(world, phys2D.createRigidBody({ type, shapes: [zone] }), visitor);
    const log: string[] = [];
    for (const type of ['begin', 'end'] as const) {
      zone.addEventListener(type, (_arbiter, { body }) => body === visitor && log.push(type));
    }
    for (let i = 0; i < 600 && !visitor.sleeping; i += 1) steps(world, 1);
    expect([visitor.sleeping, ...log]).toEqual([true, 'begin']);
    switchOff(zone);
    steps(world, 1);
    expect(log).toEqual(['begin', 'end']);
  });

  it('lists of arbiters keep the others when a body is removed', () => {
    const world = heavy();
    addFloor(world);
    const bodies = [-3, 0, 3].map((x) => boxBody(1, 1, { position: [x, 0] }));
    add(world, ...bodies);
    for (const gone of [bodies[0]!, bodies[2]!]) {
      steps(world, 2);
      world.removeRigidBody(gone);
      const left = bodies.filter((body) => body.world !== null);
      expect(world.staticArbiters).toHaveLength(left.length);
      expect(new Set(world.staticArbiters)).toEqual(new Set(left.flatMap(({ shapes }) => shapes[0]!.arbiters)));
    }
  });
});

it('a collision that was rejected and sleeps ends when the mask of the static shape changes', () => {
  const world = weightless();
  const [ground, shape] = [disc(3), disc(0.5)];
  const body = plainBody({ shapes: [shape] });
  add(world, phys2D.createRigidBody({ type: 'static', shapes: [ground] }), body);
  shape.addEventListener('preSolve', (arbiter) => arbiter.setAcceptedState(false), undefined, true);
  const log: string[] = [];
  for (const type of ['begin', 'end'] as const) shape.addEventListener(type, () => log.push(type));
  steps(world, 100);
  expect([body.sleeping, ...log]).toEqual([true, 'begin']);
  ground.setMask(0);
  steps(world, 1);
  expect(log).toEqual(['begin', 'end']);
});

it.each(['wake', 'push'])(
  'a body put to sleep that a handler of another pair makes %s goes on as if it had not slept',
  (how) => {
    const world = heavy();
    const other = boxBody(1, 1, { position: [5, 0] });
    add(world, other);
    addFloor(world);
    const body = boxBody(1, 1);
    add(world, body);
    steps(world, 30);
    const [y] = [body.getPosition()[1]];
    const log = listen(body.shapes[0]!);
    body.sleep();
    other.shapes[0]!.addEventListener('preSolve', () => {
      if (how === 'wake') body.wake();
      else body.applyImpulse([1e-3, 0]);
    });
    steps(world, 3);
    expect(log).toEqual(['progressA', 'progressA', 'progressA']);
    expect(Math.abs(body.getPosition()[1] - y)).toBeLessThan(1e-6);
  },
);

it('a contact that sleeps tells where it was as its body is put elsewhere, until it has ended', () => {
  const world = heavy();
  addFloor(world);
  const body = boxBody(1, 1);
  add(world, body);
  let atEnd: unknown;
  body.shapes[0]!.addEventListener('end', () => {
    atEnd = told();
  });
  steps(world, 100);
  expect(body.sleeping).toBe(true);
  const [arbiter] = body.shapes[0]!.arbiters;
  const told = () => arbiter!.contacts.map((contact) => [...contact.getPosition(), contact.getPenetration()]);
  const before = told();
  expect(before).toHaveLength(2);
  body.setPosition([3, -20]);
  expect(told()).toEqual(before);
  steps(world, 1);
  expect(atEnd).toEqual(before);
});
