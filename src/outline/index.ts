/**
 * Outlines that are not convex: cut into convex parts, and made simpler.
 *
 * @module phys2d/outline
 */

import type { Vec2, Vec2Like } from '../math/vectors.js';
import { nonNegative } from '../validate.js';
import { Cuts } from './cuts.js';
import { areaOf, listed, type Ring, readRing, refuseCrossings, reversed, surrounds } from './ring.js';
import { simplified } from './simplify.js';

/**
 * Cuts the inside of an outline into convex parts, each for a polygon of its own: `createPolygonShape({ vertices })`. The parts meet
 * exactly, and all their corners are vertices of the outline. There are about as many as there are corners that bend inwards, and never
 * more than four times as many as needed. What lies across several of them does not notice where they meet.
 *
 * The vertices may go either way round. Vertices within an edge, or twice in a row, are dropped; of corners of a part within 1e-9 m of each
 * other, only one is kept. Takes about ten milliseconds for 100 vertices, and some tenths of a second for 1,000 of which most bend in or
 * out: `simplifyOutline` leaves out those that are not needed.
 *
 * @param outline Vertices `[x, y]` in order, m, at least three; edges must neither cross nor touch.
 * @param holes Outlines of what is not inside. Default none.
 * @throws TypeError for anything but lists of points; RangeError, which names the vertices, if edges meet, an outline has less than three
 * corners, a hole is not inside, or a needle is thinner than can be cut.
 */
export function decomposeOutline(outline: ArrayLike<Vec2Like>, holes: ArrayLike<ArrayLike<Vec2Like>> = []): Vec2[][] {
  const where = 'decomposeOutline';
  const outer = readRing(where, 'outline', outline);
  const inner = Array.from(listed(where, 'holes', holes, 'an array of outlines'), (hole, i) =>
    readRing(where, `holes[${i}]`, hole),
  );
  refuseCrossings(where, [outer, ...inner]);
  refuseOutside(where, outer, inner);
  const cuts = new Cuts(
    turned(outer, 1),
    inner.map((hole) => turned(hole, -1)),
  );
  cuts.cut();
  return cuts.parts();
}

function turned(ring: Ring, sign: number): Ring {
  return sign * areaOf(ring) < 0 ? reversed(ring) : ring;
}

function refuseOutside(where: string, outer: Ring, holes: readonly Ring[]): void {
  for (const hole of holes) {
    const x = hole.x[0]!;
    const y = hole.y[0]!;
    if (!surrounds(outer, x, y) || holes.some((other) => other !== hole && surrounds(other, x, y))) {
      throw new RangeError(
        `${where}: ${hole.name} must be inside the outline and beside the others, got vertex [${x}, ${y}]`,
      );
    }
  }
}

/**
 * Leaves out vertices of an outline, such as one traced from a picture, which has many: first those that matter the least, as long as no
 * vertex is farther from the new outline than `tolerance`. The new outline never crosses itself. Takes some tenths of a second for 10,000
 * vertices.
 *
 * @param outline Vertices `[x, y]` in order, m, at least three; edges must neither cross nor touch.
 * @param tolerance m, >= 0.
 * @returns some of the vertices, at least three.
 * @throws as `decomposeOutline`; RangeError for a negative tolerance.
 */
export function simplifyOutline(outline: ArrayLike<Vec2Like>, tolerance: number): Vec2[] {
  const where = 'simplifyOutline';
  const ring = readRing(where, 'outline', outline);
  nonNegative(where, 'tolerance', tolerance);
  refuseCrossings(where, [ring]);
  return simplified(ring, tolerance).map((i): Vec2 => [ring.x[i]!, ring.y[i]!]);
}
