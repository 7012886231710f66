import { readFileSync } from 'node:fs';
import { extname, join } from 'node:path';
import { expect, it } from 'vitest';
import { scenes } from '../../playground/scenes.js';
import { phys2D } from '../../src/index.js';
import { HANDS_OFF } from '../scenes/play.js';
import { askFirefox, type Served } from './firefox.js';

// The built playground in Firefox: every scene runs, is seen, reports no error, and goes as in Node. Where Firefox has no WebGL 2, as without a
// screen, this is the picture on a 2D canvas.

interface Told {
  readonly errors: string[];
  readonly hashes: Record<string, string>;
  /** Pixels that are not as the paper. */
  readonly inked: Record<string, number>;
}

const FOLDER = join(import.meta.dirname, '../../dist/playground');
const STEPS = 300;
/** … of which so many are made in Node as well. */
const COMPARED = 100;
const TYPES: Readonly<Record<string, string>> = { '.html': 'text/html', '.css': 'text/css', '.js': 'text/javascript' };

/** Runs in the page: before everything else. */
const WATCH = `
  const errors = [];
  addEventListener('error', (event) => errors.push(String(event.message)));
  addEventListener('unhandledrejection', (event) => errors.push(String(event.reason)));
  const { error } = console;
  console.error = (...args) => { errors.push(args.join(' ')); error.apply(console, args); };`;

/** Runs in the page: when it is there. */
const DRIVE = `
  addEventListener('load', async () => {
    const hashes = {};
    const inked = {};
    const frame = () => new Promise((resolve) => requestAnimationFrame(resolve));
    for (const button of globalThis.playground ? document.querySelectorAll('#scenes button') : []) {
      button.click();
      await frame();
      const { simulation, view, settings } = playground;
      simulation.playing = false;
      simulation.restart();
      for (let i = 1; i <= ${STEPS}; i += 1) {
        simulation.step();
        if (i === ${COMPARED}) {
          hashes[simulation.scene.id] = simulation.hash();
        }
        if (i % 60 === 0) {
          await frame();
        }
      }
      view.draw(simulation, settings.draw);
      const copy = document.createElement('canvas');
      copy.width = view.canvas.width;
      copy.height = view.canvas.height;
      const context = copy.getContext('2d');
      context.drawImage(view.canvas, 0, 0);
      const { data } = context.getImageData(0, 0, copy.width, copy.height);
      inked[simulation.scene.id] = data.filter((value, i) => i % 4 === 1 && Math.abs(value - data[1]) > 12).length;
    }
    fetch('told', { method: 'POST', body: JSON.stringify({ errors, hashes, inked }) });
  });`;

function serve(url: string): Served | null {
  const name = url === '/' ? 'index.html' : url.slice(1);
  const type = TYPES[extname(name)];
  if (!['index.html', 'style.css', 'main.js'].includes(name) || type === undefined) {
    return null;
  }
  const file = readFileSync(join(FOLDER, name));
  const isPage = name === 'index.html';
  return { type, body: isPage ? String(file).replace('<head>', `<head><script>${WATCH}${DRIVE}</script>`) : file };
}

it('every scene runs in Firefox, and goes as in Node', { timeout: 240_000 }, async () => {
  const { errors, hashes, inked } = await askFirefox<Told>(serve);
  expect(errors).toEqual([]);
  expect(Object.keys(hashes)).toEqual(scenes.map(({ id }) => id));
  for (const { id } of scenes) {
    expect(inked[id], id).toBeGreaterThan(500);
  }
  const other = scenes.filter(({ id, gravity, build }) => {
    const world = phys2D.createWorld({ gravity: gravity ?? [0, 10] });
    const play = build(phys2D, world);
    for (let i = 0; i < COMPARED; i += 1) {
      play.beforeStep?.(HANDS_OFF);
      world.step(1 / 60);
    }
    return world.hash() !== hashes[id];
  });
  expect(other.map(({ id }) => id)).toEqual([]);
});
