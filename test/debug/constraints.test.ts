import { describe, expect, it } from 'vitest';
import type { Physics2DDebugDraw } from '../../src/debug/index.js';
import { type Constraint, type CustomConstraint, phys2D, type RigidBody, type Vec2 } from '../../src/index.js';
import { near, staticBody, tie, weightless } from '../conformance/setting.js';
import { draw, polyline, RED, runs, type Segment } from './recorder.js';

/** m per px. */
const PX = 1 / 60;

const COLOR = {
  A: [1, 0, 0, 0.8],
  B: [0, 0, 1, 0.8],
  C: [0, 1, 0, 0.8],
  D: [1, 0, 1, 0.8],
};
const ERROR = {
  A: [1, 1, 0.5, 0.8],
  B: [0.5, 1, 1, 0.8],
  C: [0.4, 1, 0.4, 0.8],
  D: [1, 0.4, 1, 0.8],
};

/** Segments of a spring, of the coils and radius that constraints have. */
const SPRING = draw((debug) => debug.drawLinearSpring(0, 0, 1, 0, 3, 3 * PX, RED)).length;

function drawn(constraint: Constraint, set: Partial<Physics2DDebugDraw> = {}): ReturnType<typeof runs> {
  return runs(
    draw((debug) => {
      Object.assign(debug, set);
      debug.drawConstraint(constraint);
    }),
  );
}

/** The nested circles of an anchor. */
function expectDot(run: ReturnType<typeof runs>[number] | undefined, color: readonly number[], [x, y]: Vec2): void {
  expect(run!.color).toEqual(color);
  const radii = [1, 0.75, 0.5, 0.25].map((part) => part * 3 * PX);
  const circles = radii.map((radius) => draw((debug) => debug.drawCircle(x, y, radius, RED)));
  near(
    run!.segments.flatMap(({ ends }) => ends),
    circles.flat().flatMap(({ ends }) => ends),
    1e-12,
  );
}

function expectLine(
  run: ReturnType<typeof runs>[number] | undefined,
  color: readonly number[],
  ...lines: number[][]
): void {
  expect(run!.color).toEqual(color);
  near(
    run!.segments.slice(0, lines.length).flatMap(({ ends }) => ends),
    lines.flat(),
    1e-9,
  );
}

/** First and last point of segments. */
function endsOf(segments: readonly Segment[]): number[] {
  const points = polyline(segments);
  return [...points[0]!, ...points.at(-1)!];
}

const at = (position: Vec2, rotation = 0): RigidBody => phys2D.createRigidBody({ position, rotation });

describe('point constraints', () => {
  const bodies = () => ({ bodyA: at([2, 2], Math.PI / 2), bodyB: at([5, 2]), anchorA: [1, 0], anchorB: [0, 1] });

  it('are both anchors and a line between them', () => {
    const found = drawn(phys2D.createPointConstraint(bodies()));
    expect(found).toHaveLength(3);
    expectDot(found[0], COLOR.A, [2, 3]);
    expectDot(found[1], COLOR.B, [5, 3]);
    expectLine(found[2], ERROR.C, [2, 3, 5, 3]);
    expect(found[2]!.segments).toHaveLength(1);
  });

  it('that are elastic have a spring', () => {
    const found = drawn(phys2D.createPointConstraint({ ...bodies(), stiff: false }));
    expect(found).toHaveLength(3);
    expect(found[2]!.color).toEqual(ERROR.C);
    expect(found[2]!.segments).toEqual(draw((debug) => debug.drawLinearSpring(2, 3, 5, 3, 3, 3 * PX, ERROR.C)));
  });

  it('use the settings', () => {
    const constraint = phys2D.createPointConstraint({ ...bodies(), stiff: false });
    const found = drawn(constraint, {
      constraintAnchorRadius: 60,
      constraintSpringRadius: 30,
      constraintSpringNumCoils: 5,
      constraintColorA: [0, 0, 0, 1],
      constraintErrorColorC: [1, 1, 1, 1],
    });
    expect(found[0]!.color).toEqual([0, 0, 0, 1]);
    near(Math.max(...polyline(found[0]!.segments.slice(0, 5)).map(([x]) => x)), 3, 1e-12);
    expect(found[2]!.segments).toEqual(draw((debug) => debug.drawLinearSpring(2, 3, 5, 3, 5, 0.5, [1, 1, 1, 1])));
  });

  it('that sleep have other colours', () => {
    const found = drawn(phys2D.createPointConstraint({ ...bodies(), sleeping: true }));
    expect(found.map(({ color }) => color)).toEqual([
      [0.7, 0.2, 0.2, 0.6],
      [0.2, 0.2, 0.7, 0.6],
      [0.4, 0.7, 0.4, 0.6],
    ]);
  });
});

describe('weld constraints', () => {
  const bodies = () => ({ bodyA: at([2, 2], 0.2), bodyB: at([5, 2], 1.5), phase: 0.3 });

  it('are drawn as points if stiff', () => {
    const found = drawn(phys2D.createWeldConstraint(bodies()));
    expect(found).toHaveLength(3);
    expectLine(found[2], ERROR.C, [2, 2, 5, 2]);
  });

  it('that are elastic turn each body with a spiral spring to where the other wants it', () => {
    const found = drawn(phys2D.createWeldConstraint({ ...bodies(), stiff: false }));
    expect(found.map(({ color }) => color)).toEqual([COLOR.A, COLOR.B, ERROR.C, ERROR.A, ERROR.B]);
    const radius = (angle: number): number => (10 + (2.5 / Math.PI) * angle) * PX;
    const spring = (x: number, from: number, to: number, color: readonly number[]) =>
      draw((debug) => debug.drawSpiralSpring(x, 2, from, to, radius(0), radius(to - from), 4, color));
    const expected = [...spring(2, 0.2, 1.2, ERROR.A), ...spring(5, 0.5, 1.5, ERROR.B)];
    near(
      [...found[3]!.segments, ...found[4]!.segments].flatMap(({ ends }) => ends),
      expected.flatMap(({ ends }) => ends),
      1e-12,
    );
  });
});

describe('distance constraints', () => {
  const rope = (params: object, x = 6) =>
    drawn(
      phys2D.createDistanceConstraint({
        bodyA: at([2, 2]),
        bodyB: at([x, 2]),
        lowerBound: 2,
        upperBound: 3,
        ...params,
      }),
    );

  it('are a line of the lower bound half-way, and what the upper adds on both sides', () => {
    const found = rope({});
    expectDot(found[0], COLOR.A, [2, 2]);
    expectDot(found[1], COLOR.B, [6, 2]);
    expectLine(found[2], ERROR.A, [3, 2, 5, 2]);
    expectLine(found[3], ERROR.B, [3, 2, 2.5, 2], [5, 2, 5.5, 2]);
    expect(found.map(({ segments }) => segments.length).slice(2)).toEqual([1, 2]);
  });

  it('without an upper bound have no second part', () => {
    expect(rope({ upperBound: Infinity })).toHaveLength(3);
  });

  it('that are elastic have springs to the anchors if they are too long or too short, and none between', () => {
    const long = rope({ stiff: false });
    expect(long[3]!.segments).toHaveLength(2 + 2 * SPRING);
    near(endsOf(long[3]!.segments.slice(2, 2 + SPRING)), [2.5, 2, 2, 2], 1e-12);
    near(endsOf(long[3]!.segments.slice(2 + SPRING)), [5.5, 2, 6, 2], 1e-12);
    const short = rope({ stiff: false }, 3);
    expect(short.map(({ segments }) => segments.length).slice(2)).toEqual([1 + 2 * SPRING, 2]);
    near(endsOf(short[2]!.segments.slice(1, 1 + SPRING)), [1.5, 2, 2, 2], 1e-12);
    const slack = rope({ stiff: false }, 4.5);
    expect(slack.map(({ segments }) => segments.length).slice(2)).toEqual([1, 2]);
  });

  it('of anchors in one place lie along x', () => {
    const found = rope({}, 2);
    expectLine(found[2], ERROR.A, [1, 2, 3, 2]);
  });
});

describe('pulley constraints', () => {
  const pulley = (params: object) =>
    drawn(
      phys2D.createPulleyConstraint({
        bodyA: at([0, 2]),
        bodyB: at([0, 0]),
        bodyC: at([3, 0]),
        bodyD: at([3, 1]),
        lowerBound: 2,
        upperBound: 5,
        ...params,
      }),
    );

  it('are two links, each with the bounds that the other leaves', () => {
    const found = pulley({ ratio: 2 });
    expect(found.slice(0, 4).map(({ color }) => color)).toEqual([COLOR.A, COLOR.B, COLOR.C, COLOR.D]);
    // The first is 2 m long and may have 0 to 3, the second 1 m and may have 0 to 1.5.
    expectLine(found[4], ERROR.A, [0, 1, 0, 1]);
    expectLine(found[5], ERROR.B, [0, 1, 0, 2.5], [0, 1, 0, -0.5]);
    expectLine(found[6], ERROR.C, [3, 0.5, 3, 0.5]);
    expectLine(found[7], ERROR.D, [3, 0.5, 3, -0.25], [3, 0.5, 3, 1.25]);
  });

  it('take a negative ratio the other way round', () => {
    const found = pulley({ ratio: -1, lowerBound: -4, upperBound: 0.5 });
    // 2 - length in [-4, 0.5], and length - 1 in [-4, 0.5] for the first.
    expectLine(found[4], ERROR.A, [0, 1, 0, 1]);
    expectLine(found[5], ERROR.B, [0, 1, 0, 1.75], [0, 1, 0, 0.25]);
    expectLine(found[6], ERROR.C, [3, -0.25, 3, 1.25]);
    expectLine(found[7], ERROR.D, [3, -0.25, 3, -2.5], [3, 1.25, 3, 3.5]);
  });

  it('that are elastic have springs in both links', () => {
    const found = pulley({ stiff: false, lowerBound: 0, upperBound: 2.5 });
    expect(found.map(({ segments }) => segments.length).slice(4)).toEqual([1, 2 + 2 * SPRING, 1, 2 + 2 * SPRING]);
    expectLine(found[5], ERROR.B, [0, 1, 0, 1.75], [0, 1, 0, 0.25]);
    near(endsOf(found[5]!.segments.slice(2, 2 + SPRING)), [0, 1.75, 0, 2], 1e-12);
  });
});

describe('line constraints', () => {
  const line = (params: object, position: Vec2 = [4, 3]) =>
    drawn(
      phys2D.createLineConstraint({
        bodyA: at([1, 1], Math.PI / 2),
        bodyB: at(position),
        anchorA: [1, 0],
        axis: [0, -2],
        lowerBound: -1,
        upperBound: 5,
        ...params,
      }),
    );

  it('are the way below the point and the way above it', () => {
    const found = line({});
    expectDot(found[0], COLOR.A, [1, 2]);
    expectDot(found[1], COLOR.B, [4, 3]);
    expectLine(found[2], ERROR.A, [0, 2, 4, 2]);
    expectLine(found[3], ERROR.B, [4, 2, 6, 2]);
    expect(found).toHaveLength(4);
  });

  it('without bounds reach 1e20 m', () => {
    const found = line({ lowerBound: -Infinity, upperBound: Infinity });
    near(found[2]!.segments[0]!.ends[0] / 1e20, -1, 1e-9);
    near(found[3]!.segments[0]!.ends[2] / 1e20, 1, 1e-9);
  });

  it('that are elastic have a spring from the nearest point to the anchor', () => {
    const found = line({ stiff: false }, [9, 5]);
    expectLine(found[2], ERROR.A, [0, 2, 6, 2]);
    expectLine(found[3], ERROR.B, [6, 2, 6, 2]);
    expect(found[4]!.color).toEqual(ERROR.C);
    expect(found[4]!.segments).toHaveLength(SPRING);
    near(endsOf(found[4]!.segments), [6, 2, 9, 5], 1e-9);
  });
});

describe('angle constraints', () => {
  const radius = (angle: number): number => (10 + (2.5 / Math.PI) * angle) * PX;
  const angle = (rotationA: number, rotationB: number, params: object = {}) =>
    drawn(
      phys2D.createAngleConstraint({
        bodyA: at([2, 2], rotationA),
        bodyB: at([6, 2], rotationB),
        lowerBound: -0.5,
        upperBound: 1,
        ratio: 2,
        ...params,
      }),
    );

  /** Points of an arc around (x, 2), and how far they are from a spiral that begins at `start`. */
  function expectArc(
    run: ReturnType<typeof runs>[number] | undefined,
    color: readonly number[],
    x: number,
    from: number,
    to: number,
    start: number,
  ) {
    expect(run!.color).toEqual(color);
    const expected = draw((debug) => debug.drawSpiral(x, 2, from, to, radius(from - start), radius(to - start), color));
    near(
      run!.segments.slice(0, expected.length).flatMap(({ ends }) => ends),
      expected.flatMap(({ ends }) => ends),
      1e-12,
    );
    return run!.segments.slice(expected.length);
  }

  it('are the range that each body has, and where in it it is', () => {
    // 2 · 0.4 − A in [−0.5, 1]: A in [−0.2, 1.3]; 2 · B − 0.3 in [−0.5, 1]: B in [−0.1, 0.65].
    const found = angle(0.3, 0.4);
    expect(found).toHaveLength(4);
    expectArc(found[0], ERROR.A, 2, -0.2, 1.3, -0.2);
    expectDot(found[1], COLOR.A, [2 + radius(0.5) * Math.cos(0.3), 2 + radius(0.5) * Math.sin(0.3)]);
    expectArc(found[2], ERROR.B, 6, -0.1, 0.65, -0.1);
    expectDot(found[3], COLOR.B, [6 + radius(0.5) * Math.cos(0.4), 2 + radius(0.5) * Math.sin(0.4)]);
  });

  it('with a negative ratio turn the range of B round', () => {
    const found = angle(0.3, 0.4, { ratio: -2 });
    expectArc(found[0], ERROR.A, 2, -1.8, -0.3, -1.8);
    expectArc(found[2], ERROR.B, 6, -0.65, 0.1, -0.65);
  });

  it('that are elastic have a spiral spring from the range to the body', () => {
    const found = angle(-3, 0, { stiff: false });
    // A in [−1, 0.5], and is at −3: the spiral begins there.
    const rest = expectArc(found[0], ERROR.A, 2, -1, 0.5, -3);
    const spring = draw((debug) => debug.drawSpiralSpring(2, 2, -1, -3, radius(2), radius(0), 4, ERROR.A));
    near(
      rest.flatMap(({ ends }) => ends),
      spring.flatMap(({ ends }) => ends),
      1e-12,
    );
    expect(angle(-3, 0)[0]!.segments).toHaveLength(found[0]!.segments.length - spring.length);
    expect(expectArc(angle(0, 0, { stiff: false })[0], ERROR.A, 2, -1, 0.5, -1)).toEqual([]);
  });

  it('with a single angle are dots, and without bounds show a turn beyond', () => {
    expect(angle(1, 0.5, { lowerBound: 0, upperBound: 0 }).map(({ color }) => color)).toEqual([COLOR.A, COLOR.B]);
    const open = angle(0.3, 0.4, { lowerBound: -Infinity, upperBound: Infinity });
    expectArc(open[0], ERROR.A, 2, 0.3 - 2 * Math.PI, 0.3 + 2 * Math.PI, 0.3 - 2 * Math.PI);
    const half = angle(0.3, 0.4, { upperBound: Infinity });
    expectArc(half[0], ERROR.A, 2, 0.3 - 2 * Math.PI, 1.3, 0.3 - 2 * Math.PI);
  });
});

describe('other kinds', () => {
  it('motors are not drawn', () => {
    expect(drawn(phys2D.createMotorConstraint({ bodyA: at([0, 0]), bodyB: at([1, 0]) }))).toEqual([]);
  });

  it.each([true, false])('a custom constraint draws itself; stiff: %s', (stiff) => {
    const calls: unknown[][] = [];
    const custom = phys2D.createCustomConstraint({
      dimension: 1,
      bodies: [at([0, 0])],
      stiff,
      jacobian() {},
      debugDraw(this: CustomConstraint, ...args) {
        calls.push([this, ...args]);
        args[0].drawLine(1, 2, 3, 4, RED);
      },
    });
    let debug: Physics2DDebugDraw | undefined;
    const segments = draw((it) => {
      debug = it;
      it.drawConstraint(custom);
    });
    expect(calls).toEqual([[custom, debug, stiff]]);
    expect(calls[0]![0]).toBe(custom);
    expect(calls[0]![1]).toBe(debug);
    expect(segments).toEqual([{ ends: [1, 2, 3, 4], color: [...RED] }]);
  });

  it('a custom constraint without debugDraw is not drawn', () => {
    expect(drawn(phys2D.createCustomConstraint({ dimension: 1, bodies: [at([0, 0])], jacobian() {} }))).toEqual([]);
  });

  it('an error of debugDraw reaches the caller', () => {
    const custom = phys2D.createCustomConstraint({
      dimension: 1,
      bodies: [at([0, 0])],
      jacobian() {},
      debugDraw() {
        throw new Error('from debugDraw');
      },
    });
    expect(() => drawn(custom)).toThrow('from debugDraw');
  });
});

describe('in drawWorld', () => {
  it('constraints come after bodies, enabled ones only; drawConstraint draws any', () => {
    const world = weightless();
    const bodyA = staticBody();
    const bodyB = phys2D.createRigidBody({ position: [1, 0], shapes: [phys2D.createCircleShape({ radius: 0.1 })] });
    world.addRigidBody(bodyB);
    const on = phys2D.createPointConstraint({ bodyA, bodyB });
    const off = phys2D.createPointConstraint({ bodyA, bodyB, disabled: true });
    tie(world, on, off);
    const colors = runs(draw((debug) => debug.drawWorld(world))).map(({ color }) => color);
    expect(colors).toEqual([[0.5, 1, 0.5, 1], COLOR.A, COLOR.B, ERROR.C]);
    expect(drawn(off)).toHaveLength(3);
    expect(
      draw((debug) => {
        debug.showConstraints = false;
        debug.showRigidBodies = false;
        debug.drawWorld(world);
      }),
    ).toEqual([]);
  });

  it('anchors follow the interpolation', () => {
    const world = weightless();
    const bodyB = phys2D.createRigidBody({ velocity: [6, 0], linearDrag: 0, mass: 1, inertia: 1 });
    world.addRigidBody(bodyB);
    world.step(1 / 60);
    const point = phys2D.createPointConstraint({ bodyA: staticBody({ position: [5, 0] }), bodyB });
    expectLine(drawn(point, { interpolation: 0.25 })[2], ERROR.C, [5, 0, 0.025, 0]);
  });
});
