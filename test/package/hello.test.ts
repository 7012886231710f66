import { spawnSync } from 'node:child_process';
import { join } from 'node:path';
import { expect, it } from 'vitest';

// The main job, as `npm start` runs it after the build.

function run(): { status: number | null; stdout: string; stderr: string } {
  const file = join(import.meta.dirname, '../../dist/examples/hello.js');
  return spawnSync(process.execPath, [file], { encoding: 'utf8' });
}

/** The table at the end: name → value. */
function table(output: string): Record<string, string> {
  return Object.fromEntries(
    [...output.matchAll(/^ {2}([a-z0-9 ]+?) {2,}(\S.*)$/gm)].map(([, name, value]) => [name, value]),
  );
}

it('hello ends by itself, with a table and the same state hash on every run', () => {
  const first = run();
  expect(first.stderr).toBe('');
  expect(first.status).toBe(0);
  const rows = table(first.stdout);
  console.log(first.stdout);
  expect(Object.keys(rows)).toEqual([
    'simulated time',
    'bodies',
    'awake at the end',
    'most contacts',
    'median step',
    'p95 step',
    'deepest overlap',
    'state hash',
  ]);
  expect(rows['simulated time']).toBe('16.00 s');
  expect(rows['awake at the end']).toBe('0');
  expect(rows['state hash']).toMatch(/^[0-9a-f]{8,16}$/);
  expect(first.stdout.match(/step +\d+ of 960/g)).toHaveLength(8);

  const second = run();
  expect(second.status).toBe(0);
  const { 'median step': _, 'p95 step': __, ...facts } = table(second.stdout);
  expect(rows).toMatchObject(facts);
});
