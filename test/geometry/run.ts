import { spawnSync } from 'node:child_process';
import { build } from 'esbuild';
import { expect } from 'vitest';

/** Bundles a script of this folder, which runs ten times as fast as what vitest loads, and runs it. @returns what its `measure` returns. */
export async function run<T>(script: string, count: number, seed: number): Promise<T> {
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
