// The scenes of test/scenes/states.ts as one script for any engine, and their hashes:
// node test/state/golden.mjs writes golden.json anew, after a change that is meant to change results.
import { writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { runInThisContext } from 'node:vm';
import { build } from 'esbuild';

/** A script that leaves `runAll` and `run` in a global `golden`, and needs nothing but the language. */
export async function goldenScript() {
  const { outputFiles } = await build({
    entryPoints: [join(import.meta.dirname, 'golden-run.ts')],
    bundle: true,
    format: 'iife',
    globalName: 'golden',
    target: 'es2022',
    minifySyntax: true,
    write: false,
  });
  return outputFiles[0].text;
}

if (process.argv[1] && import.meta.url === pathToFileURL(process.argv[1]).href) {
  const hashes = runInThisContext(`${await goldenScript()}; JSON.stringify(golden.runAll(), null, 2)`);
  writeFileSync(join(import.meta.dirname, 'golden.json'), `${hashes}\n`);
}
