import type { RigidBody, Vec2 } from '../../../src/index.js';
import { generator } from '../../scenes/mixed.js';
import { add, addGround, plainMaterial } from '../../scenes/stacks.js';
import { type Claim, type Figure, fastest, run, SLOP } from './claim.js';
import { deepestOverlap, type Outline } from './overlap.js';

/** m. What is deeper than the slop by less than a micrometre is not pushed any more. */
const LEFT = SLOP + 1e-6;

export const overlappingPyramid: Claim = {
  scene: 'pyramid of four rows created 25 % overlapped',
  measure(phys2D): Figure[] {
    const world = phys2D.createWorld({ gravity: [0, 10], allowSleeping: false });
    addGround(phys2D, world, 0.6);
    const boxes: RigidBody[] = [];
    for (let row = 0; row < 4; row += 1) {
      for (let i = 0; i < 4 - row; i += 1) {
        const vertices = phys2D.createBoxVertices(1, 1);
        const shape = phys2D.createPolygonShape({ vertices, material: plainMaterial(phys2D, 0.6) });
        boxes.push(add(phys2D, world, shape, [(i - (3 - row) / 2) * 0.75, -0.25 - 0.75 * row]));
      }
    }
    let peak = 0;
    run(world, 2, () => {
      peak = Math.max(peak, fastest(boxes));
    });
    return [
      { what: 'fastest box ever', value: peak, unit: 'm/s', limit: 0.1 },
      { what: 'overlap after 2 s', value: deepestOverlap(boxes, () => ({ size: 1 })), unit: 'm', limit: LEFT },
    ];
  },
};

export const confinedDiscs: Claim = {
  scene: '625 overlapping discs confined by walls, no gravity',
  measure(phys2D): Figure[] {
    const world = phys2D.createWorld({ gravity: [0, 0], allowSleeping: false });
    const material = plainMaterial(phys2D, 0.6);
    const wall = (width: number, height: number, position: Vec2): void => {
      const shape = phys2D.createPolygonShape({ vertices: phys2D.createBoxVertices(width, height), material });
      add(phys2D, world, shape, position, { type: 'static' });
    };
    // 25 × 25 discs of 1 m in a box of 26 m, created 0.75 m apart.
    wall(30, 2, [0, -14]);
    wall(30, 2, [0, 14]);
    wall(2, 30, [-14, 0]);
    wall(2, 30, [14, 0]);
    const discs: RigidBody[] = [];
    for (let row = 0; row < 25; row += 1) {
      for (let i = 0; i < 25; i += 1) {
        const shape = phys2D.createCircleShape({ radius: 0.5, material });
        discs.push(add(phys2D, world, shape, [(i - 12) * 0.75, (row - 12) * 0.75]));
      }
    }
    let peak = 0;
    run(world, 2, () => {
      peak = Math.max(peak, fastest(discs));
    });
    const overlap = deepestOverlap(discs, () => ({ radius: 0.5 }), false);
    return [
      { what: 'fastest disc ever', value: peak, unit: 'm/s', limit: 1 },
      { what: 'overlap after 2 s', value: overlap, unit: 'm', limit: LEFT },
    ];
  },
};

export const ballStack: Claim = {
  scene: 'three balls on each other, the topmost 100 times as heavy and taken away at step 120',
  measure(phys2D): Figure[] {
    const world = phys2D.createWorld({ gravity: [0, 10], allowSleeping: false });
    addGround(phys2D, world, 0.6);
    const balls = [1, 1, 100].map((density, i) => {
      const shape = phys2D.createCircleShape({ radius: 0.5, material: plainMaterial(phys2D, 0.6, density) });
      return add(phys2D, world, shape, [0, -0.5 - i]);
    });
    const [lower, upper, heavy] = balls as [RigidBody, RigidBody, RigidBody];
    run(world, 2);
    world.removeRigidBody(heavy);
    let rise = 0;
    const height = (): number => Math.max(-0.5 - lower.getPosition()[1], -1.5 - upper.getPosition()[1]);
    run(world, 2, () => {
      rise = Math.max(rise, height());
    });
    return [{ what: 'others rise above where they were made', value: rise, unit: 'm', limit: 0.001 }];
  },
};

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
