import { execFileSync } from 'node:child_process';
import { readdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { transform } from 'esbuild';
import { afterAll, expect, it } from 'vitest';
import { project, root } from '../package/bundlers.js';

// The programs of the guide, as a user's: each block of TypeScript is one, and the block of text after it is what it prints.

const guide = join(root, 'docs/guide');
const PROGRAM = /```ts\n([\s\S]*?)```\n(?:\n```text\n([\s\S]*?)```)?/g;

const snippets = readdirSync(guide)
  .filter((name) => name.endsWith('.md'))
  .flatMap((name) =>
    [...readFileSync(join(guide, name), 'utf8').matchAll(PROGRAM)].map(([, code, output], i) => ({
      name: `${name.replace('.md', '')}-${i + 1}`,
      code: code!,
      output,
    })),
  );

const folder = project();
afterAll(() => rmSync(folder, { recursive: true, force: true }));

it('type-checks', () => {
  for (const { name, code } of snippets) {
    writeFileSync(join(folder, `${name}.ts`), code);
  }
  const tsc = join(root, 'node_modules/typescript/bin/tsc');
  const strict = '--noEmit --strict --noUnusedLocals --noUncheckedIndexedAccess --exactOptionalPropertyTypes';
  const options = `${strict} --ignoreConfig --target es2022 --lib es2022,dom --module nodenext --skipDefaultLibCheck`;
  const errorsOf = (names: string[]) => {
    const files = names.map((name) => `${name}.ts`);
    try {
      return execFileSync(process.execPath, [tsc, ...options.split(' '), ...files], { cwd: folder, encoding: 'utf8' });
    } catch (error) {
      return (error as { stdout: string }).stdout;
    }
  };
  // One that tells the compiler what `userData` is would tell all that are compiled with it.
  const [telling, others] = [true, false].map((tells) =>
    snippets.filter(({ code }) => code.includes('declare module') === tells).map(({ name }) => name),
  );
  expect(telling).not.toEqual([]);
  for (const names of [others!, ...telling!.map((name) => [name])]) expect(errorsOf(names)).toBe('');
});

it.each(snippets)('$name prints what the guide says', async ({ name, code, output }) => {
  const file = join(folder, `${name}.mjs`);
  writeFileSync(file, (await transform(code, { loader: 'ts' })).code);
  const printed = execFileSync(process.execPath, [file], { encoding: 'utf8' });
  expect(printed).not.toBe('');
  expect(printed).toBe(output);
});
