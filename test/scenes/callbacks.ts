import type { Arbiter, Physics2DDevice, RigidBody, Shape, World } from '../../src/index.js';
import { generator } from './mixed.js';
import { Builder, friction, type Play } from './play.js';

export interface Callbacks extends Play {
  readonly platforms: readonly RigidBody[];
  readonly travellers: readonly RigidBody[];
  /** How often the sensor has thrown something up. */
  readonly launches: () => number;
}

/** y of the platforms' upper sides. */
export const DECKS: readonly number[] = [-3, -5.6, -8.2];

/** m. How far into a platform counts as on top of it. */
const SKIN = 0.05;

/**
 * A sensor at the bottom throws up whatever reaches it, through platforms that let pass what comes from below. They are belts, so all falls off again.
 */
export function buildCallbacks(phys2D: Physics2DDevice, world: World): Callbacks {
  const yard = new Builder(phys2D, world);
  const smooth = { type: 'static', surface: friction(0.1) } as const;
  yard.wall(-8, 0.4, 8, 0.8);
  for (const side of [-1, 1]) {
    yard.wall(side * 8, -12, side * 8.4, 0.8);
    const corners: [number, number][] = [
      [side * 8, -2.2],
      [side * 8, 0.4],
      [side * 1.2, 0.4],
    ];
    yard.polygon(corners, smooth);
  }
  const platforms = DECKS.map((top, i) => {
    const [middle, speed] = i % 2 === 0 ? [1, 0.9] : [-1, -0.9];
    const surfaceVelocity: [number, number] = [speed, 0];
    const deck = yard.wall(middle - 4.5, top, middle + 4.5, top + 0.25, { surface: friction(0.8), surfaceVelocity });
    deck.shapes[0]!.addEventListener('preSolve', (arbiter, other) => letPass(top, arbiter, other));
    return deck;
  });
  let launches = 0;
  const pad = yard.wall(-1.3, -0.25, 1.3, 0.35, { shape: { sensor: true } });
  const launch = (_arbiter: Arbiter, other: Shape): void => {
    const body = other.body!;
    launches += 1;
    body.setVelocity([3 * ((launches % 5) - 2) * 0.4, -9 - 1.7 * (launches % 3)]);
    body.setAngularVelocity(launches % 2 === 0 ? 3 : -3);
  };
  pad.shapes[0]!.addEventListener('begin', launch);
  pad.shapes[0]!.addEventListener('progress', launch);
  const random = generator(4);
  const travellers = Array.from({ length: 14 }, (_, i) => {
    const [x, y] = [-6 + (12 * (i % 7)) / 6, i < 7 ? -9.4 : -6.8];
    const size = 0.3 + 0.12 * random();
    return i % 2 === 0
      ? yard.disc(x, y, size, { surface: friction(0.5, 0.2) })
      : yard.box(x, y, 2 * size, 1.6 * size, { surface: friction(0.5, 0.1) });
  });
  return { platforms, travellers, launches: () => launches };
}

/** Only what was above a step ago, and does not rise, stands on a platform. Once rejected, a pair stays so while it overlaps. */
function letPass(top: number, arbiter: Arbiter, other: Shape): void {
  const body = other.body!;
  const fallen = Math.max(0, body.getVelocity()[1]) / 60;
  if (body.getVelocity()[1] < -0.01 || body.computeWorldBounds()[3] - fallen > top + SKIN) {
    arbiter.setAcceptedState(false);
    arbiter.setPersistentState(true);
  }
}
