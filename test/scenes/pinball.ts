import type { AngleConstraint, Physics2DDevice, RigidBody, Vec2, World } from '../../src/index.js';
import { Builder, friction, type Play } from './play.js';

export interface Pinball extends Play {
  readonly ball: RigidBody;
  readonly flippers: readonly RigidBody[];
  /** What bumpers have been hit for. */
  readonly score: () => number;
}

/** Half the width of the table, and its length, m. */
export const TABLE: Readonly<Vec2> = [5, 16];

/** rad. Where a flipper rests, how far it swings. */
const [REST, SWING] = [0.5, 1];
/** Flippers meet nothing else. */
const BALL = 2;
/** m/s. What a bumper gives back at least. */
const KICK = 9;

/** A table that is steep enough for gravity of 5 m/s². Left and right move the flippers; until then they move by themselves. */
export function buildPinball(phys2D: Physics2DDevice, world: World): Pinball {
  const yard = new Builder(phys2D, world);
  buildTable(phys2D, yard);
  const start: Vec2 = [0.9, -14];
  const ball = yard.disc(...start, 0.28, {
    surface: friction(0.1, 0.35),
    bullet: true,
    linearDrag: 0.02,
    shape: { group: BALL },
  });
  let score = 0;
  const spots: readonly Vec2[] = [
    [-2, -11.5],
    [2, -11.5],
    [0, -8.6],
    [-3.1, -7.4],
    [3.1, -7.4],
  ];
  for (const [x, y] of spots) {
    const bumper = yard.disc(x, y, 0.6, { type: 'static', surface: friction(0, 0.5) });
    bumper.shapes[0]!.addEventListener('begin', () => {
      const [bx, by] = ball.getPosition();
      const away = Math.sqrt((bx - x) ** 2 + (by - y) ** 2);
      ball.setVelocity([(KICK * (bx - x)) / away, (KICK * (by - y)) / away]);
      score += 1;
    });
  }
  const drain = yard.wall(-8, 1.5, 8, 2.5, { shape: { sensor: true } });
  drain.shapes[0]!.addEventListener('begin', () => {
    ball.setPosition(start);
    ball.setVelocity([score % 2 === 0 ? -1.5 : 1.5, 2]);
    ball.setAngularVelocity(0);
  });
  const sides = [-1, 1] as const;
  const flippers = sides.map((side) => buildFlipper(phys2D, yard, side));
  let byHand = false;
  const beforeStep: Play['beforeStep'] = (controls) => {
    byHand ||= controls.left || controls.right;
    flippers.forEach(({ limit }, i) => {
      const side = sides[i]!;
      const [x, y] = ball.getPosition();
      const isNear = side * x > 0.2 && side * x < 1.5 && y > -1.2 && y < 0.5;
      const up = byHand ? (side < 0 ? controls.left : controls.right) : isNear;
      const angle = side * (up ? SWING - REST : -REST);
      limit.setLowerBound(Math.min(angle, limit.getUpperBound()));
      limit.setUpperBound(angle);
      limit.setLowerBound(angle);
    });
  };
  return { ball, flippers: flippers.map(({ arm }) => arm), score: () => score, beforeStep };
}

/** Walls, a round top, and slopes that lead to the flippers. */
function buildTable(phys2D: Physics2DDevice, yard: Builder): void {
  const [half, length] = TABLE;
  const smooth = { type: 'static', surface: friction(0.05, 0.3) } as const;
  for (const side of [-1, 1]) {
    yard.wall(side * half, -length, side * (half + 0.5), 0.5, smooth);
    const slope: Vec2[] = [
      [side * half, -3],
      [side * 2.4, -0.35],
      [side * 2.4, 0.3],
      [side * half, 0.3],
    ];
    yard.polygon(slope, smooth);
    const corner: Vec2[] = [
      [side * half, -length],
      [side * (half - 2), -length],
      [side * half, 2 - length],
    ];
    yard.polygon(corner, smooth);
    const sling = phys2D.createBoxVertices(0.25, 1.8);
    yard.polygon(sling, { position: [side * 3.1, -4], rotation: -side * 0.35, ...smooth, surface: friction(0, 0.9) });
  }
  yard.wall(-half - 0.5, -length - 0.5, half + 0.5, -length, smooth);
}

/** An arm on a hinge, held at an angle by a spring. */
function buildFlipper(
  phys2D: Physics2DDevice,
  yard: Builder,
  side: -1 | 1,
): { arm: RigidBody; limit: AngleConstraint } {
  const frame = phys2D.createRigidBody({ type: 'static' });
  const hinge: Vec2 = [side * 2.3, -0.2];
  const tip = 1.9;
  const vertices: Vec2[] = [
    [side * 0.1, -0.2],
    [-side * tip, -0.09],
    [-side * tip, 0.09],
    [side * 0.1, 0.2],
  ];
  const surface = { ...friction(0.3, 0.2), density: 3 };
  const arm = yard.polygon(vertices, { position: hinge, rotation: -side * REST, surface, shape: { mask: BALL } });
  const bodies = { bodyA: frame, bodyB: arm };
  yard.world.addConstraint(phys2D.createPointConstraint({ ...bodies, anchorA: hinge }));
  const bounds = { lowerBound: -side * REST, upperBound: -side * REST };
  const limit = phys2D.createAngleConstraint({ ...bodies, ...bounds, stiff: false, frequency: 12, damping: 0.9 });
  yard.world.addConstraint(limit);
  return { arm, limit };
}
