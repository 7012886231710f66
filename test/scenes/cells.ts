import type { Physics2DDevice, RigidBody, World } from '../../src/index.js';
import { cos, sin } from '../../src/math/trig.js';

export interface CellsParams {
  /** Cells along each side. */
  readonly side: number;
  /** m. Thickness of the walls. */
  readonly wall: number;
  readonly elasticity: number;
  readonly speed: number;
  readonly spin: number;
  readonly bullet: boolean;
}

const CELL = 2.4;

/** A square of cells with thin walls, without friction and drag; in each a box of 0.3 × 0.16 m flies and turns. @returns how many have left their cell. */
export function buildCells(phys2D: Physics2DDevice, world: World, params: CellsParams): () => number {
  const { side, wall, elasticity, speed, spin, bullet } = params;
  const material = phys2D.createMaterial({ elasticity, staticFriction: 0, dynamicFriction: 0 });
  const addWall = (minX: number, minY: number, maxX: number, maxY: number): void => {
    const shape = phys2D.createPolygonShape({
      vertices: phys2D.createRectangleVertices(minX, minY, maxX, maxY),
      material,
    });
    world.addRigidBody(phys2D.createRigidBody({ type: 'static', shapes: [shape] }));
  };
  for (let i = 0; i <= side; i += 1) {
    addWall(i * CELL - wall / 2, 0, i * CELL + wall / 2, side * CELL);
    addWall(0, i * CELL - wall / 2, side * CELL, i * CELL + wall / 2);
  }
  const bodies: RigidBody[] = [];
  for (let i = 0; i < side * side; i += 1) {
    const shape = phys2D.createPolygonShape({ vertices: phys2D.createBoxVertices(0.3, 0.16), material });
    const body = phys2D.createRigidBody({
      bullet,
      position: [((i % side) + 0.5) * CELL, (Math.floor(i / side) + 0.5) * CELL],
      rotation: i,
      velocity: [speed * cos(1 + 1.7 * i), speed * sin(1 + 1.7 * i)],
      angularVelocity: i % 2 === 0 ? -spin : spin,
      linearDrag: 0,
      angularDrag: 0,
      shapes: [shape],
    });
    world.addRigidBody(body);
    bodies.push(body);
  }
  return () =>
    bodies.filter((body, i) => {
      const [x, y] = body.getPosition();
      return Math.floor(x / CELL) !== i % side || Math.floor(y / CELL) !== Math.floor(i / side);
    }).length;
}
