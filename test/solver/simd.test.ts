import { readFileSync } from 'node:fs';
import { array, assert, constantFrom, double, integer, oneof, property, record, uniqueArray } from 'fast-check';
import { afterEach, describe, expect, it, vi } from 'vitest';
import { compile } from '../../simd/build.mjs';
import { bringPolygons } from '../../src/collide/polygon-works.js';
import { PUSH_SHARE_CIRCLES, PUSH_SHARE_DYNAMIC, PUSH_SHARE_HOOKED } from '../../src/config.js';
import { createCustomConstraint, createWorld, phys2D, simdKernels, type World, worldState } from '../../src/index.js';
import { type Kernels, plainKernels } from '../../src/kernels.js';
import { recordAt, SolverData } from '../../src/solver/data.js';
import { advance, integratePositions, integrateVelocities } from '../../src/solver/integrate.js';
import { Group, JointData } from '../../src/solver/joints/joint-data.js';
import {
  ANCHOR_AX,
  ANCHOR_AY,
  ANCHOR_BX,
  ANCHOR_BY,
  BlockLayout,
  POINT,
  POINT_SNAPS,
  POINT_STRIDE,
} from '../../src/solver/joints/joint-layout.js';
import {
  finishPoints,
  pushPoints,
  pushPointsLinearly,
  solveVelocityPoints,
  warmStartPoints,
} from '../../src/solver/joints/kernels/points.js';
import { advancePoses } from '../../src/solver/joints/kernels/pose.js';
import { addJoint, allot } from '../../src/solver/joints/order/runs.js';
import * as d from '../../src/solver/layout.js';
import { type Loops, plain } from '../../src/solver/loops.js';
import { polygonWorks } from '../../src/solver/polygons.js';
import { DT, plainBody } from '../conformance/setting.js';
import { buildJointGrid } from '../scenes/joint-grid.js';
import { buildMixed } from '../scenes/mixed.js';
import { buildPyramid } from '../scenes/pyramid.js';

// As the first polygon would: contacts of two points come with it.
bringPolygons(polygonWorks);

afterEach(() => {
  vi.unstubAllGlobals();
  vi.resetModules();
});

describe('the kernels in WebAssembly', () => {
  it('are there', () => {
    expect(simdKernels.isSupported()).toBe(true);
    expect(plainKernels.isSupported()).toBe(false);
  });

  it('are compiled of what `simd` has', async () => {
    expect(readFileSync(new URL('../../src/solver/simd-code.ts', import.meta.url), 'utf8')).toBe(await compile());
  });
});

/** What a contact of a random list is. */
interface Drawn {
  readonly a: number;
  readonly b: number;
  readonly numbers: readonly number[];
  readonly share: number;
}

const BODIES = 9;

/** A number as records may have, zeros of both signs often. */
const value = oneof(constantFrom(0, -0, 1, 0.25), double({ min: -2, max: 2, noNaN: true }));

const contact = record({
  a: integer({ min: 0, max: BODIES - 1 }),
  b: integer({ min: 1, max: BODIES - 1 }),
  numbers: array(value, { minLength: d.TWO_STRIDE, maxLength: d.TWO_STRIDE }),
  share: constantFrom(PUSH_SHARE_HOOKED, PUSH_SHARE_CIRCLES, PUSH_SHARE_DYNAMIC),
});

/** Arrays of a solver that are filled with what was drawn. */
function filled(kernels: Kernels, drawn: readonly Drawn[], bodies: readonly number[]): SolverData {
  const data = new SolverData(new JointData(), kernels);
  data.resetBodies(BODIES);
  data.velocity.set(bodies);
  data.velocity.fill(0, 0, d.BODY_STRIDE);
  data.motion.set([...bodies].reverse());
  data.motion.fill(0, 0, d.BODY_STRIDE);
  for (const { a, b, numbers, share } of drawn) {
    for (const batch of [data.one, data.two]) {
      const index = batch.add({} as never);
      const at = recordAt(index, batch.stride);
      for (let k = 0; k < batch.stride; k += 1) {
        batch.records[at + 2 * k] = numbers[k]!;
      }
      batch.records[at + d.SHARE] = share;
      // As they always are: impulses push, and no mass is negative or 0 that is divided by.
      const positive = [
        d.NORMAL1,
        d.FRICTION,
        d.TANGENT_MASS,
        ...(batch === data.two ? [d.NORMAL2, d.K11, d.K22] : []),
      ];
      for (const field of positive) {
        batch.records[at + field] = Math.abs(batch.records[at + field]!);
      }
      if (batch === data.two) {
        batch.records[at + d.K11]! += 0.5;
        batch.records[at + d.K22]! += 0.5;
      } else {
        batch.records[at + d.ROLL_FRICTION] = Math.abs(batch.records[at + d.ROLL_FRICTION]!);
      }
      const [first, second] = [a * d.BODY_STRIDE, (b === a ? 0 : b) * d.BODY_STRIDE];
      const before = index % 2 === 1 ? [batch.bodies[2 * index - 2]!, batch.bodies[2 * index - 1]!] : [];
      const waits = [first, second].some((offset) => offset !== 0 && before.includes(offset));
      batch.bodies[2 * index] = waits ? first | d.WAITS : first;
      batch.bodies[2 * index + 1] = second;
    }
  }
  return data;
}

const LOOPS = [
  'warmStartOne',
  'warmStartTwo',
  'solveVelocityOne',
  'solveVelocityTwo',
  'solvePositionOne',
  'solvePositionTwo',
] as const satisfies readonly (keyof Loops)[];

describe.each(LOOPS)('%s', (loop) => {
  it('does the same in WebAssembly, to the bit: whatever shares a body, wherever it begins and ends', () => {
    assert(
      property(
        array(contact, { minLength: 1, maxLength: 40 }),
        array(value, { minLength: BODIES * d.BODY_STRIDE, maxLength: BODIES * d.BODY_STRIDE }),
        uniqueArray(integer({ min: 0, max: 40 }), { minLength: 2, maxLength: 2 }),
        constantFrom(1 / 240, 1e-3),
        (drawn, bodies, ends, h) => {
          // Warm starts are for all contacts.
          const range = loop.startsWith('warm') ? [0, drawn.length] : ends.map((end) => Math.min(end, drawn.length));
          const [from, to] = range.sort((x, y) => x - y) as [number, number];
          const [expected, found] = [plainKernels, simdKernels].map((kernels) => {
            const data = filled(kernels, drawn, bodies);
            const result = data.loops![loop](data, from, to, h);
            const { velocity, motion, one, two, deepCircles } = data;
            const count = drawn.length;
            const records = [one, two].flatMap(({ records: r, stride }) =>
              Array.from({ length: count }, (_, k) =>
                Array.from({ length: stride }, (_, n) => r[recordAt(k, stride) + 2 * n]),
              ),
            );
            data.returnArrays();
            return { result, velocity: velocity.slice(), motion: motion.slice(), records, deepCircles };
          });
          // `toEqual` tells −0 from 0.
          expect(found).toEqual(expected);
        },
      ),
      { numRuns: 150 },
    );
  });
});

/** A number of a body: most are small, some have no end. */
const ofBody = oneof({ weight: 30, arbitrary: value }, constantFrom(0.3, -0.3, 7, 2e6, -2e6, Infinity, Number.NaN));

describe.each<[string, (data: SolverData, h: number) => void]>([
  ['integrateVelocities', integrateVelocities],
  ['integratePositions', integratePositions],
  ['advance', advance],
  ['advancePoses', advancePoses],
])('%s', (_, loop) => {
  it('does the same in WebAssembly, to the bit: whatever turns far, is touched, or has no end', () => {
    const size = BODIES * d.BODY_STRIDE;
    const numbers = array(ofBody, { minLength: size, maxLength: size });
    assert(
      property(
        numbers,
        numbers,
        numbers,
        array(constantFrom(0, 1), { minLength: BODIES, maxLength: BODIES }),
        constantFrom(0.01, 0.1, 1),
        constantFrom(1 / 240, 1 / 60),
        (velocity, motion, drive, touched, turns, h) => {
          const [expected, found] = [plainKernels, simdKernels].map((kernels) => {
            const data = new SolverData(new JointData(), kernels);
            data.resetBodies(BODIES);
            data.joints.h = h;
            data.velocity.set(velocity);
            data.motion.set(motion);
            data.pose.set([...motion].reverse());
            data.drive.set(drive);
            for (let k = 0; k < BODIES; k += 1) {
              const at = k * d.BODY_STRIDE;
              data.drive[at + d.TOUCHED] = touched[k]!;
              for (const n of [d.QW, d.DW]) data.motion[at + n]! *= turns;
              // Such as rest damping sees.
              if (turns < 0.1) for (const n of [d.VX, d.VY, d.W]) data.velocity[at + n]! *= 0.005;
            }
            loop(data, h);
            const arrays = [data.velocity, data.motion, data.pose, data.drive].map((numbers) => numbers.slice());
            data.returnArrays();
            return arrays;
          });
          expect(found).toEqual(expected);
        },
      ),
      { numRuns: 300 },
    );
  });
});

/** What a rigid point joint of a random list is. */
interface DrawnPoint {
  readonly a: number;
  readonly b: number;
  readonly numbers: readonly number[];
  readonly snaps: number;
}

/** So many that few neighbours share one. */
const JOINED = 40;

const point = record({
  a: integer({ min: 0, max: JOINED - 1 }),
  b: integer({ min: 0, max: JOINED - 1 }),
  numbers: array(value, { minLength: POINT_STRIDE, maxLength: POINT_STRIDE }),
  snaps: constantFrom(0, 0, 0, 1),
});

/** Arrays of a solver with joints that were drawn; joints between a body and itself there are none. Slot 0 cannot move. */
function filledWithPoints(kernels: Kernels, drawn: readonly DrawnPoint[], numbers: readonly number[]): SolverData {
  const data = new SolverData(new JointData(), kernels);
  const bodies = Array.from({ length: JOINED }, plainBody);
  data.joints.groups.push(new Group(0));
  for (const { a, b } of drawn) {
    const constraint = phys2D.createPointConstraint({
      bodyA: bodies[a]!,
      bodyB: bodies[a === b ? (b + 1) % JOINED : b]!,
    });
    addJoint(data.joints, constraint, POINT, new BlockLayout(2, 2));
  }
  allot(data.joints);
  data.resetBodies(JOINED);
  data.makeRoomForPoints(data.joints.slots);
  for (let i = 1; i < JOINED; i += 1) {
    const at = i * d.BODY_STRIDE;
    for (let n = 0; n < d.BODY_STRIDE; n += 1) {
      data.velocity[at + n] = numbers[at + n]!;
      data.motion[at + n] = numbers[at + n]!;
      data.pose[at + n] = numbers[at + n]!;
    }
    // Most turns are small, and no mass is negative.
    data.motion[at + d.QW]! *= 0.11;
    for (const n of [d.INV_MASS, d.INV_INERTIA]) {
      data.velocity[at + n] = Math.abs(numbers[at + n]!);
      data.motion[at + n] = Math.abs(numbers[at + n]!);
    }
  }
  data.pointBodies.fill(0);
  for (const [k, { slot }] of data.joints.joints.entries()) {
    const { a, b, numbers: ofPoint, snaps } = drawn[k]!;
    const at = recordAt(slot, POINT_STRIDE);
    for (let n = 0; n < POINT_STRIDE; n += 1) {
      data.points[at + 2 * n] = ofPoint[n]!;
    }
    data.points[at + POINT_SNAPS] = snaps;
    data.pointBodies[2 * slot] = a * d.BODY_STRIDE;
    data.pointBodies[2 * slot + 1] = (a === b ? (b + 1) % JOINED : b) * d.BODY_STRIDE;
    if (slot % 2 === 0) {
      data.pointBodies[2 * slot + 2] = d.MISSING;
      for (const n of [ANCHOR_AX, ANCHOR_AY, ANCHOR_BX, ANCHOR_BY]) data.points[at + 1 + n] = 0;
    }
  }
  return data;
}

describe.each([
  ['warmStartPoints', warmStartPoints],
  ['solveVelocityPoints', solveVelocityPoints],
  ['pushPoints', pushPoints],
  ['pushPointsLinearly', pushPointsLinearly],
  ['finishPoints', finishPoints],
])('%s', (name, loop) => {
  it('does the same in WebAssembly, to the bit: whatever is rare, wherever it begins and ends', () => {
    let paired = 0;
    assert(
      property(
        array(point, { minLength: 1, maxLength: 60, size: 'max' }),
        array(value, { minLength: JOINED * d.BODY_STRIDE, maxLength: JOINED * d.BODY_STRIDE }),
        uniqueArray(integer({ min: 0, max: 60 }), { minLength: 2, maxLength: 2 }),
        double({ min: 0, max: 1, noNaN: true }),
        (drawn, bodies, ends, share) => {
          const isWhole = name === 'warmStartPoints' || name === 'finishPoints';
          const range = isWhole ? [0, drawn.length] : ends.map((end) => Math.min(end, drawn.length));
          const [from, to] = range.sort((x, y) => x - y) as [number, number];
          if (from === to) return;
          const [expected, found] = [plainKernels, simdKernels].map((kernels) => {
            const data = filledWithPoints(kernels, drawn, bodies);
            data.joints.worst[0] = share;
            data.joints.share[0] = share;
            const result = loop(data, from, to, false);
            const { velocity, motion, points, joints } = data;
            const records = joints.joints.map(({ slot }) =>
              Array.from({ length: POINT_STRIDE }, (_, n) => points[recordAt(slot, POINT_STRIDE) + 2 * n]),
            );
            paired += joints.joints[0]!.isPaired ? 1 : 0;
            data.returnArrays();
            return { result, velocity: velocity.slice(), motion: motion.slice(), records, worst: joints.worst.slice() };
          });
          expect(found).toEqual(expected);
        },
      ),
      { numRuns: 150 },
    );
    expect(paired).toBeGreaterThan(50);
  });
});

/** Runs a scene twice, and compares. */
function expectSame(build: (world: World) => void, steps: number): void {
  const worlds = [plainKernels, simdKernels].map((kernels) => {
    const world = createWorld({ state: worldState, kernels });
    build(world);
    return world;
  });
  for (let i = 0; i < steps; i += 1) {
    for (const world of worlds) world.step(DT);
    expect(worlds[1]!.hash()).toBe(worlds[0]!.hash());
  }
}

describe('a world with kernels in WebAssembly', () => {
  it('is the same to the bit, step by step: a mixed heap', () => {
    expectSame((world) => buildMixed(phys2D, world, 120, 7), 240);
  });

  it('is the same to the bit, step by step: a pyramid that its arrays have to grow for', () => {
    expectSame((world) => buildPyramid(phys2D, world, 20), 60);
  });

  it('is the same to the bit, step by step: a net that is torn at, and a wheel on it that spins', () => {
    expectSame((world) => {
      const { bodies } = buildJointGrid(phys2D, world, 12);
      bodies[40]!.setAngularVelocity(100);
      bodies[100]!.setVelocity([30, 20]);
    }, 180);
  });

  it('is what `phys2D` makes, and the function `createWorld` only if it is told', () => {
    const loops = [phys2D.createWorld(), createWorld(), createWorld({ kernels: simdKernels })].map((world) => {
      world.addRigidBody(plainBody());
      world.step(DT);
      return world.solver.loops === plain ? 'plain' : 'simd';
    });
    expect(loops).toEqual(['simd', 'plain', 'simd']);
  });

  it.each([
    ['there is none', undefined],
    [
      'it is not allowed',
      {
        Module: class {
          constructor() {
            throw new Error('violates the Content Security Policy');
          }
        },
      },
    ],
  ])('does without where %s', async (_, stub) => {
    vi.resetModules();
    vi.stubGlobal('WebAssembly', stub);
    const { phys2D: other, simdKernels: others } = await import('../../src/index.js');
    expect(others.isSupported()).toBe(false);
    const [world, same] = [other.createWorld(), phys2D.createWorld()];
    buildPyramid(other, world, 5);
    buildPyramid(phys2D, same, 5);
    for (let i = 0; i < 30; i += 1) {
      world.step(DT);
      same.step(DT);
    }
    expect(world.hash()).toBe(same.hash());
  });
});

/** Callbacks of a constraint that keeps one body from turning. */
const still = {
  position: (data: { [index: number]: number }, index: number) => {
    data[index] = 0;
  },
  jacobian: (data: { [index: number]: number }, index: number) => {
    data[index] = 0;
    data[index + 1] = 0;
    data[index + 2] = 1;
  },
};

describe.each([
  ['in WebAssembly', simdKernels],
  ['in plain TypeScript', plainKernels],
])('worlds that share arrays, %s', (_, kernels) => {
  function pyramid(base: number): World {
    const world = createWorld({ state: worldState, kernels });
    buildPyramid(phys2D, world, base);
    return world;
  }

  /** The hash of a pyramid of its own that did so many steps. */
  function alone(base: number, steps: number): string {
    const world = pyramid(base);
    for (let i = 0; i < steps; i += 1) world.step(DT);
    return world.hash();
  }

  it('do not notice: by turns, one of them large', () => {
    const worlds = [pyramid(3), pyramid(12), pyramid(4)];
    for (let i = 0; i < 20; i += 1) {
      for (const world of worlds) world.step(DT);
    }
    expect(worlds.map((world) => world.hash())).toEqual([alone(3, 20), alone(12, 20), alone(4, 20)]);
  });

  it('do not notice: one steps within a step of the other', () => {
    const inner = pyramid(6);
    const results = [true, false].map((steps) => {
      const outer = pyramid(5);
      let calls = 0;
      const probe = createCustomConstraint({
        bodies: [outer.rigidBodies[1]!],
        dimension: 1,
        positionConstants: () => {
          calls += 1;
          if (steps && calls % 7 === 0) inner.step(DT);
        },
        ...still,
      });
      outer.addConstraint(probe);
      for (let i = 0; i < 10; i += 1) outer.step(DT);
      return outer.hash();
    });
    expect(results[0]).toBe(results[1]);
    expect(inner.timeStamp).toBeGreaterThan(5);
    expect(inner.hash()).toBe(alone(6, inner.timeStamp));
  });

  it('do not notice: one of them throws in the middle of a step', () => {
    const broken = pyramid(5);
    let isBroken = true;
    broken.addConstraint(
      createCustomConstraint({
        bodies: [broken.rigidBodies[1]!],
        dimension: 1,
        positionConstants: () => {
          if (isBroken) throw new Error('in the middle');
        },
        ...still,
      }),
    );
    const others = [pyramid(5), pyramid(4)];
    for (let i = 0; i < 10; i += 1) {
      expect(() => broken.step(DT)).toThrow('in the middle');
      for (const world of others) world.step(DT);
    }
    isBroken = false;
    broken.step(DT);
    expect(others.map((world) => world.hash())).toEqual([alone(5, 10), alone(4, 10)]);
  });
});
