import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { describe, expect, it } from 'vitest';
import type * as source from '../../src/index.js';

// Limits, motors, breaking and springs of all kinds of joints at several time steps. From the bundle as built: much is measured.

const { phys2D } = (await import(
  /* @vite-ignore */ pathToFileURL(join(import.meta.dirname, '../../dist/phys2d.js')).href
)) as typeof source;

const GRAVITY = 10;
const STEPS = [1 / 30, 1 / 60, 1 / 120, 1 / 240];

function worldOf(gravity: number, substeps = 4): source.World {
  return phys2D.createWorld({ gravity: [0, gravity], substeps, allowSleeping: false });
}

/** What joints hold on to: in no world, as it need not be. */
function post(position: source.Vec2 = [0, 0]): source.RigidBody {
  return phys2D.createRigidBody({ type: 'static', position });
}

/** A body without drag that meets nothing. */
function bob(world: source.World, params: source.RigidBodyParams): source.RigidBody {
  const shapes = [phys2D.createCircleShape({ radius: 0.5, mask: 0 })];
  const body = phys2D.createRigidBody({ shapes, mass: 1, inertia: 1, linearDrag: 0, angularDrag: 0, ...params });
  world.addRigidBody(body);
  return body;
}

function energyOf(body: source.RigidBody): number {
  const [vx, vy] = body.getVelocity();
  return 0.5 * body.getMass() * (vx * vx + vy * vy) + 0.5 * body.getInertia() * body.getAngularVelocity() ** 2;
}

function distanceTo(body: source.RigidBody, [x, y]: source.Vec2 = [0, 0]): number {
  const [bx, by] = body.getPosition();
  return Math.sqrt((bx - x) ** 2 + (by - y) ** 2);
}

interface Limited {
  readonly bodies: readonly source.RigidBody[];
  /** m, rad. How far it is beyond its limit. */
  readonly beyond: () => number;
}

type Limit = (world: source.World, speed: number) => Limited;

/** Each comes to its limit at a speed, after 1 m or 1 rad. */
const STOPS: Record<string, Limit> = {
  'distance, upper': (world, speed) => {
    const body = bob(world, { position: [1, 0], velocity: [speed, 0] });
    world.addConstraint(
      phys2D.createDistanceConstraint({ bodyA: post(), bodyB: body, lowerBound: 0.5, upperBound: 2 }),
    );
    return { bodies: [body], beyond: () => distanceTo(body) - 2 };
  },
  'distance, lower': (world, speed) => {
    const body = bob(world, { position: [2, 0], velocity: [-speed, 0] });
    world.addConstraint(phys2D.createDistanceConstraint({ bodyA: post(), bodyB: body, lowerBound: 1, upperBound: 3 }));
    return { bodies: [body], beyond: () => 1 - distanceTo(body) };
  },
  'distance, two bodies': (world, speed) => {
    const body = bob(world, { position: [1, 0], velocity: [speed, 0] });
    const other = bob(world, { mass: 5, velocity: [-speed / 5, 0] });
    world.addConstraint(phys2D.createDistanceConstraint({ bodyA: other, bodyB: body, lowerBound: 0, upperBound: 2 }));
    return { bodies: [body, other], beyond: () => distanceTo(body, other.getPosition()) - 2 };
  },
  line: (world, speed) => {
    const body = bob(world, { velocity: [speed, 0] });
    const bounds = { lowerBound: -1, upperBound: 1 };
    world.addConstraint(phys2D.createLineConstraint({ bodyA: post(), bodyB: body, axis: [1, 0], ...bounds }));
    return { bodies: [body], beyond: () => body.getPosition()[0] - 1 };
  },
  angle: (world, speed) => {
    const body = bob(world, { angularVelocity: speed });
    world.addConstraint(phys2D.createAngleConstraint({ bodyA: post(), bodyB: body, lowerBound: -1, upperBound: 1 }));
    return { bodies: [body], beyond: () => body.getRotation() - 1 };
  },
  'angle with a ratio': (world, speed) => {
    const body = bob(world, { angularVelocity: -speed });
    const bounds = { ratio: -2, lowerBound: -1, upperBound: 2 };
    world.addConstraint(phys2D.createAngleConstraint({ bodyA: post(), bodyB: body, ...bounds }));
    return { bodies: [body], beyond: () => -2 * body.getRotation() - 2 };
  },
  pulley: (world, speed) => {
    const body = bob(world, { position: [1, 1], velocity: [0, speed] });
    const [pivot, left, anchor] = [post([1, 0]), post([-1, 0]), post([-1, 1])];
    const pulley = { bodyA: left, bodyB: anchor, bodyC: pivot, bodyD: body, lowerBound: 0, upperBound: 3 };
    world.addConstraint(phys2D.createPulleyConstraint({ ...pulley, ratio: 1 }));
    return { bodies: [body], beyond: () => distanceTo(body, [1, 0]) - 2 };
  },
};

describe('a limit that is reached at speed', () => {
  for (const [name, limit] of Object.entries(STOPS)) {
    it(`${name}: is not passed, and what met it stops there`, () => {
      let [most, left, beyond] = [0, 0, 0];
      for (const dt of STEPS) {
        for (const substeps of [1, 4]) {
          for (const speed of [0.5, 5, 50]) {
            const world = worldOf(0, substeps);
            const { bodies, beyond: measure } = limit(world, speed);
            const energy = (): number => bodies.reduce((sum, body) => sum + energyOf(body), 0);
            const start = energy();
            const steps = Math.ceil(2 / (speed * dt)) + 60;
            for (let i = 0; i < steps; i += 1) {
              world.step(dt);
              most = Math.max(most, energy() / start - 1);
              beyond = Math.max(beyond, measure());
            }
            left = Math.max(left, energy() / start);
            expect(measure()).toBeGreaterThan(-1e-6);
          }
        }
      }
      console.log(
        `${name}: ${beyond.toExponential(1)} beyond at most, energy ${most.toExponential(1)} above the start, ${left.toExponential(1)} left`,
      );
      expect(beyond).toBeLessThan(1e-12);
      expect(most).toBeLessThan(1e-12);
      expect(left).toBeLessThan(1e-12);
    });
  }

  it('a rope that tightens aslant takes the part of the velocity along it, and keeps the body on its circle', () => {
    let [off, beyond] = [0, 0];
    for (const dt of STEPS) {
      for (const speed of [0.5, 5]) {
        const world = worldOf(0);
        const body = bob(world, { position: [1, 0], velocity: [speed, speed] });
        world.addConstraint(
          phys2D.createDistanceConstraint({ bodyA: post(), bodyB: body, lowerBound: 0, upperBound: 2 }),
        );
        const start = energyOf(body);
        for (let t = 0; t < 10 / speed; t += dt) {
          world.step(dt);
          beyond = Math.max(beyond, distanceTo(body) - 2);
        }
        // It tightens at ((1 + √7) / 2, (√7 − 1) / 2): half of its speed is across the rope there, and of the energy an eighth.
        off = Math.max(off, Math.abs(energyOf(body) / start - 1 / 8));
      }
    }
    console.log(`aslant: ${(100 * off).toFixed(3)} % of the energy off, ${beyond.toExponential(1)} m too long`);
    expect(off).toBeLessThan(1e-5);
    expect(beyond).toBeLessThan(1e-12);
  });
});

/** Each is loaded with 100 kg. */
const LOADS: Record<string, Limit> = {
  'a rope after a fall of 3 m': (world) => {
    const body = bob(world, { position: [0.1, 0], mass: 100 });
    world.addConstraint(phys2D.createDistanceConstraint({ bodyA: post(), bodyB: body, lowerBound: 0, upperBound: 3 }));
    return { bodies: [body], beyond: () => distanceTo(body) - 3 };
  },
  'a slide with an end': (world) => {
    const [x, y] = [Math.cos(0.7), Math.sin(0.7)];
    const body = bob(world, { mass: 100 });
    const bounds = { lowerBound: -2, upperBound: 2 };
    world.addConstraint(phys2D.createLineConstraint({ bodyA: post(), bodyB: body, axis: [x, y], ...bounds }));
    const beyond = (): number => {
      const [px, py] = body.getPosition();
      return Math.max(px * x + py * y - 2, Math.abs(x * py - y * px));
    };
    return { bodies: [body], beyond };
  },
  'an arm of 2 m that is welded on': (world) => {
    const body = bob(world, { position: [2, 0], mass: 100, inertia: 130 });
    world.addConstraint(phys2D.createWeldConstraint({ bodyA: post(), bodyB: body, anchorA: [0, 0], anchorB: [-2, 0] }));
    return { bodies: [body], beyond: () => Math.max(Math.abs(body.getRotation()), distanceTo(body, [2, 0])) };
  },
};

describe('a limit under load', () => {
  for (const [name, load] of Object.entries(LOADS)) {
    it(`${name}: 100 kg do not stretch it`, () => {
      let [beyond, last] = [0, 0];
      for (const dt of STEPS) {
        const world = worldOf(GRAVITY);
        const { beyond: measure } = load(world, 0);
        for (let t = 0; t < 5; t += dt) {
          world.step(dt);
          beyond = Math.max(beyond, measure());
        }
        last = Math.max(last, measure());
      }
      console.log(`${name}: ${beyond.toExponential(1)} beyond at most, ${last.toExponential(1)} at the end`);
      expect(beyond).toBeLessThan(1e-12);
    });
  }

  it('a flap that falls onto its stop does not pass it; its hinge gapes by 2 mm at most, by 2 cm for steps of 1/30 s', () => {
    const figures: string[] = [];
    for (const dt of STEPS) {
      for (const mass of [1, 100]) {
        const world = worldOf(GRAVITY);
        const body = bob(world, { position: [1, 0], mass, inertia: 0.3 * mass });
        const bodies = { bodyA: post(), bodyB: body };
        world.addConstraint(phys2D.createPointConstraint({ ...bodies, anchorA: [0, 0], anchorB: [-1, 0] }));
        world.addConstraint(phys2D.createAngleConstraint({ ...bodies, lowerBound: -0.5, upperBound: 0.5 }));
        let [beyond, widest, gap] = [0, 0, 0];
        for (let t = 0; t < 5; t += dt) {
          world.step(dt);
          const [x, y] = body.transformLocalPointToWorld([-1, 0]);
          gap = Math.sqrt(x * x + y * y);
          widest = Math.max(widest, gap);
          beyond = Math.max(beyond, body.getRotation() - 0.5);
        }
        figures.push((1000 * widest).toFixed(2));
        expect(beyond).toBeLessThan(1e-12);
        expect(widest).toBeLessThan(dt > 1 / 60 ? 0.02 : 0.002);
        expect(gap).toBeLessThan(1e-6);
      }
    }
    console.log(`flaps: the hinge gapes by ${figures.join(', ')} mm`);
  });
});

describe('a motor', () => {
  it('against a torque has what its maxForce leaves, to the last digits, and no more than its rate', () => {
    let off = 0;
    for (const dt of STEPS) {
      for (const substeps of [1, 4, 8]) {
        for (const share of [0.9, 1.1, 2]) {
          const world = worldOf(0, substeps);
          const body = bob(world, { inertia: 2 });
          body.setTorque(-10);
          const limits = { rate: 3, maxForce: 10 * share };
          world.addConstraint(phys2D.createMotorConstraint({ bodyA: post(), bodyB: body, ...limits }));
          const steps = Math.round(8 / dt);
          for (let i = 1; i <= steps; i += 1) {
            world.step(dt);
            const wanted = Math.min(3, ((10 * share - 10) / 2) * i * dt);
            off = Math.max(off, Math.abs(body.getAngularVelocity() - wanted));
          }
        }
      }
    }
    console.log(`motors: ${off.toExponential(1)} rad/s off at most`);
    expect(off).toBeLessThan(1e-9);
  });
});

/** Each holds 3 kg, 2 m below the origin. */
const HOLDERS: Record<string, (body: source.RigidBody, config: source.ConstraintConfig) => source.Constraint> = {
  point: (bodyB, config) => phys2D.createPointConstraint({ bodyA: post(), bodyB, anchorA: [0, 2], ...config }),
  weld: (bodyB, config) => phys2D.createWeldConstraint({ bodyA: post(), bodyB, anchorA: [0, 2], ...config }),
  distance: (bodyB, config) =>
    phys2D.createDistanceConstraint({ bodyA: post(), bodyB, lowerBound: 2, upperBound: 2, ...config }),
  'distance, rope': (bodyB, config) =>
    phys2D.createDistanceConstraint({ bodyA: post(), bodyB, lowerBound: 0, upperBound: 2, ...config }),
  line: (bodyB, config) =>
    phys2D.createLineConstraint({ bodyA: post(), bodyB, axis: [1, 0], anchorA: [0, 2], ...config }),
  pulley: (bodyB, config) => {
    const other = { bodyC: post([5, 0]), bodyD: post([5, 1]) };
    const bounds = { ratio: 1, lowerBound: 3, upperBound: 3 };
    return phys2D.createPulleyConstraint({ bodyA: post(), bodyB, ...other, ...bounds, ...config });
  },
  custom: (body, config) =>
    phys2D.createCustomConstraint({
      dimension: 1,
      bodies: [body],
      position(data, index) {
        data[index] = body.getPosition()[1] - 2;
      },
      jacobian(data, index) {
        data[index] = 0;
        data[index + 1] = 1;
        data[index + 2] = 0;
      },
      ...config,
    }),
};

describe('breaking', () => {
  for (const [name, hold] of Object.entries(HOLDERS)) {
    it(`${name}: breaks under 0.01 % more than maxForce, not under 0.01 % less`, () => {
      for (const dt of STEPS) {
        for (const share of [0.9999, 1.0001]) {
          const world = worldOf(GRAVITY);
          const body = bob(world, { position: [0, 2], mass: 3 });
          const joint = hold(body, { breakUnderForce: true, maxForce: (3 * GRAVITY) / share });
          world.addConstraint(joint);
          for (let t = 0; t < 2; t += dt) {
            world.step(dt);
          }
          expect(joint.world === null, `${share} of what it holds, steps of ${dt} s`).toBe(share > 1);
        }
      }
    });
  }
});

type Spring = { stiff: false; frequency: number; damping: number };

/** Each is pulled out by 0.1 m or rad. */
const SPRINGS: Record<
  string,
  (body: source.RigidBody, spring: Spring) => { joint: source.Constraint; out: () => number }
> = {
  point: (bodyB, spring) => {
    bodyB.setPosition([0, 0.1]);
    const joint = phys2D.createPointConstraint({ bodyA: post(), bodyB, ...spring });
    return { joint, out: () => bodyB.getPosition()[1] };
  },
  'weld, pulled': (bodyB, spring) => {
    bodyB.setPosition([0, 0.1]);
    const joint = phys2D.createWeldConstraint({ bodyA: post(), bodyB, ...spring });
    return { joint, out: () => bodyB.getPosition()[1] };
  },
  'weld, turned': (bodyB, spring) => {
    bodyB.setRotation(0.1);
    const joint = phys2D.createWeldConstraint({ bodyA: post(), bodyB, ...spring });
    return { joint, out: () => bodyB.getRotation() };
  },
  distance: (bodyB, spring) => {
    bodyB.setPosition([4.1, 0]);
    const bounds = { lowerBound: 4, upperBound: 4 };
    const joint = phys2D.createDistanceConstraint({ bodyA: post(), bodyB, ...bounds, ...spring });
    return { joint, out: () => bodyB.getPosition()[0] - 4 };
  },
  'line, across': (bodyB, spring) => {
    bodyB.setPosition([0, 0.1]);
    const joint = phys2D.createLineConstraint({ bodyA: post(), bodyB, axis: [1, 0], ...spring });
    return { joint, out: () => bodyB.getPosition()[1] };
  },
  'line, along': (bodyB, spring) => {
    bodyB.setPosition([2.1, 0]);
    const bounds = { lowerBound: 2, upperBound: 2 };
    const joint = phys2D.createLineConstraint({ bodyA: post(), bodyB, axis: [1, 0], ...bounds, ...spring });
    return { joint, out: () => bodyB.getPosition()[0] - 2 };
  },
  'angle with a ratio': (bodyB, spring) => {
    bodyB.setRotation(-0.05);
    const joint = phys2D.createAngleConstraint({ bodyA: post(), bodyB, ratio: -2, ...spring });
    return { joint, out: () => -2 * bodyB.getRotation() };
  },
  pulley: (bodyD, spring) => {
    bodyD.setPosition([1, 2.1]);
    const [bodyA, bodyB, bodyC] = [post([-1, 0]), post([-1, 2]), post([1, 0])];
    const bounds = { ratio: 1, lowerBound: 4, upperBound: 4 };
    const joint = phys2D.createPulleyConstraint({ bodyA, bodyB, bodyC, bodyD, ...bounds, ...spring });
    return { joint, out: () => bodyD.getPosition()[1] - 2 };
  },
};

/** How far a spring that was let go 0.1 out is out after a time. */
function springAt(frequency: number, damping: number, time: number): number {
  const w = 2 * Math.PI * frequency;
  if (damping === 1) {
    return 0.1 * (1 + w * time) * Math.exp(-w * time);
  }
  const damped = w * Math.sqrt(1 - damping * damping);
  const wave = Math.cos(damped * time) + ((damping * w) / damped) * Math.sin(damped * time);
  return 0.1 * Math.exp(-damping * w * time) * wave;
}

describe('a spring', () => {
  for (const [name, build] of Object.entries(SPRINGS)) {
    it(`${name}: follows its formula over two periods, the nearer the shorter the sub-steps, and never swings farther`, () => {
      const figures: string[] = [];
      for (const dt of STEPS) {
        for (const substeps of [4, 8]) {
          let off = 0;
          for (const frequency of [1, 2, 4]) {
            // The scheme damps by w · h / 2 by itself: what is to be damped less cannot be.
            for (const damping of [0.25, 0.5, 1]) {
              const world = worldOf(0, substeps);
              const body = bob(world, { mass: 3, inertia: 2 });
              const { joint, out } = build(body, { stiff: false, frequency, damping });
              world.addConstraint(joint);
              const steps = Math.floor(2 / (frequency * dt));
              const turn = 2 * Math.PI * frequency * (dt / substeps);
              let worst = 0;
              for (let i = 1; i <= steps; i += 1) {
                world.step(dt);
                worst = Math.max(worst, Math.abs(out() - springAt(frequency, damping, i * dt)) / 0.1);
                expect(Math.abs(out())).toBeLessThanOrEqual(0.1);
              }
              // As a share of how far the spring turns in a sub-step, rad.
              off = Math.max(off, worst / turn);
            }
          }
          figures.push(off.toFixed(3));
        }
      }
      console.log(`spring, ${name}: off by so much of 0.1, for each radian in a sub-step: ${figures.join(', ')}`);
      for (const figure of figures) {
        expect(Number(figure)).toBeLessThan(0.27);
      }
    });
  }

  it('without damping loses height as one of the damping w · h / 2 does', () => {
    let off = 0;
    for (const dt of STEPS) {
      for (const frequency of [0.5, 1, 2]) {
        const world = worldOf(0);
        const body = bob(world, { position: [0, 0.1] });
        const spring: Spring = { stiff: false, frequency, damping: 0 };
        world.addConstraint(phys2D.createPointConstraint({ bodyA: post(), bodyB: body, ...spring }));
        const steps = Math.round(4 / (frequency * dt));
        let highest = 0;
        for (let i = 1; i <= steps; i += 1) {
          world.step(dt);
          const isLate = i * dt > 3.5 / frequency;
          highest = isLate ? Math.max(highest, body.getPosition()[1]) : 0;
        }
        const own = (Math.PI * frequency * dt) / 4;
        off = Math.max(off, Math.abs(highest / springAt(frequency, own, 4 / frequency) - 1));
      }
    }
    console.log(`undamped springs: height after four periods off by ${(100 * off).toFixed(2)} % from that`);
    expect(off).toBeLessThan(0.01);
  });
});
