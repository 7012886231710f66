import type { Physics2DDevice, RigidBody, World } from '../../src/index.js';

/** m. Distance between the centres of neighbours in a row of 1 m boxes. */
const SPACING = 1.1;

/**
 * A pyramid of 1 m boxes with `base` of them in the lowest row, on a static ground whose top is at y = 0; friction 0.6, no
 * drag. Rows touch.
 *
 * @returns the boxes, row by row from the ground up.
 */
export function buildPyramid(phys2D: Physics2DDevice, world: World, base: number, x = 0): RigidBody[] {
  const material = phys2D.createMaterial({ staticFriction: 0.6, dynamicFriction: 0.6 });
  const box = (width: number, height: number) =>
    phys2D.createPolygonShape({ vertices: phys2D.createBoxVertices(width, height), material });
  const ground = phys2D.createRigidBody({ type: 'static', position: [x, 1], shapes: [box(2 * base + 20, 2)] });
  world.addRigidBody(ground);
  const boxes: RigidBody[] = [];
  for (let row = 0; row < base; row += 1) {
    for (let i = 0; i < base - row; i += 1) {
      const position = [x + (i - (base - row - 1) / 2) * SPACING, -0.5 - row];
      const body = phys2D.createRigidBody({ position, linearDrag: 0, angularDrag: 0, shapes: [box(1, 1)] });
      world.addRigidBody(body);
      boxes.push(body);
    }
  }
  return boxes;
}
