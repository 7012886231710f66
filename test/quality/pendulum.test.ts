import { describe, expect, it } from 'vitest';
import { phys2D } from '../../src/index.js';
import { DT, heavy, plainBody, staticBody } from '../conformance/setting.js';

// A point joint neither stretches nor brakes: period and height of a pendulum.

/** A disc of mass 1 and inertia I, on an arm of length L, turned by `angle` from hanging down. */
function pendulum(length: number, inertia: number, angle: number) {
  const world = heavy({ allowSleeping: false });
  const position: [number, number] = [length * Math.sin(angle), length * Math.cos(angle)];
  const body = plainBody({ inertia, position, rotation: -angle });
  world.addRigidBody(body);
  world.addConstraint(phys2D.createPointConstraint({ bodyA: staticBody(), bodyB: body, anchorB: [0, -length] }));
  return { world, body };
}

describe('pendulum on a point joint', () => {
  it('has the period of the formula at a small angle, within 0.2 %', () => {
    for (const [length, inertia] of [
      [1, 1e-6],
      [2, 1],
      [0.3, 0.01],
    ] as const) {
      const { world, body } = pendulum(length, inertia, 0.05);
      const crossings: number[] = [];
      for (let i = 1; crossings.length < 11; i += 1) {
        const before = body.getPosition()[0];
        world.step(DT);
        const now = body.getPosition()[0];
        if (before > 0 && now <= 0) {
          crossings.push((i - now / (now - before)) * DT);
        }
      }
      const period = (crossings[10]! - crossings[0]!) / 10;
      const small = 1 + 0.05 ** 2 / 16;
      const expected = 2 * Math.PI * Math.sqrt((inertia + length * length) / (10 * length)) * small;
      const off = Math.abs(period / expected - 1);
      console.log(`pendulum of ${length} m: period off by ${(100 * off).toFixed(3)} % (target 0.2 %)`);
      expect(off).toBeLessThanOrEqual(0.002);
    }
  });

  it('loses no more than 2 % of its height in 60 s of large swings, and gains none', () => {
    const { world, body } = pendulum(1, 0.1, Math.PI / 2);
    let stretched = 0;
    let first = 0;
    let last = 0;
    let highest = 0;
    for (let i = 0; i < 3600; i += 1) {
      world.step(DT);
      const [x, y] = body.getPosition();
      stretched = Math.max(stretched, Math.abs(Math.sqrt(x * x + y * y) - 1));
      const apex = 1 - y;
      if (i < 300) first = Math.max(first, apex);
      if (i >= 3300) last = Math.max(last, apex);
      highest = Math.max(highest, apex);
    }
    const loss = (first - last) / 1;
    console.log(
      `pendulum from the horizontal, 60 s: apex lower by ${(100 * loss).toFixed(2)} % of 1 m (target 2 %), ` +
        `${(1000 * (highest - 1)).toFixed(2)} mm above the start, arm longer by ${(1e6 * stretched).toFixed(2)} µm`,
    );
    expect(loss).toBeLessThanOrEqual(0.02);
    expect(highest).toBeLessThanOrEqual(1);
    expect(stretched).toBeLessThanOrEqual(1e-4);
  });
});
