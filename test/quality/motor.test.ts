import { describe, expect, it } from 'vitest';
import { phys2D } from '../../src/index.js';
import { DT, plainBody, staticBody, weightless } from '../conformance/setting.js';

describe('motor', () => {
  it('reaches its rate, and with maxForce accelerates by maxForce / inertia, within 0.5 %', () => {
    let offRate = 0;
    let offAcceleration = 0;
    for (const ratio of [1, 2, -1.5]) {
      for (const inertia of [0.01, 1, 50]) {
        const world = weightless();
        const free = plainBody({ inertia });
        const held = plainBody({ inertia, position: [3, 0] });
        world.addRigidBody(free);
        world.addRigidBody(held);
        const rate = 7;
        world.addConstraint(phys2D.createMotorConstraint({ bodyA: staticBody(), bodyB: free, ratio, rate }));
        const torque = 0.2 * inertia;
        const limited = { ratio, rate: 100, maxForce: torque };
        world.addConstraint(phys2D.createMotorConstraint({ bodyA: staticBody(), bodyB: held, ...limited }));
        for (let i = 0; i < 60; i += 1) {
          world.step(DT);
        }
        offRate = Math.max(offRate, Math.abs((ratio * free.getAngularVelocity()) / rate - 1));
        const gained = held.getAngularVelocity() * Math.sign(ratio);
        offAcceleration = Math.max(offAcceleration, Math.abs(gained / ((Math.abs(ratio) * torque) / inertia) - 1));
      }
    }
    console.log(
      `motor: rate off by ${(100 * offRate).toFixed(4)} %, acceleration under maxForce by ` +
        `${(100 * offAcceleration).toFixed(4)} % (target 0.5 %)`,
    );
    expect(offRate).toBeLessThanOrEqual(0.005);
    expect(offAcceleration).toBeLessThanOrEqual(0.005);
  });
});
