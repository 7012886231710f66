import { extname } from 'node:path';
import type { Browser, Page } from 'playwright-core';
import { afterAll, beforeAll, expect, it } from 'vitest';
import { HEADERS, readExample } from '../../examples/serve.mjs';
import { launch } from './browser.js';

// The examples that are pages, as `node examples/serve.mjs` shows them.

/** Pages of this origin may share memory with workers. */
const ORIGIN = 'http://localhost';

let browser: Browser;
const errors: string[] = [];

async function show(name: string): Promise<Page> {
  const page = await browser.newPage();
  page.on('pageerror', (error) => errors.push(String(error)));
  await page.context().route(`${ORIGIN}/**`, async (route) => {
    const { pathname } = new URL(route.request().url());
    const file = pathname === '/' ? 'index.html' : pathname.slice(1);
    const contentType = extname(file) === '.html' ? 'text/html' : 'text/javascript';
    await route.fulfill({ headers: { ...HEADERS, 'Content-Type': contentType }, body: await readExample(name, file) });
  });
  await page.goto(`${ORIGIN}/`);
  return page;
}

beforeAll(async () => {
  browser = await launch();
}, 60_000);

afterAll(async () => {
  await browser?.close();
});

it('rollback: both peers run, and agree', async () => {
  const page = await show('rollback');
  await page.waitForFunction(
    "/[1-9]\\d\\d frames compared: the same to the bit/.test(document.querySelector('p').textContent)",
  );
  expect(await page.textContent('p')).toMatch(/[1-9]\d* and [1-9]\d* rollbacks/);
  await page.close();
}, 60_000);

it('worker: the page sees what the worker steps', async () => {
  const page = await show('worker');
  await page.waitForFunction("parseInt(document.querySelector('p').textContent, 10) > 60");
  const lit: number = await page.evaluate(`
    Array.from(document.querySelector('canvas').getContext('2d').getImageData(0, 0, 800, 600).data)
      .filter((value, i) => i % 4 === 2 && value > 150).length`);
  expect(lit).toBeGreaterThan(1000);
  await page.close();
}, 60_000);

it('no error went by unseen', () => {
  expect(errors).toEqual([]);
});
