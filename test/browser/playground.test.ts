import { readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { gzipSync } from 'node:zlib';
import type { Browser, BrowserContextOptions, Page } from 'playwright-core';
import { afterAll, beforeAll, describe, expect, it } from 'vitest';
import { type Scene, scenes } from '../../playground/scenes.js';
import { phys2D } from '../../src/index.js';
import { HANDS_OFF } from '../scenes/play.js';
import { launch, open } from './browser.js';

// The built playground, as people use it: clicks, keys, fingers.

const FOLDER = join(import.meta.dirname, '../../dist/playground');
const HOME = '/dist/playground/index.html';
/** Screenshots, for a person to look at. */
const PICTURES = join(import.meta.dirname, 'pictures');
const PHONE: BrowserContextOptions = { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true };

let browser: Browser;
let page: Page;
const errors: string[] = [];

const start = (link = '', options: BrowserContextOptions = {}): Promise<Page> =>
  open(browser, errors, `${HOME}#${link}`, { viewport: { width: 1280, height: 800 }, ...options });

/** The value of an expression in the page. */
const ask = <T>(expression: string, on = page): Promise<T> => on.evaluate(expression) as Promise<T>;

const until = async (expression: string, on = page): Promise<void> => {
  await on.waitForFunction(expression, undefined, { timeout: 60_000 });
};

const steps = (on = page): Promise<number> => ask('playground.simulation.steps', on);

/** Another scene in the same page, paused after so many steps. */
async function show(link: string, count: number, on = page): Promise<void> {
  await ask(`location.hash = '${link}&steps=${count}&x=${Math.random()}'`, on);
  const id = /scene=([\w-]+)/.exec(link)![1];
  const simulation = 'playground.simulation';
  await until(`${simulation}.scene.id === '${id}' && !${simulation}.playing && ${simulation}.steps === ${count}`, on);
}

/** Where on the page the first dynamic body that fits is. */
function placeOf(which: string, on = page): Promise<[number, number]> {
  return ask(
    `playground.view.toPage(playground.simulation.world.rigidBodies.filter((body) => body.isDynamic())${which}.getPosition())`,
    on,
  );
}

/** The hash after so many steps, without a page. */
function hashOf(scene: Scene, count: number, params: object = {}): string {
  const world = phys2D.createWorld({ gravity: scene.gravity ?? [0, 10], ...params });
  const play = scene.build(phys2D, world);
  for (let i = 0; i < count; i += 1) {
    play.beforeStep?.(HANDS_OFF);
    world.step(1 / 60);
  }
  return world.hash();
}

/** How many of the pixels of the picture are not as the paper. */
async function inked(on = page): Promise<number> {
  return ask(
    `(() => {
      const { canvas, gl } = playground.view;
      playground.view.draw(playground.simulation, playground.settings.draw);
      const data = new Uint8Array(4 * canvas.width * canvas.height);
      gl.readPixels(0, 0, canvas.width, canvas.height, gl.RGBA, gl.UNSIGNED_BYTE, data);
      let count = 0;
      for (let i = 0; i < data.length; i += 4) {
        count += Math.abs(data[i] - data[0]) + Math.abs(data[i + 1] - data[1]) > 12 ? 1 : 0;
      }
      return count;
    })()`,
    on,
  );
}

beforeAll(async () => {
  browser = await launch();
  page = await start('scene=pyramid');
}, 60_000);

afterAll(async () => {
  await browser?.close();
});

describe('the page', () => {
  it('is light: no more than 150 kB, and says how soon it paints', async () => {
    const weights = readdirSync(FOLDER).map((name) => gzipSync(readFileSync(join(FOLDER, name)), { level: 9 }).length);
    const weight = weights.reduce((sum, size) => sum + size, 0);
    const painted = `performance.getEntriesByName('first-contentful-paint')[0]`;
    await until(painted);
    const paint = await ask<number>(`${painted}.startTime`);
    console.log(`playground: ${(weight / 1000).toFixed(1)} kB gzipped, first paint after ${paint.toFixed(0)} ms`);
    expect(weight).toBeLessThanOrEqual(150_000);
    expect(paint).toBeLessThan(5000);
  });

  it('works from any path', async () => {
    const elsewhere = await open(browser, errors, '/some/where/dist/playground/index.html#scene=arch');
    await until('playground.simulation.steps > 5', elsewhere);
    expect(await elsewhere.title()).toContain('Arch');
    await elsewhere.close();

    const onDisk = await browser.newPage();
    onDisk.on('pageerror', (error) => errors.push(String(error)));
    await onDisk.goto(`${pathToFileURL(join(FOLDER, 'index.html'))}#scene=bridge`);
    await until('playground.simulation.steps > 5', onDisk);
    expect(await onDisk.title()).toContain('Bridge');
    await onDisk.close();
  });

  it('names every control', async () => {
    const nameless = await ask<string[]>(`[...document.querySelectorAll('button, input, select, canvas')]
      .filter((element) => !(element.getAttribute('aria-label') || element.labels?.[0]?.textContent || element.textContent).trim())
      .map((element) => element.outerHTML)`);
    expect(nameless).toEqual([]);
    const count = await ask<number>(`document.querySelectorAll('button, input, select').length`);
    expect(count).toBeGreaterThan(scenes.length + 20);
  });
});

describe('scenes', { timeout: 120_000 }, () => {
  it.each(scenes.map(({ id }) => id))('%s runs 300 steps, moves, is seen', async (id) => {
    const scene = scenes.find((each) => each.id === id)!;
    await page.getByRole('navigation').getByRole('button', { name: scene.title, exact: true }).click();
    await until(`document.querySelector('#title').textContent === ${JSON.stringify(scene.title)}`);
    expect(await ask('playground.simulation.scene.id')).toBe(id);
    await ask(`playground.simulation.playing = false`);
    const before = await ask<string>('playground.simulation.hash()');
    await ask(`(() => {
      for (let i = 0; i < 300; i += 1) {
        playground.simulation.step();
        if (i % 20 === 0) playground.view.draw(playground.simulation, playground.settings.draw);
      }
    })()`);
    expect(await ask<string>('playground.simulation.hash()')).not.toBe(before);
    expect(await inked()).toBeGreaterThan(500);
    await page.screenshot({ path: join(PICTURES, `${id}.png`) });
    expect(errors).toEqual([]);
  });

  it('the graph and the numbers tell what happens', async () => {
    await show('scene=tower', 20);
    await until(`document.querySelector('#steps').textContent === '20'`);
    expect(await page.locator('#bodies').textContent()).toBe('17');
    expect(await page.locator('#awake').textContent()).toBe('16');
    expect(Number(await page.locator('#contacts').textContent())).toBeGreaterThanOrEqual(32);
    expect(await page.locator('#hash').textContent()).toMatch(/^[0-9a-f]{16}$/);
    expect(await page.locator('#legend').textContent()).toMatch(/velocities\d+\.\d\d.*drawing\d+\.\d\d/);
    const drawn = await ask<number>(`(() => {
      const canvas = document.querySelector('#graph');
      const { data } = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height);
      return data.filter((value, i) => i % 4 === 3 && value > 200).length;
    })()`);
    expect(drawn).toBeGreaterThan(10);
  });

  it('5,000 bodies: how long a frame takes', async () => {
    await show('scene=crowd', 60);
    // In the end a pixel is asked for, which waits until all is drawn: by the processor, here.
    const [physics, drawing, painting] = await ask<number[]>(`(() => {
      const { simulation, view, settings } = playground;
      const sums = [0, 0, 0];
      const { gl } = view;
      const pixel = new Uint8Array(4);
      for (let i = 0; i < 60; i += 1) {
        const times = [performance.now()];
        simulation.step();
        times.push(performance.now());
        view.draw(simulation, settings.draw);
        times.push(performance.now());
        gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, pixel);
        times.push(performance.now());
        sums[0] += (times[1] - times[0]) / 60;
        sums[1] += (times[2] - times[1]) / 60;
        sums[2] += (times[3] - times[2]) / 60;
      }
      return sums;
    })()`);
    const share = drawing! / (physics! + drawing!);
    const ms = [physics, drawing, painting].map((value) => `${value!.toFixed(1)} ms`);
    console.log(
      `5,000 bodies: physics ${ms[0]}, drawing ${ms[1]}, ${(100 * share).toFixed(0)} %; pixels by the processor ${ms[2]}`,
    );
    expect(share).toBeLessThanOrEqual(0.25);
  });
});

describe('playing', () => {
  beforeAll(async () => {
    await show('scene=pyramid', 5);
  });

  it('plays, pauses, steps, starts again', async () => {
    await page.getByRole('button', { name: 'Play' }).click();
    await until('playground.simulation.steps > 20');
    await page.getByRole('button', { name: 'Pause' }).click();
    const paused = await steps();
    await page.waitForTimeout(200);
    expect(await steps()).toBe(paused);
    await page.getByRole('button', { name: 'Single step' }).click();
    await page.getByRole('button', { name: 'Single step' }).click();
    expect(await steps()).toBe(paused + 2);
    await page.getByRole('button', { name: 'Restart' }).click();
    expect(await steps()).toBeLessThan(paused);
    await until('playground.simulation.steps > 2');
  });

  it('runs slower and faster', async () => {
    const rate = async (speed: string): Promise<number> => {
      await show('scene=gears', 1);
      await page.getByLabel('Speed').selectOption(speed);
      await page.getByRole('button', { name: 'Play' }).click();
      return ask(`new Promise((resolve) => {
        const { simulation } = playground;
        const [first, since] = [simulation.steps, performance.now()];
        setTimeout(() => resolve((simulation.steps - first) / (performance.now() - since)), 1500);
      })`);
    };
    const [slow, usual, fast] = [await rate('0.25'), await rate('1'), await rate('2')];
    expect(slow).toBeLessThan(0.4 * usual);
    expect(slow).toBeGreaterThan(0.1 * usual);
    expect(fast).toBeGreaterThan(1.4 * usual);
    await page.getByLabel('Speed').selectOption('1');
  });

  it('obeys keys', async () => {
    await show('scene=arch', 3);
    await page.locator('#stage').focus();
    await page.keyboard.press('.');
    expect(await steps()).toBe(4);
    await page.keyboard.press(' ');
    await until('playground.simulation.steps > 8');
    await page.keyboard.press(' ');
    await page.keyboard.press(']');
    expect(await ask('playground.simulation.scene.id')).toBe('cards');
    await page.keyboard.press('[');
    expect(await ask('playground.simulation.scene.id')).toBe('arch');
    await until('playground.simulation.steps > 3');
    const generation = await ask<number>('playground.simulation.generation');
    await page.keyboard.press('r');
    expect(await ask('playground.simulation.generation')).toBe(generation + 1);
    await page.keyboard.press('3');
    expect(await page.getByRole('radio', { name: 'Ball' }).getAttribute('aria-checked')).toBe('true');
    await page.keyboard.press('1');
    await page.keyboard.press('?');
    expect(await page.getByRole('dialog').isVisible()).toBe(true);
    await page.keyboard.press('Escape');
    expect(await page.getByRole('dialog').isVisible()).toBe(false);
  });

  it('chooses among the tools by arrows, for who comes to them with the keyboard', async () => {
    await show('scene=platformer', 3);
    const [grab, next] = [page.getByRole('radio').first(), page.getByRole('radio').nth(1)];
    await grab.focus();
    await page.keyboard.press('ArrowRight');
    expect(await next.getAttribute('aria-checked')).toBe('true');
    expect(await ask('document.activeElement.id')).toBe(await next.getAttribute('id'));
    expect(await grab.getAttribute('tabindex')).toBe('-1');
    await page.keyboard.press('ArrowLeft');
    expect(await grab.getAttribute('aria-checked')).toBe('true');
    expect(await ask('playground.simulation.controls.right')).toBe(false);
  });

  it('leaves the keys to the scene after something was set with the pointer', async () => {
    await show('scene=platformer', 3);
    await page.getByRole('radio').first().click();
    await page.getByLabel('Contacts').click();
    await page.keyboard.down('ArrowRight');
    expect(await ask('playground.simulation.controls.right')).toBe(true);
    await page.keyboard.up('ArrowRight');
    await page.keyboard.press('.');
    expect(await steps()).toBe(4);
    await page.getByLabel('Contacts').click();
  });

  it('moves the player by the arrow keys', async () => {
    await show('scene=platformer', 30);
    const before = await ask<number>('playground.simulation.play.player.getPosition()[0]');
    await page.getByRole('button', { name: 'Play' }).click();
    await page.keyboard.down('ArrowRight');
    await until(`playground.simulation.play.player.getPosition()[0] > ${before + 1}`);
    await page.keyboard.up('ArrowRight');
    await page.keyboard.down('ArrowUp');
    await until('playground.simulation.play.player.getVelocity()[1] < -3');
    await page.keyboard.up('ArrowUp');
  });
});

describe('settings', () => {
  it('change the world', async () => {
    await show('scene=pyramid', 5);
    const set = (label: string, value: number): Promise<void> => page.getByLabel(label).fill(String(value));
    await set('Gravity across', 3);
    await set('Gravity down', -5);
    await set('Velocity iterations', 12);
    await set('Position iterations', 13);
    await set('Substeps', 2);
    await page.getByLabel('Bodies fall asleep').uncheck();
    const world = 'playground.simulation.world';
    expect(await ask(`${world}.getGravity()`)).toEqual([3, -5]);
    expect(
      await ask(
        `[${world}.velocityIterations, ${world}.positionIterations, ${world}.substeps, ${world}.allowSleeping]`,
      ),
    ).toEqual([12, 13, 2, false]);
    await page.getByLabel('Broadphase').selectOption('Sweep and prune');
    expect(await ask(`${world}.broadphase.constructor.name !== undefined && ${world}.timeStamp`)).toBeLessThan(5);
    const link = await ask<string>('location.hash');
    expect(link).toBe('#scene=pyramid&gravity=3,-5&velocity=12&position=13&substeps=2&broadphase=sweep&sleep=no');
  });

  it('of drawing change the picture', async () => {
    await show('scene=constraints', 30);
    const all = await inked();
    await page.getByLabel('Filled bodies').uncheck();
    const lines = await inked();
    expect(lines).toBeLessThan(0.6 * all);
    await page.getByLabel('Constraints', { exact: true }).uncheck();
    const bodies = await inked();
    expect(bodies).toBeLessThan(lines - 200);
    for (const label of ['Contacts', 'Impulses', 'Bounds', 'Origins and paths']) {
      await page.getByLabel(label).check();
      expect(await inked(), label).toBeGreaterThan(bodies + 10);
      await page.getByLabel(label).uncheck();
    }
    await page.getByLabel('Debug drawing only').check();
    expect(await ask('location.hash')).toContain('draw=');
    expect(await inked()).not.toBe(bodies);
    await page.getByLabel('Interpolation').uncheck();
    expect(await ask(`playground.settings.draw.has('smooth')`)).toBe(false);
  });

  it('what is thinner than a pixel is seen', async () => {
    await show('scene=cards', 1);
    await ask(
      `playground.simulation.world.removeRigidBody(playground.simulation.world.rigidBodies.find((body) => body.isStatic()))`,
    );
    // 40 lines of 70 px and more, two pixels wide.
    expect(await inked()).toBeGreaterThan(5000);
  });

  it('light and dark follow the system and the button', async () => {
    for (const colorScheme of ['light', 'dark'] as const) {
      const other = await start('scene=arch&steps=5', { colorScheme });
      await until('playground.simulation.steps === 5', other);
      const brightness = (): Promise<number> =>
        ask(
          `(() => {
            const { gl } = playground.view;
            playground.view.draw(playground.simulation, playground.settings.draw);
            const pixel = new Uint8Array(4);
            gl.readPixels(1, gl.drawingBufferHeight - 2, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, pixel);
            const page = getComputedStyle(document.body).backgroundColor.match(/\\d+/g).map(Number);
            return (pixel[0] > 127 ? 1 : 0) + (page[0] > 127 ? 1 : 0);
          })()`,
          other,
        );
      expect(await brightness()).toBe(colorScheme === 'light' ? 2 : 0);
      await other.getByRole('button', { name: 'Theme' }).click();
      expect(await brightness()).toBe(colorScheme === 'light' ? 0 : 2);
      await other.close();
    }
  });
});

it('the picture comes back after a lost context', async () => {
  await show('scene=constraints', 30);
  const before = await inked();
  await ask(`(async () => {
    const { gl, canvas } = playground.view;
    const happens = (type) => new Promise((resolve) => canvas.addEventListener(type, resolve, { once: true }));
    const extension = gl.getExtension('WEBGL_lose_context');
    const lost = happens('webglcontextlost');
    extension.loseContext();
    await lost;
    const restored = happens('webglcontextrestored');
    setTimeout(() => extension.restoreContext(), 0);
    await restored;
  })()`);
  expect(await inked()).toBe(before);
});

describe('a link', () => {
  it.each([
    ['scene=bridge', 'bridge', 150, {}],
    ['scene=wall&substeps=2&velocity=12&broadphase=sweep', 'wall', 100, { substeps: 2, velocityIterations: 12 }],
    ['scene=rain&gravity=4,6&sleep=no', 'rain', 40, { gravity: [4, 6], allowSleeping: false }],
    ['scene=callbacks', 'callbacks', 200, {}],
  ])('%s gives the state that it promises', async (link, id, count, params) => {
    await show(link, count);
    const scene = scenes.find((each) => each.id === id)!;
    const hash = hashOf(scene, count, params);
    expect(await ask('playground.simulation.hash()')).toBe(hash);
    await until(`document.querySelector('#hash').textContent === '${hash}'`);
  });

  it('can be copied, and opened elsewhere', async () => {
    await show('scene=chain&substeps=3', 77);
    await page.getByRole('button', { name: 'Copy link' }).click();
    const link = await ask<string>('location.href');
    expect(link).toMatch(/#scene=chain&substeps=3&steps=77$/);
    const other = await start(link.replace(/.*#/, ''));
    await until('playground.simulation.steps === 77 && !playground.simulation.playing', other);
    expect(await ask('playground.simulation.hash()', other)).toBe(await ask('playground.simulation.hash()'));
    await other.close();
  });

  it('that makes no sense opens the first scene', async () => {
    const other = await start('scene=nowhere&substeps=-3&gravity=a,b&velocity=1e9&draw=fill,nothing&speed=17&steps=x');
    await until('playground.simulation.steps > 2', other);
    expect(await ask('location.hash', other)).toBe('#scene=materials&draw=fill');
    await other.close();
  });
});

describe('a hand', () => {
  it('grabs and throws by mouse', async () => {
    await show('scene=pyramid', 5);
    await page.getByRole('radio', { name: 'Grab' }).click();
    const [x, y] = await placeOf('.at(-1)');
    const top = `playground.simulation.world.rigidBodies.at(-1)`;
    const joints = 'playground.simulation.world.constraints.length';
    await page.mouse.move(x, y);
    await page.mouse.down();
    expect(await ask(joints)).toBe(1);
    await page.getByRole('button', { name: 'Play' }).press('Enter');
    await page.mouse.move(x + 120, y - 20, { steps: 10 });
    await until(`playground.view.toPage(${top}.getPosition())[0] > ${x + 60}`);
    await page.getByRole('button', { name: 'Pause' }).press('Enter');
    await page.mouse.move(x + 320, y - 60, { steps: 4 });
    await ask('playground.simulation.step(4)');
    await page.mouse.up();
    expect(await ask(joints)).toBe(0);
    expect(await ask<number>(`${top}.getVelocity()[0]`)).toBeGreaterThan(2);
    expect(await ask('playground.simulation.touched')).toBe(true);
    const link = await ask<string>('playground.link()');
    expect(link).not.toContain('steps=');
  });

  it('moves the picture where there is nothing, and zooms by the wheel', async () => {
    await show('scene=pyramid', 5);
    const [x, y] = await placeOf('[0]');
    await page.mouse.move(400, 150);
    await page.mouse.down();
    await page.mouse.move(450, 180, { steps: 3 });
    await page.mouse.up();
    const [panned, lower] = await placeOf('[0]');
    expect(panned - x).toBeCloseTo(50, 0);
    expect(lower - y).toBeCloseTo(30, 0);
    const before = await ask<number>('playground.view.pixel');
    await page.mouse.wheel(0, -200);
    await until(`playground.view.pixel < ${0.9 * before}`);
    await page.getByRole('button', { name: 'Show all' }).click();
    expect((await placeOf('[0]'))[0]).toBeCloseTo(x, 0);
  });

  it('adds, deletes, explodes', async () => {
    await show('scene=pyramid', 5);
    const bodies = 'playground.simulation.world.rigidBodies';
    for (const [i, tool] of ['Box', 'Ball', 'Stone'].entries()) {
      await page.getByRole('radio', { name: tool }).click();
      await page.mouse.click(350 + 40 * i, 200);
      expect(await ask(`${bodies}.length`)).toBe(212 + i);
      const [x, y] = await ask<[number, number]>(`playground.view.toPage(${bodies}.at(-1).getPosition())`);
      expect([x, y]).toEqual([expect.closeTo(350 + 40 * i, 0), expect.closeTo(200, 0)]);
    }
    await page.getByRole('radio', { name: 'Delete' }).click();
    await page.mouse.click(390, 200);
    expect(await ask(`${bodies}.length`)).toBe(213);
    expect(await ask(`${bodies}.filter((body) => body.isDynamic() && body.shapes[0].type === 'CIRCLE').length`)).toBe(
      0,
    );
    await page.getByRole('radio', { name: 'Explode' }).click();
    const [x, y] = await placeOf('[100]');
    await page.mouse.click(x, y);
    const fastest = `Math.max(...${bodies}.map((body) => Math.hypot(...body.getVelocity())))`;
    expect(await ask<number>(fastest)).toBeGreaterThan(5);
    await page.getByRole('radio', { name: 'Grab' }).click();
  });
});

describe('a phone', () => {
  let phone: Page;

  beforeAll(async () => {
    phone = await start('scene=wall', PHONE);
    await until('playground.simulation.steps > 2', phone);
  });

  afterAll(async () => {
    await phone?.close();
  });

  it.each([
    [390, 844],
    [320, 568],
    [844, 390],
  ])('of %d × %d px: nothing overflows, nothing overlaps', async (width, height) => {
    await phone.setViewportSize({ width, height });
    for (const id of ['platformer', 'wall']) {
      await show(`scene=${id}`, 5, phone);
      await phone.waitForTimeout(100);
      await phone.screenshot({ path: join(PICTURES, `${id}-${width}x${height}.png`) });
      const [wide, high] = await ask<number[]>(
        '[document.documentElement.scrollWidth, document.documentElement.scrollHeight]',
        phone,
      );
      expect(wide).toBe(width);
      expect(high).toBe(height);
      const buttons = await ask<{ name: string; box: number[] }[]>(
        `[...document.querySelectorAll('header button, #dock button, #dock select, #pad button')]
          .filter((element) => element.offsetParent !== null)
          .map((element) => {
            const { left, top, right, bottom } = element.getBoundingClientRect();
            return { name: element.textContent || element.ariaLabel, box: [left, top, right, bottom] };
          })`,
        phone,
      );
      expect(buttons.length).toBeGreaterThanOrEqual(id === 'platformer' ? 17 : 13);
      for (const [i, { name, box }] of buttons.entries()) {
        expect(box[0], name).toBeGreaterThanOrEqual(0);
        expect(box[1], name).toBeGreaterThanOrEqual(0);
        expect(box[2], name).toBeLessThanOrEqual(width);
        expect(box[3], name).toBeLessThanOrEqual(height);
        expect(Math.min(box[2]! - box[0]!, box[3]! - box[1]!), name).toBeGreaterThanOrEqual(36);
        for (const { name: other, box: rival } of buttons.slice(i + 1)) {
          const overlaps = box[0]! < rival[2]! && rival[0]! < box[2]! && box[1]! < rival[3]! && rival[1]! < box[3]!;
          expect(overlaps, `${name} and ${other}`).toBe(false);
        }
      }
    }
    await phone.setViewportSize({ width: 390, height: 844 });
  });

  it('opens scenes and settings as sheets', async () => {
    await phone.getByRole('button', { name: 'Scenes' }).tap();
    await phone.getByRole('button', { name: 'Ragdolls' }).tap();
    expect(await ask('playground.simulation.scene.id', phone)).toBe('ragdolls');
    await phone.getByRole('button', { name: 'Settings' }).tap();
    await phone.getByLabel('Substeps').fill('7');
    expect(await ask('playground.simulation.world.substeps', phone)).toBe(7);
    await phone.touchscreen.tap(195, 120);
    // Not after so many milliseconds: on a busy machine the sheet takes longer to slide away.
    await phone.getByLabel('Substeps').waitFor({ state: 'hidden', timeout: 10_000 });
    expect(await phone.getByLabel('Substeps').isVisible()).toBe(false);
  });

  it('grabs and throws by touch, zooms by two fingers', async () => {
    await show('scene=tower', 5, phone);
    const session = await phone.context().newCDPSession(phone);
    const touch = (type: string, ...points: [number, number][]): Promise<unknown> =>
      session.send('Input.dispatchTouchEvent', {
        type: type as 'touchStart',
        touchPoints: points.map(([x, y], id) => ({ x, y, id })),
      });
    const [x, y] = await placeOf('.at(-1)', phone);
    const top = 'playground.simulation.world.rigidBodies.at(-1)';
    await touch('touchStart', [x + 6, y]);
    expect(await ask('playground.simulation.world.constraints.length', phone)).toBe(1);
    await ask('playground.setPlaying(true)', phone);
    for (let i = 1; i <= 10; i += 1) {
      await touch('touchMove', [x + 10 * i, y]);
    }
    await until(`playground.view.toPage(${top}.getPosition())[0] > ${x + 50}`, phone);
    await touch('touchEnd');
    expect(await ask('playground.simulation.world.constraints.length', phone)).toBe(0);

    // The browser neither scrolls nor zooms instead.
    expect(await ask(`getComputedStyle(playground.view.canvas).touchAction`, phone)).toBe('none');
    const before = await ask<number>('playground.view.pixel', phone);
    await touch('touchStart', [100, 200], [200, 200]);
    await touch('touchMove', [60, 200], [260, 200]);
    await touch('touchEnd');
    expect(await ask<number>('playground.view.pixel', phone)).toBeLessThan(0.7 * before);
  });

  it('has arrows for scenes that are steered', async () => {
    await show('scene=platformer', 30, phone);
    const before = await ask<number>('playground.simulation.play.player.getPosition()[0]', phone);
    await ask('playground.setPlaying(true)', phone);
    const arrow = phone.getByRole('button', { name: 'Right', exact: true });
    await arrow.dispatchEvent('pointerdown', { pointerId: 1, pointerType: 'touch' });
    await until(`playground.simulation.play.player.getPosition()[0] > ${before + 1}`, phone);
    await arrow.dispatchEvent('pointerup', { pointerId: 1, pointerType: 'touch' });
    expect(await ask('playground.simulation.controls.right', phone)).toBe(false);
    await show('scene=arch', 3, phone);
    expect(await arrow.isVisible()).toBe(false);
  });
});

it('no error went by unseen', () => {
  expect(errors).toEqual([]);
});
