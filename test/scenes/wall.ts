import type { Physics2DDevice, RigidBody, WeldConstraint, World } from '../../src/index.js';
import { Builder, friction } from './play.js';

export interface BreakableWall {
  readonly bricks: readonly RigidBody[];
  readonly welds: readonly WeldConstraint[];
  readonly balls: readonly RigidBody[];
  /** How many welds broke. */
  readonly broken: () => number;
}

const [WIDTH, HEIGHT] = [1, 0.5];
/** N. What a joint of mortar bears. */
const STRENGTH = 120;

/** A wall of bricks in mortar that breaks, and balls that are shot at it one after the other. */
export function buildBreakableWall(phys2D: Physics2DDevice, world: World, rows = 12, columns = 5): BreakableWall {
  const yard = new Builder(phys2D, world);
  yard.wall(-60, 0, 24, 1);
  const welds: WeldConstraint[] = [];
  let broken = 0;
  const mortar = (bodyA: RigidBody, bodyB: RigidBody): void => {
    const [[ax, ay], [bx, by]] = [bodyA.getPosition(), bodyB.getPosition()];
    const [dx, dy] = [(bx - ax) / 2, (by - ay) / 2];
    const anchors = { anchorA: [dx, dy], anchorB: [-dx, -dy] };
    const weld = phys2D.createWeldConstraint({ bodyA, bodyB, ...anchors, breakUnderForce: true, maxForce: STRENGTH });
    weld.addEventListener('break', () => {
      broken += 1;
    });
    world.addConstraint(weld);
    welds.push(weld);
  };
  const bricks: RigidBody[][] = [];
  for (let row = 0; row < rows; row += 1) {
    const shift = row % 2 === 0 ? 0 : WIDTH / 2;
    const course = Array.from({ length: columns }, (_, i) =>
      yard.box(2 + shift + WIDTH * i, -HEIGHT * (row + 0.5), WIDTH, HEIGHT, { surface: friction(0.6) }),
    );
    course.forEach((brick, i) => {
      if (i > 0) {
        mortar(course[i - 1]!, brick);
      }
      for (const below of bricks[row - 1] ?? []) {
        if (Math.abs(below.getPosition()[0] - brick.getPosition()[0]) < WIDTH) {
          mortar(below, brick);
        }
      }
    });
    bricks.push(course);
  }
  const balls = [0, 1, 2].map((i) => {
    const surface = { ...friction(0.4), density: 12 };
    return yard.disc(-8 - 22 * i, -2.5 - 0.6 * i, 0.5, { surface, velocity: [22, -1.5 - 2 * i], linearDrag: 0 });
  });
  return { bricks: bricks.flat(), welds, balls, broken: () => broken };
}
