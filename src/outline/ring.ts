import { COLLINEAR_TOLERANCE, MAX_SIZE, VERTEX_TOLERANCE } from '../config.js';
import type { Vec2Like } from '../math/vectors.js';
import { typeError, vector } from '../validate.js';
import { Grid } from './grid.js';
import { orient } from './orient.js';

/** A closed outline, and the indices of its vertices in the given list. */
export interface Ring {
  readonly name: string;
  readonly x: number[];
  readonly y: number[];
  readonly given: number[];
}

/** A value as a list. @throws TypeError if it has no length. */
export function listed<T>(where: string, name: string, value: unknown, what: string): ArrayLike<T> {
  const list = value as ArrayLike<T> | null | undefined;
  if (typeof list !== 'object' || list === null || typeof list.length !== 'number') {
    throw typeError(where, name, what, value);
  }
  return list;
}

/** The vertices of an outline, without those at the place of the one before, and those within an edge. */
export function readRing(where: string, name: string, value: unknown): Ring {
  const vertices = listed<Vec2Like>(where, name, value, 'an array of vertices [x, y]');
  const all: Ring = { name, x: [], y: [], given: [] };
  for (let i = 0; i < vertices.length; i += 1) {
    const point = vector(where, `${name}[${i}]`, vertices[i], 2, MAX_SIZE);
    all.x.push(point[0]!);
    all.y.push(point[1]!);
    all.given.push(i);
  }
  const ring = keep(keep(all, isNew), isCorner);
  if (ring.x.length < 3) {
    throw new RangeError(`${where}: ${name} must have at least 3 corners, got ${ring.x.length}`);
  }
  return ring;
}

function keep(ring: Ring, wanted: (ring: Ring, i: number) => boolean): Ring {
  const at = ring.x.map((_, i) => i).filter((i) => wanted(ring, i));
  return {
    name: ring.name,
    x: at.map((i) => ring.x[i]!),
    y: at.map((i) => ring.y[i]!),
    given: at.map((i) => ring.given[i]!),
  };
}

function isNew({ x, y }: Ring, i: number): boolean {
  const before = (i + x.length - 1) % x.length;
  const dx = x[i]! - x[before]!;
  const dy = y[i]! - y[before]!;
  return i === before || dx * dx + dy * dy > VERTEX_TOLERANCE * VERTEX_TOLERANCE;
}

function isCorner({ x, y }: Ring, i: number): boolean {
  const before = (i + x.length - 1) % x.length;
  const after = (i + 1) % x.length;
  return bend(x[before]!, y[before]!, x[i]!, y[i]!, x[after]!, y[after]!) !== STRAIGHT;
}

/** How a path bends at the second of three points; straight on within the tolerance of a convex polygon. */
const STRAIGHT = 0;
export const LEFT = -1;
export const RIGHT = 1;

/** How a path bends at its second point. One that goes straight back bends to the left, as no convex polygon has that. */
export function bend(ax: number, ay: number, bx: number, by: number, cx: number, cy: number): number {
  const ux = bx - ax;
  const uy = by - ay;
  const vx = cx - bx;
  const vy = cy - by;
  const turn = ux * vy - uy * vx;
  const limit = COLLINEAR_TOLERANCE * Math.sqrt((ux * ux + uy * uy) * (vx * vx + vy * vy));
  if (turn > limit) {
    return RIGHT;
  }
  return turn < -limit || ux * vx + uy * vy < 0 ? LEFT : STRAIGHT;
}

/** Twice the area, positive if the vertices go around from the x- to the y-axis. */
export function areaOf({ x, y }: Ring): number {
  let area = 0;
  for (let i = x.length - 1, j = 0; j < x.length; i = j, j += 1) {
    area += (x[i]! - x[0]!) * (y[j]! - y[0]!) - (x[j]! - x[0]!) * (y[i]! - y[0]!);
  }
  return area;
}

export function reversed({ name, x, y, given }: Ring): Ring {
  return { name, x: [...x].reverse(), y: [...y].reverse(), given: [...given].reverse() };
}

/** Whether a ring goes around a point that is not on it. */
export function surrounds({ x, y }: Ring, px: number, py: number): boolean {
  let inside = false;
  for (let i = x.length - 1, j = 0; j < x.length; i = j, j += 1) {
    if (y[i]! > py !== y[j]! > py) {
      const side = orient(x[i]!, y[i]!, x[j]!, y[j]!, px, py);
      inside = side > 0 === y[j]! > y[i]! ? !inside : inside;
    }
  }
  return inside;
}

/** An edge of a ring, from one vertex to the next. */
interface Edge {
  readonly ring: Ring;
  readonly from: number;
  readonly to: number;
  /** Its index among the edges of all rings. */
  readonly place: number;
}

/** @throws RangeError if two edges cross or touch each other elsewhere than at a corner that they share. */
export function refuseCrossings(where: string, rings: readonly Ring[]): void {
  const edges = rings
    .flatMap((ring) => ring.x.map((_, from) => ({ ring, from, to: (from + 1) % ring.x.length })))
    .map((edge, place): Edge => ({ ...edge, place }));
  const grid = new Grid<Edge>(
    rings.flatMap(({ x }) => x),
    rings.flatMap(({ y }) => y),
  );
  const along = ({ ring: { x, y }, from, to }: Edge, visit: (cell: Edge[]) => unknown) =>
    grid.along(x[from]!, y[from]!, x[to]!, y[to]!, visit);
  for (const edge of edges) {
    along(edge, (cell) => void cell.push(edge));
  }
  for (const edge of edges) {
    let met: Edge | undefined;
    along(edge, (cell) => {
      for (const other of cell) {
        if (other.place > edge.place && (met === undefined || other.place < met.place) && meets(edge, other))
          met = other;
      }
    });
    if (met !== undefined) {
      throw new RangeError(
        `${where}: edges must neither cross nor touch, got the edge from ${nameOf(edge)} meeting that from ${nameOf(met)}`,
      );
    }
  }
}

function nameOf({ ring, from }: Edge): string {
  return `vertex ${ring.given[from]} of ${ring.name}`;
}

function meets(one: Edge, other: Edge): boolean {
  const { x, y } = one.ring;
  const o = other.ring;
  if (one.ring === o && (one.to === other.from || other.to === one.from)) {
    return goesBack(one.ring, one.from, other.from);
  }
  return segmentsTouch(
    x[one.from]!,
    y[one.from]!,
    x[one.to]!,
    y[one.to]!,
    o.x[other.from]!,
    o.y[other.from]!,
    o.x[other.to]!,
    o.y[other.to]!,
  );
}

/** Whether one of two neighbouring edges goes back along the other. */
function goesBack({ x, y }: Ring, i: number, k: number): boolean {
  const count = x.length;
  const [first, corner] = (i + 1) % count === k ? [i, k] : [k, i];
  const last = (corner + 1) % count;
  const side = orient(x[first]!, y[first]!, x[corner]!, y[corner]!, x[last]!, y[last]!);
  const along = (x[corner]! - x[first]!) * (x[last]! - x[corner]!) + (y[corner]! - y[first]!) * (y[last]! - y[corner]!);
  return side === 0 && along < 0;
}

/** Whether two segments have a point in common. */
export function segmentsTouch(
  ax: number,
  ay: number,
  bx: number,
  by: number,
  cx: number,
  cy: number,
  dx: number,
  dy: number,
): boolean {
  if (
    (ax < cx && ax < dx && bx < cx && bx < dx) ||
    (ax > cx && ax > dx && bx > cx && bx > dx) ||
    (ay < cy && ay < dy && by < cy && by < dy) ||
    (ay > cy && ay > dy && by > cy && by > dy)
  ) {
    return false;
  }
  // Their bounds overlap: that is enough if they are on one line.
  const c = orient(ax, ay, bx, by, cx, cy);
  const d = orient(ax, ay, bx, by, dx, dy);
  const a = orient(cx, cy, dx, dy, ax, ay);
  const b = orient(cx, cy, dx, dy, bx, by);
  return !((c > 0 && d > 0) || (c < 0 && d < 0) || (a > 0 && b > 0) || (a < 0 && b < 0));
}

/** Whether a point is on a segment. */
export function isOn(ax: number, ay: number, bx: number, by: number, px: number, py: number): boolean {
  return (
    px >= Math.min(ax, bx) &&
    px <= Math.max(ax, bx) &&
    py >= Math.min(ay, by) &&
    py <= Math.max(ay, by) &&
    orient(ax, ay, bx, by, px, py) === 0
  );
}
