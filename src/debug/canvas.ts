import { options, positive, typeError } from '../validate.js';
import { alphaOf, Cutter, packedColor, redGreenBlue } from './cutter.js';
import type { DebugGraphicsDevice, DebugLines } from './device.js';

/** What `CanvasDebugDevice` uses of a `CanvasRenderingContext2D` or `OffscreenCanvasRenderingContext2D`. */
export interface CanvasContextLike {
  readonly canvas: { readonly width: number; readonly height: number };
  strokeStyle: unknown;
  lineWidth: number;
  lineCap: string;
  lineJoin: string;
  globalAlpha: number;
  globalCompositeOperation: string;
  save(): void;
  restore(): void;
  setLineDash(lengths: number[]): void;
  setTransform(a: number, b: number, c: number, d: number, e: number, f: number): void;
  beginPath(): void;
  moveTo(x: number, y: number): void;
  lineTo(x: number, y: number): void;
  stroke(): void;
}

/** Options of `CanvasDebugDevice.create`. */
export interface CanvasDebugDeviceParams {
  /** The 2D context of a canvas. Lines are drawn over what it shows; its state is kept. */
  context: CanvasContextLike;
  /** px, > 0. Default 1. */
  lineWidth?: number | undefined;
}

/** The most segments of a path that is stroked at once: browsers take far more time for one long path than for several short ones. */
const MAX_PATH = 500;

/** Draws debug lines on a 2D canvas. Good for some ten thousand lines; for more, use `WebGLDebugDevice`. */
export class CanvasDebugDevice implements DebugGraphicsDevice {
  private readonly context: CanvasContextLike;
  private readonly lineWidth: number;
  private readonly cutter = new Cutter();
  /** The styles of the canvas for packed colours. */
  private readonly styles = new Map<number, string>();

  /** @internal use `create` */
  constructor(params: CanvasDebugDeviceParams) {
    const where = 'CanvasDebugDevice.create';
    const { context, lineWidth = 1 } = options(where, params, true);
    if (typeof context?.lineTo !== 'function' || typeof context.canvas !== 'object') {
      throw typeError(where, 'context', 'the 2D context of a canvas', context);
    }
    this.lineWidth = positive(where, 'lineWidth', lineWidth);
    this.context = context;
  }

  /** Makes a device that draws on a 2D context. */
  static create(params: CanvasDebugDeviceParams): CanvasDebugDevice {
    return new CanvasDebugDevice(params);
  }

  get width(): number {
    return this.context.canvas.width;
  }

  get height(): number {
    return this.context.canvas.height;
  }

  /** Draws on the canvas, over what is there. */
  drawLines(lines: DebugLines): void {
    const { context, cutter } = this;
    const { ends } = cutter;
    cutter.begin(lines, this.width, this.height);
    context.save();
    context.setTransform(1, 0, 0, 1, 0, 0);
    context.lineWidth = this.lineWidth;
    context.lineCap = 'butt';
    context.lineJoin = 'round';
    context.setLineDash([]);
    context.globalAlpha = 1;
    context.globalCompositeOperation = 'source-over';
    let color = -1;
    let length = 0;
    let x = NaN;
    let y = NaN;
    for (let i = 0; i < lines.segmentCount; i += 1) {
      if (cutter.cut(lines, i)) {
        const next = packedColor(lines, i);
        if (next !== color || length === MAX_PATH) {
          this.stroke(length);
          context.strokeStyle = this.style(next);
          color = next;
          length = 0;
          x = NaN;
        }
        if (x !== ends[0] || y !== ends[1]) {
          context.moveTo(ends[0]!, ends[1]!);
        }
        x = ends[2]!;
        y = ends[3]!;
        context.lineTo(x, y);
        length += 1;
      }
    }
    this.stroke(length);
    context.restore();
  }

  /** Strokes the path, if it has segments, and begins the next. */
  private stroke(length: number): void {
    if (length > 0) {
      this.context.stroke();
    }
    this.context.beginPath();
  }

  private style(color: number): string {
    let style = this.styles.get(color);
    if (style === undefined) {
      style = `rgba(${redGreenBlue(color)}, ${alphaOf(color)})`;
      this.styles.set(color, style);
    }
    return style;
  }
}
