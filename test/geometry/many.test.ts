import { spawnSync } from 'node:child_process';
import { build } from 'esbuild';
import { expect, it } from 'vitest';
import { expectInTime, expectRight, type Pairs, type Sweeps } from './right.js';

// What distance.test.ts and sweep.test.ts do with few random pairs and sweeps, with many, and what the worst of them is.

const PAIRS = 1_000_000;
const SWEEPS = 30_000;
const timeout = 120_000;

/** Bundles a script of this folder, which runs ten times as fast as what vitest loads, and runs it. @returns what its `measure` returns. */
async function run<T>(script: string, count: number, seed: number): Promise<T> {
  const { outputFiles } = await build({
    stdin: {
      contents: `import { measure } from './${script}'; console.log(JSON.stringify(measure(${count}, ${seed})));`,
      resolveDir: import.meta.dirname,
    },
    bundle: true,
    format: 'esm',
    platform: 'node',
    minifySyntax: true,
    write: false,
  });
  const { stdout, stderr } = spawnSync(process.execPath, ['--input-type=module', '-'], {
    input: outputFiles[0]!.text,
    encoding: 'utf8',
  });
  expect(stderr).toBe('');
  return JSON.parse(stdout);
}

it(`the distance of ${PAIRS.toLocaleString('en')} random pairs is that of the references`, { timeout }, async () => {
  const measured = await run<Pairs>('random-pairs.ts', PAIRS, 1);
  const { worst, counts } = measured;
  console.log(`distance of ${PAIRS} pairs (${JSON.stringify(counts)}), worst errors over the extent of the pair:`);
  for (const [kind, { error, pair }] of Object.entries(worst)) {
    console.log(`  ${kind.padEnd(12)} ${error.toExponential(1)}  (pair ${pair})`);
  }
  expectRight(measured, PAIRS);
});

it(`${SWEEPS.toLocaleString('en')} random sweeps agree with their distances in between`, { timeout }, async () => {
  const measured = await run<Sweeps>('random-sweeps.ts', SWEEPS, 1);
  const { worst, counts } = measured;
  console.log(`${SWEEPS} sweeps (${JSON.stringify(counts)}), worst errors over the size where not in s:`);
  for (const [kind, { error, sweep }] of Object.entries(worst)) {
    console.log(`  ${kind.padEnd(26)} ${kind === 'iterations' ? error : error.toExponential(1)}  (sweep ${sweep})`);
  }
  expectInTime(measured, SWEEPS);
});
