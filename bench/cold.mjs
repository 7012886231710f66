// How long a program takes to its first step: node cold.mjs '{"engine":"phys2d"}' prints one line of JSON at the end.
import { writeSync } from 'node:fs';
import { engines } from './engines.mjs';

const { engine } = JSON.parse(process.argv[2]);
if (engine !== 'phys2d') {
  // What its adapter needs, and a program would not.
  await import('./peer.mjs');
}

const start = performance.now();
const device = await engines[engine].load();
const loaded = performance.now();
const world = device.createWorld({ gravity: [0, 10] });
function box(type, width, height, position) {
  const shapes = [device.createPolygonShape({ vertices: device.createBoxVertices(width, height) })];
  world.addRigidBody(device.createRigidBody({ type, shapes, position }));
}
box('static', 40, 2, [0, 1]);
for (let i = 0; i < 100; i += 1) {
  box('dynamic', 1, 1, [1.5 * (i % 10), -0.5 - Math.floor(i / 10)]);
}
world.step(1 / 60);
const end = performance.now();

// At once, as Box2D's threads would keep the process.
writeSync(1, `\n${JSON.stringify({ total: end - start, import: loaded - start })}\n`);
process.exit(0);
