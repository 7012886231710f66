import { afterEach, describe, expect, it, vi } from 'vitest';
import { CLEAR_STEPS } from '../../src/config.js';
import { BoxTreeBroadphase, phys2D, type RigidBody, SweepAndPrune, type World } from '../../src/index.js';
import { ClearSpace } from '../../src/solver/impacts/clear-space.js';
import { add, box, boxBody, DT, disc, heavy, plainBody, steps, weightless } from '../conformance/setting.js';
import { generator } from '../scenes/mixed.js';

// What flies in the open is not looked ahead for in every step. Whatever comes to stand in its way meanwhile is met as ever.

afterEach(() => vi.restoreAllMocks());

const thin = () => box(0.02, 4);

function wall(x: number): RigidBody {
  return phys2D.createRigidBody({ type: 'static', position: [x, 0], shapes: [thin()] });
}

/** The share of the looks that found a body in its clear space. */
function counted(): () => number {
  const holds = vi.spyOn(ClearSpace.prototype, 'holds');
  return () => holds.mock.results.filter(({ value }) => value === true).length / holds.mock.results.length;
}

describe('what comes to stand in the way of a body in the open', () => {
  type Way = (world: World) => (x: number) => void;

  /** A wall that a snapshot has at x, and that is not there until it is restored. */
  const restored =
    (meanwhile: (world: World, body: RigidBody) => void): Way =>
    (world) => {
      const body = wall(-500);
      return (x) => {
        body.setPosition([x, 0]);
        add(world, body);
        const walled = world.snapshot();
        world.removeRigidBody(body);
        meanwhile(world, body);
        steps(world, 6);
        world.restore(walled, [body]);
      };
    };

  /** Each puts a thin wall at x before the body gets there; what was made for it may be in the world before. */
  const ways: Record<string, Way> = {
    'a static body that is added': (world) => (x) => add(world, wall(x)),
    'a static body that is taken out and put in again': (world) => {
      const body = wall(-500);
      add(world, body);
      return (x) => {
        world.removeRigidBody(body);
        body.setPosition([x, 0]);
        add(world, body);
      };
    },
    'a dynamic body that becomes static': (world) => {
      const body = phys2D.createRigidBody({ position: [-500, 0], shapes: [thin()] });
      add(world, body);
      return (x) => {
        body.setPosition([x, 0]);
        body.setAsStatic();
      };
    },
    'a kinematic body': (world) => {
      const body = phys2D.createRigidBody({ type: 'kinematic', position: [-500, 0], shapes: [thin()] });
      add(world, body);
      return (x) => body.setPosition([x, 0]);
    },
    'one that a restored world has again': restored(() => undefined),
    'one that was asked for its bounds while it was gone': restored((_, body) => {
      body.computeWorldBounds();
    }),
    'one that was elsewhere until a world was restored': restored((world, body) => {
      body.setPosition([-500, 0]);
      add(world, body);
    }),
  };
  const broadphases = { 'box tree': () => new BoxTreeBroadphase(), 'sweep and prune': () => new SweepAndPrune() };
  for (const [name, put] of Object.entries(ways)) {
    it.each(Object.entries(broadphases))(`${name} (%s)`, (_, broadphase) => {
      const isHeld = counted();
      const world = weightless({ broadphase: broadphase() });
      const body = plainBody({ velocity: [60, 0], linearDrag: 0 });
      add(world, body);
      const set = put(world);
      steps(world, 12);
      expect(isHeld()).toBeGreaterThan(0.5);
      const x = body.getPosition()[0] + 4;
      set(x);
      steps(world, 20);
      expect(body.getPosition()[0]).toBeLessThan(x);
    });
  }

  it('a body that is put elsewhere is looked at anew', () => {
    const world = weightless();
    const body = plainBody({ velocity: [60, 0] });
    add(world, body, wall(-100));
    steps(world, 12);
    body.setPosition([-102, 0]);
    steps(world, 20);
    expect(body.getPosition()[0]).toBeLessThan(-100);
  });

  it('a body that is faster, or larger, now', () => {
    for (const change of [
      (body: RigidBody) => body.setVelocity([600, 0]),
      (body: RigidBody) => body.addShape(disc(20)),
    ]) {
      const world = weightless();
      const body = plainBody({ velocity: [10, 0] });
      add(world, body, wall(20));
      steps(world, 60);
      change(body);
      steps(world, 20);
      expect(body.getPosition()[0]).toBeLessThan(20);
    }
  });
});

describe('results', () => {
  /** Things that fly and fall among walls, while all that changes worlds happens. */
  function play(seed: number, forgets: boolean): string[] {
    const random = generator(seed);
    const world = heavy({ gravity: [0, 4 * random()] });
    const bodies: RigidBody[] = [];
    const statics: RigidBody[] = [];
    const place = (): [number, number] => [60 * random() - 30, 60 * random() - 30];
    for (let i = 0; i < 40; i += 1) {
      const velocity: [number, number] = [40 * random() - 20, 40 * random() - 20];
      const shapes = [random() < 0.5 ? disc(0.2 + random()) : box(1, 0.4, { sensor: random() < 0.1 })];
      bodies.push(phys2D.createRigidBody({ position: place(), velocity, angularVelocity: 6 * random(), shapes }));
    }
    add(world, ...bodies);
    for (let i = 0; i < 20; i += 1) {
      const [bodyA, bodyB] = [bodies[i]!, bodies[i + 1]!];
      if (random() < 0.6) {
        world.addConstraint(phys2D.createDistanceConstraint({ bodyA, bodyB, lowerBound: 0, upperBound: 6 }));
      }
    }
    const any = (list: RigidBody[]): RigidBody => list[Math.floor(list.length * random())]!;
    const changes: (() => void)[] = [
      () => {
        const body = phys2D.createRigidBody({ type: 'static', position: place(), shapes: [box(6, 0.05)] });
        statics.push(body);
        add(world, body);
      },
      () => {
        const body = any(statics);
        if (body !== undefined) world.removeRigidBody(body);
      },
      () => any(bodies).setPosition(place()),
      () => any(bodies).setVelocity([100 * random() - 50, 100 * random() - 50]),
      () => any(bodies).sleep(),
      () => any(bodies).wake(),
      () => {
        any(bodies).bullet = random() < 0.2;
      },
      () => {
        const body = any(bodies);
        if (body.isDynamic()) body.setAsStatic();
        else if (random() < 0.3) body.setAsKinematic();
        else body.setAsDynamic();
      },
    ];
    const hashes: string[] = [];
    for (let i = 0; i < 240; i += 1) {
      if (random() < 0.15) changes[Math.floor(changes.length * random())]!();
      if (forgets) world.movers.space.forget();
      world.step(DT);
      if (i % 10 === 9) hashes.push(world.hash());
    }
    return hashes;
  }

  it('are the same to the bit as if nothing were remembered', () => {
    const isHeld = counted();
    for (let seed = 1; seed <= 10; seed += 1) {
      expect(play(seed, false)).toEqual(play(seed, true));
    }
    expect(isHeld()).toBeGreaterThan(0.2);
  });

  it('where bullets and kinematic bodies meet what flies in the open', () => {
    const shoot = (kind: 'dynamic' | 'kinematic', comesAt: number, forgets: boolean): string => {
      const world = heavy();
      const target = boxBody(1, 1, { position: [0, -40], angularVelocity: 1, force: [30, 0] });
      const shot = phys2D.createRigidBody({ type: kind, bullet: true, position: [-500, 0], shapes: [disc(0.2)] });
      add(world, target, shot);
      let met = 0;
      target.shapes[0]!.addEventListener('begin', () => {
        met += 1;
      });
      for (let i = 0; i < 60; i += 1) {
        if (i === comesAt) {
          const [x, y] = target.getPosition();
          shot.setPosition([x - 3, y]);
          shot.setVelocity([200, 0]);
        }
        if (forgets) world.movers.space.forget();
        world.step(DT);
      }
      expect(met).toBe(1);
      return world.hash();
    };
    for (const kind of ['dynamic', 'kinematic'] as const) {
      for (const comesAt of [10, 17, 24]) {
        expect(shoot(kind, comesAt, false)).toBe(shoot(kind, comesAt, true));
      }
    }
  });

  it('of a swinging chain, too, which nothing is near', () => {
    const swing = (forgets: boolean): string => {
      const world = heavy();
      let last = phys2D.createRigidBody({ type: 'static' });
      add(world, last);
      for (let i = 0; i < 12; i += 1) {
        const body = boxBody(0.5, 0.1, { position: [0.5 * i + 0.25, 0] });
        add(world, body);
        const anchors = { anchorA: i === 0 ? ([0, 0] as const) : ([0.25, 0] as const), anchorB: [-0.25, 0] as const };
        world.addConstraint(phys2D.createPointConstraint({ bodyA: last, bodyB: body, ...anchors }));
        last = body;
      }
      for (let i = 0; i < 300; i += 1) {
        if (forgets) world.movers.space.forget();
        world.step(DT);
      }
      return world.hash();
    };
    const isHeld = counted();
    const hash = swing(false);
    expect(isHeld()).toBeGreaterThan(0.8);
    expect(hash).toBe(swing(true));
  });
});

it('a square tells how far a body can go in it', () => {
  const world = weightless();
  const body = plainBody({ velocity: [1, 0] });
  add(world, body);
  const space = new ClearSpace();
  const holds = (reach: number): boolean => {
    space.reach = reach;
    return space.holds(body);
  };
  space.begin();
  space.search(world, body);
  expect(holds(0)).toBe(false);
  space.begin();
  space.reach = 0.25;
  space.search(world, body);
  expect(holds(CLEAR_STEPS * 0.25 - 0.01)).toBe(true);
  expect(holds(CLEAR_STEPS * 0.25 + 0.01)).toBe(false);
  for (const [x, y] of [
    [0.5, 0],
    [0, -0.5],
    [-0.5, 0.5],
  ] as const) {
    body.setPosition([x, y]);
    expect(holds(CLEAR_STEPS * 0.25 - 0.51)).toBe(true);
    expect(holds(CLEAR_STEPS * 0.25 - 0.49)).toBe(false);
  }
  body.setPosition([0, 0]);
  body.addShape(disc(0.75));
  steps(world, 1);
  body.setPosition([0, 0]);
  expect(holds(CLEAR_STEPS * 0.25 - 0.26)).toBe(true);
  expect(holds(CLEAR_STEPS * 0.25 - 0.24)).toBe(false);
  space.forget();
  space.begin();
  expect(holds(0)).toBe(false);
});
