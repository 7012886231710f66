import { readFileSync } from 'node:fs';
import { extname, join } from 'node:path';
import { build } from 'esbuild';
import { type Browser, type BrowserContextOptions, chromium, type Page } from 'playwright-core';
import { find } from './engines.mjs';

// Chromium, and pages that load the built package. What runs in a page is in `pages`, as plain modules.

const root = join(import.meta.dirname, '../..');

/** Addresses of this origin are answered from the project, nothing leaves the machine. */
const ORIGIN = 'http://phys2d.test';

const TYPES: Readonly<Record<string, string>> = { '.html': 'text/html', '.css': 'text/css' };

const ARGUMENTS = [
  '--no-sandbox',
  '--headless',
  '--disable-gpu',
  '--disable-background-networking',
  '--use-gl=angle',
  '--use-angle=swiftshader',
  '--enable-unsafe-swiftshader',
];

/** Starts a browser; close it when done. WebGL is computed by the processor, so that it is there on every machine. */
export async function launch(): Promise<Browser> {
  return chromium.launch({ executablePath: find('chromium'), args: ARGUMENTS });
}

/**
 * Opens a page, an empty one or one of `pages`; `/readme.html` is the one that the README shows. It can import `/dist/…` (also as
 * `/node_modules/phys2d/dist/…`), `/pages/…`, `/examples/…`, and `/scenes/….js`, which is built from that scene. Errors of the page that nothing
 * catches, and what it reports to the console as such, are put into `errors`.
 */
export async function open(
  browser: Browser,
  errors: string[],
  path = '/',
  options: BrowserContextOptions = {},
): Promise<Page> {
  const page = await browser.newPage({ viewport: { width: 1000, height: 700 }, ...options });
  page.on('pageerror', (error) => errors.push(String(error)));
  page.on('console', (message) => {
    if (message.type() === 'error') {
      errors.push(message.text());
    }
  });
  await page.route('**/*', async (route) => {
    const { origin, pathname } = new URL(route.request().url());
    if (origin !== ORIGIN) {
      await route.abort();
    } else if (pathname === '/') {
      await route.fulfill({
        contentType: 'text/html',
        body: '<!doctype html><meta charset="utf-8"><title>phys2d</title>',
      });
    } else {
      const contentType = TYPES[extname(pathname)] ?? 'text/javascript';
      await route.fulfill({ contentType, body: await read(pathname) });
    }
  });
  await page.goto(ORIGIN + path);
  return page;
}

async function read(pathname: string): Promise<string> {
  if (pathname === '/readme.html') {
    return /```html\n(<canvas[\s\S]*?)```/.exec(readFileSync(join(root, 'README.md'), 'utf8'))![1]!;
  }
  const [, folder, ...rest] = pathname.replace(/^\/(some\/where|node_modules\/phys2d)\//, '/').split('/');
  if (folder === 'scenes') {
    const entry = join(root, 'test/scenes', rest.join('/').replace(/\.js$/, '.ts'));
    const { outputFiles } = await build({ entryPoints: [entry], bundle: true, format: 'esm', write: false });
    return outputFiles[0]!.text;
  }
  const home = folder === 'dist' || folder === 'examples' ? folder : 'test/browser/pages';
  return readFileSync(join(root, home, ...rest), 'utf8');
}
