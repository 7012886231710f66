import { describe, expect, it } from 'vitest';
import { type Constraint, phys2D, type RigidBody, type RigidBodyParams, type World } from '../../src/index.js';

// Static and kinematic bodies serve as anchors wherever they are.

const DT = 1 / 60;

function weightless(): World {
  return phys2D.createWorld({ gravity: [0, 0] });
}

function add(world: World, params: RigidBodyParams = {}): RigidBody {
  const body = phys2D.createRigidBody({ shapes: [phys2D.createCircleShape({ radius: 0.2 })], ...params });
  world.addRigidBody(body);
  return body;
}

/** Each kind, and how far it is from being met. */
const KINDS: Record<string, (bodyA: RigidBody, bodyB: RigidBody) => [Constraint, () => number]> = {
  point(bodyA, bodyB) {
    const constraint = phys2D.createPointConstraint({ bodyA, bodyB, anchorA: [0, 1] });
    return [constraint, () => distance(bodyA.transformLocalPointToWorld([0, 1]), bodyB.getPosition())];
  },
  weld(bodyA, bodyB) {
    const constraint = phys2D.createWeldConstraint({ bodyA, bodyB, anchorA: [0, 1] });
    return [constraint, () => distance(bodyA.transformLocalPointToWorld([0, 1]), bodyB.getPosition())];
  },
  angle(bodyA, bodyB) {
    const constraint = phys2D.createAngleConstraint({ bodyA, bodyB });
    return [constraint, () => Math.abs(bodyB.getRotation() - bodyA.getRotation())];
  },
  rope(bodyA, bodyB) {
    const constraint = phys2D.createDistanceConstraint({ bodyA, bodyB, upperBound: 4 });
    return [constraint, () => Math.max(0, distance(bodyA.getPosition(), bodyB.getPosition()) - 4)];
  },
};

function distance(a: ArrayLike<number>, b: ArrayLike<number>): number {
  return Math.sqrt((a[0]! - b[0]!) ** 2 + (a[1]! - b[1]!) ** 2);
}

describe('a kinematic body that another world moves', () => {
  for (const [kind, make] of Object.entries(KINDS)) {
    it(`${kind}: is followed, and the hash tells where it is`, () => {
      const [here, there] = [weightless(), weightless()];
      const foreign = add(there, { type: 'kinematic', velocity: [-1, 0.5], angularVelocity: 0.2 });
      const body = add(here, { position: [0, 1] });
      const [constraint, error] = make(foreign, body);
      here.addConstraint(constraint);
      // The rope is slack for longer than it takes to fall asleep.
      for (let i = 0; i < 300; i += 1) {
        there.step(DT);
        here.step(DT);
      }
      // It has moved on in this step before the constraint was solved.
      expect(error()).toBeLessThan(0.005);
      const hash = here.hash();
      there.step(DT);
      expect(here.hash()).not.toBe(hash);
    });
  }
});

it('a static body that another world restores elsewhere takes along what hangs on it', () => {
  const [here, there] = [weightless(), weightless()];
  const foreign = add(there, { type: 'static' });
  const before = there.snapshot();
  there.removeRigidBody(foreign);
  foreign.setPosition([0, 1]);
  there.addRigidBody(foreign);
  const body = add(here);
  here.addConstraint(phys2D.createPointConstraint({ bodyA: foreign, bodyB: body }));
  for (let i = 0; i < 10; i += 1) {
    here.step(DT);
  }
  expect(distance(body.getPosition(), [0, 1])).toBeLessThan(1e-3);
  there.restore(before);
  for (let i = 0; i < 10; i += 1) {
    here.step(DT);
  }
  expect(distance(body.getPosition(), [0, 0])).toBeLessThan(1e-3);
});

it('joints of another world change nothing in this one', () => {
  const run = (isTied: boolean) => {
    const [here, there] = [phys2D.createWorld(), weightless()];
    const floor = phys2D.createPolygonShape({ vertices: phys2D.createRectangleVertices(-20, 0, 20, 1) });
    here.addRigidBody(phys2D.createRigidBody({ type: 'static', shapes: [floor] }));
    for (let i = 0; i < 60; i += 1) {
      const size = 0.8 + 0.2 * (i % 3);
      const position: [number, number] = [0.9 * (i % 4) - 1.5 + 0.05 * (i % 7), -1 - 0.9 * Math.floor(i / 4)];
      const shapes = [phys2D.createPolygonShape({ vertices: phys2D.createBoxVertices(size, size) })];
      const crate = add(here, { position, shapes });
      if (isTied) there.addConstraint(phys2D.createPointConstraint({ bodyA: add(there, { position }), bodyB: crate }));
    }
    for (let i = 0; i < 120; i += 1) here.step(DT);
    return here.hash();
  };
  expect(run(true)).toBe(run(false));
});
