import type { DebugLines } from './device.js';
import { RED, SEGMENT, VERTEX } from './lines.js';

/**
 * Maps the segments of a drawing to px and clips them to its clip rectangle (Liang & Barsky 1984), in 64 bits: so coordinates that reach a
 * device are small, however far away the ends of a line were, or how far from the origin the scene is.
 */
export class Cutter {
  /** x1, y1, x2, y2 of the segment that was clipped last, px from the upper left. */
  readonly ends = new Float64Array(4);
  /** px = factor · m + offset, for x and y. */
  private readonly factor = new Float64Array(2);
  private readonly offset = new Float64Array(2);
  private readonly least = new Float64Array(2);
  private readonly most = new Float64Array(2);
  /** Where the segment enters between two sides, and where it leaves, for x and y: 0 at its nearer end, 1 or −1 at the other one. */
  private readonly enter = new Float64Array(2);
  private readonly leave = new Float64Array(2);

  /** Takes over the mapping of a drawing, and the size of the device in px. */
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

  /** Finds the clipped ends of a segment. @returns whether any of it is visible. */
  cut(lines: DebugLines, segment: number): boolean {
    const { vertices } = lines;
    const { ends, factor, offset, enter, leave } = this;
    const at = segment * SEGMENT;
    for (let i = 0; i < 2; i += 1) {
      ends[i] = factor[i]! * vertices[at + i]! + offset[i]!;
      ends[i + 2] = factor[i]! * vertices[at + VERTEX + i]! + offset[i]!;
    }
    // Measured from the nearer end, as small numbers added to those of an end that is very far away would be lost.
    const away = Math.abs(ends[0]!) + Math.abs(ends[1]!);
    const near = away < Infinity && away > Math.abs(ends[2]!) + Math.abs(ends[3]!) ? 1 : 0;
    this.meetSides(0, near);
    this.meetSides(1, near);
    const start = Math.max(-near, enter[0]!, enter[1]!);
    const end = Math.min(1 - near, leave[0]!, leave[1]!);
    // Also false for NaN, which ends give that are too far away for px.
    if (!(start <= end)) {
      return false;
    }
    for (let i = 0; i < 2; i += 1) {
      const from = ends[i + 2 * near]!;
      const way = ends[i + 2]! - ends[i]!;
      // A segment that a side clips ends right there, which the sum would miss if the segment is very long.
      if (start > -near) {
        ends[i] = start === enter[i] ? this.side(i, way < 0) : from + start * way;
      }
      if (end < 1 - near) {
        ends[i + 2] = end === leave[i] ? this.side(i, way > 0) : from + end * way;
      }
    }
    return true;
  }

  private meetSides(i: number, near: number): void {
    const from = this.ends[i + 2 * near]!;
    const way = this.ends[i + 2]! - this.ends[i]!;
    const toLeast = this.least[i]! - from;
    const toMost = this.most[i]! - from;
    if (way === 0) {
      const within = toLeast <= 0 && toMost >= 0;
      this.enter[i] = within ? -Infinity : Infinity;
      this.leave[i] = Infinity;
    } else {
      this.enter[i] = Math.min(toLeast / way, toMost / way);
      this.leave[i] = Math.max(toLeast / way, toMost / way);
    }
  }

  private side(i: number, upper: boolean): number {
    return upper ? this.most[i]! : this.least[i]!;
  }
}

/** The colour of a segment as four bytes in a number, red lowest. */
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

/** The numbers of `rgb(…)` for a packed colour, for CSS and SVG. */
export function redGreenBlue(color: number): string {
  return `${color & 255}, ${(color >>> 8) & 255}, ${(color >>> 16) & 255}`;
}

/** The alpha of a packed colour, to two decimals. */
export function alphaOf(color: number): number {
  return Math.round((100 * (color >>> 24)) / 255) / 100;
}
