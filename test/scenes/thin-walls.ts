import type { Physics2DDevice, RigidBody, Vec2, World } from '../../src/index.js';
import { cos, sin } from '../../src/math/trig.js';
import { Builder, friction } from './play.js';

export interface ThinWalls {
  readonly bullets: readonly RigidBody[];
  /** How many are not in their cell any more. */
  escaped(): number;
}

const [CELL, WALL, COLUMNS, ROWS] = [2.4, 0.04, 7, 4];

/** Cells with walls of 4 cm. In each a bullet of 180 m/s, which is 3 m a step. */
export function buildThinWalls(phys2D: Physics2DDevice, world: World): ThinWalls {
  const yard = new Builder(phys2D, world);
  const mirror = friction(0, 1);
  const [width, height] = [CELL * COLUMNS, CELL * ROWS];
  for (let column = 0; column <= COLUMNS; column += 1) {
    const x = column * CELL - width / 2;
    yard.wall(x - WALL / 2, -height / 2, x + WALL / 2, height / 2, { surface: mirror });
  }
  for (let row = 0; row <= ROWS; row += 1) {
    const y = row * CELL - height / 2;
    yard.wall(-width / 2, y - WALL / 2, width / 2, y + WALL / 2, { surface: mirror });
  }
  const centres = Array.from(
    { length: COLUMNS * ROWS },
    (_, i): Vec2 => [((i % COLUMNS) - (COLUMNS - 1) / 2) * CELL, (Math.floor(i / COLUMNS) - (ROWS - 1) / 2) * CELL],
  );
  const bullets = centres.map(([x, y], i) => {
    const velocity: Vec2 = [180 * cos(1 + i), 180 * sin(1 + i)];
    const params = { surface: mirror, bullet: true, velocity, linearDrag: 0 };
    return i % 2 === 0
      ? yard.disc(x, y, 0.12, params)
      : yard.box(x, y, 0.3, 0.16, { ...params, rotation: i, inertia: Infinity });
  });
  const escaped = (): number =>
    bullets.filter((body, i) => {
      const [x, y] = body.getPosition();
      return !(Math.abs(x - centres[i]![0]) < CELL / 2 && Math.abs(y - centres[i]![1]) < CELL / 2);
    }).length;
  return { bullets, escaped };
}
