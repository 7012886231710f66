import { describe, expect, it } from 'vitest';
import { phys2D, type RigidBody, type World } from '../../src/index.js';
import { buildBridge } from '../scenes/bridge.js';

// A level that is played again in the same world goes as it did the first time, to the bit.

const DT = 1 / 60;

/** Where all bodies are and how they move. */
const look = (bodies: readonly RigidBody[]): string =>
  bodies
    .map((b) => [...b.getPosition(), b.getRotation(), ...b.getVelocity(), b.getAngularVelocity(), b.sleeping].join())
    .join('|');

/** A bridge with a load, and what puts it back to where it began. */
function level(world: World) {
  buildBridge(phys2D, world);
  const bodies = [...world.rigidBodies];
  const constraints = [...world.constraints];
  const places = bodies.map((body) => ({ position: body.getPosition(), rotation: body.getRotation() }));
  const put = (): void => {
    bodies.forEach((body, i) => {
      body.setPosition(places[i]!.position);
      body.setRotation(places[i]!.rotation);
      body.setVelocity([0, 0]);
      body.setAngularVelocity(0);
      world.addRigidBody(body);
    });
    constraints.forEach((constraint) => void world.addConstraint(constraint));
  };
  /** The last step is as long as is given. */
  const run = (steps: number, last = DT): string[] =>
    Array.from({ length: steps }, (_, i) => {
      world.step(i < steps - 1 ? DT : last);
      return look(bodies);
    });
  return { bodies, constraints, put, run };
}

describe.each<[string, (world: World) => void]>([
  ['cleared', (world) => world.clear()],
  ['emptied body by body', (world) => [...world.rigidBodies].forEach((body) => void world.removeRigidBody(body))],
])('a world that was %s', (_name, empty) => {
  it.each([7, 100])('after %i steps', (before) => {
    const world = phys2D.createWorld();
    const { put, run } = level(world);
    const first = run(200);
    for (let time = 0; time < 3; time += 1) {
      empty(world);
      for (let i = 0; i < before; i += 1) {
        world.step(DT);
      }
      put();
      expect(run(200)).toEqual(first);
    }
  });

  it('after a step of another length', () => {
    const world = phys2D.createWorld();
    const { put, run } = level(world);
    const first = run(60, 0.1);
    empty(world);
    put();
    expect(run(60, 0.1)).toEqual(first);
  });
});

it('goes on alike when it is restored in the middle', () => {
  const world = phys2D.createWorld();
  const { put, run } = level(world);
  run(50);
  world.clear();
  world.step(DT);
  put();
  run(37);
  const saved = world.snapshot();
  const hash = world.hash();
  const after = run(60);
  world.restore(saved);
  expect(world.hash()).toBe(hash);
  expect(run(60)).toEqual(after);
});

it('what stays where it is does not mind', () => {
  const world = phys2D.createWorld();
  const floor = phys2D.createPolygonShape({ vertices: phys2D.createBoxVertices(30, 1) });
  world.addRigidBody(phys2D.createRigidBody({ type: 'static', position: [0, 4], shapes: [floor] }));
  const { bodies, constraints, put, run } = level(world);
  const parts = bodies.filter((body) => !body.isStatic());
  const first = run(100);
  constraints.forEach((constraint) => void world.removeConstraint(constraint));
  parts.forEach((body) => void world.removeRigidBody(body));
  world.step(DT);
  put();
  expect(run(100)).toEqual(first);
});
