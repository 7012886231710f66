import { optional, options, positive, typeError } from '../validate.js';
import { Cutter, packedColor } from './cutter.js';
import type { DebugGraphicsDevice, DebugLines } from './device.js';
import { SEGMENT } from './lines.js';

/** What `WebGLDebugDevice` uses of a `WebGL2RenderingContext`. */
export interface WebGL2ContextLike {
  readonly drawingBufferWidth: number;
  readonly drawingBufferHeight: number;
  readonly ARRAY_BUFFER: number;
  readonly BLEND: number;
  readonly COMPILE_STATUS: number;
  readonly CULL_FACE: number;
  readonly DEPTH_TEST: number;
  readonly DYNAMIC_DRAW: number;
  readonly FLOAT: number;
  readonly FRAGMENT_SHADER: number;
  readonly LINK_STATUS: number;
  readonly ONE: number;
  readonly ONE_MINUS_SRC_ALPHA: number;
  readonly SCISSOR_TEST: number;
  readonly SRC_ALPHA: number;
  readonly STENCIL_TEST: number;
  readonly TRIANGLE_STRIP: number;
  readonly UNSIGNED_BYTE: number;
  readonly VERTEX_SHADER: number;
  attachShader(program: unknown, shader: unknown): void;
  bindAttribLocation(program: unknown, index: number, name: string): void;
  bindBuffer(target: number, buffer: unknown): void;
  bindVertexArray(array: unknown): void;
  blendFuncSeparate(srcRGB: number, dstRGB: number, srcAlpha: number, dstAlpha: number): void;
  bufferData(target: number, size: number, usage: number): void;
  bufferSubData(target: number, offset: number, data: Uint8Array, start: number, length: number): void;
  compileShader(shader: unknown): void;
  createBuffer(): unknown;
  createProgram(): unknown;
  createShader(type: number): unknown;
  createVertexArray(): unknown;
  deleteBuffer(buffer: unknown): void;
  deleteProgram(program: unknown): void;
  deleteShader(shader: unknown): void;
  deleteVertexArray(array: unknown): void;
  disable(capability: number): void;
  drawArraysInstanced(mode: number, first: number, count: number, instanceCount: number): void;
  enable(capability: number): void;
  enableVertexAttribArray(index: number): void;
  getProgramInfoLog(program: unknown): string | null;
  getProgramParameter(program: unknown, name: number): unknown;
  getUniformLocation(program: unknown, name: string): unknown;
  isContextLost(): boolean;
  linkProgram(program: unknown): void;
  shaderSource(shader: unknown, source: string): void;
  uniform2f(location: unknown, x: number, y: number): void;
  uniform1f(location: unknown, x: number): void;
  useProgram(program: unknown): void;
  vertexAttribDivisor(index: number, divisor: number): void;
  vertexAttribPointer(
    index: number,
    size: number,
    type: number,
    normalized: boolean,
    stride: number,
    offset: number,
  ): void;
  viewport(x: number, y: number, width: number, height: number): void;
}

export interface WebGLDebugDeviceParams {
  /** A WebGL 2 context. */
  context: WebGL2ContextLike;
  /** px, > 0. Default 1. */
  lineWidth?: number | undefined;
}

/** What a segment takes in the buffer: four numbers of 32 bits for its ends, px, then its colour in four bytes. */
const STRIDE = 5;
const COLOR = 4;
const BYTES = 4 * STRIDE;

const ENDS_INDEX = 0;
const COLOR_INDEX = 1;

/** Each segment is a strip of two triangles, wider than its line by half a px on each side, over which the line fades. */
const VERTEX_SHADER = `#version 300 es
uniform vec2 screen;
uniform float reach;
in vec4 ends;
in vec4 color;
out vec4 ink;
out float across;
void main() {
  vec2 way = ends.zw - ends.xy;
  float size = length(way);
  vec2 along = size > 0.0 ? way / size : vec2(1.0, 0.0);
  float side = gl_VertexID < 2 ? -1.0 : 1.0;
  vec2 end = (gl_VertexID & 1) == 0 ? ends.xy : ends.zw;
  vec2 px = end + side * reach * vec2(-along.y, along.x);
  ink = color;
  across = side * reach;
  gl_Position = vec4(2.0 * px.x / screen.x - 1.0, 1.0 - 2.0 * px.y / screen.y, 0.0, 1.0);
}`;

const FRAGMENT_SHADER = `#version 300 es
precision highp float;
uniform float reach;
in vec4 ink;
in float across;
out vec4 shown;
void main() {
  shown = vec4(ink.rgb, ink.a * min(1.0, reach - abs(across)));
}`;

/** What lives in the context. */
interface Parts {
  readonly program: unknown;
  readonly array: unknown;
  readonly buffer: unknown;
  readonly screen: unknown;
  readonly reach: unknown;
}

/**
 * Draws debug lines with WebGL 2, in one draw call a frame: good for 100,000 lines and more. On top of what the canvas shows, without depth or
 * stencil test. It leaves blending on and both tests, culling and scissors off, the viewport at the whole canvas, and no program, vertex array or
 * buffer bound. After a lost context it goes on when there is one again.
 */
export class WebGLDebugDevice implements DebugGraphicsDevice {
  private readonly context: WebGL2ContextLike;
  private readonly lineWidth: number;
  private readonly cutter = new Cutter();
  private parts: Parts | null = null;
  /** The same memory as numbers of both sorts, and as what is sent. */
  private places = new Float32Array(0);
  private colors = new Uint32Array(0);
  private bytes = new Uint8Array(0);
  /** How much of it the buffer in the context has room for. */
  private room = 0;

  /** @internal use `create` */
  constructor(params: WebGLDebugDeviceParams) {
    const where = 'WebGLDebugDevice.create';
    const given = options(where, params, true);
    const context = given.context;
    if (typeof context?.drawArraysInstanced !== 'function') {
      throw typeError(where, 'context', 'a WebGL 2 context', context);
    }
    this.lineWidth = positive(where, 'lineWidth', optional(given.lineWidth, 1));
    this.context = context;
  }

  static create(params: WebGLDebugDeviceParams): WebGLDebugDevice {
    return new WebGLDebugDevice(params);
  }

  get width(): number {
    return this.context.drawingBufferWidth;
  }

  get height(): number {
    return this.context.drawingBufferHeight;
  }

  /** Draws over what the canvas shows. @throws Error if the browser refuses the shaders. */
  drawLines(lines: DebugLines): void {
    const { context: gl } = this;
    if (gl.isContextLost()) {
      this.parts = null;
      return;
    }
    this.parts ??= this.build();
    const { parts } = this;
    const count = this.pack(lines);
    gl.bindBuffer(gl.ARRAY_BUFFER, parts.buffer);
    if (this.room < this.bytes.length) {
      this.room = this.bytes.length;
      gl.bufferData(gl.ARRAY_BUFFER, this.room, gl.DYNAMIC_DRAW);
    }
    gl.bufferSubData(gl.ARRAY_BUFFER, 0, this.bytes, 0, count * BYTES);
    gl.bindBuffer(gl.ARRAY_BUFFER, null);
    gl.viewport(0, 0, this.width, this.height);
    gl.enable(gl.BLEND);
    gl.blendFuncSeparate(gl.SRC_ALPHA, gl.ONE_MINUS_SRC_ALPHA, gl.ONE, gl.ONE_MINUS_SRC_ALPHA);
    gl.disable(gl.DEPTH_TEST);
    gl.disable(gl.STENCIL_TEST);
    gl.disable(gl.CULL_FACE);
    gl.disable(gl.SCISSOR_TEST);
    gl.useProgram(parts.program);
    gl.uniform2f(parts.screen, this.width, this.height);
    gl.uniform1f(parts.reach, (this.lineWidth + 1) / 2);
    gl.bindVertexArray(parts.array);
    gl.drawArraysInstanced(gl.TRIANGLE_STRIP, 0, 4, count);
    gl.bindVertexArray(null);
    gl.useProgram(null);
  }

  /** Deletes what it has in the context. */
  destroy(): void {
    const { context: gl, parts } = this;
    if (parts !== null) {
      gl.deleteProgram(parts.program);
      gl.deleteVertexArray(parts.array);
      gl.deleteBuffer(parts.buffer);
      this.parts = null;
    }
  }

  /** Puts what is to be seen into the memory that is sent. @returns how many segments. */
  private pack(lines: DebugLines): number {
    const { cutter } = this;
    const { ends } = cutter;
    if (this.places.length < lines.segmentCount * STRIDE) {
      this.places = new Float32Array((lines.vertices.length / SEGMENT) * STRIDE);
      this.colors = new Uint32Array(this.places.buffer);
      this.bytes = new Uint8Array(this.places.buffer);
    }
    const { places, colors } = this;
    cutter.begin(lines, this.width, this.height);
    let at = 0;
    for (let i = 0; i < lines.segmentCount; i += 1) {
      if (cutter.cut(lines, i)) {
        places[at] = ends[0]!;
        places[at + 1] = ends[1]!;
        places[at + 2] = ends[2]!;
        places[at + 3] = ends[3]!;
        colors[at + COLOR] = packedColor(lines, i);
        at += STRIDE;
      }
    }
    return at / STRIDE;
  }

  private build(): Parts {
    const { context: gl } = this;
    this.room = 0;
    const program = gl.createProgram();
    for (const [type, source] of [
      [gl.VERTEX_SHADER, VERTEX_SHADER],
      [gl.FRAGMENT_SHADER, FRAGMENT_SHADER],
    ] as const) {
      const shader = gl.createShader(type);
      gl.shaderSource(shader, source);
      gl.compileShader(shader);
      gl.attachShader(program, shader);
      gl.deleteShader(shader);
    }
    gl.bindAttribLocation(program, ENDS_INDEX, 'ends');
    gl.bindAttribLocation(program, COLOR_INDEX, 'color');
    gl.linkProgram(program);
    if (gl.getProgramParameter(program, gl.LINK_STATUS) !== true && !gl.isContextLost()) {
      throw new Error(`WebGLDebugDevice.drawLines: the shaders do not link: ${gl.getProgramInfoLog(program)}`);
    }
    const array = gl.createVertexArray();
    const buffer = gl.createBuffer();
    gl.bindVertexArray(array);
    gl.bindBuffer(gl.ARRAY_BUFFER, buffer);
    gl.vertexAttribPointer(ENDS_INDEX, 4, gl.FLOAT, false, BYTES, 0);
    gl.vertexAttribPointer(COLOR_INDEX, 4, gl.UNSIGNED_BYTE, true, BYTES, 4 * COLOR);
    for (const index of [ENDS_INDEX, COLOR_INDEX]) {
      gl.enableVertexAttribArray(index);
      gl.vertexAttribDivisor(index, 1);
    }
    gl.bindVertexArray(null);
    gl.bindBuffer(gl.ARRAY_BUFFER, null);
    const screen = gl.getUniformLocation(program, 'screen');
    const reach = gl.getUniformLocation(program, 'reach');
    return { program, array, buffer, screen, reach };
  }
}
