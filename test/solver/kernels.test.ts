import { describe, expect, it } from 'vitest';
import { type Constraint, phys2D } from '../../src/index.js';
import type { SolverData } from '../../src/solver/data.js';
import {
  ANCHORED,
  DISTANCE,
  DISTANCE_NX,
  DISTANCE_NY,
  DISTANCE_OWN,
  LINE,
} from '../../src/solver/joints/joint-layout.js';
import { finishAnchored } from '../../src/solver/joints/kernels/anchored.js';
import {
  finishBlock,
  lineariseBlock,
  pushBlock,
  solveVelocityBlock,
  warmStartBlock,
} from '../../src/solver/joints/kernels/blocks.js';
import { finishDistances, lineariseDistance, warmStartDistances } from '../../src/solver/joints/kernels/distances.js';
import { pushRun, solveVelocityRun } from '../../src/solver/joints/kernels/sweeps.js';
import { add, plainBody, staticBody, steps, tie, weightless } from '../conformance/setting.js';
import { Chance } from '../geometry/forms.js';

// The straight-line kernels do what the general one does, with the same operations in the same order; the sweeps over single rows, which round once less, in another one.

type Loop = (data: SolverData, start: number, end: number) => unknown;

/** Pairs of bodies, some of them immovable, joined by what the kernel solves: rigid, soft, limited and breaking. */
function pairs(join: (both: object) => Constraint): SolverData {
  const chance = new Chance(7);
  const random = (from: number, to: number) => chance.span(from, to);
  const world = weightless();
  for (let i = 0; i < 60; i += 1) {
    const [x, y] = [9 * (i % 8), 9 * Math.floor(i / 8)];
    const place = { position: [x, y] as const, rotation: random(-3, 3) };
    const bodyA =
      i % 5 === 4 ? staticBody(place) : plainBody({ ...place, mass: random(0.1, 9), angularVelocity: random(-4, 4) });
    const bodyB = plainBody({
      position: [x + random(-2, 2), y + random(-2, 2)],
      velocity: [random(-5, 5), random(-5, 5)],
      inertia: random(0.1, 5),
    });
    const soft = i % 3 === 1 ? { stiff: false, frequency: random(1, 9), damping: random(0, 1) } : {};
    const most = { breakUnderError: true, maxError: i % 11 === 6 ? 0.01 : 1e6 };
    const limits = i % 7 === 3 ? { maxForce: 20 } : i % 7 === 5 ? { maxForce: 1e6, breakUnderForce: true } : {};
    add(world, bodyA, bodyB);
    const anchors = { anchorA: [random(-1, 1), random(-1, 1)], anchorB: [random(-1, 1), random(-1, 1)] };
    tie(world, join({ bodyA, bodyB, ...anchors, ...soft, ...most, ...limits }));
  }
  steps(world, 2);
  expect(world.solver.joints.joints.length).toBeGreaterThan(40);
  return world.solver;
}

function each(solve: (data: SolverData, index: number) => unknown): Loop {
  return (data, start, end) => {
    for (let k = start; k < end; k += 1) solve(data, k);
  };
}

function isNear(one: number, other: number, tolerance: number): boolean {
  return one === other || Math.abs(one - other) <= tolerance * Math.max(1, Math.abs(other));
}

/** What a loop over all joints makes of the numbers of a step. */
function outcome(data: SolverData, loop: Loop): number[][] {
  const { joints } = data;
  const arrays = [data.velocity, data.motion, joints.records, joints.worst];
  const before = arrays.map((array) => array.slice());
  joints.worst.fill(0);
  for (const { start, end } of joints.runs) loop(data, start, end);
  // What is there only while a joint is solved; and the direction, which the general one leaves to the constraint.
  for (const { at, layout } of joints.joints) {
    joints.records.fill(0, at + layout.work, at + layout.work + layout.rows);
    joints.records.fill(0, at + layout.own + DISTANCE_NX, at + layout.size - DISTANCE_OWN + DISTANCE_NY + 1);
  }
  const after = arrays.map((array) => [...array]);
  for (const [i, array] of arrays.entries()) array.set(before[i]!);
  joints.broken.length = 0;
  return after;
}

/** What the general kernel does with each joint. */
const general = {
  warmStart: each((data, k) => warmStartBlock(data, k, true)),
  solveVelocity: each((data, k) => solveVelocityBlock(data, data.joints.joints[k]!)),
  linearise: each((data, k) => lineariseBlock(data, data.joints.joints[k]!)),
  push: each((data, k) => pushBlock(data, data.joints.joints[k]!)),
  finish: each((data, k) => finishBlock(data, data.joints.joints[k]!)),
};

/** The same joints, from the last to the first. */
function backwards(loop: Loop): Loop {
  return (data, start, end) => {
    for (let k = end - 1; k >= start; k -= 1) loop(data, k, k + 1);
  };
}

function inTurn(...loops: Loop[]): Loop {
  return (data, start, end) => {
    for (const loop of loops) loop(data, start, end);
  };
}

const bounds = { lowerBound: -0.5, upperBound: 0.5 };

describe.each([
  ['distances', DISTANCE, phys2D.createDistanceConstraint, { lowerBound: 0.5, upperBound: 1.5 }],
  ['distances of one length', DISTANCE, phys2D.createDistanceConstraint, { lowerBound: 1, upperBound: 1 }],
  ['lines', LINE, phys2D.createLineConstraint, { axis: [1, 2], ...bounds }],
  ['slots', LINE, phys2D.createLineConstraint, { axis: [1, 2], lowerBound: 0.5, upperBound: 0.5 }],
  ['welds', ANCHORED, phys2D.createWeldConstraint, { phase: 0.3 }],
  ['points that may break', ANCHORED, phys2D.createPointConstraint, {}],
])('%s', (_, kernel, create, options) => {
  const data = pairs((both) => create({ ...both, ...options } as never));
  const sweep = (isBack: boolean): Loop => {
    return (all, start, end) => solveVelocityRun(all, kernel, start, end, isBack);
  };
  const push = (isBack: boolean): Loop => {
    return (all, start, end) => pushRun(all, kernel, start, end, isBack);
  };
  const own: [string, Loop, Loop][] = [];
  if (kernel === DISTANCE) {
    own.push(['begin a sub-step', general.warmStart, warmStartDistances]);
    const straight = each((all, k) => lineariseDistance(all, all.joints.joints[k]!));
    own.push(['are linearised', general.linearise, straight]);
  }
  if (kernel !== LINE)
    own.push(['end a sub-step', general.finish, kernel === DISTANCE ? finishDistances : finishAnchored]);

  it('have their kernel', () => {
    const kernels = new Set(data.joints.joints.map((joint) => joint.kernel));
    expect([...kernels]).toEqual([kernel]);
  });

  it.each<[string, Loop, Loop]>([
    ...own,
    ['are swept over velocities', general.solveVelocity, sweep(false)],
    ['are swept back over velocities', backwards(general.solveVelocity), sweep(true)],
    ['are swept over positions', inTurn(general.linearise, general.push), inTurn(general.linearise, push(false))],
    [
      'are swept back over positions',
      inTurn(general.linearise, backwards(general.push)),
      inTurn(general.linearise, push(true)),
    ],
  ])('%s as by the general one', (_name, wanted, straight) => {
    data.joints.share[0] = 0.5;
    const found = outcome(data, straight);
    const expected = outcome(data, wanted);
    const tolerance = kernel === DISTANCE ? 1e-12 : 0;
    const off = found.flatMap((numbers, i) =>
      numbers.filter((number, k) => !isNear(number, expected[i]![k]!, tolerance)),
    );
    expect(off).toEqual([]);
    expect(found).not.toEqual(outcome(data, () => {}));
  });
});
