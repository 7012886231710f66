import { describe, expect, it } from 'vitest';
import {
  type Broadphase,
  phys2D,
  type RigidBody,
  type RigidBodyParams,
  type Shape,
  type World,
} from '../../src/index.js';

// What far bodies, handlers in the middle of a step, and the choice of a broadphase must not change.

function add(world: World, params: RigidBodyParams): RigidBody {
  const body = phys2D.createRigidBody(params);
  world.addRigidBody(body);
  return body;
}

function box(width: number, height: number): Shape {
  return phys2D.createPolygonShape({ vertices: phys2D.createBoxVertices(width, height) });
}

function ball(radius: number, elasticity = 0): Shape {
  return phys2D.createCircleShape({ radius, material: phys2D.createMaterial({ elasticity }) });
}

describe('a ball that rises slowly to a ceiling, slower and slower', () => {
  /** Its height and speed after a step, alone in the world or with a fast body a kilometre away. */
  function rise(gap: number, isAlone: boolean): number[] {
    const world = phys2D.createWorld();
    add(world, { type: 'static', position: [0, -0.5], shapes: [box(20, 1)] });
    const rising = add(world, { position: [0, 0.5 + gap], velocity: [0, -0.65], linearDrag: 0, shapes: [ball(0.5)] });
    if (!isAlone) {
      add(world, { position: [1000, 1000], velocity: [50, 0], shapes: [ball(0.5)] });
    }
    world.step(1 / 60);
    return [rising.getPosition()[1], rising.getVelocity()[1]];
  }

  it('stops there, also if nothing else is fast', () => {
    for (const gap of [0.001, 0.003, 0.005, 0.007, 0.009]) {
      expect(rise(gap, true)).toEqual(rise(gap, false));
      expect(rise(gap, true)[0]).toBeGreaterThan(0.4998);
    }
  });
});

describe('world.substeps, set in a preSolve handler', () => {
  it.each([1, 2, 8])('counts from the next step on: %i', (substeps) => {
    const world = phys2D.createWorld();
    const anchor = phys2D.createRigidBody({ type: 'static' });
    const weight = add(world, { position: [0, 1], mass: 1, shapes: [ball(0.2)] });
    const rod = { bodyA: anchor, bodyB: weight, lowerBound: 1, upperBound: 1, maxForce: 20, breakUnderForce: true };
    world.addConstraint(phys2D.createDistanceConstraint(rod));
    const floor = box(3, 1);
    add(world, { type: 'static', position: [20, 0.5], shapes: [floor] });
    add(world, { position: [20, -0.45], shapes: [ball(0.5)] });
    let asked = 0;
    floor.addEventListener('preSolve', () => {
      asked += 1;
      if (asked === 50) {
        world.substeps = substeps;
      }
    });
    for (let i = 0; i < 100; i += 1) {
      world.step(1 / 60);
    }
    expect(world.substeps).toBe(substeps);
    expect(world.constraints).toHaveLength(1);
  });
});

describe('a ray in a preSolve handler at the end of a step', () => {
  /** A shot meets a wall while a disc flies by elsewhere: whether each ray at the height of the disc hit that. */
  function look(broadphase: Broadphase): { hits: boolean[]; hash: string } {
    const world = phys2D.createWorld({ gravity: [0, 0], broadphase });
    const wall = box(0.1, 10);
    add(world, { type: 'static', position: [50, 0], shapes: [wall] });
    const disc = add(world, { position: [0, 20], velocity: [0, 30], linearDrag: 0, shapes: [ball(0.3)] });
    add(world, { velocity: [1500, 0], linearDrag: 0, shapes: [ball(0.2, 2)] });
    const hits: boolean[] = [];
    wall.addEventListener('preSolve', (arbiter) => {
      const [, y] = disc.getPosition();
      const hit = world.rayCast({ origin: [-10, y + 0.1], direction: [1, 0], maxFactor: 20 });
      hits.push(hit?.shape === disc.shapes[0] && world.bodyPointQuery([0, y + 0.1], []) === 1);
      arbiter.setAcceptedState(hit === null);
    });
    for (let i = 0; i < 5; i += 1) {
      world.step(1 / 60);
    }
    return { hits, hash: world.hash() };
  }

  it('sees bodies where they are then, with any broadphase', () => {
    const tree = look(phys2D.createBoxTreeBroadphase());
    expect(tree.hits.length).toBeGreaterThan(0);
    expect(tree.hits.every(Boolean)).toBe(true);
    expect(look(phys2D.createSweepAndPruneBroadphase())).toEqual(tree);
  });
});

it('a handler that steps another world changes nothing in its own, also at the end of a step', () => {
  const bounce = (steps: boolean): number => {
    const other = phys2D.createWorld({ gravity: [0, 5000] });
    add(other, { shapes: [ball(1)] });
    const world = phys2D.createWorld({ gravity: [0, 10] });
    add(world, { type: 'static', position: [0, 5.1], shapes: [box(18, 0.2)] });
    const shape = ball(0.1, 0.5);
    const bullet = add(world, { bullet: true, shapes: [shape], velocity: [0, 60] });
    let asked = 0;
    shape.addEventListener('preSolve', () => {
      asked += 1;
      if (steps) other.step(1 / 60);
    });
    for (let i = 0; i < 8; i += 1) world.step(1 / 60);
    expect(asked).toBeGreaterThan(0);
    return bullet.getVelocity()[1];
  };
  expect(bounce(true)).toBe(bounce(false));
  expect(bounce(false)).toBeLessThan(-10);
});

it('a handler that steps another world, where something is struck as well, changes nothing of impacts that come at once', () => {
  const fall = (steps: boolean) => {
    const other = phys2D.createWorld({ gravity: [0, 0] });
    add(other, { type: 'static', position: [5, 0], shapes: [box(0.2, 10)] });
    add(other, { velocity: [400, 0], shapes: [ball(0.1, 1)] });
    const world = phys2D.createWorld({ gravity: [0, 0] });
    const tile = phys2D.createMaterial({ elasticity: 1 });
    const slab = (width: number, height: number) =>
      phys2D.createPolygonShape({ vertices: phys2D.createBoxVertices(width, height), material: tile });
    for (const x of [-1, 1]) add(world, { type: 'static', position: [x, 5], shapes: [slab(2, 0.2)] });
    const fast = add(world, { position: [0.2, 0], velocity: [0, 500], linearDrag: 0, shapes: [slab(1, 0.5)] });
    const worlds: (World | null)[] = [];
    world.addEventListener('hit', ({ bodyA }) => worlds.push(bodyA.world));
    let mayStep = steps;
    fast.shapes[0]!.addEventListener('preSolve', () => {
      if (mayStep) other.step(1 / 60);
      mayStep = false;
    });
    world.step(1 / 60);
    expect(worlds).toEqual([world, world]);
    expect(other.timeStamp).toBe(steps ? 1 : 0);
    return [...fast.getVelocity(), fast.getAngularVelocity()];
  };
  expect(fall(true)).toEqual(fall(false));
  expect(fall(false)[1]).toBeLessThan(-490);
});

it.each([10, 600])('a door that a handler sets in motion goes on, whatever comes at %d m/s', (speed) => {
  const world = phys2D.createWorld({ gravity: [0, 0] });
  const wall = add(world, { type: 'static', position: [10, 0], shapes: [box(1, 10)] });
  const door = add(world, { type: 'kinematic', position: [0, 20], shapes: [box(1, 4)] });
  for (let i = 0; i < 5; i += 1) world.step(1 / 60);
  expect(door.sleeping).toBe(true);
  add(world, { velocity: [speed, 0], shapes: [ball(0.2)] });
  let opened = Infinity;
  wall.shapes[0]!.addEventListener('preSolve', () => {
    opened = Math.min(opened, world.timeStamp);
    door.setVelocity([0, 3]);
  });
  for (let i = 0; i < 70; i += 1) world.step(1 / 60);
  expect(door.sleeping).toBe(false);
  expect(door.getPosition()[1] - 20).toBeGreaterThan((3 * (world.timeStamp - opened - 1)) / 60 - 1e-9);
  expect(world.timeStamp - opened).toBeGreaterThan(5);
});

it('a door that is awake, and that a handler sets in motion in its last step, goes on', () => {
  const world = phys2D.createWorld();
  const floor = add(world, { type: 'static', position: [0, 1], shapes: [box(20, 1)] });
  add(world, { shapes: [box(1, 1)] });
  const door = add(world, { type: 'kinematic', position: [0, 20], shapes: [box(1, 4)] });
  for (let i = 0; i < 5; i += 1) world.step(1 / 60);
  expect(door.sleeping).toBe(true);
  door.wake();
  floor.shapes[0]!.addEventListener('preSolve', () => door.setVelocity([0, 3]));
  for (let i = 0; i < 60; i += 1) world.step(1 / 60);
  expect(door.sleeping).toBe(false);
  expect(door.getPosition()[1]).toBeGreaterThan(22.9);
});
