import { widened } from '../math/doubles.js';
import type { ColorLike, DebugLines } from './device.js';

/** Offsets and lengths in `DebugLines.vertices`. */
export const RED = 2;
export const VERTEX = 6;
export const SEGMENT = 2 * VERTEX;

/** The segments of a frame. The buffer grows by doubling and stays, so that a warm frame allocates nothing. */
export class LineBuffer implements DebugLines {
  vertices = new Float64Array(256 * SEGMENT);
  segmentCount = 0;
  readonly mapping = new Float64Array(4);
  readonly clip = new Float64Array(4);
  /**
   * Where `lineToNext` goes. An array, as numbers passed from function to function may be boxed, which would make garbage for each segment.
   */
  readonly next = new Float64Array(2);
  private readonly last = new Float64Array(2);
  /** The colour of the segments to come. */
  private readonly color = new Float64Array(4);

  setColor(color: ColorLike): void {
    for (let i = 0; i < 4; i += 1) {
      this.color[i] = color[i]!;
    }
  }

  add(x1: number, y1: number, x2: number, y2: number): void {
    this.moveTo(x1, y1);
    this.next[0] = x2;
    this.next[1] = y2;
    this.lineToNext();
  }

  /** Where a polyline begins. */
  moveTo(x: number, y: number): void {
    this.last[0] = x;
    this.last[1] = y;
  }

  /** Adds a segment from where the polyline ends so far to `next`. */
  lineToNext(): void {
    const from = this.segmentCount * SEGMENT;
    if (from === this.vertices.length) {
      this.grow();
    }
    const { vertices, color, last, next } = this;
    const to = from + VERTEX;
    vertices[from] = last[0]!;
    vertices[from + 1] = last[1]!;
    vertices[to] = next[0]!;
    vertices[to + 1] = next[1]!;
    for (let i = 0; i < 4; i += 1) {
      vertices[from + RED + i] = color[i]!;
      vertices[to + RED + i] = color[i]!;
    }
    last[0] = next[0]!;
    last[1] = next[1]!;
    this.segmentCount += 1;
  }

  private grow(): void {
    this.vertices = widened(this.vertices, new Float64Array(2 * this.vertices.length));
  }
}
