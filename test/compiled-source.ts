import { mkdtemp, readdir, rm } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join, relative } from 'node:path';
import { fileURLToPath, pathToFileURL } from 'node:url';
import { build } from 'esbuild';
import type { Plugin } from 'vitest/config';

const SOURCE = fileURLToPath(new URL('../src/', import.meta.url));

/**
 * Tests import `src` as it is in a bundle: compiled once, into a temporary folder, when they start. Served module by module, each
 * call of another module's function would go through a getter, and the engine be several times slower than it is. Where tests are
 * watched, or coverage is asked for, they get the files themselves.
 */
export function compiledSource(): Plugin {
  let folder: string | undefined;
  return {
    name: 'compiled-source',
    enforce: 'pre',
    async configureVitest({ vitest }) {
      if (folder !== undefined || vitest.config.watch || vitest.config.coverage.enabled) return;
      const compiled = await mkdtemp(join(tmpdir(), 'phys2d-'));
      vitest.onClose(() => rm(compiled, { recursive: true }));
      await compile(compiled);
      folder = compiled;
    },
    async resolveId(name, importer) {
      if (folder === undefined) return null;
      const found = await this.resolve(name, importer, { skipSelf: true });
      if (found === null || !found.id.startsWith(SOURCE)) return null;
      const file = join(folder, relative(SOURCE, found.id).replace(/\.ts$/, '.mjs'));
      return { id: pathToFileURL(file).href, external: true };
    },
  };
}

async function compile(folder: string): Promise<void> {
  const files = (await readdir(SOURCE, { recursive: true })).filter((name) => name.endsWith('.ts'));
  await build({
    entryPoints: files.map((name) => join(SOURCE, name)),
    outbase: SOURCE,
    outdir: folder,
    outExtension: { '.js': '.mjs' },
    bundle: true,
    splitting: true,
    format: 'esm',
    target: 'es2022',
    // Constants are written where they are used, as in the bundles.
    minifySyntax: true,
    sourcemap: 'linked',
  });
}
