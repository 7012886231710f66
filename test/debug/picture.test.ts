import { existsSync } from 'node:fs';
import { join } from 'node:path';
import { expect, it } from 'vitest';
import { Physics2DDebugDraw, SVGDebugDevice } from '../../src/debug/index.js';
import { phys2D } from '../../src/index.js';
import { buildGallery, GALLERY } from '../scenes/gallery.js';

// One picture, of a scene before its first step, so that it does not depend on the solver. If it is meant to change:
// npx vitest run test/debug/picture.test.ts -u, and look at it.

it('a scene with all eight constraints looks as it did', async () => {
  const world = phys2D.createWorld();
  buildGallery(phys2D, world);
  expect(new Set(world.constraints.map(({ type }) => type)).size).toBe(8);
  const title = 'One constraint of each kind, and bodies of all types, as Physics2DDebugDraw draws them';
  const svg = SVGDebugDevice.create({ width: 60 * GALLERY[0], height: 60 * GALLERY[1], background: '#14181f', title });
  const debug = Physics2DDebugDraw.create({ graphicsDevice: svg });
  debug.begin();
  debug.drawWorld(world);
  debug.end();
  const file = join(import.meta.dirname, 'gallery.svg');
  expect(existsSync(file)).toBe(true);
  await expect(String(svg)).toMatchFileSnapshot(file);
});
