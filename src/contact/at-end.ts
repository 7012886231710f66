import { roundness } from '../collide/along.js';
import * as g from '../collide/layout.js';
import { EDGE_NX, EDGE_NY, EDGE_STRIDE } from '../geometry/layout.js';
import { cos, sin } from '../math/trig.js';
import type { Shape } from '../shape/shape.js';
import { POLYGON } from '../shape/shape-kind.js';
import type { Arbiter } from './arbiter.js';
import { HELD_NUMBERS } from './layout.js';

// A manifold followed from the placements that it was found for to those at the end of the step. Worked out when asked for, because most contacts are never asked; or before a body is put elsewhere.

/** What was found: scratch. */
export const atEnd = { nx: 0.5, ny: 0.5, x: 0.5, y: 0.5, penetration: 0.5 };

const found = /* @__PURE__ */ new Float64Array(HELD_NUMBERS);

/** How much two units may differ by rounding. */
const SAME = 1e-9;

/** A body is about to be put elsewhere, or to leave. */
export function holdAtEnd(arbiter: Arbiter): void {
  if (!(arbiter.active || arbiter.sleeping) || arbiter.count === 0 || arbiter.isHeld()) {
    return;
  }
  // Held only when all is found: what is held is told.
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

/** The normal: that of an edge turns with its body; that of corners and circles is the way from the middle of one to that of the other. */
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
    // A handler has removed the shape.
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
    pointNormal(arbiter);
  }
}

/** Whether a polygon that was turned by an angle had an edge with that outer normal. */
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

/** Of circles the centres count, of polygons the corners. */
function pointNormal(arbiter: Arbiter): void {
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
  // Two corners that touch have no direction, nor have those that went through each other.
  if (toA + toB > SAME && length > SAME && x * nx + y * ny > 0) {
    atEnd.nx = x / length;
    atEnd.ny = y / length;
  }
}

/** A point, half-way into the overlap, and how deep that is. */
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
  // Along the surfaces half-way too, but where one is round: that one goes with its centre.
  const share = roundA > 0 === roundB > 0 ? 0.5 : roundB > 0 ? 1 : 0;
  atEnd.x = endX + share * gapX + (0.5 - share) * gap * nx;
  atEnd.y = endY + share * gapY + (0.5 - share) * gap * ny;
  atEnd.penetration = -separation - gap;
}
