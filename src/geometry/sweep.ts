import { cosSin } from '../math/trig.js';
import { Distance, measureDistance } from './distance.js';
import { EDGE_STRIDE } from './layout.js';
import { Outline } from './outline.js';

/** Angle, cosine, sine: scratch. */
const turned = new Float64Array(3);

/** What can be swept: writes its outline where that was put. */
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

/** A shape on its way: where its origin is at time 0, and at what rates it moves and turns. */
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
  /** The time that it is placed for, and where the origin is then. */
  at = 0.5;
  atX = 0;
  atY = 0;
  /** Largest distance of a corner from the origin; right after `measureReach`. */
  reach = 0.5;

  /** Puts a shape where its body is, relative to another one, at rest. */
  stand(shape: Swept, at: Placement, origin: Placement): void {
    this.shape = shape;
    this.x = at.x - origin.x;
    this.y = at.y - origin.y;
    this.angle = at.angle;
    this.vx = 0;
    this.vy = 0;
    this.w = 0;
  }

  /** The same, on its way with the velocities of the body. */
  start(shape: Swept, at: Placement & Velocity, origin: Placement): void {
    this.stand(shape, at, origin);
    this.vx = at.vx;
    this.vy = at.vy;
    this.w = at.w;
  }

  /** Brings the outline to where it is at time `at`. */
  place(): void {
    const { at, outline } = this;
    turned[0] = this.angle + this.w * at;
    cosSin(turned);
    this.atX = this.x + this.vx * at;
    this.atY = this.y + this.vy * at;
    outline.x = this.atX;
    outline.y = this.atY;
    outline.cos = turned[1]!;
    outline.sin = turned[2]!;
    this.shape!.outline(outline);
  }

  measureReach(): void {
    const { corners, count } = this.outline;
    let squared = 0;
    for (let i = 0; i < count * EDGE_STRIDE; i += EDGE_STRIDE) {
      const x = corners[i]! - this.atX;
      const y = corners[i + 1]! - this.atY;
      squared = Math.max(squared, x * x + y * y);
    }
    this.reach = Math.sqrt(squared);
  }
}

/** Two shapes on their ways, and how they lie to each other at the time last looked at. */
export class Sweep {
  readonly a = new Travel();
  readonly b = new Travel();
  readonly distance = new Distance();
  /** What is looked for, as `timeOfImpact` is told: from function to function numbers go through fields, as arguments and results would be boxed. */
  target = 0.5;
  tolerance = 0.5;
  most = 0.5;
  /** The time from which to look, then that last looked at, the longest that certainly is safe from there, and the curvature of both ways. */
  time = 0.5;
  safe = 0.5;
  curvature = 0.5;
  /** Several times what any sweep has been seen to need: some 6,000 for shapes that turn forty times close to each other. The mean is 23. */
  patience = 20_000;
  /** What to say when that is used up: that they meet where they are by then. */
  cautious = false;
}

/** A bound on the farthest corner along an axis in a while, and its rate: scratch. */
const bound = { height: 0.5, rate: 0.5 };

/**
 * How far along `(nx, ny)` the outline of a travel reaches at most after another `dt`: every corner goes on at its present rate, and the
 * curvature of its way, at most w² times its distance from the origin, is added by the caller.
 */
function reachAlong(travel: Travel, nx: number, ny: number, dt: number): void {
  const { outline, atX, atY, w } = travel;
  const { corners, count } = outline;
  const base = nx * travel.vx + ny * travel.vy;
  bound.height = -Infinity;
  for (let i = 0; i < count * EDGE_STRIDE; i += EDGE_STRIDE) {
    const x = corners[i]!;
    const y = corners[i + 1]!;
    const rate = base + w * (ny * (x - atX) - nx * (y - atY));
    const height = nx * x + ny * y + rate * dt;
    if (height > bound.height) {
      bound.height = height;
      bound.rate = rate;
    }
  }
}

/**
 * The longest time for which two travels certainly stay farther apart than `target` along the axis on which they are apart now; at most
 * `most`. With n fixed their gap is at least g(s) = gap − (A's reach + B's) − ½·(w²·r of both)·s², which is concave: if it holds at the
 * end it holds all the way, and Newton's method from there comes down on its root. The end is where the corners that are farthest now would
 * meet, or before.
 */
function findSafe(sweep: Sweep): void {
  const { a, b, distance, target, curvature } = sweep;
  const { axisX, axisY } = distance;
  const limit = target + a.outline.radius + b.outline.radius;
  reachAlong(a, axisX, axisY, 0);
  const { rate: rateA } = bound;
  reachAlong(b, -axisX, -axisY, 0);
  let s = Math.min(sweep.most - sweep.time, latestRoot(distance.value - target, rateA + bound.rate, curvature));
  for (let i = 0; i < 64; i += 1) {
    reachAlong(a, axisX, axisY, s);
    const { height, rate } = bound;
    reachAlong(b, -axisX, -axisY, s);
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

/** When a gap that closes at a rate, faster by the curvature, is closed. */
function latestRoot(gap: number, rate: number, curvature: number): number {
  const root = Math.sqrt(rate * rate + 2 * curvature * gap);
  if (rate > 0) {
    return (2 * gap) / (rate + root);
  }
  return curvature > 0 ? (root - rate) / curvature : Infinity;
}

/**
 * The first time from `from` on at which two travelling shapes are no farther apart than `target` (negative: overlap by that much) and
 * `tolerance`, or −1 if that does not come before `most`. Conservative advancement (Mirtich 1996; van den Bergen, Collision Detection in Interactive
 * 3D Environments, 2003), with steps by a bound of second order for the axis of the signed distance, so that it closes in on an impact
 * quadratically however fast the shapes turn. Leaves the sweep as it is at that time.
 */
export function timeOfImpact(sweep: Sweep, target: number, tolerance: number, from: number, most: number): number {
  sweep.target = target;
  sweep.tolerance = tolerance;
  sweep.time = from;
  sweep.most = most;
  return findImpact(sweep) ? sweep.time : -1;
}

/** The same of what the fields of the sweep say; the time is left there too. @returns whether that comes. */
export function findImpact(sweep: Sweep): boolean {
  const { a, b, cautious, distance, most } = sweep;
  const enough = sweep.target + sweep.tolerance;
  for (let i = 0; i < sweep.patience; i += 1) {
    const { time: t } = sweep;
    a.at = t;
    b.at = t;
    a.place();
    b.place();
    measureDistance(a.outline, b.outline, distance);
    if (distance.value <= enough) {
      return true;
    }
    if (i === 0) {
      a.measureReach();
      b.measureReach();
      sweep.curvature = a.w * a.w * a.reach + b.w * b.w * b.reach;
    }
    findSafe(sweep);
    if (sweep.safe >= most - t) {
      return false;
    }
    sweep.time = t + sweep.safe;
  }
  // Nothing is asked of an object here, where hardly any sweep gets: that would make compiled code bail out.
  return cautious;
}
