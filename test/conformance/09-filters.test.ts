import { describe, expect, it, vi } from 'vitest';
import { phys2D, type ShapeParams } from '../../src/index.js';
import { add, arbiterOf, box, disc, plainBody, steps, tie, weightless } from './setting.js';

/** Two overlapping bodies, each with one disc, in a world without gravity. */
function overlapping(first: ShapeParams, second: ShapeParams) {
  const world = weightless();
  const a = plainBody({ shapes: [disc(0.5, first)] });
  const b = plainBody({ shapes: [disc(0.5, second)], position: [0.7, 0] });
  return { world, a, b };
}

const sensor = { sensor: true };
const withSensor: [ShapeParams, ShapeParams][] = [
  [sensor, {}],
  [{}, sensor],
  [sensor, sensor],
];

/** A sensor and a disc that overlap, after one step. */
function sensed(first: ShapeParams, second: ShapeParams) {
  const { world, a, b } = overlapping(first, second);
  add(world, a, b);
  steps(world, 1);
  return { a, b, arbiter: arbiterOf(world, a, b)! };
}

describe('filters', () => {
  it('C-101 shapes interact if each has a group that the mask of the other has', () => {
    const cases: [number, number, number, number, boolean][] = [
      [2, 4, 4, 2, true],
      [2, 4, 4, 1, false],
      [1, 0, 1, 0xffffffff, false],
      [6, 4, 4, 2, true],
      [0x80000000, 1, 1, 0x80000000, true],
      [0, 0xffffffff, 1, 0xffffffff, false],
    ];
    for (const [groupA, maskA, groupB, maskB, meet] of cases) {
      for (const plain of [true, false]) {
        const first = { group: groupA, mask: maskA };
        const second = { group: groupB, mask: maskB, sensor: !plain };
        for (const swapped of [false, true]) {
          const { world, a, b } = swapped ? overlapping(second, first) : overlapping(first, second);
          add(world, a, b);
          steps(world, 1);
          expect(arbiterOf(world, a, b) !== undefined, `${groupA}/${maskA} ${groupB}/${maskB}`).toBe(meet);
        }
      }
    }
  });

  it('C-102 a sensor tells of an overlap and does nothing else', () => {
    for (const options of withSensor) {
      const { world, a, b } = overlapping(...options);
      const begin = vi.fn();
      a.shapes[0]!.addEventListener('begin', begin);
      add(world, a, b);
      a.setVelocity([1, 0]);
      b.setVelocity([0, 2]);
      steps(world, 1);
      expect(begin).toHaveBeenCalledTimes(1);
      expect([a.getVelocity(), b.getVelocity()]).toEqual([
        [1, 0],
        [0, 2],
      ]);
      expect(arbiterOf(world, a, b)!.sensor).toBe(true);
    }
  });

  it('C-103 the arbiter of a sensor has no values', () => {
    for (const options of withSensor) {
      const { arbiter } = sensed(...options);
      arbiter.setElasticity(0.5);
      arbiter.setRollingFriction(0.5);
      arbiter.setRollingFrictionFromShapes();
      arbiter.setAcceptedState(true);
      arbiter.setPersistentState(true);
      expect(arbiter.getNormal()).toEqual([0, 0]);
      expect([
        arbiter.getElasticity(),
        arbiter.getStaticFriction(),
        arbiter.getDynamicFriction(),
        arbiter.getRollingFriction(),
      ]).toEqual([undefined, undefined, undefined, undefined]);
      expect([arbiter.isStateAccepted(), arbiter.isStatePersistent()]).toEqual([false, false]);
      expect(arbiter.contacts).toEqual([]);
      expect(arbiter.getRollingImpulse()).toBe(0);
    }
  });

  it('C-104 … and gives no impulse [D-03]', () => {
    const { a, b, arbiter } = sensed(sensor, {});
    for (const body of [a, b, plainBody()]) {
      expect(arbiter.getImpulseForBody(body)).toEqual([0, 0, 0]);
    }
  });

  it('C-105 sensors meet anything but static on static, colliders need a dynamic body', () => {
    const types = ['dynamic', 'kinematic', 'static'] as const;
    for (const first of types) {
      for (const second of types) {
        for (const senses of [true, false]) {
          const world = weightless();
          const a = plainBody({ type: first, velocity: [0.1, 0], shapes: [disc(0.5, { sensor: senses })] });
          const b = plainBody({ type: second, position: [0.7, 0], shapes: [box(1, 1)] });
          const begin = vi.fn();
          a.shapes[0]!.addEventListener('begin', begin);
          add(world, a, b);
          steps(world, 2);
          const expected = senses
            ? first !== 'static' || second !== 'static'
            : first === 'dynamic' || second === 'dynamic';
          expect(begin, `${first} ${second} ${senses}`).toHaveBeenCalledTimes(expected ? 1 : 0);
          expect(a.shapes[0]!.arbiters, `${first} ${second} ${senses}`).toHaveLength(expected ? 1 : 0);
        }
      }
    }
  });

  it('C-106 a constraint keeps its bodies from interacting while it is enabled', () => {
    for (const options of [{}, sensor]) {
      const { world, a, b } = overlapping({}, options);
      add(world, a, b);
      const constraint = phys2D.createAngleConstraint({ bodyA: a, bodyB: b, ignoreInteractions: true });
      tie(world, constraint);
      steps(world, 2);
      expect(a.shapes[0]!.arbiters).toEqual([]);
      constraint.disable();
      steps(world, 1);
      expect(arbiterOf(world, a, b)!.sensor).toBe(options === sensor);
    }
  });

  it('C-106 so does every kind, and none without the option', () => {
    for (const ignoreInteractions of [true, false]) {
      for (let kind = 0; kind < 8; kind += 1) {
        const world = weightless();
        const a = plainBody();
        const b = plainBody({ position: [0.9, 0] });
        add(world, a, b);
        const bodies = { bodyA: b, bodyB: a, ignoreInteractions };
        const constraint = [
          phys2D.createPointConstraint({ ...bodies, anchorB: [0.9, 0] }),
          phys2D.createWeldConstraint({ ...bodies, anchorB: [0.9, 0] }),
          phys2D.createAngleConstraint(bodies),
          phys2D.createDistanceConstraint({ ...bodies, upperBound: 1 }),
          phys2D.createLineConstraint({ ...bodies, axis: [1, 0] }),
          phys2D.createMotorConstraint(bodies),
          phys2D.createPulleyConstraint({ ...bodies, bodyC: a, bodyD: b, upperBound: 3 }),
          phys2D.createCustomConstraint({ dimension: 1, bodies: [a, b], jacobian() {}, ignoreInteractions }),
        ][kind]!;
        tie(world, constraint);
        steps(world, 1);
        expect(arbiterOf(world, a, b) === undefined, constraint.type).toBe(ignoreInteractions);
        constraint.disable();
        steps(world, 1);
        expect(arbiterOf(world, a, b), constraint.type).toBeDefined();
      }
    }
  });

  it('a constraint that comes or goes ends or begins the interaction', () => {
    const { world, a, b } = overlapping({}, {});
    const calls: string[] = [];
    for (const type of ['begin', 'progress', 'end'] as const) {
      b.shapes[0]!.addEventListener(type, () => calls.push(type));
    }
    add(world, a, b);
    const constraint = phys2D.createMotorConstraint({ bodyA: a, bodyB: b, ignoreInteractions: true, maxForce: 0 });
    const changes: (() => unknown)[] = [
      () => world.addConstraint(constraint),
      () => constraint.disable(),
      () => constraint.enable(),
      () => world.removeConstraint(constraint),
    ];
    steps(world, 1);
    for (const change of changes) {
      change();
      a.setPosition([0, 0]);
      b.setPosition([0.7, 0]);
      steps(world, 1);
    }
    expect(calls).toEqual(['begin', 'end', 'begin', 'end', 'begin']);
  });
});
