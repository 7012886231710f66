import { describe, expect, it } from 'vitest';
import { phys2D, type RigidBody, type Shape, type Vec2 } from '../../src/index.js';
import { add, box, disc, staticBody, steps, weightless } from '../conformance/setting.js';

// What bounces, or has a handler that is asked first, is not foreseen: it is stopped all the same where it only grazes something, and gets no deeper into it than what is.

const PHASES = 100;
const FREE = { linearDrag: 0, angularDrag: 0 };

function elastic(elasticity: number) {
  return phys2D.createMaterial({ elasticity, staticFriction: 0, dynamicFriction: 0, rollingFriction: 0 });
}

function shoot(shape: Shape, position: Vec2, speed: number, more = {}): RigidBody {
  return phys2D.createRigidBody({ shapes: [shape], position, velocity: [speed, 0], ...FREE, ...more });
}

/** How many of a hundred discs, each at another part of a step from it, come through a gap in a wall. */
function countThrough(radius: number, gap: number, speed: number, make: () => Shape): number {
  const world = weightless();
  const shots: RigidBody[] = [];
  for (let k = 0; k < PHASES; k += 1) {
    const y = 6 * k;
    for (const [top, bottom] of [
      [y - 2.5, y - gap / 2],
      [y + gap / 2, y + 2.5],
    ] as const) {
      const vertices = phys2D.createRectangleVertices(0, top, 0.1, bottom);
      add(world, staticBody({ shapes: [phys2D.createPolygonShape({ vertices, material: elastic(0) })] }));
    }
    shots.push(shoot(make(), [-speed * (0.3 + k / (60 * PHASES)), y], speed));
    add(world, shots[k]!);
  }
  steps(world, 36);
  return shots.filter((shot) => shot.getPosition()[0] > 0.2 + radius).length;
}

describe.each([5, 10, 20, 60])('at %f m/s', (speed) => {
  it.each([
    [0.25, 0.42],
    [0.05, 0.08],
    [0.03, 0.04],
  ])('no disc of radius %f m that bounces comes through a gap of %f m', (radius, gap) => {
    expect(countThrough(radius, gap, speed, () => disc(radius, { material: elastic(0.2) }))).toBe(0);
  });

  it('nor one whose handler is asked', () => {
    const make = () => {
      const shape = disc(0.25, { material: elastic(0) });
      shape.addEventListener('preSolve', () => {});
      return shape;
    };
    expect(countThrough(0.25, 0.42, speed, make)).toBe(0);
  });

  it.each([
    ['a static disc', 'static', false],
    ['a disc that moves, as bullets', 'dynamic', true],
  ] as const)('discs that graze %s by 1 to 4.5 cm are turned by it', (_, type, bullet) => {
    for (const depth of [0.01, 0.03, 0.045]) {
      const world = weightless();
      const shots: RigidBody[] = [];
      for (let k = 0; k < PHASES; k += 1) {
        const shapes = [disc(0.25, { material: elastic(1) })];
        add(world, phys2D.createRigidBody({ type, shapes, position: [0, 6 * k], ...FREE }));
        const position: Vec2 = [-speed * (0.2 + k / (60 * PHASES)), 6 * k - 0.5 + depth];
        shots.push(shoot(disc(0.25, { material: elastic(1) }), position, speed, { bullet }));
        add(world, shots[k]!);
      }
      steps(world, 24);
      expect(shots.filter((shot) => Math.abs(shot.getVelocity()[1]) < 0.02 * speed).length, `${depth} m`).toBe(0);
    }
  });
});

it.each([4, 10, 60])('a ball of 5 cm that bounces at %f m/s gets no more than 1 cm into the floor', (speed) => {
  let deepest = 0;
  for (let k = 0; k < PHASES; k += 1) {
    const world = weightless();
    add(world, staticBody({ shapes: [box(2, 2)], position: [1, 0] }));
    const ball = shoot(disc(0.05, { material: elastic(0.5) }), [-0.05 - speed * (0.1 + k / (60 * PHASES)), 0], speed);
    add(world, ball);
    for (let i = 0; i < 12; i += 1) {
      world.step(1 / 60);
      deepest = Math.max(deepest, ball.getPosition()[0] + 0.05);
    }
  }
  expect(deepest).toBeLessThan(0.01);
});

describe('what bounces, and passes by without touching, flies on', () => {
  it.each([
    [0.25, 3, 0.001],
    [0.25, 10, 0.01],
    [0.03, 3, 0.005],
    [0.03, 10, 0.01],
  ])('balls of %f m at %f m/s, %f m from a ball, or the edge of a wall', (radius, speed, gap) => {
    const material = elastic(0.5);
    const edge = () => phys2D.createPolygonShape({ vertices: phys2D.createBoxVertices(0.04, 2 * radius), material });
    for (const make of [() => disc(radius, { material }), edge]) {
      const world = weightless();
      const shots: RigidBody[] = [];
      for (let k = 0; k < PHASES; k += 1) {
        add(world, staticBody({ shapes: [make()], position: [0, 5 * k] }));
        const position: Vec2 = [-speed * (0.3 + k / (60 * PHASES)), 5 * k - 2 * radius - gap];
        shots.push(shoot(disc(radius, { material }), position, speed));
        add(world, shots[k]!);
      }
      steps(world, 36);
      const off = shots.filter(
        (shot) => Math.hypot(shot.getVelocity()[0] - speed, shot.getVelocity()[1]) > 1e-9 * speed,
      );
      expect(off).toHaveLength(0);
    }
  });
});

describe.each([0.5, 0.9, 0.98])('a ball that is cut by a bullet, off the centre by %f of its width,', (share) => {
  it.each([
    [0.0285, 1],
    [0.0285, 3],
    [0.0285, 8],
    [0.0285, 30],
    [0.1, 8],
    [0.25, 5],
    [0.25, 15],
  ])('of %f m at %f m/s, leaves along the line of centres', (radius, speed) => {
    const material = elastic(1);
    const world = weightless();
    const balls: RigidBody[] = [];
    for (let k = 0; k < PHASES; k += 1) {
      balls.push(phys2D.createRigidBody({ shapes: [disc(radius, { material })], position: [0, 5 * k], ...FREE }));
      const position: Vec2 = [-speed * (0.3 + k / (60 * PHASES)), 5 * k + 2 * share * radius];
      add(world, balls[k]!, shoot(disc(radius, { material }), position, speed, { bullet: true }));
    }
    steps(world, 40);
    for (const ball of balls) {
      const [vx, vy] = ball.getVelocity();
      expect(Math.hypot(vx, vy)).toBeGreaterThan(0);
      expect(Math.abs(Math.atan2(vy, vx) + Math.asin(share))).toBeLessThan(0.025);
    }
  });
});
