import { execFileSync } from 'node:child_process';
import { existsSync, mkdtempSync, readdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { dirname, join, normalize } from 'node:path';
import { beforeAll, describe, expect, it } from 'vitest';
import * as audit from '../../src/audit/index.js';
import * as debug from '../../src/debug/index.js';
import * as names from '../../src/index.js';
import * as outline from '../../src/outline/index.js';
import * as runner from '../../src/runner.js';
import * as state from '../../src/state/index.js';

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
  const search = ['classes', 'variables'].flatMap((kind) => readdirSync(join(site, kind))).join(' ');
  const llms = readFileSync(join(site, 'llms.txt'), 'utf8');
  const public_ = Object.keys({ ...names, ...debug, ...outline, ...runner, ...state, ...audit }).filter(
    (name) => name !== 'default',
  );
  expect(public_.filter((name) => /^[A-Z]/.test(name) && !search.includes(name))).toEqual([]);
  expect(public_.filter((name) => !llms.includes(name))).toEqual([]);
  const guide = readdirSync(join(docs, 'guide')).filter((name) => name.endsWith('.md'));
  for (const name of guide) {
    const title = /^title: (.*)$/m.exec(readFileSync(join(docs, 'guide', name), 'utf8'))![1]!;
    expect(existsSync(join(site, 'documents', `${title.replaceAll(' ', '_')}.html`)), name).toBe(true);
    expect(llms).toContain(`# ${title}\n`);
  }
});

it('llms.txt declares what is public, and of the rest only what that is made from', () => {
  const [, api] = readFileSync(join(site, 'llms.txt'), 'utf8').split('# API\n', 2);
  const names = (text: string, pattern: RegExp) => [...text.matchAll(pattern)].map(([, name]) => name!).sort();
  const published = readFileSync(join(docs, '../dist/umd.d.cts'), 'utf8');
  const expected = new Set(names(published, /^ {2}(?:type|const) (\w+)/gm).filter((name) => name !== 'vendor'));
  const declaring = '(?:declare )?(?:abstract )?(?:class|interface|type|const|function) (\\w+)';
  expect([...new Set(names(api!, RegExp(`^export ${declaring}`, 'gm')))]).toEqual([...expected].sort());
  const others = names(api!, RegExp(`^${declaring}`, 'gm'));
  expect(others).toContain('BaseShape');
  expect(others.filter((name) => api!.match(RegExp(`\\b${name}\\b`, 'g'))!.length < 2)).toEqual([]);
  expect(api).not.toMatch(/^ +(?:private|protected) /m);
});

describe('comments', () => {
  interface Report {
    checked: number;
    poor: string[];
  }
  const report = (...files: string[]): Report =>
    JSON.parse(execFileSync(process.execPath, [join(docs, 'comments.mjs'), ...files], { encoding: 'utf8' })) as Report;

  it('each public name has one that says something', () => {
    const { checked, poor } = report();
    console.log(`${checked - poor.length} of ${checked} public names have a complete comment`);
    expect(poor).toEqual([]);
    expect(checked).toBeGreaterThan(
      Object.keys({ ...names, ...debug, ...outline, ...runner, ...state, ...audit }).length,
    );
  });

  it('a poor one is found', () => {
    const folder = mkdtempSync(join(tmpdir(), 'phys2d-comments-'));
    const file = join(folder, 'poor.d.ts');
    writeFileSync(
      file,
      `/** Things. */
export interface ThingParams {
  size?: number;
  /** The mass. */
  mass?: number;
  /** kg. */
  load?: number;
  /** Default 1. */
  good?: number;
}
declare class Base {
  a(): void;
  private b: number;
  /** m. */
  get c(): number;
  set c(c: number);
}
/** Does this and that. */
export declare class Thing extends Base {
  static make(): void;
  list: {
    /** Good. */
    x: 1;
    y: 2;
  }[] | null;
}
export declare function make(): Thing;
export {};`,
    );
    expect(report(file)).toEqual({
      checked: 13,
      poor: [
        'Thing.a has no comment',
        'Thing.list has no comment',
        'Thing.list.y has no comment',
        'Thing.make has no comment',
        'ThingParams.load does not say its default',
        'ThingParams.mass has a comment that says nothing but the name',
        'ThingParams.size has no comment',
        'make has no comment',
      ],
    });
    rmSync(folder, { recursive: true });
  });
});
