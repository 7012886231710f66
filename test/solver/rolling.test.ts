import { describe, expect, it } from 'vitest';
import { phys2D, type World } from '../../src/index.js';

// A circle that turns has its surface where it was: contacts of wheels and balls do not turn with them, however fast.

const RADIUS = 0.4;

function ground(world: World): void {
  const material = phys2D.createMaterial({ staticFriction: 1.2, dynamicFriction: 1, rollingFriction: 0 });
  const shapes = [phys2D.createPolygonShape({ vertices: phys2D.createBoxVertices(20_000, 10), material })];
  world.addRigidBody(phys2D.createRigidBody({ type: 'static', position: [0, 5], shapes }));
}

describe('rolling', () => {
  for (const spin of [1, 12, 60, 300]) {
    it(`a disc at ${spin} rad/s stays on the ground, and goes as fast as it turns`, () => {
      const world = phys2D.createWorld({ allowSleeping: false });
      ground(world);
      const material = phys2D.createMaterial({ staticFriction: 1.2, dynamicFriction: 1, rollingFriction: 0 });
      const shape = phys2D.createCircleShape({ radius: RADIUS, material });
      const disc = phys2D.createRigidBody({
        position: [0, -RADIUS],
        velocity: [spin * RADIUS, 0],
        angularVelocity: spin,
        shapes: [shape],
        linearDrag: 0,
        angularDrag: 0,
      });
      world.addRigidBody(disc);
      for (let i = 0; i < 300; i += 1) {
        world.step(1 / 60);
        const [x, y] = disc.getPosition();
        expect(Math.abs(y + RADIUS)).toBeLessThan(0.0005);
        const [contact] = shape.arbiters[0]!.contacts;
        expect(contact!.getPosition()[0]).toBeCloseTo(x, 9);
        expect(contact!.getPenetration()).toBeCloseTo(y + RADIUS, 9);
      }
      // Friction acts half-way into the overlap.
      expect(disc.getVelocity()[0] / (disc.getAngularVelocity() * RADIUS)).toBeCloseTo(1, 3);
      expect(disc.getAngularVelocity() / spin).toBeCloseTo(1, 3);
    });
  }

  it('a disc that falls spinning does not sink', () => {
    for (const spin of [20, 200, 1000]) {
      for (const speed of [1, 10, 100, 400]) {
        const world = phys2D.createWorld();
        ground(world);
        const material = phys2D.createMaterial({ staticFriction: 1.2, dynamicFriction: 1 });
        const shapes = [phys2D.createCircleShape({ radius: RADIUS, material })];
        const disc = phys2D.createRigidBody({ position: [0, -3], velocity: [0, speed], angularVelocity: spin, shapes });
        world.addRigidBody(disc);
        for (let i = 0; i < 120; i += 1) {
          world.step(1 / 60);
          expect(disc.getPosition()[1] + RADIUS).toBeLessThan(0.005);
        }
      }
    }
  });
});
