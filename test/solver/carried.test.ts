import { describe, expect, it } from 'vitest';
import { type Polygon, phys2D } from '../../src/index.js';
import { add, box, disc, heavy, speed, weightless } from '../conformance/setting.js';

describe('what lies on a kinematic platform that rocks', () => {
  const material = phys2D.createMaterial({ staticFriction: 1, dynamicFriction: 1 });
  const half = (x: number): Polygon => {
    const vertices = phys2D.createRectangleVertices(x - 0.1, -0.25, x + 0.1, 0.25);
    return phys2D.createPolygonShape({ vertices, material });
  };
  const kinds: readonly [string, () => Polygon[], number, number, number, number][] = [
    ['a box', () => [box(0.5, 0.5, { material })], 1, 2, 0.3, 0.5],
    ['a box of two shapes', () => [half(-0.15), half(0.15)], 1, 2, 0.25, 0.5],
    ['a stack of three', () => [box(0.5, 0.5, { material })], 3, 3, 0.3, 0.2],
  ];

  it.each(kinds)('%s stays where it lies for a minute', (_name, makeShapes, count, at, swing, frequency) => {
    const world = heavy();
    const platform = phys2D.createRigidBody({ type: 'kinematic', shapes: [box(8, 0.4, { material })] });
    const load = Array.from({ length: count }, (_, i) =>
      phys2D.createRigidBody({ position: [at, -0.45 - 0.5 * i], shapes: makeShapes() }),
    );
    add(world, platform, ...load);
    let angle = 0;
    for (let i = 1; i <= 3600; i += 1) {
      const next = (swing * (1 - Math.cos((2 * Math.PI * frequency * i) / 60))) / 2;
      platform.setAngularVelocity((next - angle) * 60);
      angle = next;
      world.step(1 / 60);
    }
    const [x] = platform.transformWorldPointToLocal(load[count - 1]!.getPosition());
    console.log(`on a platform that rocks, 60 s: off by ${(1000 * (x - at)).toFixed(1)} mm`);
    expect(Math.abs(x - at)).toBeLessThan(0.015);
  });
});

// What goes along with it follows its arc, by ω²·h/2 a sub-step. Where it turns by radians in a step, that is no arc any more: at 10⁵ rad/s
// things left with 100 times the speed of the drum.
it.each([100, 1e4, 1e5])('what lies in a drum that turns at %d rad/s gets no more than its speed', (rate) => {
  const world = weightless();
  const shapes = Array.from({ length: 24 }, (_, i) => {
    const angle = (i * Math.PI) / 12;
    const [cos, sin] = [Math.cos(angle), Math.sin(angle)];
    const corners = phys2D.createRectangleVertices(-0.25, 1.4, 0.25, 1.6);
    return phys2D.createPolygonShape({
      vertices: corners.map(([x, y]) => [x * cos - y * sin, x * sin + y * cos] as const),
    });
  });
  add(world, phys2D.createRigidBody({ type: 'kinematic', angularVelocity: rate, shapes }));
  const load = Array.from({ length: 8 }, (_, i) => {
    const angle = (i * Math.PI) / 4;
    const [x, y] = [1.25 * Math.cos(angle), 1.25 * Math.sin(angle)];
    return phys2D.createRigidBody({
      position: [x, y],
      rotation: angle,
      velocity: [-rate * y, rate * x],
      angularVelocity: rate,
      shapes: [i % 2 === 0 ? box(0.2, 0.2) : disc(0.1)],
    });
  });
  add(world, ...load);
  let most = 0;
  for (let i = 0; i < 120; i += 1) {
    world.step(1 / 60);
    most = Math.max(most, ...load.map((body) => speed(body) / (1.4 * rate)));
  }
  console.log(`in a drum at ${rate} rad/s: at most ${most.toFixed(2)} times its speed`);
  expect(most).toBeLessThan(1.5);
});
