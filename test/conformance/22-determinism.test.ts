import { describe, expect, it } from 'vitest';
import { phys2D, type World } from '../../src/index.js';
import { stateHash } from '../scenes/hash.js';
import { buildMixed } from '../scenes/mixed.js';
import { buildPyramid } from '../scenes/pyramid.js';
import { add, addFloor, boxBody, plainBody, steps, weightless } from './setting.js';

const BROADPHASES = {
  'box tree': () => phys2D.createBoxTreeBroadphase(),
  'sweep and prune': () => phys2D.createSweepAndPruneBroadphase(),
};

function placements(world: World): number[] {
  return world.rigidBodies.flatMap((body) => [...body.getPosition(), body.getRotation()]);
}

describe('determinism and robustness', () => {
  it('C-239 a scene ends the same with every broadphase', () => {
    const [first, ...others] = Object.values(BROADPHASES).map((broadphase) => {
      const world = phys2D.createWorld({ broadphase: broadphase() });
      buildMixed(phys2D, world, 50, 1);
      steps(world, 300);
      return placements(world);
    });
    for (const other of others) {
      expect(other).toEqual(first);
    }
  });

  it('C-248 equal calls in fresh worlds give equal bits', () => {
    const run = () => {
      const world = phys2D.createWorld();
      buildMixed(phys2D, world, 60, 3);
      steps(world, 300);
      return placements(world);
    };
    expect(run()).toEqual(run());
  });

  it('the pyramid has one state hash, whatever the broadphase and what other worlds do', () => {
    const bystander = phys2D.createWorld();
    buildMixed(phys2D, bystander, 20, 9);
    const hashes = Object.values(BROADPHASES).map((broadphase) => {
      const world = phys2D.createWorld({ broadphase: broadphase() });
      buildPyramid(phys2D, world, 10);
      for (let i = 0; i < 300; i += 1) {
        world.step(1 / 60);
        bystander.step(1 / 50);
      }
      return stateHash(world);
    });
    expect(new Set(hashes).size).toBe(1);
  });

  it('a hash tells worlds apart', () => {
    const world = phys2D.createWorld();
    buildPyramid(phys2D, world, 3);
    const before = stateHash(world);
    const [x, y] = world.rigidBodies[3]!.getPosition();
    world.rigidBodies[3]!.setPosition([x + 1e-15, y]);
    expect(stateHash(world)).not.toBe(before);
  });

  it('C-249 a stack stands while the step length alternates', () => {
    const world = phys2D.createWorld();
    addFloor(world);
    const bodies = [0, -1, -2, -3].map((y) => boxBody(1, 1, { position: [0, y] }));
    add(world, ...bodies);
    const before = bodies.map((body) => body.getPosition());
    for (let i = 0; i < 200; i += 1) {
      world.step(i % 2 === 0 ? 1 / 60 : 1 / 30);
    }
    bodies.forEach((body, i) => {
      const [x, y] = body.getPosition();
      expect(Math.hypot(x - before[i]![0], y - before[i]![1])).toBeLessThan(0.05);
    });
  });

  it('C-250 an exception of a begin handler reaches the caller, and the world goes on', () => {
    const world = weightless();
    const a = plainBody();
    const b = plainBody({ position: [0.9, 0] });
    a.shapes[0]!.addEventListener('begin', () => {
      throw new Error('from the handler');
    });
    let calls = 0;
    b.shapes[0]!.addEventListener('begin', () => {
      calls += 1;
    });
    add(world, a, b);
    expect(() => world.step(1 / 60)).toThrow('from the handler');
    const [x] = b.getPosition();
    steps(world, 10);
    expect(world.timeStamp).toBe(11);
    expect(b.getPosition()[0]).toBeGreaterThanOrEqual(x);
    expect(calls).toBe(1);
  });
});
