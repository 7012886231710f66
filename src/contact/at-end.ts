import { roundness } from '../collide/along.js';
import * as g from '../collide/layout.js';
import { works } from '../collide/polygon-works.js';
import { EDGE_NX, EDGE_NY, EDGE_STRIDE } from '../geometry/layout.js';
import { cos, sin } from '../math/trig.js';
import type { Polygon } from '../shape/polygon.js';
import { POLYGON } from '../shape/shape-kind.js';
import type { Arbiter } from './arbiter.js';
import * as c from './layout.js';

// A manifold is found for the placements at the start of a step. Here it is followed to those at the end: on demand, as most contacts are
// never asked for, or just before a body is moved by hand.

/** The result of `normalAtEnd` and `pointAtEnd`: scratch. */
export const atEnd = { nx: 0.5, ny: 0.5, x: 0.5, y: 0.5, penetration: 0.5 };

/** The result of `carryArms`: scratch. */
const ends = { ax: 0.5, ay: 0.5, bx: 0.5, by: 0.5 };

const found = /* @__PURE__ */ new Float64Array(c.HELD_NUMBERS);

/** By how much components of two equal unit vectors may differ by rounding; also a length, m, too short to give a direction. */
const SAME = 1e-9;

/** Keeps the manifold at the end of the step, as a body of the pair is about to be moved by hand or to leave. */
export function holdAtEnd(arbiter: Arbiter): void {
  if (!(arbiter.active || arbiter.sleeping) || arbiter.count === 0 || arbiter.isHeld()) {
    return;
  }
  // Written to the arbiter only at the end: once it is held, `pointAtEnd` returns what is held.
  for (let which = 0; which < 2; which += 1) {
    pointAtEnd(arbiter, which);
    const at = c.HELD_POINT * which;
    found[c.HELD_X + at] = atEnd.x;
    found[c.HELD_Y + at] = atEnd.y;
    found[c.HELD_PENETRATION + at] = atEnd.penetration;
  }
  found[c.HELD_NX] = atEnd.nx;
  found[c.HELD_NY] = atEnd.ny;
  arbiter.hold().set(found);
}

/**
 * Writes the normal to `atEnd`. The normal of an edge turns with its body. Between corners and circles it runs from the one contact point
 * to the other, or from centre to centre.
 */
export function normalAtEnd(arbiter: Arbiter): void {
  const { numbers: n, at: o, shapeA, shapeB } = arbiter;
  const a = shapeA.owner;
  const b = shapeB.owner;
  const nx = n[o + g.NX]!;
  const ny = n[o + g.NY]!;
  atEnd.nx = nx;
  atEnd.ny = ny;
  if (arbiter.isHeld()) {
    const { numbers } = arbiter.held!;
    atEnd.nx = numbers[c.HELD_NX]!;
    atEnd.ny = numbers[c.HELD_NY]!;
    return;
  }
  if (a === null || b === null) {
    // A handler has removed a shape from its body.
    return;
  }
  const turnA = a.angle - n[o + g.ANGLE_A]!;
  const turnB = b.angle - n[o + g.ANGLE_B]!;
  if (turnA === 0 && turnB === 0 && b.x - a.x === n[o + g.DX] && b.y - a.y === n[o + g.DY]) {
    return;
  }
  if (shapeA.kind === POLYGON && works!.hasEdge(shapeA, nx, ny, n[o + g.ANGLE_A]!)) {
    turnNormal(turnA);
  } else if (shapeB.kind === POLYGON && works!.hasEdge(shapeB, -nx, -ny, n[o + g.ANGLE_B]!)) {
    turnNormal(turnB);
  } else if (nx * nx + ny * ny > 0) {
    joinPoints(arbiter);
  }
}

/** Whether a polygon has this outward edge normal when turned by `angle`. */
export function hasEdge({ localEdges: edges }: Polygon, nx: number, ny: number, angle: number): boolean {
  const c = cos(angle);
  const s = sin(angle);
  const x = c * nx + s * ny;
  const y = c * ny - s * nx;
  for (let k = 0; k < edges.length; k += EDGE_STRIDE) {
    if (Math.abs(edges[k + EDGE_NX]! - x) < SAME && Math.abs(edges[k + EDGE_NY]! - y) < SAME) {
      return true;
    }
  }
  return false;
}

function turnNormal(angle: number): void {
  const c = cos(angle);
  const s = sin(angle);
  const { nx, ny } = atEnd;
  atEnd.nx = c * nx - s * ny;
  atEnd.ny = s * nx + c * ny;
}

/** The normal between two points that move with their bodies: the centre of a circle, the corner of a polygon. */
function joinPoints(arbiter: Arbiter): void {
  const { numbers: n, at: o, shapeA, shapeB } = arbiter;
  const { nx, ny } = atEnd;
  const separation = n[o + g.S0]!;
  const toA = shapeA.kind === POLYGON ? 0.5 * separation : roundness(shapeA, separation);
  const toB = shapeB.kind === POLYGON ? 0.5 * separation : roundness(shapeB, separation);
  carryArms(arbiter, 0, toA, toB);
  const x = ends.bx - ends.ax;
  const y = ends.by - ends.ay;
  const length = Math.sqrt(x * x + y * y);
  // Corners that coincide define no direction, and of points that have passed through each other it is the wrong one.
  if (toA + toB > SAME && length > SAME && x * nx + y * ny > 0) {
    atEnd.nx = x / length;
    atEnd.ny = y / length;
  }
}

/** Finds in `ends` where the bodies have carried a point, 0 or 1: on A as far back along the first normal as given, on B as far on. */
function carryArms({ numbers: n, at: o, bodyA: a, bodyB: b }: Arbiter, which: number, toA: number, toB: number): void {
  const nx = n[o + g.NX]!;
  const ny = n[o + g.NY]!;
  const x = n[o + g.X0 + g.POINT * which]!;
  const y = n[o + g.Y0 + g.POINT * which]!;
  const cA = cos(a.angle - n[o + g.ANGLE_A]!);
  const sA = sin(a.angle - n[o + g.ANGLE_A]!);
  const cB = cos(b.angle - n[o + g.ANGLE_B]!);
  const sB = sin(b.angle - n[o + g.ANGLE_B]!);
  const ax = x - nx * toA;
  const ay = y - ny * toA;
  const bx = x - n[o + g.DX]! + nx * toB;
  const by = y - n[o + g.DY]! + ny * toB;
  ends.ax = a.x + cA * ax - sA * ay;
  ends.ay = a.y + sA * ax + cA * ay;
  ends.bx = b.x + cB * bx - sB * by;
  ends.by = b.y + sB * bx + cB * by;
}

/** Writes normal, position and penetration of a point, 0 or 1, to `atEnd`. The position is half-way into the overlap. */
export function pointAtEnd(arbiter: Arbiter, which: number): void {
  normalAtEnd(arbiter);
  if (arbiter.isHeld()) {
    const { numbers } = arbiter.held!;
    const at = c.HELD_POINT * which;
    atEnd.x = numbers[c.HELD_X + at]!;
    atEnd.y = numbers[c.HELD_Y + at]!;
    atEnd.penetration = numbers[c.HELD_PENETRATION + at]!;
    return;
  }
  const { numbers: n, at: o, shapeA, shapeB } = arbiter;
  const separation = n[o + g.S0 + g.POINT * which]!;
  const { nx, ny } = atEnd;
  const roundA = roundness(shapeA, separation);
  const roundB = roundness(shapeB, separation);
  carryArms(arbiter, which, roundA, roundB);
  const endX = ends.ax + nx * roundA;
  const endY = ends.ay + ny * roundA;
  const gapX = ends.bx - nx * roundB - endX;
  const gapY = ends.by - ny * roundB - endY;
  const gap = nx * gapX + ny * gapY;
  // Along the surfaces half-way, too, unless exactly one is round: the point goes with its centre.
  const share = roundA > 0 === roundB > 0 ? 0.5 : roundB > 0 ? 1 : 0;
  atEnd.x = endX + share * gapX + (0.5 - share) * gap * nx;
  atEnd.y = endY + share * gapY + (0.5 - share) * gap * ny;
  atEnd.penetration = -separation - gap;
}
