import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { describe, expect, it } from 'vitest';
import { STATIC_FRICTION_SPEED_SQUARED } from '../../src/config.js';
import type * as source from '../../src/index.js';

// Friction between unequal materials, at rest and sliding, against its formulas. From the bundle as built: much is measured.

const { phys2D } = (await import(
  /* @vite-ignore */ pathToFileURL(join(import.meta.dirname, '../../dist/phys2d.js')).href
)) as typeof source;

const GRAVITY = 10;
const STEPS = [1 / 30, 1 / 60, 1 / 120, 1 / 240];
const SUBSTEPS = 4;

/** Slabs on each other on a level ground, each 0.2 m high, of 1 kg, and with a material of its own. */
function slabs(
  gravity: source.Vec2,
  ground: source.MaterialParams,
  layers: readonly { readonly width: number; readonly material: source.MaterialParams; readonly speed?: number }[],
) {
  const world = phys2D.createWorld({ gravity, substeps: SUBSTEPS, allowSleeping: false });
  const shape = (width: number, height: number, material: source.MaterialParams): source.Shape =>
    phys2D.createPolygonShape({
      vertices: phys2D.createBoxVertices(width, height),
      material: phys2D.createMaterial(material),
    });
  world.addRigidBody(phys2D.createRigidBody({ type: 'static', position: [0, 1], shapes: [shape(4000, 2, ground)] }));
  const bodies = layers.map(({ width, material, speed = 0 }, i) => {
    const free = { mass: 1, linearDrag: 0, angularDrag: 0, velocity: [speed, 0] as source.Vec2 };
    const body = phys2D.createRigidBody({
      position: [0, -0.1 - 0.2 * i],
      shapes: [shape(width, 0.2, material)],
      ...free,
    });
    world.addRigidBody(body);
    return body;
  });
  return { world, bodies };
}

const alike = (friction: number): source.MaterialParams => ({ staticFriction: friction, dynamicFriction: friction });

describe('friction', () => {
  it('of unequal materials stops a slab after v² / (2 μ g), μ the geometric mean, and for good', () => {
    let [worst, last] = [0, 0];
    for (const dt of STEPS) {
      for (const [a, b] of [
        [0.2, 0.8],
        [0.05, 0.2],
        [1, 0.04],
        [3, 0.3],
      ] as const) {
        for (const speed of [3, 8]) {
          const friction = Math.sqrt(a * b);
          const { world, bodies } = slabs([0, GRAVITY], alike(a), [{ width: 2, material: alike(b), speed }]);
          for (let t = 0; t < speed / (friction * GRAVITY) + 1; t += dt) {
            world.step(dt);
          }
          // Braked before it moves, it falls short by half of a sub-step at its first speed.
          const way = (speed * speed) / (2 * friction * GRAVITY) - (0.5 * speed * dt) / SUBSTEPS;
          worst = Math.max(worst, Math.abs(bodies[0]!.getPosition()[0] - way));
          last = Math.max(last, Math.abs(bodies[0]!.getVelocity()[0]));
        }
      }
    }
    console.log(`slides: way off by ${(1000 * worst).toFixed(3)} mm, ${last.toExponential(1)} m/s left`);
    expect(worst).toBeLessThan(2e-4);
    expect(last).toBeLessThan(1e-12);
  });

  it('is none if one of the two has none', () => {
    const { world, bodies } = slabs([0, GRAVITY], alike(0.5), [{ width: 2, material: alike(0), speed: 3 }]);
    for (let i = 0; i < 600; i += 1) {
      world.step(1 / 60);
    }
    expect(bodies[0]!.getVelocity()[0]).toBeCloseTo(3, 12);
    expect(bodies[0]!.getPosition()[0]).toBeCloseTo(30, 9);
  });

  it('holds against a force that grows until it is μ m g; from 1 cm/s on the slab has the friction of what slides', () => {
    let [late, creep, offGain] = [0, 0, 0];
    for (const dt of STEPS) {
      const material = { staticFriction: 0.6, dynamicFriction: 0.3 };
      const { world, bodies } = slabs([0, GRAVITY], material, [{ width: 2, material }]);
      const body = bodies[0]!;
      const sliding = Math.sqrt(STATIC_FRICTION_SPEED_SQUARED);
      for (let i = 0; i < 60; i += 1) {
        world.step(dt);
      }
      let force = 0;
      while (body.getVelocity()[0] <= sliding && force < 10) {
        if (force < 0.6 * GRAVITY) {
          creep = Math.max(creep, Math.abs(body.getPosition()[0]));
        }
        force += dt;
        body.setForce([force, 0]);
        world.step(dt);
      }
      // By 1 N/s more than it can hold: v = t² / 2.
      late = Math.max(late, Math.abs(force - 0.6 * GRAVITY - Math.sqrt(2 * sliding)) / dt);
      body.setForce([0.6 * GRAVITY, 0]);
      const from = body.getVelocity()[0];
      const steps = Math.round(1 / dt);
      for (let i = 0; i < steps; i += 1) {
        world.step(dt);
      }
      offGain = Math.max(offGain, Math.abs((body.getVelocity()[0] - from) / (0.3 * GRAVITY) - 1));
    }
    console.log(
      `pulled: slips ${late.toFixed(2)} steps off, creeps ${(1e6 * creep).toFixed(3)} µm before, then acceleration off by ${(100 * offGain).toFixed(3)} %`,
    );
    expect(late).toBeLessThan(2);
    expect(creep).toBeLessThan(1e-6);
    expect(offGain).toBeLessThan(1e-3);
  });

  it('holds a slab on a slope of 99.9 % of μ, in 10 s without creep; on one of 102 % that slides as it should, within 1 %', () => {
    let [creep, off] = [0, 0];
    for (const dt of STEPS) {
      for (const friction of [0.1, 0.5, 1]) {
        for (const share of [0.98, 0.999, 1.02]) {
          const angle = Math.atan(friction * share);
          const pull: source.Vec2 = [GRAVITY * Math.sin(angle), GRAVITY * Math.cos(angle)];
          const { world, bodies } = slabs(pull, alike(friction), [{ width: 2, material: alike(friction) }]);
          for (let i = 0; i < 30; i += 1) {
            world.step(dt);
          }
          const [from] = bodies[0]!.getPosition();
          const [speed] = bodies[0]!.getVelocity();
          const steps = Math.round(10 / dt);
          for (let i = 0; i < steps; i += 1) {
            world.step(dt);
          }
          const way = bodies[0]!.getPosition()[0] - from;
          const gain = pull[0] - friction * pull[1];
          if (share < 1) {
            creep = Math.max(creep, Math.abs(way));
          } else {
            off = Math.max(off, Math.abs(way / (10 * speed + 50 * gain) - 1));
          }
        }
      }
    }
    console.log(`slopes: creep ${creep.toExponential(1)} m, slide off by ${(100 * off).toFixed(2)} %`);
    expect(creep).toBeLessThan(1e-12);
    expect(off).toBeLessThan(0.01);
  });

  it('between layers is that of each pair: upper slabs slide as one over a lowest one that stays', () => {
    let [off, apart, moved] = [0, 0, 0];
    for (const dt of STEPS) {
      const rough = alike(1);
      // Against rough ones its friction is 0.1.
      const slippery = alike(0.01);
      const { world, bodies } = slabs([0, GRAVITY], rough, [
        { width: 8, material: rough },
        { width: 4, material: slippery, speed: 2 },
        { width: 2, material: rough, speed: 2 },
      ]);
      for (let t = 0; t < 3; t += dt) {
        world.step(dt);
        apart = Math.max(apart, Math.abs(bodies[2]!.getPosition()[0] - bodies[1]!.getPosition()[0]));
      }
      off = Math.max(off, Math.abs(bodies[1]!.getPosition()[0] / (4 / (2 * 0.1 * GRAVITY)) - 1));
      moved = Math.max(moved, Math.abs(bodies[0]!.getPosition()[0]));
    }
    console.log(
      `layers: way off by ${(100 * off).toFixed(2)} %, upper ones ${(1000 * apart).toFixed(2)} mm apart, lowest moved ${(1e6 * moved).toFixed(1)} µm`,
    );
    expect(off).toBeLessThan(0.005);
    expect(apart).toBeLessThan(0.003);
    expect(moved).toBeLessThan(1e-4);
  });
});
