import { describe, expect, it } from 'vitest';
import { type PointConstraint, phys2D, type RigidBody, type Vec2, type World } from '../../src/index.js';
import { box, disc, staticBody, steps } from '../conformance/setting.js';
import { worstGap } from '../scenes/joint-grid.js';

// A tank: wheels driven by motors, in a track of links that lie on the ground and on the stones that it goes over.

const LINKS = 30;
/** m. Half of how long the straight parts of the track are, and how far the wheels' axes are from it. */
const HALF = 2;
const BEND = 0.58;
const AXES = -1;
const LENGTH = 4 * HALF + 2 * Math.PI * BEND;

/** A closed way around two wheels, whose axes are at −half and half: where it is after so many metres from its lower left corner on, and in what direction it goes on there. */
function along(way: number, half: number, radius: number): { position: Vec2; rotation: number } {
  const straight = 2 * half;
  const bend = Math.PI * radius;
  const around = (x: number, angle: number): { position: Vec2; rotation: number } => ({
    position: [x + radius * Math.sin(angle), radius * Math.cos(angle)],
    rotation: -angle,
  });
  if (way < straight) return { position: [way - half, radius], rotation: 0 };
  if (way < straight + bend) return around(half, (way - straight) / radius);
  if (way < 2 * straight + bend) return { position: [half - (way - straight - bend), -radius], rotation: -Math.PI };
  return around(-half, Math.PI + (way - 2 * straight - bend) / radius);
}

function buildTank(world: World): { hull: RigidBody; joints: PointConstraint[] } {
  const material = phys2D.createMaterial({ staticFriction: 1.5, dynamicFriction: 1.5 });
  const joints: PointConstraint[] = [];
  const join = (bodyA: RigidBody, anchorA: Vec2, bodyB: RigidBody, anchorB: Vec2) => {
    joints.push(phys2D.createPointConstraint({ bodyA, anchorA, bodyB, anchorB }));
    world.addConstraint(joints.at(-1)!);
  };
  const put = (shape: ReturnType<typeof box | typeof disc>, at: { position: Vec2; rotation?: number }) => {
    const body = phys2D.createRigidBody({ shapes: [shape], ...at });
    world.addRigidBody(body);
    return body;
  };
  const hull = put(box(4, 0.6, { group: 2, mask: ~6 >>> 0 }), { position: [0, -1.3] });
  for (const x of [-2, -0.7, 0.7, 2]) {
    const wheel = put(disc(0.5, { material, group: 2 }), { position: [x, AXES] });
    join(hull, [x, 0.3], wheel, [0, 0]);
    world.addConstraint(phys2D.createMotorConstraint({ bodyA: hull, bodyB: wheel, rate: 8, maxForce: 60 }));
  }
  const pitch = LENGTH / LINKS;
  const links = Array.from({ length: LINKS }, (_, i) => {
    const { position, rotation } = along((i + 0.5) * pitch, HALF, BEND);
    const place = { position: [position[0], AXES + position[1]] as Vec2, rotation };
    return put(box(0.95 * pitch, 0.12, { material, group: 4, mask: ~4 >>> 0 }), place);
  });
  for (const [i, link] of links.entries()) {
    join(link, [pitch / 2, 0], links[(i + 1) % LINKS]!, [-pitch / 2, 0]);
  }
  return { hull, joints };
}

describe('a tank on its tracks', () => {
  function buildGround(world: World): void {
    world.addRigidBody(staticBody({ shapes: [box(400, 2)], position: [0, 1] }));
  }

  // A link that is pinched between a wheel and the corner of a stone is torn from the next one, for a step or two.
  it('goes over stones, wherever they lie, and its track stays together', () => {
    const gaps: number[] = [];
    for (const shift of [0, 0.2, 0.4, 0.6, 0.8]) {
      const world = phys2D.createWorld();
      buildGround(world);
      for (let i = 0; i < 20; i += 1) {
        const place = { position: [6 + shift + 2.2 * i, -0.05] as Vec2, rotation: 0.3 * ((i % 3) - 1) };
        world.addRigidBody(staticBody({ shapes: [box(0.6, 0.3)], ...place }));
      }
      const { hull, joints } = buildTank(world);
      steps(world, 30);
      for (let i = 0; i < 900; i += 1) {
        steps(world, 1);
        gaps.push(worstGap(joints));
      }
      expect(hull.getPosition()[0]).toBeGreaterThan(55);
      expect(Math.abs(hull.getRotation())).toBeLessThan(0.3);
    }
    const mean = gaps.reduce((sum, gap) => sum + gap, 0) / gaps.length;
    const open = gaps.filter((gap) => gap > 0.015).length;
    const most = Math.max(...gaps);
    console.log(
      `tracks over stones: worst gap of a step ${(1000 * mean).toFixed(2)} mm in the mean, ${(1000 * most).toFixed(0)} mm at most, above 15 mm in ${open} steps of ${gaps.length}`,
    );
    expect(mean).toBeLessThan(0.006);
    // By chance: in runs with other places of the stones 0.04 to 0.12 m.
    expect(most).toBeLessThan(0.2);
    expect(open).toBeLessThan(24);
  });

  it.each([60, 240, 480])('is as fast at %d steps a second', (rate) => {
    const world = phys2D.createWorld();
    buildGround(world);
    const { hull, joints } = buildTank(world);
    let worst = 0;
    for (let i = 0; i < 5 * rate; i += 1) {
      world.step(1 / rate);
      worst = Math.max(worst, worstGap(joints));
    }
    const [x] = hull.getPosition();
    console.log(
      `tank at ${rate} steps a second: ${x.toFixed(1)} m in 5 s, gaps of at most ${(1000 * worst).toFixed(1)} mm`,
    );
    expect(x).toBeGreaterThan(17);
    expect(x).toBeLessThan(24);
    expect(worst).toBeLessThan(0.015);
  });
});

describe('a belt around two wheels', () => {
  const COUNT = 24;
  const BEND_OF_BELT = 0.543;
  const PITCH = (4 + 2 * Math.PI * BEND_OF_BELT) / COUNT;

  it.each([60, 120, 240])('that stands is told so, at %d steps a second', (rate) => {
    const world = phys2D.createWorld();
    const material = phys2D.createMaterial({ density: 20, staticFriction: 1.5, dynamicFriction: 1.3 });
    const anchor = staticBody({});
    const [wheel] = [-1, 1].map((x) => {
      const body = phys2D.createRigidBody({ position: [x, 0], shapes: [disc(0.5, { material })] });
      world.addRigidBody(body);
      world.addConstraint(phys2D.createPointConstraint({ bodyA: anchor, bodyB: body, anchorA: [x, 0] }));
      return body;
    });
    const motor = phys2D.createMotorConstraint({ bodyA: anchor, bodyB: wheel!, rate: 6, maxForce: 800 });
    world.addConstraint(motor);
    const links = Array.from({ length: COUNT }, (_, i) => {
      const shapes = [box(0.95 * PITCH, 0.08, { material, group: 8, mask: ~8 >>> 0 })];
      const body = phys2D.createRigidBody({ shapes, ...along((i + 0.5) * PITCH, 1, BEND_OF_BELT) });
      world.addRigidBody(body);
      return body;
    });
    for (const [i, link] of links.entries()) {
      const ends = { anchorA: [PITCH / 2, 0] as Vec2, anchorB: [-PITCH / 2, 0] as Vec2 };
      world.addConstraint(phys2D.createPointConstraint({ bodyA: link, bodyB: links[(i + 1) % COUNT]!, ...ends }));
    }
    const run = (seconds: number): void => {
      for (let i = 0; i < seconds * rate; i += 1) world.step(1 / rate);
    };
    run(3);
    motor.setRate(0);
    run(20);
    let told = 0;
    let moved = 0;
    for (let i = 0; i < rate; i += 1) {
      const before = links.map((link) => link.getPosition());
      world.step(1 / rate);
      for (const [k, link] of links.entries()) {
        const [x, y] = link.getPosition();
        told = Math.max(told, Math.hypot(...link.getVelocity()));
        moved = Math.max(moved, rate * Math.hypot(x - before[k]![0], y - before[k]![1]));
      }
    }
    console.log(
      `belt that stands, at ${rate} steps a second: told of ${told.toFixed(3)} m/s, moves at ${moved.toFixed(3)} m/s`,
    );
    // Before, 1.5, 3.0 and 6.4 m/s: corrections made momentum, which the wheels took from it again.
    expect(told).toBeLessThan(0.5);
    expect(moved).toBeLessThan(0.5);
  });
});

describe('a disc on a slack rope', () => {
  // It is as fast as it is told, though it is where it was after each step: nothing takes that from it.
  it('that bounces to and fro in a slot keeps its speed', () => {
    const world = phys2D.createWorld({ gravity: [0, 0] });
    const material = phys2D.createMaterial({ elasticity: 1, staticFriction: 0, dynamicFriction: 0 });
    const walls = [0, 2.02].map((x) => staticBody({ position: [x, 0], shapes: [box(1, 4, { material })] }));
    const shapes = [disc(0.5, { material })];
    const body = phys2D.createRigidBody({ position: [1.01, 0], velocity: [20, 0], linearDrag: 0, shapes });
    for (const each of [...walls, body]) {
      world.addRigidBody(each);
    }
    const anchor = staticBody({ position: [1, -3] });
    world.addConstraint(phys2D.createDistanceConstraint({ bodyA: anchor, bodyB: body, upperBound: 50 }));
    steps(world, 60);
    expect(Math.hypot(...body.getVelocity())).toBeCloseTo(20, 6);
    for (const wall of walls) {
      world.removeRigidBody(wall);
    }
    steps(world, 30);
    expect(Math.abs(body.getPosition()[0] - 1.01)).toBeCloseTo(10, 3);
  });
});
