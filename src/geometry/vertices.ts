import { COLLINEAR_TOLERANCE, MAX_SIZE, VERTEX_TOLERANCE } from '../config.js';
import { cos, sin } from '../math/trig.js';
import type { Vec2, Vec2Like } from '../math/vectors.js';
import { finite, integer, isVector, positive, typeError, vector } from '../validate.js';
import { polygonArea } from './mass.js';

/** Corners of a `width` × `height` box around the origin, clockwise from the upper left. Sizes in m, > 0. */
export function createBoxVertices(width: number, height: number): Vec2[] {
  const x = positive('createBoxVertices', 'width', width) / 2;
  const y = positive('createBoxVertices', 'height', height) / 2;
  return [
    [-x, -y],
    [x, -y],
    [x, y],
    [-x, y],
  ];
}

/** Corners of the rectangle between two opposite corners in any order, clockwise from the upper left. m. */
export function createRectangleVertices(x1: number, y1: number, x2: number, y2: number): Vec2[] {
  const where = 'createRectangleVertices';
  finite(where, 'x1', x1);
  finite(where, 'y1', y1);
  finite(where, 'x2', x2);
  finite(where, 'y2', y2);
  const minX = Math.min(x1, x2);
  const maxX = Math.max(x1, x2);
  const minY = Math.min(y1, y2);
  const maxY = Math.max(y1, y2);
  if (minX === maxX) {
    throw new RangeError(`${where}: x2 must differ from x1, got ${x2} for both`);
  }
  if (minY === maxY) {
    throw new RangeError(`${where}: y2 must differ from y1, got ${y2} for both`);
  }
  return [
    [minX, minY],
    [maxX, minY],
    [maxX, maxY],
    [minX, maxY],
  ];
}

/**
 * `numVertices` points evenly spread in angle on an ellipse around the origin, clockwise from the positive x-axis.
 * Diameters in m, > 0; at least three vertices.
 */
export function createRegularPolygonVertices(diameterX: number, diameterY: number, numVertices: number): Vec2[] {
  const where = 'createRegularPolygonVertices';
  const rx = positive(where, 'diameterX', diameterX) / 2;
  const ry = positive(where, 'diameterY', diameterY) / 2;
  integer(where, 'numVertices', numVertices, 3);
  const vertices: Vec2[] = [];
  for (let k = 0; k < numVertices; k += 1) {
    const angle = (k * 2 * Math.PI) / numVertices;
    vertices.push([rx * cos(angle), ry * sin(angle)]);
  }
  return vertices;
}

/**
 * Checks the vertices of a polygon and returns them flat, `[x0, y0, …]`, in clockwise order, without those that lie inside an edge.
 * Counter-clockwise input is reversed.
 *
 * @throws TypeError for anything but a list of points; RangeError, naming the vertex, unless the vertices are at least three, finite,
 * distinct and go once around a convex polygon.
 */
export function convexVertices(where: string, value: unknown): number[] {
  const list = value as ArrayLike<Vec2Like> | null | undefined;
  if (typeof list !== 'object' || list === null || typeof list.length !== 'number') {
    throw typeError(where, 'vertices', 'an array of vertices [x, y]', value);
  }
  const count = list.length;
  if (count < 3) {
    throw new RangeError(`${where}: vertices must have at least 3 vertices, got ${count}`);
  }
  const flat: number[] = [];
  for (let i = 0; i < count; i += 1) {
    const given = list[i];
    const point = isVector(given, 2, MAX_SIZE) ? given : vector(where, `vertices[${i}]`, given, 2, MAX_SIZE);
    flat.push(point[0]!, point[1]!);
  }
  refuseRepeats(where, flat);
  const reversed = polygonArea(flat) < 0;
  if (reversed) reverse(flat);
  return withoutCollinear(where, flat, reversed);
}

function refuseRepeats(where: string, flat: readonly number[]): void {
  const i = repeatedVertex(flat);
  if (i >= 0) {
    const j = (i + 1) % (flat.length / 2);
    const found = `vertex ${j} equal to vertex ${i}: [${flat[2 * j]}, ${flat[2 * j + 1]}]`;
    throw new RangeError(`${where}: vertices must be distinct, got ${found}`);
  }
}

/** The first vertex that the next one is equal to, or −1. */
export function repeatedVertex(flat: ArrayLike<number>): number {
  const count = flat.length / 2;
  for (let i = 0; i < count; i += 1) {
    const j = (i + 1) % count;
    const dx = flat[2 * j]! - flat[2 * i]!;
    const dy = flat[2 * j + 1]! - flat[2 * i + 1]!;
    if (dx * dx + dy * dy <= VERTEX_TOLERANCE * VERTEX_TOLERANCE) {
      return i;
    }
  }
  return -1;
}

function reverse(flat: number[]): void {
  for (let i = 0, j = flat.length - 2; i < j; i += 2, j -= 2) {
    const x = flat[i]!;
    const y = flat[i + 1]!;
    flat[i] = flat[j]!;
    flat[i + 1] = flat[j + 1]!;
    flat[j] = x;
    flat[j + 1] = y;
  }
}

/**
 * Every corner must turn clockwise or not at all, and all turns together must be one full turn: the x-direction of the
 * edges then changes its sign exactly twice. A path that winds twice (a pentagram) turns one way only, yet changes more often.
 */
function withoutCollinear(where: string, flat: readonly number[], reversed: boolean): number[] {
  const count = flat.length / 2;
  const kept: number[] = [];
  for (let i = 0; i < count; i += 1) {
    const before = (i + count - 1) % count;
    const after = (i + 1) % count;
    const x = flat[2 * i]!;
    const y = flat[2 * i + 1]!;
    const ax = x - flat[2 * before]!;
    const ay = y - flat[2 * before + 1]!;
    const bx = flat[2 * after]! - x;
    const by = flat[2 * after + 1]! - y;
    const turn = ax * by - ay * bx;
    const limit = COLLINEAR_TOLERANCE * Math.sqrt((ax * ax + ay * ay) * (bx * bx + by * by));
    if (turn > limit) {
      kept.push(x, y);
    } else if (turn < -limit || ax * bx + ay * by < 0) {
      const vertex = reversed ? count - 1 - i : i;
      const found = turn < -limit ? 'bending the other way' : 'turning straight back';
      throw notAround(where, `vertex ${vertex} ${found}: [${x}, ${y}]`);
    }
  }
  const winding = kept.length < 6 ? -1 : firstSecondRound(kept, count * COLLINEAR_TOLERANCE);
  if (winding !== 0) {
    throw notAround(where, winding < 0 ? 'all vertices on one line' : `a second round at vertex ${winding}`);
  }
  return kept;
}

function notAround(where: string, found: string): RangeError {
  return new RangeError(`${where}: vertices must go once around a convex polygon, got ${found}`);
}

/**
 * 0 for a path that goes round once; else the vertex at which the edges begin a second round. That shows in their direction along the
 * longer side of the bounds, which changes sign twice in a round. Edges that are square to it but for `slack` count as neither direction:
 * each corner that was left out may have bent back a little.
 */
function firstSecondRound(flat: readonly number[], slack: number): number {
  const count = flat.length / 2;
  const along = extent(flat, 0) >= extent(flat, 1) ? 0 : 1;
  const across = 1 - along;
  let changes = 0;
  let previous = 0;
  for (let i = 0; i <= count; i += 1) {
    const from = i % count;
    const to = (i + 1) % count;
    const way = flat[2 * to + along]! - flat[2 * from + along]!;
    const least = slack * Math.abs(flat[2 * to + across]! - flat[2 * from + across]!);
    const sign = way > least ? 1 : way < -least ? -1 : previous;
    if (previous !== 0 && sign !== previous) {
      changes += 1;
      if (changes > 2) {
        return from;
      }
    }
    previous = sign;
  }
  return 0;
}

/** The extent of a path along an axis, 0 or 1. */
function extent(flat: readonly number[], axis: number): number {
  let least = Infinity;
  let most = -Infinity;
  for (let i = axis; i < flat.length; i += 2) {
    least = Math.min(least, flat[i]!);
    most = Math.max(most, flat[i]!);
  }
  return most - least;
}
