import { expect, it } from 'vitest';
import { phys2D, type RigidBody } from '../../src/index.js';
import { ANCHORED, BLOCK, DISTANCE, LINE, POINT, TURN } from '../../src/solver/joints/joint-layout.js';
import {
  linearise,
  pushRun,
  pushRunLinearly,
  pushTurnedRun,
  solveVelocityRun,
} from '../../src/solver/joints/kernels/sweeps.js';
import { add, plainBody, steps, tie, weightless } from '../conformance/setting.js';

/** A hub, whose joints of each kernel share it, so that their order counts. */
function hub() {
  const world = weightless();
  const bodyA = plainBody({ angularVelocity: 3 });
  const spokes = Array.from(
    { length: 24 },
    (_, i): RigidBody => plainBody({ position: [1 + i, 2], velocity: [i, -2] }),
  );
  add(world, bodyA, ...spokes);
  for (const [i, bodyB] of spokes.entries()) {
    const place = { bodyA, bodyB, anchorA: [i / 4, 0.5] as [number, number] };
    const kinds = [
      () => phys2D.createPointConstraint(place),
      () => phys2D.createAngleConstraint({ bodyA, bodyB, lowerBound: 0.2, upperBound: 0.3, ratio: 1 + i / 8 }),
      () => phys2D.createDistanceConstraint({ ...place, lowerBound: 1, upperBound: 2 }),
      () => phys2D.createWeldConstraint(place),
      () => phys2D.createLineConstraint({ ...place, axis: [1, 2], lowerBound: -1, upperBound: 1 }),
      () => phys2D.createPulleyConstraint({ ...place, bodyC: bodyA, bodyD: spokes[0]!, upperBound: 2 }),
    ];
    tie(world, kinds[Math.floor(i / 4)]!());
  }
  steps(world, 2);
  return world.solver;
}

it.each([
  ['velocities', solveVelocityRun],
  ['positions, exactly', pushRun],
  ['positions, linearly', pushRunLinearly],
  ['positions, as they have turned', pushTurnedRun],
])('a sweep back over %s is over the joints one by one, from the last to the first', (_, solve) => {
  const data = hub();
  const { joints } = data;
  linearise(data, joints.groups[0]!, false);
  const arrays = [data.velocity, data.motion, data.points, joints.records];
  const before = arrays.map((array) => array.slice());
  const outcome = (sweep: (kernel: number, start: number, end: number) => boolean) => {
    for (const [i, array] of arrays.entries()) array.set(before[i]!);
    const found = joints.runs.map(({ kernel, start, end }) => sweep(kernel, start, end));
    return { found, numbers: arrays.map((array) => array.slice()) };
  };
  const back = outcome((kernel, start, end) => solve(data, kernel, start, end, true));
  const single = outcome((kernel, start, end) => {
    let found = false;
    for (let k = end - 1; k >= start; k -= 1) found = solve(data, kernel, k, k + 1, false) || found;
    return found;
  });
  const forth = outcome((kernel, start, end) => solve(data, kernel, start, end, false));
  expect(joints.runs.map(({ kernel }) => kernel).sort()).toEqual([POINT, TURN, DISTANCE, LINE, ANCHORED, BLOCK]);
  expect(back).toEqual(single);
  expect(back.numbers).not.toEqual(forth.numbers);
});
