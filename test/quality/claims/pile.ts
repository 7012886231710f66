import type { Physics2DDevice, RigidBody, Vec2 } from '../../../src/index.js';
import { generator } from '../../scenes/mixed.js';
import { add, addGround, addWalls, plainMaterial } from '../../scenes/stacks.js';
import { type Claim, type Figure, fastest, run, SLOP } from './claim.js';
import { deepestOverlap, type Outline } from './overlap.js';

/**
 * What is loose in a pocket may rock on a corner for minutes, as nothing damps it: in about one of six piles something still does, and in one
 * of sixteen something is deeper than it should be at that moment. So there are five of them.
 */
const SEEDS = [500, 501, 502, 503, 504];

function measurePile(phys2D: Physics2DDevice, seed: number): { readonly overlap: number; readonly speed: number } {
  const world = phys2D.createWorld({ gravity: [0, 10], allowSleeping: false });
  addGround(phys2D, world, 0.6);
  const random = generator(seed);
  addWalls(phys2D, world, 0.6, { x: 8.5, width: 1, height: 80, below: 2 });
  const bodies: RigidBody[] = [];
  const outlines: Outline[] = [];
  for (let i = 0; i < 500; i += 1) {
    const size = 0.4 + 0.8 * random();
    const sides = 2 + Math.floor(6 * random());
    const material = plainMaterial(phys2D, 0.6, 1 + 19 * random());
    const outline: Outline =
      sides < 3
        ? { radius: size / 2 }
        : { vertices: phys2D.createRegularPolygonVertices(size, size, sides).map(([x, y]) => [x!, y!]) };
    const shape =
      'radius' in outline
        ? phys2D.createCircleShape({ ...outline, material })
        : phys2D.createPolygonShape({ vertices: outline.vertices, material });
    const position: Vec2 = [14 * random() - 7, -1 - 0.14 * i];
    bodies.push(add(phys2D, world, shape, position, { rotation: 6 * random() }));
    outlines.push(outline);
  }
  run(world, 20);
  return { overlap: deepestOverlap(bodies, (_, i) => outlines[i]!), speed: fastest(bodies) };
}

export const pile: Claim = {
  scene: 'five piles of 500 mixed shapes, densities 1 to 20, after 20 s',
  measure(phys2D): Figure[] {
    const piles = SEEDS.map((seed) => measurePile(phys2D, seed));
    const overlaps = piles.map(({ overlap }) => overlap).sort((a, b) => a - b);
    const speeds = piles.map(({ speed }) => speed).sort((a, b) => a - b);
    return [
      { what: 'deepest overlap, median of the piles', value: overlaps[2]!, unit: 'm', limit: 2 * SLOP },
      { what: 'deepest overlap of all', value: overlaps[4]!, unit: 'm' },
      { what: 'fastest body, median of the piles', value: speeds[2]!, unit: 'm/s', limit: 0.01 },
      { what: 'fastest body of all', value: speeds[4]!, unit: 'm/s' },
    ];
  },
};
