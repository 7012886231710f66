import { expect, it } from 'vitest';
import { phys2D, type RigidBody } from '../../src/index.js';

// A ball strikes a rack along its axis: both halves go the same way. Ways that the sweep did not know yet were taken as met, one of two: of a ball in the middle that struck two behind it only one was.

const SPEED = 20;

function strike(radius: number, rows: number, bullet: boolean): RigidBody[] {
  const world = phys2D.createWorld({ gravity: [0, 0] });
  const material = phys2D.createMaterial({ elasticity: 0.95, staticFriction: 0, dynamicFriction: 0 });
  const ball = (x: number, y: number, velocity = 0) => {
    const shapes = [phys2D.createCircleShape({ radius, material })];
    const body = phys2D.createRigidBody({
      position: [x, y],
      velocity: [velocity, 0],
      bullet,
      linearDrag: 0,
      angularDrag: 0,
      shapes,
    });
    world.addRigidBody(body);
    return body;
  };
  const apart = 2.0004 * radius;
  const balls: RigidBody[] = [];
  for (let row = 0; row < rows; row += 1) {
    for (let i = 0; i <= row; i += 1) {
      balls.push(ball(row * apart * Math.sqrt(0.75), (i - row / 2) * apart));
    }
  }
  ball(-8 * radius, 0, SPEED);
  for (let i = 0; i < 30; i += 1) {
    world.step(1 / 60);
  }
  return balls;
}

it.each([true, false])('a rack of 15 balls breaks up evenly, bullets: %s', (bullet) => {
  let worst = 0;
  for (let radius = 0.1; radius < 0.7; radius += 0.05) {
    const velocities = strike(radius, 5, bullet).map((each) => each.getVelocity());
    for (const [x, y] of velocities) {
      worst = Math.max(worst, Math.min(...velocities.map(([vx, vy]) => Math.hypot(vx - x, vy + y))));
    }
  }
  console.log(
    `racks, bullets ${bullet}: halves differ by ${((100 * worst) / SPEED).toFixed(2)} % of the speed at most`,
  );
  expect(worst / SPEED).toBeLessThan(0.02);
});
