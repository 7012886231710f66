// The worker has the world, and steps it 60 times a second; at the end of each step the world writes where its bodies are.
import { phys2D } from 'phys2d';
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
  let [due, last] = [0, performance.now()];
  setInterval(() => {
    const now = performance.now();
    // What is due beyond five steps is dropped: after a pause the world goes on, and does not hurry.
    due = Math.min(5, due + ((now - last) * 60) / 1000);
    for (last = now; due >= 1; due -= 1) {
      world.step(1 / 60);
      Atomics.store(counts, STEPS, world.timeStamp);
    }
  }, 8);
});
