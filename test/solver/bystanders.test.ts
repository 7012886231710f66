import { describe, expect, it } from 'vitest';
import { phys2D, type RigidBody, type Vec2, type World } from '../../src/index.js';
import { generator } from '../scenes/mixed.js';

// What has nothing to do with the others changes nothing for them, though it decides what of them has to be looked at.

/** Things that fly about in a room with pillars; most so fast that they would pass thin walls. @returns where they are after 3 s. */
function fly(elasticity: number, bystand: (world: World) => void): Vec2[] {
  const world = phys2D.createWorld({ gravity: [0, 10], allowSleeping: false });
  const material = phys2D.createMaterial({ elasticity });
  const add = (width: number, height: number, params: object): RigidBody => {
    const vertices = phys2D.createBoxVertices(width, height);
    const body = phys2D.createRigidBody({ ...params, shapes: [phys2D.createPolygonShape({ vertices, material })] });
    world.addRigidBody(body);
    return body;
  };
  for (const [x, y, width, height] of [
    [0, -10, 20, 0.1],
    [0, 10, 20, 0.1],
    [-10, 0, 0.1, 20],
    [10, 0, 0.1, 20],
    [-4, 0, 0.1, 8],
    [4, 0, 0.1, 8],
  ] as const) {
    add(width, height, { type: 'static', position: [x, y] });
  }
  const random = generator(9);
  const between = (least: number, most: number): number => least + (most - least) * random();
  const bodies = Array.from({ length: 40 }, () =>
    add(0.3, 0.3, {
      position: [between(-3, 3), between(-9, 9)],
      velocity: [between(-60, 60), between(-60, 60)],
      angularVelocity: between(-5, 5),
    }),
  );
  bystand(world);
  for (let i = 0; i < 180; i += 1) {
    world.step(1 / 60);
  }
  return bodies.map((body) => body.getPosition());
}

describe.each([0, 0.8])('of elasticity %d', (elasticity) => {
  const alone = fly(elasticity, () => {});

  it('nothing leaves the room', () => {
    expect(alone.filter(([x, y]) => Math.abs(x) > 10 || Math.abs(y) > 10)).toEqual([]);
  });

  it.each<[string, (world: World) => void]>([
    [
      'a zone around all of them',
      (world) => {
        const zone = phys2D.createPolygonShape({ vertices: phys2D.createBoxVertices(50, 50), sensor: true });
        world.addRigidBody(phys2D.createRigidBody({ type: 'static', shapes: [zone] }));
      },
    ],
    [
      'a bullet far away',
      (world) => {
        const shapes = [phys2D.createCircleShape({ radius: 0.1 })];
        world.addRigidBody(phys2D.createRigidBody({ bullet: true, position: [1e3, 0], velocity: [200, 0], shapes }));
      },
    ],
    [
      'a platform that moves far away',
      (world) => {
        const shapes = [phys2D.createPolygonShape({ vertices: phys2D.createBoxVertices(500, 1) })];
        const position = [0, 1e3];
        world.addRigidBody(phys2D.createRigidBody({ type: 'kinematic', position, velocity: [9, 0], shapes }));
      },
    ],
  ])('%s changes nothing', (_, bystand) => {
    expect(fly(elasticity, bystand)).toEqual(alone);
  });
});
