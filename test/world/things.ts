import {
  type Circle,
  type Polygon,
  phys2D,
  type RigidBody,
  type RigidBodyParams,
  type World,
} from '../../src/index.js';

// Things of any size and mass, to be tried at their limits.

export const box = (width: number, height = width): Polygon =>
  phys2D.createPolygonShape({ vertices: phys2D.createBoxVertices(width, height) });
export const circle = (radius: number): Circle => phys2D.createCircleShape({ radius });

export function add(world: World, shape: Circle | Polygon, params: RigidBodyParams = {}): RigidBody {
  const body = phys2D.createRigidBody({ shapes: [shape], ...params });
  world.addRigidBody(body);
  return body;
}

/** A floor whose surface is at y = 0, for things of a size. */
export function addFloor(world: World, size = 1): RigidBody {
  return add(world, box(100 * size, size), { type: 'static', position: [0, size / 2] });
}

/** Boxes and circles by turns, one above the other with a little room. */
export function addTower(
  world: World,
  count: number,
  size = 1,
  params: (i: number) => RigidBodyParams = () => ({}),
): void {
  for (let i = 0; i < count; i += 1) {
    const position = [0.02 * size * i, -size * (0.6 + 1.1 * i)] as const;
    add(world, i % 2 === 0 ? box(size) : circle(size / 2), { position, ...params(i) });
  }
}

/** Boxes that hang on each other. */
export function addChain(world: World, count: number, params: (i: number) => RigidBodyParams = () => ({})): void {
  let last = add(world, box(1), { type: 'static', position: [0, -20] });
  for (let i = 0; i < count; i += 1) {
    const next = add(world, box(0.5), { position: [i + 1, -20], ...params(i) });
    const anchors = { anchorA: [0.5, 0], anchorB: [-0.5, 0] } as const;
    world.addConstraint(phys2D.createPointConstraint({ bodyA: last, bodyB: next, ...anchors }));
    last = next;
  }
}
