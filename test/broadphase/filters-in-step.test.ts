import { expect, test } from 'vitest';
import type { Broadphase } from '../../src/broadphase/broadphase.js';
import { phys2D } from '../../src/index.js';

/** A handler lets a box meet the floor that the mask of the floor kept apart from it: they met before, so their arbiter is still there. */
function run(broadphase: Broadphase, restores: boolean): string {
  const world = phys2D.createWorld({ broadphase, gravity: [0, 0] });
  const floor = phys2D.createPolygonShape({ vertices: phys2D.createRectangleVertices(-5, 0, 5, 3) });
  const box = (group: number) => phys2D.createPolygonShape({ vertices: phys2D.createBoxVertices(1, 1), group });
  const first = box(1);
  world.addRigidBody(phys2D.createRigidBody({ type: 'static', shapes: [floor] }));
  world.addRigidBody(phys2D.createRigidBody({ shapes: [first], position: [-2, -0.499] }));
  world.addRigidBody(phys2D.createRigidBody({ shapes: [box(2)], position: [2, -0.45] }));
  first.addEventListener('preSolve', () => {
    if (world.timeStamp === 20) floor.setMask(0xffffffff);
  });
  for (let i = 0; i < 20; i += 1) {
    if (i === 5) floor.setMask(1);
    if (restores && i === 19) world.restore(world.snapshot());
    world.step(1 / 60);
  }
  return world.hash();
}

test('what a handler lets interact within a step does so from the next one on, whatever the broadphase knows', () => {
  const hash = run(phys2D.createSweepAndPruneBroadphase(), false);
  expect(run(phys2D.createBoxTreeBroadphase(), false)).toBe(hash);
  expect(run(phys2D.createBoxTreeBroadphase(), true)).toBe(hash);
});
