import { describe, expect, it } from 'vitest';
import { phys2D, type RigidBody, type RigidBodyParams, type World } from '../../src/index.js';
import { box, disc, staticBody, weightless } from '../conformance/setting.js';

// A flipper on a hinge, driven by a motor, that strikes a ball at rest: both are bullets.

const SPEED = 25;
const LENGTH = 1.4;
const HALF = 0.1;
const RADIUS = 0.13;
const BALL = { x: 1, y: -0.4 };

/** rad. Where the flipper, whose hinge is the origin, first touches the ball. */
const TOUCH = Math.atan2(-BALL.y, BALL.x) - Math.asin((HALF + RADIUS) / Math.hypot(BALL.x, BALL.y));

/** A flipper that comes from somewhere, and a ball. */
function setUp(from: RigidBodyParams, y: number, maxForce: number): { world: World; ball: RigidBody } {
  const world = weightless();
  const material = phys2D.createMaterial({ density: 1, elasticity: 0.5, staticFriction: 0, dynamicFriction: 0 });
  const heavy = phys2D.createMaterial({ density: 20, elasticity: 0.5, staticFriction: 0, dynamicFriction: 0 });
  const flipper = phys2D.createRigidBody({
    ...from,
    bullet: true,
    shapes: [box(LENGTH, 2 * HALF, { material: heavy })],
  });
  const ball = phys2D.createRigidBody({
    position: [BALL.x, y],
    bullet: true,
    linearDrag: 0,
    shapes: [disc(RADIUS, { material })],
  });
  world.addRigidBody(flipper);
  world.addRigidBody(ball);
  const bodies = { bodyA: staticBody({}), bodyB: flipper };
  world.addConstraint(phys2D.createPointConstraint({ ...bodies, anchorB: [-LENGTH / 2, 0] }));
  world.addConstraint(phys2D.createMotorConstraint({ ...bodies, rate: -SPEED, maxForce }));
  return { world, ball };
}

/** The direction in which the ball goes off, and how deep it was hit. */
function strike(rate: number, isTurning: boolean): { way: number; depth: number } {
  // One that turns already begins a turn and a half before, where nothing is in its way.
  const start = isTurning ? 3 * Math.PI : 0;
  const from: RigidBodyParams = {
    position: [(LENGTH / 2) * Math.cos(start), (LENGTH / 2) * Math.sin(start)],
    rotation: start,
    angularVelocity: isTurning ? -SPEED : 0,
    velocity: isTurning ? [(SPEED * LENGTH * Math.sin(start)) / 2, (-SPEED * LENGTH * Math.cos(start)) / 2] : [0, 0],
  };
  const { world, ball } = setUp(from, BALL.y, 1e5);
  let depth = Number.NaN;
  world.addEventListener('hit', (arbiter) => {
    depth = arbiter.contacts[0]!.getPenetration();
  });
  for (let i = 0; i < rate && Number.isNaN(depth); i += 1) {
    world.step(1 / rate);
  }
  const [vx, vy] = ball.getVelocity();
  return { way: Math.atan2(-vx, -vy), depth };
}

describe('a flipper that a motor turns', () => {
  it.each([30, 60, 120, 240])('strikes at the first touch, at %d steps a second', (rate) => {
    for (const isTurning of [false, true]) {
      const { way, depth } = strike(rate, isTurning);
      const off = Math.abs(way - TOUCH);
      console.log(
        `flipper at ${rate} steps a second${isTurning ? ', turning already' : ''}: off by ${((180 * off) / Math.PI).toFixed(1)}°, ${(1000 * depth).toFixed(1)} mm deep`,
      );
      // Before, by up to 10.7°, and 100 mm: what has joints was only stopped that deep.
      expect(off).toBeLessThan(0.05);
      // What turned by far in the step is not where the contact would have it.
      if (!isTurning) expect(depth).toBeLessThan(0.005);
    }
  });

  it.each([
    [1e5, -0.4],
    [1e5, -0.6],
    [1e5, -0.8],
    [3000, -0.4],
    [3000, -0.6],
    [3000, -0.8],
  ])('strikes as hard whatever the rate, with %d N·m, a ball at %d m', (maxForce, y) => {
    const exact = speedOf(2400, maxForce, y);
    for (const rate of [30, 60, 120, 240]) {
      const speed = speedOf(rate, maxForce, y);
      console.log(
        `flipper of ${maxForce} N·m at ${rate} steps a second: ${speed.toFixed(1)} m/s, exact ${exact.toFixed(1)}`,
      );
      // Before, as if the motor had worked all the step, up to 32 % less.
      expect(Math.abs(speed / exact - 1)).toBeLessThan(0.13);
    }
  });
});

/** m/s. With which a ball leaves a flipper that begins to turn from rest. */
function speedOf(rate: number, maxForce: number, y: number): number {
  const { world, ball } = setUp({ position: [LENGTH / 2, 0] }, y, maxForce);
  for (let i = 0; i < 0.3 * rate; i += 1) {
    world.step(1 / rate);
  }
  return Math.hypot(...ball.getVelocity());
}
