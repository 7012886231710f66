import type { Physics2DDevice, RigidBody, World } from '../../src/index.js';

/** Numbers in [0, 1), the same for the same seed (mulberry32). */
export function generator(seed: number): () => number {
  let state = seed >>> 0;
  return () => {
    state = (state + 0x6d2b79f5) >>> 0;
    let t = Math.imul(state ^ (state >>> 15), state | 1);
    t ^= t + Math.imul(t ^ (t >>> 7), t | 61);
    return ((t ^ (t >>> 14)) >>> 0) / 2 ** 32;
  };
}

/** Circles and regular polygons of 0.2 to 0.6 m above a bin of 8 m. @returns them. */
export function buildMixed(phys2D: Physics2DDevice, world: World, count: number, seed: number): RigidBody[] {
  const random = generator(seed);
  for (const [x, y, width, height] of [
    [0, 0.5, 10, 1],
    [-4.5, -10, 1, 20],
    [4.5, -10, 1, 20],
  ] as const) {
    const wall = phys2D.createPolygonShape({ vertices: phys2D.createBoxVertices(width, height) });
    world.addRigidBody(phys2D.createRigidBody({ type: 'static', position: [x, y], shapes: [wall] }));
  }
  const bodies: RigidBody[] = [];
  for (let i = 0; i < count; i += 1) {
    const size = 0.2 + 0.4 * random();
    const sides = 2 + Math.floor(7 * random());
    const shape =
      sides < 3
        ? phys2D.createCircleShape({ radius: size / 2 })
        : phys2D.createPolygonShape({ vertices: phys2D.createRegularPolygonVertices(size, size, sides) });
    const body = phys2D.createRigidBody({
      shapes: [shape],
      position: [7 * random() - 3.5, -1 - 0.15 * i],
      rotation: 6 * random(),
    });
    world.addRigidBody(body);
    bodies.push(body);
  }
  return bodies;
}
