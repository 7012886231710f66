import type { Physics2DDevice, RigidBody, Shape, Vec2, World } from '../../src/index.js';

/** Friction alike at rest and sliding, nothing else. */
export function plainMaterial(phys2D: Physics2DDevice, friction: number, density = 1) {
  return phys2D.createMaterial({ density, staticFriction: friction, dynamicFriction: friction, rollingFriction: 0 });
}

/** Without drag: nothing but contacts slows a body. */
export function add(
  phys2D: Physics2DDevice,
  world: World,
  shape: Shape,
  position: Vec2,
  more: { type?: 'static' | 'dynamic'; rotation?: number; velocity?: Vec2; angularVelocity?: number } = {},
): RigidBody {
  const body = phys2D.createRigidBody({ position, shapes: [shape], linearDrag: 0, angularDrag: 0, ...more });
  world.addRigidBody(body);
  return body;
}

/** A static box whose top is at y = 0, around `x`. */
export function addGround(
  phys2D: Physics2DDevice,
  world: World,
  friction: number,
  width = 200,
  x = 0,
  y = 0,
): RigidBody {
  const material = plainMaterial(phys2D, friction);
  const shape = phys2D.createPolygonShape({ vertices: phys2D.createBoxVertices(width, 2), material });
  return add(phys2D, world, shape, [x, y + 1], { type: 'static' });
}

/** Two static walls of this width and height, their middles at x and −x, that reach `below` metres under y = 0. */
export function addWalls(
  phys2D: Physics2DDevice,
  world: World,
  friction: number,
  { x, width, height, below }: { x: number; width: number; height: number; below: number },
): void {
  for (const middle of [-x, x]) {
    const vertices = phys2D.createBoxVertices(width, height);
    const shape = phys2D.createPolygonShape({ vertices, material: plainMaterial(phys2D, friction) });
    add(phys2D, world, shape, [middle, below - height / 2], { type: 'static' });
  }
}

export interface TowerParams {
  readonly count: number;
  /** m. Every other box is this far to the left, the others to the right. */
  readonly offset: number;
  readonly friction: number;
  /** m. From the centre of a box to that of the next: more than 1 and the boxes fall onto each other. */
  readonly spacing?: number;
  /** Of the topmost box, times that of the others. */
  readonly topDensity?: number;
  /** Of the bottom of the tower. */
  readonly at?: Vec2;
}

/** A tower of 1 m boxes on a ground. @returns the boxes, from the ground up. */
export function buildTower(phys2D: Physics2DDevice, world: World, params: TowerParams): RigidBody[] {
  const { count, offset, friction, spacing = 1, topDensity = 1, at: [x, y] = [0, 0] } = params;
  addGround(phys2D, world, friction, 200, x, y);
  return Array.from({ length: count }, (_, i) => {
    const material = plainMaterial(phys2D, friction, i === count - 1 ? topDensity : 1);
    const shape = phys2D.createPolygonShape({ vertices: phys2D.createBoxVertices(1, 1), material });
    return add(phys2D, world, shape, [x + (i % 2 === 0 ? -offset : offset), y - 0.5 - i * spacing]);
  });
}

/** A box of 20 m, 400 times as heavy as either of two 1 m boxes that it lies on. @returns the big one. */
export function buildBigOnSmall(phys2D: Physics2DDevice, world: World): RigidBody {
  addGround(phys2D, world, 0.6);
  const box = (size: number): Shape =>
    phys2D.createPolygonShape({ vertices: phys2D.createBoxVertices(size, size), material: plainMaterial(phys2D, 0.6) });
  add(phys2D, world, box(1), [-9, -0.5]);
  add(phys2D, world, box(1), [9, -0.5]);
  return add(phys2D, world, box(20), [0, -11]);
}

/** Three pyramids of ten rows whose tops are 100, 200 and 300 times as dense as the rest. @returns the tops. */
export function buildHeavyPyramids(phys2D: Physics2DDevice, world: World): RigidBody[] {
  addGround(phys2D, world, 0.6);
  return [100, 200, 300].map((density, k) => {
    let top: RigidBody | null = null;
    for (let row = 0; row < 10; row += 1) {
      for (let i = 0; i < 10 - row; i += 1) {
        const material = plainMaterial(phys2D, 0.6, row === 9 ? density : 1);
        const shape = phys2D.createPolygonShape({ vertices: phys2D.createBoxVertices(1, 1), material });
        top = add(phys2D, world, shape, [(i - (9 - row) / 2) * 1.1 + 20 * (k - 1), -0.5 - row]);
      }
    }
    return top!;
  });
}
