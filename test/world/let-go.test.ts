import { setFlagsFromString } from 'node:v8';
import { runInNewContext } from 'node:vm';
import { describe, expect, it } from 'vitest';
import { phys2D, type World } from '../../src/index.js';
import { Chance } from '../geometry/forms.js';

// What leaves a world is collected once its user lets go of it, with all that is bound to it, though the world goes on.

const DT = 1 / 60;
const COUNT = 100;

async function collect(): Promise<void> {
  setFlagsFromString('--expose-gc');
  const gc = runInNewContext('gc') as () => void;
  for (let i = 0; i < 3; i += 1) {
    await new Promise((resolve) => setTimeout(resolve, 10));
    gc();
  }
  await new Promise((resolve) => setTimeout(resolve, 10));
}

const floor = phys2D.createRigidBody({
  type: 'static',
  position: [0, 0.5],
  shapes: [phys2D.createPolygonShape({ vertices: phys2D.createBoxVertices(40, 1) })],
});

/** Bodies that rain on a floor, touch, are bullets, sensors, tied, listened to; some fall asleep. All are taken out again in the end. */
function play(world: World, empty: (world: World) => void, hasStates: boolean): WeakRef<object>[] {
  const chance = new Chance(3);
  world.addRigidBody(floor);
  const bodies = Array.from({ length: COUNT }, (_, i) =>
    phys2D.createRigidBody({
      position: [chance.span(-15, 15), chance.span(-20, -1)],
      velocity: [chance.span(-30, 30), 0],
      bullet: i % 5 === 0,
      shapes: [
        i % 2 === 0
          ? phys2D.createCircleShape({ radius: 0.4, sensor: i % 20 === 0 })
          : phys2D.createPolygonShape({ vertices: phys2D.createBoxVertices(0.8, 0.8) }),
      ],
    }),
  );
  bodies.forEach((body) => void world.addRigidBody(body));
  bodies.forEach(({ shapes }) => void shapes[0]!.addEventListener('begin', () => {}));
  const joints = bodies
    .slice(1, COUNT / 5)
    .map((bodyB, i) => phys2D.createDistanceConstraint({ bodyA: bodies[i]!, bodyB, lowerBound: 0, upperBound: 5 }));
  joints.forEach((joint) => void world.addConstraint(joint));
  for (let i = 0; i < 120; i += 1) {
    world.step(DT);
  }
  expect(world.dynamicArbiters.length).toBeGreaterThan(20);
  if (hasStates) {
    world.hash();
    world.restore(world.snapshot());
  }
  empty(world);
  return [...bodies, ...joints].map((object) => new WeakRef(object));
}

const ways: [string, (world: World) => void, number][] = [
  ['cleared', (world) => world.clear(), 0],
  ['emptied body by body', (world) => [...world.rigidBodies].forEach((body) => void world.removeRigidBody(body)), 3],
  [
    'emptied shape by shape',
    (world) => {
      for (const body of [...world.rigidBodies]) {
        [...body.shapes].forEach((shape) => void body.removeShape(shape));
        world.removeRigidBody(body);
      }
    },
    3,
  ],
];

describe.each(ways)('a world that was %s', (_name, empty, steps) => {
  it.each([
    ['with a box tree', false],
    ['with sweep and prune, after it was saved', true],
  ])('%s', async (_kind, isOther) => {
    const world = phys2D.createWorld(isOther ? { broadphase: phys2D.createSweepAndPruneBroadphase() } : {});
    const left = play(world, empty, isOther);
    for (let i = 0; i < steps; i += 1) {
      world.step(DT);
    }
    await collect();
    expect(left.filter((ref) => ref.deref() !== undefined).length).toBe(0);
    expect(world.rigidBodies.length).toBeLessThan(COUNT);
  });
});

it('lets go of a hinge that was struck, and of what hung on it', async () => {
  const world = phys2D.createWorld({ gravity: [0, 0] });
  const strike = (): WeakRef<object>[] => {
    const base = phys2D.createRigidBody({ type: 'static' });
    const bar = phys2D.createRigidBody({
      position: [0, 1],
      shapes: [phys2D.createPolygonShape({ vertices: phys2D.createBoxVertices(0.2, 2) })],
    });
    const ball = phys2D.createRigidBody({
      position: [-3.2, 1.5],
      velocity: [120, 0],
      bullet: true,
      shapes: [phys2D.createCircleShape({ radius: 0.1, material: phys2D.createMaterial({ elasticity: 0.8 }) })],
    });
    const hinge = phys2D.createPointConstraint({ bodyA: base, bodyB: bar, anchorB: [0, -1] });
    for (const body of [base, bar, ball]) world.addRigidBody(body);
    world.addConstraint(hinge);
    for (let i = 0; i < 10; i += 1) world.step(DT);
    expect(Math.abs(bar.getAngularVelocity())).toBeGreaterThan(1);
    world.removeConstraint(hinge);
    for (const body of [base, bar, ball]) world.removeRigidBody(body);
    return [base, bar, ball, hinge].map((object) => new WeakRef(object));
  };
  const left = strike();
  for (let i = 0; i < 10; i += 1) world.step(DT);
  await collect();
  expect(left.filter((ref) => ref.deref() !== undefined).length).toBe(0);
});

it('tells an event handler that clears the world what it was called for', () => {
  const world = phys2D.createWorld();
  world.addRigidBody(floor);
  const ball = phys2D.createRigidBody({ position: [0, -0.6], shapes: [phys2D.createCircleShape({ radius: 0.5 })] });
  world.addRigidBody(ball);
  const told: unknown[] = [];
  ball.shapes[0]!.addEventListener('begin', (arbiter) => {
    world.clear();
    told.push(arbiter.bodyA, arbiter.bodyB);
  });
  for (let i = 0; i < 60 && told.length === 0; i += 1) {
    world.step(DT);
  }
  expect(told).toEqual(expect.arrayContaining([floor, ball]));
});
