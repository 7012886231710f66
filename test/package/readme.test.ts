import { execFileSync } from 'node:child_process';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { expect, it } from 'vitest';

// The example of the README is examples/readme.ts, which the type check and the build read as well.

const root = join(import.meta.dirname, '../..');
const read = (name: string): string => readFileSync(join(root, name), 'utf8');

it('the README shows the example to the letter', () => {
  const blocks = [...read('README.md').matchAll(/```ts\n([\s\S]*?)```/g)].map(([, code]) => code);
  expect(blocks).toContain(read('examples/readme.ts'));
});

it('the example has 20 lines and prints what the README says', () => {
  expect(read('examples/readme.ts').trimEnd().split('\n')).toHaveLength(20);
  const output = execFileSync(process.execPath, [join(root, 'dist/examples/readme.js')], { encoding: 'utf8' });
  expect(output.split('\n')).toHaveLength(7);
  expect(read('README.md')).toContain(`\`\`\`\n${output}\`\`\``);
});
