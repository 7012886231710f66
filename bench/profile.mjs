// Where the time of a scene goes, by the sampling profiler: node bench/profile.mjs scene [engine] prints the functions with the largest
// self time. Functions that were inlined are counted with their callers.
import { mkdtempSync, readdirSync, readFileSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { basename, join } from 'node:path';
import { measure } from './measure.mjs';
import { scenes } from './scenes.mjs';

const ROWS = 20;

const [scene, engine = 'phys2d'] = process.argv.slice(2);
if (!(scene in scenes)) {
  console.error(`bench: node bench/profile.mjs scene [engine], scenes are ${Object.keys(scenes).join(', ')}`);
  process.exit(2);
}
const folder = mkdtempSync(join(tmpdir(), 'phys2d-profile-'));
const flags = ['--cpu-prof', `--cpu-prof-dir=${folder}`];
measure({ task: 'speed', engine, scene, seconds: 10 }, { flags });
const { nodes, samples, timeDeltas } = JSON.parse(readFileSync(join(folder, readdirSync(folder)[0]), 'utf8'));
rmSync(folder, { recursive: true });

const places = new Map(nodes.map(({ id, callFrame }) => [id, callFrame]));
const times = new Map();
let total = 0;
for (const [i, id] of samples.entries()) {
  const { functionName, url, lineNumber } = places.get(id);
  // What builds the scene and looks at it is not the engine's.
  if (functionName === '(idle)' || /child\.mjs|scenes\.js|engines\.mjs/.test(url) || url.startsWith('node:')) {
    continue;
  }
  const name = `${functionName || '(no name)'}${url === '' ? '' : `  ${basename(url)}:${lineNumber + 1}`}`;
  times.set(name, (times.get(name) ?? 0) + timeDeltas[i]);
  total += timeDeltas[i];
}
console.log(`${scene}, ${engine}: self time of ${(total / 1e6).toFixed(1)} s`);
for (const [name, time] of [...times].sort((a, b) => b[1] - a[1]).slice(0, ROWS)) {
  console.log(`${((100 * time) / total).toFixed(1).padStart(6)} %  ${name}`);
}
