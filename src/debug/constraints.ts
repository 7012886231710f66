import type { RigidBody } from '../body.js';
import { ANGLE, writePose, X, Y } from '../body-pose.js';
import type { AngleConstraint } from '../constraint/angle.js';
import type { Constraint } from '../constraint/constraint.js';
import type { DistanceConstraint } from '../constraint/distance.js';
import type { LineConstraint } from '../constraint/line.js';
import type { PointConstraint } from '../constraint/point.js';
import type { PulleyConstraint } from '../constraint/pulley.js';
import type { AnchoredConstraint } from '../constraint/two-body.js';
import type { WeldConstraint } from '../constraint/weld.js';
import { cosSin } from '../math/trig.js';
import { addCircle, addLinearSpring, addSpiral } from './curves.js';
import type { Physics2DDebugDraw } from './draw.js';
import type { Color } from './settings.js';

type Letter = 'A' | 'B' | 'C' | 'D';

/** m. Drawn in place of an infinite bound of a line. */
const FAR = 1e20;

/** rad. How much of an unbounded range of angles is shown beyond the body or the other bound. */
const FAR_TURN = 2 * Math.PI;

/** Scratch: the pose of a body; angle, cosine and sine; a point in body coordinates. */
const pose = /* @__PURE__ */ new Float64Array(3);
const turn = /* @__PURE__ */ new Float64Array(3);
const local = /* @__PURE__ */ new Float64Array(2);

/** World points of the anchors of the constraint that is being drawn. */
const ends = {
  A: /* @__PURE__ */ new Float64Array(2),
  B: /* @__PURE__ */ new Float64Array(2),
  C: /* @__PURE__ */ new Float64Array(2),
  D: /* @__PURE__ */ new Float64Array(2),
};

export function addConstraint(debug: Physics2DDebugDraw, constraint: Constraint): void {
  if (constraint.type === 'POINT') {
    addPoint(debug, constraint);
  } else if (constraint.type === 'WELD') {
    addWeld(debug, constraint);
  } else if (constraint.type === 'DISTANCE') {
    addDistance(debug, constraint);
  } else if (constraint.type === 'LINE') {
    addLine(debug, constraint);
  } else if (constraint.type === 'ANGLE') {
    addAngle(debug, constraint);
  } else if (constraint.type === 'PULLEY') {
    addPulley(debug, constraint);
  } else if (constraint.type === 'CUSTOM') {
    constraint.debugDraw?.call(constraint, debug, constraint.stiff);
  }
}

function addPoint(debug: Physics2DDebugDraw, constraint: PointConstraint | WeldConstraint): void {
  placeEnds(debug, constraint);
  const { A: a, B: b } = ends;
  useErrorColor(debug, constraint, 'C');
  if (constraint.stiff) {
    debug.lines.add(a[0]!, a[1]!, b[0]!, b[1]!);
  } else {
    addSpring(debug, a[0]!, a[1]!, b[0]!, b[1]!);
  }
}

/** Adds a weld. If it is soft, with springs that lead from the angle of each body to the one that the other body asks for. */
function addWeld(debug: Physics2DDebugDraw, constraint: WeldConstraint): void {
  addPoint(debug, constraint);
  if (!constraint.stiff) {
    const { A: a, B: b } = ends;
    const phase = constraint.getPhase();
    const angleA = angleOf(debug, constraint.bodyA);
    const angleB = angleOf(debug, constraint.bodyB);
    useErrorColor(debug, constraint, 'A');
    addTurnSpring(debug, a[0]!, a[1]!, angleA, angleB - phase, Math.min(angleA, angleB - phase));
    useErrorColor(debug, constraint, 'B');
    addTurnSpring(debug, b[0]!, b[1]!, angleB, angleA + phase, Math.min(angleB, angleA + phase));
  }
}

function addDistance(debug: Physics2DDebugDraw, constraint: DistanceConstraint): void {
  placeEnds(debug, constraint);
  addLink(debug, constraint, 'A', 'B', constraint.getLowerBound(), constraint.getUpperBound());
}

/** Adds a pulley. Each link has the bounds that the length of the other one leaves it. */
function addPulley(debug: Physics2DDebugDraw, constraint: PulleyConstraint): void {
  placeEnds(debug, constraint);
  placeEnd(debug, constraint, constraint.bodyC, constraint.getAnchorC(local), 'C');
  placeEnd(debug, constraint, constraint.bodyD, constraint.getAnchorD(local), 'D');
  const ratio = constraint.getRatio();
  const lower = constraint.getLowerBound();
  const upper = constraint.getUpperBound();
  const first = distance(ends.A, ends.B);
  const second = ratio * distance(ends.C, ends.D);
  addLink(debug, constraint, 'A', 'B', Math.max(0, lower - second), Math.max(0, upper - second));
  const least = ((ratio > 0 ? lower : upper) - first) / ratio;
  const most = ((ratio > 0 ? upper : lower) - first) / ratio;
  addLink(debug, constraint, 'C', 'D', Math.max(0, least), Math.max(0, most));
}

/**
 * Adds a line of the lower bound's length half-way between two ends, on each side what the upper bound adds, and springs from there to ends
 * that are out of bounds.
 */
function addLink(
  debug: Physics2DDebugDraw,
  constraint: Constraint,
  from: 'A' | 'C',
  to: 'B' | 'D',
  lower: number,
  upper: number,
): void {
  const a = ends[from];
  const b = ends[to];
  const length = distance(a, b);
  const nx = length > 0 ? (b[0]! - a[0]!) / length : 1;
  const ny = length > 0 ? (b[1]! - a[1]!) / length : 0;
  const x = (a[0]! + b[0]!) / 2;
  const y = (a[1]! + b[1]!) / 2;
  const lx = (nx * lower) / 2;
  const ly = (ny * lower) / 2;
  useErrorColor(debug, constraint, from);
  debug.lines.add(x - lx, y - ly, x + lx, y + ly);
  if (!constraint.stiff && length < lower) {
    addSpring(debug, x - lx, y - ly, a[0]!, a[1]!);
    addSpring(debug, x + lx, y + ly, b[0]!, b[1]!);
  }
  if (upper < Infinity) {
    const ux = (nx * upper) / 2;
    const uy = (ny * upper) / 2;
    useErrorColor(debug, constraint, to);
    debug.lines.add(x - lx, y - ly, x - ux, y - uy);
    debug.lines.add(x + lx, y + ly, x + ux, y + uy);
    if (!constraint.stiff && length > upper) {
      addSpring(debug, x - ux, y - uy, a[0]!, a[1]!);
      addSpring(debug, x + ux, y + uy, b[0]!, b[1]!);
    }
  }
}

function addLine(debug: Physics2DDebugDraw, constraint: LineConstraint): void {
  placeEnds(debug, constraint);
  const { A: a, B: b } = ends;
  writePose(constraint.bodyA, debug.interpolation, pose);
  turn[0] = pose[ANGLE]!;
  cosSin(turn);
  constraint.getAxis(local);
  const nx = turn[1]! * local[0]! - turn[2]! * local[1]!;
  const ny = turn[2]! * local[0]! + turn[1]! * local[1]!;
  const lower = Math.max(constraint.getLowerBound(), -FAR);
  const upper = Math.min(constraint.getUpperBound(), FAR);
  const along = nx * (b[0]! - a[0]!) + ny * (b[1]! - a[1]!);
  const nearest = Math.min(Math.max(along, lower), upper);
  const x = a[0]! + nearest * nx;
  const y = a[1]! + nearest * ny;
  useErrorColor(debug, constraint, 'A');
  debug.lines.add(a[0]! + lower * nx, a[1]! + lower * ny, x, y);
  useErrorColor(debug, constraint, 'B');
  debug.lines.add(x, y, a[0]! + upper * nx, a[1]! + upper * ny);
  if (!constraint.stiff) {
    useErrorColor(debug, constraint, 'C');
    addSpring(debug, x, y, b[0]!, b[1]!);
  }
}

/** Adds lower ≤ ratio · θB − θA ≤ upper as a range for the angle of each body. */
function addAngle(debug: Physics2DDebugDraw, constraint: AngleConstraint): void {
  const ratio = constraint.getRatio();
  const lower = constraint.getLowerBound();
  const upper = constraint.getUpperBound();
  const angleA = angleOf(debug, constraint.bodyA);
  const angleB = angleOf(debug, constraint.bodyB);
  addRange(debug, constraint, constraint.bodyA, 'A', ratio * angleB - upper, ratio * angleB - lower);
  const least = ((ratio > 0 ? lower : upper) + angleA) / ratio;
  const most = ((ratio > 0 ? upper : lower) + angleA) / ratio;
  addRange(debug, constraint, constraint.bodyB, 'B', least, most);
}

/** Adds the angles that a body may have as a spiral, the one it has as a dot, and a spring to that from the nearest that it may have. */
function addRange(
  debug: Physics2DDebugDraw,
  constraint: AngleConstraint,
  body: RigidBody,
  letter: 'A' | 'B',
  lower: number,
  upper: number,
): void {
  writePose(body, debug.interpolation, pose);
  const x = pose[X]!;
  const y = pose[Y]!;
  const angle = pose[ANGLE]!;
  const from = lower > -Infinity ? lower : Math.min(angle, upper) - FAR_TURN;
  const to = upper < Infinity ? upper : Math.max(angle, lower) + FAR_TURN;
  const start = Math.min(from, angle);
  useErrorColor(debug, constraint, letter);
  addSpiral(debug, x, y, from, to, radiusAt(debug, from, start), radiusAt(debug, to, start));
  const nearest = Math.min(Math.max(angle, from), to);
  if (!constraint.stiff) {
    addTurnSpring(debug, x, y, nearest, angle, start);
  }
  turn[0] = angle;
  cosSin(turn);
  const radius = radiusAt(debug, angle, start);
  useColor(debug, constraint, letter);
  addDot(debug, x + radius * turn[1]!, y + radius * turn[2]!);
}

/** m. The radius, at an angle, of the spiral on which angles are shown, which begins at the angle `start`. */
function radiusAt(debug: Physics2DDebugDraw, angle: number, start: number): number {
  const px = debug.constraintSpiralMinRadius + (angle - start) * debug.constraintSpiralDeltaRadius;
  return px * debug.screenToPhysics2D;
}

function addTurnSpring(debug: Physics2DDebugDraw, x: number, y: number, from: number, to: number, start: number): void {
  const coils = debug.constraintSpiralNumCoils;
  addSpiral(debug, x, y, from, to, radiusAt(debug, from, start), radiusAt(debug, to, start), coils);
}

function addSpring(debug: Physics2DDebugDraw, x1: number, y1: number, x2: number, y2: number): void {
  const radius = debug.constraintSpringRadius * debug.screenToPhysics2D;
  addLinearSpring(debug, x1, y1, x2, y2, debug.constraintSpringNumCoils, radius);
}

/** Finds and draws the anchors of both bodies. */
function placeEnds(debug: Physics2DDebugDraw, constraint: Extract<Constraint, AnchoredConstraint>): void {
  placeEnd(debug, constraint, constraint.bodyA, constraint.getAnchorA(local), 'A');
  placeEnd(debug, constraint, constraint.bodyB, constraint.getAnchorB(local), 'B');
}

function placeEnd(
  debug: Physics2DDebugDraw,
  constraint: Constraint,
  body: RigidBody,
  anchor: Float64Array,
  letter: Letter,
): void {
  writePose(body, debug.interpolation, pose);
  turn[0] = pose[ANGLE]!;
  cosSin(turn);
  const end = ends[letter];
  end[0] = pose[X]! + turn[1]! * anchor[0]! - turn[2]! * anchor[1]!;
  end[1] = pose[Y]! + turn[2]! * anchor[0]! + turn[1]! * anchor[1]!;
  useColor(debug, constraint, letter);
  addDot(debug, end[0]!, end[1]!);
}

/** Adds an anchor: nested circles. */
function addDot(debug: Physics2DDebugDraw, x: number, y: number): void {
  const radius = debug.constraintAnchorRadius * debug.screenToPhysics2D;
  for (let part = 4; part > 0; part -= 1) {
    addCircle(debug, x, y, (radius * part) / 4);
  }
}

function angleOf(debug: Physics2DDebugDraw, body: RigidBody): number {
  writePose(body, debug.interpolation, pose);
  return pose[ANGLE]!;
}

function distance(a: Float64Array, b: Float64Array): number {
  const dx = b[0]! - a[0]!;
  const dy = b[1]! - a[1]!;
  return Math.sqrt(dx * dx + dy * dy);
}

/** Names of colour settings, so that they are not built anew for each constraint. */
const COLORS = {
  A: ['constraintColorA', 'constraintSleepingColorA'],
  B: ['constraintColorB', 'constraintSleepingColorB'],
  C: ['constraintColorC', 'constraintSleepingColorC'],
  D: ['constraintColorD', 'constraintSleepingColorD'],
} as const;
const ERROR_COLORS = {
  A: ['constraintErrorColorA', 'constraintErrorSleepingColorA'],
  B: ['constraintErrorColorB', 'constraintErrorSleepingColorB'],
  C: ['constraintErrorColorC', 'constraintErrorSleepingColorC'],
  D: ['constraintErrorColorD', 'constraintErrorSleepingColorD'],
} as const;

function useColor(debug: Physics2DDebugDraw, constraint: Constraint, letter: Letter): void {
  const color: Color = debug[COLORS[letter][constraint.sleeping ? 1 : 0]];
  debug.lines.setColor(color);
}

function useErrorColor(debug: Physics2DDebugDraw, constraint: Constraint, letter: Letter): void {
  const color: Color = debug[ERROR_COLORS[letter][constraint.sleeping ? 1 : 0]];
  debug.lines.setColor(color);
}
