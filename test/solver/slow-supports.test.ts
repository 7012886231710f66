import { describe, expect, it } from 'vitest';
import { type Circle, type Polygon, phys2D, type RigidBody, type World } from '../../src/index.js';
import { add, addFloor, box, boxBody, disc, heavy, steps } from '../conformance/setting.js';

// What lies on something that is moved or reshaped by hand, ever so slowly, goes along: it does not fall asleep where it was.

/** From 0 to 1 and slow at both ends. */
function ease(t: number): number {
  const s = Math.min(1, Math.max(0, t));
  return s * s * (3 - 2 * s);
}

function kinematic(shape: Circle | Polygon, y: number): RigidBody {
  return phys2D.createRigidBody({ type: 'kinematic', position: [0, y], shapes: [shape] });
}

/** Lets things come to rest for 2 s, moves for `seconds` with one call before each step, and waits for 5 s. */
function carry(world: World, seconds: number, move: (eased: number) => void): void {
  steps(world, 120);
  for (let i = 1; i <= 60 * seconds; i += 1) {
    move(ease(i / (60 * seconds)));
    steps(world, 1);
  }
  steps(world, 300);
}

describe.each([5, 20, 40])('a crate on a support that sinks in %i s', (seconds) => {
  it.each<[string, (crate: RigidBody, world: World) => number]>([
    [
      'by setPosition',
      (_, world) => {
        const lift = kinematic(box(6, 1), 0.5);
        add(world, lift);
        carry(world, seconds, (eased) => lift.setPosition([0, 0.5 + eased]));
        return 1;
      },
    ],
    [
      'as its shape is scaled',
      (_, world) => {
        const block = kinematic(box(6, 1), 0.5);
        add(world, block);
        let before = 1;
        carry(world, seconds, (eased) => {
          block.shapes[0]!.scale(1, (1 - eased / 2) / before);
          before = 1 - eased / 2;
        });
        return 0.25;
      },
    ],
    [
      'as its radius shrinks',
      (_, world) => {
        const ball = kinematic(disc(2), 2);
        add(world, ball);
        carry(world, seconds, (eased) => (ball.shapes[0] as Circle).setRadius(2 - eased / 2));
        return 0.5;
      },
    ],
    [
      'as its vertices change, on a dynamic body',
      (_, world) => {
        addFloor(world);
        const ice = boxBody(1, 1, { position: [0, 0] });
        add(world, ice);
        carry(world, seconds, (eased) => {
          const half = (1 - 0.8 * eased) / 2;
          (ice.shapes[0] as Polygon).setVertices(phys2D.createBoxVertices(1, 2 * half));
        });
        return 0.8 - 0.5;
      },
    ],
  ])('%s', (_, sink) => {
    const world = heavy();
    const crate = boxBody(0.5, 0.5, { position: [0, -0.25] });
    if (_.includes('dynamic')) crate.setPosition([0, -0.75]);
    add(world, crate);
    const depth = sink(crate, world);
    expect(crate.getPosition()[1]).toBeCloseTo(depth - 0.25, 2);
    expect(crate.sleeping).toBe(true);
  });
});

// The flipper trembles, as its corner rubs on the wall: in the step in which all fell asleep it was 0.08 mm from the ball, which then was an island of its own.
it('a ball between a wall and a flipper that trembles wakes as the flipper is dropped', () => {
  for (const gap of [-0.02, -0.03, -0.05, -0.08]) {
    for (const maxForce of [20, 50, 100, 150]) {
      for (const friction of [0, 0.2, 0.4]) {
        const world = heavy({ gravity: [0, 6] });
        const material = phys2D.createMaterial({
          elasticity: 0.4,
          staticFriction: friction,
          dynamicFriction: friction,
        });
        const wall = [
          [-1, -1.5],
          [gap, -0.3],
          [gap, 0.3],
          [-1, 0.3],
        ] as const;
        const shapes = [phys2D.createPolygonShape({ vertices: wall, material })];
        add(world, phys2D.createRigidBody({ type: 'static', shapes }));
        const flipper = boxBody(1.4, 0.16, { position: [0.7, 0], bullet: true }, { material });
        add(world, flipper);
        const pair = { bodyA: phys2D.createRigidBody({ type: 'static' }), bodyB: flipper };
        world.addConstraint(phys2D.createPointConstraint({ ...pair, anchorB: [-0.7, 0], ignoreInteractions: true }));
        world.addConstraint(phys2D.createAngleConstraint({ ...pair, lowerBound: -0.5, upperBound: 0.5 }));
        const motor = phys2D.createMotorConstraint({ ...pair, rate: -20, maxForce });
        world.addConstraint(motor);
        steps(world, 30);
        const ball = phys2D.createRigidBody({ position: [0.25, -1], shapes: [disc(0.14, { material })], bullet: true });
        add(world, ball);
        steps(world, 900);
        const y = ball.getPosition()[1];
        motor.setRate(20);
        steps(world, 60);
        expect(ball.getPosition()[1], `gap ${gap}, ${maxForce} N·m, friction ${friction}`).toBeGreaterThan(y + 0.02);
      }
    }
  }
});
