import { describe, expect, it } from 'vitest';
import { phys2D } from '../../src/index.js';
import { add, boxBody, heavy, staticBody, steps, tie } from '../conformance/setting.js';

// Bounds that are moved in each step drive pistons and lifts. What hangs on them goes as fast as they do: with all of the way in the first of several sub-steps it was flung up at so many times that.

describe('what hangs by a rope on something whose bounds are moved', () => {
  for (const [substeps, positionIterations] of [[1], [2], [4], [8], [16], [16, 40]] as const) {
    it(`goes up as fast as that, substeps ${substeps}, position iterations ${positionIterations ?? 'as usual'}`, () => {
      const world = heavy({ substeps, ...(positionIterations === undefined ? {} : { positionIterations }) });
      const trolley = boxBody(0.5, 0.5, { inertia: Infinity });
      const load = boxBody(0.8, 0.8, { position: [0, 2] });
      add(world, trolley, load);
      const axis = { axis: [0, 1] as [number, number], lowerBound: 0, upperBound: 0 };
      const line = phys2D.createLineConstraint({ bodyA: staticBody(), bodyB: trolley, ...axis });
      tie(world, line, phys2D.createDistanceConstraint({ bodyA: trolley, bodyB: load, upperBound: 2 }));
      steps(world, 60);
      for (let i = 1; i <= 60; i += 1) {
        line.setLowerBound((-2 * i) / 60);
        line.setUpperBound((-2 * i) / 60);
        steps(world, 1);
        expect(-load.getVelocity()[1]).toBeLessThan(2.1);
        expect(trolley.getPosition()[1]).toBeCloseTo((-2 * i) / 60, 2);
      }
      expect(load.getPosition()[1] - trolley.getPosition()[1]).toBeCloseTo(2, 2);
    });
  }

  it('comes to the new place of a point, an angle and a distance within the step', () => {
    const world = heavy({ gravity: [0, 0] });
    const bodies = [0, 10, 20].map((x) => boxBody(1, 1, { position: [x, 0] }));
    const [pinned, turned, kept] = bodies as [(typeof bodies)[0], (typeof bodies)[0], (typeof bodies)[0]];
    add(world, ...bodies);
    const frame = staticBody();
    const point = phys2D.createPointConstraint({ bodyA: frame, bodyB: pinned });
    const angle = phys2D.createAngleConstraint({ bodyA: frame, bodyB: turned, lowerBound: 0, upperBound: 0 });
    const distance = phys2D.createDistanceConstraint({ bodyA: frame, bodyB: kept, lowerBound: 20, upperBound: 20 });
    tie(world, point, angle, distance);
    steps(world, 2);
    point.setAnchorA([0.03, 0]);
    angle.setUpperBound(0.03);
    angle.setLowerBound(0.03);
    distance.setUpperBound(20.03);
    distance.setLowerBound(20.03);
    steps(world, 1);
    expect(pinned.getPosition()[0]).toBeCloseTo(0.03, 6);
    expect(turned.getRotation()).toBeCloseTo(0.03, 6);
    expect(kept.getPosition()[0]).toBeCloseTo(20.03, 6);
    for (const body of bodies) {
      expect(Math.hypot(...body.getVelocity())).toBeLessThan(1e-6);
      expect(Math.abs(body.getAngularVelocity())).toBeLessThan(1e-6);
    }
  });
});
