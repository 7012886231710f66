import { execFileSync } from 'node:child_process';
import { existsSync, readdirSync, readFileSync } from 'node:fs';
import { dirname, join, normalize } from 'node:path';
import { beforeAll, expect, it } from 'vitest';
import * as debug from '../../src/debug/index.js';
import * as names from '../../src/index.js';
import * as runner from '../../src/runner.js';

// The documentation site, built as `npm run docs` does; TypeDoc's warnings are errors.

const docs = join(import.meta.dirname, '../../docs');
const site = join(docs, 'site');

beforeAll(() => {
  const options = { shell: process.platform === 'win32', stdio: 'pipe' } as const;
  execFileSync('npm', ['install', '--silent', '--no-audit', '--no-fund'], { ...options, cwd: docs });
  execFileSync(process.execPath, [join(docs, 'build.mjs')], { stdio: 'pipe' });
}, 120_000);

const unescaped = (text: string): string => text.replaceAll('&amp;', '&').replaceAll('&quot;', '"');

it('has no broken link', () => {
  const pages = readdirSync(site, { recursive: true, encoding: 'utf8' }).filter((name) => name.endsWith('.html'));
  const text = new Map(pages.map((name) => [normalize(name), readFileSync(join(site, name), 'utf8')]));
  let checked = 0;
  const broken: string[] = [];
  for (const [page, html] of text) {
    for (const [, link] of html.matchAll(/(?:href|src)="([^"]+)"/g)) {
      if (/^(?:https?|data|mailto):/.test(link!)) {
        continue;
      }
      const [path, anchor = ''] = unescaped(link!).split('#', 2).map(decodeURIComponent);
      const target = path === '' ? page : normalize(join(dirname(page), path!.replace(/\?.*/, '')));
      const found = text.get(target) ?? (existsSync(join(site, target)) ? null : undefined);
      const hasAnchor = anchor === '' || found === null || unescaped(found ?? '').includes(`id="${anchor}"`);
      if (found === undefined || !hasAnchor) {
        broken.push(`${page}: ${link}`);
      }
      checked += 1;
    }
  }
  expect(broken).toEqual([]);
  expect(checked).toBeGreaterThan(1000);
});

it('has every public name and every page of the guide, for people and for machines', () => {
  const search = readFileSync(join(site, 'modules.html'), 'utf8') + readdirSync(join(site, 'classes')).join(' ');
  const llms = readFileSync(join(site, 'llms.txt'), 'utf8');
  const public_ = Object.keys({ ...names, ...debug, ...runner }).filter((name) => name !== 'default');
  expect(public_.filter((name) => /^[A-Z]/.test(name) && !search.includes(name))).toEqual([]);
  expect(public_.filter((name) => !llms.includes(name))).toEqual([]);
  const guide = readdirSync(join(docs, 'guide')).filter((name) => name.endsWith('.md'));
  for (const name of guide) {
    const title = /^title: (.*)$/m.exec(readFileSync(join(docs, 'guide', name), 'utf8'))![1]!;
    expect(existsSync(join(site, 'documents', `${title.replaceAll(' ', '_')}.html`)), name).toBe(true);
    expect(llms).toContain(`# ${title}\n`);
  }
});
