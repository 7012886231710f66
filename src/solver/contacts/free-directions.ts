import { FACE_SLIT, FLUSH_TOLERANCE } from '../../config.js';
import { EDGE_NX, EDGE_NY, EDGE_STRIDE, EDGES } from '../../geometry/layout.js';
import type { Polygon } from '../../shape/polygon.js';

// Where grounds lie side by side, only part of their corners is surface. Around a point each ground fills a wedge of directions; what all
// of them leave is free. The surface may carry something in the directions of the normals of the faces on either side of the free part, and
// in all directions between these where it is a ridge.

/**
 * What a direction is at a point: one in which the surface may carry; one in which it may not, though there is another one; or there is no
 * surface.
 */
export const RIGHT = 0;
export const WRONG = 1;
export const BURIED = 2;

/** Right angles. Rounding. */
const ROUNDING = 1e-9;

/** A wedge: where it begins and ends, as 0 to 4 around the direction that is asked about, and the outward normals of the faces there. */
const FROM = 0;
const TO = 1;
const FROM_X = 2;
const FROM_Y = 3;
const TO_X = 4;
const TO_Y = 5;
const STRIDE = 6;
/** At most so many wedges are kept at a point; the others are left out. */
const MOST = 32;

export class FreeDirections {
  /** The unit vector that is asked about, out of the surface; if it is wrong, then the normal of the face that is right instead. */
  x = 0.5;
  y = 0.5;
  private readonly wedges = new Float64Array(STRIDE * MOST);
  private count = 0;
  private isWithin = false;

  /** Starts at a new point. The direction is set already. */
  begin(): void {
    this.count = 0;
    this.isWithin = false;
  }

  /** Adds the wedge that a placed polygon fills around a point, if there is one. The point is given relative to its body. */
  add({ numbers: edges, at, offsets }: Polygon, point: Float64Array): void {
    const px = point[0]!;
    const py = point[1]!;
    const to = STRIDE * this.count;
    const w = this.wedges;
    const last = at + EDGES + EDGE_STRIDE * (offsets.length - 1);
    let isWedge = false;
    let highest = -Infinity;
    for (let i = 0; i < offsets.length; i += 1) {
      const k = at + EDGES + EDGE_STRIDE * i;
      const nx = edges[k + EDGE_NX]!;
      const ny = edges[k + EDGE_NY]!;
      const height = nx * px + ny * py - offsets[i]!;
      if (height > FLUSH_TOLERANCE) {
        return;
      }
      highest = Math.max(highest, height);
      if (height >= -FLUSH_TOLERANCE && this.count < MOST) {
        const next = k === last ? at + EDGES : k + EDGE_STRIDE;
        const isPast = nx * (py - edges[next + 1]!) - ny * (px - edges[next]!) > FLUSH_TOLERANCE;
        const isBefore = nx * (py - edges[k + 1]!) - ny * (px - edges[k]!) < -FLUSH_TOLERANCE;
        if (!isPast && !isBefore) {
          cut(w, to, edges, k + EDGE_NX, isWedge);
          isWedge = true;
        }
      }
    }
    if (isWedge) {
      this.measure(w, to + FROM, to + FROM_X, 1);
      this.measure(w, to + TO, to + TO_X, -1);
      this.count += 1;
    } else if (highest < -FLUSH_TOLERANCE) {
      this.isWithin = true;
    }
  }

  /**
   * Writes where a wedge begins beside a face, or with `sign` −1 where it ends: from 0 to 4, 1 for each right angle from the direction that
   * is asked about. Between, it only grows with the angle, which is all that matters.
   */
  private measure(w: Float64Array, to: number, face: number, sign: number): void {
    const dx = -sign * w[face + 1]!;
    const dy = sign * w[face]!;
    const along = this.x * dx + this.y * dy;
    const across = this.x * dy - this.y * dx;
    const share = across / (Math.abs(along) + Math.abs(across));
    w[to] = along < 0 ? 2 - share : across < 0 ? 4 + share : share;
  }

  /** Says what the direction is. If it is wrong, `x` and `y` become the normal of the next face that is right. */
  judge(): number {
    if (this.isWithin) {
      return BURIED;
    }
    const { wedges: w } = this;
    const end = STRIDE * this.count;
    let isFilled = false;
    for (let k = 0; k < end; k += STRIDE) {
      isFilled ||= w[k + FROM]! > w[k + TO]!;
    }
    // The wedges next to the direction on either side; or, if some fill it, these and those that adjoin them.
    let to = -1;
    let from = 5;
    let before = 0;
    let after = 0;
    for (let grows = true; grows; ) {
      grows = false;
      for (let k = 0; k < end; k += STRIDE) {
        const begins = w[k + FROM]!;
        const ends = w[k + TO]!;
        const holds = begins > ends;
        if (ends > to && (holds || !isFilled || begins <= to + FACE_SLIT)) {
          to = ends;
          before = k;
          grows = true;
        }
        if (begins < from && (holds || !isFilled || ends >= from - FACE_SLIT)) {
          from = begins;
          after = k;
          grows = true;
        }
      }
    }
    if (isFilled ? to >= from - FACE_SLIT : from + 4 - to < FACE_SLIT) {
      return BURIED;
    }
    if (!isFilled && from >= 1 - ROUNDING && to <= 3 + ROUNDING) {
      return RIGHT;
    }
    const alongBefore = this.x * w[before + TO_X]! + this.y * w[before + TO_Y]!;
    const alongAfter = this.x * w[after + FROM_X]! + this.y * w[after + FROM_Y]!;
    const face = alongBefore > alongAfter ? before + TO_X : after + FROM_X;
    this.x = w[face]!;
    this.y = w[face + 1]!;
    return WRONG;
  }
}

/**
 * Cuts off from a wedge what is beyond a face, whose normal is at `face` in the numbers of the polygon: the wedge is then a half-plane, or
 * what is left of one.
 */
function cut(w: Float64Array, to: number, edges: Float64Array, face: number, isWedge: boolean): void {
  const nx = edges[face]!;
  const ny = edges[face + 1]!;
  // The wedge begins a quarter turn on from the first normal, and ends a quarter turn back from the second.
  const fromX = -w[to + FROM_Y]!;
  const fromY = w[to + FROM_X]!;
  const toX = w[to + TO_Y]!;
  const toY = -w[to + TO_X]!;
  const cutsFrom = !isWedge || (fromX * nx + fromY * ny > 0 && -ny * toY - nx * toX > 0);
  const cutsTo = !isWedge || (-fromX * nx - fromY * ny > 0 && ny * toY + nx * toX > 0);
  if (cutsFrom) {
    w[to + FROM_X] = nx;
    w[to + FROM_Y] = ny;
  }
  if (cutsTo) {
    w[to + TO_X] = nx;
    w[to + TO_Y] = ny;
  }
}
