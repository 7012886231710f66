import { describe, expect, it, vi } from 'vitest';
import { phys2D, type RigidBody, type World } from '../../src/index.js';
import { add, addFloor, box, boxBody, disc, heavy, near, plainBody, steps, tie, weightless } from './setting.js';

/** Counts the `wake` and `sleep` events of a body. */
function count(body: RigidBody): { wake: number; sleep: number } {
  const seen = { wake: 0, sleep: 0 };
  body.addEventListener('wake', () => {
    seen.wake += 1;
  });
  body.addEventListener('sleep', () => {
    seen.sleep += 1;
  });
  return seen;
}

/** A plain body that has fallen asleep in a world without gravity. */
function sleeper(): { world: World; body: RigidBody; seen: { wake: number; sleep: number } } {
  const world = weightless();
  const body = plainBody();
  const seen = count(body);
  add(world, body);
  steps(world, 62);
  expect(body.sleeping).toBe(true);
  return { world, body, seen };
}

/** A box that has fallen asleep on a body with its top at y = 0.5. */
function resting(ground: RigidBody): { world: World; body: RigidBody; seen: { wake: number; sleep: number } } {
  const world = heavy();
  add(world, ground);
  const body = boxBody(1, 1);
  const seen = count(body);
  add(world, body);
  steps(world, 150);
  expect(body.sleeping).toBe(true);
  return { world, body, seen };
}

const ground = (type: 'static' | 'kinematic') =>
  phys2D.createRigidBody({ type, position: [0, 1], shapes: [box(20, 1)] });

describe('sleeping and waking', () => {
  it('C-147 a body at rest is awake after step 61 and asleep after step 62', () => {
    const world = weightless();
    const body = plainBody();
    const seen = count(body);
    add(world, body);
    steps(world, 61);
    expect(body.sleeping).toBe(false);
    steps(world, 1);
    expect(body.sleeping).toBe(true);
    steps(world, 10);
    expect(seen).toEqual({ wake: 0, sleep: 1 });
  });

  it('C-147 a body without shapes is at rest only if it does not turn either', () => {
    const world = weightless();
    const [still, turning] = [0, 1].map((angularVelocity) =>
      phys2D.createRigidBody({ mass: 1, inertia: 1, angularVelocity, angularDrag: 0 }),
    );
    add(world, still!, turning!);
    steps(world, 100);
    expect([still!.sleeping, turning!.sleeping]).toEqual([true, false]);
  });

  it('C-148 falling asleep ends all motion', () => {
    const { world, body } = resting(ground('static'));
    expect(body.getVelocity()).toEqual([0, 0]);
    expect(body.getAngularVelocity()).toBe(0);
    expect(world.liveDynamics).toEqual([]);
  });

  it('C-149 wake() is silent, a change of velocity is not', () => {
    const { world, body, seen } = sleeper();
    body.wake();
    expect(world.liveDynamics).toEqual([body]);
    steps(world, 1);
    expect(seen.wake).toBe(0);
    const other = sleeper();
    other.body.setVelocity([1, 0]);
    steps(other.world, 1);
    expect(other.seen.wake).toBe(1);
    steps(other.world, 5);
    expect(other.seen.wake).toBe(1);
  });

  it('C-150 equal values do not wake, new ones do', () => {
    const { body } = sleeper();
    body.setVelocity([0, 0]);
    body.setPosition([0, 0]);
    body.setForce([0, 0]);
    body.setRotation(0);
    expect(body.sleeping).toBe(true);
    for (const change of [
      (b: RigidBody) => b.setVelocity([1, 0]),
      (b: RigidBody) => b.setPosition([1, 0]),
      (b: RigidBody) => b.setForce([1, 0]),
      (b: RigidBody) => b.setRotation(1),
    ]) {
      const { body: other } = sleeper();
      change(other);
      expect(other.sleeping).toBe(false);
    }
  });

  it('C-151 some calls always wake, others never', () => {
    for (const call of [
      (b: RigidBody) => b.shapes[0]!.setGroup(1),
      (b: RigidBody) => b.shapes[0]!.setMask(0xffffffff),
      (b: RigidBody) => b.setSurfaceVelocity([0, 0]),
      (b: RigidBody) => b.setLinearDrag(0),
      (b: RigidBody) => b.applyImpulse([0, 0]),
      (b: RigidBody) => b.integrate(0),
      (b: RigidBody) => b.shapes[0]!.translate([0, 0]),
    ]) {
      const { body } = sleeper();
      call(body);
      expect(body.sleeping, String(call)).toBe(false);
    }
    const { body } = sleeper();
    body.getPosition();
    body.getMass();
    body.computeWorldBounds();
    body.bullet = true;
    expect(body.sleeping).toBe(true);
  });

  it('C-152 a stack wakes as a whole', () => {
    const world = heavy();
    addFloor(world);
    const bodies = [boxBody(1, 1), boxBody(1, 1, { position: [0, -1] })];
    const seen = bodies.map(count);
    add(world, ...bodies);
    steps(world, 200);
    expect(bodies.map((body) => body.sleeping)).toEqual([true, true]);
    bodies[1]!.applyImpulse([0, -1]);
    steps(world, 1);
    expect(bodies.map((body) => body.sleeping)).toEqual([false, false]);
    expect(seen.map((events) => events.wake)).toEqual([1, 1]);
  });

  it('C-152 bodies put to sleep one by one wake with what lies on them, whichever was made first', () => {
    for (const lowerFirst of [true, false]) {
      const world = heavy();
      addFloor(world);
      const bodies = [0, 1].map(() => boxBody(1, 1));
      const [lower, upper] = lowerFirst ? [bodies[0]!, bodies[1]!] : [bodies[1]!, bodies[0]!];
      upper.setPosition([0, -1]);
      add(world, ...bodies);
      steps(world, 5);
      upper.sleep();
      lower.sleep();
      steps(world, 1);
      expect([lower.sleeping, upper.sleeping]).toEqual([true, true]);
      lower.setVelocity([1, 0]);
      expect([lower.sleeping, upper.sleeping]).toEqual([false, false]);
    }
  });

  it('C-153 a body falls when its support is removed', () => {
    const floor = ground('static');
    const { world, body } = resting(floor);
    const [, y] = body.getPosition();
    world.removeRigidBody(floor);
    expect(body.sleeping).toBe(false);
    steps(world, 30);
    expect(body.getPosition()[1]).toBeGreaterThan(y + 0.5);
  });

  it('C-154 a platform that starts wakes what stands on it', () => {
    const platform = ground('kinematic');
    const { body } = resting(platform);
    expect(platform.sleeping).toBe(true);
    platform.setVelocity([0, -1]);
    expect(body.sleeping).toBe(false);
  });

  it('C-155 a belt that starts wakes what lies on it', () => {
    const floor = ground('static');
    const { world, body } = resting(floor);
    floor.setSurfaceVelocity([2, 0]);
    expect(body.sleeping).toBe(false);
    expect(floor.sleeping).toBe(true);
    steps(world, 60);
    expect(body.getVelocity()[0]).toBeGreaterThan(1.9);
  });

  it('C-156 a sleeping body that is hit wakes in that step', () => {
    const { world, body, seen } = sleeper();
    const other = plainBody({ position: [-1.2, 0], velocity: [3, 0] });
    add(world, other);
    let hitAt = 0;
    for (let i = 1; i <= 20 && hitAt === 0; i += 1) {
      steps(world, 1);
      hitAt = world.dynamicArbiters.some((arbiter) => arbiter.active) ? i : 0;
    }
    expect(hitAt).toBeGreaterThan(0);
    expect(body.sleeping).toBe(false);
    expect(body.getVelocity()[0]).toBeGreaterThan(1);
    expect(seen.wake).toBe(1);
  });

  it('C-157 a sensor does not wake what it enters', () => {
    const { world, body, seen } = sleeper();
    add(world, plainBody({ shapes: [disc(0.5, { sensor: true })], position: [-1, 0], velocity: [1, 0] }));
    steps(world, 60);
    expect(body.sleeping).toBe(true);
    expect(seen.wake).toBe(0);
  });

  it('C-158 a kinematic body sleeps after one step without motion', () => {
    const world = weightless();
    const body = plainBody({ type: 'kinematic' });
    const seen = count(body);
    add(world, body);
    steps(world, 1);
    expect(body.sleeping).toBe(true);
    expect(world.liveKinematics).toEqual([]);
    body.setVelocity([1, 0]);
    expect(world.liveKinematics).toEqual([body]);
    steps(world, 1);
    expect(seen).toEqual({ wake: 0, sleep: 0 });
  });

  it('C-159 sleep() has no effect on a kinematic body', () => {
    const world = weightless();
    const body = plainBody({ type: 'kinematic', velocity: [1, 0] });
    add(world, body);
    body.sleep();
    expect(body.sleeping).toBe(false);
    expect(world.liveKinematics).toEqual([body]);
  });

  it('C-160 sleep() keeps the velocity', () => {
    const world = weightless();
    const body = plainBody({ velocity: [1, 0] });
    add(world, body);
    body.sleep();
    steps(world, 30);
    expect(body.sleeping).toBe(true);
    expect(body.getPosition()).toEqual([0, 0]);
    body.wake();
    steps(world, 30);
    expect(body.getVelocity()).toEqual([1, 0]);
    expect(body.getPosition()[0]).toBeCloseTo(0.5, 9);
  });

  it('C-161 a body put to sleep beside a live constraint can be woken [D-40]', () => {
    const world = weightless();
    const p = plainBody();
    const q = plainBody({ position: [3, 0], velocity: [0, 1] });
    add(world, p, q);
    tie(world, phys2D.createDistanceConstraint({ bodyA: p, bodyB: q, upperBound: 5 }));
    p.sleep();
    steps(world, 1);
    p.wake();
    expect(p.sleeping).toBe(false);
    expect(world.liveDynamics).toContain(p);
  });

  it('C-161 so can the other one, after any number of steps', () => {
    const world = weightless();
    const p = plainBody();
    const q = plainBody({ position: [3, 0], velocity: [0, 1] });
    add(world, p, q);
    const constraint = phys2D.createDistanceConstraint({ bodyA: q, bodyB: p, upperBound: 5 });
    tie(world, constraint);
    for (const count of [0, 1, 100]) {
      p.sleep();
      q.sleep();
      steps(world, count);
      expect([p.sleeping, q.sleeping]).toEqual([true, true]);
      p.wake();
      q.wake();
      expect([p.sleeping, q.sleeping, constraint.sleeping]).toEqual([false, false, false]);
      expect(world.liveDynamics).toHaveLength(2);
      expect(world.liveConstraints).toEqual([constraint]);
    }
  });

  it('C-162 a constraint keeps the partner of a moving body awake', () => {
    const world = weightless();
    const p = plainBody();
    const q = plainBody({ position: [3, 0], torque: 0.2 });
    add(world, p, q);
    tie(world, phys2D.createDistanceConstraint({ bodyA: p, bodyB: q, upperBound: 5 }));
    steps(world, 200);
    near(p.getPosition(), [0, 0], 1e-9);
    expect([p.sleeping, q.sleeping]).toEqual([false, false]);
  });

  it('C-162 whichever of the two is moving, a pulley or a custom constraint likewise', () => {
    for (const moving of [0, 1, 2]) {
      const world = weightless();
      const bodies = [0, 1, 2].map((i) => plainBody({ position: [3 * i, 0] }));
      add(world, ...bodies);
      const [a, b, c] = bodies as [RigidBody, RigidBody, RigidBody];
      const anchor = phys2D.createRigidBody({ type: 'static', position: [0, 9] });
      tie(
        world,
        phys2D.createPulleyConstraint({ bodyA: a, bodyB: anchor, bodyC: anchor, bodyD: b, upperBound: 99 }),
        phys2D.createCustomConstraint({ dimension: 1, bodies: [anchor, b, c], jacobian() {} }),
      );
      bodies[moving]!.setForce([0, 0.01]);
      bodies[moving]!.setVelocity([0, 0.1]);
      steps(world, 100);
      expect(bodies.map((body) => body.sleeping)).toEqual([false, false, false]);
    }
  });

  it('C-163 a constraint falls asleep with its island', () => {
    const world = weightless();
    const p = plainBody();
    const q = plainBody({ position: [3, 0] });
    add(world, p, q);
    const constraint = phys2D.createDistanceConstraint({ bodyA: p, bodyB: q, upperBound: 5 });
    tie(world, constraint);
    const slept = vi.fn();
    const woken = vi.fn();
    constraint.addEventListener('sleep', slept);
    constraint.addEventListener('wake', woken);
    steps(world, 80);
    expect([p.sleeping, q.sleeping, constraint.sleeping]).toEqual([true, true, true]);
    expect(world.liveConstraints).toEqual([]);
    expect(slept).toHaveBeenCalledTimes(1);
    p.applyImpulse([0, 1]);
    expect([p.sleeping, q.sleeping, constraint.sleeping]).toEqual([false, false, false]);
    steps(world, 1);
    expect(woken).toHaveBeenCalledTimes(1);
  });

  it('C-164 a slack rope to a moving platform becomes taut [D-78]', () => {
    const world = weightless();
    const platform = phys2D.createRigidBody({ type: 'kinematic', velocity: [-0.5, 0], shapes: [disc(0.5)] });
    const body = plainBody({ position: [3, 0] });
    add(world, platform, body);
    tie(world, phys2D.createDistanceConstraint({ bodyA: platform, bodyB: body, upperBound: 5 }));
    steps(world, 1200);
    expect(platform.getPosition()[0]).toBeCloseTo(-10, 6);
    expect(body.getPosition()[0] - platform.getPosition()[0]).toBeLessThanOrEqual(5.05);
  });

  it('C-164 the same with the roles exchanged, and while the platform turns', () => {
    const world = weightless();
    const platform = phys2D.createRigidBody({ type: 'kinematic', angularVelocity: 0.1 });
    const body = plainBody({ position: [3, 0] });
    add(world, platform, body);
    const rope = phys2D.createDistanceConstraint({ bodyA: body, bodyB: platform, upperBound: 5 });
    tie(world, rope);
    steps(world, 200);
    expect([body.sleeping, rope.sleeping]).toEqual([false, false]);
    platform.setVelocity([-0.5, 0]);
    steps(world, 1200);
    expect(body.getPosition()[0] - platform.getPosition()[0]).toBeLessThanOrEqual(5.05);
    platform.setVelocity([0, 0]);
    platform.setAngularVelocity(0);
    body.setVelocity([0, 0]);
    steps(world, 120);
    expect([body.sleeping, rope.sleeping]).toEqual([true, true]);
  });

  it('C-165 a removed body is awake', () => {
    const { world, body } = sleeper();
    const floor = addFloor(world, { position: [0, 5] });
    world.removeRigidBody(body);
    world.removeRigidBody(floor);
    expect([body.sleeping, floor.sleeping]).toEqual([false, false]);
  });

  it('C-166 adding a listener wakes silently', () => {
    const { world, body, seen } = sleeper();
    body.addEventListener('sleep', () => {});
    expect(body.sleeping).toBe(false);
    steps(world, 1);
    expect(seen.wake).toBe(0);
  });

  it('allowSleeping: false keeps everything awake, and wakes what slept', () => {
    const { world, body } = sleeper();
    world.allowSleeping = false;
    expect(body.sleeping).toBe(false);
    steps(world, 200);
    expect(body.sleeping).toBe(false);
    world.allowSleeping = true;
    steps(world, 61);
    expect(body.sleeping).toBe(false);
    steps(world, 1);
    expect(body.sleeping).toBe(true);
  });

  it('… constraints between awake bodies too, and those without a body that can move', () => {
    const world = weightless();
    const bodyA = phys2D.createRigidBody({ type: 'static' });
    const body = plainBody();
    add(world, body);
    const tied = phys2D.createPointConstraint({ bodyA, bodyB: body });
    const idle = phys2D.createPointConstraint({ bodyA, bodyB: phys2D.createRigidBody({ type: 'static' }) });
    tie(world, tied, idle);
    steps(world, 1);
    tied.sleep();
    world.allowSleeping = false;
    expect([tied.sleeping, idle.sleeping]).toEqual([false, false]);
    steps(world, 2);
    expect(world.liveConstraints).toHaveLength(2);
  });
});
