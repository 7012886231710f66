import type { DebugLines } from './device.js';
import { RED, SEGMENT, VERTEX } from './lines.js';

/**
 * Maps the segments of a drawing to px and cuts them to its clip rectangle (Liang & Barsky 1984), in 64 bits: what reaches a device is
 * small, however far the ends of a line were, or how far from the origin the scene is.
 */
export class Cutter {
  /** x1, y1, x2, y2 of the segment that was cut last, px from the upper left. */
  readonly ends = new Float64Array(4);
  /** px = factor · m + offset, for x and y. */
  private readonly factor = new Float64Array(2);
  private readonly offset = new Float64Array(2);
  private readonly least = new Float64Array(2);
  private readonly most = new Float64Array(2);
  /** The part of the segment that is left, as a range of [0, 1]. */
  private readonly range = new Float64Array(2);

  /** Takes over the mapping to a device of so many px. */
  begin({ mapping, clip }: DebugLines, width: number, height: number): void {
    const { factor, offset, least, most } = this;
    factor[0] = (mapping[0]! * width) / 2;
    factor[1] = (-mapping[1]! * height) / 2;
    offset[0] = ((mapping[2]! + 1) * width) / 2;
    offset[1] = ((1 - mapping[3]!) * height) / 2;
    for (let i = 0; i < 2; i += 1) {
      least[i] = clip[i]!;
      most[i] = clip[i]! + clip[i + 2]!;
    }
  }

  /** Finds the ends of a segment. @returns whether any of it is to be seen. */
  cut(lines: DebugLines, segment: number): boolean {
    const { vertices } = lines;
    const { ends, factor, offset, range } = this;
    const at = segment * SEGMENT;
    range[0] = 0;
    range[1] = 1;
    for (let i = 0; i < 2; i += 1) {
      const from = factor[i]! * vertices[at + i]! + offset[i]!;
      const to = factor[i]! * vertices[at + VERTEX + i]! + offset[i]!;
      if (!this.cutAxis(from, to - from, this.least[i]!, this.most[i]!)) {
        return false;
      }
      ends[i] = from;
      ends[i + 2] = to;
    }
    const [start, end] = [range[0]!, range[1]!];
    for (let i = 0; i < 2; i += 1) {
      const from = ends[i]!;
      const way = ends[i + 2]! - from;
      if (start > 0) ends[i] = from + start * way;
      if (end < 1) ends[i + 2] = from + end * way;
    }
    return true;
  }

  private cutAxis(from: number, way: number, least: number, most: number): boolean {
    const { range } = this;
    if (way === 0) {
      return from >= least && from <= most;
    }
    const atLeast = (least - from) / way;
    const atMost = (most - from) / way;
    range[0] = Math.max(range[0]!, Math.min(atLeast, atMost));
    range[1] = Math.min(range[1]!, Math.max(atLeast, atMost));
    return range[0]! <= range[1]!;
  }
}

/** The colour of a segment as four bytes in a number: red is the lowest. */
export function packedColor({ vertices }: DebugLines, segment: number): number {
  const at = segment * SEGMENT + RED;
  return (
    (byte(vertices[at]!) |
      (byte(vertices[at + 1]!) << 8) |
      (byte(vertices[at + 2]!) << 16) |
      (byte(vertices[at + 3]!) << 24)) >>>
    0
  );
}

function byte(share: number): number {
  return Math.round(255 * share);
}

/** `rgb` of a packed colour, for CSS and SVG. */
export function redGreenBlue(color: number): string {
  return `${color & 255}, ${(color >>> 8) & 255}, ${(color >>> 16) & 255}`;
}

/** The alpha of a packed colour, to two digits. */
export function alphaOf(color: number): number {
  return Math.round((100 * (color >>> 24)) / 255) / 100;
}
