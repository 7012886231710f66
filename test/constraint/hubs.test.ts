import { describe, expect, it } from 'vitest';
import {
  type Constraint,
  createWorld,
  phys2D,
  type RigidBody,
  simdKernels,
  type World,
  worldState,
} from '../../src/index.js';
import { box, DT } from '../conformance/setting.js';

// Many joints on one body that gives way more easily than what hangs on it: nothing may get energy of that.

function energyOf(world: World): number {
  return world.rigidBodies.reduce((sum, body) => {
    const [x, y] = body.getVelocity();
    return sum + (body.getMass() * (x * x + y * y) + body.getInertia() * body.getAngularVelocity() ** 2) / 2;
  }, 0);
}

type Spoke = (hub: RigidBody, spoke: RigidBody, at: [number, number]) => Constraint;

const spokes: Record<string, Spoke> = {
  weld: (bodyA, bodyB, [x, y]) =>
    phys2D.createWeldConstraint({ bodyA, bodyB, anchorA: [x / 2, y / 2], anchorB: [-x / 2, -y / 2] }),
  point: (bodyA, bodyB, at) => phys2D.createPointConstraint({ bodyA, bodyB, anchorA: at }),
  line: (bodyA, bodyB, at) =>
    phys2D.createLineConstraint({ bodyA, bodyB, anchorA: at, axis: at, lowerBound: 0, upperBound: 0 }),
  custom: (hub, spoke, [x, y]) =>
    phys2D.createCustomConstraint({
      dimension: 2,
      bodies: [hub, spoke],
      position: (data, index) => {
        const [ax, ay] = hub.transformLocalPointToWorld([x, y]);
        const [bx, by] = spoke.getPosition();
        data[index] = bx - ax;
        data[index + 1] = by - ay;
      },
      jacobian: (data, index) => {
        const [rx, ry] = hub.transformLocalVectorToWorld([x, y]);
        for (const [i, value] of [-1, 0, ry, 1, 0, 0, 0, -1, -rx, 0, 1, 0].entries()) data[index + i] = value;
      },
    }),
};

/** A hub with `count` equal boxes around it, `radius` m away, without gravity; one of them is pushed. */
function star(world: World, kind: string, count: number, radius: number): void {
  const make = (position: [number, number]): RigidBody => {
    const shapes = [box(0.5, 0.5, { mask: 0 })];
    const body = phys2D.createRigidBody({ position, shapes, linearDrag: 0, angularDrag: 0 });
    world.addRigidBody(body);
    return body;
  };
  const hub = make([0, 0]);
  const around = Array.from({ length: count }, (_, i): [number, number] => {
    const angle = (2 * Math.PI * i) / count + 0.1;
    return [radius * Math.cos(angle), radius * Math.sin(angle)];
  });
  const bodies = around.map(make);
  for (const [i, at] of around.entries()) world.addConstraint(spokes[kind]!(hub, bodies[i]!, at));
  bodies[0]!.setVelocity([0, 4]);
}

describe('spokes of a hub', () => {
  it.each(
    Object.keys(spokes).flatMap((kind) =>
      [3, 4, 6, 12].flatMap((count) =>
        (kind === 'custom' ? [1] : [1, 2, 4]).map((radius) => [kind, count, radius] as const),
      ),
    ),
  )('%s, %d of %d m, keep no more energy than they got', (kind, count, radius) => {
    const world = phys2D.createWorld({ gravity: [0, 0], allowSleeping: false });
    star(world, kind, count, radius);
    const given = energyOf(world);
    for (let i = 0; i < 240; i += 1) {
      world.step(DT);
      expect(energyOf(world)).toBeLessThanOrEqual(given);
    }
    expect(energyOf(world)).toBeLessThan(given);
    expect(energyOf(world)).toBeGreaterThan(0.02 * given);
  });

  it('are swept over to and fro, and a net of equal discs is not, nor a chain', () => {
    const isToAndFro = (build: (world: World) => void): boolean => {
      const world = phys2D.createWorld();
      build(world);
      world.step(DT);
      return world.solver.joints.groups.some(({ toAndFro }) => toAndFro);
    };
    const joined = (pairs: (i: number) => number[], place: (i: number) => [number, number], count: number) =>
      isToAndFro((world) => {
        const bodies = Array.from({ length: count }, (_, i) =>
          phys2D.createRigidBody({ position: place(i), shapes: [phys2D.createCircleShape({ radius: 0.4 })] }),
        );
        for (const body of bodies) world.addRigidBody(body);
        for (const [i, bodyA] of bodies.entries()) {
          for (const bodyB of pairs(i).map((k) => bodies[k]!)) {
            const [ax, ay] = bodyA.getPosition();
            const [bx, by] = bodyB.getPosition();
            const anchorA: [number, number] = [(bx - ax) / 2, (by - ay) / 2];
            const anchorB: [number, number] = [-anchorA[0], -anchorA[1]];
            world.addConstraint(phys2D.createPointConstraint({ bodyA, bodyB, anchorA, anchorB }));
          }
        }
      });
    expect(isToAndFro((world) => star(world, 'weld', 4, 2))).toBe(true);
    expect(
      joined(
        (i) => (i < 9 ? [i + 1] : []),
        (i) => [i, 0],
        10,
      ),
    ).toBe(false);
    const net = (i: number) => [...(i % 10 < 9 ? [i + 1] : []), ...(i < 90 ? [i + 10] : [])];
    expect(joined(net, (i) => [i % 10, Math.floor(i / 10)], 100)).toBe(false);
  });

  it('are the same with kernels and without, and after a restore', () => {
    const worlds = [undefined, simdKernels].map((kernels) => {
      const world = createWorld({ gravity: [0, 3], state: worldState, kernels });
      for (const [i, kind] of ['weld', 'point', 'line', 'custom'].entries()) star(world, kind, 5 + i, 2);
      return world;
    });
    const [plain, simd] = worlds as [World, World];
    for (let i = 0; i < 60; i += 1) {
      const snapshot = plain.snapshot();
      plain.step(DT);
      plain.step(DT);
      plain.restore(snapshot);
      plain.step(DT);
      simd.step(DT);
      expect(plain.hash()).toBe(simd.hash());
    }
  });

  it('of a Ferris wheel hang still', () => {
    for (const [count, radius] of [
      [6, 1.5],
      [8, 2],
    ] as const) {
      const world = phys2D.createWorld();
      const make = (position: [number, number]): RigidBody => {
        const body = phys2D.createRigidBody({ position, shapes: [box(0.5, 0.5, { mask: 0 })] });
        world.addRigidBody(body);
        return body;
      };
      const hub = make([0, 0]);
      const bodyA = phys2D.createRigidBody({ type: 'static' });
      world.addConstraint(phys2D.createPointConstraint({ bodyA, bodyB: hub }));
      for (let i = 0; i < count; i += 1) {
        const angle = (2 * Math.PI * i) / count;
        const anchorA: [number, number] = [radius * Math.cos(angle), radius * Math.sin(angle)];
        const bodyB = make([anchorA[0], anchorA[1] + 0.3]);
        world.addConstraint(phys2D.createPointConstraint({ bodyA: hub, bodyB, anchorA, anchorB: [0, -0.3] }));
      }
      for (let i = 0; i < 120; i += 1) world.step(DT);
      expect(Math.max(...world.rigidBodies.map((body) => Math.hypot(...body.getVelocity())))).toBeLessThan(0.05);
    }
  });

  it.each([4, 8, 16])('of %d gears lose energy to drag alone', (count) => {
    const world = phys2D.createWorld({ gravity: [0, 0], allowSleeping: false });
    const wheels = Array.from({ length: count + 1 }, (_, i) =>
      phys2D.createRigidBody({ position: [3 * i, 0], shapes: [phys2D.createCircleShape({ radius: 0.5 })] }),
    );
    for (const wheel of wheels) world.addRigidBody(wheel);
    for (const bodyB of wheels.slice(1)) {
      world.addConstraint(
        phys2D.createAngleConstraint({ bodyA: wheels[0]!, bodyB, ratio: 0.25, lowerBound: 0, upperBound: 0 }),
      );
    }
    wheels[1]!.setAngularVelocity(1);
    for (let i = 0; i < 600; i += 1) {
      world.step(DT);
      expect(Math.max(...wheels.map((wheel) => Math.abs(wheel.getAngularVelocity())))).toBeLessThan(1);
    }
  });
});

describe('short ropes', () => {
  it.each([
    [3, 0.02],
    [4, 0.02],
    [8, 0.05],
    [16, 0.1],
    [16, 0.02],
  ])('of a slack bridge of %d planks, %d m, let it swing', (count, rope) => {
    const world = phys2D.createWorld({ allowSleeping: false });
    const bank = phys2D.createRigidBody({ type: 'static' });
    const width = count + ((count + 1) * rope) / 2;
    let last = bank;
    for (let i = 0; i <= count; i += 1) {
      const isPlank = i < count;
      const shapes = [box(1, 0.2, { mask: 0 })];
      const next = isPlank ? phys2D.createRigidBody({ position: [((i + 0.5) * width) / count, 0], shapes }) : bank;
      if (isPlank) world.addRigidBody(next);
      world.addConstraint(
        phys2D.createDistanceConstraint({
          bodyA: last,
          bodyB: next,
          anchorA: last === bank ? [0, 0] : [0.5, 0],
          anchorB: isPlank ? [-0.5, 0] : [width, 0],
          upperBound: rope,
        }),
      );
      last = next;
    }
    for (let i = 0; i < 600; i += 1) {
      world.step(DT);
      // No more than what falls so deep gets.
      for (const body of world.rigidBodies)
        expect(Math.hypot(...body.getVelocity())).toBeLessThan(2 * Math.sqrt(2 * 10 * count));
    }
  });
});
