import type { MaterialParams, Physics2DDevice, RigidBody, World } from '../../src/index.js';
import { generator } from './mixed.js';
import { Builder, friction, type Play } from './play.js';

export interface Materials extends Play {
  readonly lift: RigidBody;
  readonly pusher: RigidBody;
  /** What goes round. */
  readonly goods: readonly RigidBody[];
}

/** m. How far the lift rises, and the pusher reaches. */
const RISE = 6;
const REACH = 2.2;
/** s. When the lift begins to rise, is up, the pusher is out, is back, the lift is down again. */
const TIMES = [2, 4.4, 5.4, 6.4, 8] as const;

const GOODS: readonly MaterialParams[] = [
  { ...friction(1.2, 0.7), density: 1.1 },
  { ...friction(0.05), density: 0.9 },
  { ...friction(0.4, 0.2), density: 7.8 },
  { ...friction(0.6, 0.1), density: 0.6 },
  { ...friction(1, 0), density: 0.1, rollingFriction: 0.1 },
];

/** From 0 before the first time to 1 after the second. */
function ramp(time: number, from: number, to: number): number {
  return Math.min(1, Math.max(0, (time - from) / (to - from)));
}

/** Rubber, ice, steel, wood and foam go round: on a belt to a lift, pushed off above onto another belt, down a slide. */
export function buildMaterials(phys2D: Physics2DDevice, world: World): Materials {
  const yard = new Builder(phys2D, world);
  const belt = friction(1.5);
  yard.wall(-9.6, 0, 6, 0.4, { surface: belt, surfaceVelocity: [1.6, 0] });
  // The lower side of a belt runs the other way, so what is caught there is carried out.
  const deck: [number, number][] = [
    [-4, -RISE],
    [6, -RISE],
    [4.8, 0.4 - RISE],
    [-4, 0.4 - RISE],
  ];
  yard.polygon(deck, { type: 'static', surface: belt, surfaceVelocity: [-1.6, 0] });
  yard.wall(-10, -9, -9.6, 0.4);
  yard.wall(8.05, -5.9, 8.45, 0.4);
  yard.wall(8.05, -9, 8.45, -7.5);
  yard.wall(-10, -9.4, 10.8, -9);
  const slide: [number, number][] = [
    [-9.6, -2.6],
    [-9, -2.6],
    [-6.8, 0],
    [-9.6, 0],
  ];
  yard.polygon(slide, { type: 'static', surface: friction(0.1) });
  const smooth = { type: 'kinematic', surface: friction(0.15) } as const;
  const lift = yard.box(7.02, RISE / 2 + 0.1, 2, RISE + 0.2, smooth);
  const pusher = yard.box(9.3, -RISE - 0.75, 2.4, 1.4, smooth);
  const random = generator(11);
  const goods = Array.from({ length: 30 }, (_, i) => {
    const surface = GOODS[i % GOODS.length]!;
    const [x, y] = [-6 + 1.05 * (i % 11), -1 - 0.9 * Math.floor(i / 11)];
    const size = 0.45 + 0.2 * random();
    return random() < 0.4
      ? yard.disc(x, y, size / 2, { surface })
      : yard.box(x, y, size, 0.4 + 0.15 * random(), { surface });
  });
  const [rising, up, out, back, down] = TIMES;
  const beforeStep = (): void => {
    const time = (world.simulatedTime + 1 / 60) % down;
    const height = RISE * (ramp(time, rising, up) - ramp(time, back, down));
    const reach = REACH * (ramp(time, up, out) - ramp(time, out, back));
    lift.setVelocityFromPosition([7.02, RISE / 2 + 0.1 - height], 0, 1 / 60);
    pusher.setVelocityFromPosition([9.3 - reach, -RISE - 0.75], 0, 1 / 60);
  };
  return { lift, pusher, goods, beforeStep };
}
