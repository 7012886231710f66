import type { RigidBody, Vec2 } from '../../../src/index.js';
import type { Outline } from '../../quality/claims/overlap.js';
import { generator } from '../mixed.js';
import { buildPyramid } from '../pyramid.js';
import { DT, Heap, type Parts, regular, type SpeedScene, watchSag } from './scene.js';

const STANDING = { figure: 'worst sag, mm', warmUp: 60, steps: 240, steady: true } as const;
const HEAPED = { figure: 'deepest overlap, mm', steady: false } as const;

/** Pyramids of 1 m boxes, 45 m apart, none asleep. */
export function pyramidsOf(base: number, count: number, more: Partial<SpeedScene> = {}): SpeedScene {
  const boxes = (count * base * (base + 1)) / 2;
  return {
    title: count === 1 ? `pyramid of base ${base}, ${boxes} boxes` : `${count} pyramids of base ${base}`,
    ...STANDING,
    ...more,
    start(phys2D) {
      const world = phys2D.createWorld({ gravity: [0, 10], allowSleeping: false });
      const built: RigidBody[] = [];
      for (let i = 0; i < count; i += 1) {
        built.push(...buildPyramid(phys2D, world, base, 45 * i));
      }
      return { world, quality: watchSag(built) };
    },
  };
}

/** A bucket as wide as high, whose floor is at y = 0. */
export function addBucket(heap: Heap, side: number): void {
  heap.box(side + 4, 2, [0, 1], { type: 'static' });
  heap.box(2, side, [-side / 2 - 1, -side / 2], { type: 'static' });
  heap.box(2, side, [side / 2 + 1, -side / 2], { type: 'static' });
}

/** Circles of 0.6 to 1 m that fall into a bucket, `columns` of them side by side. */
export function circlesOf(columns: number, rows: number): SpeedScene {
  const count = columns * rows;
  return {
    title: `${count.toLocaleString('en')} circles in a bucket`,
    ...HEAPED,
    warmUp: 180,
    steps: 180,
    start(phys2D) {
      const world = phys2D.createWorld({ gravity: [0, 10], allowSleeping: false });
      const heap = new Heap(phys2D, world);
      addBucket(heap, 1.25 * columns);
      const random = generator(1);
      for (let i = 0; i < count; i += 1) {
        const radius = 0.3 + 0.2 * random();
        const x = 1.2 * ((i % columns) - 0.5 * (columns - 1)) + 0.2 * (random() - 0.5);
        heap.add([{ radius }], [x, -0.6 - Math.floor(i / columns)]);
      }
      return { world, quality: () => heap.overlap() };
    },
  };
}

/** A circle or a regular polygon of 3 to 8 corners, 0.3 to 0.7 m wide. */
export function mixedOutline(random: () => number): Outline {
  const radius = 0.15 + 0.2 * random();
  const sides = 2 + Math.floor(7 * random());
  return sides < 3 ? { radius } : regular(radius, sides);
}

export const rain: SpeedScene = {
  title: '1,000 mixed shapes raining',
  ...HEAPED,
  warmUp: 120,
  steps: 300,
  start(phys2D) {
    const world = phys2D.createWorld({ gravity: [0, 10], allowSleeping: false });
    const heap = new Heap(phys2D, world);
    addBucket(heap, 20);
    const random = generator(3);
    for (let i = 0; i < 1000; i += 1) {
      const position: Vec2 = [(i % 20) - 9.5 + 0.2 * random(), -1 - 0.8 * Math.floor(i / 20)];
      heap.add([mixedOutline(random)], position, { rotation: 6 * random() });
    }
    return { world, quality: () => heap.overlap() };
  },
};

/** Every step four of 1,000 mixed shapes that rain are taken away, and four made anew. */
export const renewedRain: SpeedScene = {
  title: 'mixed rain, 4 of 1,000 shapes taken away and made anew in each step',
  ...HEAPED,
  renews: true,
  warmUp: 400,
  steps: 1200,
  start(phys2D) {
    const world = phys2D.createWorld({ gravity: [0, 10], allowSleeping: false });
    const heap = new Heap(phys2D, world);
    addBucket(heap, 20);
    const random = generator(4);
    const walls = heap.parts.splice(0);
    const oldest: Parts[] = [];
    let next = 0;
    const drop = (): void => {
      heap.add([mixedOutline(random)], [19 * random() - 9.5, -15 - 5 * random()], { rotation: 6 * random() });
      oldest.push(heap.parts.pop()!);
    };
    const act = (): void => {
      for (let i = 0; i < 4; i += 1) {
        drop();
      }
      for (; oldest.length - next > 1000; next += 1) {
        world.removeRigidBody(oldest[next]!.body);
      }
      world.step(DT);
    };
    return { world, act, quality: () => heap.overlap([...walls, ...oldest.slice(next)]) };
  },
};

export const pusher: SpeedScene = {
  title: '8,000 pentagons and a pusher',
  ...HEAPED,
  warmUp: 60,
  steps: 90,
  start(phys2D) {
    const world = phys2D.createWorld({ gravity: [0, 10], allowSleeping: false });
    const heap = new Heap(phys2D, world);
    addBucket(heap, 100);
    const random = generator(8);
    for (let i = 0; i < 8000; i += 1) {
      const x = (i % 130) * 0.7 - 41 + 0.05 * random();
      heap.add([regular(0.32, 5)], [x, -0.4 - 0.7 * Math.floor(i / 130)], { rotation: 6 * random() });
    }
    const wall = heap.box(2, 60, [-47, -30.5], { type: 'kinematic' });
    const before = (index: number): void => {
      if (index % 60 === 0) {
        wall.setVelocity([index % 120 === 0 ? 4 : -4, 0]);
      }
    };
    return { world, before, quality: () => heap.overlap() };
  },
};
