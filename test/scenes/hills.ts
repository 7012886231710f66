import type { Physics2DDevice, RigidBody, Vec2, World } from '../../src/index.js';
import { cos } from '../../src/math/trig.js';
import { Builder, friction, type Play } from './play.js';
import { buildVehicle } from './vehicle.js';

export interface Hills extends Play {
  readonly chassis: RigidBody;
}

/** From, to, height: m. */
const HILLS: readonly (readonly [number, number, number])[] = [
  [8, 20, 1.4],
  [22, 30, 0.7],
  [31, 45, 2],
];

/** The car with springs, on its bumpy ground with hills. It drives to and fro, unless told otherwise. */
export function buildHills(phys2D: Physics2DDevice, world: World): Hills {
  const { chassis, motor } = buildVehicle(phys2D, world);
  const yard = new Builder(phys2D, world);
  for (const hill of HILLS) {
    addHill(yard, hill);
  }
  yard.wall(-7, -10, -6, 3);
  yard.wall(54, -20, 55, 10);
  const rate = motor.getRate();
  let ahead = 1;
  let turning = 1;
  const beforeStep: Play['beforeStep'] = ({ left, right, down }) => {
    const [x] = chassis.getPosition();
    ahead = x > 48 ? -1 : x < 3 ? 1 : ahead;
    // Not at once: it would rear up.
    const wanted = left ? -1 : right ? 1.6 : down ? 0 : ahead;
    turning += Math.max(-0.015, Math.min(0.015, wanted - turning));
    motor.setRate(turning * rate);
  };
  return { chassis, follow: chassis, beforeStep };
}

function addHill(yard: Builder, [from, to, height]: readonly [number, number, number]): void {
  const pieces = 16;
  const top = (i: number): Vec2 => [
    from + ((to - from) * i) / pieces,
    0.2 - (height + 0.2) * (0.5 - 0.5 * cos((2 * Math.PI * i) / pieces)),
  ];
  for (let i = 0; i < pieces; i += 1) {
    const [left, right] = [top(i), top(i + 1)];
    const corners: Vec2[] = [left, right, [right[0], 0.6], [left[0], 0.6]];
    yard.polygon(corners, { type: 'static', surface: friction(1) });
  }
}
