import { roundness } from '../collide/along.js';
import * as g from '../collide/layout.js';
import { EDGE_NX, EDGE_NY, EDGE_STRIDE } from '../geometry/layout.js';
import { cos, sin } from '../math/trig.js';
import type { Shape } from '../shape/shape.js';
import { POLYGON } from '../shape/shape-kind.js';
import type { Arbiter } from './arbiter.js';
import { HELD_NUMBERS } from './layout.js';

// A manifold is found for the placements at the start of a step. Here it is followed to those at the end: on demand, as most contacts are
// never asked for, or just before a body is moved by hand.

/** The result of `normalAtEnd` and `pointAtEnd`: scratch. */
export const atEnd = { nx: 0.5, ny: 0.5, x: 0.5, y: 0.5, penetration: 0.5 };

const found = /* @__PURE__ */ new Float64Array(HELD_NUMBERS);

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
    const at = 2 + 3 * which;
    found[at] = atEnd.x;
    found[at + 1] = atEnd.y;
    found[at + 2] = atEnd.penetration;
  }
  found[0] = atEnd.nx;
  found[1] = atEnd.ny;
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
    atEnd.nx = numbers[0]!;
    atEnd.ny = numbers[1]!;
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
  if (hasEdge(shapeA, nx, ny, n[o + g.ANGLE_A]!)) {
    turnNormal(turnA);
  } else if (hasEdge(shapeB, -nx, -ny, n[o + g.ANGLE_B]!)) {
    turnNormal(turnB);
  } else if (nx * nx + ny * ny > 0) {
    joinPoints(arbiter);
  }
}

/** Whether a shape is a polygon with this outward edge normal when turned by `angle`. */
function hasEdge(shape: Shape, nx: number, ny: number, angle: number): boolean {
  if (shape.kind !== POLYGON) {
    return false;
  }
  const c = cos(angle);
  const s = sin(angle);
  const x = c * nx + s * ny;
  const y = c * ny - s * nx;
  const { localEdges: edges } = shape;
  let found = false;
  for (let k = 0; k < edges.length; k += EDGE_STRIDE) {
    found ||= Math.abs(edges[k + EDGE_NX]! - x) < SAME && Math.abs(edges[k + EDGE_NY]! - y) < SAME;
  }
  return found;
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
  const { numbers: n, at: o, bodyA: a, bodyB: b, shapeA, shapeB } = arbiter;
  const { nx, ny } = atEnd;
  const separation = n[o + g.S0]!;
  const toA = shapeA.kind === POLYGON ? 0.5 * separation : roundness(shapeA, separation);
  const toB = shapeB.kind === POLYGON ? 0.5 * separation : roundness(shapeB, separation);
  const cA = cos(a.angle - n[o + g.ANGLE_A]!);
  const sA = sin(a.angle - n[o + g.ANGLE_A]!);
  const cB = cos(b.angle - n[o + g.ANGLE_B]!);
  const sB = sin(b.angle - n[o + g.ANGLE_B]!);
  const ax = n[o + g.X0]! - nx * toA;
  const ay = n[o + g.Y0]! - ny * toA;
  const bx = n[o + g.X0]! - n[o + g.DX]! + nx * toB;
  const by = n[o + g.Y0]! - n[o + g.DY]! + ny * toB;
  const x = b.x + cB * bx - sB * by - (a.x + cA * ax - sA * ay);
  const y = b.y + sB * bx + cB * by - (a.y + sA * ax + cA * ay);
  const length = Math.sqrt(x * x + y * y);
  // Corners that coincide define no direction, and of points that have passed through each other it is the wrong one.
  if (toA + toB > SAME && length > SAME && x * nx + y * ny > 0) {
    atEnd.nx = x / length;
    atEnd.ny = y / length;
  }
}

/** Writes normal, position and penetration of a point, 0 or 1, to `atEnd`. The position is half-way into the overlap. */
export function pointAtEnd(arbiter: Arbiter, which: number): void {
  normalAtEnd(arbiter);
  if (arbiter.isHeld()) {
    const { numbers } = arbiter.held!;
    atEnd.x = numbers[2 + 3 * which]!;
    atEnd.y = numbers[3 + 3 * which]!;
    atEnd.penetration = numbers[4 + 3 * which]!;
    return;
  }
  const { numbers: n, at: o } = arbiter;
  const a = arbiter.bodyA;
  const b = arbiter.bodyB;
  const x = n[o + g.X0 + g.POINT * which]!;
  const y = n[o + g.Y0 + g.POINT * which]!;
  const separation = n[o + g.S0 + g.POINT * which]!;
  const cA = cos(a.angle - n[o + g.ANGLE_A]!);
  const sA = sin(a.angle - n[o + g.ANGLE_A]!);
  const cB = cos(b.angle - n[o + g.ANGLE_B]!);
  const sB = sin(b.angle - n[o + g.ANGLE_B]!);
  const { nx, ny } = atEnd;
  const roundA = roundness(arbiter.shapeA, separation);
  const roundB = roundness(arbiter.shapeB, separation);
  const ax = x - n[o + g.NX]! * roundA;
  const ay = y - n[o + g.NY]! * roundA;
  const bx = x - n[o + g.DX]! + n[o + g.NX]! * roundB;
  const by = y - n[o + g.DY]! + n[o + g.NY]! * roundB;
  const endX = a.x + cA * ax - sA * ay + nx * roundA;
  const endY = a.y + sA * ax + cA * ay + ny * roundA;
  const gapX = b.x + cB * bx - sB * by - nx * roundB - endX;
  const gapY = b.y + sB * bx + cB * by - ny * roundB - endY;
  const gap = nx * gapX + ny * gapY;
  // Along the surfaces half-way, too, unless exactly one is round: the point goes with its centre.
  const share = roundA > 0 === roundB > 0 ? 0.5 : roundB > 0 ? 1 : 0;
  atEnd.x = endX + share * gapX + (0.5 - share) * gap * nx;
  atEnd.y = endY + share * gapY + (0.5 - share) * gap * ny;
  atEnd.penetration = -separation - gap;
}
