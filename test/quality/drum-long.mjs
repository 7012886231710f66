// The drum of 1,000 boxes for 3,000 steps, or as many as told, from the bundle as built: too long for the test suite, so it is run by hand, after
// `npm run build`: node test/quality/drum-long.mjs [steps]. Prints what escaped and the time per step; fails if anything escaped.
import { join } from 'node:path';
import { build } from 'esbuild';
import { phys2D } from '../../dist/phys2d.js';

const entryPoints = [join(import.meta.dirname, 'drum.ts')];
const { outputFiles } = await build({ entryPoints, bundle: true, format: 'esm', write: false });
const { DrumRun } = await import(`data:text/javascript,${encodeURIComponent(outputFiles[0].text)}`);

const steps = Number(process.argv[2] ?? 3000);
const run = new DrumRun(phys2D, 1000);
const start = performance.now();
for (let done = 0; done < steps; done += 300) {
  run.step(Math.min(300, steps - done));
}
const time = (performance.now() - start) / steps;
console.log(`drum: ${run.escaped()} of 1,000 outside after ${steps} steps, ${time.toFixed(2)} ms a step`);
process.exitCode = run.escaped() > 0 ? 1 : 0;
