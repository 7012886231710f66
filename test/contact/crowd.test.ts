import { describe, expect, it } from 'vitest';
import { validate } from '../../src/audit/index.js';
import { CROWD } from '../../src/config.js';
import { type Broadphase, phys2D, type RigidBody, type Shape, type World } from '../../src/index.js';

// Thousands of shapes at one point are millions of pairs. Of those only so many are made that time and memory stay bounded.

const box = (width: number, height = width): Shape =>
  phys2D.createPolygonShape({ vertices: phys2D.createBoxVertices(width, height) });
const circle = (radius: number): Shape => phys2D.createCircleShape({ radius });

function add(world: World, shape: Shape, position: readonly [number, number], type: 'dynamic' | 'static' = 'dynamic') {
  const body = phys2D.createRigidBody({ type, position, shapes: [shape] });
  world.addRigidBody(body);
  return body;
}

function crowd(count: number, make: () => Shape = () => box(1), broadphase?: Broadphase): World {
  const world = phys2D.createWorld({ broadphase, gravity: [0, 0] });
  for (let i = 0; i < count; i += 1) {
    add(world, make(), [0, 0]);
  }
  return world;
}

describe('shapes at one point', () => {
  it.each([
    ['boxes', () => box(1)],
    ['circles', () => circle(0.5)],
  ] as const)('1,000 %s: each has its share of pairs at once, and stays finite', (_, make) => {
    const world = crowd(1000, make);
    world.step(1 / 60);
    validate(world);
    expect(world.dynamicArbiters.length).toBeLessThanOrEqual(CROWD * 1000);
    expect(world.rigidBodies.filter(({ shapes }) => shapes[0]!.arbiters.length < CROWD)).toEqual([]);
    world.step(1 / 60);
    validate(world);
  });

  it('are all paired if they are not more than are in each other’s way', () => {
    const world = crowd(CROWD);
    world.step(1 / 60);
    expect(world.dynamicArbiters.length).toBe((CROWD * (CROWD - 1)) / 2);
  });

  it.each([
    ['boxes', () => box(1)],
    ['circles', () => circle(0.5)],
  ] as const)('%s get apart', (_, make) => {
    const world = phys2D.createWorld({ gravity: [0, 0], allowSleeping: false });
    for (let i = 0; i < 2 * CROWD; i += 1) {
      add(world, make(), [0.01 * (i % 7), 0.01 * (i % 11)]);
    }
    const shapes: Shape[] = [];
    const deep = () => world.rigidBodies.filter((body) => world.shapePointQuery(body.getPosition(), shapes) > 1).length;
    world.step(1 / 60);
    expect(deep()).toBeGreaterThan(0);
    for (let i = 0; i < 120; i += 1) {
      world.step(1 / 60);
    }
    validate(world);
    expect(deep()).toBe(0);
  });

  it('go on alike with either broadphase, and after a restore', () => {
    const one = crowd(2 * CROWD);
    const other = crowd(2 * CROWD, undefined, phys2D.createSweepAndPruneBroadphase());
    for (let i = 0; i < 20; i += 1) {
      one.step(1 / 60);
      other.step(1 / 60);
      expect(other.hash()).toBe(one.hash());
      one.restore(one.snapshot());
    }
  });
});

describe('nothing is left out', () => {
  it('of what is listened to', () => {
    const world = crowd(2 * CROWD);
    const { shapes } = world.rigidBodies[CROWD + 30]!;
    let begun = 0;
    shapes[0]!.addEventListener('begin', () => {
      begun += 1;
    });
    world.step(1 / 60);
    expect(begun).toBe(2 * CROWD - 1);
  });

  it('of what a sensor senses', () => {
    const world = crowd(2 * CROWD);
    const sensor = phys2D.createCircleShape({ radius: 0.5, sensor: true });
    add(world, sensor, [0, 0]);
    world.step(1 / 60);
    expect(sensor.arbiters.length).toBe(2 * CROWD);
  });

  it('of what lies on a floor, or on a dynamic tray', () => {
    const world = phys2D.createWorld();
    const floor = add(world, box(100, 1), [0, 0.5], 'static');
    const tray = add(world, box(2 * CROWD, 1), [0, -0.5]);
    const balls: RigidBody[] = [];
    for (let i = 0; i < 2 * CROWD; i += 1) {
      balls.push(add(world, circle(0.4), [i - CROWD + 0.5, -1.4]));
    }
    world.step(1 / 60);
    expect(tray.shapes[0]!.arbiters.length).toBe(2 * CROWD + 1);
    expect(floor.shapes[0]!.arbiters.length).toBe(1);
    expect(balls.filter(({ shapes }) => shapes[0]!.arbiters.length !== 1)).toEqual([]);
  });

  it('of trays full of things that lie on each other', () => {
    const world = phys2D.createWorld();
    add(world, box(400, 1), [0, 0.5], 'static');
    const trays = [add(world, box(200, 1), [0, -0.5]), add(world, box(200, 1), [0, -2.3])];
    for (let i = 0; i < 200; i += 1) {
      add(world, circle(0.4), [i - 99.5, -1.4]);
      add(world, circle(0.4), [i - 99.5, -3.2]);
    }
    for (let i = 0; i < 60; i += 1) {
      world.step(1 / 60);
    }
    expect(trays[0]!.shapes[0]!.arbiters.length).toBe(201);
    expect(trays[1]!.getPosition()[1]).toBeCloseTo(-2.3, 1);
  });
});
