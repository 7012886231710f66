import { describe, expect, it } from 'vitest';
import { phys2D, type RigidBody, type Shape, type World } from '../../src/index.js';
import { add, box, disc, staticBody, steps, tie, weightless } from '../conformance/setting.js';

// What is small gets neither through the joint of tiles that lie flush, of which neither would be entered deeply, nor out of the corner that some make; nor what is jointed through a wall.

function tiles(...rectangles: readonly (readonly [number, number, number, number])[]): RigidBody {
  const shapes = rectangles.map(([left, top, right, bottom]) =>
    phys2D.createPolygonShape({ vertices: phys2D.createRectangleVertices(left, top, right, bottom) }),
  );
  return staticBody({ shapes });
}

function shoot(
  world: World,
  shape: Shape,
  position: [number, number],
  velocity: [number, number],
  spin = 0,
): RigidBody {
  const free = { linearDrag: 0, angularDrag: 0 };
  const body = phys2D.createRigidBody({ shapes: [shape], position, velocity, angularVelocity: spin, ...free });
  add(world, body);
  return body;
}

describe('a wall of two tiles', () => {
  it.each([
    [0.1, 0.01],
    [0.3, 0.02],
    [0.1, 0.05],
    [0.05, 0.005],
    [0.03, 0.03],
  ])('rods of %f × %f m, turning by up to 14 rad/s', (length, height) => {
    for (const spin of [0, 5, 14]) {
      for (let speed = 50; speed < 400; speed += 35) {
        for (let y = -0.3; y <= 0.3; y += 0.04) {
          for (const slope of [0, 0.15, 0.5]) {
            const world = weightless();
            add(world, tiles([0, -2, 0.387, 0], [0, 0, 0.387, 2]));
            const rod = shoot(world, box(length, height), [-1.5, y], [speed, slope * speed], spin);
            steps(world, 4);
            expect(rod.getPosition()[0], `${speed} m/s, ${slope}, from ${y}, ${spin} rad/s`).toBeLessThan(0.387);
          }
        }
      }
    }
  });
});

describe('a corner of three tiles', () => {
  it.each([0.005, 0.01, 0.02, 0.05])('balls of radius %f m', (radius) => {
    for (let speed = 10; speed <= 160; speed += 3) {
      for (let slope = 0.9; slope < 1.1; slope += 0.02) {
        const world = weightless();
        add(world, tiles([-1, 0, 0, 1], [0, 0, 1, 1], [-1, -1, 0, 0]));
        const ball = shoot(world, disc(radius), [0.5, -0.5], [-speed, speed * slope]);
        steps(world, 60);
        const [x, y] = ball.getPosition();
        expect(x > -0.5 && y < 0.5, `${speed} m/s, ${slope}: ${x}, ${y}`).toBe(true);
      }
    }
  });
});

describe('a room of eight walls that overlap', () => {
  it.each([0.04, 0.06, 0.1])('two balls of %f m joined to each other, which bounce', (size) => {
    const material = phys2D.createMaterial({ elasticity: 1, staticFriction: 0, dynamicFriction: 0 });
    for (let speed = 10; speed < 300; speed += 51) {
      for (let direction = 0; direction < 6.2; direction += 0.42) {
        const world = weightless();
        for (let i = 0; i < 8; i += 1) {
          const angle = (Math.PI * i) / 4;
          const wall = box(0.2, 4.4 * Math.tan(Math.PI / 8), { material });
          add(
            world,
            staticBody({ shapes: [wall], rotation: angle, position: [2.1 * Math.cos(angle), 2.1 * Math.sin(angle)] }),
          );
        }
        const velocity: [number, number] = [speed * Math.cos(direction), speed * Math.sin(direction)];
        const pair = [0, -0.9 * size].map((x) => shoot(world, disc(size / 2, { material }), [x, 0], velocity));
        const [bodyA, bodyB] = [pair[0]!, pair[1]!];
        const anchorA: [number, number] = [-0.45 * size, 0];
        tie(
          world,
          phys2D.createPointConstraint({ bodyA, bodyB, anchorA, anchorB: [0.45 * size, 0], ignoreInteractions: true }),
        );
        steps(world, 120);
        for (const body of pair) {
          expect(Math.hypot(...body.getPosition()), `${speed} m/s, ${direction}`).toBeLessThan(2.3);
        }
      }
    }
  });
});

describe('a crate in the corner of a room of tiles, a ledge beside it whose underside is about as high as its top', () => {
  it.each([0.7, 0.9, 0.99, 1])('lies on the floor (%f m)', (size) => {
    for (const side of [1, -1]) {
      for (const turn of [1e-12, 1e-6, 1e-3]) {
        for (const above of [-0.002, 0.002, 0.005, 0.015]) {
          for (const away of [0.001, 0.3]) {
            const world = phys2D.createWorld();
            // Corner, floor and wall, whose face is at 0; and the ledge.
            for (const [x, y] of [
              [-1, 0],
              [0, 0],
              [-1, -1],
              [size + away, -size - 1 - above],
            ] as const) {
              add(world, tiles(side > 0 ? [x, y, x + 1, y + 1] : [-x - 1, y, -x, y + 1]));
            }
            const crate = phys2D.createRigidBody({
              shapes: [box(size, size)],
              position: [side * (size / 2 + 0.0005), 0.003 - size / 2],
              rotation: side * turn,
            });
            add(world, crate);
            steps(world, 10);
            const [x, y] = crate.getPosition();
            const where = `side ${side}, turned ${turn}, ledge ${above} above, ${away} away: ${x}, ${y}`;
            expect(Math.abs(y + size / 2), where).toBeLessThan(0.01);
            expect(Math.abs(side * x - size / 2), where).toBeLessThan(0.02);
          }
        }
      }
    }
  });
});
