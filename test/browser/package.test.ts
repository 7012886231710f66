import type { Browser, Page } from 'playwright-core';
import { afterAll, beforeAll, describe, expect, it } from 'vitest';
import type { Physics2DDevice } from '../../src/index.js';
import { launch, open } from './browser.js';

// The bundles where browsers load them: by script tags, as modules, in workers. All come to the same bits.

let browser: Browser;
let page: Page;
const errors: string[] = [];

beforeAll(async () => {
  browser = await launch();
  page = await open(browser, errors);
}, 60_000);

afterAll(async () => {
  await browser?.close();
});

/** Where a body is after a second's fall; runs in the page. */
function fall(device: unknown): number[] {
  const phys2D = device as Physics2DDevice;
  const world = phys2D.createWorld({ gravity: [0, 10] });
  const body = phys2D.createRigidBody({ shapes: [phys2D.createCircleShape({ radius: 0.5 })] });
  world.addRigidBody(body);
  for (let i = 0; i < 60; i += 1) {
    world.step(1 / 60);
  }
  return body.getPosition();
}

const run = (device: string): Promise<number[]> => page.evaluate(`(async () => (${fall})(${device}))()`);

describe('in a browser', () => {
  let expected: number[];

  it('a module is imported', async () => {
    expected = await run("(await import('/dist/phys2d.js')).phys2D");
    expect(expected[0]).toBe(0);
    expect(Math.round(expected[1]!)).toBe(5);
    expect(await run("(await import('/dist/phys2d.min.js')).default")).toEqual(expected);
  });

  it.each(['phys2d.umd.js', 'phys2d.umd.min.js'])('a script tag loads %s', async (name) => {
    await page.evaluate('delete globalThis.phys2D');
    await page.addScriptTag({ url: `/dist/${name}` });
    expect(await run('globalThis.phys2D')).toEqual(expected);
  });

  it.each([
    ['worker.js', 'module'],
    ['classic-worker.js', 'classic'],
  ])('a worker runs %s, a %s', async (name, type) => {
    const code = `new Promise((resolve, reject) => {
      const worker = new Worker('/pages/${name}', { type: '${type}' });
      worker.onmessage = ({ data }) => resolve(data);
      worker.onerror = ({ message }) => reject(new Error(message));
    })`;
    expect(await page.evaluate(code)).toEqual(expected);
  });

  it.each(['phys2d.js', 'phys2d.min.js'])(
    '%s solves by WebAssembly, and without where a page forbids that',
    async (name) => {
      const ask = `import('/dist/${name}').then(({ simdKernels }) => simdKernels.isSupported())`;
      expect(await page.evaluate(ask)).toBe(true);
      const strict = await open(browser, []);
      await strict.route('**/strict', (route) =>
        route.fulfill({
          contentType: 'text/html',
          body: '',
          headers: { 'Content-Security-Policy': "script-src 'self'" },
        }),
      );
      await strict.goto(new URL('/strict', strict.url()).href);
      expect(await strict.evaluate(ask)).toBe(false);
      const code = `import('/dist/${name}').then(({ phys2D }) => (${fall})(phys2D))`;
      expect(await strict.evaluate(code)).toEqual(expected);
      await strict.close();
    },
  );

  it('no page has thrown anything', () => {
    expect(errors).toEqual([]);
  });
});
