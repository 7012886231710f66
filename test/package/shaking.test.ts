import { execFileSync } from 'node:child_process';
import { rmSync } from 'node:fs';
import { join } from 'node:path';
import { gzipSync } from 'node:zlib';
import { build } from 'esbuild';
import { afterAll, describe, expect, it } from 'vitest';
import { PROGRAMS, partsOf, project } from './bundlers.js';

// What a game does not use is not in its bundle. Here with esbuild; `test/consumers` has the other bundlers.

const folder = project();
afterAll(() => rmSync(folder, { recursive: true, force: true }));

async function bundle(i: number): Promise<string> {
  const { outputFiles } = await build({
    entryPoints: [join(folder, `${i}.js`)],
    bundle: true,
    minify: true,
    format: 'esm',
    platform: 'browser',
    write: false,
  });
  return outputFiles[0]!.text;
}

describe.each(PROGRAMS.map((program, i) => ({ ...program, i })))('$name', ({ name, parts, budget, i }) => {
  it('has in its bundle what it uses and nothing else, and runs', async () => {
    const text = await bundle(i);
    const size = gzipSync(text, { level: 9 }).length;
    console.log(`${name}: ${(size / 1000).toFixed(1)} kB minified and gzipped`);
    expect(partsOf(text).sort()).toEqual([...parts].sort());
    expect(size).toBeLessThanOrEqual(budget);
    // Else the README promises too little.
    expect(size).toBeGreaterThan(0.95 * budget);
    const output = execFileSync(process.execPath, ['--input-type=module', '-'], { input: text, encoding: 'utf8' });
    expect(output.trim()).toBe('fell 5');
  });
});

it('what is smaller by its parts is smaller', async () => {
  const sizes = await Promise.all(
    ['world, circles and a broadphase', 'everything but constraints', 'everything', 'everything, with debug drawing']
      .map((name) => PROGRAMS.findIndex((program) => program.name === name))
      .map(async (i) => gzipSync(await bundle(i), { level: 9 }).length),
  );
  for (let i = 1; i < sizes.length; i += 1) {
    expect(sizes[i]! - sizes[i - 1]!).toBeGreaterThan(1000);
  }
});

it('nothing is left of the package where nothing of it is used', async () => {
  const options = { bundle: true, minify: true, format: 'esm', write: false, logLevel: 'silent' } as const;
  const contents =
    "import { phys2D, World } from 'phys2d';\nimport { SVGDebugDevice } from 'phys2d/debug';\nconsole.log(1);";
  const { outputFiles } = await build({ ...options, stdin: { contents, resolveDir: folder } });
  expect(outputFiles[0]!.text.trim()).toBe('console.log(1);');
});
