import { expect, it } from 'vitest';
import { validate } from '../../src/audit/index.js';
import { type Constraint, phys2D, type RigidBody, type World } from '../../src/index.js';
import { add, addFloor, boxBody, heavy, steps } from '../conformance/setting.js';
import { type Dice, dice } from '../quality/dice.js';

// All that is extreme but legal at once, at random: sizes of 1 mm to 1000 km, speeds up to 1e5 m/s, masses of 1 mg to a million tons, steps of 10 µs to 1 s.
// All stays finite and consistent, nothing has to be frozen for it, and no step hangs: the time limit of tests would tell.

const BODIES = 24;
const STEPS = 12;

function makeBody({ within, scaled, pick }: Dice): RigidBody {
  const size = scaled(1e-3, 1e6);
  const place = size * scaled(0.01, 10);
  const speed = pick([0, scaled(1, 1e5)]);
  const spin = pick([1, 1e3]);
  return phys2D.createRigidBody({
    type: pick(['dynamic', 'dynamic', 'dynamic', 'static', 'kinematic']),
    position: [within(-place, place), within(-place, place)],
    rotation: within(-10, 10),
    velocity: [within(-speed, speed), within(-speed, speed)],
    angularVelocity: within(-spin, spin),
    bullet: pick([true, false]),
    mass: pick([undefined, scaled(1e-6, 1e9)]),
    shapes: [
      pick([
        phys2D.createCircleShape({ radius: size / 2 }),
        phys2D.createPolygonShape({ vertices: phys2D.createBoxVertices(size, size * scaled(0.1, 1)) }),
      ]),
    ],
  });
}

function makeConstraint({ scaled, within, pick }: Dice, bodyA: RigidBody, bodyB: RigidBody): Constraint {
  const common = {
    bodyA,
    bodyB,
    stiff: pick([true, false]),
    frequency: scaled(0.1, 100),
    maxForce: scaled(1, 1e9),
    breakUnderForce: pick([true, false]),
  };
  const bounds = { lowerBound: -1, upperBound: 1 };
  const ratio = scaled(1e-3, 1e3);
  return pick([
    () => phys2D.createPointConstraint(common),
    () => phys2D.createWeldConstraint({ ...common, phase: within(-3, 3) }),
    () => phys2D.createAngleConstraint({ ...common, ...bounds, ratio }),
    () => phys2D.createDistanceConstraint({ ...common, lowerBound: 0, upperBound: scaled(1e-3, 1e6) }),
    () => phys2D.createLineConstraint({ ...common, ...bounds, axis: [within(-1, 1), 1] }),
    () => phys2D.createMotorConstraint({ ...common, rate: scaled(0.1, 1e5), ratio }),
  ])();
}

function build(random: Dice): World {
  const { scaled, pick } = random;
  const world = phys2D.createWorld({ gravity: [0, scaled(0.01, 1000)], substeps: pick([1, 2, 4]) });
  const bodies = Array.from({ length: BODIES }, () => makeBody(random));
  for (const body of bodies) {
    world.addRigidBody(body);
  }
  for (let i = 0; i < BODIES / 4; i += 1) {
    const bodyA = pick(bodies);
    const bodyB = pick(bodies.filter((body) => body !== bodyA));
    world.addConstraint(makeConstraint(random, bodyA, bodyB));
  }
  return world;
}

it.each(Array.from({ length: 40 }, (_, i) => i + 1))('extremes by seed %d', (seed) => {
  const random = dice(seed);
  const world = build(random);
  const frozen: RigidBody[] = [];
  world.addEventListener('nonfinite', (body) => void frozen.push(body));
  for (let i = 0; i < STEPS; i += 1) {
    world.step(random.scaled(1e-5, 1));
    validate(world);
  }
  expect(world.timeStamp).toBe(STEPS);
  expect(frozen).toEqual([]);
});

it('simulated time stays finite, however long the steps', () => {
  const world = phys2D.createWorld();
  for (let i = 0; i < 3; i += 1) {
    world.step(1.7e308);
    validate(world);
  }
  expect(world.simulatedTime).toBe(Number.MAX_VALUE);
});

/** Three discs of areas 1, 1 and 4 times π size², in a corner. */
function corner(density: number, size: number): RigidBody {
  const material = phys2D.createMaterial({ density });
  const discs: [number, number, number][] = [
    [0, 0, 1],
    [size, 0, 1],
    [0, size, 2],
  ];
  return phys2D.createRigidBody({
    shapes: discs.map(([x, y, r]) => phys2D.createCircleShape({ radius: r * size, origin: [x, y], material })),
  });
}

it.each([
  [1e308, 1],
  [1e300, 1e10],
  [1e308, 1e74],
  [1e160, 1e74],
  [1, 1e74],
  [1e-300, 1],
  [1e-160, 1e-30],
])('the centre of mass is right, also of what is too heavy for a number: %f kg/m², %f m', (density, size) => {
  const body = corner(density, size);
  const [x, y] = body.computeLocalCenterOfMass();
  expect(x / size).toBeCloseTo(1 / 6, 12);
  expect(y / size).toBeCloseTo(4 / 6, 12);
  body.alignWithOrigin();
  expect(body.computeLocalCenterOfMass().map((each) => Math.abs(each / size) < 1e-12)).toEqual([true, true]);
});

it('shapes that are too far apart to be moved stay all where they are', () => {
  const material = phys2D.createMaterial({ density: 1000 });
  const far = phys2D.createCircleShape({ radius: 1, origin: [1e14, 0], material });
  const small = phys2D.createPolygonShape({ vertices: phys2D.createBoxVertices(1e-3, 1e-3) });
  const body = phys2D.createRigidBody({ shapes: [far, small] });
  expect(() => body.alignWithOrigin()).toThrow('RigidBody.alignWithOrigin: shapes must be ones that stay whole');
  expect(far.getOrigin()).toEqual([1e14, 0]);
  expect(small.getVertices()).toEqual([
    [-5e-4, -5e-4],
    [5e-4, -5e-4],
    [5e-4, 5e-4],
    [-5e-4, 5e-4],
  ]);
});

it('the largest friction holds, and moves no force', () => {
  const material = phys2D.createMaterial({ staticFriction: Number.MAX_VALUE, dynamicFriction: Number.MAX_VALUE });
  const world = heavy();
  addFloor(world, {}, { material });
  const body = boxBody(1, 1, { velocity: [3, 0], position: [0, -1.5], force: [1, 0] }, { material });
  add(world, body);
  let told = 0;
  world.addEventListener('nonfinite', () => {
    told += 1;
  });
  steps(world, 120);
  expect(told).toBe(0);
  expect(body.getForce()).toEqual([1, 0]);
  expect(body.shapes[0]!.arbiters[0]!.getStaticFriction()).toBeCloseTo(Number.MAX_VALUE, -300);
});

it.each([1e300, 1e306, Number.MAX_VALUE])('what weighs %f kg falls on a floor, and both stay finite', (mass) => {
  for (const speed of [0, 3, 300]) {
    for (const elasticity of [0, 0.5]) {
      const material = phys2D.createMaterial({ elasticity });
      const world = heavy();
      const floor = addFloor(world, {}, { material });
      const body = boxBody(1, 1, { mass, position: [0, -2], velocity: [0, speed] }, { material });
      add(world, body);
      steps(world, 60);
      validate(world);
      const numbers = [floor, body].flatMap((each) => [...each.getPosition(), ...each.getVelocity()]);
      expect(numbers.every(Number.isFinite)).toBe(true);
      expect(floor.getVelocity()).toEqual([0, 0]);
    }
  }
});

it.each([1e100, 1e300])('in a step of %f s what is fast is frozen at worst', (deltaTime) => {
  for (const params of [{ bullet: true }, { type: 'kinematic' }, {}] as const) {
    for (const speed of [1, 1e10]) {
      const world = heavy();
      addFloor(world);
      add(world, boxBody(1, 1, { velocity: [speed, speed], angularVelocity: speed, ...params }));
      world.step(deltaTime);
      world.step(1 / 60);
      validate(world);
    }
  }
});

it.each([1.7e308, Infinity])('bounds that nothing can meet are refused: %f', (bound) => {
  const [bodyA, bodyB] = [boxBody(1, 1), boxBody(1, 1)];
  const weld = phys2D.createWeldConstraint({ bodyA, bodyB });
  const angle = phys2D.createAngleConstraint({ bodyA, bodyB });
  const refused = [
    () => phys2D.createAngleConstraint({ bodyA, bodyB, lowerBound: bound, upperBound: bound }),
    () => phys2D.createAngleConstraint({ bodyA, bodyB, lowerBound: -bound, upperBound: -bound }),
    () => angle.setUpperBound(-bound),
    () => weld.setPhase(bound),
  ];
  for (const call of refused) expect(call).toThrow(RangeError);
  expect([angle.getUpperBound(), weld.getPhase()]).toEqual([0, 0]);
  expect(() => angle.setUpperBound(bound)).not.toThrow();
});
