// Measures phys2d beside other engines: npm run bench, or
// node bench/run.mjs [--json] [--write] [--rounds=3] [--limit=60] [engine…] [scene…] [part…]
import { writeFileSync } from 'node:fs';
import { cpus } from 'node:os';
import { engines as all, usual, versionOf } from './engines.mjs';
import { attempt, here, summary } from './measure.mjs';
import { parts } from './parts.mjs';
import { writeFigures } from './readme.mjs';
import { scenes as built } from './scenes.mjs';
import { markdown, printPart, printScene, printTargets } from './speed-table.mjs';
import { judge } from './targets.mjs';

/** s. Where steps are much alike, warm-up and measurement take no longer than this each. */
const SECONDS = 4;
/** s. An engine that takes longer than this for a scene does it only once. */
const SLOW = 15;

const scenes = { ...built, ...(await import('./casts-scene.mjs')) };

const flags = process.argv.slice(2).filter((argument) => argument.startsWith('--'));
const names = process.argv.slice(2).filter((argument) => !argument.startsWith('--'));
const number = (flag, usual) => Number(flags.find((it) => it.startsWith(`--${flag}=`))?.split('=')[1] ?? usual);
const unknown = [
  ...names.filter((name) => !(name in all) && !(name in scenes) && !(name in parts)),
  ...flags.filter((flag) => !/^--(json|write|rounds=[1-9]\d*|limit=\d+)$/.test(flag)),
];
if (unknown.length > 0) {
  console.error(`bench: there is no ${unknown.join(', ')}`);
  for (const [what, group] of Object.entries({ engines: all, scenes, parts })) {
    console.error(`bench: ${what} are ${Object.keys(group).join(', ')}`);
  }
  process.exit(2);
}

const json = flags.includes('--json');
const rounds = number('rounds', 3);
/** s. What takes longer is given up. */
const limit = number('limit', 60);
const named = (group) => Object.keys(group).filter((name) => names.includes(name));
const engines = named(all).length > 0 ? named(all) : usual;
const isNarrowed = named(scenes).length + named(parts).length > 0;
const wantedScenes = isNarrowed ? named(scenes) : Object.keys(scenes);
const wantedParts = isNarrowed ? named(parts) : Object.keys(parts);

let hasFailed = false;
const results = {
  command: process.argv.slice(2).join(' '),
  date: new Date().toISOString().slice(0, 10),
  node: process.version,
  cpu: cpus()[0].model.trim(),
  cores: cpus().length,
  rounds,
  versions: Object.fromEntries(engines.map((engine) => [engine, versionOf(engine)])),
  scenes: [],
  parts: [],
};
if (!json) {
  console.log(`phys2d bench: Node ${results.node}, ${results.cpu}, ${results.cores} cores`);
  console.log(engines.map((engine) => `${all[engine].title ?? engine} ${results.versions[engine]}`).join(', '));
}
for (const name of wantedScenes) {
  const scene = compare(name);
  results.scenes.push(scene);
  json || printScene(scene);
}
for (const name of wantedParts) {
  const part = { name, ...parts[name]({ rounds, scenes: built }) };
  results.parts.push(part);
  json || printPart(part);
}
json || printTargets(results);
if (flags.includes('--write')) {
  writeFileSync(here('RESULTS.md'), markdown(results));
  writeFigures();
}
if (json) {
  console.log(JSON.stringify(results, null, 2));
}
process.exitCode = hasFailed || results.parts.some(({ equal }) => equal === false) ? 1 : 0;

/** A scene with all engines, in turn, several times over. */
function compare(name) {
  const { title, figure } = scenes[name];
  const runs = Object.fromEntries(engines.map((engine) => [engine, []]));
  const done = new Set();
  for (let round = 0; round < rounds; round += 1) {
    for (const engine of engines.filter((it) => !done.has(it))) {
      const start = performance.now();
      const run = attempt({ task: 'speed', engine, scene: name, seconds: SECONDS, most: 0.4 * limit }, { limit });
      runs[engine].push(run);
      if (run.times === undefined || performance.now() - start > 1000 * SLOW) {
        done.add(engine);
      }
    }
  }
  const cells = Object.fromEntries(engines.map((engine) => [engine, cellOf(runs[engine])]));
  if (scenes[name].agrees) {
    failStrays(cells);
  }
  return { name, title, figure, cells, targets: judge(name, figure, cells) };
}

/** Times of an engine that hits other things than phys2d, by more than a thousandth, do not count. */
function failStrays(cells) {
  const own = cells.phys2d;
  const isNear = (a, b) => Math.abs(a - b) <= 0.001 * b;
  for (const [engine, { median, quality, factors }] of Object.entries(cells)) {
    const strays = !(isNear(quality, own?.quality) && isNear(factors, own?.factors));
    if (own?.median !== undefined && median !== undefined && strays) {
      cells[engine] = { failure: 'hits differ', reason: `${quality} hits, not ${own.quality}` };
      hasFailed = true;
    }
  }
}

/** What is told of one engine: times of its quietest run, the worst quality of all, and whether it did fewer steps than it should. */
function cellOf(runs) {
  const good = runs.filter(({ times }) => times !== undefined);
  if (good.length === 0) {
    const { unsupported, failure, reason } = runs[0];
    return { failure: unsupported ? '–' : failure, reason };
  }
  const { factors, profile } = good[0];
  return {
    ...summary(good),
    // NaN comes through JSON as null.
    quality: Math.max(...good.map(({ quality }) => quality ?? Number.NaN)),
    isCut: good.some((run) => run.isCut),
    rounds: good.length,
    factors,
    profile,
  };
}
