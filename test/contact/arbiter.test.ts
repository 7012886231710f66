import { describe, expect, it } from 'vitest';
import * as g from '../../src/collide/layout.js';
import { type Contact, phys2D } from '../../src/index.js';
import { generator } from '../scenes/mixed.js';

it.each([
  [Infinity, 1],
  [-Infinity, 0],
  [2, 2],
  [0.5, 0.5],
])('an arbiter whose elasticity is set to %d has %d, and its bodies go on', (given, kept) => {
  const world = phys2D.createWorld({ gravity: [0, 0] });
  const bodies = [0, 0.9].map((x) => {
    const shapes = [phys2D.createCircleShape({ radius: 0.5 })];
    const body = phys2D.createRigidBody({ position: [x, 0], velocity: [-2 * x, 0], shapes });
    world.addRigidBody(body);
    return body;
  });
  bodies[0]!.shapes[0]!.addEventListener('preSolve', (arbiter) => arbiter.setElasticity(given));
  world.step(1 / 60);
  expect(bodies[0]!.shapes[0]!.arbiters[0]!.getElasticity()).toBe(kept);
  for (let i = 0; i < 10; i += 1) {
    world.step(1 / 60);
  }
  expect(bodies.flatMap((body) => [...body.getPosition(), ...body.getVelocity()]).every(Number.isFinite)).toBe(true);
});

it('each of two contacts is told no more friction than its normal impulse allows, also in the first step', () => {
  const world = phys2D.createWorld({ gravity: [0, 10], substeps: 1 });
  const material = phys2D.createMaterial({ staticFriction: 0.3, dynamicFriction: 0.2 });
  const box = (width: number) => phys2D.createPolygonShape({ vertices: phys2D.createBoxVertices(width, 1), material });
  world.addRigidBody(phys2D.createRigidBody({ type: 'static', position: [0, 1], shapes: [box(20)] }));
  world.addRigidBody(phys2D.createRigidBody({ position: [0, 0.004], velocity: [3, 0], shapes: [box(1)] }));
  for (let i = 0; i < 5; i += 1) {
    world.step(1 / 60);
    const { contacts } = world.staticArbiters[0]!;
    expect(contacts).toHaveLength(2);
    for (const contact of contacts) {
      expect(contact.getTangentImpulse() / contact.getNormalImpulse()).toBeCloseTo(-0.2, 9);
    }
  }
});

describe('normal and penetration are those of the end of the step', () => {
  const smooth = phys2D.createMaterial({ staticFriction: 0, dynamicFriction: 0, rollingFriction: 0 });
  const disc = () => phys2D.createCircleShape({ radius: 0.5, material: smooth });
  const fixed = { linearDrag: 0, angularDrag: 0, inertia: 1e9 };

  it.each([true, false])('of two discs, one of which slides over the other; it has an effect: %s', (isAccepted) => {
    const world = phys2D.createWorld({ gravity: [0, 0] });
    const low = phys2D.createRigidBody({ shapes: [disc()], mass: 1e9, ...fixed });
    const high = phys2D.createRigidBody({ position: [0, 0.9], velocity: [10, 0], shapes: [disc()], ...fixed });
    world.addRigidBody(low);
    world.addRigidBody(high);
    low.shapes[0]!.addEventListener('preSolve', (arbiter) => {
      expect(arbiter.getNormal()).toEqual([0, 1]);
      arbiter.setAcceptedState(isAccepted);
    });
    world.step(1 / 60);
    const arbiter = world.dynamicArbiters[0]!;
    const [ax, ay] = low.getPosition();
    const [bx, by] = high.getPosition();
    const length = Math.hypot(bx - ax, by - ay);
    const [nx, ny] = arbiter.getNormal();
    expect(nx).toBeCloseTo((bx - ax) / length, 9);
    expect(ny).toBeCloseTo((by - ay) / length, 9);
    expect(arbiter.contacts[0]!.getPenetration()).toBeCloseTo(1 - length, 9);
  });

  it('but of a shape that was removed since', () => {
    const world = phys2D.createWorld({ gravity: [0, 0] });
    const bodies = [0, 0.9].map((x) => phys2D.createRigidBody({ position: [x, 0], shapes: [disc()], ...fixed }));
    bodies.forEach((body) => {
      world.addRigidBody(body);
    });
    world.step(1 / 60);
    const arbiter = world.dynamicArbiters[0]!;
    bodies[1]!.removeShape(bodies[1]!.shapes[0]!);
    expect(arbiter.getNormal()).toEqual([1, 0]);
  });

  it('of what lies on a plate that turns, and of a disc at a corner that goes by', () => {
    const world = phys2D.createWorld({ gravity: [0, 0] });
    const vertices = phys2D.createBoxVertices(4, 1);
    const plate = (y: number, velocity: [number, number], angularVelocity: number) => {
      const shapes = [phys2D.createPolygonShape({ vertices, material: smooth })];
      const type = 'kinematic';
      const body = phys2D.createRigidBody({ type, position: [0, y], velocity, angularVelocity, shapes });
      world.addRigidBody(body);
      return body;
    };
    const rest = (x: number, y: number) => {
      const body = phys2D.createRigidBody({ position: [x, y], shapes: [disc()], mass: 1e9, ...fixed });
      world.addRigidBody(body);
      return body;
    };
    const turning = plate(0, [0, 0], 6);
    const onPlate = rest(0.1, -0.99);
    const passing = plate(10, [-3, 0], 0);
    const atCorner = rest(2.3, 10 - 0.5 - 0.38);
    world.step(1 / 60);
    for (const [plateBody, body] of [
      [turning, onPlate],
      [passing, atCorner],
    ] as const) {
      const arbiter = body.shapes[0]!.arbiters[0]!;
      const sign = arbiter.shapeA === plateBody.shapes[0] ? 1 : -1;
      const [x, y] = plateBody.transformWorldPointToLocal(body.getPosition());
      const [dx, dy] = plateBody.transformWorldVectorToLocal(arbiter.getNormal());
      const corner = [x - Math.min(x, 2), y + 0.5];
      const length = Math.hypot(corner[0]!, corner[1]!);
      expect(sign * dx).toBeCloseTo(corner[0]! / length, 6);
      expect(sign * dy).toBeCloseTo(corner[1]! / length, 6);
      // At a corner what is half-way between the surfaces is followed, not the corner.
      expect(arbiter.contacts[0]!.getPenetration()).toBeCloseTo(0.5 - length, 4);
    }
  });

  it('contacts tell all that a pair gave that met twice in a step', () => {
    let again = 0;
    for (let i = 0; i < 400; i += 1) {
      const random = generator(i + 1);
      const world = phys2D.createWorld();
      const material = phys2D.createMaterial({ elasticity: 0.3, staticFriction: 0.6, dynamicFriction: 0.5 });
      const floor = phys2D.createPolygonShape({ vertices: phys2D.createBoxVertices(30, 1), material });
      world.addRigidBody(phys2D.createRigidBody({ type: 'static', position: [0, 3], shapes: [floor] }));
      const shape = phys2D.createPolygonShape({ vertices: phys2D.createBoxVertices(0.8, 0.5), material });
      const body = phys2D.createRigidBody({
        shapes: [shape],
        rotation: 6 * random(),
        velocity: [6 * random() - 3, 6 * random()],
        angularVelocity: 8 * random() - 4,
      });
      world.addRigidBody(body);
      for (let k = 0; k < 60; k += 1) {
        world.step(1 / 60);
        const arbiter = world.staticArbiters[0];
        if (arbiter?.active !== true) continue;
        again += arbiter.metAgain() ? 1 : 0;
        const [x, y] = arbiter.getImpulseForBody(body);
        const sign = arbiter.bodyB === body ? 1 : -1;
        const [nx, ny] = [arbiter.numbers[arbiter.at + g.NX]!, arbiter.numbers[arbiter.at + g.NY]!];
        const sum = (of: (contact: Contact) => number) => arbiter.contacts.reduce((all, each) => all + of(each), 0);
        expect(sum((contact) => contact.getNormalImpulse())).toBeCloseTo(sign * (x * nx + y * ny), 9);
        expect(sum((contact) => contact.getTangentImpulse())).toBeCloseTo(sign * (y * nx - x * ny), 9);
      }
    }
    expect(again).toBeGreaterThan(5);
  });

  it('a virtual contact has no part in what its pair gave before it met again', () => {
    const world = phys2D.createWorld({ substeps: 2 });
    const floor = phys2D.createPolygonShape({ vertices: phys2D.createBoxVertices(30, 1) });
    world.addRigidBody(phys2D.createRigidBody({ type: 'static', position: [0, 3], shapes: [floor] }));
    const material = phys2D.createMaterial({ elasticity: 0.8 });
    const shape = phys2D.createPolygonShape({ vertices: phys2D.createBoxVertices(0.3, 0.2), material });
    const body = phys2D.createRigidBody({
      position: [0, 2],
      rotation: 5,
      velocity: [-2.1, 9.1],
      angularVelocity: 3.9,
      shapes: [shape],
    });
    world.addRigidBody(body);
    for (let k = 0; k < 3; k += 1) {
      world.step(1 / 60);
    }
    const arbiter = world.staticArbiters[0]!;
    expect(arbiter.metAgain()).toBe(true);
    const gave = Math.abs(arbiter.getImpulseForBody(body)[1]);
    expect(gave).toBeGreaterThan(0.5);
    const told = arbiter.contacts.map((contact) => [contact.virtual, contact.getNormalImpulse()] as const);
    expect(told.filter(([virtual]) => virtual)).toEqual([[true, 0]]);
    expect(told.find(([virtual]) => !virtual)![1]).toBeCloseTo(gave, 9);
    expect(arbiter.contacts.find((contact) => contact.virtual)!.getTangentImpulse()).toBe(0);
  });
});
