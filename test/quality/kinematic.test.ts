import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { describe, expect, it } from 'vitest';
import { REST_DAMPING, REST_SPEED } from '../../src/config.js';
import type * as source from '../../src/index.js';

// What lies on a belt or a moving platform is carried along. From the bundle as built: much is measured.

const { phys2D } = (await import(
  /* @vite-ignore */ pathToFileURL(join(import.meta.dirname, '../../dist/phys2d.js')).href
)) as typeof source;

const GRAVITY = 10;
const DT = 1 / 60;
const STEPS = [1 / 30, 1 / 60, 1 / 120, 1 / 240];
const SUBSTEPS = 4;

function box(width: number, height: number, friction: number): source.Shape {
  const material = phys2D.createMaterial({ staticFriction: friction, dynamicFriction: friction });
  return phys2D.createPolygonShape({ vertices: phys2D.createBoxVertices(width, height), material });
}

interface Ride {
  readonly world: source.World;
  readonly under: source.RigidBody;
  /** From the lowest up. */
  readonly boxes: readonly source.RigidBody[];
}

/** 1 m boxes on each other, with the velocity of what they lie on, a box that turns about (0, 1). */
function ride(
  friction: number,
  under: source.RigidBodyParams,
  { count = 1, x = 0, allowSleeping = false, velocity = [0, 0] as source.Vec2, angularVelocity = 0 } = {},
): Ride {
  const world = phys2D.createWorld({ gravity: [0, GRAVITY], substeps: SUBSTEPS, allowSleeping });
  const base = phys2D.createRigidBody({ position: [0, 1], shapes: [box(4000, 2, friction)], ...under });
  world.addRigidBody(base);
  const boxes = Array.from({ length: count }, (_, i) => {
    const motion = { velocity, angularVelocity, linearDrag: 0, angularDrag: 0 };
    const body = phys2D.createRigidBody({ position: [x, -0.5 - i], shapes: [box(1, 1, friction)], ...motion });
    world.addRigidBody(body);
    return body;
  });
  return { world, under: base, boxes };
}

/** The most that rest damping takes in a sub-step, and friction gives back in the next, as a share of the speed. */
const lag = (dt: number): number => (REST_DAMPING * dt) / SUBSTEPS;

describe('a belt', () => {
  it('has a box at its speed v after v / (μ g), after v² / (2 μ g), and carries it on', () => {
    let [offSpeed, offWay, offTime] = [0, 0, 0];
    for (const dt of STEPS) {
      // With 1 the box would stand on its edge.
      for (const friction of [0.2, 0.5, 0.8]) {
        for (const speed of [0.05, 0.5, 2, -3]) {
          const { world, under, boxes } = ride(friction, { type: 'static' });
          for (let i = 0; i < 30; i += 1) {
            world.step(dt);
          }
          under.setSurfaceVelocity([speed, 0]);
          const start = Math.abs(speed) / (friction * GRAVITY);
          let time = 0;
          let reached = Infinity;
          while (time < start + 2) {
            world.step(dt);
            time += dt;
            reached =
              Math.abs(boxes[0]!.getVelocity()[0] - speed) < 1e-3 * Math.abs(speed) ? Math.min(reached, time) : reached;
          }
          offSpeed = Math.max(offSpeed, Math.abs(boxes[0]!.getVelocity()[0] / speed - 1));
          offTime = Math.max(offTime, (reached - start) / dt);
          // The integrator is ahead by half of what the speed changes in a sub-step, as for any fall.
          const ahead = (0.5 * speed * dt) / SUBSTEPS;
          const way = speed * (time - start / 2) + ahead;
          offWay = Math.max(offWay, Math.abs(boxes[0]!.getPosition()[0] - way));
        }
      }
    }
    console.log(
      `belts: speed off by ${offSpeed.toExponential(1)}, reached ${offTime.toFixed(2)} steps late, way off by ${(1000 * offWay).toFixed(3)} mm`,
    );
    expect(offSpeed).toBeLessThan(1e-9);
    // The drag puts more load on one edge of the box; the last tenth of a percent takes until that has settled.
    expect(offTime).toBeLessThan(3);
    expect(offWay).toBeLessThan(2e-4);
  });
});

describe('a platform', () => {
  it('at 0.1 mm/s to 1 m/s keeps what stands on it awake, and carries it along; below 1 cm/s rest damping costs what lies on others 0.21 %', () => {
    let [slow, beyond, fast] = [0, 0, 0];
    for (const speed of [1e-4, 1e-3, 2e-3, 5e-3, REST_SPEED, 0.02, 0.05, 1]) {
      for (const count of [1, 5]) {
        const velocity: source.Vec2 = [speed, 0];
        const options = { count, allowSleeping: true, velocity };
        const { world, under, boxes } = ride(0.6, { type: 'kinematic', velocity }, options);
        for (let i = 0; i < 1200; i += 1) {
          world.step(DT);
        }
        const [way] = under.getPosition();
        for (const body of boxes) {
          expect(body.sleeping).toBe(false);
          const behind = way - body.getPosition()[0];
          if (speed < REST_SPEED) {
            slow = Math.max(slow, behind / way);
            beyond = Math.max(beyond, behind - lag(DT) * way);
          } else {
            fast = Math.max(fast, Math.abs(behind));
          }
        }
      }
    }
    console.log(
      `platforms: below 1 cm/s ${(100 * slow).toFixed(3)} % behind, ${beyond.toExponential(1)} m more than damping takes; else ${fast.toExponential(1)} m`,
    );
    expect(beyond).toBeLessThan(1e-7);
    expect(fast).toBeLessThan(1e-8);
  });

  it('at 5 mm/s keeps a disc on it where it is', () => {
    const world = phys2D.createWorld({ gravity: [0, 10], allowSleeping: false });
    const velocity: source.Vec2 = [0.005, 0];
    const under = phys2D.createRigidBody({ type: 'kinematic', position: [0, 1], velocity, shapes: [box(40, 2, 0.6)] });
    const disc = phys2D.createRigidBody({
      position: [0, -0.5],
      velocity,
      linearDrag: 0,
      angularDrag: 0,
      shapes: [phys2D.createCircleShape({ radius: 0.5 })],
    });
    world.addRigidBody(under);
    world.addRigidBody(disc);
    for (let i = 0; i < 3600; i += 1) {
      world.step(DT);
    }
    expect(under.getPosition()[0]).toBeCloseTo(0.3, 9);
    expect(disc.getPosition()[0]).toBeCloseTo(0.3, 6);
  });

  it('that rises or sinks has the box on it, within 0.3 mm', () => {
    let worst = 0;
    for (const speed of [1e-3, 5e-3, 0.02, 1]) {
      for (const direction of [1, -1]) {
        const motion = { velocity: [0, speed * direction] as source.Vec2 };
        const { world, under, boxes } = ride(0.6, { type: 'kinematic', ...motion }, { allowSleeping: true, ...motion });
        for (let i = 0; i < 1200; i += 1) {
          world.step(DT);
          worst = Math.max(worst, Math.abs(under.getPosition()[1] - 1.5 - boxes[0]!.getPosition()[1]));
        }
      }
    }
    console.log(`lifts: ${(1000 * worst).toFixed(3)} mm apart or overlapping at most`);
    expect(worst).toBeLessThan(3e-4);
  });

  it('that gets faster in jumps leaves a box no farther behind than friction can help; one too fast moves it by μ g t² / 2', () => {
    let worst = -Infinity;
    let free = 0;
    for (const dt of STEPS) {
      for (const gain of [0.001, 0.01, 1, 5, 5.9, 7, 20]) {
        const { world, under, boxes } = ride(0.6, { type: 'kinematic' });
        const grip = 0.6 * GRAVITY;
        for (let i = 0; i < 60; i += 1) {
          world.step(dt);
        }
        const steps = Math.round(3 / dt);
        for (let i = 1; i <= steps; i += 1) {
          under.setVelocity([gain * i * dt, 0]);
          world.step(dt);
        }
        const behind = under.getPosition()[0] - boxes[0]!.getPosition()[0];
        if (gain < grip) {
          // Each jump by gain · dt costs at most its square / (2 μ g).
          worst = Math.max(worst, behind - (steps * (gain * dt) ** 2) / (2 * grip));
        } else {
          const way = 0.5 * grip * 9 + (0.5 * 3 * grip * dt) / SUBSTEPS;
          free = Math.max(free, Math.abs(boxes[0]!.getPosition()[0] - way));
        }
      }
    }
    console.log(
      `accelerated: ${(1000 * worst).toFixed(3)} mm more behind; too fast for friction, way off by ${(1000 * free).toFixed(3)} mm`,
    );
    expect(worst).toBeLessThan(1e-4);
    expect(free).toBeLessThan(1e-4);
  });

  it('that tilts has the box on it, up to nine tenths of the angle of friction', () => {
    let worst = 0;
    for (const spin of [1e-3, 5e-3, 0.02, 0.1]) {
      for (const x of [0, 1, 3]) {
        const tilt = { angularVelocity: spin };
        const { world, under, boxes } = ride(
          0.6,
          { type: 'kinematic', ...tilt },
          { x, velocity: [1.5 * spin, x * spin], ...tilt },
        );
        const from = under.transformWorldPointToLocal(boxes[0]!.getPosition())[0];
        const steps = Math.floor(Math.min(60, (0.9 * Math.atan(0.6)) / spin) / DT);
        for (let i = 1; i <= steps; i += 1) {
          world.step(DT);
          const slip = Math.abs(under.transformWorldPointToLocal(boxes[0]!.getPosition())[0] - from);
          worst = Math.max(worst, slip);
        }
      }
    }
    console.log(`tilted: slipped ${(1000 * worst).toFixed(3)} mm`);
    expect(worst).toBeLessThan(6e-4);
  });
});
