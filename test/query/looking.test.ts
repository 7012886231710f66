import { describe, expect, it } from 'vitest';
import { phys2D, type RigidBody, type RigidBodyParams, type Shape, type World } from '../../src/index.js';
import { generator } from '../scenes/mixed.js';

// Who looks changes nothing, and sees what is there: also in the middle of a step, where the solver has shapes elsewhere than their bodies are.

const utils = phys2D.createCollisionUtils();

type Look = (body: RigidBody, world: World) => unknown;

/** What is done in `preSolve` handlers, some of which are called where fast bodies meet. */
const LOOKS: Record<string, Look> = {
  computeWorldBounds: (body) => body.computeWorldBounds(),
  containsPoint: ({ shapes }) => utils.containsPoint(shapes[0]!, [0, 0]),
  rayTest: ({ shapes }) => utils.rayTest(shapes[0]!, { origin: [0, 0], direction: [0, 1], maxFactor: 9 }, []),
  intersects: ({ shapes }, { rigidBodies }) => utils.intersects(shapes[0]!, rigidBodies[0]!.shapes[0]!),
  sweepTest: ({ shapes }, { rigidBodies }) => utils.sweepTest(shapes[0]!, rigidBodies[0]!.shapes[0]!, 1, [], []),
  convexCast: ({ shapes }, world) => world.convexCast(shapes[0]!, 1),
  shapeQuery: ({ shapes }, world) => world.shapeQuery(shapes[0]!, []),
  rayCast: (_, world) => world.rayCast({ origin: [0, 0], direction: [0, 1], maxFactor: 9 }),
};

/** A bullet between a kinematic ball and a box, each of which throws it at the other. */
function hashAfter(look: Look | null): string {
  const world = phys2D.createWorld();
  const material = phys2D.createMaterial({ elasticity: 1 });
  const hexagon = (width: number, height: number) =>
    phys2D.createPolygonShape({ vertices: phys2D.createRegularPolygonVertices(width, height, 6), material });
  const add = (shape: Shape, params: RigidBodyParams) => {
    world.addRigidBody(phys2D.createRigidBody({ ...params, shapes: [shape] }));
  };
  add(phys2D.createPolygonShape({ vertices: phys2D.createRectangleVertices(-6.2501, -8.7536, 3.5281, 2.5223) }), {
    type: 'static',
  });
  add(phys2D.createCircleShape({ radius: 0.3608, origin: [-0.4321, 0], material }), {
    type: 'kinematic',
    position: [-0.1384, -3.5455],
    velocity: [2.3245, -16.9837],
  });
  add(hexagon(0.5128, 0.69374), { bullet: true, position: [-0.9843, -3.1867], velocity: [-69.8677, -19.8248] });
  add(hexagon(0.6888, 0.41546), { position: [-1.0884, -3.1003], velocity: [35.8664, -22.8443] });
  let asked = 0;
  for (const { shapes } of world.rigidBodies.slice(1)) {
    shapes[0]!.addEventListener(
      'preSolve',
      () => {
        asked += 1;
        for (const body of world.rigidBodies) {
          look?.(body, world);
        }
      },
      undefined,
      true,
    );
  }
  for (let i = 0; i < 3; i += 1) {
    world.step(1 / 60);
  }
  expect(asked).toBeGreaterThan(3);
  return world.hash();
}

describe('in the middle of a step', () => {
  it.each(Object.keys(LOOKS))('%s changes nothing', (name) => {
    expect(hashAfter(LOOKS[name]!)).toBe(hashAfter(null));
  });

  it('callbacks of constraints see shapes where the bodies are', () => {
    const world = phys2D.createWorld({ gravity: [0, 0] });
    const circle = phys2D.createCircleShape({ radius: 0.1, origin: [1, 0] });
    const body = phys2D.createRigidBody({
      shapes: [circle],
      velocity: [6, 0],
      angularVelocity: 20,
      mass: 1,
      inertia: 1,
    });
    world.addRigidBody(body);
    const seen: number[] = [];
    world.addConstraint(
      phys2D.createCustomConstraint({
        bodies: [body],
        dimension: 1,
        position(data, i) {
          const [x, y] = body.transformLocalPointToWorld([1, 0]);
          const [minX, minY, maxX, maxY] = body.computeWorldBounds();
          seen.push(Math.abs((minX + maxX) / 2 - x), Math.abs((minY + maxY) / 2 - y));
          seen.push(utils.containsPoint(circle, [x, y]) ? 0 : 1);
          data[i] = 0;
        },
        jacobian(data, i) {
          for (let k = i; k < i + 3; k += 1) {
            data[k] = 0;
          }
        },
      }),
    );
    world.step(1 / 60);
    expect(seen.length).toBeGreaterThan(3);
    expect(Math.max(...seen)).toBeLessThan(1e-12);
  });
});

describe('geometry', () => {
  it('of a circle keeps its radius through any number of turns', () => {
    const circle = phys2D.createCircleShape({ radius: 0.7, origin: [1, 2] });
    for (let i = 0; i < 1000; i += 1) {
      circle.rotate(i);
    }
    expect(circle.getRadius()).toBe(0.7);
  });

  it('of a polygon that was stretched flat can be cloned', () => {
    const vertices = phys2D.createRegularPolygonVertices(1, 1, 64);
    const polygon = phys2D.createPolygonShape({ vertices });
    polygon.rotate(0.3);
    polygon.scale(1, 1e-8);
    const { length } = polygon.vertices;
    expect(length).toBe(128);
    expect([...polygon.clone().vertices]).toEqual([...polygon.vertices]);
  });

  it('has unit normals where a ray from far away hits a circle', () => {
    const world = phys2D.createWorld();
    world.addRigidBody(
      phys2D.createRigidBody({ type: 'static', shapes: [phys2D.createCircleShape({ radius: 0.01 })] }),
    );
    for (const far of [1, 1e4, 1e7]) {
      const hit = world.rayCast({ origin: [0.004, -far], direction: [0, 1], maxFactor: 2 * far })!;
      expect(Math.hypot(...hit.hitNormal)).toBeCloseTo(1, 12);
    }
  });

  it('is met by sweeps from far away', () => {
    const random = generator(7);
    const shape = () => {
      const vertices = phys2D.createRegularPolygonVertices(
        0.2 + random(),
        0.2 + random(),
        3 + Math.floor(5 * random()),
      );
      return phys2D.createPolygonShape({ vertices });
    };
    let missed = 0;
    for (let i = 0; i < 300; i += 1) {
      const way = i % 2 === 0 ? 1e7 : 1e8;
      const one = phys2D.createRigidBody({ shapes: [shape()], rotation: 6 * random(), velocity: [way, 0] });
      const other = phys2D.createRigidBody({ shapes: [shape()], rotation: 6 * random(), position: [way, 0] });
      missed += utils.sweepTest(one.shapes[0]!, other.shapes[0]!, 2, [], []) === undefined ? 1 : 0;
    }
    expect(missed).toBe(0);
  });
});
