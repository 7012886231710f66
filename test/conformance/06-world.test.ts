import { describe, expect, it, vi } from 'vitest';
import { phys2D, type RigidBody } from '../../src/index.js';
import { add, addFloor, disc, heavy, near, plainBody, steps, tie, weightless } from './setting.js';

describe('world: membership and lists', () => {
  it('C-062 a new world is empty', () => {
    const world = phys2D.createWorld();
    expect([world.simulatedTime, world.timeStamp]).toEqual([0, 0]);
    for (const list of [
      world.rigidBodies,
      world.liveDynamics,
      world.liveKinematics,
      world.dynamicArbiters,
      world.staticArbiters,
    ]) {
      expect(list).toEqual([]);
    }
    expect(world.getGravity()).toEqual([0, 10]);
    expect([world.velocityIterations, world.positionIterations]).toEqual([8, 8]);
  });

  it('C-063 time passes by the steps made', () => {
    const world = phys2D.createWorld();
    world.step(0.5);
    world.step(0.25);
    expect([world.simulatedTime, world.timeStamp]).toEqual([0.75, 2]);
  });

  it('C-064 a body is added once', () => {
    const world = weightless();
    const body = plainBody();
    expect(world.addRigidBody(body)).toBe(true);
    expect(body.world).toBe(world);
    expect(world.rigidBodies).toContain(body);
    expect(world.liveDynamics).toContain(body);
    expect(world.addRigidBody(body)).toBe(false);
    expect(world.rigidBodies).toHaveLength(1);
  });

  it('C-065 a body belongs to one world', () => {
    const [one, two] = [weightless(), weightless()];
    const body = plainBody();
    add(one, body);
    expect(two.addRigidBody(body)).toBe(false);
    expect(two.removeRigidBody(body)).toBe(false);
    expect(body.world).toBe(one);
  });

  it('C-066 static bodies are in no live list, kinematic ones in theirs', () => {
    const world = weightless();
    const fixed = plainBody({ type: 'static' });
    const moved = plainBody({ type: 'kinematic', position: [5, 0] });
    add(world, fixed, moved);
    expect(world.rigidBodies).toEqual([fixed, moved]);
    expect(world.liveDynamics).toEqual([]);
    expect(world.liveKinematics).toEqual([moved]);
    expect(fixed.sleeping).toBe(true);
  });

  it('C-067 a body added asleep stays asleep', () => {
    const world = heavy();
    const body = plainBody({ sleeping: true });
    add(world, body);
    expect(world.liveDynamics).toEqual([]);
    steps(world, 30);
    expect(body.getPosition()).toEqual([0, 0]);
  });

  it('C-068 a removed body is in no list', () => {
    const world = weightless();
    const bodies = (['dynamic', 'kinematic', 'static'] as const).map((type, i) =>
      plainBody({ type, position: [3 * i, 0] }),
    );
    add(world, ...bodies);
    for (const body of bodies) {
      expect(world.removeRigidBody(body)).toBe(true);
      expect(body.world).toBe(null);
    }
    expect([...world.rigidBodies, ...world.liveDynamics, ...world.liveKinematics]).toEqual([]);
  });

  it('C-069 a removed body takes its constraints along', () => {
    const world = weightless();
    const p = plainBody();
    const q = plainBody({ position: [3, 0] });
    add(world, p, q);
    const constraint = phys2D.createDistanceConstraint({ bodyA: p, bodyB: q, upperBound: 5 });
    tie(world, constraint);
    const broken = vi.fn();
    constraint.addEventListener('break', broken);
    world.removeRigidBody(p);
    expect([world.constraints, world.liveConstraints, p.constraints, q.constraints]).toEqual([[], [], [], []]);
    expect(constraint.world).toBeNull();
    steps(world, 1);
    expect(broken).not.toHaveBeenCalled();
  });

  it('C-069 whichever of its bodies it is, static ones too', () => {
    for (let k = 0; k < 4; k += 1) {
      const world = weightless();
      const bodies = (['dynamic', 'kinematic', 'static', 'dynamic'] as const).map((type, i) =>
        plainBody({ type, position: [3 * i, 0] }),
      );
      add(world, ...bodies);
      const [bodyA, bodyB, bodyC, bodyD] = bodies as [RigidBody, RigidBody, RigidBody, RigidBody];
      const pulley = phys2D.createPulleyConstraint({ bodyA, bodyB, bodyC, bodyD, upperBound: 20 });
      const custom = phys2D.createCustomConstraint({ dimension: 1, bodies, jacobian() {} });
      tie(world, pulley, custom);
      world.removeRigidBody(bodies[k]!);
      expect([pulley.world, custom.world, world.constraints]).toEqual([null, null, []]);
      expect(bodies.map((body) => body.constraints)).toEqual([[], [], [], []]);
    }
  });

  it('C-070 a constraint is added once and removed once', () => {
    const world = weightless();
    const a = plainBody();
    const b = plainBody({ position: [3, 0] });
    add(world, a, b);
    const constraint = phys2D.createDistanceConstraint({ bodyA: a, bodyB: b, upperBound: 5 });
    expect([world.addConstraint(constraint), world.addConstraint(constraint)]).toEqual([true, false]);
    expect(constraint.world).toBe(world);
    expect([a.constraints, b.constraints, world.constraints]).toEqual([[constraint], [constraint], [constraint]]);
    expect(weightless().removeConstraint(constraint)).toBe(false);
    expect([world.removeConstraint(constraint), world.removeConstraint(constraint)]).toEqual([true, false]);
    expect(constraint.world).toBeNull();
    expect([a.constraints, b.constraints, world.constraints]).toEqual([[], [], []]);
  });

  it('C-071 clear empties the lists and keeps the time', () => {
    const world = heavy();
    const floor = addFloor(world);
    const body = plainBody();
    add(world, body);
    steps(world, 10);
    world.clear();
    expect(world.timeStamp).toBe(10);
    for (const list of [
      world.rigidBodies,
      world.liveDynamics,
      world.liveKinematics,
      world.dynamicArbiters,
      world.staticArbiters,
    ]) {
      expect(list).toEqual([]);
    }
    expect([floor.world, body.world]).toEqual([null, null]);
    expect([...floor.shapes, ...body.shapes].flatMap((shape) => shape.arbiters)).toEqual([]);
    add(world, floor, body);
    steps(world, 10);
    expect(world.staticArbiters).toHaveLength(1);
  });

  it('C-072 clear ends interactions without a word', () => {
    const world = weightless();
    const a = plainBody();
    const b = plainBody({ position: [0.5, 0] });
    let ends = 0;
    a.shapes[0]!.addEventListener('end', () => {
      ends += 1;
    });
    add(world, a, b);
    steps(world, 2);
    expect(world.dynamicArbiters).toHaveLength(1);
    world.clear();
    add(world, a);
    steps(world, 5);
    expect(ends).toBe(0);
  });

  it('C-073 a change of gravity wakes sleeping bodies, an equal value does not', () => {
    const world = weightless();
    const body = plainBody();
    add(world, body);
    steps(world, 70);
    expect(body.sleeping).toBe(true);
    world.setGravity([0, 0]);
    expect(body.sleeping).toBe(true);
    world.setGravity([1, 2]);
    expect(world.getGravity()).toEqual([1, 2]);
    expect(body.sleeping).toBe(false);
  });

  it('C-075 a pulley over four bodies is removed from all of them [D-02]', () => {
    const world = weightless();
    const bodies = [0, 1, 2, 3].map((i) => plainBody({ position: [3 * i, 0] }));
    add(world, ...bodies);
    const [bodyA, bodyB, bodyC, bodyD] = bodies as [RigidBody, RigidBody, RigidBody, RigidBody];
    const other = phys2D.createAngleConstraint({ bodyA: bodyB, bodyB: bodyC });
    const pulley = phys2D.createPulleyConstraint({ bodyA, bodyB, bodyC, bodyD, upperBound: 20 });
    tie(world, other, pulley);
    expect(world.removeConstraint(pulley)).toBe(true);
    expect(bodies.map((body) => body.constraints)).toEqual([[], [other], [other], []]);
    for (const body of bodies) {
      expect(world.removeRigidBody(body)).toBe(true);
    }
    expect(world.constraints).toEqual([]);
  });

  it('C-076 a static body in no world is an anchor', () => {
    const world = heavy();
    const anchor = phys2D.createRigidBody({ type: 'static', position: [1, 2], rotation: 1 });
    const body = plainBody({ position: [1, 3] });
    add(world, body);
    tie(world, phys2D.createPointConstraint({ bodyA: anchor, bodyB: body, anchorB: [0, -1] }));
    steps(world, 120);
    near(body.getPosition(), [1, 3], 1e-3);
    near(anchor.getPosition(), [1, 2], 0);
  });

  it('C-076 a kinematic one too; whichever role it has', () => {
    for (const type of ['static', 'kinematic'] as const) {
      for (const isA of [true, false]) {
        const world = heavy();
        const anchor = phys2D.createRigidBody({ type, position: [1, 2] });
        const body = plainBody({ position: [1, 3] });
        add(world, body);
        const own = { bodyA: anchor, bodyB: body, anchorB: [0, -1] } as const;
        const exchanged = { bodyA: body, bodyB: anchor, anchorA: [0, -1] } as const;
        tie(world, phys2D.createPointConstraint(isA ? own : exchanged));
        steps(world, 120);
        near(body.getPosition(), [1, 3], 1e-3);
        near(anchor.getPosition(), [1, 2], 0);
      }
    }
  });

  it('C-077 a dynamic body in no world makes a constraint inert [D-05]', () => {
    const world = heavy();
    const outside = plainBody();
    const body = plainBody({ position: [0, 1] });
    add(world, body);
    const constraint = phys2D.createPointConstraint({ bodyA: outside, bodyB: body, anchorB: [0, -1] });
    tie(world, constraint);
    steps(world, 60);
    near(outside.getPosition(), [0, 0], 0);
    near(body.getVelocity(), [0, 10], 1e-6);
    add(world, outside);
    steps(world, 60);
    near(body.transformLocalPointToWorld([0, -1]), outside.getPosition() as [number, number], 0.01);
  });

  it('C-074 nothing is added or removed in a preSolve handler', () => {
    const world = weightless();
    const a = plainBody();
    const b = plainBody({ position: [0.5, 0] });
    const stranger = plainBody({ position: [9, 9] });
    const tied = phys2D.createAngleConstraint({ bodyA: a, bodyB: b });
    const untied = phys2D.createAngleConstraint({ bodyA: a, bodyB: b });
    tie(world, tied);
    const results: boolean[] = [];
    a.shapes[0]!.addEventListener('preSolve', () => {
      results.push(world.addRigidBody(stranger), world.removeRigidBody(b));
      results.push(world.addConstraint(untied), world.removeConstraint(tied));
      results.push(a.addShape(disc(1)), a.removeShape(a.shapes[0]!));
    });
    add(world, a, b);
    steps(world, 1);
    expect(results).toEqual([false, false, false, false, false, false]);
    expect(world.rigidBodies).toEqual([a, b]);
    expect(world.constraints).toEqual([tied]);
    expect(a.constraints).toEqual([tied]);
    expect(a.shapes).toHaveLength(1);
  });

  it('lists stay exact through random additions and removals', () => {
    const world = heavy();
    addFloor(world);
    let seed = 7;
    const random = (): number => {
      seed = (Math.imul(seed, 1664525) + 1013904223) >>> 0;
      return seed / 2 ** 32;
    };
    const inside: RigidBody[] = [];
    for (let i = 0; i < 400; i += 1) {
      if (inside.length < 40 && random() < 0.6) {
        const type = random() < 0.8 ? 'dynamic' : random() < 0.5 ? 'kinematic' : 'static';
        const body = plainBody({ type, position: [16 * random() - 8, -8 * random()] });
        add(world, body);
        inside.push(body);
      } else if (inside.length > 0) {
        const [body] = inside.splice(Math.floor(random() * inside.length), 1);
        expect(world.removeRigidBody(body!)).toBe(true);
        expect(body!.shapes[0]!.arbiters).toEqual([]);
      }
      world.step(1 / 60);
      expect(new Set(world.rigidBodies)).toEqual(new Set([world.rigidBodies[0], ...inside].filter((b) => b)));
      const live = inside.filter((body) => !body.sleeping);
      expect(new Set([...world.liveDynamics, ...world.liveKinematics])).toEqual(new Set(live));
      for (const arbiter of [...world.dynamicArbiters, ...world.staticArbiters]) {
        expect(arbiter.bodyA.world).toBe(world);
        expect(arbiter.bodyB.world).toBe(world);
        expect(arbiter.shapeA.id).toBeLessThan(arbiter.shapeB.id);
        expect(arbiter.shapeA.arbiters).toContain(arbiter);
        expect(arbiter.shapeB.arbiters).toContain(arbiter);
      }
    }
  });
});
