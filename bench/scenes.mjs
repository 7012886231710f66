// The scenes that tests and benchmarks share, bundled anew for plain Node.
import { pathToFileURL } from 'node:url';
import { build } from 'esbuild';
import { here } from './measure.mjs';

const outfile = here('../dist/bench/scenes.js');
await build({ entryPoints: [here('../test/scenes/speed/index.ts')], outfile, bundle: true, format: 'esm' });

export const { DT, pyramidsOf, scenes } = await import(pathToFileURL(outfile).href);
