import { describe, expect, it } from 'vitest';
import { type Material, phys2D, type RigidBody, type Shape } from '../../src/index.js';
import { add, box, DT } from '../conformance/setting.js';

// Small things come fast along a floor to the end of a thick wall that stands on it, or hang at walls that could move, but do not.

function rectangle(x1: number, y1: number, x2: number, y2: number, material: Material): Shape {
  return phys2D.createPolygonShape({ vertices: phys2D.createRectangleVertices(x1, y1, x2, y2), material });
}

const things: Record<string, [number, (material: Material) => Shape]> = {
  'a marble of 4 cm': [0.04, (material) => phys2D.createCircleShape({ radius: 0.02, material })],
  'a box of 5 cm': [0.05, (material) => box(0.05, 0.05, { material })],
  'a plank of 5 cm': [0.05, (material) => box(1.5, 0.05, { material })],
};

describe.each([0.3, 0.01, 0])('of elasticity %d', (elasticity) => {
  it.each(Object.keys(things))('%s does not slip into the foot of a wall', (name) => {
    const [height, make] = things[name]!;
    for (const isAsked of [false, true]) {
      for (let speed = 1; speed <= 30; speed += 0.5) {
        const friction = isAsked ? 0 : 1;
        const material = phys2D.createMaterial({ elasticity, staticFriction: friction, dynamicFriction: friction });
        const world = phys2D.createWorld();
        const wall = rectangle(5, -5, 5.5, 0, material);
        if (isAsked) wall.addEventListener('preSolve', () => {});
        for (const shape of [rectangle(-20, 0, 10, 1, material), wall]) {
          add(world, phys2D.createRigidBody({ type: 'static', shapes: [shape] }));
        }
        const shapes = [make(material)];
        const still = { linearDrag: 0, angularDrag: 0 };
        const body = phys2D.createRigidBody({ position: [2, -height / 2], velocity: [speed, 0], shapes, ...still });
        add(world, body);
        for (let i = 0; i < 200; i += 1) {
          world.step(DT);
          // Three quarters of its thickness is what an impact may be deep.
          expect(body.computeWorldBounds()[2] - 5).toBeLessThan(0.8 * height);
        }
      }
    }
  });
});

it.each(['static', 'kinematic'] as const)('nothing hangs in the air beside %s walls that stand still', (type) => {
  const material = phys2D.createMaterial({ staticFriction: 0, dynamicFriction: 0, elasticity: 0.3 });
  const flying = (spin: number, x: number): RigidBody => {
    const world = phys2D.createWorld();
    const shapes = [rectangle(-5.1, -5.1, 500, -5, material), rectangle(-5.1, -5, -5, 500, material)];
    add(world, phys2D.createRigidBody({ type, shapes }));
    // 5 cm deep in the ceiling, on its way off it and towards a wall.
    const body = phys2D.createRigidBody({
      position: [x, -4.808],
      rotation: 2.737,
      velocity: [-27.47, 8.2],
      angularVelocity: spin,
      shapes: [box(0.402, 0.355, { material })],
    });
    add(world, body);
    for (let i = 0; i < 30; i += 1) world.step(1 / 30);
    return body;
  };
  for (let spin = -150; spin <= 150; spin += 30) {
    for (let x = -4.7; x < -3.9; x += 0.1) {
      expect(flying(spin, x).getPosition()[1]).toBeGreaterThan(0);
    }
  }
});
