import { describe, expect, it } from 'vitest';
import { phys2D, type RigidBody, type World } from '../../src/index.js';
import { add, box, disc, heavy, near, plainBody, speed, steps, tie, weightless } from '../conformance/setting.js';
import { generator } from '../scenes/mixed.js';

// Kinematic bodies that are fast or turn fast, and bodies that change their type in flight.

const FAST = 120;
const FREE = { linearDrag: 0, angularDrag: 0 };

function allFinite(...bodies: RigidBody[]): boolean {
  return bodies.every((body) =>
    [...body.getPosition(), ...body.getVelocity(), body.getRotation(), body.getAngularVelocity()].every(
      Number.isFinite,
    ),
  );
}

/** What stands in the way of a kinematic body: alone, asleep, or tied to something. */
const WAYS = ['resting', 'asleep', 'rod', 'spring', 'box'] as const;

function standing(world: World, way: (typeof WAYS)[number], x: number, y: number): RigidBody {
  const shapes = [way === 'box' ? box(0.2, 0.2) : disc(0.1)];
  const body = phys2D.createRigidBody({ shapes, position: [x, y], ...FREE });
  add(world, body);
  if (way === 'asleep') {
    body.sleep();
  }
  if (way === 'rod') {
    const partner = phys2D.createRigidBody({ shapes: [disc(0.1)], position: [2 * x, 2 * y], ...FREE });
    const length = Math.sqrt(x * x + y * y);
    add(world, partner);
    tie(
      world,
      phys2D.createDistanceConstraint({ bodyA: body, bodyB: partner, lowerBound: length, upperBound: length }),
    );
  }
  if (way === 'spring') {
    const bodyA = phys2D.createRigidBody({ type: 'static' });
    const anchorA: [number, number] = [x, y];
    tie(world, phys2D.createPointConstraint({ bodyA, bodyB: body, anchorA, stiff: false, frequency: 2, damping: 0.5 }));
  }
  return body;
}

describe('kinematic bodies at speed', () => {
  it('50 m/s: a thin bar sweeps along whatever it hits', () => {
    for (const way of WAYS) {
      for (const start of [-1.1, -1.4, -1.9]) {
        const world = weightless();
        const bar = phys2D.createRigidBody({ type: 'kinematic', velocity: [50, 0], shapes: [box(0.02, 4)] });
        bar.setPosition([start, 0]);
        const body = standing(world, way, 1, 0);
        add(world, bar);
        for (let i = 0; i < 20; i += 1) {
          steps(world, 1);
          expect(body.getPosition()[0], `${way} from ${start}`).toBeGreaterThan(bar.getPosition()[0] + 0.08);
        }
        expect(body.sleeping).toBe(false);
        expect(bar.getVelocity()).toEqual([50, 0]);
        near(bar.getPosition(), [start + 50 / 3, 0]);
        if (way === 'rod') {
          expect(body.getVelocity()[0]).toBeGreaterThan(45);
        } else if (way !== 'spring') {
          near(body.getVelocity()[0], 50, 0.5);
        }
      }
    }
  });

  it('50 rad/s: a rotor does not pass what is in its way', () => {
    for (const way of WAYS) {
      for (const angle of [0.4, 0.8, 1.3, 2.6]) {
        const world = weightless();
        const rotor = phys2D.createRigidBody({ type: 'kinematic', angularVelocity: 50, shapes: [box(4, 0.05)] });
        const body = standing(world, way, 1.2 * Math.cos(angle), 1.2 * Math.sin(angle));
        add(world, rotor);
        let [ahead, before] = [angle, angle];
        for (let i = 0; i < 6; i += 1) {
          steps(world, 1);
          const [x, y] = body.getPosition();
          if (x * x + y * y > 2.1 * 2.1) {
            break;
          }
          const now = Math.atan2(y, x);
          const turn = now - before - 2 * Math.PI * Math.round((now - before) / (2 * Math.PI));
          ahead += turn - 50 / 60;
          before = now;
          expect(ahead, `${way} at ${angle}, step ${i}`).toBeGreaterThan(0);
          expect(ahead, `${way} at ${angle}, step ${i}`).toBeLessThan(Math.PI);
        }
        expect(speed(body), `${way} at ${angle}`).toBeGreaterThan(way === 'rod' ? 15 : 40);
        expect(allFinite(body)).toBe(true);
      }
    }
  });

  it('they carry a bullet that hits them, to the end of the step', () => {
    const world = weightless();
    const wall = phys2D.createRigidBody({
      type: 'kinematic',
      position: [4, 0],
      velocity: [-60, 0],
      shapes: [box(0.02, 9)],
    });
    const shot = plainBody({ shapes: [disc(0.25)], velocity: [60, 0] });
    add(world, wall, shot);
    for (let i = 0; i < 20; i += 1) {
      steps(world, 1);
      expect(shot.getPosition()[0] + 0.25).toBeLessThan(wall.getPosition()[0]);
    }
    near([shot.getPosition()[0], shot.getVelocity()[0]], [wall.getPosition()[0] - 0.26, -60], 0.01);
  });
});

describe('a thin box that moves and turns', () => {
  const HALF = 4;
  const THICK = 0.02;

  function outside(drum: RigidBody, bodies: readonly RigidBody[]): boolean {
    return bodies.some((body) => {
      const [x, y] = drum.transformWorldPointToLocal(body.getPosition());
      return !(Math.max(Math.abs(x), Math.abs(y)) < HALF + THICK);
    });
  }

  it.each([
    [60, 500],
    [30, 0],
    [10, 0],
    [10, 5000],
  ])('1/%d s, turns of up to %d rad/s: keeps what whirls and is shot about in it', (rate, spin) => {
    const end = HALF + THICK;
    for (let seed = 1; seed <= 12; seed += 1) {
      const random = generator(seed);
      const world = heavy();
      const shapes = [
        phys2D.createRectangleVertices(-end, -end, end, -HALF),
        phys2D.createRectangleVertices(-end, HALF, end, end),
        phys2D.createRectangleVertices(-end, -HALF, -HALF, HALF),
        phys2D.createRectangleVertices(HALF, -HALF, end, HALF),
      ].map((vertices) => phys2D.createPolygonShape({ vertices }));
      const drum = phys2D.createRigidBody({ type: 'kinematic', angularVelocity: 1, velocity: [3, 0], shapes });
      const bodies = [0, 1, 2].map((i) => {
        const angle = 2 * Math.PI * random();
        const v = 400 * random();
        return phys2D.createRigidBody({
          bullet: i === 0,
          position: [(random() - 0.5) * HALF, (random() - 0.5) * HALF],
          velocity: [v * Math.cos(angle), v * Math.sin(angle)],
          angularVelocity: (random() - 0.5) * spin,
          shapes: [box(0.1 + 0.4 * random(), 0.1 + 0.2 * random())],
        });
      });
      add(world, drum, ...bodies);
      for (let i = 0; i < 60; i += 1) {
        world.step(1 / rate);
        expect(outside(drum, bodies), `seed ${seed}, step ${i}`).toBe(false);
      }
    }
  });

  it('that moves fast keeps what slides along a wall of it to the next one', () => {
    for (const seed of [106, 978, 1001, 3463, 4024, 4131, 4493, 4810]) {
      const random = generator(seed);
      const world = weightless();
      const material = phys2D.createMaterial({ elasticity: 1, staticFriction: 3, dynamicFriction: 3 });
      const velocity: [number, number] = [200 * random() - 100, 200 * random() - 100];
      const shapes = [
        [-1.35, -1.35, 1.35, -1.3],
        [-1.35, 1.3, 1.35, 1.35],
        [-1.35, -1.35, -1.3, 1.35],
        [1.3, -1.35, 1.35, 1.35],
      ].map(([left, top, right, bottom]) => {
        const vertices = phys2D.createRectangleVertices(left!, top!, right!, bottom!);
        return phys2D.createPolygonShape({ vertices, material });
      });
      const drum = phys2D.createRigidBody({ type: 'kinematic', velocity, shapes });
      const bodies = [-1, 0, 1].map((x) =>
        phys2D.createRigidBody({
          bullet: true,
          position: [x, 0],
          velocity: [1000 * random() - 500, 1000 * random() - 500],
          shapes: [box(0.05, 0.05, { material })],
          ...FREE,
        }),
      );
      add(world, drum, ...bodies);
      for (let i = 0; i < 30; i += 1) {
        steps(world, 1);
        for (const body of bodies) {
          const [x, y] = drum.transformWorldPointToLocal(body.getPosition());
          expect(Math.max(Math.abs(x), Math.abs(y)), `seed ${seed}, step ${i}`).toBeLessThan(1.35);
        }
      }
    }
  });
});

describe('a body of infinite mass', () => {
  it.each(['kinematic', 'static'] as const)('is turned out of what it overlaps, but not moved: %s', (type) => {
    const world = weightless();
    const block = phys2D.createRigidBody({
      type,
      position: [-0.341, -0.664],
      rotation: -4.3,
      shapes: [box(0.852, 1.11)],
    });
    const paddle = phys2D.createRigidBody({
      position: [-0.074, -1.19],
      mass: Infinity,
      shapes: [phys2D.createPolygonShape({ vertices: phys2D.createRectangleVertices(-0.564, -0.814, 0.466, 0.256) })],
    });
    add(world, block, paddle);
    steps(world, 20);
    expect(paddle.getPosition()).toEqual([-0.074, -1.19]);
    expect(paddle.getRotation()).not.toBe(0);
  });
});

describe('a bar of 20 km that turns', () => {
  it('does not stop what flies along it, a millimetre away', () => {
    for (const type of ['kinematic', 'dynamic'] as const) {
      const world = weightless();
      const bar = phys2D.createRigidBody({ type, shapes: [box(20_000, 0.2)], angularVelocity: 0.5, ...FREE });
      const ball = phys2D.createRigidBody({
        shapes: [disc(0.5)],
        position: [100, 0.601],
        velocity: [-400, 50],
        bullet: true,
        ...FREE,
      });
      add(world, bar, ball);
      for (let i = 1; i <= 10; i += 1) {
        steps(world, 1);
        near(ball.getPosition()[0]!, 100 - (400 * i) / 60, 0.01);
      }
    }
  });
});

describe('changes of type', () => {
  it('what is no longer solid for each other passes, what becomes so does not [D-43]', () => {
    const world = weightless();
    const wall = phys2D.createRigidBody({ type: 'static', position: [5, 0], shapes: [box(0.02, 20)] });
    const shot = plainBody({ shapes: [disc(0.25)], velocity: [FAST, 0] });
    add(world, wall, shot);
    steps(world, 3);
    near(shot.getPosition()[0], 4.74, 0.01);
    shot.setAsKinematic();
    shot.setVelocity([FAST, 0]);
    steps(world, 1);
    near(shot.getPosition()[0], 6.74, 0.01);
    shot.setVelocity([-FAST, 0]);
    shot.setAsDynamic();
    steps(world, 3);
    near(shot.getPosition()[0], 5.26, 0.01);
    wall.setAsDynamic();
    shot.setPosition([0, 0]);
    shot.setVelocity([FAST, 0]);
    steps(world, 5);
    near(shot.getPosition()[0], 10, 0.01);
    shot.setPosition([0, 0]);
    wall.setAsKinematic();
    wall.setPosition([5, 0]);
    wall.setVelocity([0, 0]);
    steps(world, 5);
    near(shot.getPosition()[0], 4.74, 0.01);
  });
});
