import { describe, expect, it } from 'vitest';
import { phys2D, type Shape } from '../../src/index.js';

// Balls and capsules on a floor of flush tiles: what a tile tells is that it is touched, not that it is near.

function buildFloor() {
  const world = phys2D.createWorld({ allowSleeping: false });
  const tile = (x: number) =>
    phys2D.createPolygonShape({ vertices: phys2D.createRectangleVertices(x, 0, x + 1, 1), userData: x });
  const shapes = Array.from({ length: 20 }, (_, i) => tile(i - 5));
  world.addRigidBody(phys2D.createRigidBody({ type: 'static', shapes }));
  return world;
}

function buildShapes(kind: 'ball' | 'capsule'): Shape[] {
  const ball = (y: number) => phys2D.createCircleShape({ radius: 0.5, origin: [0, y] });
  const vertices = phys2D.createRectangleVertices(-0.5, -1, 0.5, 0);
  return kind === 'ball' ? [ball(0)] : [ball(0), ball(-1), phys2D.createPolygonShape({ vertices })];
}

describe.each(['ball', 'capsule'] as const)('a %s on flush tiles', (kind) => {
  it.each([0.01, 0.03, 0.05, 0.1])('that rests %d m beside a seam has begun to touch one tile, once', (x) => {
    const world = buildFloor();
    const shapes = buildShapes(kind);
    const begun: unknown[] = [];
    let ended = 0;
    for (const shape of shapes) {
      shape.addEventListener('begin', (_, tile) => begun.push(tile.userData));
      shape.addEventListener('end', () => {
        ended += 1;
      });
    }
    world.addRigidBody(phys2D.createRigidBody({ position: [x, -0.5], inertia: Infinity, shapes }));
    for (let i = 0; i < 300; i += 1) {
      world.step(1 / 60);
    }
    expect(begun).toEqual([0]);
    expect(ended).toBe(0);
  });

  it.each([0.5, 2, 5])('that goes over ten of them at %d m/s begins to touch each about once', (speed) => {
    const world = buildFloor();
    const material = phys2D.createMaterial({ staticFriction: 0, dynamicFriction: 0, rollingFriction: 0 });
    const shapes = buildShapes(kind);
    const begun: unknown[] = [];
    for (const shape of shapes) {
      shape.setMaterial(material);
      shape.addEventListener('begin', (_, tile) => begun.push(tile.userData));
    }
    const body = phys2D.createRigidBody({ position: [-2.5, -0.5], inertia: Infinity, linearDrag: 0, shapes });
    body.setVelocity([speed, 0]);
    world.addRigidBody(body);
    while (body.getPosition()[0] < 7.5) {
      world.step(1 / 60);
    }
    expect(new Set(begun).size).toBe(11);
    expect(begun.length).toBeLessThanOrEqual(13);
    expect(body.getVelocity()[0]).toBeCloseTo(speed, 6);
  });
});
