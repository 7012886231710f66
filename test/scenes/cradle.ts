import type { Physics2DDevice, RigidBody, World } from '../../src/index.js';
import { cos, sin } from '../../src/math/trig.js';
import { Builder, friction } from './play.js';

/** m. Radius of the balls, and length of what they hang on. */
const RADIUS = 0.5;
export const STRING = 4;

/** Newton's cradle: five balls, the first of them lifted. @returns them from left to right. */
export function buildCradle(phys2D: Physics2DDevice, world: World, count = 5): RigidBody[] {
  const yard = new Builder(phys2D, world);
  const pitch = 2 * RADIUS;
  yard.wall((-count / 2) * pitch - 0.3, -STRING - 0.3, (count / 2) * pitch + 0.3, -STRING, { shape: { mask: 0 } });
  return Array.from({ length: count }, (_, i) => {
    const x = (i - (count - 1) / 2) * pitch;
    const angle = i === 0 ? 0.8 : 0;
    const position: [number, number] = [x - STRING * sin(angle), -STRING + STRING * cos(angle)];
    const ball = yard.disc(0, 0, RADIUS, { position, surface: friction(0, 1), linearDrag: 0, angularDrag: 0 });
    const bodyA = phys2D.createRigidBody({ type: 'static', position: [x, -STRING] });
    const rod = { bodyA, bodyB: ball, lowerBound: STRING, upperBound: STRING };
    world.addConstraint(phys2D.createDistanceConstraint(rod));
    return ball;
  });
}
