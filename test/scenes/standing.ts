import type { Physics2DDevice, RigidBody, Vec2, World } from '../../src/index.js';
import { add, addGround, plainMaterial } from './stacks.js';

const STONES = 17;

/**
 * A round arch of 17 wedges on a ground, with four boxes on its crown. @returns the wedges from left to right, then the boxes from the bottom up.
 */
export function buildArch(phys2D: Physics2DDevice, world: World): RigidBody[] {
  addGround(phys2D, world, 0.6);
  const material = plainMaterial(phys2D, 0.6);
  const [inner, outer] = [8, 10];
  const at = (radius: number, k: number): Vec2 => {
    const angle = (Math.PI * k) / STONES;
    return [-radius * Math.cos(angle), -radius * Math.sin(angle)];
  };
  const bodies = Array.from({ length: STONES }, (_, k) => {
    const corners = [at(inner, k), at(outer, k), at(outer, k + 1), at(inner, k + 1)];
    const centre: Vec2 = [0, 1].map((axis) => corners.reduce((sum, corner) => sum + corner[axis]! / 4, 0)) as Vec2;
    const vertices = corners.map(([x, y]): Vec2 => [x - centre[0], y - centre[1]]);
    return add(phys2D, world, phys2D.createPolygonShape({ vertices, material }), centre);
  });
  for (let i = 0; i < 4; i += 1) {
    const shape = phys2D.createPolygonShape({ vertices: phys2D.createBoxVertices(2, 1), material });
    // On the flat top of the keystone, which is a chord of the circle.
    const top = -outer * Math.cos(Math.PI / 2 / STONES);
    bodies.push(add(phys2D, world, shape, [0, top - 0.5 - i]));
  }
  return bodies;
}

/** A house of cards 0.4 m long and 2 mm thick, of five storeys. @returns all cards. */
export function buildCardHouse(phys2D: Physics2DDevice, world: World): RigidBody[] {
  addGround(phys2D, world, 0.7);
  const material = plainMaterial(phys2D, 0.7);
  const [length, thickness, storeys] = [0.4, 0.002, 5];
  const lean = (25 * Math.PI) / 180;
  const cards: RigidBody[] = [];
  const card = (position: Vec2, rotation: number): void => {
    const shape = phys2D.createPolygonShape({ vertices: phys2D.createBoxVertices(thickness, length), material });
    cards.push(add(phys2D, world, shape, position, { rotation }));
  };
  // A leaning card touches the ground with a corner, the other card of its pair with the upper one.
  const height = length * Math.cos(lean) + thickness * Math.sin(lean);
  const width = length * Math.sin(lean) + thickness * Math.cos(lean);
  for (let storey = 0; storey < storeys; storey += 1) {
    const count = storeys - storey;
    const base = -storey * (height + thickness);
    for (let i = 0; i < count; i += 1) {
      const x = (i - (count - 1) / 2) * 2 * width;
      card([x - width / 2, base - height / 2], lean);
      card([x + width / 2, base - height / 2], -lean);
      if (i < count - 1) {
        card([x + width, base - height - thickness / 2], Math.PI / 2);
      }
    }
  }
  return cards;
}

/** A row of dominoes of which a ball tips over the first. @returns them from left to right. */
export function buildDominoes(phys2D: Physics2DDevice, world: World): RigidBody[] {
  addGround(phys2D, world, 0.6);
  const material = plainMaterial(phys2D, 0.6);
  const dominoes = Array.from({ length: 15 }, (_, i) => {
    const shape = phys2D.createPolygonShape({ vertices: phys2D.createBoxVertices(0.25, 1), material });
    return add(phys2D, world, shape, [i * 0.7, -0.5]);
  });
  const ball = phys2D.createCircleShape({ radius: 0.2, material });
  add(phys2D, world, ball, [-1, -0.9], { velocity: [3, 0] });
  return dominoes;
}
