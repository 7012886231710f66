import { describe, expect, it } from 'vitest';
import { phys2D, type RigidBody, type World } from '../../src/index.js';
import { solveVelocityContacts } from '../../src/solver/contacts/contacts.js';
import { BODY_STRIDE, VY, WINDOW } from '../../src/solver/layout.js';
import {
  add,
  addFloor,
  arbiterOf,
  box,
  boxBody,
  DT,
  disc,
  heavy,
  near,
  plainBody,
  speed,
  steps,
  weightless,
} from '../conformance/setting.js';
import { buildMixed } from '../scenes/mixed.js';
import { buildPyramid } from '../scenes/pyramid.js';

/** Linear and angular momentum about the world's origin. */
function momentum(bodies: readonly RigidBody[]): number[] {
  const total = [0, 0, 0];
  for (const body of bodies) {
    const [x, y] = body.getPosition();
    const [vx, vy] = body.getVelocity();
    const mass = body.getMass();
    total[0]! += mass * vx;
    total[1]! += mass * vy;
    total[2]! += mass * (x * vy - y * vx) + body.getInertia() * body.getAngularVelocity();
  }
  return total;
}

describe('what a collision keeps', () => {
  it('impulses are equal and opposite: linear momentum stays to the last digits', () => {
    const world = weightless();
    const bodies = [
      boxBody(1, 1, { velocity: [3, 0.3], angularVelocity: 1, linearDrag: 0, angularDrag: 0 }),
      boxBody(1, 2, { position: [1.6, 0.4], angularVelocity: -2, linearDrag: 0, angularDrag: 0 }),
      plainBody({ position: [2.7, 0], velocity: [-0.5, 0.2] }),
    ];
    add(world, ...bodies);
    const [px, py, pw] = momentum(bodies);
    steps(world, 60);
    const after = momentum(bodies);
    near([after[0]!, after[1]!], [px!, py!], 1e-12);
    near(after[2]!, pw!, 0.05);
    expect(world.dynamicArbiters.length).toBeGreaterThan(0);
  });

  it('the arbiter reports what changed the velocity', () => {
    const world = weightless();
    const body = plainBody({ position: [0, -0.02], velocity: [0, 2] });
    const floor = addFloor(world);
    add(world, body);
    steps(world, 1);
    const [jx, jy, jw] = arbiterOf(world, body, floor)!.getImpulseForBody(body);
    near(
      [jx, jy, jw],
      [...body.getVelocity(), body.getAngularVelocity()].map((v, i) => v - (i === 1 ? 2 : 0)),
      1e-9,
    );
  });
});

describe('the impulse that an arbiter tells', () => {
  it('is that of the step, also where a bounce comes too late for what was kept of the last one', () => {
    const world = heavy({ allowSleeping: false });
    const floor = addFloor(world);
    const ball = plainBody({ shapes: [disc(0.5, { material: phys2D.createMaterial({ elasticity: 0.5 }) })] });
    add(world, ball);
    steps(world, 60);
    ball.setPosition([0, -0.005]);
    ball.setVelocity([0, 2]);
    steps(world, 1);
    const [, given] = arbiterOf(world, floor, ball)!.getImpulseForBody(ball);
    near(given, ball.getVelocity()[1] - 2 - 10 * DT, 1e-9);
  });
});

describe('infinite mass and inertia', () => {
  it('a body that cannot be pushed is not, and nothing turns into NaN', () => {
    for (const given of [{ mass: Infinity }, { inertia: Infinity }, { mass: Infinity, inertia: Infinity }]) {
      const world = heavy();
      addFloor(world);
      const odd = boxBody(1, 1, { position: [0, -0.2], ...given });
      const other = boxBody(1, 1, { position: [0.3, -1.4] });
      add(world, odd, other);
      steps(world, 200);
      for (const body of [odd, other]) {
        expect([...body.getPosition(), ...body.getVelocity(), body.getRotation()].every(Number.isFinite)).toBe(true);
      }
      expect(speed(odd)).toBeLessThan(0.05);
    }
  });
});

describe('impacts within a step', () => {
  it('surfaces that come near are stopped when they meet, and begin in that step', () => {
    const world = weightless();
    addFloor(world);
    const body = boxBody(1, 1, { position: [0, -0.01], velocity: [0, 1] });
    const events: string[] = [];
    body.shapes[0]!.addEventListener('begin', (arbiter) => {
      events.push(`begin ${world.timeStamp} ${arbiter.active}`);
    });
    body.shapes[0]!.addEventListener('progress', () => {
      events.push(`progress ${world.timeStamp}`);
    });
    add(world, body);
    steps(world, 2);
    expect(events).toEqual(['begin 1 true', 'progress 2']);
    expect(speed(body)).toBeLessThan(1e-9);
    expect(body.getPosition()[1]).toBeGreaterThan(0);
    expect(body.getPosition()[1]).toBeLessThan(0.001);
  });

  it('a preSolve handler is asked before anything is stopped', () => {
    const world = weightless();
    addFloor(world);
    const body = boxBody(1, 1, { position: [0, -0.01], velocity: [0, 1] });
    body.shapes[0]!.addEventListener('preSolve', (arbiter) => arbiter.setAcceptedState(false));
    add(world, body);
    steps(world, 60);
    near(body.getVelocity(), [0, 0.95], 0.01);
  });

  it('an elastic ball keeps its height', () => {
    const world = heavy();
    const material = phys2D.createMaterial({ elasticity: 1 });
    addFloor(world, {}, { material });
    const ball = plainBody({ position: [0, -2], shapes: [disc(0.5, { material })] });
    add(world, ball);
    const apexes: number[] = [];
    let rising = false;
    for (let i = 0; i < 1200; i += 1) {
      world.step(1 / 60);
      const up = ball.getVelocity()[1] < 0;
      if (rising && !up) {
        apexes.push(-ball.getPosition()[1]);
      }
      rising = up;
    }
    console.log(`elastic ball from 2 m: apexes ${apexes.map((y) => y.toFixed(4)).join(' ')}`);
    expect(apexes.length).toBeGreaterThan(8);
    for (const apex of apexes) {
      expect(Math.abs(apex / 2 - 1)).toBeLessThan(0.01);
    }
  });
});

/** The farthest that a body has moved, m. */
function worstMove(bodies: readonly RigidBody[], world: World, count: number): number {
  const before = bodies.map((body) => body.getPosition());
  steps(world, count);
  return Math.max(
    ...bodies.map((body, i) => {
      const [x, y] = body.getPosition();
      return Math.hypot(x - before[i]![0], y - before[i]![1]);
    }),
  );
}

describe('stacks', () => {
  it('a pyramid of base 20 stands without sleeping', () => {
    const world = phys2D.createWorld({ allowSleeping: false });
    const move = worstMove(buildPyramid(phys2D, world, 20), world, 1200);
    const fastest = Math.max(...world.liveDynamics.map(speed));
    console.log(
      `pyramid of base 20, 20 s: worst move ${move.toFixed(4)} m, fastest body ${fastest.toExponential(1)} m/s`,
    );
    expect(move).toBeLessThan(0.03);
    expect(fastest).toBeLessThan(1e-3);
  });

  it('a tower of ten with a top of 100 times the density stands', () => {
    const world = phys2D.createWorld({ allowSleeping: false });
    addFloor(world);
    const heavyTop = phys2D.createMaterial({ density: 100 });
    const bodies = Array.from({ length: 10 }, (_, i) =>
      boxBody(1, 1, { position: [0, -i] }, i === 9 ? { material: heavyTop } : {}),
    );
    add(world, ...bodies);
    const move = worstMove(bodies, world, 600);
    console.log(`tower of 10, top 100 times as dense, 10 s: worst move ${move.toFixed(4)} m`);
    expect(move).toBeLessThan(0.12);
  });

  it('a column of ten under a row of fifty boxes stands', () => {
    const world = phys2D.createWorld({ allowSleeping: false });
    addFloor(world);
    const bodies = Array.from({ length: 10 }, (_, i) => boxBody(1, 1, { position: [0, -i] }));
    bodies.push(boxBody(5, 0.5, { position: [0, -9.75] }));
    for (let i = 0; i < 50; i += 1) {
      bodies.push(boxBody(0.98, 1, { position: [(i % 5) - 2, -10.5 - Math.floor(i / 5)] }));
    }
    add(world, ...bodies);
    const move = worstMove(bodies, world, 900);
    console.log(`column of ten under fifty boxes, 15 s: worst move ${move.toFixed(4)} m`);
    expect(move).toBeLessThan(0.12);
  });

  it('a wide heap of equal boxes is not hard to solve, however heavy they are, but for the row on the ground', () => {
    const world = phys2D.createWorld({ allowSleeping: false, gravity: [0, 60] });
    buildPyramid(phys2D, world, 30);
    world.clock = () => 0;
    steps(world, 240);
    expect(world.profile!.hardContacts).toBeLessThanOrEqual(WINDOW);
  });

  it('of what is solved with a heavy column only that is hard', () => {
    const world = phys2D.createWorld({ allowSleeping: false });
    addFloor(world);
    const material = phys2D.createMaterial({ density: 100 });
    for (let i = 0; i < 10; i += 1) {
      add(world, boxBody(1, 1, { position: [0, -i] }, i === 9 ? { material } : {}));
    }
    for (let i = 0; i < 80; i += 1) {
      const x = 1 + 0.2 * Math.floor(i / 2);
      add(world, boxBody(0.1, 0.1, { position: [i % 2 === 0 ? x : -x, 0.45] }));
    }
    world.clock = () => 0;
    steps(world, 120);
    expect(world.profile!.contacts).toBe(90);
    expect(world.profile!.hardContacts).toBe(10);
  });

  it('a mixed pile falls asleep', () => {
    const world = phys2D.createWorld();
    buildMixed(phys2D, world, 120, 4);
    steps(world, 600);
    expect(world.liveDynamics).toHaveLength(0);
  });
});

describe('turning on', () => {
  it('a box dropped on its corner comes to rest on an edge', () => {
    const world = heavy();
    addFloor(world);
    const body = boxBody(1, 1, { position: [0, -2], rotation: 0.7 });
    add(world, body);
    steps(world, 400);
    expect(body.sleeping).toBe(true);
    const quarter = body.getRotation() / (Math.PI / 2);
    near(quarter, Math.round(quarter), 1e-3);
    near(body.getPosition()[1], 0, 0.003);
  });

  it('a wheel driven by a torque rolls without slipping', () => {
    const world = heavy();
    const floor = phys2D.createRigidBody({ type: 'static', position: [0, 1], shapes: [box(400, 1)] });
    const wheel = plainBody({ torque: 0.2 });
    add(world, floor, wheel);
    steps(world, 120);
    const [vx] = wheel.getVelocity();
    expect(vx).toBeGreaterThan(0.1);
    near(vx, 0.5 * wheel.getAngularVelocity(), 1e-3);
  });
});

describe('a sweep over contacts', () => {
  it('tells whether it changed anything, as what lies still needs no further one', () => {
    for (const shape of [box(1, 1), disc(0.5)]) {
      const world = heavy({ allowSleeping: false });
      addFloor(world);
      add(world, plainBody({ shapes: [shape] }));
      steps(world, 120);
      const { solver } = world;
      expect(solver.one.count + solver.two.count).toBe(1);
      expect(solveVelocityContacts(solver, DT / 4)).toBe(false);
      solver.velocity[BODY_STRIDE + VY]! += 1e-6;
      expect(solveVelocityContacts(solver, DT / 4)).toBe(true);
      expect(solveVelocityContacts(solver, DT / 4)).toBe(false);
    }
  });
});

describe('a step in which no body is awake', () => {
  it('still asks custom constraints that are', () => {
    const world = phys2D.createWorld({ allowSleeping: false, velocityIterations: 8 });
    const body = plainBody();
    let clamped = 0;
    const constraint = phys2D.createCustomConstraint({
      dimension: 1,
      bodies: [body],
      jacobian(data, index) {
        data[index] = 1;
      },
      velocityClamp() {
        clamped += 1;
      },
    });
    add(world, body);
    world.addConstraint(constraint);
    body.sleep();
    steps(world, 1);
    expect(world.liveDynamics).toEqual([]);
    expect(clamped).toBe(8);
  });
});
