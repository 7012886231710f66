import { describe, expect, it } from 'vitest';
import { type Material, phys2D, type RigidBody, type World } from '../../src/index.js';
import { add, box, heavy, near, staticBody, steps } from '../conformance/setting.js';

// What falls flat on several things at once comes to all of them at once: solved one after the other, the first would throw it over.

type Rectangle = readonly [left: number, top: number, right: number, bottom: number];

function rectangle([left, top, right, bottom]: Rectangle, material: Material) {
  return phys2D.createPolygonShape({ vertices: phys2D.createRectangleVertices(left, top, right, bottom), material });
}

const speeds = [3, 5, 10, 20, 40];
const elasticities = [0, 0.5, 1];
const substeps = [1, 2, 4];

/** Lets a body fall 0.3 m onto the ground, whose top is at 0, at each of the speeds and so on. */
function forEachFall(fall: (world: World, material: Material, speed: number) => RigidBody, name: string): RigidBody[] {
  const bodies: RigidBody[] = [];
  for (const speed of speeds) {
    for (const elasticity of elasticities) {
      for (const count of substeps) {
        const world = heavy({ substeps: count });
        const friction = { staticFriction: 2, dynamicFriction: 1 };
        const body = fall(world, phys2D.createMaterial({ elasticity, ...friction }), speed);
        steps(world, 6);
        expect(Math.abs(body.getAngularVelocity()), `${name} at ${speed} m/s, ${elasticity}, ${count}`).toBeLessThan(
          0.02,
        );
        expect(Math.abs(body.getVelocity()[0])).toBeLessThan(0.1);
        bodies.push(body);
      }
    }
  }
  return bodies;
}

describe('what falls flat does not turn', () => {
  const floors: readonly [string, readonly Rectangle[]][] = [
    [
      'two tiles',
      [
        [-2, 0, 0, 1],
        [0, 0, 2, 1],
      ],
    ],
    [
      'two tiles, the right one made first',
      [
        [0, 0, 2, 1],
        [-2, 0, 0, 1],
      ],
    ],
    ['five tiles', [-2, -0.3, -0.1, 0.1, 0.3].map((left, i, all): Rectangle => [left, 0, all[i + 1] ?? 2, 1])],
  ];

  it.each(floors)('a box on %s, which goes on as from one slab', (name, tiles) => {
    const drop = (rectangles: readonly Rectangle[], x: number) =>
      forEachFall((world, material, speed) => {
        for (const each of rectangles) {
          add(world, staticBody({ shapes: [rectangle(each, material)] }));
        }
        const body = phys2D.createRigidBody({
          position: [x, -0.8],
          velocity: [0, speed],
          shapes: [box(1, 1, { material })],
        });
        add(world, body);
        return body;
      }, name);
    for (const x of [-0.25, 0.25, 0.4]) {
      const onSlab = drop([[-2, 0, 2, 1]], x);
      drop(tiles, x).forEach((body, i) => {
        near(body.getVelocity()[1], onSlab[i]!.getVelocity()[1], 0.02);
      });
    }
  });

  it('a plank on two posts', () => {
    forEachFall((world, material, speed) => {
      const posts = [rectangle([-1.5, 0, -0.5, 1], material), rectangle([0.5, 0, 1.5, 1], material)];
      add(world, staticBody({ shapes: posts }));
      const plank = phys2D.createRigidBody({
        position: [0, -0.55],
        velocity: [0, speed],
        shapes: [box(4, 0.5, { material })],
      });
      add(world, plank);
      return plank;
    }, 'plank');
  });

  it('a table of one body on its legs', () => {
    forEachFall((world, material, speed) => {
      add(world, staticBody({ shapes: [rectangle([-9, 0, 9, 1], material)] }));
      const parts: Rectangle[] = [
        [-1, -0.5, -0.8, 0.5],
        [0.8, -0.5, 1, 0.5],
        [-1, -0.6, 1, -0.5],
      ];
      const shapes = parts.map((part) => rectangle(part, material));
      const table = phys2D.createRigidBody({ position: [0, -0.8], velocity: [0, speed], shapes });
      table.alignWithOrigin();
      add(world, table);
      return table;
    }, 'table');
  });

  it('a cart of one body on its wheels', () => {
    forEachFall((world, material, speed) => {
      add(world, staticBody({ shapes: [rectangle([-9, 0, 9, 1], material)] }));
      const wheels = [-0.8, 0.8].map((x) => phys2D.createCircleShape({ radius: 0.25, origin: [x, 0.25], material }));
      const shapes = [...wheels, rectangle([-1, -0.3, 1, 0.1], material)];
      const cart = phys2D.createRigidBody({ position: [0, -0.8], velocity: [0, speed], shapes });
      cart.alignWithOrigin();
      add(world, cart);
      return cart;
    }, 'cart');
  });

  it('a bullet on two boxes that lie side by side', () => {
    for (const speed of speeds) {
      const world = heavy();
      const material = phys2D.createMaterial({ elasticity: 0.5 });
      add(world, staticBody({ shapes: [rectangle([-9, 0, 9, 1], material)] }));
      const boxes = [-0.5, 0.5].map((x) => phys2D.createRigidBody({ position: [x, -0.5], shapes: [box(1, 1)] }));
      const shot = phys2D.createRigidBody({
        position: [0, -2.5],
        velocity: [0, speed],
        bullet: true,
        shapes: [box(1, 1, { material })],
      });
      add(world, ...boxes, shot);
      for (let i = 0; i < 20; i += 1) {
        steps(world, 1);
        expect(Math.abs(shot.getAngularVelocity()), `${speed} m/s`).toBeLessThan(0.5);
      }
    }
  });
});
