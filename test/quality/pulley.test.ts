import { describe, expect, it } from 'vitest';
import { phys2D, type RigidBody } from '../../src/index.js';
import { DT, heavy, plainBody, staticBody } from '../conformance/setting.js';

function distance(a: RigidBody, b: RigidBody): number {
  const [ax, ay] = a.getPosition();
  const [bx, by] = b.getPosition();
  return Math.sqrt((bx - ax) ** 2 + (by - ay) ** 2);
}

describe('pulley', () => {
  for (const ratio of [1, 2]) {
    it(`keeps the sum of its lengths within 1 mm over 10 s of swinging loads, ratio ${ratio}`, () => {
      const world = heavy();
      const a = plainBody({ position: [-3, 3], velocity: [2, 0] });
      const d = plainBody({ position: [3, 4], velocity: [-1, 0], mass: 1.02 * ratio });
      const b = staticBody({ position: [-3, 0] });
      const c = staticBody({ position: [3, 0] });
      world.addRigidBody(a);
      world.addRigidBody(d);
      const total = 3 + ratio * 4;
      const bodies = { bodyA: a, bodyB: b, bodyC: c, bodyD: d };
      world.addConstraint(phys2D.createPulleyConstraint({ ...bodies, ratio, lowerBound: total, upperBound: total }));
      let worst = 0;
      let swing = 0;
      for (let i = 0; i < 600; i += 1) {
        world.step(DT);
        worst = Math.max(worst, Math.abs(distance(a, b) + ratio * distance(c, d) - total));
        swing = Math.max(swing, Math.abs(a.getPosition()[0] + 3));
      }
      console.log(`pulley, ratio ${ratio}: sum off by ${(1e6 * worst).toFixed(2)} µm (target 1 mm)`);
      expect(swing).toBeGreaterThan(0.5);
      expect(worst).toBeLessThanOrEqual(1e-3);
    });
  }
});
