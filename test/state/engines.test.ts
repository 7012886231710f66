import { execFile } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { promisify } from 'node:util';
import { getQuickJS } from 'quickjs-emscripten';
import { afterAll, beforeAll, describe, expect, it } from 'vitest';
import { launch, open } from '../browser/browser.js';
import { find } from '../browser/engines.mjs';
import { askFirefox } from '../browser/firefox.js';
import { goldenScript } from './golden.mjs';

// The same scenes have the same hashes, every 10 steps for 600, in every JavaScript engine; in QuickJS, which has no WebAssembly, by kernels in plain TypeScript. A change that is meant to change results:
// node test/state/golden.mjs
//
// QuickJS interprets: it does the first third of each scene, and all of it when asked to, which takes a minute:
// QUICKJS_STEPS=600 npx vitest run test/state/engines.test.ts

type Hashes = Record<string, string[]>;

/** What an engine comes to, and by which kernels. */
interface Found {
  readonly hashes: Hashes;
  readonly kernels: string;
}

const RUN = '({ hashes: golden.runAll(), kernels: golden.kernels() })';

const MINUTES = 60_000;
const EVERY = 10;
const QUICKJS_STEPS = Number(process.env.QUICKJS_STEPS ?? 200);
const golden = JSON.parse(readFileSync(join(import.meta.dirname, 'golden.json'), 'utf8')) as Hashes;
const folder = mkdtempSync(join(tmpdir(), 'phys2d-golden-'));
const expected: Found = { hashes: golden, kernels: 'WebAssembly' };
let script = '';

beforeAll(async () => {
  script = await goldenScript();
});

afterAll(() => {
  rmSync(folder, { recursive: true, force: true });
});

it('there are 360 hashes, all different', () => {
  expect(Object.values(golden).map(({ length }) => length)).toEqual([60, 60, 60, 60, 60, 60]);
  expect(new Set(Object.values(golden).flat()).size).toBe(360);
});

describe('golden hashes', () => {
  it(
    'in V8 (Node)',
    async () => {
      expect(await runInShell(process.execPath, 'console.log')).toEqual(expected);
    },
    2 * MINUTES,
  );

  it(
    'in V8 (Chromium)',
    async () => {
      const browser = await launch();
      try {
        const page = await open(browser, []);
        await page.addScriptTag({ content: script });
        expect(await page.evaluate(RUN)).toEqual(expected);
      } finally {
        await browser.close();
      }
    },
    2 * MINUTES,
  );

  it(
    'in SpiderMonkey (Firefox)',
    async () => {
      expect(await runInFirefox()).toEqual(expected);
    },
    2 * MINUTES,
  );

  it(
    'in JavaScriptCore (jsc)',
    async () => {
      expect(await runInShell(find('jsc'), 'print')).toEqual(expected);
    },
    2 * MINUTES,
  );

  it(
    `in QuickJS, for ${QUICKJS_STEPS} steps`,
    async () => {
      const quickJS = await getQuickJS();
      const context = quickJS.newContext();
      context.unwrapResult(context.evalCode(script)).dispose();
      const kernels = context.unwrapResult(context.evalCode('golden.kernels()'));
      expect(context.dump(kernels)).toBe('TypeScript');
      kernels.dispose();
      const found: Hashes = {};
      for (const name of Object.keys(golden)) {
        const result = context.unwrapResult(context.evalCode(`golden.run(${JSON.stringify(name)}, ${QUICKJS_STEPS})`));
        found[name] = context.dump(result) as string[];
        result.dispose();
      }
      context.dispose();
      const count = QUICKJS_STEPS / EVERY;
      expect(Object.keys(found)).toHaveLength(6);
      expect(count).toBeGreaterThanOrEqual(20);
      for (const [name, hashes] of Object.entries(found)) {
        expect(hashes).toHaveLength(count);
        expect(hashes, name).toEqual(golden[name]!.slice(0, count));
      }
    },
    10 * MINUTES,
  );
});

/** A program that runs a file, and what prints there. */
async function runInShell(program: string, print: string): Promise<Found> {
  const file = join(folder, `${print}.js`);
  writeFileSync(file, `${script}; ${print}(JSON.stringify(${RUN}));`);
  const { stdout } = await promisify(execFile)(program, [file], { maxBuffer: 1e6 });
  return JSON.parse(stdout) as Found;
}

/** In a page that posts what it found. */
async function runInFirefox(): Promise<Found> {
  const page = `<!doctype html><meta charset="utf-8"><script>${script}
    const body = JSON.stringify(${RUN});
    fetch('/', { method: 'POST', body });
  </script>`;
  return askFirefox<Found>((url) => (url === '/' ? { type: 'text/html', body: page } : null));
}
