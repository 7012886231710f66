import { describe, expect, it } from 'vitest';
import { phys2D, type RigidBody, type Shape, type Vec2, type World } from '../../src/index.js';
import { add, disc, heavy } from '../conformance/setting.js';

// Nothing catches on the joints of tiles, whether these stand still or move, as one body or each as its own, also where what slides goes far in a step.

const FREE = { linearDrag: 0, angularDrag: 0 };

const material = phys2D.createMaterial({ staticFriction: 0, dynamicFriction: 0, rollingFriction: 0 });

const rectangle = (left: number, right: number) =>
  phys2D.createPolygonShape({ vertices: phys2D.createRectangleVertices(left, 0, right, 1), material });

const tiles = (from: number, to: number) =>
  Array.from({ length: to - from }, (_, i) => rectangle(from + i, from + i + 1));

const slider = (kind: string, size: number): Shape =>
  kind === 'disc'
    ? disc(size / 2, { material })
    : phys2D.createPolygonShape({ vertices: phys2D.createBoxVertices(size, size), material });

function addSlider(world: World, shape: Shape, size: number, x: number, velocity: Vec2): RigidBody {
  const body = phys2D.createRigidBody({ shapes: [shape], position: [x, -size / 2], velocity, ...FREE });
  add(world, body);
  return body;
}

describe.each([
  ['still', 0, 0],
  ['that creep', 0.05, 0],
  ['of a train', 4, 0],
  ['of a train that comes', -3, 0],
  ['of a lift up', 0, -2],
  ['of a lift down', 0, 1],
  ['that go aslant', 1, -1],
])('tiles %s', (_, vx, vy) => {
  it.each([
    ['one body', true],
    ['a body each', false],
  ])('%s', (_name, isOne) => {
    for (const rate of [30, 60]) {
      for (const speed of [3, 8, 20, 60]) {
        for (const kind of ['box', 'disc']) {
          for (const size of [0.2, 0.6, 2]) {
            const world = heavy();
            const end = Math.ceil(Math.abs(speed - vx)) + 10;
            for (const shapes of isOne ? [tiles(-10, end)] : tiles(-10, end).map((tile) => [tile])) {
              add(world, phys2D.createRigidBody({ type: 'kinematic', velocity: [vx, vy], shapes }));
            }
            const body = addSlider(world, slider(kind, size), size, 0, [speed, vy]);
            let highest = 0;
            for (let i = 1; i <= rate; i += 1) {
              world.step(1 / rate);
              highest = Math.max(highest, (vy * i) / rate - size / 2 - body.getPosition()[1]);
            }
            const what = `${kind} of ${size} m at ${speed} m/s, ${rate} steps a second`;
            expect(highest, what).toBeLessThan(0.01);
            expect(body.getVelocity()[0] / speed, what).toBeCloseTo(1, 6);
          }
        }
      }
    }
  });
});

it.each([0.05, 0.3, -0.3])(
  'tiles of a floor that turns at %f rad/s carry as a floor of one piece',
  (angularVelocity) => {
    for (const rate of [30, 60]) {
      for (const speed of [3, 8, 20]) {
        for (const size of [0.6, 2]) {
          for (const kind of ['box', 'disc']) {
            const [tiled, whole] = [tiles(-30, 30), [rectangle(-30, 30)]].map((shapes) => {
              const world = heavy();
              add(world, phys2D.createRigidBody({ type: 'kinematic', angularVelocity, shapes }));
              const velocity: Vec2 = [speed, -3.3 * angularVelocity];
              const body = addSlider(world, slider(kind, size), size, -3.3, velocity);
              for (let i = 0; i < rate / 2; i += 1) {
                world.step(1 / rate);
              }
              return body.getPosition();
            });
            const apart = Math.hypot(tiled![0] - whole![0], tiled![1] - whole![1]);
            expect(apart, `${kind} of ${size} m at ${speed} m/s, ${rate} steps a second`).toBeLessThan(0.05);
          }
        }
      }
    }
  },
);

it('tiles that are sent to places each step, by velocities that differ by rounding', () => {
  for (const rate of [30, 60]) {
    for (let start = 0; start < 1; start += 0.13) {
      const world = heavy();
      const cars = Array.from({ length: 20 }, (_, i) => {
        const shapes = [phys2D.createPolygonShape({ vertices: phys2D.createBoxVertices(1.3, 1), material })];
        const car = phys2D.createRigidBody({ type: 'kinematic', position: [1.3 * i - 3 + start, 0.5], shapes });
        add(world, car);
        return car;
      });
      const body = addSlider(world, slider('box', 0.6), 0.6, 0, [15, 0]);
      for (let i = 1; i <= rate; i += 1) {
        cars.forEach((car, k) => {
          car.setVelocityFromPosition([1.3 * k - 3 + start + (3 * i) / rate, 0.5], 0, 1 / rate);
        });
        world.step(1 / rate);
        expect(-0.3 - body.getPosition()[1], `from ${start}, step ${i}, ${rate} a second`).toBeLessThan(0.01);
      }
    }
  }
});

it('bodies that go side by side go on so, whatever falls on them', () => {
  const velocity: Vec2 = [6, -1];
  for (const elasticity of [0, 0.5]) {
    const world = heavy();
    const rubber = phys2D.createMaterial({ elasticity });
    const cars = Array.from({ length: 10 }, (_, i) => {
      const shapes = [phys2D.createPolygonShape({ vertices: phys2D.createBoxVertices(2, 1), material: rubber })];
      const car = phys2D.createRigidBody({ type: 'kinematic', position: [2 * i, 0], velocity, shapes });
      add(world, car);
      return car;
    });
    for (let i = 0; i < 60; i += 1) {
      const shapes = [disc(0.3, { material: rubber })];
      add(world, phys2D.createRigidBody({ shapes, position: [0.3 * i, -2 - (i % 7)], velocity: [6, 20] }));
    }
    for (let i = 1; i <= 120; i += 1) {
      world.step(1 / 60);
      cars.forEach((car, k) => {
        const [x, y] = car.getPosition();
        expect(Math.hypot(x - 2 * k - (6 * i) / 60, y + i / 60), `car ${k}, step ${i}`).toBeLessThan(1e-9);
      });
    }
  }
});
