import { join } from 'node:path';
import { expect, it } from 'vitest';
import { Physics2DDebugDraw, SVGDebugDevice } from '../../src/debug/index.js';
import { phys2D } from '../../src/index.js';
import { buildGallery } from '../scenes/gallery.js';

// The pictures of the guide, each a part of the gallery before its first step. If they are meant to change:
// npx vitest run test/docs/pictures.test.ts -u, and look at them.

it.each([
  ['point', 1.2, 0, 2.8],
  ['weld', 4.3, 0.4, 2.8],
  ['distance', 7.1, 0.2, 3.7],
  ['line', 11, 0.2, 3.1],
  ['angle', 0.5, 3.6, 3],
  ['motor', 4.2, 3.6, 2.8],
  ['pulley', 7.4, 3.75, 3],
  ['custom', 10.5, 3, 3.4],
] as const)('the %s constraint looks as in the guide', async (kind, x, y, size) => {
  const world = phys2D.createWorld();
  buildGallery(phys2D, world);
  const title = `A ${kind} constraint, as Physics2DDebugDraw draws it`;
  const svg = SVGDebugDevice.create({ width: 240, height: 240, background: '#14181f', title });
  const debug = Physics2DDebugDraw.create({ graphicsDevice: svg });
  debug.setPhysics2DViewport([x, y, x + size, y + size]);
  debug.begin();
  debug.drawWorld(world);
  debug.end();
  await expect(String(svg)).toMatchFileSnapshot(join(import.meta.dirname, `../../docs/guide/pictures/${kind}.svg`));
});
