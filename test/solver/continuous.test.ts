import { describe, expect, it, vi } from 'vitest';
import { type Arbiter, phys2D, type RigidBody, type Shape, type World } from '../../src/index.js';
import { add, box, disc, near, plainBody, steps, tie, weightless } from '../conformance/setting.js';

// What handlers are told of impacts that lie between two steps, and what they and the filters can do about them.

const FAST = 120;

interface Scene {
  readonly world: World;
  readonly wall: RigidBody;
  readonly shot: RigidBody;
}

type Kind = 'static' | 'kinematic' | 'dynamic';
const KINDS: readonly Kind[] = ['static', 'kinematic', 'dynamic'];

/** A disc at the origin that flies at a thin wall at x = 5 and meets it in its third step. */
function aim(wallShape: Shape = box(0.02, 10), shotShape: Shape = disc(0.25), kind: Kind = 'static'): Scene {
  const world = weightless();
  const mass = 1000;
  const wall = phys2D.createRigidBody({ type: kind, position: [5, 0], shapes: [wallShape], mass, linearDrag: 0 });
  const shot = plainBody({ shapes: [shotShape], velocity: [FAST, 0], bullet: kind === 'dynamic' });
  add(world, wall, shot);
  return { world, wall, shot };
}

/** Notes what the first shape of a body is told, with the number of the step. */
function listen(world: World, body: RigidBody): string[] {
  const log: string[] = [];
  for (const type of ['begin', 'progress', 'end', 'hit'] as const) {
    const note = (): void => {
      log.push(`${type} ${world.timeStamp}`);
    };
    if (type === 'hit') {
      body.shapes[0]!.addEventListener(type, note);
    } else {
      body.shapes[0]!.addEventListener(type, note);
    }
  }
  return log;
}

describe('events of an impact', () => {
  it('begin once, then progress while it lasts, end once', () => {
    for (const kind of KINDS) {
      const { world, wall, shot } = aim(undefined, undefined, kind);
      const logs = [listen(world, wall), listen(world, shot)];
      steps(world, 6);
      shot.setVelocity([-30, 0]);
      steps(world, 5);
      const expected = ['begin 3', 'hit 3', 'progress 4', 'progress 5', 'progress 6', 'progress 7', 'end 8'];
      expect(logs, kind).toEqual([expected, expected]);
    }
  });

  it('what bounces off parts at once', () => {
    const material = phys2D.createMaterial({ elasticity: 1 });
    for (const kind of KINDS) {
      const { world, wall } = aim(box(0.02, 10, { material }), disc(0.25, { material }), kind);
      const log = listen(world, wall);
      steps(world, 10);
      expect(log, kind).toEqual(['begin 3', 'hit 3', 'progress 4', 'end 5']);
    }
  });

  it('they come after those of the step itself, in the order of the shapes, not of the impacts', () => {
    const world = weightless();
    const log: string[] = [];
    const walls = [0, 1].map((i) =>
      phys2D.createRigidBody({ type: 'static', position: [5, 10 * i], shapes: [box(0.02, 5)] }),
    );
    const late = [1, 0].map((i) => plainBody({ position: [-0.8 * (1 - i), 10 * i], velocity: [FAST, 0] }));
    const still = [0, 1, 2, 3].map((i) => plainBody({ position: [0.9 * (i % 2), -10 * (i < 2 ? 1 : 2)] }));
    add(world, ...walls, ...late, ...still);
    still[3]!.setPosition([3, -20]);
    for (const [name, body] of [
      ['first wall', walls[0]],
      ['second wall', walls[1]],
      ['pair', still[0]],
      ['parting', still[2]],
    ] as const) {
      for (const type of ['begin', 'end'] as const) {
        body!.shapes[0]!.addEventListener(type, () => log.push(`${name}: ${type}`));
      }
    }
    still[1]!.setPosition([3, -10]);
    still[3]!.setPosition([0.9, -20]);
    steps(world, 2);
    still[1]!.setPosition([0.9, -10]);
    still[3]!.setPosition([3, -20]);
    log.length = 0;
    steps(world, 1);
    expect(log).toEqual(['pair: begin', 'parting: end', 'first wall: begin', 'second wall: begin']);
  });

  it('`end` and `begin` in one step: apart when it began, together again within it', () => {
    const { world, wall, shot } = aim();
    shot.setPosition([4.741, 0]);
    shot.setVelocity([1, 0]);
    steps(world, 1);
    const log = listen(world, wall);
    shot.setPosition([4, 0]);
    shot.setVelocity([FAST, 0]);
    steps(world, 1);
    expect(log).toEqual(['end 2', 'begin 2', 'hit 2']);
  });

  it('`hit` tells how fast, how hard and where', () => {
    for (const [elasticity, slant] of [
      [0, 0],
      [0.5, 0],
      [1, 0.5],
    ] as const) {
      const material = phys2D.createMaterial({ elasticity, staticFriction: 0, dynamicFriction: 0 });
      for (const kind of ['static', 'kinematic'] as const) {
        const { world, wall, shot } = aim(box(0.02, 100, { material }), disc(0.25, { material }), kind);
        shot.setVelocity([FAST, slant * FAST]);
        const seen: number[][] = [];
        wall.shapes[0]!.addEventListener('hit', (_, other, hit) => {
          expect(other).toBe(shot.shapes[0]);
          seen.push([hit.approachSpeed, hit.impulse, ...hit.getPosition(), ...hit.getNormal()]);
        });
        steps(world, 6);
        expect(seen).toHaveLength(1);
        near(seen[0]!.slice(0, 2), [FAST, FAST * (1 + elasticity)], 1e-6);
        near(seen[0]!.slice(2), [4.99, slant * 4.74, -1, 0], 0.01);
        near(shot.getVelocity(), [-elasticity * FAST, slant * FAST], 1e-6);
      }
    }
  });

  it('the arbiter reports the impulse to both, and is in the lists', () => {
    for (const kind of KINDS) {
      const { world, wall, shot } = aim(undefined, undefined, kind);
      steps(world, 3);
      const lists = { static: 'staticArbiters', kinematic: 'staticArbiters', dynamic: 'dynamicArbiters' } as const;
      const arbiters = world[lists[kind]];
      expect(arbiters).toHaveLength(1);
      const [arbiter] = arbiters as [Arbiter];
      expect(wall.shapes[0]!.arbiters).toEqual([arbiter]);
      expect(shot.shapes[0]!.arbiters).toEqual([arbiter]);
      expect([arbiter.active, arbiter.sleeping, arbiter.sensor]).toEqual([true, false, false]);
      const given = FAST - shot.getVelocity()[0];
      expect(given).toBeGreaterThan(0.99 * FAST);
      near(arbiter.getImpulseForBody(shot), [-given, 0, 0]);
      near(arbiter.getImpulseForBody(wall), [given, 0, 0]);
      expect(arbiter.contacts.map((contact) => contact.fresh)).toEqual([true]);
      steps(world, 60);
      near(arbiter.getImpulseForBody(shot), [0, 0, 0], 1e-3);
    }
  });

  it('a sleeping body that a bullet hits wakes in that step', () => {
    const { world, wall, shot } = aim(undefined, undefined, 'dynamic');
    const wake = vi.fn();
    wall.addEventListener('wake', wake);
    wall.sleep();
    steps(world, 2);
    expect([wall.sleeping, wake.mock.calls.length]).toEqual([true, 0]);
    steps(world, 1);
    expect([wall.sleeping, wall.getVelocity()[0] > 0.1]).toEqual([false, true]);
    steps(world, 3);
    expect(wake).toHaveBeenCalledTimes(1);
    expect(wall.getPosition()[0]).toBeGreaterThan(shot.getPosition()[0]);
  });
});

describe('preSolve at an impact', () => {
  it('may read everything', () => {
    for (const kind of KINDS) {
      for (const owner of ['wall', 'shot'] as const) {
        const scene = aim(undefined, undefined, kind);
        const calls: unknown[][] = [];
        const { wall, shot } = scene;
        scene[owner].shapes[0]!.addEventListener('preSolve', function (this: Shape, arbiter, other) {
          const place = arbiter.contacts[0]!.getPosition();
          calls.push([this, other, arbiter.isStateAccepted(), arbiter.isStatePersistent(), arbiter.contacts.length]);
          near(arbiter.getNormal(), [-1, 0]);
          near(place, [4.99, 0], 0.01);
          expect(arbiter.contacts[0]!.getPenetration()).toBeGreaterThan(-0.01);
          near([...arbiter.getImpulseForBody(shot), arbiter.getElasticity()!], [0, 0, 0, 0], 0);
          expect(scene.world.addRigidBody(plainBody())).toBe(false);
        });
        steps(scene.world, 3);
        const [own, other] = owner === 'wall' ? [wall, shot] : [shot, wall];
        expect(calls).toEqual([[own.shapes[0], other.shapes[0], true, false, 1]]);
      }
    }
  });

  it('its rejection lets pass, with begin and end; asked once if it persists', () => {
    for (const kind of KINDS) {
      for (const persistent of [false, true]) {
        const { world, wall, shot } = aim(undefined, disc(2.5), kind);
        const handler = vi.fn((arbiter: Arbiter) => {
          arbiter.setAcceptedState(false);
          arbiter.setPersistentState(persistent);
        });
        shot.shapes[0]!.addEventListener('preSolve', handler);
        const log = listen(world, wall);
        steps(world, 10);
        near(shot.getPosition()[0], 20);
        near([...wall.getPosition(), ...shot.getVelocity()], [5, 0, FAST, 0]);
        expect(log, kind).toEqual(['begin 2', 'progress 3', 'progress 4', 'end 5']);
        expect(handler.mock.calls.length).toBeGreaterThanOrEqual(persistent ? 1 : 3);
        expect(handler.mock.calls.length).toBeLessThanOrEqual(persistent ? 1 : 5);
        shot.setPosition([-1, 0]);
        shot.setVelocity([FAST, 0]);
        steps(world, 8);
        expect(log.filter((line) => line.startsWith('begin'))).toHaveLength(2);
        expect(handler.mock.calls.length).toBeGreaterThanOrEqual(2);
      }
    }
  });

  it('a changed mind is heard: rejected at one wall, stopped at the next', () => {
    const { world, wall, shot } = aim();
    const second = phys2D.createRigidBody({ type: 'static', position: [5.6, 0], shapes: [box(0.02, 10)] });
    add(world, second);
    shot.shapes[0]!.addEventListener('preSolve', (arbiter, other) => {
      arbiter.setAcceptedState(other.body !== wall);
    });
    const logs = [listen(world, wall), listen(world, second)];
    steps(world, 5);
    near(shot.getPosition()[0], 5.34, 0.01);
    expect(logs[0]!.slice(0, 1)).toEqual(['begin 3']);
    expect(logs[1]!.slice(0, 2)).toEqual(['begin 3', 'hit 3']);
  });

  it('what it sets takes effect at once', () => {
    for (const kind of ['static', 'kinematic'] as const) {
      const { world, wall, shot } = aim(box(0.02, 100), undefined, kind);
      shot.setVelocity([FAST, 10]);
      wall.shapes[0]!.addEventListener('preSolve', (arbiter) => {
        arbiter.setElasticity(1);
        arbiter.setStaticFriction(0);
        arbiter.setDynamicFriction(0);
      });
      steps(world, 4);
      near(shot.getVelocity(), [-FAST, 10], 1e-6);
    }
  });

  it('what it throws reaches the caller of step, and the step is done all the same', () => {
    const { world, wall, shot } = aim();
    let armed = true;
    wall.shapes[0]!.addEventListener('preSolve', () => {
      if (armed) {
        armed = false;
        throw new Error('at the impact');
      }
    });
    steps(world, 2);
    expect(() => steps(world, 1)).toThrow('at the impact');
    steps(world, 5);
    near(shot.getPosition()[0], 4.74, 0.01);
  });
});

describe('filters', () => {
  it('masks, groups and constraints with ignoreInteractions let pass, sensors and solid shapes', () => {
    for (const kind of KINDS) {
      for (const sensor of [false, true]) {
        for (const how of ['mask', 'group', 'tie', 'nothing'] as const) {
          const group = how === 'group' ? 4 : 1;
          const mask = how === 'mask' ? 6 : 0xffffffff;
          const { world, wall, shot } = aim(box(0.02, 10, { group, sensor }), disc(0.25, { mask }), kind);
          if (how === 'group') {
            shot.shapes[0]!.setMask(3);
          }
          const ignoreInteractions = how === 'tie';
          tie(
            world,
            phys2D.createDistanceConstraint({ bodyA: wall, bodyB: shot, upperBound: 100, ignoreInteractions }),
          );
          const log = listen(world, wall);
          steps(world, 8);
          expect(shot.getPosition()[0] > 5, `${kind} ${sensor} ${how}`).toBe(sensor || how !== 'nothing');
          expect(log.length > 0).toBe(how === 'nothing');
        }
      }
    }
  });
});

describe('sensors crossed within a step', () => {
  it('begin in that step, end in the next, once each, whoever is the sensor', () => {
    for (const kind of KINDS) {
      for (const which of ['wall', 'shot', 'both'] as const) {
        const sensor = { sensor: true };
        const scene = aim(
          box(0.02, 10, which === 'shot' ? {} : sensor),
          disc(0.25, which === 'wall' ? {} : sensor),
          kind,
        );
        const logs = [listen(scene.world, scene.wall), listen(scene.world, scene.shot)];
        steps(scene.world, 10);
        expect(logs, `${kind}, ${which}`).toEqual([
          ['begin 3', 'end 4'],
          ['begin 3', 'end 4'],
        ]);
        near([...scene.wall.getPosition(), ...scene.shot.getPosition()], [5, 0, 20, 0]);
      }
    }
  });

  it('by a kinematic body too, of static and dynamic ones', () => {
    for (const kind of ['static', 'dynamic'] as const) {
      const { world, wall, shot } = aim(undefined, disc(0.25, { sensor: true }), kind);
      shot.setAsKinematic();
      const log = listen(world, wall);
      wall.sleep();
      steps(world, 10);
      expect(log, kind).toEqual(['begin 3', 'end 4']);
      expect([wall.sleeping, shot.getPosition()[0] > 19]).toEqual([true, true]);
    }
  });

  it('not by a dynamic body that is no bullet, of a dynamic sensor', () => {
    const { world, wall, shot } = aim(box(0.02, 10, { sensor: true }), undefined, 'dynamic');
    shot.bullet = false;
    const log = listen(world, wall);
    steps(world, 10);
    expect(log).toEqual([]);
  });

  it('before a wall, but not behind it', () => {
    const { world, wall, shot } = aim();
    const gates = [4.2, 4.6, 5.4].map((x) =>
      phys2D.createRigidBody({ type: 'static', position: [x, 0], shapes: [box(0.02, 10, { sensor: true })] }),
    );
    add(world, ...gates);
    const logs = [wall, ...gates].map((body) => listen(world, body));
    shot.setVelocity([FAST, 0]);
    steps(world, 5);
    near(shot.getPosition()[0], 4.74, 0.01);
    expect(logs[0]).toEqual(['begin 3', 'hit 3', 'progress 4', 'progress 5']);
    expect(logs[1]!.slice(0, 1)).toEqual(['begin 2']);
    expect(logs[2]!.slice(0, 3)).toEqual(['begin 3', 'progress 4', 'progress 5']);
    expect(logs[3]).toEqual([]);
  });

  it('several in one step, each told of', () => {
    const { world, shot } = aim(box(0.02, 10, { sensor: true }));
    const gates = Array.from({ length: 12 }, (_, i) =>
      phys2D.createRigidBody({
        type: 'static',
        position: [4.4 + 0.1 * i, 0],
        shapes: [box(0.02, 10, { sensor: true })],
      }),
    );
    add(world, ...gates);
    const logs = gates.map((gate) => listen(world, gate));
    steps(world, 10);
    for (const log of logs) {
      expect(log).toEqual(['begin 3', 'end 4']);
    }
    near(shot.getPosition()[0], 20);
  });
});

describe('handlers of impacts', () => {
  for (const type of ['begin', 'hit'] as const) {
    it(`of ${type} may remove the shot or the wall`, () => {
      for (const kind of KINDS) {
        for (const gone of ['wall', 'shot'] as const) {
          const scene = aim(undefined, undefined, kind);
          const { world, wall, shot } = scene;
          const stays = gone === 'wall' ? shot : wall;
          const log = listen(world, stays);
          const remove = (): void => {
            expect(world.removeRigidBody(scene[gone])).toBe(true);
          };
          if (type === 'hit') {
            wall.shapes[0]!.addEventListener('hit', remove);
          } else {
            wall.shapes[0]!.addEventListener('begin', remove);
          }
          steps(world, 3);
          expect([scene[gone].world, stays.world]).toEqual([null, world]);
          steps(world, 3);
          expect(log).toEqual(['begin 3', 'hit 3', 'end 4']);
          expect([world.staticArbiters, world.dynamicArbiters]).toEqual([[], []]);
          if (gone === 'wall') {
            shot.setVelocity([FAST, 0]);
            steps(world, 1);
            near(shot.getPosition()[0], 6.74, 0.01);
          }
        }
      }
    });
  }
});
