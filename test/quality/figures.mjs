// npm run figures: measures all claims with the package as built, and writes FIGURES.md.
import { writeFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { build } from 'esbuild';

const here = (path) => fileURLToPath(new URL(path, import.meta.url));
const contents = "export * as claims from './claims/index.js'; export { measure, tableOf } from './figures.js';";
const outfile = here('../../dist/quality/claims.js');
await build({ stdin: { contents, resolveDir: here('.') }, outfile, bundle: true, format: 'esm', logLevel: 'error' });
const { phys2D } = await import('../../dist/phys2d.js');
const { claims, measure, tableOf } = await import(outfile);
writeFileSync(here('FIGURES.md'), tableOf(measure(claims, phys2D)));
