import { describe, expect, it } from 'vitest';
import { type Constraint, phys2D, type RigidBody, type World } from '../../src/index.js';
import { seal } from '../../src/state/format.js';
import { add, addFloor, boxBody, heavy, steps, weightless } from '../conformance/setting.js';

// Worlds that differ only in what a shape or a body is to others go on differently: their hashes differ, and neither takes the state of the other.

/** A copy, of which nothing is known but its bytes. */
function copyOf(world: World): ArrayBuffer {
  return world.snapshot().slice(0);
}

describe('of a sensor', () => {
  function fallOnto(sensor: boolean): World {
    const world = heavy();
    addFloor(world, {}, { sensor });
    add(world, boxBody(1, 1, { position: [0, -3] }));
    return world;
  }

  it('the hash is another one', () => {
    expect(fallOnto(true).hash()).not.toBe(fallOnto(false).hash());
    expect(fallOnto(true).hash()).toBe(fallOnto(true).hash());
  });

  it.each([true, false])('the state is refused where the shape is none, and the other way round (%s)', (sensor) => {
    const [world, other] = [fallOnto(sensor), fallOnto(!sensor)];
    steps(world, 10);
    const before = other.hash();
    expect(() => other.restore(copyOf(world))).toThrow('a shape of it is a sensor, or is none here');
    expect(other.hash()).toBe(before);
    const same = fallOnto(sensor);
    same.restore(copyOf(world));
    expect(same.hash()).toBe(world.hash());
  });
});

describe('of bodies that are exchanged in a constraint', () => {
  type Make = (a: RigidBody, b: RigidBody, c: RigidBody) => Constraint;
  const kinds: Record<string, Make> = {
    motor: (bodyA, bodyB) => phys2D.createMotorConstraint({ bodyA, bodyB, rate: 2 }),
    angle: (bodyA, bodyB) => phys2D.createAngleConstraint({ bodyA, bodyB, lowerBound: 1, upperBound: 2 }),
    distance: (bodyA, bodyB) =>
      phys2D.createDistanceConstraint({ bodyA, bodyB, anchorA: [0.4, 0.3], lowerBound: 1, upperBound: 2 }),
    line: (bodyA, bodyB) =>
      phys2D.createLineConstraint({ bodyA, bodyB, axis: [1, 0.5], lowerBound: -1, upperBound: 1 }),
    pulley: (bodyA, bodyC, bodyB) =>
      phys2D.createPulleyConstraint({ bodyA, bodyB, bodyC, bodyD: bodyB, lowerBound: 0, upperBound: 2, ratio: 3 }),
    custom: (a, b) =>
      phys2D.createCustomConstraint({
        dimension: 1,
        bodies: [a, b],
        position: () => undefined,
        jacobian: (data) => {
          for (let i = 0; i < 6; i += 1) data[i] = i === 0 ? 1 : 0;
        },
      }),
  };

  function build(make: Make, isExchanged: boolean): World {
    const world = weightless();
    const [a, b, c] = [-1, 0, 3].map((x, i) => boxBody(1, 1, { position: [x, 3 * i], velocity: [0, i] })) as [
      RigidBody,
      RigidBody,
      RigidBody,
    ];
    add(world, a, b, c);
    world.addConstraint(isExchanged ? make(b, a, c) : make(a, b, c));
    return world;
  }

  it.each(Object.entries(kinds))('%s: the hash is another one, and the state is refused', (_, make) => {
    const [world, other] = [build(make, false), build(make, true)];
    expect(world.hash()).not.toBe(other.hash());
    const before = other.hash();
    expect(() => other.restore(copyOf(world))).toThrow('a constraint of it has other bodies');
    expect(other.hash()).toBe(before);
    const same = build(make, false);
    same.restore(copyOf(world));
    expect(same.hash()).toBe(world.hash());
  });

  it('no forged state makes a body one of those of a constraint that does not use it', () => {
    const world = weightless();
    const [bodyA, bodyB, other] = [0, 3, 6].map((x) => boxBody(1, 1, { position: [x, 0] })) as [
      RigidBody,
      RigidBody,
      RigidBody,
    ];
    add(world, bodyA, bodyB, other);
    world.addConstraint(phys2D.createMotorConstraint({ bodyA, bodyB, rate: 2 }));
    world.addConstraint(phys2D.createMotorConstraint({ bodyA: bodyB, bodyB: other, rate: 1 }));
    steps(world, 3);
    const snapshot = world.snapshot();
    const hash = world.hash();
    let refused = 0;
    for (let i = 8; i < snapshot.byteLength / 4 - 3; i += 1) {
      for (const change of [-1, 1]) {
        const forged = snapshot.slice(0);
        const words = new Int32Array(forged);
        words[i]! += change;
        words[i + 1] = 0;
        // Places are told from one to the next: the next one is where it was.
        words[i + 3]! -= change;
        seal(forged);
        try {
          world.restore(forged);
        } catch (error) {
          expect(String(error)).toContain('World.restore: the snapshot');
          refused += 1;
        }
        for (const body of world.rigidBodies) {
          expect(body.constraints.filter(({ members }) => !members.includes(body))).toEqual([]);
        }
        world.restore(snapshot);
        expect(world.hash()).toBe(hash);
      }
    }
    expect(refused).toBeGreaterThan(20);
  });
});
