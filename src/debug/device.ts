/** A colour `[r, g, b, a]`, each from 0 to 1; alpha is not multiplied in. Any array, tuple or typed array with at least four numbers. */
export type ColorLike = ArrayLike<number>;

/** A line drawing, for a `DebugGraphicsDevice`. Valid until `drawLines` returns; do not keep or change it. */
export interface DebugLines {
  /** Two vertices for each segment, six numbers for each vertex: x, y in physics coordinates, m, then r, g, b, a of the segment. */
  readonly vertices: Float64Array;
  /** Number of segments. What comes after them in `vertices` is old. */
  readonly segmentCount: number;
  /** `[c0, c1, c2, c3]`: in clip space, where the device spans −1 to 1 and y points up, a vertex is at `(x * c0 + c2, y * c1 + c3)`. */
  readonly mapping: ArrayLike<number>;
  /** The clip rectangle `[x, y, width, height]`, px from the upper left: nothing may be visible outside of it. */
  readonly clip: ArrayLike<number>;
}

/** What `Physics2DDebugDraw` draws with: a device of your own, or one of `CanvasDebugDevice`, `WebGLDebugDevice` and `SVGDebugDevice`. */
export interface DebugGraphicsDevice {
  /** px. */
  readonly width: number;
  /** px. */
  readonly height: number;
  /** Draws the segments in their order, cut to the clip rectangle, with alpha blending and without depth test. */
  drawLines(lines: DebugLines): void;
  /** Releases what the device holds. */
  destroy?(): void;
}
