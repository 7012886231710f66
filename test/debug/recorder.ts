import { type DebugGraphicsDevice, type DebugLines, Physics2DDebugDraw } from '../../src/debug/index.js';

/** A segment as the device got it: its ends, m, and its colour. */
export interface Segment {
  readonly ends: readonly [x1: number, y1: number, x2: number, y2: number];
  readonly color: readonly number[];
}

export interface Frame {
  readonly segments: readonly Segment[];
  readonly mapping: readonly number[];
  readonly clip: readonly number[];
}

/** Keeps copies of all it is given. */
export class RecordingDevice implements DebugGraphicsDevice {
  readonly frames: Frame[] = [];
  destroyed = 0;

  constructor(
    public width: number,
    public height: number,
  ) {}

  drawLines(lines: DebugLines): void {
    const segments: Segment[] = [];
    for (let i = 0; i < lines.segmentCount; i += 1) {
      const [x1, y1, ...first] = lines.vertices.slice(12 * i, 12 * i + 6);
      const [x2, y2, ...second] = lines.vertices.slice(12 * i + 6, 12 * i + 12);
      if (String(first) !== String(second)) {
        throw new Error(`segment ${i} has two colours: ${first} and ${second}`);
      }
      segments.push({ ends: [x1!, y1!, x2!, y2!], color: first });
    }
    this.frames.push({ segments, mapping: Array.from(lines.mapping), clip: Array.from(lines.clip) });
  }

  destroy(): void {
    this.destroyed += 1;
  }
}

/** A device of 600 × 600 px and what draws on it, at 60 px per metre. */
export function recorder(width = 600, height = 600): { device: RecordingDevice; debug: Physics2DDebugDraw } {
  const device = new RecordingDevice(width, height);
  return { device, debug: Physics2DDebugDraw.create({ graphicsDevice: device }) };
}

/** What is drawn in one frame of a new recorder. */
export function draw(what: (debug: Physics2DDebugDraw) => void): readonly Segment[] {
  const { device, debug } = recorder();
  debug.begin();
  what(debug);
  debug.end();
  return device.frames[0]?.segments ?? [];
}

/** The points that segments go through; they have to hang together. */
export function polyline(segments: readonly Segment[]): readonly (readonly [x: number, y: number])[] {
  return segments.flatMap(({ ends: [x1, y1, x2, y2] }, i) => {
    const [, , x0, y0] = segments[i - 1]?.ends ?? [x1, y1, x1, y1];
    if (x0 !== x1 || y0 !== y1) {
      throw new Error(`segment ${i} begins at (${x1}, ${y1}), where none ends`);
    }
    return i === 0
      ? [
          [x1, y1],
          [x2, y2],
        ]
      : [[x2, y2]];
  });
}

/** Runs of segments of one colour: how many, and which. */
export function runs(segments: readonly Segment[]): { color: readonly number[]; segments: Segment[] }[] {
  const found: { color: readonly number[]; segments: Segment[] }[] = [];
  for (const segment of segments) {
    const last = found.at(-1);
    if (last !== undefined && String(last.color) === String(segment.color)) {
      last.segments.push(segment);
    } else {
      found.push({ color: segment.color, segments: [segment] });
    }
  }
  return found;
}

export const RED = [1, 0, 0, 1] as const;
