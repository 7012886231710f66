import { describe, expect, it, vi } from 'vitest';
import { type Arbiter, phys2D, type RigidBody, type Shape, type World } from '../../src/index.js';
import { add, addFloor, arbiterOf, box, boxBody, disc, heavy, near, plainBody, steps, weightless } from './setting.js';

const all = (world: World): Arbiter[] => [...world.dynamicArbiters, ...world.staticArbiters];

/** Two plain bodies that overlapped in step 1, and are far apart from then on. */
function parted(first: Shape = disc(0.5), second: Shape = disc(0.5)) {
  const world = weightless();
  const a = plainBody({ shapes: [first] });
  const b = plainBody({ shapes: [second], position: [0.9, 0] });
  add(world, a, b);
  steps(world, 1);
  expect(arbiterOf(world, a, b)).toBeDefined();
  b.setPosition([9, 0]);
  return { world, a, b };
}

/** A body on the floor, which is older, after some steps. */
function onFloor(make: () => RigidBody, count: number) {
  const world = heavy();
  const floor = addFloor(world);
  const body = make();
  add(world, body);
  steps(world, count);
  return { world, floor, body, arbiter: arbiterOf(world, floor, body)! };
}

describe('arbiters', () => {
  it('C-107 two overlapping bodies make one arbiter', () => {
    for (const shapes of [
      [disc(0.5), disc(0.5)],
      [disc(0.5), box(1, 1)],
      [box(1, 1), disc(0.5)],
      [box(1, 1), box(1, 1)],
    ] as const) {
      for (const reversed of [false, true]) {
        const world = weightless();
        const a = plainBody({ shapes: [shapes[reversed ? 1 : 0].clone()] });
        const b = plainBody({ shapes: [shapes[reversed ? 0 : 1].clone()], position: [0.9, 0] });
        add(world, b, a);
        steps(world, 1);
        expect(all(world)).toEqual(world.dynamicArbiters);
        expect(world.dynamicArbiters).toHaveLength(1);
        const arbiter = world.dynamicArbiters[0]!;
        expect([arbiter.active, arbiter.sleeping, arbiter.sensor]).toEqual([true, false, false]);
        expect([arbiter.shapeA, arbiter.shapeB]).toEqual([a.shapes[0], b.shapes[0]]);
        expect(arbiter.shapeA.id).toBeLessThan(arbiter.shapeB.id);
        expect([arbiter.bodyA, arbiter.bodyB]).toEqual([a, b]);
        expect([a.shapes[0]!.arbiters, b.shapes[0]!.arbiters]).toEqual([[arbiter], [arbiter]]);
      }
    }
  });

  it('C-108 a contact with a static or kinematic body is in staticArbiters', () => {
    for (const type of ['static', 'kinematic'] as const) {
      for (const sensor of [false, true]) {
        const world = weightless();
        const a = plainBody({ type, shapes: [disc(0.5, { sensor })] });
        const b = plainBody({ position: [0.9, 0] });
        add(world, a, b);
        steps(world, 1);
        expect(world.dynamicArbiters).toEqual([]);
        expect(world.staticArbiters).toEqual(a.shapes[0]!.arbiters);
        expect(world.staticArbiters).toHaveLength(1);
      }
    }
  });

  it('C-109 the normal points from shapeA to shapeB', () => {
    for (const shape of [box(1, 1), disc(0.5)]) {
      const above = onFloor(() => plainBody({ shapes: [shape.clone()] }), 5);
      expect(above.arbiter.shapeA).toBe(above.floor.shapes[0]);
      near(above.arbiter.getNormal(), [0, -1]);
      const world = heavy();
      const body = plainBody({ shapes: [shape] });
      const floor = addFloor(world);
      add(world, body);
      steps(world, 5);
      const arbiter = arbiterOf(world, body, floor)!;
      expect(arbiter.shapeA).toBe(shape);
      near(arbiter.getNormal(), [0, 1]);
    }
  });

  it('C-110 a box stands on two contacts, a disc on one', () => {
    const { contacts } = onFloor(() => boxBody(1, 1), 30).arbiter;
    expect(contacts.map((contact) => contact.active)).toEqual([true, true]);
    const ends = contacts.map((contact) => contact.getPosition()[0]).sort((a, b) => a - b);
    near(ends, [-0.5, 0.5], 0.01);
    for (const contact of contacts) {
      near(contact.getPosition()[1], 0.5, 0.01);
    }
    const one = onFloor(() => plainBody(), 30).arbiter.contacts;
    expect(one.map((contact) => contact.active)).toEqual([true]);
    near(one[0]!.getPosition(), [0, 0.5], 0.01);
  });

  it('C-111 the impulse of a step carries the weight', () => {
    for (const shape of [box(1, 1), disc(0.5)]) {
      for (const make of [() => shape, () => shape.clone()]) {
        const { floor, body, arbiter } = onFloor(() => plainBody({ shapes: [make()] }), 30);
        near(arbiter.getImpulseForBody(body), [0, -1 / 6, 0], 1e-3);
        near(arbiter.getImpulseForBody(floor).slice(0, 2), [0, 1 / 6], 1e-3);
        expect(arbiter.getImpulseForBody(plainBody())).toEqual([0, 0, 0]);
        const normals = arbiter.contacts.map((contact) => contact.getNormalImpulse());
        near(
          normals.reduce((sum, impulse) => sum + impulse, 0),
          1 / 6,
          1e-3,
        );
        expect(Math.min(...normals)).toBeGreaterThanOrEqual(0);
        for (const contact of arbiter.contacts) {
          expect(contact.getPenetration()).toBeGreaterThanOrEqual(0);
          expect(contact.getPenetration()).toBeLessThanOrEqual(0.015);
        }
      }
    }
  });

  it('C-111 … and what a body gets is what its velocities change by', () => {
    const world = weightless();
    const a = plainBody({ shapes: [box(1, 1)], velocity: [0.3, 0.1], angularVelocity: 0.2 });
    const b = plainBody({ shapes: [disc(0.5)], position: [0.999, 0.3], velocity: [-0.2, 0], mass: 3 });
    add(world, a, b);
    steps(world, 1);
    const arbiter = arbiterOf(world, a, b)!;
    const [ax, ay, aw] = arbiter.getImpulseForBody(a);
    const [bx, by, bw] = arbiter.getImpulseForBody(b);
    near(a.getVelocity(), [0.3 + ax, 0.1 + ay]);
    near(b.getVelocity(), [-0.2 + bx / 3, by / 3]);
    expect(ax).toBeLessThan(-0.1);
    expect(Math.abs(arbiter.getRollingImpulse())).toBeGreaterThan(1e-4);
    near(a.getAngularVelocity(), 0.2 + aw, 1e-3);
    near(b.getAngularVelocity(), bw, 1e-3);
    const destination = new Float64Array(3);
    expect(arbiter.getImpulseForBody(b, destination)).toBe(destination);
    expect([...destination]).toEqual([bx, by, bw]);
  });

  it('C-112 a contact is fresh in its first step', () => {
    for (const shape of [box(1, 1), disc(0.5)]) {
      const { world, arbiter } = onFloor(() => plainBody({ shapes: [shape], position: [0, 0.001] }), 1);
      expect(arbiter.contacts.map((contact) => contact.fresh)).toContain(true);
      expect(arbiter.contacts.map((contact) => contact.fresh)).not.toContain(false);
      steps(world, 1);
      expect(arbiter.contacts.map((contact) => contact.fresh)).not.toContain(true);
    }
  });

  it('C-112 a point that was virtual is fresh in the step that uses it, also where an impact does', () => {
    let used = 0;
    const wrong: unknown[] = [];
    for (const substeps of [1, 4]) {
      for (let k = 0; k < 20; k += 1) {
        const world = heavy({ substeps });
        const floor = addFloor(world);
        const body = boxBody(1, 1, {
          rotation: 0.02 + 0.05 * k,
          position: [0, -0.3 - 0.02 * k],
          angularVelocity: (k % 5) - 2,
        });
        add(world, body);
        let before: boolean[] = [];
        for (let i = 0; i < 150; i += 1) {
          steps(world, 1);
          const contacts = arbiterOf(world, floor, body)?.contacts.filter((contact) => contact.active) ?? [];
          if (contacts.length === before.length) {
            contacts.forEach((contact, at) => {
              const wanted = before[at]! && !contact.virtual;
              used += wanted ? 1 : 0;
              if (contact.fresh !== wanted) wrong.push([substeps, k, i, at]);
            });
          }
          before = contacts.map((contact) => contact.virtual);
        }
      }
    }
    expect(wrong).toEqual([]);
    expect(used).toBeGreaterThan(60);
  });

  it('C-113 a point that is apart is virtual', () => {
    const low = 0.5 * (Math.cos(0.1) + Math.sin(0.1));
    for (const rotation of [0.1, -0.1]) {
      const { arbiter } = onFloor(() => boxBody(1, 1, { position: [0, 0.5 - low + 0.002], rotation }), 1);
      const { contacts } = arbiter;
      expect(contacts).toHaveLength(2);
      const [apart, held] = contacts[0]!.virtual ? contacts : [...contacts].reverse();
      expect([apart!.virtual, held!.virtual]).toEqual([true, false]);
      expect([apart!.getNormalImpulse(), apart!.getTangentImpulse()]).toEqual([0, 0]);
      expect(apart!.getPenetration()).toBeLessThan(-0.05);
      expect(held!.getNormalImpulse()).toBeGreaterThan(0);
      expect(Math.sign(apart!.getPosition()[0])).toBe(Math.sign(rotation) * -1);
    }
  });

  it('C-113 … and has no impulse, whatever the boxes do', () => {
    const world = heavy();
    addFloor(world);
    for (let i = 0; i < 40; i += 1) {
      add(world, boxBody(0.6, 0.3, { position: [(i % 5) * 0.7 - 1.4, -0.5 * i], rotation: i, angularVelocity: i % 7 }));
    }
    let virtual = 0;
    for (let i = 0; i < 400; i += 1) {
      steps(world, 1);
      for (const contact of all(world).flatMap(({ active, contacts }) => (active ? contacts : []))) {
        if (contact.virtual) {
          virtual += 1;
          expect([contact.getNormalImpulse(), contact.getTangentImpulse()], `step ${i}`).toEqual([0, 0]);
        }
      }
    }
    expect(virtual).toBeGreaterThan(100);
  });

  it('C-114 an arbiter is kept for 30 steps', () => {
    const { world, a } = parted();
    for (let i = 1; i <= 30; i += 1) {
      steps(world, 1);
      expect(all(world), `step ${i}`).toHaveLength(1);
      expect(all(world)[0]!.active).toBe(false);
      expect(a.shapes[0]!.arbiters).toEqual(all(world));
    }
  });

  it('C-114 … for a single one if it is of a sensor', () => {
    const { world } = parted(disc(0.5, { sensor: true }));
    steps(world, 1);
    expect(all(world).map((arbiter) => arbiter.active)).toEqual([false]);
    steps(world, 1);
    expect(all(world)).toEqual([]);
  });

  it('C-115 afterwards it is nowhere [D-01]', () => {
    const { world, a, b } = parted();
    steps(world, 31);
    expect(all(world)).toEqual([]);
    steps(world, 9);
    expect(all(world)).toEqual([]);
    expect([a.shapes[0]!.arbiters, b.shapes[0]!.arbiters]).toEqual([[], []]);
  });

  it('C-116 an old pair has nothing to do with a new one [D-01]', () => {
    const { world, a } = parted();
    steps(world, 50);
    const r = plainBody({ position: [0, 5] });
    const s = plainBody({ position: [0.9, 5] });
    const calls: string[] = [];
    for (const type of ['begin', 'progress', 'end'] as const) {
      r.shapes[0]!.addEventListener(type, () => calls.push(type));
    }
    add(world, r, s);
    steps(world, 1);
    world.removeRigidBody(a);
    steps(world, 1);
    expect(calls).toEqual(['begin', 'progress']);
  });

  it('C-117 a value set by hand stays until it is to come from the shapes again', () => {
    const values = ['Elasticity', 'StaticFriction', 'DynamicFriction', 'RollingFriction'] as const;
    const rough = phys2D.createMaterial({
      elasticity: 0.4,
      staticFriction: 9,
      dynamicFriction: 4,
      rollingFriction: 0.25,
    });
    const combined = { Elasticity: 0.2, StaticFriction: Math.sqrt(18), DynamicFriction: 2, RollingFriction: 0 };
    for (const name of values) {
      const { arbiter, body, world } = onFloor(() => plainBody(), 5);
      arbiter[`set${name}`](0.7);
      expect(arbiter[`get${name}`](), name).toBe(0.7);
      body.shapes[0]!.setMaterial(rough);
      expect(arbiter[`get${name}`](), name).toBe(0.7);
      steps(world, 3);
      expect(arbiter[`get${name}`](), name).toBe(0.7);
      for (const other of values) {
        if (other !== name && other !== 'RollingFriction') {
          near(arbiter[`get${other}`]()!, combined[other]);
        }
      }
      arbiter[`set${name}FromShapes`]();
      near(arbiter[`get${name}`]()!, name === 'RollingFriction' ? Math.sqrt(0.25 * 0.005) : combined[name]);
    }
  });

  it('C-117 … also through a pause, until the arbiter is dropped', () => {
    for (const [pause, expected] of [
      [29, 0.7],
      [40, 0],
    ] as const) {
      const world = weightless();
      const [a, b] = [plainBody(), plainBody({ position: [0.9, 0] })];
      add(world, a, b);
      steps(world, 1);
      arbiterOf(world, a, b)!.setElasticity(0.7);
      b.setPosition([9, 0]);
      steps(world, pause);
      a.setPosition([0, 0]);
      b.setPosition([0.9, 0]);
      steps(world, 1);
      expect(arbiterOf(world, a, b)!.getElasticity()).toBe(expected);
    }
  });

  it('C-118 the combined values follow the materials of the shapes', () => {
    const { floor, body, arbiter } = onFloor(() => boxBody(1, 1), 5);
    for (const other of [floor, body]) {
      other.shapes[0]!.setMaterial(
        phys2D.createMaterial({ elasticity: 0.5, staticFriction: 8, dynamicFriction: 0.25 }),
      );
      const twice = other === body;
      near(arbiter.getElasticity()!, twice ? 0.5 : 0.25);
      near(arbiter.getStaticFriction()!, twice ? 8 : 4);
      near(arbiter.getDynamicFriction()!, twice ? 0.25 : 0.5);
    }
    body.shapes[0]!.setMaterial(phys2D.createMaterial({ elasticity: Infinity }));
    expect(arbiter.getElasticity()).toBe(1);
    floor.shapes[0]!.setMaterial(phys2D.createMaterial({ elasticity: -Infinity }));
    expect(arbiter.getElasticity()).toBe(0);
  });

  it('a setter wakes both bodies, silently', () => {
    const world = weightless();
    const bodies = [plainBody(), plainBody({ position: [0.999, 0] })];
    const wake = vi.fn();
    for (const body of bodies) {
      body.addEventListener('wake', wake);
    }
    add(world, ...bodies);
    const calls: ((arbiter: Arbiter) => void)[] = [
      (arbiter) => arbiter.setElasticity(0),
      (arbiter) => arbiter.setStaticFriction(1),
      (arbiter) => arbiter.setDynamicFriction(1),
      (arbiter) => arbiter.setRollingFriction(1),
      (arbiter) => arbiter.setElasticityFromShapes(),
      (arbiter) => arbiter.setAcceptedState(true),
      (arbiter) => arbiter.setPersistentState(false),
    ];
    for (const call of calls) {
      steps(world, 80);
      expect(bodies.map((body) => body.sleeping)).toEqual([true, true]);
      const arbiter = bodies[0]!.shapes[0]!.arbiters[0]!;
      expect([arbiter.sleeping, arbiter.active]).toEqual([true, false]);
      call(arbiter);
      expect(
        bodies.map((body) => body.sleeping),
        String(call),
      ).toEqual([false, false]);
      expect([arbiter.sleeping, arbiter.active]).toEqual([false, true]);
      expect(world.dynamicArbiters).toEqual([arbiter]);
    }
    steps(world, 1);
    expect(wake).not.toHaveBeenCalled();
  });
});
