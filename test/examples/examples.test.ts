import { execFile } from 'node:child_process';
import { join } from 'node:path';
import { promisify } from 'node:util';
import type { Browser, Page } from 'playwright-core';
import { afterAll, beforeAll, describe, expect, it } from 'vitest';
import { launch, open } from '../browser/browser.js';

// The examples that are projects of their own: installed, built and run as their README says.

const run = promisify(execFile);
const folderOf = (name: string): string => join(import.meta.dirname, '../../examples', name);

let browser: Browser;
const errors: string[] = [];

async function npm(name: string, ...args: string[]): Promise<string> {
  const { stdout } = await run('npm', args, { cwd: folderOf(name), shell: process.platform === 'win32' });
  return stdout;
}

const install = (name: string): Promise<string> =>
  npm(name, 'install', '--no-package-lock', '--no-audit', '--no-fund', '--prefer-offline');

const ask = <T>(page: Page, expression: string): Promise<T> => page.evaluate(expression) as Promise<T>;

/** Opens the page of an example. */
const show = (name: string): Promise<Page> => open(browser, errors, `/examples/${name}/index.html`);

/** The picture on the page, as text: another one if anything moved. */
async function picture(page: Page): Promise<string> {
  return (await page.locator('canvas').screenshot()).toString('base64');
}

/** px. How far the farthest picture is from where the runner says that it belongs, after a frame. */
const farthest = (page: Page, pictures: string, runner: string): Promise<number> =>
  ask(
    page,
    `Math.max(...[...${pictures}].map(([body, { x, y }]) => {
      const [bx, by] = ${runner}.getPosition(body);
      return Math.hypot(x - 60 * bx, y - 60 * by);
    }))`,
  );

beforeAll(async () => {
  browser = await launch();
}, 60_000);

afterAll(async () => {
  await browser?.close();
});

describe('examples', { timeout: 180_000 }, () => {
  it('script tag: one global, a tower, a ball for each click', async () => {
    const page = await show('script-tag');
    expect(await ask(page, 'typeof phys2D.createWorld')).toBe('function');
    const before = await picture(page);
    await page.waitForTimeout(300);
    expect(await picture(page)).not.toBe(before);
    expect(await ask(page, 'world.rigidBodies.length')).toBe(9);
    await page.locator('canvas').click({ position: { x: 120, y: 60 } });
    const ball = 'world.rigidBodies[9].getPosition()';
    expect(await ask<number>(page, `${ball}[0]`)).toBeCloseTo(2, 1);
    await page.waitForFunction(`${ball}[1] > 8`);
    await page.close();
  });

  it('TypeScript and a bundler: types hold, barrels roll down', async () => {
    await install('bundler');
    await npm('bundler', 'run', 'check');
    await npm('bundler', 'run', 'build');
    const page = await show('bundler');
    await page.waitForFunction(`/^[1-9]\\d* barrels/.test(document.querySelector('#landed').textContent)`);
    const before = await picture(page);
    await page.waitForTimeout(200);
    expect(await picture(page)).not.toBe(before);
    await page.close();
  });

  it('server: 60 steps a second, poses printed, ends by itself', async () => {
    await install('server');
    const began = performance.now();
    const { stdout, stderr } = await run(process.execPath, ['server.js', '3'], { cwd: folderOf('server') });
    const seconds = (performance.now() - began) / 1000;
    expect(stderr).toBe('');
    const lines = stdout
      .trim()
      .split('\n')
      .map((line) => JSON.parse(line) as { step: number; poses: { name: string; x: number; y: number }[] });
    expect(seconds).toBeGreaterThan(2.9);
    expect(seconds).toBeLessThan(6);
    expect(lines.length).toBeGreaterThanOrEqual(4);
    expect(lines.at(-1)!.step).toBeLessThanOrEqual(181);
    for (const { poses } of lines) {
      expect(poses.map(({ name }) => name)).toEqual(['ada', 'bob', 'cyd']);
      expect(poses.every(({ y }) => y < 0 && y > -7)).toBe(true);
    }
    expect(lines.at(-1)!.poses[0]!.x).toBeGreaterThan(lines[0]!.poses[0]!.x + 1);
  });

  it('PixiJS: pictures are where the bodies are', async () => {
    await install('pixi');
    await npm('pixi', 'run', 'build');
    const page = await show('pixi');
    await page.waitForFunction('globalThis.world?.timeStamp > 5');
    expect(await ask(page, 'world.rigidBodies.length')).toBe(22);
    expect(await ask<boolean>(page, 'world.rigidBodies.every((body) => pictures.has(body))')).toBe(true);
    const before = await picture(page);
    await page.mouse.click(100, 100);
    await page.waitForFunction('world.rigidBodies.length === 23 && world.rigidBodies[22].getPosition()[1] > 4');
    expect(await picture(page)).not.toBe(before);
    expect(await farthest(page, 'pictures', 'runner')).toBeLessThan(1e-6);
    await page.close();
  });

  it('Phaser: crates fall, and can be dragged', async () => {
    await install('phaser');
    await npm('phaser', 'run', 'build');
    const page = await show('phaser');
    await page.waitForFunction('globalThis.game?.scene.scenes[0]?.world?.timeStamp > 60');
    const scene = 'game.scene.scenes[0]';
    expect(await ask(page, `${scene}.world.rigidBodies.length`)).toBe(13);
    const body = `${scene}.world.rigidBodies.at(-1)`;
    const [x, y] = await ask<[number, number]>(page, `${body}.getPosition().map((value) => 60 * value)`);
    await page.mouse.move(x, y);
    await page.mouse.down();
    await page.waitForFunction(`${scene}.world.constraints.length === 1`);
    await page.mouse.move(x - 40, y - 150, { steps: 6 });
    await page.waitForFunction(`${body}.getPosition()[1] < ${y / 60 - 1}`);
    await page.mouse.up();
    await page.waitForFunction(`${scene}.world.constraints.length === 0`);
    expect(await farthest(page, `${scene}.pictures`, `${scene}.runner`)).toBeLessThan(1e-6);
    await page.close();
  });

  it('no page reported an error', () => {
    expect(errors).toEqual([]);
  });
});
