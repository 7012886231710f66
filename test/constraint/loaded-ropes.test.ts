import { describe, expect, it } from 'vitest';
import { type PointConstraint, phys2D, type Vec2 } from '../../src/index.js';
import { add, box, disc, heavy, pin, staticBody, steps } from '../conformance/setting.js';
import { worstGap } from '../scenes/joint-grid.js';
import { hangOver } from '../scenes/loaded-ropes.js';

// Ropes of many links that lie over something bear what hangs on them, as ropes that touch nothing do. Where what they let sag made no momentum, because they touched something, they tore from some 200 times the
// mass of their links on, and the loads fell to the ground.

/** m. Of a drum at the origin. */
const RADIUS = 2;

/** A rope over a drum, 3 m down on either side, with loads of so many kg at its ends. */
function overDrum(surface: number, density: number, loads: readonly [number, number]) {
  const world = heavy();
  const material = phys2D.createMaterial({ staticFriction: surface, dynamicFriction: surface, rollingFriction: 0 });
  add(world, phys2D.createRigidBody({ type: 'static', shapes: [disc(RADIUS, { material })] }));
  const rope = hangOver(phys2D, world, { at: [0, 0], radius: RADIUS, leg: 3, loads, surface, density });
  return { world, ...rope, start: rope.loads.map((load) => load.getPosition()[1]) };
}

describe('a rope over a drum', () => {
  it.each([2, 5, 10, 20])('bears %d kg at either end with links of 0.04 kg', (mass) => {
    const { world, joints, loads, start } = overDrum(0.3, 2, [mass, mass]);
    let gap = 0;
    for (let i = 0; i < 300; i += 1) {
      steps(world, 1);
      gap = Math.max(gap, worstGap(joints));
    }
    const fell = loads.map((load, i) => load.getPosition()[1] - start[i]!);
    console.log(
      `${mass} kg over a drum: gaps up to ${(1000 * gap).toFixed(1)} mm, moved by ${fell.map((y) => y.toFixed(2))} m`,
    );
    // Two equal loads are in balance wherever they are; what both fall by together the rope is longer, or the drum smaller.
    expect(gap).toBeLessThan(0.03);
    expect((fell[0]! + fell[1]!) / 2).toBeLessThan(0.3);
  });

  it('holds 10 kg by 5 at the other end, by friction', () => {
    const { world, loads, start } = overDrum(1, 2, [5, 10]);
    steps(world, 300);
    expect(loads[1]!.getPosition()[1] - start[1]!).toBeLessThan(0.15);
  });

  it('runs off without friction, about as fast as the heavier load pulls it', () => {
    const { world, joints, loads } = overDrum(0, 20, [20, 24]);
    const mass = 44 + 0.4 * (joints.length - 1);
    // What goes over to one side pulls there: s″ = (4 + 2 · ρ · s) · g / m with ρ = 2 kg/m.
    const rate = Math.sqrt((2 * 2 * 10) / mass);
    const speed = (4 / (2 * 2)) * rate * Math.sinh(rate * 3);
    steps(world, 180);
    console.log(`a rope that runs off: ${loads[1]!.getVelocity()[1].toFixed(2)} m/s, by hand ${speed.toFixed(2)}`);
    expect(Math.abs(loads[1]!.getVelocity()[1] / speed - 1)).toBeLessThan(0.25);
  });
});

describe('a ball on a thin rope', () => {
  /** A rope of so many links of 0.3 m, held level at its right end, with a ball at its left one; the links weigh 0.024 kg. */
  function held(at: Vec2, count: number, mass: number) {
    const world = heavy();
    const frame = staticBody();
    const joints: PointConstraint[] = [];
    let last = frame;
    let anchor = at;
    for (let i = 0; i < count; i += 1) {
      const link = phys2D.createRigidBody({ position: [at[0] - (i + 0.5) * 0.3, at[1]], shapes: [box(0.3, 0.08)] });
      add(world, link);
      joints.push(pin(world, last, anchor, link, [0.15, 0]));
      last = link;
      anchor = [-0.15, 0];
    }
    const ball = phys2D.createRigidBody({
      position: [at[0] - count * 0.3 - 0.3, at[1]],
      mass,
      inertia: 0.045 * mass,
      shapes: [disc(0.3)],
    });
    add(world, ball);
    joints.push(pin(world, last, anchor, ball, [0.3, 0]));
    return { world, joints, ball };
  }

  // How a rope winds around a peg is a matter of chance: of 64 of these some 16 open by 0.1 to 0.15 m for a moment.
  it.each([0.5, 3])('of %d kg swings round a peg, which ropes of 20 to 28 links wind around', (mass) => {
    const gaps = [20, 22, 24, 26, 28].map((count) => {
      const { world, joints, ball } = held([0, -4], count, mass);
      add(world, phys2D.createRigidBody({ type: 'static', shapes: [disc(0.4)] }));
      let gap = 0;
      for (let i = 0; i < 1200; i += 1) {
        steps(world, 1);
        gap = Math.max(gap, worstGap(joints));
      }
      // Many still swing, but not as fast as what fell so far: at 11 m/s.
      expect(Math.hypot(...ball.getVelocity())).toBeLessThan(6);
      return gap;
    });
    gaps.sort((one, other) => one - other);
    console.log(`${mass} kg round a peg: gaps up to ${gaps.map((gap) => (1000 * gap).toFixed(1)).join(', ')} mm`);
    expect(gaps[2]!).toBeLessThan(0.1);
    expect(gaps[4]!).toBeLessThan(0.2);
  });
});
