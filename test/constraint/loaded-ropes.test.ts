import { describe, expect, it } from 'vitest';
import { type PointConstraint, phys2D, type RigidBody, type Vec2, type World } from '../../src/index.js';
import { add, box, disc, heavy, staticBody, steps, tie } from '../conformance/setting.js';

// Ropes of many links that lie over something bear what hangs on them, as ropes that touch nothing do. Where what they let sag made no momentum, because they touched something, they tore from 200 times the
// mass of their links on, and the loads fell to the ground.

/** m. Of a drum at the origin. */
const RADIUS = 2;
const LINK = 0.2;

function pin(world: World, bodyA: RigidBody, anchorA: Vec2, bodyB: RigidBody, anchorB: Vec2): PointConstraint {
  const joint = phys2D.createPointConstraint({ bodyA, anchorA, bodyB, anchorB, ignoreInteractions: true });
  tie(world, joint);
  return joint;
}

function gapOf(joint: PointConstraint): number {
  const [ax, ay] = joint.bodyA.transformLocalPointToWorld(joint.getAnchorA());
  const [bx, by] = joint.bodyB.transformLocalPointToWorld(joint.getAnchorB());
  return Math.hypot(ax - bx, ay - by);
}

/** Where the middle of a rope over the drum is, so far along it from its top, and how it is turned. */
function along(way: number): { position: Vec2; rotation: number } {
  const radius = RADIUS + 0.06;
  const quarter = (Math.PI / 2) * radius;
  if (Math.abs(way) > quarter) {
    const side = Math.sign(way);
    return { position: [side * radius, Math.abs(way) - quarter], rotation: (side * Math.PI) / 2 };
  }
  const angle = way / radius;
  return { position: [radius * Math.sin(angle), -radius * Math.cos(angle)], rotation: angle };
}

/** A rope over a drum, 3 m down on either side, with loads of so many kg at its ends. */
function overDrum(friction: number, density: number, kilograms: readonly [number, number]) {
  const world = heavy();
  const surface = { staticFriction: friction, dynamicFriction: friction, rollingFriction: 0 };
  const material = phys2D.createMaterial({ density, ...surface });
  add(world, phys2D.createRigidBody({ type: 'static', shapes: [disc(RADIUS, { material })] }));
  const half = Math.round(((Math.PI / 2) * (RADIUS + 0.06) + 3) / LINK);
  const links: RigidBody[] = [];
  const joints: PointConstraint[] = [];
  for (let i = 0; i < 2 * half; i += 1) {
    const link = phys2D.createRigidBody({ ...along((i - half + 0.5) * LINK), shapes: [box(LINK, 0.1, { material })] });
    add(world, link);
    if (i > 0) joints.push(pin(world, links[i - 1]!, [LINK / 2, 0], link, [-LINK / 2, 0]));
    links.push(link);
  }
  const loads = kilograms.map((mass, i) => {
    const link = links.at(-i)!;
    const [x, y] = link.getPosition();
    const load = phys2D.createRigidBody({ position: [x, y + 0.6], mass, inertia: mass / 10 });
    add(world, load);
    joints.push(pin(world, link, [(i - 0.5) * LINK, 0], load, [0, -0.5]));
    return load;
  });
  return { world, joints, loads, start: loads.map((load) => load.getPosition()[1]) };
}

describe('a rope over a drum', () => {
  it.each([2, 5, 10, 20])('bears %d kg at either end with links of 0.04 kg', (mass) => {
    const { world, joints, loads, start } = overDrum(0.3, 2, [mass, mass]);
    let gap = 0;
    for (let i = 0; i < 300; i += 1) {
      steps(world, 1);
      gap = Math.max(gap, ...joints.map(gapOf));
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

  it('runs off without friction, as fast as the heavier load pulls it', () => {
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

  it.each([0.5, 3])('of %d kg swings round a peg, which the rope winds around, and comes to rest', (mass) => {
    const { world, joints, ball } = held([0, -4], 24, mass);
    add(world, phys2D.createRigidBody({ type: 'static', shapes: [disc(0.4)] }));
    let gap = 0;
    for (let i = 0; i < 1200; i += 1) {
      steps(world, 1);
      gap = Math.max(gap, ...joints.map(gapOf));
    }
    console.log(`${mass} kg round a peg: gaps up to ${(1000 * gap).toFixed(1)} mm`);
    expect(gap).toBeLessThan(0.1);
    expect(Math.hypot(...ball.getVelocity())).toBeLessThan(0.1);
  });
});
