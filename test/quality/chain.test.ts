import { describe, expect, it } from 'vitest';
import { type PointConstraint, phys2D, type RigidBody } from '../../src/index.js';
import { box, DT, disc, heavy, staticBody } from '../conformance/setting.js';
import { worstGap } from '../scenes/joint-grid.js';

const APART = { group: 2, mask: 1 };
const LINKS = 10;
const LINK_MASS = 0.2;

/** m. The widest gap of a chain that falls from the horizontal, a ball at its end: in all steps, and in those from 300 to 600. */
function gaps(massRatio: number): { all: number; late: number } {
  const world = heavy({ allowSleeping: false });
  const joints: PointConstraint[] = [];
  let last: RigidBody = staticBody();
  const append = (body: RigidBody, anchorA: [number, number], anchorB: [number, number]): void => {
    world.addRigidBody(body);
    const joint = phys2D.createPointConstraint({ bodyA: last, bodyB: body, anchorA, anchorB });
    world.addConstraint(joint);
    joints.push(joint);
    last = body;
  };
  const free = { linearDrag: 0, angularDrag: 0 };
  for (let i = 0; i < LINKS; i += 1) {
    const link = phys2D.createRigidBody({ position: [i + 0.5, 0], shapes: [box(1, 0.2, APART)], ...free });
    append(link, i === 0 ? [0, 0] : [0.5, 0], [-0.5, 0]);
  }
  const mass = massRatio * LINK_MASS;
  const ball = { mass, inertia: mass / 2, position: [LINKS + 1, 0], shapes: [disc(1, APART)], ...free };
  append(phys2D.createRigidBody(ball), [0.5, 0], [-1, 0]);
  let all = 0;
  let late = 0;
  for (let i = 0; i < 600; i += 1) {
    world.step(DT);
    const gap = worstGap(joints);
    all = Math.max(all, gap);
    late = i < 300 ? 0 : Math.max(late, gap);
  }
  return { all, late };
}

describe('chain of ten links with a ball at the end', () => {
  it('holds 100 times the mass of a link within 0.06 m', () => {
    for (const massRatio of [1, 100, 1000]) {
      const { all, late } = gaps(massRatio);
      const target = massRatio === 100 ? ' (target 0.06)' : '';
      console.log(`chain, ${massRatio}:1: widest gap ${late.toFixed(4)} m${target}, from the start ${all.toFixed(4)}`);
      expect(late).toBeLessThanOrEqual(massRatio <= 100 ? 0.06 : 0.2);
    }
  });
});

/** Breaks of a hanging chain as it is built, at rest: each joint bears `strength` times what hangs on it. */
function breaks(links: number, endMass: number, strength: number): number {
  const world = heavy();
  const masses = Array.from({ length: links }, (_, i) => (i === links - 1 ? endMass : 1));
  let last: RigidBody = staticBody();
  let broken = 0;
  for (const [i, mass] of masses.entries()) {
    const body = phys2D.createRigidBody({
      position: [0, i + 1],
      mass,
      inertia: 0.1 * mass,
      shapes: [disc(0.2, APART)],
    });
    world.addRigidBody(body);
    const weight = 10 * masses.slice(i).reduce((sum, value) => sum + value, 0);
    const joint = phys2D.createPointConstraint({
      bodyA: last,
      bodyB: body,
      anchorA: [0, 0.5],
      anchorB: [0, -0.5],
      breakUnderForce: true,
      maxForce: strength * weight,
    });
    joint.addEventListener('break', () => {
      broken += 1;
    });
    world.addConstraint(joint);
    last = body;
  }
  for (let i = 0; i < 120; i += 1) {
    world.step(DT);
  }
  return broken;
}

describe('breakable chain, built at rest', () => {
  it('holds what it is made for, and not more', () => {
    for (const [links, endMass] of [
      [1, 1],
      [2, 50],
      [10, 1],
    ] as const) {
      expect(breaks(links, endMass, 1.02), `${links} links, ${endMass}:1`).toBe(0);
      expect(breaks(links, endMass, 0.98), `${links} links, ${endMass}:1`).toBeGreaterThan(0);
    }
  });
});

/** A ball of 393 times the mass of a link swings from the horizontal, 20 s. @returns of the energy of its fall what the joints made at most. */
function made(links: number, rate: number): number {
  const world = heavy();
  const free = { linearDrag: 0, angularDrag: 0 };
  const joints: PointConstraint[] = [];
  let last: RigidBody = staticBody();
  const hang = (body: RigidBody, anchorA: [number, number], anchorB: [number, number]): void => {
    world.addRigidBody(body);
    const strength = { breakUnderForce: true, maxForce: 1e6 };
    joints.push(phys2D.createPointConstraint({ bodyA: last, bodyB: body, anchorA, anchorB, ...strength }));
    world.addConstraint(joints.at(-1)!);
    last = body;
  };
  for (let i = 0; i < links; i += 1) {
    const link = phys2D.createRigidBody({ ...free, position: [0.4 * i + 0.2, 0], shapes: [box(0.4, 0.1, APART)] });
    hang(link, i === 0 ? [0, 0] : [0.2, 0], [-0.2, 0]);
  }
  const density = phys2D.createMaterial({ density: 20 });
  const shapes = [disc(0.5, { ...APART, material: density })];
  hang(phys2D.createRigidBody({ ...free, position: [0.4 * links, 0], shapes }), [0.2, 0], [0, 0]);
  const mass = last.getMass();
  let most = 0;
  for (let i = 0; i < 20 * rate; i += 1) {
    world.step(1 / rate);
    const energy = world.rigidBodies.reduce((sum, body) => {
      const speed = Math.hypot(...body.getVelocity());
      const turning = 0.5 * body.getInertia() * body.getAngularVelocity() ** 2;
      return sum + body.getMass() * (0.5 * speed * speed - 10 * body.getPosition()[1]) + turning;
    }, 0);
    most = Math.max(most, energy / (mass * 10 * 0.4 * links));
  }
  return most;
}

describe('a heavy ball on light links that may break, though not by that', () => {
  it.each([
    [2, 30, 1],
    [4, 30, 1],
    [8, 30, 1],
    [2, 60, 0.12],
    [4, 60, 0.12],
    [8, 60, 0.5],
    [4, 120, 0.12],
    [8, 120, 0.12],
  ])('is not flung up: on %d, at %d steps a second', (links, rate, limit) => {
    const share = made(links, rate);
    console.log(
      `breakable chain of ${links} at ${rate} steps a second: makes ${(100 * share).toFixed(1)} % of the energy of the fall`,
    );
    // Before, 121,000 times the energy on two links at 30 steps a second, 43 times on four at 60.
    expect(share).toBeLessThan(limit);
  });
});
