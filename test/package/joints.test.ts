import { spawnSync } from 'node:child_process';
import { join } from 'node:path';
import { build } from 'esbuild';
import { expect, it } from 'vitest';

// The example with constraints, from its source, as a user's program.

const root = join(import.meta.dirname, '../..');

async function bundle(): Promise<string> {
  const { outputFiles } = await build({
    entryPoints: [join(root, 'examples/joints.ts')],
    alias: { phys2d: join(root, 'src/index.ts') },
    bundle: true,
    format: 'esm',
    platform: 'node',
    write: false,
  });
  return outputFiles[0]!.text;
}

it('the car of the example drives over the humps, the same on every run', async () => {
  const input = await bundle();
  const [first, second] = [0, 1].map(() =>
    spawnSync(process.execPath, ['--input-type=module', '-'], { input, encoding: 'utf8' }),
  );
  console.log(first!.stdout);
  expect(first!.stderr).toBe('');
  expect(first!.status).toBe(0);
  expect(second!.stdout).toBe(first!.stdout);
  const rows = [...first!.stdout.matchAll(/^ +(\d+) s +([-\d.]+), ([-\d.]+) +([-\d.]+) m\/s/gm)].map((row) =>
    row.slice(1).map(Number),
  );
  expect(rows.map(([time]) => time)).toEqual([1, 2, 3, 4, 5, 6, 7, 8, 9, 10]);
  rows.forEach(([, x, y, speed], i) => {
    expect(x).toBeGreaterThan(rows[i - 1]?.[1] ?? 0);
    expect(y).toBeLessThan(-0.7);
    expect(speed).toBeGreaterThan(1);
    expect(speed).toBeLessThan(5);
  });
  expect(rows[9]![1]).toBeGreaterThan(20);
});
