// Which functions of phys2d allocate in a warm step, and how much: node bench/allocations.mjs
import { Session } from 'node:inspector/promises';
import { buildPyramid } from '../dist/bench/scenes.js';
import { phys2D } from '../dist/phys2d.js';

const STEPS = 1000;

const world = phys2D.createWorld({ allowSleeping: false });
buildPyramid(phys2D, world, 15);

function run(steps) {
  for (let i = 0; i < steps; i += 1) {
    world.step(1 / 60);
  }
}

run(2 * STEPS);
const session = new Session();
session.connect();
await session.post('HeapProfiler.startSampling', {
  samplingInterval: 256,
  includeObjectsCollectedByMajorGC: true,
  includeObjectsCollectedByMinorGC: true,
});
run(STEPS);
const { profile } = await session.post('HeapProfiler.stopSampling');

const bytes = new Map();
const nodes = [profile.head];
for (const { callFrame, selfSize, children } of nodes) {
  const name = callFrame.functionName || '(no name)';
  bytes.set(name, (bytes.get(name) ?? 0) + selfSize);
  nodes.push(...children);
}
for (const [name, size] of [...bytes].sort((a, b) => b[1] - a[1]).slice(0, 15)) {
  console.log(`${(size / STEPS).toFixed(0).padStart(8)} B/step  ${name}`);
}
