// Which functions of phys2d allocate in a warm step, and how much: node bench/allocations.mjs [scene]
import { Session } from 'node:inspector/promises';
import { phys2D } from '../dist/phys2d.js';
import { DT, pyramidsOf, scenes } from './scenes.mjs';

/** s. Large scenes are done in fewer steps. */
const SECONDS = 10;
const STEPS = 1000;

const [name] = process.argv.slice(2);
if (name !== undefined && !(name in scenes)) {
  console.error(`bench: scenes are ${Object.keys(scenes).join(', ')}`);
  process.exit(2);
}
const {
  world,
  act = () => world.step(DT),
  before = () => {},
} = (name === undefined ? pyramidsOf(15, 1) : scenes[name]).start(phys2D);
let index = 0;

/** @returns how many steps were done. */
function run(steps) {
  const end = performance.now() + 1000 * SECONDS;
  for (let i = 0; i < steps; i += 1) {
    if (performance.now() > end) {
      return i;
    }
    before(index);
    act();
    index += 1;
  }
  return steps;
}

run(2 * STEPS);
const session = new Session();
session.connect();
await session.post('HeapProfiler.startSampling', {
  samplingInterval: 256,
  includeObjectsCollectedByMajorGC: true,
  includeObjectsCollectedByMinorGC: true,
});
const steps = run(STEPS);
const { profile } = await session.post('HeapProfiler.stopSampling');

const bytes = new Map();
const nodes = [profile.head];
for (const { callFrame, selfSize, children } of nodes) {
  const name = callFrame.functionName || '(no name)';
  bytes.set(name, (bytes.get(name) ?? 0) + selfSize);
  nodes.push(...children);
}
for (const [name, size] of [...bytes].sort((a, b) => b[1] - a[1]).slice(0, 15)) {
  console.log(`${(size / steps).toFixed(0).padStart(8)} B/step  ${name}`);
}
