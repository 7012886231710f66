// The worker has the world, and steps it 60 times a second; at the end of each step the world writes where its bodies are.
import { phys2D } from 'phys2d';
import { FixedStepRunner } from 'phys2d/runner';
import { PoseBuffer } from 'phys2d/state';
import { COUNT, SIZE, STEPS } from './shared.js';

addEventListener('message', ({ data: { poses, counts } }) => {
  const world = phys2D.createWorld();
  for (const [x, y, width, height] of [
    [10, 15, 20, 1],
    [-0.5, 7, 1, 16],
    [20.5, 7, 1, 16],
  ]) {
    const shapes = [phys2D.createPolygonShape({ vertices: phys2D.createBoxVertices(width, height) })];
    world.addRigidBody(phys2D.createRigidBody({ type: 'static', position: [x, y], shapes }));
  }
  world.poses = PoseBuffer.create({ capacity: COUNT, poses });
  for (let i = 0; i < COUNT; i += 1) {
    const shapes = [phys2D.createPolygonShape({ vertices: phys2D.createBoxVertices(SIZE, SIZE) })];
    const body = phys2D.createRigidBody({
      position: [2 + (i % 20) * 0.8, 13 - Math.floor(i / 20)],
      rotation: i,
      shapes,
    });
    world.addRigidBody(body);
    world.poses.track(body);
  }
  const runner = FixedStepRunner.create({ world });
  let last = performance.now();
  setInterval(() => {
    const now = performance.now();
    runner.advance((now - last) / 1000);
    last = now;
    Atomics.store(counts, STEPS, world.timeStamp);
  }, 8);
});
