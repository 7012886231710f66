// Measures phys2d beside other engines: npm run bench, or node bench/run.mjs [--json] [pyramid] [chains] [grid] [crowd] [events] [continuous] [rays] [casts] [garbage] [hash]
import { spawnSync } from 'node:child_process';
import { cpus } from 'node:os';
import { fileURLToPath } from 'node:url';
import { build } from 'esbuild';

const ROUNDS = 5;
const TIMEOUT = 300_000;
const GC_FLAGS = ['--expose-gc', '--min-semi-space-size=64', '--max-semi-space-size=64'];

const here = (path) => fileURLToPath(new URL(path, import.meta.url));
const json = process.argv.includes('--json');
const wanted = process.argv.slice(2).filter((argument) => argument !== '--json');
const say = (line) => json || console.log(line);

const parts = { pyramid, chains, grid, crowd, events, continuous, rays, casts, garbage, hash };
for (const name of wanted.filter((name) => !(name in parts))) {
  console.error(`bench: there is no part ${name}, only ${Object.keys(parts).join(', ')}`);
  process.exit(2);
}

await build({
  stdin: {
    contents: ['pyramid', 'joint-grid', 'hash', 'mixed'].map((name) => `export * from './${name}.js';`).join(''),
    resolveDir: here('../test/scenes'),
  },
  outfile: here('../dist/bench/scenes.js'),
  bundle: true,
  format: 'esm',
});

const cpu = cpus()[0].model.trim();
const results = { node: process.version, cpu, cores: cpus().length };
say(`phys2d bench: Node ${process.version}, ${cpu}, ${results.cores} cores`);
for (const name of Object.keys(parts)) {
  if (wanted.length === 0 || wanted.includes(name)) {
    results[name] = parts[name]();
  }
}
if (json) {
  console.log(JSON.stringify(results, null, 2));
}
process.exitCode = results.hash?.equal === false ? 1 : 0;

/** Runs one measurement in a process of its own. */
function measure(job, flags = []) {
  const child = spawnSync(process.execPath, [...flags, here('child.mjs'), JSON.stringify(job)], {
    encoding: 'utf8',
    stdio: ['ignore', 'pipe', 'inherit'],
    maxBuffer: 2 ** 26,
    timeout: TIMEOUT,
  });
  if (child.status !== 0) {
    throw new Error(`bench: ${JSON.stringify(job)} ended with ${child.signal ?? child.status}`);
  }
  return JSON.parse(child.stdout);
}

/** Runs all jobs in turn, several times over, so that a slow moment of the machine hits all alike. */
function interleave(jobs) {
  const runs = jobs.map(() => []);
  for (let round = 0; round < ROUNDS; round += 1) {
    for (const [i, job] of jobs.entries()) {
      runs[i].push(measure(job));
    }
  }
  return runs;
}

/** Median and 95th percentile of the quietest run: what else the machine does can only add to the times. */
function summary(runs) {
  const [times] = runs.map(({ times }) => times.sort((a, b) => a - b)).sort((a, b) => median(a) - median(b));
  return { median: median(times), p95: times[Math.floor(0.95 * times.length)] };
}

function median(sorted) {
  return sorted[Math.floor(sorted.length / 2)];
}

function pyramid() {
  const job = { task: 'pyramid', base: 40, warmUp: 60, steps: 240 };
  say(`\nPyramid of 820 boxes, awake: the quietest of ${ROUNDS} × ${job.steps} steps, 8 velocity iterations`);
  say(columns('', 'median', 'p95', 'worst sag', 'phys2d is'));
  const names = ['phys2d', 'planck', 'planck, discrete'];
  const runs = interleave(names.map((engine) => ({ ...job, engine })));
  const engines = {};
  for (const [i, name] of names.entries()) {
    const times = summary(runs[i]);
    const sag = Math.max(...runs[i].map((run) => run.sag));
    const ratio = (i === 0 ? times : engines.phys2d).median / times.median;
    engines[name] = { ...times, sag, ratio };
    const share = i === 0 ? '' : `× ${ratio.toFixed(3)}`;
    say(columns(name, ms(times.median), ms(times.p95), `${(1000 * sag).toFixed(1)} mm`, share));
  }
  const { ratio } = engines.planck;
  say(target('phys2d / planck', ratio.toFixed(3), 0.12));
  return { engines, ratio, target: 0.12 };
}

function chains() {
  const job = { task: 'chains', count: 100, links: 20, warmUp: 60, steps: 240 };
  return jointed(`${job.count} chains of ${job.links} links`, job);
}

function grid() {
  const job = { task: 'grid', size: 40, warmUp: 60, steps: 240 };
  return jointed(`Net of ${job.size} × ${job.size} discs`, job);
}

function jointed(title, job) {
  say(`\n${title}, awake: the quietest of ${ROUNDS} × ${job.steps} steps, 8 velocity iterations`);
  say(columns('', 'median', 'p95', 'widest gap', 'phys2d is'));
  const names = ['phys2d', 'planck'];
  const runs = interleave(names.map((engine) => ({ ...job, engine })));
  const engines = {};
  for (const [i, name] of names.entries()) {
    const times = summary(runs[i]);
    const gap = Math.max(...runs[i].map((run) => run.gap));
    const ratio = (i === 0 ? times : engines.phys2d).median / times.median;
    engines[name] = { ...times, gap, ratio };
    const share = i === 0 ? '' : `× ${ratio.toFixed(3)}`;
    say(columns(name, ms(times.median), ms(times.p95), `${(1000 * gap).toFixed(1)} mm`, share));
  }
  const { ratio } = engines.planck;
  say(target('phys2d / planck', ratio.toFixed(3), 0.35));
  return { engines, ratio, target: 0.35 };
}

function crowd() {
  const job = { task: 'crowd', warmUp: 300, steps: 1200 };
  say(`\n50 awake boxes: the quietest of ${ROUNDS} × ${job.steps} steps`);
  const [aloneRuns, amidRuns] = interleave([
    { ...job, idle: 0 },
    { ...job, idle: 10_000 },
  ]);
  for (const { awake } of [...aloneRuns, ...amidRuns]) {
    if (awake !== 50) {
      throw new Error(`bench: 50 boxes should be awake, not ${awake}`);
    }
  }
  const alone = summary(aloneRuns);
  const amid = summary(amidRuns);
  const ratio = amid.median / alone.median;
  say(columns('', 'median', 'p95'));
  say(columns('alone', ms(alone.median), ms(alone.p95)));
  say(columns('with 10,000 idle', ms(amid.median), ms(amid.p95)));
  say(target('with / alone', ratio.toFixed(2), 1.5));
  return { alone, amid, ratio, target: 1.5 };
}

function events() {
  const job = { task: 'events', base: 32, warmUp: 120, steps: 480 };
  const [silentRuns, heardRuns] = interleave([job, { ...job, listening: true }]);
  const { pairs, callsPerStep } = heardRuns[0];
  const silent = summary(silentRuns);
  const heard = summary(heardRuns);
  const ratio = heard.median / silent.median;
  say(`\n${pairs} touching pairs: the quietest of ${ROUNDS} × ${job.steps} steps`);
  say(columns('handlers', 'median', 'p95'));
  say(columns('none', ms(silent.median), ms(silent.p95)));
  say(columns(`${callsPerStep.toFixed(0)} calls a step`, ms(heard.median), ms(heard.p95)));
  say(target('with / without', ratio.toFixed(2), 1.15));
  const warm = { task: 'garbage', engine: 'phys2d', base: job.base, warmUp: 1000, steps: 1000 };
  const [kB, heardkB] = [false, true].map((listening) => measure({ ...warm, listening }, GC_FLAGS).bytesPerStep / 1000);
  say(columns('garbage', `${kB.toFixed(2)} kB/step`, `${heardkB.toFixed(2)} kB/step`));
  return { silent, heard, pairs, callsPerStep, ratio, target: 1.15, kB: { silent: kB, heard: heardkB } };
}

function continuous() {
  const job = { task: 'continuous', base: 40, warmUp: 120, steps: 2000 };
  say(`\nContinuous collision in the pyramid, where nothing is fast: ${job.steps} steps`);
  const shares = interleave([job])[0].map(({ share }) => 100 * share);
  const share = median(shares.sort((a, b) => a - b));
  say(target('share of a step', `${share.toFixed(2)} %`, '3 %'));
  return { share, target: 3 };
}

function rays() {
  const job = { task: 'rays', bodies: 2000, rays: 10_000, casts: 0, warmUp: 10, steps: 40 };
  const { engines } = cast(`${job.rays} rays, the nearest hit among ${job.bodies} bodies`, job);
  for (const [name, { hits, factors }] of Object.entries(engines)) {
    if (!near(hits, engines.phys2d.hits) || !near(factors, engines.phys2d.factors)) {
      throw new Error(`bench: rays hit other things in ${name} than in phys2d`);
    }
  }
  const { planck, Rapier } = engines;
  say(target('phys2d / planck', planck.ratio.toFixed(3), 0.6));
  say(target('phys2d / Rapier', Rapier.ratio.toFixed(3), 1.5));
  return { engines, ratio: planck.ratio, target: 0.6, ratioToRapier: Rapier.ratio, targetToRapier: 1.5 };
}

function casts() {
  const job = { task: 'casts', bodies: 2000, rays: 0, casts: 2000, warmUp: 20, steps: 80 };
  return cast(`${job.casts} casts of a box, the nearest hit among ${job.bodies} bodies`, job);
}

function cast(title, job) {
  say(`\n${title}: the quietest of ${ROUNDS} × ${job.steps} times all`);
  say(columns('', 'median', 'p95', 'hits', 'factors', 'phys2d is'));
  const names = ['phys2d', 'planck', 'Rapier'];
  const runs = interleave(names.map((engine) => ({ ...job, engine })));
  const engines = {};
  for (const [i, name] of names.entries()) {
    const times = summary(runs[i]);
    const { hits, factors } = runs[i][0];
    const ratio = (i === 0 ? times : engines.phys2d).median / times.median;
    engines[name] = { ...times, hits, factors, ratio };
    const share = i === 0 ? '' : `× ${ratio.toFixed(3)}`;
    say(columns(name, ms(times.median), ms(times.p95), `${hits}`, factors.toFixed(3), share));
  }
  return { engines };
}

function near(a, b) {
  return Math.abs(a - b) <= 0.001 * b;
}

function garbage() {
  const job = { task: 'garbage', base: 15, warmUp: 1000, steps: 1000 };
  say(`\nGarbage, 120 awake boxes: ${job.steps} steps after ${job.warmUp}`);
  const kB = {};
  for (const engine of ['phys2d', 'planck']) {
    kB[engine] = measure({ ...job, engine }, GC_FLAGS).bytesPerStep / 1000;
    say(columns(engine, `${kB[engine].toFixed(2)} kB/step`));
  }
  say(target('phys2d', `${kB.phys2d.toFixed(2)} kB`, '1 kB'));
  return { kB, target: 1 };
}

function hash() {
  const job = { task: 'hash', base: 40, steps: 600 };
  say(`\nState hash of the pyramid of 820 boxes, awake, after ${job.steps} steps`);
  const hashes = measure(job);
  const equal = new Set(Object.values(hashes)).size === 1;
  say(columns('box tree', hashes.boxTree));
  say(columns('sweep and prune', hashes.sweepAndPrune));
  say(columns('in a second world', hashes.secondWorld));
  say(equal ? '  equal' : '  NOT EQUAL');
  return { ...hashes, equal };
}

function columns(name, ...values) {
  return `  ${name.padEnd(18)}${values.map((value) => value.padStart(14)).join('')}`.trimEnd();
}

function target(name, value, limit) {
  return `${columns(name, value)}   (target: at most ${limit})`;
}

function ms(value) {
  return `${value.toFixed(3)} ms`;
}
