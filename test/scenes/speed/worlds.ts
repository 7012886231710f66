import type { Physics2DDevice, RigidBody, Vec2, World } from '../../../src/index.js';
import { generator } from '../mixed.js';
import { countOutside, DT, Heap, ring, type SpeedScene } from './scene.js';

/** A closed ring of boxes as one kinematic body that turns at 0.5 rad/s, half full of boxes. */
export function drumOf(count: number): SpeedScene {
  return {
    title: `drum with ${count.toLocaleString('en')} boxes`,
    figure: 'escaped',
    warmUp: 120,
    steps: 180,
    steady: false,
    start(phys2D) {
      const world = phys2D.createWorld({ gravity: [0, 10], allowSleeping: false });
      const heap = new Heap(phys2D, world);
      const [sides, thickness, cell] = [48, 1, 0.6];
      const radius = Math.sqrt((2 * count * cell * cell) / Math.PI);
      heap.add(ring(radius, thickness, sides), [0, 0], { type: 'kinematic', angularVelocity: 0.5 });
      const random = generator(2);
      const boxes: RigidBody[] = [];
      const half = Math.floor(radius / cell);
      for (let row = half; row >= -half && boxes.length < count; row -= 1) {
        for (let column = -half; column <= half && boxes.length < count; column += 1) {
          if ((row * row + column * column) * cell * cell < (radius - cell) ** 2) {
            const [width, height] = [0.3 + 0.25 * random(), 0.3 + 0.25 * random()];
            boxes.push(heap.box(width, height, [cell * column, cell * row]));
          }
        }
      }
      const limit = (radius + thickness / 2) / Math.cos(Math.PI / sides);
      return { world, quality: () => countOutside(boxes, [0, 0], limit) };
    },
  };
}

/** 20 floors of 500 tiles of 1 m, 20 m apart, with 100 boxes on each, alone, that fall asleep. */
function buildTiles(phys2D: Physics2DDevice, world: World): void {
  const heap = new Heap(phys2D, world);
  for (let floor = 0; floor < 20; floor += 1) {
    for (let i = 0; i < 500; i += 1) {
      heap.box(1, 1, [i, 20 * floor + 0.5], { type: 'static' });
    }
    for (let i = 0; i < 100; i += 1) {
      heap.box(0.8, 0.8, [5 * i + 0.5, 20 * floor - 0.4]);
    }
  }
}

/** Ten stacks of five boxes, on the lowest floor, between those that sleep. */
function buildAwake(phys2D: Physics2DDevice, world: World): RigidBody[] {
  const heap = new Heap(phys2D, world);
  for (let stack = 0; stack < 10; stack += 1) {
    for (let level = 0; level < 5; level += 1) {
      heap.box(0.8, 0.8, [50 * stack + 3, -0.4 - 0.8 * level]);
    }
  }
  return heap.bodies;
}

/** A long time to get warm: what does little in a step is compiled late, in V8 after some 850 steps. */
const AWAKE = { figure: 'awake', warmUp: 1000, steps: 600, steady: false } as const;

function countAwake(world: World): number {
  return world.rigidBodies.filter((body) => !body.isStatic() && !body.sleeping).length;
}

export const tiles: SpeedScene = {
  title: '10,000 static tiles, 2,000 sleeping and 50 awake boxes',
  ...AWAKE,
  start(phys2D) {
    const world = phys2D.createWorld({ gravity: [0, 10] });
    buildTiles(phys2D, world);
    const awake = buildAwake(phys2D, world);
    const before = (): void => {
      for (const body of awake) {
        body.wake();
      }
    };
    return { world, before, quality: () => countAwake(world) };
  },
};

export const asleep: SpeedScene = {
  title: '10,000 static tiles, 2,000 sleeping boxes, nothing awake',
  ...AWAKE,
  start(phys2D) {
    const world = phys2D.createWorld({ gravity: [0, 10] });
    buildTiles(phys2D, world);
    return { world, quality: () => countAwake(world) };
  },
};

/** 5,000 boxes that do not touch, made, added, stepped once, and removed. */
export const addRemove: SpeedScene = {
  title: 'adding, one step, removing 5,000 boxes',
  figure: 'bodies left',
  renews: true,
  warmUp: 5,
  steps: 20,
  steady: true,
  start(phys2D) {
    const world = phys2D.createWorld({ gravity: [0, 10], allowSleeping: false });
    const make = (): RigidBody[] =>
      Array.from({ length: 5000 }, (_, i) => {
        const shapes = [phys2D.createPolygonShape({ vertices: phys2D.createBoxVertices(1, 1) })];
        return phys2D.createRigidBody({ shapes, position: [2 * (i % 100), 2 * Math.floor(i / 100)] });
      });
    // Bodies of a peer are descriptions until they are added: making these is its adapter's work, not the engine's.
    const isPeer = 'isPeer' in phys2D;
    let described: RigidBody[] = [];
    const before = (): void => {
      described = isPeer ? make() : [];
    };
    const act = (): void => {
      const bodies = isPeer ? described : make();
      for (const body of bodies) {
        world.addRigidBody(body);
      }
      world.step(DT);
      for (const body of bodies) {
        world.removeRigidBody(body);
      }
    };
    return { world, before, act, quality: () => world.rigidBodies.length };
  },
};

/** m. Side of a cell of `bullets`, and how thick its walls are: a bullet goes 3.3 m in a step. */
const CELL = 2;
const WALL = 0.05;

export const bullets: SpeedScene = {
  title: '500 bullets at 200 m/s in thin cells',
  figure: 'escaped',
  warmUp: 60,
  steps: 120,
  steady: false,
  start(phys2D) {
    const world = phys2D.createWorld({ gravity: [0, 0], allowSleeping: false });
    const heap = new Heap(phys2D, world, { friction: 0, elasticity: 1 });
    const [columns, rows] = [25, 20];
    for (let column = 0; column <= columns; column += 1) {
      heap.box(WALL, CELL * rows, [column * CELL, (rows * CELL) / 2], { type: 'static' });
    }
    for (let row = 0; row <= rows; row += 1) {
      heap.box(CELL * columns, WALL, [(columns * CELL) / 2, row * CELL], { type: 'static' });
    }
    const random = generator(5);
    const centres: Vec2[] = [];
    const shot: RigidBody[] = [];
    for (let i = 0; i < columns * rows; i += 1) {
      const centre: Vec2 = [((i % columns) + 0.5) * CELL, (Math.floor(i / columns) + 0.5) * CELL];
      const angle = 6.28 * random();
      const velocity: Vec2 = [200 * Math.cos(angle), 200 * Math.sin(angle)];
      const outline = i % 2 === 0 ? { radius: 0.1 } : { size: 0.2 };
      shot.push(heap.add([outline], centre, { bullet: true, velocity }));
      centres.push(centre);
    }
    const isOut = (body: RigidBody, i: number): boolean => {
      const [x, y] = body.getPosition();
      const [cx, cy] = centres[i]!;
      return !(Math.abs(x - cx) < CELL / 2 && Math.abs(y - cy) < CELL / 2);
    };
    return { world, quality: () => shot.filter(isOut).length };
  },
};
