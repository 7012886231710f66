// npm run fuzz -- --seed 1 --runs 1000 --steps 200: random programs of so many calls, for the seeds from the first on. A failure is shrunk and
// printed as a test; the exit code is 1 then. --keep: goes on after a failure, and prints each kind once.
import { fileURLToPath, pathToFileURL } from 'node:url';
import { parseArgs } from 'node:util';
import { build } from 'esbuild';

const here = (path) => fileURLToPath(new URL(path, import.meta.url));
const { values } = parseArgs({
  options: {
    seed: { type: 'string', default: '1' },
    runs: { type: 'string', default: '1000' },
    steps: { type: 'string', default: '200' },
    keep: { type: 'boolean', default: false },
  },
});
const [seed, runs, steps] = [values.seed, values.runs, values.steps].map(Number);
const outfile = here('../../dist/quality/fuzz.js');
await build({
  entryPoints: [here('fuzz.ts')],
  outfile,
  bundle: true,
  format: 'esm',
  platform: 'node',
  logLevel: 'error',
});
const { phys2D } = await import('../../dist/phys2d.js');
const { validate } = await import('../../dist/validate.js');
const { fuzz, kindOf, testOf } = await import(pathToFileURL(outfile).href);

const began = performance.now();
const kinds = new Map();
let done = 0;
for (; done < runs && (values.keep || kinds.size === 0); done += 1) {
  const failure = fuzz({ phys2D, validate }, seed + done, steps, (kind) => kinds.has(kind));
  if (failure !== null) {
    const kind = kindOf(failure.message);
    kinds.set(kind, (kinds.get(kind) ?? 0) + 1);
    if (failure.program.length > 0) {
      console.log(testOf(failure));
    }
  }
}
const seconds = ((performance.now() - began) / 1000).toFixed(1);
console.log(`${done} programs of ${steps} calls in ${seconds} s, seeds ${seed} to ${seed + done - 1}`);
for (const [kind, count] of kinds) {
  console.log(`${count} × ${kind}`);
}
process.exitCode = kinds.size === 0 ? 0 : 1;
