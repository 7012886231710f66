import type { Physics2DDevice, RigidBody, World } from '../../src/index.js';
import { Builder, friction } from './play.js';

/** m. Between the particles. */
const PITCH = 0.6;

export interface SoftBody {
  readonly particles: readonly RigidBody[];
  /** m². What lies between the outermost particles. */
  area(): number;
}

/** A square of discs, each on springs to its neighbours and across. (x, y) is the upper left. */
export function buildSoftBody(phys2D: Physics2DDevice, world: World, x: number, y: number, size = 5): SoftBody {
  const yard = new Builder(phys2D, world);
  const particles: RigidBody[] = [];
  for (let i = 0; i < size * size; i += 1) {
    const [column, row] = [i % size, Math.floor(i / size)];
    particles.push(yard.disc(x + PITCH * column, y + PITCH * row, 0.29, { surface: friction(0.5) }));
  }
  const tie = (a: number, b: number, length: number): void => {
    const bounds = { lowerBound: length, upperBound: length, stiff: false, frequency: 9, damping: 0.25 };
    const bodies = { bodyA: particles[a]!, bodyB: particles[b]!, ignoreInteractions: true };
    world.addConstraint(phys2D.createDistanceConstraint({ ...bodies, ...bounds }));
  };
  for (let i = 0; i < size * size; i += 1) {
    const [right, below] = [i % size < size - 1, i < size * (size - 1)];
    if (right) {
      tie(i, i + 1, PITCH);
    }
    if (below) {
      tie(i, i + size, PITCH);
    }
    if (right && below) {
      tie(i, i + size + 1, PITCH * Math.SQRT2);
      tie(i + 1, i + size, PITCH * Math.SQRT2);
    }
  }
  const along = Array.from({ length: size - 1 }, (_, i) => i);
  const last = size - 1;
  const rim = [
    ...along,
    ...along.map((i) => last + size * i),
    ...along.map((i) => size * size - 1 - i),
    ...along.map((i) => size * (last - i)),
  ];
  const area = (): number => {
    const corners = rim.map((i) => particles[i]!.getPosition());
    return corners.reduce((sum, [ax, ay], i) => {
      const [bx, by] = corners[(i + 1) % corners.length]!;
      return sum + (ax * by - bx * ay) / 2;
    }, 0);
  };
  return { particles, area };
}

/** Three of them over a stair. */
export function buildSoftBodies(phys2D: Physics2DDevice, world: World): SoftBody[] {
  const yard = new Builder(phys2D, world);
  yard.wall(-8, 0, 8, 1);
  yard.wall(-8.4, -9, -8, 1);
  yard.wall(8, -9, 8.4, 1);
  yard.wall(-8, -1.2, -2.4, 0);
  yard.disc(2.4, 0.2, 1, { type: 'static' });
  return [-6.4, -1.6, 3.4].map((x, i) => buildSoftBody(phys2D, world, x, -6 - i, 5));
}
