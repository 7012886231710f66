import { atan2, cosSin } from '../math/trig.js';
import type { Physics2DDebugDraw } from './draw.js';

// Curves as segments, in the present colour of the line buffer. Lengths in m; the tolerances of the settings are px.

const TWO_PI = 2 * Math.PI;

/** The most pieces of one curve, so that drawing it ends, however large and fine it is. A circle of 20 million px still has its 0.4 px. */
const MAX_PIECES = 16384;

/** The fewest pieces of a wave of a spring; a multiple of 4, so that its crests are among the points. */
const MIN_WAVE_PIECES = 8;

/** Angle, cosine, sine: scratch. */
const turn = /* @__PURE__ */ new Float64Array(3);

/** Offsets of a point of a curve and its tangent, a unit vector or zero; and scratch for two of them. */
const X = 0;
const Y = 1;
const U = 2;
const V = 3;
const near = /* @__PURE__ */ new Float64Array(4);
const far = /* @__PURE__ */ new Float64Array(4);

function pieces(count: number): number {
  return Math.min(Math.ceil(count), MAX_PIECES);
}

/**
 * How many pieces a circle of radius R needs so that no chord is farther from it than e: R · (1 − cos(π / n)) ≤ e. Below R = e/2, 1, as no
 * n has a meaning.
 */
function circlePieces(radius: number, maxError: number): number {
  if (radius < maxError / 2) {
    return 1;
  }
  const t = maxError / radius;
  return pieces(Math.PI / atan2(Math.sqrt(t * (2 - t)), 1 - t));
}

export function addCircle(debug: Physics2DDebugDraw, x: number, y: number, radius: number): void {
  const count = Math.max(3, circlePieces(radius * debug.physics2DToScreen, debug.circleMaxError));
  turn[0] = TWO_PI / count;
  cosSin(turn);
  const cos = turn[1]!;
  const sin = turn[2]!;
  const { lines } = debug;
  const { next } = lines;
  let rx = cos * radius;
  let ry = sin * radius;
  lines.moveTo(x + radius, y);
  for (let i = 1; i < count; i += 1) {
    next[0] = x + rx;
    next[1] = y + ry;
    lines.lineToNext();
    const before = rx;
    rx = cos * before - sin * ry;
    ry = sin * before + cos * ry;
  }
  next[0] = x + radius;
  next[1] = y;
  lines.lineToNext();
}

/**
 * Adds a quadratic Bézier curve. Between the middle of a piece and that of its chord lies a quarter of |p1 − 2c + p2|, and halving a piece
 * leaves a quarter of that, everywhere alike: so all pieces have the same size in the parameter.
 */
export function addCurve(
  debug: Physics2DDebugDraw,
  x1: number,
  y1: number,
  cx: number,
  cy: number,
  x2: number,
  y2: number,
  most = MAX_PIECES,
): void {
  const ax = x1 - 2 * cx + x2;
  const ay = y1 - 2 * cy + y2;
  const maxError = debug.curveMaxError * debug.screenToPhysics2D;
  let gap = Math.sqrt(ax * ax + ay * ay) / 4;
  let count = 1;
  while (gap >= maxError && count < most) {
    gap /= 4;
    count *= 2;
  }
  const { lines } = debug;
  const { next } = lines;
  lines.moveTo(x1, y1);
  for (let i = 1; i < count; i += 1) {
    const t = i / count;
    next[0] = x1 + t * (2 * (cx - x1) + t * ax);
    next[1] = y1 + t * (2 * (cy - y1) + t * ay);
    lines.lineToNext();
  }
  next[0] = x2;
  next[1] = y2;
  lines.lineToNext();
}

/**
 * Adds a piece from `near` to `far`: the Bézier curve with their tangents, in at most `most` segments, or a straight line if these do not
 * meet between them.
 */
function addPiece(debug: Physics2DDebugDraw, most: number): void {
  const dx = far[X]! - near[X]!;
  const dy = far[Y]! - near[Y]!;
  const bend = near[U]! * far[V]! - near[V]! * far[U]!;
  const s = (dx * far[V]! - dy * far[U]!) / bend;
  const q = (near[U]! * dy - near[V]! * dx) / bend;
  if (Math.abs(bend) >= debug.spiralEpsilon && s > 0 && q > 0) {
    addCurve(debug, near[X]!, near[Y]!, near[X]! + s * near[U]!, near[Y]! + s * near[V]!, far[X]!, far[Y]!, most);
  } else {
    debug.lines.add(near[X]!, near[Y]!, far[X]!, far[Y]!);
  }
}

/**
 * Writes to `far` the point of a curve in polar coordinates: by its angle, its radius, and the derivative of the radius with respect to the
 * angle.
 */
function goTo(x: number, y: number, angle: number, radius: number, slope: number): void {
  turn[0] = angle;
  cosSin(turn);
  const cos = turn[1]!;
  const sin = turn[2]!;
  const u = slope * cos - radius * sin;
  const v = slope * sin + radius * cos;
  const length = Math.sqrt(u * u + v * v) || 1;
  far[X] = x + radius * cos;
  far[Y] = y + radius * sin;
  far[U] = u / length;
  far[V] = v / length;
}

/**
 * Adds a spiral: the radius goes from `radius1` at `angle1` to `radius2` at `angle2`, in proportion to the angle, with `coils` sine waves on
 * it if that is above 0.
 */
export function addSpiral(
  debug: Physics2DDebugDraw,
  x: number,
  y: number,
  angle1: number,
  angle2: number,
  radius1: number,
  radius2: number,
  coils = 0,
): void {
  if (angle1 === angle2) {
    return;
  }
  const upward = angle1 < angle2;
  const start = upward ? angle1 : angle2;
  const end = upward ? angle2 : angle1;
  const inner = upward ? radius1 : radius2;
  const outer = upward ? radius2 : radius1;
  const span = end - start;
  const arc = debug.spiralMaxArc;
  const waves = Math.max(0, coils);
  const count = pieces(waves > 0 ? Math.max(span / (3 * arc), 40 * waves) : span / arc);
  const slope = (outer - inner) / span;
  const amplitude = waves > 0 ? debug.spiralSpringSize * Math.abs(TWO_PI * slope) : 0;
  const pace = (TWO_PI * waves) / span;
  for (let i = 0; i <= count; i += 1) {
    const t = i / count;
    turn[0] = TWO_PI * waves * t;
    cosSin(turn);
    const radius = inner + t * (outer - inner) + amplitude * turn[2]!;
    near.set(far);
    goTo(x, y, i === count ? end : start + t * span, radius, slope + amplitude * pace * turn[1]!);
    if (i > 0) {
      addPiece(debug, MAX_PIECES / count);
    }
  }
}

/** Adds `coils` full sine waves; a line if there are none, or the spring is too short to be seen as one. */
export function addLinearSpring(
  debug: Physics2DDebugDraw,
  x1: number,
  y1: number,
  x2: number,
  y2: number,
  coils: number,
  radius: number,
): void {
  const dx = x2 - x1;
  const dy = y2 - y1;
  const length = Math.sqrt(dx * dx + dy * dy);
  if (coils <= 0 || length === 0 || length * debug.physics2DToScreen < debug.minSpringLength) {
    debug.lines.add(x1, y1, x2, y2);
    return;
  }
  // Across the spring, a chord of a sine wave is as far from it as that of a circle of its amplitude.
  const exact = circlePieces(Math.abs(radius) * debug.physics2DToScreen, debug.curveMaxError);
  const perWave = Math.max(MIN_WAVE_PIECES, 4 * Math.ceil(exact / 4));
  const count = pieces(perWave * coils);
  const { lines } = debug;
  const { next } = lines;
  lines.moveTo(x1, y1);
  for (let i = 1; i < count; i += 1) {
    const t = i / count;
    turn[0] = TWO_PI * coils * t;
    cosSin(turn);
    const aside = (radius / length) * turn[2]!;
    next[0] = x1 + t * dx - aside * dy;
    next[1] = y1 + t * dy + aside * dx;
    lines.lineToNext();
  }
  next[0] = x2;
  next[1] = y2;
  lines.lineToNext();
}
