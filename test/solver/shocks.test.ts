import { describe, expect, it } from 'vitest';
import { type Constraint, phys2D, type RigidBody, type Shape } from '../../src/index.js';
import { add, energyOf, kineticOf, staticBody, steps, tie } from '../conformance/setting.js';

// What falls on something without any elasticity stays on it, and gives it what it had: also where that lies on something else, or is lighter.

const PHASES = 6;

function material(density: number, elasticity: number) {
  return phys2D.createMaterial({ density, elasticity });
}

function box(density = 1, elasticity = 0): Shape {
  return phys2D.createPolygonShape({
    vertices: phys2D.createBoxVertices(1, 1),
    material: material(density, elasticity),
  });
}

function disc(density = 1, elasticity = 0): Shape {
  return phys2D.createCircleShape({ radius: 0.5, material: material(density, elasticity) });
}

interface Fall {
  readonly lower: () => Shape;
  readonly upper: () => Shape;
  readonly count?: number;
  readonly substeps?: number;
}

/** m/s. How fast it comes up again at most in a second after it fell on a column at rest, at whatever moment of a step it gets there. */
function reboundOf({ lower, upper, count = 1, substeps = 4 }: Fall, speed: number): number {
  let fastest = 0;
  for (let phase = 0; phase < PHASES; phase += 1) {
    const world = phys2D.createWorld({ gravity: [0, 10], substeps });
    const vertices = phys2D.createRectangleVertices(-50, 0, 50, 5);
    add(world, staticBody({ shapes: [phys2D.createPolygonShape({ vertices })] }));
    for (let i = 0; i < count; i += 1) {
      add(world, phys2D.createRigidBody({ shapes: [lower()], position: [0, -0.5 - i] }));
    }
    steps(world, 60);
    const height = count + 0.8 + (phase * speed) / (60 * PHASES);
    const top: RigidBody = phys2D.createRigidBody({
      shapes: [upper()],
      position: [0, -height],
      velocity: [0, speed],
    });
    add(world, top);
    for (let i = 0; i < 60; i += 1) {
      world.step(1 / 60);
      fastest = Math.max(fastest, -top.getVelocity()[1]);
    }
  }
  return fastest;
}

const falls: Record<string, Fall> = {
  'a disc on a disc': { lower: disc, upper: disc },
  'a box on a box': { lower: box, upper: box },
  'a disc on a box': { lower: box, upper: disc },
  'a box on one of a tenth of its mass': { lower: box, upper: () => box(10) },
  'a box on one of a fiftieth of its mass': { lower: box, upper: () => box(50) },
  'a box on one of ten times its mass': { lower: () => box(10), upper: box },
  'a box on a tower of five': { lower: box, upper: box, count: 5 },
  'a disc on a tower of three': { lower: box, upper: disc, count: 3 },
  'a disc on a disc, one sub-step': { lower: disc, upper: disc, substeps: 1 },
  'a disc on a disc, eight sub-steps': { lower: disc, upper: disc, substeps: 8 },
};

describe.each([1, 6, 20])('at %f m/s', (speed) => {
  it.each(Object.keys(falls))('%s stays there', (name) => {
    expect(reboundOf(falls[name]!, speed)).toBeLessThan(0.1);
  });

  it('elasticity is no more than it is where that which is struck lies on something', () => {
    for (const elasticity of [0.05, 0.1]) {
      const upper = () => box(10, elasticity);
      expect(reboundOf({ lower: () => box(1, elasticity), upper }, speed)).toBeLessThan(elasticity * speed + 0.1);
    }
  });
});

it('the impulses that are told are what the bodies were given', () => {
  const world = phys2D.createWorld({ gravity: [0, 0] });
  const free = { linearDrag: 0, angularDrag: 0 };
  const target = phys2D.createRigidBody({ shapes: [box()], ...free });
  const behind = phys2D.createRigidBody({ shapes: [box()], position: [1, 0], ...free });
  const shot = phys2D.createRigidBody({ shapes: [box(10)], position: [-2, 0], velocity: [6, 0], ...free });
  for (const body of [target, behind, shot]) add(world, body);
  let told = 0;
  for (let i = 0; i < 60; i += 1) {
    world.step(1 / 60);
    for (const arbiter of world.dynamicArbiters) {
      if (arbiter.bodyA === shot || arbiter.bodyB === shot) {
        told += Math.abs(arbiter.getImpulseForBody(shot)[0]!);
      }
    }
  }
  // 10 kg at 6 m/s, then 12 kg together at 5 m/s.
  for (const body of [target, behind, shot]) expect(body.getVelocity()[0]).toBeCloseTo(5, 1);
  expect(told).toBeCloseTo(10 * (6 - shot.getVelocity()[0]), 9);
});

/** m/s. How fast the whole of what joints hold together comes up again at most after it fell on the ground. */
function wholeReboundOf(build: () => [RigidBody[], Constraint[]], speed: number): number {
  let fastest = 0;
  for (let phase = 0; phase < PHASES; phase += 1) {
    const world = phys2D.createWorld({ gravity: [0, 10] });
    const vertices = phys2D.createRectangleVertices(-50, 0, 50, 5);
    add(world, staticBody({ shapes: [phys2D.createPolygonShape({ vertices })] }));
    const [bodies, constraints] = build();
    for (const body of bodies) {
      const [x, y] = body.getPosition();
      body.setPosition([x!, y! - 0.3 - (phase * speed) / (60 * PHASES)]);
      body.setVelocity([0, speed]);
      add(world, body);
    }
    tie(world, ...constraints);
    const mass = bodies.reduce((sum, body) => sum + body.getMass(), 0);
    for (let i = 0; i < 60; i += 1) {
      world.step(1 / 60);
      const momentum = bodies.reduce((sum, body) => sum - body.getMass() * body.getVelocity()[1]!, 0);
      fastest = Math.max(fastest, momentum / mass);
    }
  }
  return fastest;
}

/** A heavy chassis on two light wheels. */
function cart(): [RigidBody[], Constraint[]] {
  const plate = phys2D.createPolygonShape({ vertices: phys2D.createBoxVertices(2, 0.5), material: material(5, 0) });
  const bodyA = phys2D.createRigidBody({ shapes: [plate], position: [0, -1] });
  const wheels = [-0.8, 0.8].map((x) => {
    const shape = phys2D.createCircleShape({ radius: 0.4, material: material(1, 0) });
    return phys2D.createRigidBody({ shapes: [shape], position: [x, -0.4] });
  });
  const axles = wheels.map((bodyB) => {
    const [x] = bodyB.getPosition();
    return phys2D.createPointConstraint({ bodyA, bodyB, anchorA: [x!, 0.6], ignoreInteractions: true });
  });
  return [[bodyA, ...wheels], axles];
}

/** The same with motors that turn the wheels, … */
function driven(): [RigidBody[], Constraint[]] {
  const [bodies, axles] = cart();
  const [bodyA, ...wheels] = bodies;
  const motors = wheels.map((bodyB) => phys2D.createMotorConstraint({ bodyA: bodyA!, bodyB, rate: 5, maxForce: 20 }));
  return [bodies, [...axles, ...motors]];
}

/** … or with wheels on springs, which are guided; `load` times as heavy. */
function sprung(load: number): [RigidBody[], Constraint[]] {
  const [[bodyA, ...wheels]] = cart();
  bodyA!.setMass(load * bodyA!.getMass());
  bodyA!.setInertia(load * bodyA!.getInertia());
  const springs = wheels.flatMap((bodyB) => {
    const [x] = bodyB.getPosition();
    const bodies = { bodyA: bodyA!, bodyB };
    const guide = { anchorA: [x!, 0.6], axis: [0, 1], lowerBound: -0.2, upperBound: 0.2 } as const;
    const spring = { lowerBound: 0.6, upperBound: 0.6, stiff: false, frequency: 4 };
    return [
      phys2D.createLineConstraint({ ...bodies, ...guide, ignoreInteractions: true }),
      phys2D.createDistanceConstraint({ ...bodies, anchorA: [x!, 0], ...spring }),
    ];
  });
  return [[bodyA!, ...wheels], springs];
}

/** Two boxes, one on the other. */
function welded(): [RigidBody[], Constraint[]] {
  const [bodyA, bodyB] = [-0.5, -1.5].map((y) => phys2D.createRigidBody({ shapes: [box()], position: [0, y] }));
  const weld = phys2D.createWeldConstraint({ bodyA: bodyA!, bodyB: bodyB!, anchorA: [0, -0.5], anchorB: [0, 0.5] });
  return [[bodyA!, bodyB!], [weld]];
}

it.each([1, 3, 6, 20])('what rigid joints hold together stays where it fell, too, at %f m/s', (speed) => {
  expect(wholeReboundOf(cart, speed)).toBeLessThan(0.05);
  expect(wholeReboundOf(welded, speed)).toBeLessThan(0.05);
});

it.each([1, 3, 6, 20])('a motor or springs throw nothing up, at %f m/s', (speed) => {
  expect(wholeReboundOf(driven, speed)).toBeLessThan(0.05);
  // As heavy as it is it lies on the stops of the guides.
  expect(wholeReboundOf(() => sprung(4), speed)).toBeLessThan(0.05);
});

it('a heap is left to the sweeps of the step', () => {
  const world = phys2D.createWorld({ gravity: [0, 10] });
  add(
    world,
    staticBody({ shapes: [phys2D.createPolygonShape({ vertices: phys2D.createRectangleVertices(-50, 0, 50, 5) })] }),
  );
  for (let row = 0; row < 10; row += 1) {
    for (let i = 0; i < 10 - row; i += 1) {
      add(world, phys2D.createRigidBody({ shapes: [box()], position: [i + row / 2, -0.5 - row] }));
    }
  }
  steps(world, 60);
  const ball = phys2D.createRigidBody({ shapes: [disc(5)], position: [4.5, -12], velocity: [0, 10] });
  add(world, ball);
  steps(world, 240);
  for (const body of world.rigidBodies) expect(body.getVelocity()[1]).toBeCloseTo(0, 2);
});

describe('a heavy disc that strikes a light one, which touches another heavy one', () => {
  it.each([10, 100, 1000])('goes on with them at half its speed, %f times as heavy', (ratio) => {
    for (const speed of [1, 5, 20]) {
      const world = phys2D.createWorld({ gravity: [0, 0] });
      const free = { linearDrag: 0, angularDrag: 0 };
      const [striker, light, last] = [-1.05, 0, 1].map((x) => {
        const shapes = [disc(x === 0 ? 1 : ratio)];
        return phys2D.createRigidBody({ shapes, position: [x, 0], velocity: [x < 0 ? speed : 0, 0], ...free });
      });
      for (const body of [striker!, light!, last!]) add(world, body);
      let energy = Infinity;
      for (let step = 0; step < 60; step += 1) {
        world.step(1 / 60);
        const now = kineticOf(world);
        expect(now, `${speed} m/s, step ${step}`).toBeLessThan(1.002 * energy);
        energy = now;
      }
      // All three go on together, of which the light one has its share.
      const share = ratio / (2 * ratio + 1);
      for (const body of [striker!, last!]) expect(body.getVelocity()[0] / speed / share).toBeCloseTo(1, 1);
    }
  });
});

describe('a hinged bridge of boards that balls without elasticity fell on', () => {
  it.each([8, 12, 16])('is given no energy by them, %i boards', (count) => {
    const material = phys2D.createMaterial({ elasticity: 0 });
    const world = phys2D.createWorld({ gravity: [0, 10] });
    const board = (x: number, type: 'static' | 'dynamic') => {
      const shapes = [phys2D.createPolygonShape({ vertices: phys2D.createBoxVertices(1, 0.2), material })];
      const body = phys2D.createRigidBody({ type, shapes, position: [x, 0], mass: 1, linearDrag: 0, angularDrag: 0 });
      add(world, body);
      return body;
    };
    let bodyA = board(-count / 2 - 0.5, 'static');
    for (let i = 0; i <= count; i += 1) {
      const bodyB = board(i - count / 2 + 0.5, i < count ? 'dynamic' : 'static');
      const anchors = { anchorA: [0.5, 0], anchorB: [-0.5, 0] } as const;
      tie(world, phys2D.createPointConstraint({ bodyA, bodyB, ...anchors, ignoreInteractions: true }));
      bodyA = bodyB;
    }
    steps(world, 120);
    for (let i = 0; i < 4; i += 1) {
      const shapes = [phys2D.createCircleShape({ radius: 0.3, material })];
      const x = 1 - count / 2 + ((count - 2) * (i + 0.5)) / 4;
      add(world, phys2D.createRigidBody({ shapes, position: [x, -2 - 0.3 * i], mass: 1 }));
    }
    steps(world, 180);
    let least = Infinity;
    for (let step = 0; step < 720; step += 1) {
      world.step(1 / 60);
      const energy = energyOf(world);
      least = Math.min(least, energy);
      expect(energy, `step ${step}`).toBeLessThan(least + 10);
    }
  });
});
