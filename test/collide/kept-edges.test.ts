import { describe, expect, it } from 'vitest';
import { phys2D, type Vec2 } from '../../src/index.js';

// Edges that face each other are kept while shapes hardly move, but what is found has to be what it would be if they were chosen anew.

type Place = readonly [x: number, y: number, turn: number];

/** How deep B is in A as a step finds them, the last of some in which B is put somewhere, or 0; and how far they are from each other. */
function find(verticesA: readonly Vec2[], turnA: number, verticesB: readonly Vec2[], places: readonly Place[]) {
  const world = phys2D.createWorld({ gravity: [0, 0] });
  const utils = phys2D.createCollisionUtils();
  const shapeA = phys2D.createPolygonShape({ vertices: verticesA });
  const shapeB = phys2D.createPolygonShape({ vertices: verticesB });
  const body = phys2D.createRigidBody({ shapes: [shapeB] });
  world.addRigidBody(phys2D.createRigidBody({ type: 'static', rotation: turnA, shapes: [shapeA] }));
  world.addRigidBody(body);
  let depth = 0;
  shapeA.addEventListener('preSolve', (arbiter) => {
    arbiter.setAcceptedState(false);
    depth = Math.max(...arbiter.contacts.map((contact) => contact.getPenetration()));
  });
  let distance = 0;
  for (const [x, y, turn] of places) {
    depth = 0;
    body.setPosition([x, y]);
    body.setRotation(turn);
    distance = utils.signedDistance(shapeA, shapeB, [0, 0], [0, 0], [0, 0]);
    world.step(1 / 60);
  }
  return { depth, distance };
}

describe('edges that were kept', () => {
  it('tell nothing of an overlap where a corner of a large shape has moved away as it turned', () => {
    const a: Vec2[] = [
      [22.417109347879887, 31.974753756076097],
      [52.41710934787989, 4.977705213509264],
      [82.41710934787989, 31.974753756076097],
    ];
    const b: Vec2[] = [
      [-30, 0],
      [0, -10.991536103852331],
      [30, 0],
    ];
    const at = [-2.3505729176281447, -11.052066088661274] as const;
    const places: Place[] = [
      [...at, 0.613896959926933],
      [...at, 0.6122482947807061],
    ];
    const { depth, distance } = find(a, 2.9940658612176776, b, places);
    expect(distance).toBeGreaterThan(0.003);
    expect(depth).toBe(0);
  });

  it('do not hide an overlap beside them, of shapes with sides that are finely divided', () => {
    const side = [30, 60, 90, 120, 150].map((angle): Vec2 => {
      const [x, y] = [Math.cos((angle * Math.PI) / 180), Math.sin((angle * Math.PI) / 180)];
      return [0.02 * x, 2e-7 * y];
    });
    const a: Vec2[] = [[-0.02, 0], [0, -0.009625765379960497], [0.02, 0], ...side];
    const b: Vec2[] = [
      [-0.02, 0],
      [0, -0.0027838277178582143],
      [0.02, 0],
      [0, 2e-7],
    ];
    const places: Place[] = [
      [-0.010036531407386065, -0.01763393644243479, 4.681548232678324],
      [-0.011804983847010779, -0.01832861332328329, 4.681548232678324],
      [-0.011804983847010779, -0.01832861332328329, 4.681110628808336],
      [-0.009905294419712142, -0.01829426103355207, 4.681110628808336],
    ];
    const { depth, distance } = find(a, 3.2327094837091863, b, places);
    expect(distance).toBeLessThan(-0.0025);
    expect(depth).toBeCloseTo(-distance, 6);
  });
});

describe('a circle at the corner of a polygon', () => {
  it('has a normal where its centre is so near that the square of the distance is zero', () => {
    const world = phys2D.createWorld();
    const corner = phys2D.createPolygonShape({
      vertices: [
        [0, 0],
        [1, 1],
        [-1, 1],
      ],
    });
    const ball = phys2D.createRigidBody({
      position: [0, -1e-170],
      shapes: [phys2D.createCircleShape({ radius: 0.1 })],
    });
    world.addRigidBody(phys2D.createRigidBody({ type: 'static', shapes: [corner] }));
    world.addRigidBody(ball);
    let length = 0;
    corner.addEventListener('preSolve', (arbiter) => {
      length = Math.hypot(...arbiter.getNormal());
    });
    world.addEventListener('nonfinite', () => expect.unreachable('frozen'));
    world.step(1 / 60);
    expect(length).toBeCloseTo(1, 12);
    expect(Math.hypot(...ball.getPosition())).toBeGreaterThan(0.01);
  });
});
