import { describe, expect, it } from 'vitest';
import { phys2D } from '../../src/index.js';
import { addFloor, boxBody, speed } from '../conformance/setting.js';

describe('what sleeps through a change of the step', () => {
  it.each([1 / 240, 1 / 600, 1 / 20])(
    'wakes with the impulses of the step that it fell asleep in: %s s',
    (deltaTime) => {
      const world = phys2D.createWorld();
      addFloor(world);
      const boxes = Array.from({ length: 10 }, (_, i) => {
        const body = boxBody(1, 1, { position: [0, -0.5 - i] });
        world.addRigidBody(body);
        return body;
      });
      for (let i = 0; i < 600 && !boxes[9]!.sleeping; i += 1) {
        world.step(1 / 60);
      }
      expect(boxes[9]!.sleeping).toBe(true);
      for (let i = 0; i < 3; i += 1) {
        world.step(deltaTime);
      }
      boxes[0]!.wake();
      let fastest = 0;
      for (let i = 0; i < 60; i += 1) {
        world.step(deltaTime);
        fastest = Math.max(fastest, ...boxes.map(speed));
      }
      expect(boxes[9]!.sleeping).toBe(false);
      expect(fastest).toBeLessThan(1e-3);
    },
  );
});

describe('a joint of a chain that is pulled against a wall', () => {
  it('tells all of what it gives', () => {
    const world = phys2D.createWorld({ gravity: [0, 0], allowSleeping: false });
    const wall = phys2D.createPolygonShape({ vertices: phys2D.createRectangleVertices(2, -5, 3, 5) });
    world.addRigidBody(phys2D.createRigidBody({ type: 'static', shapes: [wall] }));
    let before = phys2D.createRigidBody({ type: 'static' });
    world.addRigidBody(before);
    for (let i = 0; i < 12; i += 1) {
      const body = boxBody(0.4, 0.2, { position: [0.2 + 0.4 * i, 0], linearDrag: 0, angularDrag: 0 });
      world.addRigidBody(body);
      world.addConstraint(
        phys2D.createPointConstraint({
          bodyA: before,
          bodyB: body,
          anchorA: i === 0 ? [0, 0] : [0.2, 0],
          anchorB: [-0.2, 0],
          ignoreInteractions: true,
        }),
      );
      before = body;
    }
    const last = world.constraints[11]!;
    let contested = 0;
    for (let i = 0; i < 200; i += 1) {
      const pull = Math.min(2080, 20 * i);
      before.setForce([pull, 0]);
      const { 0: vx } = before.getVelocity();
      world.step(1 / 60);
      contested += world.solver.joints.groups.some((group) => group.contested) ? 1 : 0;
      const given = (before.getVelocity()[0] - vx) * before.getMass() - pull / 60;
      expect(last.getImpulseForBody(before)[0]).toBeCloseTo(given, 6);
    }
    expect(contested).toBeGreaterThan(50);
  });
});
