import { CAST_TOLERANCE, STILL_LOOKS } from '../config.js';
import { cosSin } from '../math/trig.js';
import { Distance, measureDistance } from './distance.js';
import { EDGE_STRIDE } from './layout.js';
import { Outline } from './outline.js';

/** By what share the time at which circles meet is reckoned too early. */
const SHORT = 1e-9;

/** By what share of its length the end of a way may be off by rounding. */
const ROUNDING = 4 * Number.EPSILON;

/** Angle, cosine, sine: scratch. */
const turned = /* @__PURE__ */ new Float64Array(3);

/**
 * The rate at which the separating axis turns, rad/s, and a time from now; and, written by `findFarthest`, a bound on how far corners reach
 * along it after that time, and the rate at which that grows: scratch.
 */
const bound = { turning: 0.5, after: 0.5, height: 0.5, rate: 0.5 };

/** What can be swept: writes its outline for the placement in `into`. */
export interface Swept {
  outline(into: Outline): void;
}

interface Placement {
  readonly x: number;
  readonly y: number;
  readonly angle: number;
}

interface Velocity {
  readonly vx: number;
  readonly vy: number;
  readonly w: number;
}

/** A moving shape: where its body's origin is at time 0, and the rates at which it moves and turns. */
export class Travel {
  shape: Swept | null = null;
  readonly outline = new Outline();
  /** Of the origin, at time 0. */
  x = 0;
  y = 0;
  angle = 0;
  vx = 0;
  vy = 0;
  w = 0;
  /** The time that `place` is for. The outline has the placement at that time. */
  at = 0.5;
  /** Its rates at that time, as seen from the axis of the sweep, which turns about the origin of the coordinates. */
  seenX = 0.5;
  seenY = 0.5;
  seenW = 0.5;
  /** The largest distance of a corner from the body's origin, as of the last `measureReach`. */
  reach = 0.5;

  /** Sets a shape at rest where its body is, relative to another body. */
  stand(shape: Swept, at: Placement, origin: Placement): void {
    this.shape = shape;
    this.x = at.x - origin.x;
    this.y = at.y - origin.y;
    this.angle = at.angle;
    this.vx = 0;
    this.vy = 0;
    this.w = 0;
  }

  /** The same, moving with the velocities of its body. */
  start(shape: Swept, at: Placement & Velocity, origin: Placement): void {
    this.stand(shape, at, origin);
    this.vx = at.vx;
    this.vy = at.vy;
    this.w = at.w;
  }

  /** Moves the outline to where the shape is at time `at`. `isFirst`: it has not been placed since `stand` or `start`. */
  place(isFirst: boolean): void {
    const { at, outline, w, vx, vy } = this;
    if (isFirst || w !== 0) {
      turned[0] = this.angle + w * at;
      cosSin(turned);
      outline.cos = turned[1]!;
      outline.sin = turned[2]!;
    }
    if (isFirst || w !== 0 || vx !== 0 || vy !== 0) {
      this.shape!.outline(outline.put(this.x + vx * at, this.y + vy * at, outline.cos, outline.sin));
    }
    this.seenX = vx + bound.turning * outline.y;
    this.seenY = vy - bound.turning * outline.x;
    this.seenW = w - bound.turning;
  }

  measureReach(): void {
    const { corners, count, x: atX, y: atY } = this.outline;
    let squared = 0;
    for (let i = 0; i < count * EDGE_STRIDE; i += EDGE_STRIDE) {
      const x = corners[i]! - atX;
      const y = corners[i + 1]! - atY;
      squared = Math.max(squared, x * x + y * y);
    }
    this.reach = Math.sqrt(squared);
  }
}

/** Two moving shapes, and their distance at the time last looked at. */
export class Sweep {
  readonly a = new Travel();
  readonly b = new Travel();
  readonly distance = new Distance();
  /** What is looked for, see `findImpact`. Numbers pass from function to function through fields, as arguments and results would be boxed. */
  target = 0.5;
  tolerance = 0.5;
  most = 0.5;
  /** The time to start from, then the one last looked at; and the longest time from there for which the shapes are certain to stay apart. */
  time = 0.5;
  safe = 0.5;

  /**
   * `patience`: how many looks to take at most. The default is several times what any sweep has been seen to need, some 4,000 for shapes
   * that turn forty times close to each other. The mean is 22.
   * `cautious`: what to return when these are used up: `true`, that the shapes meet where they are by then.
   */
  constructor(
    readonly patience = 20_000,
    readonly cautious = false,
  ) {}

  /** Lets go of the shapes. */
  release(): void {
    this.a.shape = null;
    this.b.shape = null;
  }
}

/**
 * Writes to `bound` how far a moving outline reaches at most along an axis, or against it (`sign` −1), after its time: every corner goes on at
 * its present rate, as seen from the axis. The caller adds for the curvature of its path.
 */
function findFarthest(travel: Travel, { axisX, axisY }: Distance, sign: number): void {
  const { corners, count, x: atX, y: atY } = travel.outline;
  const { seenW } = travel;
  const nx = sign * axisX;
  const ny = sign * axisY;
  const { after } = bound;
  const base = nx * travel.seenX + ny * travel.seenY;
  bound.height = -Infinity;
  for (let i = 0; i < count * EDGE_STRIDE; i += EDGE_STRIDE) {
    const x = corners[i]!;
    const y = corners[i + 1]!;
    const rate = base + seenW * (ny * (x - atX) - nx * (y - atY));
    const height = nx * x + ny * y + rate * after;
    if (height > bound.height) {
      bound.height = height;
      bound.rate = rate;
    }
  }
}

/** Writes the present rate of the farthest corner to `bound`: what does not turn has all corners go at one rate. */
function findRate(travel: Travel, axis: Distance, sign: number): void {
  if (travel.seenW === 0) {
    bound.rate = sign * (axis.axisX * travel.seenX + axis.axisY * travel.seenY);
  } else {
    bound.after = 0;
    findFarthest(travel, axis, sign);
  }
}

/**
 * Finds the longest time for which two moving shapes are certain to stay farther apart than `target` along the axis of their present
 * distance; at most until `most`, and until a turning axis has turned by a radian. Their gap is at least g(s) = gap − (A's reach + B's) −
 * ½·c·s², which is concave: if it holds at the end it holds all the way, and Newton's method from there comes down on its root. The end is
 * where the corners that are farthest now would meet, or before. Seen from an axis that turns at a rate t, corners go round at w − t, with
 * a curvature of (w − t)²·r, and the origins, which part at v, with t²·d + 2·|t|·v, where they are d ≤ x + v·s apart, and s ≤ 1 / |t|.
 */
function findSafe(sweep: Sweep): void {
  const { a, b, distance, target } = sweep;
  const t = Math.abs(bound.turning);
  const x = Math.abs(b.outline.x - a.outline.x) + Math.abs(b.outline.y - a.outline.y);
  const v = Math.abs(b.vx - a.vx) + Math.abs(b.vy - a.vy);
  const curvature = a.seenW * a.seenW * a.reach + b.seenW * b.seenW * b.reach + t * (t * x + 3 * v);
  const limit = target + a.outline.radius + b.outline.radius;
  findRate(a, distance, 1);
  const { rate: rateA } = bound;
  findRate(b, distance, -1);
  const root = latestRoot(distance.value - target, rateA + bound.rate, curvature);
  let s = Math.min(sweep.most - sweep.time, 1 / t, root);
  for (let i = 0; i < 64; i += 1) {
    bound.after = s;
    findFarthest(a, distance, 1);
    const { height, rate } = bound;
    findFarthest(b, distance, -1);
    const gap = -bound.height - height - limit - 0.5 * curvature * s * s;
    const slope = -bound.rate - rate - curvature * s;
    if (gap >= 0 || slope >= 0) {
      break;
    }
    const next = s - gap / slope;
    if (!(next < s)) {
      break;
    }
    s = next;
  }
  sweep.safe = s;
}

/** The time after which a gap is closed that shrinks at a rate, which itself grows by `curvature` per second. */
function latestRoot(gap: number, rate: number, curvature: number): number {
  const root = Math.sqrt(rate * rate + 2 * curvature * gap);
  if (rate > 0) {
    return (2 * gap) / (rate + root);
  }
  return curvature > 0 ? (root - rate) / curvature : Infinity;
}

/** The time at which two moving shapes first touch, from 0 on, or −1 if they do not before `most`. */
export function timeOfImpact(sweep: Sweep, most: number): number {
  sweep.target = 0;
  sweep.tolerance = CAST_TOLERANCE;
  sweep.time = 0;
  sweep.most = most;
  return findImpact(sweep) ? sweep.time : -1;
}

/**
 * Advances from the time of the sweep to the first at which two moving shapes are no farther apart than `target` (negative: overlap by that
 * much) and `tolerance`. @returns whether that comes before `most`; the sweep is left as it is at that time.
 *
 * Conservative advancement (Mirtich 1996; van den Bergen, Collision Detection in Interactive 3D Environments, 2003), with steps by a bound
 * of second order along the axis of the signed distance, so that it converges on an impact quadratically however fast the shapes turn. What
 * takes many steps is also looked at along axes that turn with either shape: across an axis that stands still, the far end of a long shape
 * arrives at once.
 */
export function findImpact(sweep: Sweep): boolean {
  bound.turning = 0;
  placeAndMeasure(sweep, true);
  sweep.a.measureReach();
  sweep.b.measureReach();
  return (sweep.cautious || comeNear(sweep)) && findNext(sweep);
}

/**
 * Advances to where the bounding circles of both shapes meet, however the shapes turn: else one that turns often on a long way would be
 * looked at for each turn. @returns whether they meet.
 */
function comeNear(sweep: Sweep): boolean {
  const { a, b, time } = sweep;
  const x = b.outline.x - a.outline.x;
  const y = b.outline.y - a.outline.y;
  const vx = b.vx - a.vx;
  const vy = b.vy - a.vy;
  const speed = Math.sqrt(vx * vx + vy * vy);
  const reach = sweep.target + sweep.tolerance + a.outline.radius + b.outline.radius + a.reach + b.reach;
  const near = reach + ROUNDING * (Math.abs(x) + Math.abs(y));
  if (!(near > 0 && speed > 0)) {
    return true;
  }
  // The origin of B as seen from that of A: how far to the side of A's way it lies, and how far ahead.
  const aside = (x * vy - y * vx) / speed;
  const ahead = -(x * vx + y * vy) / speed;
  if (Math.abs(aside) > near) {
    return false;
  }
  const half = Math.sqrt(near * near - aside * aside);
  const safe = ((ahead - half) / speed) * (1 - SHORT);
  if (ahead + half < 0 || safe >= sweep.most - time) {
    return false;
  }
  if (safe > 0 && (a.w !== 0 || b.w !== 0)) {
    sweep.time = time + safe;
    placeAndMeasure(sweep, false);
  }
  return true;
}

/** As `findImpact`, from where the sweep is, for another target. */
export function findNext(sweep: Sweep): boolean {
  const { a, b, cautious, distance, most } = sweep;
  const enough = sweep.target + sweep.tolerance;
  // m per second of sweep: rounding of the places of shapes that approach each other from far away.
  const blur = ROUNDING * (Math.abs(b.vx - a.vx) + Math.abs(b.vy - a.vy));
  for (let i = 1; i <= sweep.patience; i += 1) {
    const { time: t } = sweep;
    if (distance.value <= enough + blur * t) {
      return true;
    }
    findSafe(sweep);
    if (sweep.safe >= most - t) {
      return false;
    }
    sweep.time = t + sweep.safe;
    bound.turning = i < STILL_LOOKS || i % 3 === 0 ? 0 : i % 3 === 1 ? a.w : b.w;
    placeAndMeasure(sweep, false);
  }
  // Nothing is asked of an object here, where hardly any sweep gets: that would make compiled code bail out.
  return cautious;
}

/** Places both shapes at the time of the sweep, and measures their distance. */
function placeAndMeasure({ a, b, distance, time }: Sweep, isFirst: boolean): void {
  a.at = time;
  b.at = time;
  a.place(isFirst);
  b.place(isFirst);
  measureDistance(a.outline, b.outline, distance);
}
