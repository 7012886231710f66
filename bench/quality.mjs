// What comes of the scenes of test/quality/claims with phys2d and with other engines: npm run quality, or
// node bench/quality.mjs [--json] [--write] [--check] [--limit=120] [engine…] [claim…]
import { spawn } from 'node:child_process';
import { writeFileSync } from 'node:fs';
import { cpus } from 'node:os';
import { fileURLToPath, pathToFileURL } from 'node:url';
import { build } from 'esbuild';
import { engines as all, versionOf } from './engines.mjs';
import { collapsed, markdown, print, summarize } from './quality-table.mjs';
import { writeFigures } from './readme.mjs';

/** Those compared unless names say otherwise: flavours of one engine differ in speed, and phaser-box2d is Box2D. */
const USUAL = ['phys2d', 'planck', 'Rapier', 'Box2D', 'matter-js', 'p2-es'];

const here = (path) => fileURLToPath(new URL(path, import.meta.url));
const flags = process.argv.slice(2).filter((argument) => argument.startsWith('--'));
/** ms. What takes longer is given up. */
const TIMEOUT = 1000 * Number(flags.find((flag) => /^--limit=\d+$/.test(flag))?.slice(8) ?? 120);
const names = process.argv.slice(2).filter((argument) => !argument.startsWith('--'));

await build({
  entryPoints: [here('../test/quality/claims/index.ts')],
  outfile: here('../dist/bench/claims.js'),
  bundle: true,
  format: 'esm',
});
const claims = await import(pathToFileURL(here('../dist/bench/claims.js')).href);

const unknown = [
  ...names.filter((name) => !(name in all) && !(name in claims)),
  ...flags.filter((flag) => !/^--(json|write|check|limit=\d+)$/.test(flag)),
];
if (unknown.length > 0) {
  console.error(`quality: there is no ${unknown.join(', ')}`);
  console.error(`quality: engines are ${Object.keys(all).join(', ')}; claims are ${Object.keys(claims).join(', ')}`);
  process.exit(2);
}
const chosen = (from, usual = from) => {
  const named = from.filter((name) => names.includes(name));
  return named.length > 0 ? named : usual;
};
const engines = chosen(Object.keys(all), USUAL);

if (flags.includes('--check')) {
  await check();
} else {
  await compare(chosen(Object.keys(claims)));
}

/** Runs one engine in a process of its own. @returns what it printed, or why it did not. */
function run(job) {
  return new Promise((resolve) => {
    const child = spawn(process.execPath, [here('quality-child.mjs'), JSON.stringify(job)], {
      stdio: ['ignore', 'pipe', 'pipe'],
    });
    let out = '';
    let errors = '';
    child.stdout.on('data', (data) => {
      out += data;
    });
    child.stderr.on('data', (data) => {
      errors += data;
    });
    const late = setTimeout(() => child.kill('SIGKILL'), TIMEOUT);
    const start = performance.now();
    child.on('close', (code, signal) => {
      clearTimeout(late);
      const seconds = (performance.now() - start) / 1000;
      if (code === 0) {
        resolve({ ...job, seconds, result: JSON.parse(out.trim().split('\n').at(-1)) });
        return;
      }
      const reason = errors.split('\n').find((line) => /error|panicked|unreachable/i.test(line)) ?? '';
      const failure = signal === 'SIGKILL' ? `over ${TIMEOUT / 1000} s` : 'crash';
      resolve({ ...job, seconds, failure, reason: signal === 'SIGKILL' ? '' : reason.trim().slice(0, 160) });
    });
  });
}

/** As many at a time as there are cores: no figure depends on the time. */
async function runAll(jobs) {
  const results = jobs.map(() => null);
  let next = 0;
  const work = async () => {
    while (next < jobs.length) {
      const i = next;
      next += 1;
      results[i] = await run(jobs[i]);
      process.stderr.isTTY && process.stderr.write(`\r${next} of ${jobs.length} `);
    }
  };
  await Promise.all(cpus().map(work));
  return results;
}

async function check() {
  const results = await runAll(engines.map((engine) => ({ engine })));
  if (flags.includes('--json')) {
    console.log(JSON.stringify(results, null, 2));
  }
  for (const { engine, result = [], failure, reason } of results) {
    const bad = result.filter(({ good }) => !good);
    const isGood = failure === undefined && bad.length === 0;
    process.exitCode = isGood ? process.exitCode : 1;
    if (!flags.includes('--json')) {
      console.log(
        `${engine.padEnd(10)} ${failure ?? `${result.length - bad.length} of ${result.length} as they should be`} ${reason ?? ''}`,
      );
      for (const { what, value, expected } of bad) {
        console.log(`  WRONG  ${what} ${value}, not ${expected}`);
      }
    }
  }
}

async function compare(wanted) {
  const jobs = wanted.flatMap((claim) => engines.map((engine) => ({ engine, claim })));
  const runs = await runAll(jobs);
  const tables = wanted.map((claim) => {
    const columns = engines.map((engine) => runs.find((it) => it.engine === engine && it.claim === claim));
    return { claim, scene: claims[claim].scene, ...tableOf(columns) };
  });
  const about = {
    date: new Date().toISOString().slice(0, 10),
    node: process.version,
    cpu: cpus()[0].model.trim(),
    versions: Object.fromEntries(engines.map((engine) => [engine, versionOf(engine)])),
  };
  const results = { ...about, timeout: TIMEOUT / 1000, summary: summarize(engines, tables), tables };
  const failed = runs.filter(({ engine, failure }) => engine === 'phys2d' && failure !== undefined);
  for (const { claim, failure, reason } of failed) {
    console.error(`quality: phys2d did not do ${claim}: ${failure} ${reason}`);
    process.exitCode = 1;
  }
  if (flags.includes('--write') && failed.length === 0) {
    writeFileSync(here('QUALITY.md'), markdown(results));
    writeFigures();
  }
  if (flags.includes('--json')) {
    console.log(JSON.stringify(results, null, 2));
  } else {
    print(results);
  }
}

/** The rows of a claim: of each figure what every engine has of it. */
function tableOf(columns) {
  const whole = columns.find(({ result }) => result !== undefined)?.result.figures ?? [];
  const rows = whole.map(({ what, unit, limit }, i) => {
    const cells = columns.map(({ engine, result, failure }) =>
      result === undefined
        ? { engine, value: failure, fell: false }
        : { engine, value: result.figures[i].value, fell: collapsed(result.figures, i) },
    );
    return { what, unit, limit, cells };
  });
  const failures = columns
    .filter(({ failure }) => failure)
    .map(({ engine, failure, reason }) => ({ engine, failure, reason }));
  const seconds = Object.fromEntries(columns.map((column) => [column.engine, Number(column.seconds.toFixed(1))]));
  return { rows, failures, seconds };
}
