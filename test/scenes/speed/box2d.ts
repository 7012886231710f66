import type { PointConstraint, RigidBody, Vec2 } from '../../../src/index.js';
import { worstGap } from '../joint-grid.js';
import { generator } from '../mixed.js';
import { buildRagdoll } from '../ragdoll.js';
import { addBucket, mixedOutline } from './piles.js';
import { box, countOutside, Heap, ring, type SpeedScene, watchSag } from './scene.js';

// Benchmarks of Box2D v3 (shared/benchmarks.c and samples/sample_benchmark.cpp), in what all engines have: what a motor turns there
// is kinematic here, segments and chains are boxes, capsules are boxes, and nothing starts overlapped. Its joint grid is `grid100`.

const STANDING = { figure: 'worst sag, mm', warmUp: 60, steps: 120, steady: true } as const;
const HEAPED = { figure: 'deepest overlap, mm', steady: false } as const;

/** Adds a pyramid of 1 m boxes that touch on all sides, whose base is at `y`. */
function addTightPyramid(heap: Heap, base: number, x: number, y: number): void {
  for (let row = 0; row < base; row += 1) {
    for (let i = 0; i < base - row; i += 1) {
      heap.box(1, 1, [x + i - (base - row - 1) / 2, y - 0.5 - row]);
    }
  }
}

export const largePyramid: SpeedScene = {
  title: 'Box2D: tight pyramid of base 100',
  ...STANDING,
  start(phys2D) {
    const world = phys2D.createWorld({ gravity: [0, 10], allowSleeping: false });
    new Heap(phys2D, world).box(200, 2, [0, 1], { type: 'static' });
    const heap = new Heap(phys2D, world);
    addTightPyramid(heap, 100, 0, 0);
    return { world, quality: watchSag(heap.bodies) };
  },
};

export const manyPyramids: SpeedScene = {
  title: 'Box2D: 20 × 20 tight pyramids of base 10',
  ...STANDING,
  start(phys2D) {
    const world = phys2D.createWorld({ gravity: [0, 10], allowSleeping: false });
    const ground = new Heap(phys2D, world);
    const heap = new Heap(phys2D, world);
    for (let row = 0; row < 20; row += 1) {
      const y = -12 * row;
      ground.box(240, 1, [0, y + 0.5], { type: 'static' });
      for (let i = 0; i < 20; i += 1) {
        addTightPyramid(heap, 10, 11 * (i - 9.5), y);
      }
    }
    return { world, quality: watchSag(heap.bodies) };
  },
};

export const tumbler: SpeedScene = {
  title: 'Box2D: square tumbler with 2,025 boxes',
  figure: 'escaped',
  warmUp: 120,
  steps: 180,
  steady: false,
  start(phys2D) {
    const world = phys2D.createWorld({ gravity: [0, 10], allowSleeping: false });
    const walls = [box(1, 20, 10), box(1, 20, -10), box(20, 1, 0, 10), box(20, 1, 0, -10)];
    new Heap(phys2D, world).add(walls, [0, 0], { type: 'kinematic', angularVelocity: (25 * Math.PI) / 180 });
    const heap = new Heap(phys2D, world);
    for (let i = 0; i < 45; i += 1) {
      for (let k = 0; k < 45; k += 1) {
        heap.box(0.25, 0.25, [0.4 * (k - 22), 0.4 * (i - 22)]);
      }
    }
    return { world, quality: () => countOutside(heap.bodies, [0, 0], 10.5 * Math.SQRT2) };
  },
};

export const smash: SpeedScene = {
  title: 'Box2D: 9,600 sleeping boxes hit by a large one, no gravity',
  ...HEAPED,
  warmUp: 50,
  steps: 150,
  start(phys2D) {
    const world = phys2D.createWorld({ gravity: [0, 0] });
    const heap = new Heap(phys2D, world, { density: 8 });
    heap.box(8, 8, [-20, 0], { velocity: [40, 0] });
    const light = new Heap(phys2D, world);
    for (let column = 0; column < 120; column += 1) {
      for (let row = 0; row < 80; row += 1) {
        light.box(0.4, 0.4, [30 + 0.4 * column, 0.4 * (row - 40)], { sleeping: true });
      }
    }
    return { world, quality: () => heap.overlap([...heap.parts, ...light.parts]) };
  },
};

export const spinner: SpeedScene = {
  title: 'Box2D: 3,038 mixed shapes fall on an arm that turns in a ring',
  figure: 'escaped',
  warmUp: 180,
  steps: 180,
  steady: false,
  start(phys2D) {
    const world = phys2D.createWorld({ gravity: [0, 10], allowSleeping: false });
    const [radius, thickness, cell] = [40, 1, 0.8];
    const ground = new Heap(phys2D, world, { friction: 0.1 });
    ground.add(ring(radius, thickness, 120), [0, 0], { type: 'static' });
    ground.box(1.2, 36, [0, 20], { type: 'kinematic', angularVelocity: 5 });
    const heap = new Heap(phys2D, world, { friction: 0.1, elasticity: 0.1, density: 0.25 });
    const kinds = [box(0.75, 0.4), { radius: 0.35 }, { size: 0.7 }];
    const count = 3038;
    for (let row = 1; heap.parts.length < count; row += 1) {
      const half = Math.floor(Math.sqrt((radius - 1) ** 2 - (row * cell) ** 2) / cell);
      for (let column = -half; column <= half && heap.parts.length < count; column += 1) {
        heap.add([kinds[heap.parts.length % 3]!], [cell * column, -cell * row]);
      }
    }
    return { world, quality: () => countOutside(heap.bodies, [0, 0], radius + thickness) };
  },
};

export const ragdolls: SpeedScene = {
  title: 'Box2D: rain of 300 ragdolls of ten parts',
  figure: 'widest gap, mm',
  warmUp: 120,
  steps: 180,
  steady: false,
  start(phys2D) {
    const world = phys2D.createWorld({ gravity: [0, 10], allowSleeping: false });
    addBucket(new Heap(phys2D, world), 80);
    const random = generator(6);
    const joints: PointConstraint[] = [];
    for (let i = 0; i < 300; i += 1) {
      const at: Vec2 = [2.6 * ((i % 30) - 14.5) + 0.3 * random(), -3 - 3.5 * Math.floor(i / 30)];
      joints.push(...buildRagdoll(phys2D, world, at).joints);
    }
    return { world, quality: () => 1000 * worstGap(joints) };
  },
};

/** Bodies that fall into a bucket, in rows, one in each cell. */
function fallInto(title: string, count: number, cell: number, add: (heap: Heap, at: Vec2, i: number) => RigidBody) {
  return {
    title,
    ...HEAPED,
    warmUp: 120,
    steps: 180,
    start(phys2D) {
      const world = phys2D.createWorld({ gravity: [0, 10], allowSleeping: false });
      const heap = new Heap(phys2D, world);
      addBucket(heap, 60);
      const columns = Math.floor(56 / cell);
      for (let i = 0; i < count; i += 1) {
        const x = cell * ((i % columns) - (columns - 1) / 2) + 0.1 * (Math.floor(i / columns) % 3);
        add(heap, [x, -cell * (1 + Math.floor(i / columns))], i);
      }
      return { world, quality: () => heap.overlap() };
    },
  } satisfies SpeedScene;
}

export const barrel: SpeedScene = fallInto(
  'Box2D: barrel with 2,600 circles, boxes and polygons',
  2600,
  1.6,
  (heap, at, i) =>
    i % 3 === 0 ? heap.box(1, 0.6, at) : heap.add([i % 3 === 1 ? { radius: 0.5 } : mixedOutline(generator(i))], at),
);

/** An L of two boxes around its centre of mass. */
const L = [box(1.5, 0.5, 0.2, 0.3), box(0.5, 1, -0.3, -0.45)];

export const compounds: SpeedScene = fallInto(
  'Box2D: barrel with 1,000 bodies of two shapes',
  1000,
  2.3,
  (heap, at, i) => heap.add(L, at, { rotation: i }),
);

export const largeCompounds: SpeedScene = {
  title: 'Box2D: 16 bodies of 20 × 20 boxes fall on one of 2,000',
  ...HEAPED,
  warmUp: 120,
  steps: 180,
  start(phys2D) {
    const world = phys2D.createWorld({ gravity: [0, 10], allowSleeping: false });
    const heap = new Heap(phys2D, world);
    const tiles = Array.from({ length: 2000 }, (_, i) => box(1, 1, (i % 200) - 99.5, Math.floor(i / 200) + 0.5));
    heap.add(tiles, [0, 0], { type: 'static' });
    const squares = Array.from({ length: 400 }, (_, i) => box(1, 1, (i % 20) - 9.5, Math.floor(i / 20) - 9.5));
    for (let i = 0; i < 16; i += 1) {
      heap.add(squares, [25 * ((i % 4) - 1.5) + 3 * Math.floor(i / 4), -16 - 25 * Math.floor(i / 4)]);
    }
    return { world, quality: () => heap.overlap() };
  },
};
