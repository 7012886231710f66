import { describe, expect, it } from 'vitest';
import type { PointConstraint, RigidBody, Vec2, World } from '../../src/index.js';
import { add, box, disc, heavy, pin, staticBody, steps } from '../conformance/setting.js';
import { free } from './welded.js';

// Two rigid points hold two bodies as a weld does, however close together they lie.

/** A door of 1.5 m on a static frame, by two points 3 cm apart, the second of which has its bodies the other way round. */
function hang(world: World, rotation = 0): { door: RigidBody; points: [PointConstraint, PointConstraint] } {
  const frame = staticBody();
  const door = free({ position: [0.75, 0], rotation, shapes: [box(1.5, 0.08)] });
  add(world, frame, door);
  const points: [PointConstraint, PointConstraint] = [
    pin(world, frame, [0, 0], door, [-0.75, 0]),
    pin(world, door, [-0.72, 0], frame, [0.03, 0]),
  ];
  return { door, points };
}

function angleOf(door: RigidBody): number {
  return Math.atan2(Math.sin(door.getRotation()), Math.cos(door.getRotation()));
}

describe('two points between the same bodies', () => {
  it('keep them where they are, whatever strikes them', () => {
    const world = heavy();
    const { door } = hang(world);
    const ball = free({ position: [1.2, -4], velocity: [0, 15], shapes: [disc(0.25)] });
    add(world, ball);
    let fastest = 0;
    for (let i = 0; i < 240; i += 1) {
      steps(world, 1);
      fastest = Math.max(fastest, Math.hypot(...ball.getVelocity()));
    }
    expect(fastest).toBeLessThan(60);
    expect(Math.abs(angleOf(door))).toBeLessThan(0.001);
    expect(Math.abs(door.getAngularVelocity())).toBeLessThan(0.001);
  });

  it.each([0, 2, -6])('do so after %d whole turns', (turns) => {
    const world = heavy();
    const { door } = hang(world, 2 * Math.PI * turns);
    steps(world, 120);
    expect(Math.abs(door.getRotation() - 2 * Math.PI * turns)).toBeLessThan(0.001);
  });

  it('give together what the door weighs, and turn it by what that asks for', () => {
    const world = heavy({ gravity: [0, 10], allowSleeping: false });
    const { door, points } = hang(world);
    steps(world, 120);
    const [one, two] = points.map((point) => point.getImpulseForBody(door));
    const sum = one!.map((part, i) => part + two![i]!);
    expect(sum[0]).toBeCloseTo(0, 6);
    expect(sum[1]).toBeCloseTo((-10 * door.getMass()) / 60, 6);
    expect(sum[2]).toBeCloseTo(0, 6);
  });

  it('hold another angle once an anchor of either lies elsewhere', () => {
    for (const which of [0, 1] as const) {
      const world = heavy();
      const { door, points } = hang(world);
      steps(world, 30);
      const [first, second] = points;
      const anchors: [Vec2, Vec2] = [
        [-0.75, 0],
        [-0.75, 0.03],
      ];
      if (which === 0) second.setAnchorA(anchors[1]);
      else first.setAnchorB([-0.72, 0.03]);
      steps(world, 240);
      expect(Math.abs(angleOf(door) - (which === 0 ? -Math.PI / 2 : Math.PI / 2))).toBeLessThan(0.001);
    }
  });

  it('turn about the one that is left', () => {
    const world = heavy();
    const { door, points } = hang(world);
    steps(world, 60);
    world.removeConstraint(points[0]);
    steps(world, 30);
    expect(Math.abs(angleOf(door))).toBeGreaterThan(0.2);
    const [x, y] = door.transformLocalPointToWorld([-0.72, 0]);
    expect(Math.hypot(x - 0.03, y)).toBeLessThan(0.001);
  });

  it('are two points where they cannot both meet', () => {
    const world = heavy({ gravity: [0, 0] });
    const { door, points } = hang(world);
    points[1].setAnchorA([-0.65, 0]);
    steps(world, 120);
    // One asks for 0.75 m, the other for 0.68 m.
    const [x] = door.getPosition();
    expect(x).toBeGreaterThan(0.679);
    expect(x).toBeLessThan(0.751);
    expect(Math.abs(angleOf(door))).toBeLessThan(0.01);
  });

  it('go on to the bit after a snapshot, also as an anchor is moved', () => {
    const world = heavy();
    const { door, points } = hang(world);
    add(world, free({ position: [1, -2], velocity: [0, 10], shapes: [disc(0.2)] }));
    steps(world, 20);
    const states: ArrayBuffer[] = [world.snapshot()];
    const hashes: (string | number | bigint)[] = [];
    const run = () => {
      steps(world, 20);
      points[1].setAnchorA([-0.75, 0.03]);
      steps(world, 10);
      hashes.push(world.hash());
      steps(world, 60);
      hashes.push(world.hash());
    };
    run();
    world.restore(states[0]!);
    run();
    expect(hashes.slice(2)).toEqual(hashes.slice(0, 2));
    expect(Number.isFinite(door.getRotation())).toBe(true);
  });
});
