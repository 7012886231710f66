import { execFileSync } from 'node:child_process';
import { existsSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { expect, it } from 'vitest';
import { withFigures } from '../../bench/readme.mjs';
import { PROGRAMS } from './bundlers.js';

// The examples of the README are files of examples/, which the type check and the build read as well.

const root = join(import.meta.dirname, '../..');
const read = (name: string): string => readFileSync(join(root, name), 'utf8');

it('the README shows the examples to the letter', () => {
  const blocks = [...read('README.md').matchAll(/```ts\n([\s\S]*?)```/g)].map(([, code]) => code);
  expect(blocks).toEqual(['readme', 'custom', 'events'].map((name) => read(`examples/${name}.ts`)));
});

it('the bead of the second example stays on its wire', () => {
  const output = execFileSync(process.execPath, [join(root, 'dist/examples/custom.js')], { encoding: 'utf8' });
  const places = [...output.matchAll(/\((-?[\d.]+), (-?[\d.]+)\)/g)].map(([, x, y]) => [Number(x), Number(y)]);
  expect(places).toHaveLength(3);
  for (const [x, y] of places) {
    expect(Math.abs(y! - x! * x!)).toBeLessThan(0.03 * Math.abs(x!) + 0.01);
  }
});

it('the example has 20 lines and prints what the README says', () => {
  expect(read('examples/readme.ts').trimEnd().split('\n')).toHaveLength(20);
  const output = execFileSync(process.execPath, [join(root, 'dist/examples/readme.js')], { encoding: 'utf8' });
  expect(output.split('\n')).toHaveLength(7);
  expect(read('README.md')).toContain(`\`\`\`\n${output}\`\`\``);
});

it('the example with events prints what the README says', () => {
  const output = execFileSync(process.execPath, [join(root, 'dist/examples/events.js')], { encoding: 'utf8' });
  expect(output.split('\n').length).toBeGreaterThan(3);
  expect(read('README.md')).toContain(`\`\`\`\n${output}\`\`\``);
});

it('the README has the figures of the last runs beside other engines', () => {
  const speed = existsSync(join(root, 'bench/RESULTS.md')) ? read('bench/RESULTS.md') : null;
  const readme = read('README.md');
  // The formatter sets the width of columns.
  const loose = (text: string): string => text.replace(/ {2,}/g, ' ').replace(/-{3,}/g, '---');
  expect(loose(withFigures(readme, read('bench/QUALITY.md'), speed))).toBe(loose(readme));
  const page = `Written on 2020-01-02 by \`node x.mjs --y\`, Node\n\n3 of 7 targets are met.\n\n## Median of a step, ms\n\n| | phys2d |\n|---|---|\n| mud (m) | 3 |\n| rain (m) | 7 |\n\n`;
  const changed = withFigures(readme, read('bench/QUALITY.md'), page);
  expect(changed).toContain('measured on 2020-01-02 by\n`node x.mjs --y`. phys2d meets 3 / 7 of its targets');
  expect(changed).toContain('| | phys2d |\n|---|---|\n| rain (m) | 7 |\n\n');
});

it('the README has the sizes that the tests allow', () => {
  const line = /\*\*Size\*\*[^.]*?at most (.*?) kB\. A bundler/s.exec(read('README.md'))![1]!;
  const named = [
    'world, circles and a broadphase',
    'everything but constraints',
    'everything',
    'everything, with debug drawing',
  ];
  const budgets = named.map((name) => PROGRAMS.find((program) => program.name === name)!.budget / 1000);
  expect([...line.matchAll(/[\d.]+(?= kB|$)/g)].map(Number)).toEqual(budgets);
});
