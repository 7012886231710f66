import { describe, expect, it } from 'vitest';
import { phys2D } from '../../src/index.js';
import { add, box, disc, plainBody, weightless } from '../conformance/setting.js';

// Arrays that results are written into: what cannot hold them is refused, and nothing is written anywhere.

function stage() {
  const world = weightless();
  const [a, b] = [plainBody(), plainBody({ position: [3, 0] })];
  add(world, a, b);
  world.step(1 / 60);
  return { world, a, b, utils: phys2D.createCollisionUtils() };
}

const frozen = Object.freeze([0, 0, 0, 0]) as unknown as number[];
const short = new Float32Array(1);
const shut = Object.preventExtensions([0]);
const BAD = [null, 5, 'text', frozen, short, shut, new BigInt64Array(4)] as unknown as number[][];

describe('a destination for numbers', () => {
  const { world, a, b, utils } = stage();
  const constraint = phys2D.createPointConstraint({ bodyA: a, bodyB: b });
  const line = phys2D.createLineConstraint({ bodyA: a, bodyB: b, axis: [1, 0], lowerBound: 0, upperBound: 1 });

  it.each<[string, string, (dst: number[]) => unknown]>([
    ['World.getGravity', 'dst', (dst) => world.getGravity(dst)],
    ['RigidBody.getPosition', 'dst', (dst) => a.getPosition(dst)],
    ['RigidBody.getVelocity', 'dst', (dst) => a.getVelocity(dst)],
    ['RigidBody.transformWorldPointToLocal', 'dst', (dst) => a.transformWorldPointToLocal([1, 2], dst)],
    ['RigidBody.transformWorldVectorToLocal', 'dst', (dst) => a.transformWorldVectorToLocal([1, 2], dst)],
    ['RigidBody.transformLocalPointToWorld', 'dst', (dst) => a.transformLocalPointToWorld([1, 2], dst)],
    ['RigidBody.transformLocalVectorToWorld', 'dst', (dst) => a.transformLocalVectorToWorld([1, 2], dst)],
    ['RigidBody.computeLocalCenterOfMass', 'dst', (dst) => a.computeLocalCenterOfMass(dst)],
    ['RigidBody.computeWorldBounds', 'dst', (dst) => a.computeWorldBounds(dst)],
    ['Circle.computeCenterOfMass', 'dst', (dst) => disc(1).computeCenterOfMass(dst)],
    ['Polygon.computeCenterOfMass', 'dst', (dst) => box(1, 1).computeCenterOfMass(dst)],
    ['PointConstraint.getAnchorA', 'dst', (dst) => constraint.getAnchorA(dst)],
    ['Constraint.getImpulseForBody', 'dst', (dst) => constraint.getImpulseForBody(a, dst)],
    ['LineConstraint.getAxis', 'dst', (dst) => line.getAxis(dst)],
    ['CollisionUtils.signedDistance', 'axis', (dst) => utils.signedDistance(a.shapes[0]!, b.shapes[0]!, [], [], dst)],
  ])('%s refuses what cannot hold them', (where, name, call) => {
    for (const bad of BAD) {
      expect(() => call(bad)).toThrow(TypeError);
      expect(() => call(bad)).toThrow(
        new RegExp(`^${where}: ${name} must be an array to write [234] numbers into, got `),
      );
    }
    expect(() => call([])).not.toThrow();
    expect(() => call(new Float64Array(4) as unknown as number[])).not.toThrow();
    expect(short[0]).toBe(0);
  });

  it('is not written to if another one is refused', () => {
    const witness = [7, 7];
    expect(() => utils.signedDistance(a.shapes[0]!, b.shapes[0]!, witness, witness, frozen)).toThrow('axis');
    expect(witness).toEqual([7, 7]);
  });
});

it('a store for objects is an array that can be written to', () => {
  const { world } = stage();
  for (const bad of [...BAD, new Float64Array(9)] as never[]) {
    expect(() => world.shapePointQuery([0, 0], bad)).toThrow(
      /^World\.shapePointQuery: store must be an array to write into, got /,
    );
  }
});

it('handles and objects are refused by the function that was called', () => {
  const tree = phys2D.createBoxTreeBroadphase();
  for (const broadphase of [tree, phys2D.createSweepAndPruneBroadphase()]) {
    const insert = () => broadphase.insert(null, [0, 0, 1, 1], false, {}, { group: 'a', mask: 1 } as never);
    expect(insert).toThrow(
      /^(?:BoxTreeBroadphase|SweepAndPrune)\.insert: filter must be an object with the numbers group and mask/,
    );
  }
});
