import { describe, expect, it } from 'vitest';
import { phys2D, type RigidBody, type Vec2, type World } from '../../src/index.js';
import { add, box, disc, energyOf, heavy, pinAt, staticBody, steps } from '../conformance/setting.js';
import { generator } from '../scenes/mixed.js';
import { dense, free, weld } from './welded.js';

// What is held by more joints than it needs, as a plate by two pins, is struck by something: nobody gains anything but what that brought.

/** Lets balls of 1 to 10 kg/m² fall on a place, and others after them. @returns the energy that they bring, J. */
function dropBalls(world: World, [x, y]: Vec2, next: () => number): number {
  let brought = 0;
  for (let i = 0; i < 2; i += 1) {
    const ball = free({
      position: [x + 0.6 * (next() - 0.5), y - 4 - 3 * i],
      velocity: [0, 5 + 15 * next()],
      shapes: [disc(0.1 + 0.2 * next(), { material: phys2D.createMaterial({ density: 1 + 9 * next() }) })],
    });
    add(world, ball);
    brought += ball.getMass() * (ball.getVelocity()[1] ** 2 / 2 + 6 * 10);
  }
  return brought;
}

/** What the bodies of so many worlds gain at most in 4 s, as a share of what the balls bring. */
function mostGained(count: number, build: (world: World, next: () => number) => Vec2): number {
  let most = 0;
  for (let seed = 1; seed <= count; seed += 1) {
    const next = generator(seed);
    const world = heavy({ gravity: [0, 10] });
    const brought = dropBalls(world, build(world, next), next);
    const before = energyOf(world);
    for (let i = 0; i < 240; i += 1) {
      steps(world, 1);
      most = Math.max(most, (energyOf(world) - before) / brought);
    }
  }
  return most;
}

/** A static body that nothing touches. */
function anchor(world: World): RigidBody {
  const body = staticBody({ shapes: [box(0.2, 0.2, { mask: 0 })] });
  add(world, body);
  return body;
}

describe('struck by balls, nobody gains energy with', () => {
  it.each(['a weld', 'two pins'])('a door on a plate that two pins hold, held itself by %s', (kind) => {
    const gained = mostGained(24, (world, next) => {
      const plate = free({ shapes: [dense(0.4, 0.4, 3)] });
      const length = 0.5 + 1.5 * next();
      const door = free({
        position: [0.25 + length / 2, 0],
        shapes: [dense(length, 0.04 + 0.1 * next(), 0.2 + next())],
      });
      const frame = anchor(world);
      add(world, plate, door);
      pinAt(world, frame, plate, [-0.2, -0.2]);
      pinAt(world, frame, plate, [0.2, -0.2]);
      if (kind === 'a weld') {
        weld(world, plate, door, [0.25, 0]);
      } else {
        pinAt(world, plate, door, [0.25, 0]);
        pinAt(world, plate, door, [0.27 + 0.08 * next(), 0]);
      }
      return [0.25 + length * (0.3 + 0.7 * next()), 0];
    });
    console.log(`doors that balls fall on gain at most ${gained.toFixed(4)} of what these bring`);
    expect(gained).toBeLessThan(0.05);
  });

  it('a four-bar on one bar of which two or three pins hold a plate', () => {
    const gained = mostGained(24, (world, next) => {
      const frame = anchor(world);
      const density = 0.5 + 2 * next();
      const bar = (from: Vec2, to: Vec2, width: number): RigidBody => {
        const [x, y] = [to[0] - from[0], to[1] - from[1]];
        const body = free({
          position: [from[0] + x / 2, from[1] + y / 2],
          rotation: Math.atan2(y, x),
          shapes: [dense(Math.hypot(x, y), width, density)],
        });
        add(world, body);
        return body;
      };
      const left: Vec2 = [-1 - 0.5 * next(), -1 - next()];
      const right: Vec2 = [1 + 0.5 * next(), -1 - next()];
      const bars = [bar([-1, 0], left, 0.1), bar(left, right, 0.1), bar(right, [1, 0], 0.1)] as const;
      pinAt(world, frame, bars[0], [-1, 0]);
      pinAt(world, bars[0], bars[1], left);
      pinAt(world, bars[1], bars[2], right);
      pinAt(world, bars[2], frame, [1, 0]);
      const share = 0.3 + 0.4 * next();
      const [x, y] = [left[0] + share * (right[0] - left[0]), left[1] + share * (right[1] - left[1])];
      const plate = bar([x - 0.3, y - 0.4], [x + 0.3, y - 0.4], 0.8);
      const pins = 2 + Math.floor(2 * next());
      for (let i = 0; i < pins; i += 1) pinAt(world, bars[1], plate, [x - 0.15 + 0.3 * next(), y]);
      return [x, y];
    });
    console.log(`four-bars with a plate that balls fall on gain at most ${gained.toFixed(4)} of what these bring`);
    expect(gained).toBeLessThan(0.05);
  });
});
