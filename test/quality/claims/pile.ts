import type { RigidBody, Vec2 } from '../../../src/index.js';
import { generator } from '../../scenes/mixed.js';
import { add, addGround, plainMaterial } from '../../scenes/stacks.js';
import { type Claim, type Figure, fastest, run, SLOP } from './claim.js';
import { deepestOverlap, type Outline } from './overlap.js';

export const pile: Claim = {
  scene: 'pile of 500 mixed shapes, densities 1 to 20, after 20 s',
  measure(phys2D): Figure[] {
    const world = phys2D.createWorld({ gravity: [0, 10], allowSleeping: false });
    addGround(phys2D, world, 0.6);
    const random = generator(500);
    for (const x of [-8.5, 8.5]) {
      const vertices = phys2D.createBoxVertices(1, 80);
      const wall = phys2D.createPolygonShape({ vertices, material: plainMaterial(phys2D, 0.6) });
      add(phys2D, world, wall, [x, -38], { type: 'static' });
    }
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
    const overlap = deepestOverlap(bodies, (_, i) => outlines[i]!);
    return [
      { what: 'deepest overlap', value: overlap, unit: 'm', limit: 2 * SLOP },
      { what: 'fastest body', value: fastest(bodies), unit: 'm/s', limit: 0.01 },
    ];
  },
};
