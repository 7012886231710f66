import type { ColorLike, DebugLines } from './device.js';

/** Offsets and lengths in `DebugLines.vertices`. */
export const RED = 2;
export const VERTEX = 6;
export const SEGMENT = 2 * VERTEX;

/** Segments that gather over a frame. The buffer grows by doubling and stays, so that a warm frame allocates nothing. */
export class LineBuffer implements DebugLines {
  vertices = new Float64Array(256 * SEGMENT);
  segmentCount = 0;
  readonly mapping = new Float64Array(4);
  readonly clip = new Float64Array(4);
  /** Of the segments to come. */
  private readonly color = new Float64Array(4);

  setColor(color: ColorLike): void {
    for (let i = 0; i < 4; i += 1) {
      this.color[i] = color[i]!;
    }
  }

  add(x1: number, y1: number, x2: number, y2: number): void {
    const from = this.segmentCount * SEGMENT;
    if (from === this.vertices.length) {
      this.grow();
    }
    const { vertices, color } = this;
    const to = from + VERTEX;
    vertices[from] = x1;
    vertices[from + 1] = y1;
    vertices[to] = x2;
    vertices[to + 1] = y2;
    for (let i = 0; i < 4; i += 1) {
      vertices[from + RED + i] = color[i]!;
      vertices[to + RED + i] = color[i]!;
    }
    this.segmentCount += 1;
  }

  private grow(): void {
    const grown = new Float64Array(2 * this.vertices.length);
    grown.set(this.vertices);
    this.vertices = grown;
  }
}
