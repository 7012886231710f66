import { options, positive, typeError } from '../validate.js';
import { Cutter, packedColor } from './cutter.js';
import type { DebugGraphicsDevice, DebugLines } from './device.js';
import { SEGMENT } from './lines.js';

/** What `WebGLDebugDevice` uses of a `WebGL2RenderingContext`. */
export interface WebGL2ContextLike {
  readonly drawingBufferWidth: number;
  readonly drawingBufferHeight: number;
  readonly ARRAY_BUFFER: number;
  readonly BLEND: number;
  readonly CULL_FACE: number;
  readonly DEPTH_TEST: number;
  readonly DYNAMIC_DRAW: number;
  readonly ELEMENT_ARRAY_BUFFER: number;
  readonly FLOAT: number;
  readonly FRAGMENT_SHADER: number;
  readonly LINK_STATUS: number;
  readonly ONE: number;
  readonly ONE_MINUS_SRC_ALPHA: number;
  readonly SCISSOR_TEST: number;
  readonly SRC_ALPHA: number;
  readonly STATIC_DRAW: number;
  readonly STENCIL_TEST: number;
  readonly TRIANGLES: number;
  readonly UNSIGNED_BYTE: number;
  readonly UNSIGNED_INT: number;
  readonly VERTEX_SHADER: number;
  attachShader(program: unknown, shader: unknown): void;
  bindAttribLocation(program: unknown, index: number, name: string): void;
  bindBuffer(target: number, buffer: unknown): void;
  bindVertexArray(array: unknown): void;
  blendFuncSeparate(srcRGB: number, dstRGB: number, srcAlpha: number, dstAlpha: number): void;
  bufferData(target: number, size: number, usage: number): void;
  bufferData(target: number, data: Uint32Array, usage: number): void;
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
  drawElements(mode: number, count: number, type: number, offset: number): void;
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

/** Options of `WebGLDebugDevice.create`. */
export interface WebGLDebugDeviceParams {
  /** A WebGL 2 context. */
  context: WebGL2ContextLike;
  /** px, > 0. Default 1. */
  lineWidth?: number | undefined;
}

/** A vertex in the buffer: x and y, and the distance from the line, px, as numbers of 32 bits; then the colour in four bytes. */
const VERTEX_NUMBERS = 4;
const ACROSS = 2;
const COLOR = 3;
const VERTEX_BYTES = 4 * VERTEX_NUMBERS;

/**
 * Each segment is two triangles, half a px wider than its line on both sides; over this margin the line fades. Refused: an instance of a
 * quad for each segment, which takes a third of the memory, but took 25 µs a segment where WebGL runs on the processor; and lines of WebGL,
 * which are one px wide.
 */
const CORNERS = 4;
const INDICES = [0, 1, 2, 2, 1, 3];

const PLACE_INDEX = 0;
const COLOR_INDEX = 1;

const VERTEX_SHADER = `#version 300 es
uniform vec2 screen;
in vec3 place;
in vec4 color;
out vec4 ink;
out float across;
void main() {
  ink = color;
  across = place.z;
  gl_Position = vec4(2.0 * place.x / screen.x - 1.0, 1.0 - 2.0 * place.y / screen.y, 0.0, 1.0);
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

/** The objects in the context. */
interface Parts {
  readonly program: unknown;
  readonly array: unknown;
  readonly vertices: unknown;
  readonly indices: unknown;
  readonly screen: unknown;
  readonly reach: unknown;
}

/**
 * Draws debug lines with WebGL 2, in one draw call a frame: good for 100,000 lines and more. Lines are drawn over what the canvas shows,
 * without depth or stencil test. Afterwards blending is on; both tests, culling and scissors are off; the viewport is the whole canvas; and
 * no program, vertex array or buffer is bound. After a lost context, it goes on when the context is restored.
 */
export class WebGLDebugDevice implements DebugGraphicsDevice {
  private readonly context: WebGL2ContextLike;
  private readonly lineWidth: number;
  private readonly cutter = new Cutter();
  private parts: Parts | null = null;
  /** The same memory as floats, as integers, and as the bytes that are sent. */
  private places = new Float32Array(0);
  private colors = new Uint32Array(0);
  private bytes = new Uint8Array(0);
  /** How many segments the buffers in the context have room for. */
  private room = 0;

  /** @internal use `create` */
  constructor(params: WebGLDebugDeviceParams) {
    const where = 'WebGLDebugDevice.create';
    const { context, lineWidth = 1 } = options(where, params, true);
    if (typeof context?.bindVertexArray !== 'function') {
      throw typeError(where, 'context', 'a WebGL 2 context', context);
    }
    this.lineWidth = positive(where, 'lineWidth', lineWidth);
    this.context = context;
  }

  /** Makes a device that draws on a WebGL 2 context. */
  static create(params: WebGLDebugDeviceParams): WebGLDebugDevice {
    return new WebGLDebugDevice(params);
  }

  get width(): number {
    return this.context.drawingBufferWidth;
  }

  get height(): number {
    return this.context.drawingBufferHeight;
  }

  /** Draws the lines over what the canvas shows. @throws Error if the browser refuses the shaders. */
  drawLines(lines: DebugLines): void {
    const { context: gl } = this;
    if (gl.isContextLost()) {
      this.parts = null;
      return;
    }
    this.parts ??= this.build();
    const { parts } = this;
    const count = this.pack(lines);
    gl.bindVertexArray(parts.array);
    gl.bindBuffer(gl.ARRAY_BUFFER, parts.vertices);
    this.makeRoom();
    gl.bufferSubData(gl.ARRAY_BUFFER, 0, this.bytes, 0, count * CORNERS * VERTEX_BYTES);
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
    gl.drawElements(gl.TRIANGLES, count * INDICES.length, gl.UNSIGNED_INT, 0);
    gl.bindVertexArray(null);
    gl.useProgram(null);
  }

  /** Deletes its objects in the context. */
  destroy(): void {
    const { context: gl, parts } = this;
    if (parts !== null) {
      gl.deleteProgram(parts.program);
      gl.deleteVertexArray(parts.array);
      gl.deleteBuffer(parts.vertices);
      gl.deleteBuffer(parts.indices);
      this.parts = null;
    }
  }

  /** Writes the visible segments to the memory that is sent. @returns how many they are. */
  private pack(lines: DebugLines): number {
    const { cutter } = this;
    const { ends } = cutter;
    if (this.places.length < lines.segmentCount * CORNERS * VERTEX_NUMBERS) {
      this.places = new Float32Array((lines.vertices.length / SEGMENT) * CORNERS * VERTEX_NUMBERS);
      this.colors = new Uint32Array(this.places.buffer);
      this.bytes = new Uint8Array(this.places.buffer);
    }
    cutter.begin(lines, this.width, this.height);
    const reach = (this.lineWidth + 1) / 2;
    let count = 0;
    for (let i = 0; i < lines.segmentCount; i += 1) {
      if (cutter.cut(lines, i)) {
        const dx = ends[2]! - ends[0]!;
        const dy = ends[3]! - ends[1]!;
        const size = Math.sqrt(dx * dx + dy * dy);
        if (size > 0) {
          const sideX = (-dy / size) * reach;
          const sideY = (dx / size) * reach;
          const color = packedColor(lines, i);
          const at = count * CORNERS;
          this.put(at, ends[0]! - sideX, ends[1]! - sideY, -reach, color);
          this.put(at + 1, ends[0]! + sideX, ends[1]! + sideY, reach, color);
          this.put(at + 2, ends[2]! - sideX, ends[3]! - sideY, -reach, color);
          this.put(at + 3, ends[2]! + sideX, ends[3]! + sideY, reach, color);
          count += 1;
        }
      }
    }
    return count;
  }

  private put(vertex: number, x: number, y: number, across: number, color: number): void {
    const at = vertex * VERTEX_NUMBERS;
    this.places[at] = x;
    this.places[at + 1] = y;
    this.places[at + ACROSS] = across;
    this.colors[at + COLOR] = color;
  }

  /** Makes room in the bound buffers for what is sent. The indices are always the same. */
  private makeRoom(): void {
    const { context: gl } = this;
    const room = this.places.length / (CORNERS * VERTEX_NUMBERS);
    if (this.room < room) {
      this.room = room;
      gl.bufferData(gl.ARRAY_BUFFER, this.bytes.length, gl.DYNAMIC_DRAW);
      const indices = new Uint32Array(room * INDICES.length);
      for (let i = 0; i < indices.length; i += 1) {
        indices[i] = Math.floor(i / INDICES.length) * CORNERS + INDICES[i % INDICES.length]!;
      }
      gl.bufferData(gl.ELEMENT_ARRAY_BUFFER, indices, gl.STATIC_DRAW);
    }
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
    gl.bindAttribLocation(program, PLACE_INDEX, 'place');
    gl.bindAttribLocation(program, COLOR_INDEX, 'color');
    gl.linkProgram(program);
    if (gl.getProgramParameter(program, gl.LINK_STATUS) !== true && !gl.isContextLost()) {
      throw new Error(`WebGLDebugDevice.drawLines: the shaders do not link: ${gl.getProgramInfoLog(program)}`);
    }
    const array = gl.createVertexArray();
    const vertices = gl.createBuffer();
    const indices = gl.createBuffer();
    gl.bindVertexArray(array);
    gl.bindBuffer(gl.ARRAY_BUFFER, vertices);
    gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, indices);
    gl.vertexAttribPointer(PLACE_INDEX, 3, gl.FLOAT, false, VERTEX_BYTES, 0);
    gl.vertexAttribPointer(COLOR_INDEX, 4, gl.UNSIGNED_BYTE, true, VERTEX_BYTES, 4 * COLOR);
    gl.enableVertexAttribArray(PLACE_INDEX);
    gl.enableVertexAttribArray(COLOR_INDEX);
    gl.bindVertexArray(null);
    gl.bindBuffer(gl.ARRAY_BUFFER, null);
    const screen = gl.getUniformLocation(program, 'screen');
    const reach = gl.getUniformLocation(program, 'reach');
    return { program, array, vertices, indices, screen, reach };
  }
}
