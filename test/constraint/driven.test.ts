import { describe, expect, it } from 'vitest';
import { type LineConstraint, phys2D, type RigidBody, type Vec2, type World } from '../../src/index.js';
import { add, addFloor, box, boxBody, heavy, pin, pinAt, staticBody, steps, tie } from '../conformance/setting.js';
import { generator } from '../scenes/mixed.js';

// What a motor drives turns as fast as it is asked to, however light that is, and however heavy what hangs on it: a sweep hands on little of what a motor gives.

/** The least and the greatest angular velocity of a body in so many steps. */
function rangeOf(world: World, body: RigidBody, count: number): [least: number, most: number] {
  const speeds = Array.from({ length: count }, () => {
    steps(world, 1);
    return body.getAngularVelocity();
  });
  return [Math.min(...speeds), Math.max(...speeds)];
}

describe('a train of two to six gears of 0.1 to 100 kg', () => {
  /** The angular velocity of the first, which a motor without a limit turns at 5 rad/s, from 25 s on. */
  function firstOf(seed: number, breaks: boolean): [number, number] {
    const random = generator(seed);
    const world = heavy({ allowSleeping: false });
    const frame = staticBody();
    const wheels: RigidBody[] = [];
    const count = 2 + Math.floor(5 * random());
    for (let i = 0; i < count; i += 1) {
      const radius = 0.2 + 0.8 * random();
      const mass = 0.1 * 1000 ** random();
      const inertia = (mass * radius * radius) / 2;
      const wheel = phys2D.createRigidBody({ mass, inertia, position: [2 * i, 0], linearDrag: 0, angularDrag: 0 });
      add(world, wheel);
      pin(world, frame, [2 * i, 0], wheel, [0, 0]);
      const ratio = -0.3 * 10 ** random();
      const before = wheels.at(-1);
      if (before !== undefined) {
        const bounds = { lowerBound: 0, upperBound: 0 };
        tie(world, phys2D.createAngleConstraint({ bodyA: before, bodyB: wheel, ratio, ...bounds }));
      }
      wheels.push(wheel);
    }
    const breaking = breaks ? { breakUnderForce: true, maxForce: 1e9 } : {};
    tie(world, phys2D.createMotorConstraint({ bodyA: frame, bodyB: wheels[0]!, rate: 5, ...breaking }));
    steps(world, 1500);
    return rangeOf(world, wheels[0]!, 300);
  }

  // Of the first sixty those that swung for ever between 2 and 8 rad/s, or the like, when a motor asked for no sweeps.
  it.each([
    { breaks: false, seeds: [6, 22, 27, 37, 50, 57, 59] },
    { breaks: true, seeds: [22, 27, 37, 50, 57, 59] },
  ])('turns at the rate of its motor, one that may break: $breaks', ({ breaks, seeds }) => {
    const off = seeds.filter((seed) => firstOf(seed, breaks).some((speed) => Math.abs(speed - 5) > 0.25));
    expect(off).toEqual([]);
  });
});

describe('the motor of a slider crank', () => {
  it.each([
    { crank: 2, rod: 0.5, slider: 4, maxForce: 30, within: [5.8, 6.4] },
    { crank: 5, rod: 5, slider: 50, maxForce: 300, within: [5.7, 8] },
    { crank: 10, rod: 1, slider: 20, maxForce: 200, within: [5.8, 6.3] },
  ])(
    'does not whip it at its dead points: $crank, $rod and $slider kg/m²',
    ({ crank, rod, slider, maxForce, within }) => {
      const world = heavy({ gravity: [0, 10] });
      const frame = staticBody();
      const [turning, pushing, sliding] = (
        [
          [crank, 0.5, 1, 0.1],
          [rod, 2.25, 2.5, 0.1],
          [slider, 3.5, 0.5, 0.5],
        ] as const
      ).map(([density, x, width, height]) => {
        const shapes = [box(width, height, { material: phys2D.createMaterial({ density, elasticity: 0 }) })];
        return phys2D.createRigidBody({ position: [x, 0], shapes, linearDrag: 0, angularDrag: 0 });
      }) as [RigidBody, RigidBody, RigidBody];
      add(world, turning, pushing, sliding);
      pin(world, frame, [0, 0], turning, [-0.5, 0]);
      pin(world, turning, [0.5, 0], pushing, [-1.25, 0]);
      pin(world, pushing, [1.25, 0], sliding, [0, 0]);
      const rail = { bodyA: frame, bodyB: sliding };
      tie(world, phys2D.createLineConstraint({ ...rail, axis: [1, 0], lowerBound: -50, upperBound: 50 }));
      tie(world, phys2D.createAngleConstraint(rail));
      tie(world, phys2D.createMotorConstraint({ bodyA: frame, bodyB: turning, rate: 6, maxForce }));
      steps(world, 120);
      const [least, most] = rangeOf(world, turning, 480);
      expect(least).toBeGreaterThan(within[0]!);
      expect(most).toBeLessThan(within[1]!);
    },
  );
});

describe('brakes that are too weak to stop what hangs on a rope of twenty links', () => {
  /** How often the joints of the rope were swept over in a sub-step, on the average over 4 s, while it swings. */
  function sweepsOf(maxForce: number): number {
    const world = heavy({ allowSleeping: false });
    let before = staticBody();
    add(world, before);
    for (let i = 0; i < 20; i += 1) {
      const link = boxBody(1, 0.2, { position: [i + 0.5, 0] });
      add(world, link);
      pinAt(world, before, link, [i, 0]);
      tie(world, phys2D.createMotorConstraint({ bodyA: before, bodyB: link, rate: 0, maxForce }));
      before = link;
    }
    let sum = 0;
    for (let i = 0; i < 240; i += 1) {
      steps(world, 1);
      sum += world.solver.joints.groups[0]!.sweeps;
    }
    return sum / 240;
  }

  it('ask for hardly more sweeps than no brakes do', () => {
    expect(sweepsOf(0.05)).toBeLessThan(sweepsOf(0) + 1);
  });
});

describe('a scissor lift, pushed together by three tenths in three seconds', () => {
  /** Bars of 1 kg across each other, stage upon stage, the lowest on a hinge and a slide of a frame whose origin is at the hinge, the top under a load. @returns the load and the slide. */
  function lift(
    world: World,
    frame: RigidBody,
    stages: number,
    load: number,
  ): { top: RigidBody; slide: LineConstraint } {
    const bar = (from: Vec2, to: Vec2, mass: number): RigidBody => {
      const [x, y] = [to[0] - from[0], to[1] - from[1]];
      const length = Math.hypot(x, y);
      const body = phys2D.createRigidBody({
        mass,
        inertia: (mass * (length * length + 0.01)) / 12,
        position: [(from[0] + to[0]) / 2, (from[1] + to[1]) / 2],
        rotation: Math.atan2(y, x),
        linearDrag: 0,
        angularDrag: 0,
      });
      add(world, body);
      return body;
    };
    const rail = (bodyA: RigidBody, anchorA: Vec2, bodyB: RigidBody, at: Vec2, upperBound: number): LineConstraint => {
      const anchors = { anchorA, anchorB: bodyB.transformWorldPointToLocal(at) };
      const slide = phys2D.createLineConstraint({ bodyA, bodyB, axis: [1, 0], ...anchors, lowerBound: 0, upperBound });
      tie(world, slide);
      return slide;
    };
    let [before, beside] = [frame, frame];
    let slide: LineConstraint | undefined;
    for (let i = 0; i < stages; i += 1) {
      const y = -i / 2;
      const rising = bar([0, y], [1, y - 0.5], 1);
      const falling = bar([1, y], [0, y - 0.5], 1);
      pinAt(world, rising, falling, [0.5, y - 0.25]);
      pinAt(world, before, i === 0 ? rising : falling, i === 0 ? [0, 0] : [1, y]);
      if (i === 0) slide = rail(frame, [0, 0], falling, [1, 0], 1);
      else pinAt(world, beside, rising, [0, y]);
      [before, beside] = [rising, falling];
    }
    const top = bar([0, -stages / 2], [1, -stages / 2], load);
    pinAt(world, beside, top, [0, -stages / 2]);
    rail(top, [-0.5, 0], before, [1, -stages / 2], 1.1);
    return { top, slide: slide! };
  }

  it.each([
    { stages: 3, load: 50, lies: false },
    { stages: 4, load: 100, lies: false },
    { stages: 6, load: 20, lies: false },
    { stages: 3, load: 50, lies: true },
    { stages: 6, load: 20, lies: true },
  ])('stands still: $stages stages under $load kg, on a base that lies on the ground: $lies', (params) => {
    const { stages, load, lies } = params;
    const world = heavy({ allowSleeping: false });
    const base = lies ? boxBody(4, 0.2, { mass: 50 }) : staticBody();
    if (lies) {
      addFloor(world, { position: [0, 0.6] });
      add(world, base);
    }
    const { top, slide } = lift(world, base, stages, load);
    // The base rocks on the ground for a while.
    for (let i = 1; i <= (lies ? 900 : 300); i += 1) {
      const width = 1 - 0.3 * Math.min(1, i / 180);
      slide.setLowerBound(width);
      slide.setUpperBound(width);
      steps(world, 1);
    }
    const pushes: number[] = [];
    for (let i = 0; i < 120; i += 1) {
      steps(world, 1);
      pushes.push(-slide.getImpulseForBody(slide.bodyB)[0]! * 60);
      expect(Math.hypot(...top.getVelocity())).toBeLessThan(lies ? 0.01 : 1e-3);
    }
    // Each stage is the other side of a triangle; and by virtual work the slide bears what weighs on all of them.
    const height = Math.sqrt(1.25 - 0.49);
    const weights = Array.from({ length: stages }, (_, i) => 2 * i + 1).reduce(
      (sum, weight) => sum + weight,
      load * stages,
    );
    expect(top.getPosition()[1]).toBeCloseTo(-stages * height, 2);
    expect(Math.min(...pushes) / ((10 * weights * 0.7) / height)).toBeGreaterThan(lies ? 0.95 : 0.99);
    expect(Math.max(...pushes) / ((10 * weights * 0.7) / height)).toBeLessThan(lies ? 1.05 : 1.01);
  });
});
