import type { Browser, Page } from 'playwright-core';
import { afterAll, beforeAll, describe, expect, it } from 'vitest';
import { launch, open } from './browser.js';

// Debug drawing in a browser, with the minified bundles: what is really seen.

let browser: Browser;
let page: Page;
const errors: string[] = [];

/** Calls a function of pages/debug.js. */
function call<T>(name: string, ...args: unknown[]): Promise<T> {
  return page.evaluate(`import('/pages/debug.js').then((page) => page.${name}(...${JSON.stringify(args)}))`);
}

beforeAll(async () => {
  browser = await launch();
  page = await open(browser, errors);
}, 60_000);

afterAll(async () => {
  await browser?.close();
});

describe.each(['canvas', 'webgl'])('lines on %s', (kind) => {
  const BLACK = [0, 0, 0];
  const WHOLE = [0, 0, 100, 80];

  it('lie where they should, in their colours', async () => {
    const lines = [
      [10, 10.5, 90, 10.5, [1, 0, 0, 1]],
      [20.5, 20, 20.5, 70, [0, 1, 0, 0.5]],
      [30, 30.5, 60, 30.5, [0.2, 0.4, 0.6, 1]],
    ];
    const places = [
      [50, 10],
      [50, 9],
      [50, 11],
      [20, 45],
      [19, 45],
      [21, 45],
      [45, 30],
      [25, 30],
      [65, 30],
      [5, 10],
      [95, 10],
    ];
    const found = await call<number[][]>('pattern', kind, lines, WHOLE, places);
    expect(found[0]).toEqual([255, 0, 0]);
    expect(found[3]![0]).toBe(0);
    expect(found[3]![1]).toBeGreaterThanOrEqual(127);
    expect(found[3]![1]).toBeLessThanOrEqual(128);
    expect(found[6]).toEqual([51, 102, 153]);
    for (const i of [1, 2, 4, 5, 7, 8, 9, 10]) {
      expect(found[i], `place ${places[i]}`).toEqual(BLACK);
    }
  });

  it('blend in their order', async () => {
    const lines = [
      [10, 10.5, 90, 10.5, [1, 0, 0, 1]],
      [10, 10.5, 90, 10.5, [0, 0, 1, 0.5]],
      [10, 20.5, 90, 20.5, [0, 0, 1, 0.5]],
      [10, 20.5, 90, 20.5, [1, 0, 0, 1]],
    ];
    const [first, second] = await call<number[][]>('pattern', kind, lines, WHOLE, [
      [50, 10],
      [50, 20],
    ]);
    expect(Math.abs(first![0]! - 127.5)).toBeLessThan(1);
    expect(Math.abs(first![2]! - 127.5)).toBeLessThan(1);
    expect(second).toEqual([255, 0, 0]);
  });

  it('end at the screen viewport, however long they are', async () => {
    const lines = [
      [-1e20, 20.5, 1e20, 20.5, [1, 1, 1, 1]],
      [30.5, -1e20, 30.5, 1e20, [1, 1, 1, 1]],
    ];
    const inside = [
      [20, 20],
      [59, 20],
      [40, 20],
      [30, 10],
      [30, 49],
    ];
    const outside = [
      [19, 20],
      [61, 20],
      [30, 8],
      [30, 51],
      [2, 20],
      [30, 79],
    ];
    const found = await call<number[][]>('pattern', kind, lines, [20, 10, 60, 50], [...inside, ...outside]);
    expect(found.slice(0, inside.length)).toEqual(inside.map(() => [255, 255, 255]));
    expect(found.slice(inside.length)).toEqual(outside.map(() => BLACK));
  });
});

it('a scene looks alike on Canvas and with WebGL', async () => {
  const [canvas, webgl] = await call<{ lit: number; share: number }[]>('compare');
  expect(canvas!.lit).toBeGreaterThan(3000);
  expect(webgl!.lit).toBeGreaterThan(3000);
  expect(canvas!.share).toBeGreaterThan(0.995);
  expect(webgl!.share).toBeGreaterThan(0.995);
});

describe('100,000 segments a frame', () => {
  const SEGMENTS = 100_000;

  /** Bytes allocated for a frame that is like many before it. */
  async function garbage(): Promise<number> {
    const frames = 20;
    await call('drawMany', 40);
    const session = await page.context().newCDPSession(page);
    const collected = { includeObjectsCollectedByMajorGC: true, includeObjectsCollectedByMinorGC: true };
    await session.send('HeapProfiler.startSampling', { samplingInterval: 512, ...collected });
    const milliseconds = await call<number>('drawMany', frames);
    const { profile } = await session.send('HeapProfiler.stopSampling');
    await session.detach();
    const bytes = profile.samples.reduce((sum, { size }) => sum + size, 0) / frames;
    console.log(`${milliseconds.toFixed(1)} ms and ${Math.round(bytes)} bytes a frame`);
    return bytes;
  }

  it('of lines are one draw call, and no garbage', async () => {
    const calls = await call<unknown[][]>('prepareMany', 'lines', SEGMENTS);
    expect(calls.map(([name]) => name)).toEqual(['drawElements']);
    expect(calls[0]![2]).toBe(6 * SEGMENTS);
    expect(await garbage()).toBeLessThan(SEGMENTS / 10);
  });

  it('of a world are one draw call, and not a boxed number each', async () => {
    const calls = await call<unknown[][]>('prepareMany', 'world', SEGMENTS);
    expect(calls.map(([name]) => name)).toEqual(['drawElements']);
    const segments = (calls[0]![2] as number) / 6;
    expect(segments).toBeGreaterThan(SEGMENTS);
    expect(await garbage()).toBeLessThan(12 * segments);
  });
});

it('WebGL goes on after a lost context', async () => {
  const { colors, error } = await call<{ colors: number[][]; error: number }>('loseContext');
  expect(colors[0]).toEqual([0, 255, 0, 255]);
  expect(colors[2]).toEqual([0, 255, 0, 255]);
  expect(error).toBe(0);
});

it('the page of the README shows crates that fall', async () => {
  const readme = await open(browser, errors);
  // Looks at two early frames as they are drawn: later, which may be soon on a slow machine, the crates sleep.
  await readme.addInitScript(`
    window.lit = [];
    const next = window.requestAnimationFrame;
    let frame = 0;
    window.requestAnimationFrame = (draw) => next((time) => {
      draw(time);
      frame += 1;
      if (frame === 3 || frame === 10) {
        const { data } = document.querySelector('canvas').getContext('2d').getImageData(0, 0, 900, 600);
        window.lit.push(Array.from({ length: 900 * 600 }, (_, i) => i).filter((i) => Math.max(data[4 * i], data[4 * i + 1], data[4 * i + 2]) > 90));
      }
    });`);
  await readme.goto(new URL('/readme.html', readme.url()).href);
  await readme.waitForFunction('lit.length === 2');
  const [before, after] = await readme.evaluate<number[][]>('lit');
  expect(before!.length).toBeGreaterThan(1000);
  expect(after!.length).toBeGreaterThan(1000);
  expect(after).not.toEqual(before);
  await readme.close();
});

it('no error went by unseen', () => {
  expect(errors).toEqual([]);
});
