import { execFileSync } from 'node:child_process';
import { createHash } from 'node:crypto';
import { cpSync, mkdtempSync, readdirSync, readFileSync, rmSync, statSync, symlinkSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { afterAll, expect, it } from 'vitest';

// What is published can be built again by anyone: another build, in another place, has the same bytes. And nothing of it runs when it is installed.

const root = join(import.meta.dirname, '../..');
const place = mkdtempSync(join(tmpdir(), 'phys2d-build-'));

afterAll(() => rmSync(place, { recursive: true }));

/** Digests of all files of a build that are published, by name. */
function digests(dist: string): Map<string, string> {
  const { files } = JSON.parse(readFileSync(join(root, 'package.json'), 'utf8')) as { files: string[] };
  const left = files.filter((name) => name.startsWith('!dist/')).map((name) => name.slice('!dist/'.length));
  const names = readdirSync(dist, { recursive: true, encoding: 'utf8' })
    .filter((name) => statSync(join(dist, name)).isFile() && !left.includes(name.split(/[\\/]/)[0]!))
    .sort();
  return new Map(
    names.map((name) => [
      name,
      createHash('sha256')
        .update(readFileSync(join(dist, name)))
        .digest('hex'),
    ]),
  );
}

it('two builds in two places have the same bytes', () => {
  for (const name of readdirSync(root).filter(
    (name) => !['.git', 'dist', 'node_modules', 'bench', 'docs'].includes(name),
  )) {
    cpSync(join(root, name), join(place, name), {
      recursive: true,
      filter: (path) => !/[\\/]node_modules(?:[\\/]|$)/.test(path),
    });
  }
  symlinkSync(join(root, 'node_modules'), join(place, 'node_modules'), 'junction');
  execFileSync(process.execPath, [join(place, 'build.mjs')], { cwd: place, stdio: 'pipe' });
  const [here, there] = [digests(join(root, 'dist')), digests(join(place, 'dist'))];
  expect(here.size).toBeGreaterThan(0);
  expect([...there]).toEqual([...here]);
}, 120_000);

it('nothing runs when the package is installed, and nothing comes with it', () => {
  const { scripts, ...rest } = JSON.parse(readFileSync(join(root, 'package.json'), 'utf8')) as Record<string, object>;
  const hooks = ['preinstall', 'install', 'postinstall', 'prepare', 'preprepare', 'postprepare', 'prepublish'];
  expect(hooks.filter((name) => name in scripts!)).toEqual([]);
  expect(
    ['dependencies', 'optionalDependencies', 'peerDependencies', 'bundleDependencies'].filter((name) => name in rest),
  ).toEqual([]);
});

it('the lock file says of everything that is installed what it is, by digest', () => {
  const { packages } = JSON.parse(readFileSync(join(root, 'package-lock.json'), 'utf8')) as {
    packages: Record<string, { integrity?: string; optional?: boolean; os?: string[] }>;
  };
  // Tools for other systems could not be had where it was made.
  const without = Object.entries(packages).filter(
    ([name, { integrity, optional, os }]) => name !== '' && integrity === undefined && !(optional && os),
  );
  expect(without).toEqual([]);
});
