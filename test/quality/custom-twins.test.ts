import { describe, expect, it } from 'vitest';
import {
  type Constraint,
  type CustomConstraintParams,
  phys2D,
  type RigidBody,
  type Vec2,
  type World,
} from '../../src/index.js';
import { boxBody, DT, heavy, staticBody } from '../conformance/setting.js';

// A built-in constraint and the same one written with callbacks move their bodies alike.

const STEPS = 300;
const TARGET = 1e-6;

/** Where the two moving bodies are at first. */
const A: Vec2 = [1.8, 0.2];
const B: Vec2 = [3.2, 0.4];
const TURN_B = 0.2;

type Options = { stiff?: boolean; frequency?: number; damping?: number };

/** The bodies of one scene: a static anchor and two boxes that swing. */
interface Scene {
  readonly world: World;
  readonly anchor: RigidBody;
  readonly a: RigidBody;
  readonly b: RigidBody;
}

interface Kind {
  readonly name: string;
  readonly builtIn: (scene: Scene, options: Options) => Constraint;
  readonly twin: (scene: Scene) => Pick<CustomConstraintParams, 'dimension' | 'bodies' | 'jacobian' | 'position'>;
}

const cross = (a: Vec2, b: Vec2): number => a[0] * b[1] - a[1] * b[0];

/** World point of an anchor, and its arm from the body's origin. */
function at(body: RigidBody, anchor: Vec2): { point: Vec2; arm: Vec2 } {
  return { point: body.transformLocalPointToWorld(anchor), arm: body.transformLocalVectorToWorld(anchor) };
}

function between(a: { point: Vec2 }, b: { point: Vec2 }): Vec2 {
  return [b.point[0] - a.point[0], b.point[1] - a.point[1]];
}

/** Length of the line between two anchors, and its row of the Jacobian, 6 numbers. */
function link(bodyA: RigidBody, anchorA: Vec2, bodyB: RigidBody, anchorB: Vec2): { length: number; row: number[] } {
  const a = at(bodyA, anchorA);
  const b = at(bodyB, anchorB);
  const d = between(a, b);
  const length = Math.sqrt(d[0] * d[0] + d[1] * d[1]);
  const n: Vec2 = [d[0] / length, d[1] / length];
  return { length, row: [-n[0], -n[1], -cross(a.arm, n), n[0], n[1], cross(b.arm, n)] };
}

function custom(
  bodies: RigidBody[],
  dimension: number,
  jacobian: () => number[],
  position?: () => number[],
): Pick<CustomConstraintParams, 'dimension' | 'bodies' | 'jacobian' | 'position'> {
  const write = (values: () => number[]) => (data: { [index: number]: number }, index: number) =>
    values().forEach((value, i) => {
      data[index + i] = value;
    });
  return { bodies, dimension, jacobian: write(jacobian), ...(position ? { position: write(position) } : {}) };
}

/** An anchor of the first body; and those of the others that fit it where the scene begins, so that no error has to be removed first. */
const P: Vec2 = [0.4, 0.3];
const ON_A: Vec2 = [P[0] - A[0], P[1] - A[1]];
const ON_B = fromTurned([A[0] + P[0] - B[0], A[1] + P[1] - B[1]]);
const ALONG: Vec2 = [1, 0.2];
const ON_LINE = fromTurned([A[0] + P[0] + 1.5 * ALONG[0] - B[0], A[1] + P[1] + 1.5 * ALONG[1] - B[1]]);
const ROD = distance(P, A);
/**
 * The ropes of the pulley hang down. A custom constraint is corrected twice in a sub-step, a built-in one often once: what that leaves grows
 * to 5e-5 m within these 300 steps where ropes swing wide.
 */
const UP: Vec2 = [2.2, -3];
const UP_TOO: Vec2 = [3.2, -3];
const NEAR: Vec2 = [0.1, -0.2];
const ROPES = distance([A[0] + NEAR[0], A[1] + NEAR[1]], UP) + 0.72 * distance(B, UP_TOO);

function distance(p: Vec2, q: Vec2): number {
  return Math.sqrt((p[0] - q[0]) ** 2 + (p[1] - q[1]) ** 2);
}

/** From world directions to the coordinates of body b, which is turned. */
function fromTurned([x, y]: Vec2): Vec2 {
  const [c, s] = [Math.cos(TURN_B), Math.sin(TURN_B)];
  return [c * x + s * y, c * y - s * x];
}

const KINDS: readonly Kind[] = [
  {
    name: 'POINT',
    builtIn: ({ anchor, a }, options) =>
      phys2D.createPointConstraint({ bodyA: anchor, bodyB: a, anchorA: P, anchorB: ON_A, ...options }),
    twin: ({ anchor, a }) =>
      custom(
        [anchor, a],
        2,
        () => {
          const r = at(anchor, P).arm;
          const s = at(a, ON_A).arm;
          return [-1, 0, r[1], 1, 0, -s[1], 0, -1, -r[0], 0, 1, s[0]];
        },
        () => between(at(anchor, P), at(a, ON_A)),
      ),
  },
  {
    name: 'WELD',
    builtIn: ({ a, b }, options) =>
      phys2D.createWeldConstraint({ bodyA: a, bodyB: b, anchorA: P, anchorB: ON_B, phase: TURN_B, ...options }),
    twin: ({ a, b }) =>
      custom(
        [a, b],
        3,
        () => {
          // A weld gives to both bodies at one place on the line between its anchors, that turns as this does.
          const [x, y] = between(at(a, P), at(b, ON_B));
          const r = at(a, P).arm;
          const s = at(b, ON_B).arm;
          const [wA, wB] = [a.getAngularVelocity(), b.getAngularVelocity()];
          const [vA, vB] = [a.getVelocity(), b.getVelocity()];
          const vx = vB[0] - wB * s[1] - vA[0] + wA * r[1];
          const vy = vB[1] + wB * s[0] - vA[1] - wA * r[0];
          const turns = x * x + y * y > 0 ? (x * vy - y * vx) / (x * x + y * y) : 0;
          const share = wA === wB ? 0.5 : Math.max(0, Math.min(1, (turns - wB) / (wA - wB)));
          const [rx, ry] = [r[0] + share * x, r[1] + share * y];
          const [sx, sy] = [s[0] - (1 - share) * x, s[1] - (1 - share) * y];
          return [-1, 0, ry, 1, 0, -sy, 0, -1, -rx, 0, 1, sx, 0, 0, -1, 0, 0, 1];
        },
        () => [...between(at(a, P), at(b, ON_B)), b.getRotation() - a.getRotation() - TURN_B],
      ),
  },
  {
    name: 'ANGLE',
    builtIn: ({ a, b }, options) =>
      phys2D.createAngleConstraint({
        bodyA: a,
        bodyB: b,
        ratio: -1.5,
        lowerBound: -0.3,
        upperBound: -0.3,
        ...options,
      }),
    twin: ({ a, b }) =>
      custom(
        [a, b],
        1,
        () => [0, 0, -1, 0, 0, -1.5],
        () => [-1.5 * b.getRotation() - a.getRotation() + 0.3],
      ),
  },
  {
    name: 'DISTANCE',
    builtIn: ({ anchor, a }, options) =>
      phys2D.createDistanceConstraint({
        bodyA: anchor,
        bodyB: a,
        anchorA: P,
        lowerBound: ROD,
        upperBound: ROD,
        ...options,
      }),
    twin: ({ anchor, a }) =>
      custom(
        [anchor, a],
        1,
        () => link(anchor, P, a, [0, 0]).row,
        () => [link(anchor, P, a, [0, 0]).length - ROD],
      ),
  },
  {
    name: 'LINE',
    builtIn: ({ a, b }, options) =>
      phys2D.createLineConstraint({ bodyA: a, bodyB: b, anchorA: P, anchorB: ON_LINE, axis: ALONG, ...options }),
    twin: ({ a, b }) => {
      const measure = () => {
        const pa = at(a, P);
        const pb = at(b, ON_LINE);
        const size = Math.sqrt(1.04);
        const axis = a.transformLocalVectorToWorld([1 / size, 0.2 / size]);
        const d = between(pa, pb);
        return { error: cross(axis, d), n: [-axis[1], axis[0]] as Vec2, d, r: pa.arm, s: pb.arm };
      };
      return custom(
        [a, b],
        1,
        () => {
          const { n, d, r, s } = measure();
          return [-n[0], -n[1], -cross([r[0] + d[0], r[1] + d[1]], n), n[0], n[1], cross(s, n)];
        },
        () => [measure().error],
      );
    },
  },
  {
    name: 'MOTOR',
    builtIn: ({ a, b }) => phys2D.createMotorConstraint({ bodyA: a, bodyB: b, ratio: 2 }),
    twin: ({ a, b }) => custom([a, b], 1, () => [0, 0, -1, 0, 0, 2]),
  },
  {
    name: 'PULLEY',
    builtIn: ({ anchor, a, b }, options) =>
      phys2D.createPulleyConstraint({
        bodyA: a,
        bodyB: anchor,
        bodyC: anchor,
        bodyD: b,
        anchorA: NEAR,
        anchorB: UP,
        anchorC: UP_TOO,
        ratio: 0.72,
        lowerBound: ROPES,
        upperBound: ROPES,
        ...options,
      }),
    twin: ({ anchor, a, b }) => {
      const measure = () => [link(a, NEAR, anchor, UP), link(anchor, UP_TOO, b, [0, 0])] as const;
      return custom(
        [a, anchor, anchor, b],
        1,
        () => {
          const [first, second] = measure();
          return [...first.row, ...second.row.map((value) => 0.72 * value)];
        },
        () => {
          const [first, second] = measure();
          return [first.length + 0.72 * second.length - ROPES];
        },
      );
    },
  },
];

function build(kind: Kind, isTwin: boolean, options: Options, substeps: number): Scene {
  const world = heavy({ substeps });
  const anchor = staticBody();
  const mask = { group: 2, mask: 1 };
  const a = boxBody(1, 0.5, { position: A, angularVelocity: 1, velocity: [0.5, 1] }, mask);
  const b = boxBody(0.6, 0.6, { position: B, rotation: TURN_B, angularVelocity: -2, velocity: [-1, 0] }, mask);
  const scene = { world, anchor, a, b };
  world.addRigidBody(a);
  world.addRigidBody(b);
  const constraint = isTwin
    ? phys2D.createCustomConstraint({ ...kind.twin(scene), ...options })
    : kind.builtIn(scene, options);
  world.addConstraint(constraint);
  return scene;
}

/** m, rad. The largest difference of a placement in the whole run. */
function difference(kind: Kind, options: Options, substeps: number): number {
  const one = build(kind, false, options, substeps);
  const other = build(kind, true, options, substeps);
  let worst = 0;
  for (let i = 0; i < STEPS; i += 1) {
    one.world.step(DT);
    other.world.step(DT);
    for (const name of ['a', 'b'] as const) {
      const [x, y] = one[name].getPosition();
      const [u, v] = other[name].getPosition();
      const turn = Math.abs(one[name].getRotation() - other[name].getRotation());
      worst = Math.max(worst, Math.abs(x - u), Math.abs(y - v), turn);
    }
  }
  return worst;
}

describe('a custom constraint moves its bodies like the built-in kind it imitates', () => {
  for (const kind of KINDS) {
    it(`${kind.name}, stiff`, () => {
      const worst = difference(kind, {}, 4);
      console.log(`${kind.name} and its twin: ${worst.toExponential(1)} m, rad (target ${TARGET})`);
      expect(worst).toBeLessThanOrEqual(TARGET);
    });
  }

  for (const kind of KINDS.filter(({ name }) => name !== 'MOTOR')) {
    it(`${kind.name}, elastic, without sub-steps: a callback is asked once a step`, () => {
      const options = { stiff: false, frequency: 3, damping: 0.3 };
      const worst = difference(kind, options, 1);
      const divided = difference(kind, options, 4);
      console.log(
        `${kind.name} and its twin, elastic: ${worst.toExponential(1)} m, rad (target ${TARGET}); ` +
          `with 4 sub-steps ${divided.toExponential(1)}`,
      );
      expect(worst).toBeLessThanOrEqual(TARGET);
    });
  }
});
