import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { describe, expect, it } from 'vitest';
import type * as source from '../../src/index.js';
import { dice } from './dice.js';

// What moves fast is not stopped by what it only slides over; what falls bounces as it should, or comes to rest. From the bundle as built:
// unbundled, this takes minutes.

const { phys2D } = (await import(
  /* @vite-ignore */ pathToFileURL(join(import.meta.dirname, '../../dist/phys2d.js')).href
)) as typeof source;

const DT = 1 / 60;
const FREE = { linearDrag: 0, angularDrag: 0 };

interface Skim {
  readonly substeps: number;
  readonly fall: number;
  readonly tile: number;
  readonly size: number;
  readonly round: boolean;
  /** m. By how much the tops of the tiles differ. */
  readonly uneven: number;
}

/**
 * A box or disc at 50 m/s that lands on the third of 60 tiles. @returns the lesser of the shares of speed and of way it has at the 57th, and how
 * far it was thrown up, m; −1 if it went through.
 */
function skim({ substeps, fall, tile, size, round, uneven }: Skim): { kept: number; thrown: number } {
  const world = phys2D.createWorld({ gravity: [0, 10], substeps });
  const material = phys2D.createMaterial({ staticFriction: 0, dynamicFriction: 0, rollingFriction: 0 });
  const { within } = dice(60);
  for (let i = 0; i < 60; i += 1) {
    const shapes = [phys2D.createPolygonShape({ vertices: phys2D.createBoxVertices(tile, 1), material })];
    const y = 0.5 + within(0, uneven);
    world.addRigidBody(phys2D.createRigidBody({ type: 'static', position: [tile * (i + 0.5), y], shapes }));
  }
  const shape = round
    ? phys2D.createCircleShape({ radius: size / 2, material })
    : phys2D.createPolygonShape({ vertices: phys2D.createBoxVertices(size, size), material });
  const landing = 2.5 * tile + size;
  const start = landing - 50 * Math.sqrt((2 * fall) / 10);
  const body = phys2D.createRigidBody({
    position: [start, -size / 2 - fall],
    velocity: [50, 0],
    shapes: [shape],
    ...FREE,
  });
  world.addRigidBody(body);
  let time = 0;
  let thrown = 0;
  while (start + 50 * time < 57 * tile) {
    world.step(DT);
    time += DT;
    const [, y] = body.getPosition();
    if (y >= 0) {
      return { kept: -1, thrown };
    }
    thrown = Math.max(thrown, -size / 2 - fall - y);
  }
  const [x] = body.getPosition();
  return { kept: Math.min(body.getVelocity()[0] / 50, (x - start) / (50 * time)), thrown };
}

describe('skimming', { timeout: 120_000 }, () => {
  for (const round of [false, true]) {
    for (const uneven of [0, 1e-4]) {
      const what = `${round ? 'discs' : 'boxes'} over ${uneven > 0 ? 'tiles that differ by 0.1 mm' : 'flush tiles'}`;
      it(`${what} keep 99.9 % of speed and way, of any size and after any fall`, () => {
        let worst = 1;
        let how = '';
        let count = 0;
        let failed = 0;
        let highest = 0;
        for (const substeps of [1, 2, 4]) {
          for (const fall of [0, 0.01, 0.1, 0.5, 2]) {
            for (const tile of [0.25, 1, 1.3, 3]) {
              for (const size of [0.05, 0.3, 1, 2]) {
                const { kept, thrown } = skim({ substeps, fall, tile, size, round, uneven });
                count += 1;
                highest = Math.max(highest, thrown);
                failed += kept < 0.999 ? 1 : 0;
                if (kept < worst) {
                  worst = kept;
                  how = `${substeps} sub-steps, fall ${fall} m, tiles of ${tile} m, size ${size} m`;
                }
              }
            }
          }
        }
        console.log(
          `${what}: ${failed} of ${count} keep less; worst ${(100 * worst).toFixed(3)} % (${how}); thrown up ${highest.toFixed(3)} m`,
        );
        expect(worst).toBeGreaterThanOrEqual(0.999);
        expect(highest).toBeLessThan(0.01);
      });
    }
  }
});

describe('falls', { timeout: 120_000 }, () => {
  const ground = (elasticity: number, thickness: number): source.RigidBody => {
    const material = phys2D.createMaterial({ elasticity });
    const vertices = phys2D.createBoxVertices(100, thickness);
    const shapes = [phys2D.createPolygonShape({ vertices, material })];
    return phys2D.createRigidBody({ type: 'static', position: [0, thickness / 2], shapes });
  };

  it('an elastic ball comes up again as high as it fell, 15 times', () => {
    const lines: string[] = [];
    let [most, least] = [1, 1];
    for (const height of [0.5, 1, 2, 5, 10, 20, 30]) {
      const world = phys2D.createWorld({ gravity: [0, 10] });
      const material = phys2D.createMaterial({ elasticity: 1 });
      const shapes = [phys2D.createCircleShape({ radius: 0.25, material })];
      const ball = phys2D.createRigidBody({ position: [0, -0.25 - height], shapes, ...FREE });
      world.addRigidBody(ground(1, 0.1));
      world.addRigidBody(ball);
      const apexes: number[] = [];
      let before = 0;
      for (let i = 0; i < 6000 && apexes.length < 15; i += 1) {
        world.step(DT);
        const vy = ball.getVelocity()[1];
        if (before < 0 && vy >= 0) {
          apexes.push((-0.25 - ball.getPosition()[1]) / height);
        }
        before = vy;
      }
      expect(apexes).toHaveLength(15);
      lines.push(`${height} m: ${Math.min(...apexes).toFixed(3)} to ${Math.max(...apexes).toFixed(3)}`);
      [least, most] = [Math.min(least, ...apexes), Math.max(most, ...apexes)];
    }
    console.log(`apexes of 15 bounces, share of the height: ${lines.join('; ')}`);
    expect(most).toBeLessThan(1.02);
    expect(least).toBeGreaterThan(0.99);
  });

  it('small boxes that land on a corner, and turn onto the next, are never a tenth in the floor', () => {
    const utils = phys2D.createCollisionUtils();
    for (const size of [0.1, 0.2, 0.5]) {
      let deepest = 0;
      for (const rate of [30, 60, 120]) {
        for (const speed of [5, 10, 20]) {
          for (const angularVelocity of [-0.5, 0.5, 3]) {
            for (let k = 0; k < 10; k += 1) {
              const world = phys2D.createWorld({ gravity: [0, 10] });
              const floor = ground(0, 2);
              const shape = phys2D.createPolygonShape({ vertices: phys2D.createBoxVertices(size, size) });
              const position: source.Vec2 = [0, -2 - (k * speed) / rate / 10];
              const motion = { velocity: [0, speed] as const, rotation: 0.2, angularVelocity };
              world.addRigidBody(floor);
              world.addRigidBody(phys2D.createRigidBody({ position, ...motion, shapes: [shape] }));
              for (let i = 0; i < rate; i += 1) {
                world.step(1 / rate);
                deepest = Math.max(deepest, -utils.signedDistance(shape, floor.shapes[0]!, [], [], []));
              }
            }
          }
        }
      }
      console.log(`boxes of ${size} m that land on a corner: ${(1000 * deepest).toFixed(1)} mm deep at most`);
      // Half of boxes of 0.1 m was where 5 cm are left to all.
      expect(deepest).toBeLessThan(0.102 * size);
    }
  });

  it('inelastic boxes from up to 50 m come to rest on the floor, without sinking', () => {
    let [deepest, fastest, through, longest] = [0, 0, 0, 0];
    let [worst, stalled] = ['', ''];
    for (let seed = 0; seed < 200; seed += 1) {
      const { within, scaled } = dice(seed);
      const world = phys2D.createWorld({ gravity: [0, 10] });
      const [width, height, fall] = [scaled(0.1, 2), scaled(0.1, 2), scaled(0.1, 50)];
      const rotation = seed % 3 === 0 ? 0 : within(0, 6);
      const reach = 0.5 * (Math.abs(Math.cos(rotation)) * height + Math.abs(Math.sin(rotation)) * width);
      const shapes = [phys2D.createPolygonShape({ vertices: phys2D.createBoxVertices(width, height) })];
      const body = phys2D.createRigidBody({ position: [0, -reach - fall], rotation, shapes, ...FREE });
      world.addRigidBody(ground(0, 0.1));
      world.addRigidBody(body);
      let met = false;
      shapes[0]!.addEventListener('begin', () => {
        met = true;
      });
      for (let i = 0; i < 400 && !met; i += 1) {
        world.step(DT);
      }
      expect(met).toBe(true);
      let stall = 0;
      for (let i = 1; i <= 600; i += 1) {
        const [fromX, fromY] = body.getPosition();
        world.step(DT);
        const [dx, dy] = [body.getPosition()[0] - fromX, body.getPosition()[1] - fromY];
        const [vx, vy] = body.getVelocity();
        const isStuck = vx * vx + vy * vy > 0.25 && dx * dx + dy * dy < 0.01 * (vx * vx + vy * vy) * DT * DT;
        stall = isStuck ? stall + 1 : 0;
        if (stall > longest) {
          longest = stall;
          stalled = `seed ${seed}`;
        }
        through += body.getPosition()[1] > 0 ? 1 : 0;
        // Not in an impact: one of a box that whirls on has it deeper for a step.
        const isSlow = Math.abs(vx) + Math.abs(vy) + Math.abs(body.getAngularVelocity()) * (width + height) < 1;
        if (i >= 60 && isSlow) {
          const depth = body.computeWorldBounds()[3]!;
          if (depth > deepest) {
            deepest = depth;
            worst = `seed ${seed}`;
          }
        }
      }
      const [vx, vy] = body.getVelocity();
      fastest = Math.max(fastest, Math.sqrt(vx * vx + vy * vy));
    }
    console.log(
      `200 boxes: ${(1000 * deepest).toFixed(2)} mm deep from 60 steps after the impact on (${worst}), ${fastest.toFixed(4)} m/s after 600; ` +
        `stuck in spite of their speed for ${longest} steps at most (${stalled})`,
    );
    expect(through).toBe(0);
    expect(longest).toBeLessThan(5);
    expect(deepest).toBeLessThan(0.005);
    expect(fastest).toBeLessThan(0.05);
  });

  it('a column of ten boxes that falls 3 m does not explode', () => {
    const lines: string[] = [];
    let [worst, rise] = [0, 0];
    for (const gap of [0, 0.001, 0.01, 0.1]) {
      for (const lean of [0, 0.02]) {
        const world = phys2D.createWorld({ gravity: [0, 10] });
        const { within } = dice(10);
        world.addRigidBody(ground(0, 0.1));
        const bodies = Array.from({ length: 10 }, (_, i) => {
          const shapes = [phys2D.createPolygonShape({ vertices: phys2D.createBoxVertices(1, 1) })];
          const position: [number, number] = [within(-lean, lean), -3.5 - i * (1 + gap)];
          const body = phys2D.createRigidBody({ position, shapes, ...FREE });
          world.addRigidBody(body);
          return body;
        });
        const starts = bodies.map((body) => body.getPosition()[1]);
        /** Of all bodies, J: it may only become less. */
        const energy = (): number =>
          bodies.reduce((sum, body) => {
            const [vx, vy] = body.getVelocity();
            const w = body.getAngularVelocity();
            return sum + 0.5 * (vx * vx + vy * vy) + (0.5 / 6) * w * w - 10 * body.getPosition()[1];
          }, 0);
        const given = energy();
        let [fastest, most] = [0, 0];
        for (let i = 0; i < 600; i += 1) {
          world.step(DT);
          most = Math.max(most, energy() / given);
          bodies.forEach((body, k) => {
            const [x, y] = body.getPosition();
            const [vx, vy] = body.getVelocity();
            expect(y).toBeLessThan(0);
            expect(Math.abs(x)).toBeLessThan(20);
            const fall = Math.max(3 + k * gap, y - starts[k]!);
            fastest = Math.max(fastest, Math.sqrt(vx * vx + vy * vy) / Math.sqrt(2 * 10 * fall));
          });
        }
        const stands = bodies.every((body, k) => Math.abs(body.getPosition()[1] + 0.5 + k) < 0.1);
        [worst, rise] = [Math.max(worst, fastest), Math.max(rise, most)];
        lines.push(
          `${gap} m, ${lean} m: ${fastest.toFixed(3)}, ${most.toFixed(4)}, ${stands ? 'stands' : 'fell over'}`,
        );
      }
    }
    console.log(
      `columns (gap, lean: fastest box as a share of its speed of fall, most energy as a share): ${lines.join('; ')}`,
    );
    expect(worst).toBeLessThan(1.03);
    expect(rise).toBeLessThan(1.001);
  });
});
