import { type DebugGraphicsDevice, WebGLDebugDevice } from '../src/debug/index.js';
import type { RigidBody, Shape, Vec2 } from '../src/index.js';
import { type Frame, inkOf, poseOf, type Surface, strengthOf } from './surface.js';
import type { Rgb } from './theme.js';

// Bodies as filled shapes with a rim, in one draw call. What a shape looks like in its body stays in the graphics card; placements and inks go
// there in each frame, in a texture with a column of two texels for each body.

/** Numbers of a vertex: x and y in the body, m; which body; the distances from three edges, m, or for a disc its middle and radius; 1 for a disc,
 * 2 more for a sensor, 4 more for what is static and has no tick. Then what each m that the shape is grown by adds to x, y and the distances: the
 * middle of the rim is on the edge, so half of it is outside, and what is thinner than a px is seen as well. */
const VERTEX = 12;
const ATTRIBUTES = [
  ['place', 3],
  ['rim', 4],
  ['outward', 2],
  ['slope', 3],
] as const;
/** Bodies in a row of the textures. */
const ROW = 1024;

const VERTEX_SHADER = `#version 300 es
precision highp float;
uniform sampler2D poses;
uniform sampler2D inks;
uniform vec4 mapping;
uniform float scale;
uniform float width;
in vec3 place;
in vec4 rim;
in vec2 outward;
in vec3 slope;
out vec4 edge;
out vec2 local;
flat out vec4 ink;
flat out float kind;
void main() {
  int body = int(place.z);
  ivec2 at = ivec2(body % ${ROW}, body / ${ROW});
  vec4 pose = texelFetch(poses, at, 0);
  ink = texelFetch(inks, at, 0);
  float growth = (0.5 * width + 0.5) / scale;
  local = place.xy + growth * outward;
  edge = rim + growth * vec4(slope, 0.0);
  kind = rim.w;
  vec2 world = pose.xy + vec2(pose.z * local.x - pose.w * local.y, pose.w * local.x + pose.z * local.y);
  gl_Position = vec4(world * mapping.xy + mapping.zw, 0.0, 1.0);
}`;

const FRAGMENT_SHADER = `#version 300 es
precision highp float;
uniform float scale;
uniform float width;
in vec4 edge;
in vec2 local;
flat in vec4 ink;
flat in float kind;
out vec4 shown;
void main() {
  float reach = 0.5 * width + 0.5;
  float depth;
  float tick = 0.0;
  bool disc = mod(kind, 2.0) > 0.5;
  if (disc) {
    vec2 spoke = local - edge.xy;
    depth = (edge.z - length(spoke)) * scale;
    float across = (reach - abs(spoke.y) * scale) * step(edge.z * 0.4, spoke.x) * step(kind, 3.5);
    tick = clamp(across, 0.0, 1.0);
  } else {
    depth = min(edge.x, min(edge.y, edge.z)) * scale;
  }
  float inside = clamp(reach + depth, 0.0, 1.0);
  float rim = max(clamp(reach - depth, 0.0, 1.0), tick);
  float strength = mod(kind, 4.0) > 1.5 ? 0.4 : 1.0;
  shown = vec4(ink.rgb, strength * inside * mix(ink.a, 1.0, rim));
}`;

export class WebGLSurface implements Surface {
  readonly device: DebugGraphicsDevice;
  private readonly program: WebGLProgram;
  private readonly array: WebGLVertexArrayObject;
  private readonly buffer: WebGLBuffer;
  private readonly poseTexture: WebGLTexture;
  private readonly inkTexture: WebGLTexture;
  private readonly uniforms: Record<'mapping' | 'scale' | 'width', WebGLUniformLocation | null>;
  private poses = new Float32Array(0);
  private inks = new Uint8Array(0);
  private strengths: number[] = [];
  private vertexCount = 0;
  private rows = 0;
  /** The bodies as they are in the buffer. */
  private readonly drawn: RigidBody[] = [];

  constructor(
    private readonly gl: WebGL2RenderingContext,
    lineWidth: number,
  ) {
    this.device = WebGLDebugDevice.create({ context: gl, lineWidth });
    this.program = link(gl);
    this.array = gl.createVertexArray();
    this.buffer = gl.createBuffer();
    this.poseTexture = gl.createTexture();
    this.inkTexture = gl.createTexture();
    const at = (name: string): WebGLUniformLocation | null => gl.getUniformLocation(this.program, name);
    this.uniforms = { mapping: at('mapping'), scale: at('scale'), width: at('width') };
    gl.bindVertexArray(this.array);
    gl.bindBuffer(gl.ARRAY_BUFFER, this.buffer);
    let offset = 0;
    ATTRIBUTES.forEach(([, size], index) => {
      gl.enableVertexAttribArray(index);
      gl.vertexAttribPointer(index, size, gl.FLOAT, false, 4 * VERTEX, 4 * offset);
      offset += size;
    });
    gl.bindVertexArray(null);
  }

  isLost(): boolean {
    return this.gl.isContextLost();
  }

  clear([r, g, b]: Rgb): void {
    const { gl } = this;
    gl.viewport(0, 0, gl.drawingBufferWidth, gl.drawingBufferHeight);
    gl.clearColor(r / 255, g / 255, b / 255, 1);
    gl.clear(gl.COLOR_BUFFER_BIT);
  }

  drawBodies(frame: Frame): void {
    const { mapping } = frame;
    const { gl } = this;
    const { rigidBodies } = frame.world;
    if (rigidBodies.length !== this.drawn.length || rigidBodies.some((body, i) => body !== this.drawn[i])) {
      this.build(rigidBodies);
    }
    if (this.vertexCount === 0) {
      return;
    }
    this.place(rigidBodies, frame);
    gl.useProgram(this.program);
    gl.uniform4f(this.uniforms.mapping, ...mapping);
    gl.uniform1f(this.uniforms.scale, frame.scale);
    gl.uniform1f(this.uniforms.width, frame.rim);
    this.send(0, this.poseTexture, gl.RGBA32F, gl.FLOAT, this.poses);
    this.send(1, this.inkTexture, gl.RGBA8, gl.UNSIGNED_BYTE, this.inks);
    gl.uniform1i(gl.getUniformLocation(this.program, 'poses'), 0);
    gl.uniform1i(gl.getUniformLocation(this.program, 'inks'), 1);
    gl.enable(gl.BLEND);
    gl.blendFuncSeparate(gl.SRC_ALPHA, gl.ONE_MINUS_SRC_ALPHA, gl.ONE, gl.ONE_MINUS_SRC_ALPHA);
    gl.bindVertexArray(this.array);
    gl.drawArrays(gl.TRIANGLES, 0, this.vertexCount);
    gl.bindVertexArray(null);
    gl.activeTexture(gl.TEXTURE0);
  }

  private send(
    unit: number,
    texture: WebGLTexture,
    format: number,
    type: number,
    data: Float32Array | Uint8Array,
  ): void {
    const { gl } = this;
    gl.activeTexture(gl.TEXTURE0 + unit);
    gl.bindTexture(gl.TEXTURE_2D, texture);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, gl.NEAREST);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MAG_FILTER, gl.NEAREST);
    gl.texImage2D(gl.TEXTURE_2D, 0, format, ROW, this.rows, 0, gl.RGBA, type, data);
  }

  private place(bodies: readonly RigidBody[], frame: Frame): void {
    const { poses } = this;
    const { inks } = frame;
    const point: Vec2 = [0, 0];
    bodies.forEach((body, i) => {
      const angle = poseOf(body, frame, point);
      poses[4 * i] = point[0];
      poses[4 * i + 1] = point[1];
      poses[4 * i + 2] = Math.cos(angle);
      poses[4 * i + 3] = Math.sin(angle);
      const ink = 4 * inkOf(body);
      this.inks[4 * i] = inks[ink]!;
      this.inks[4 * i + 1] = inks[ink + 1]!;
      this.inks[4 * i + 2] = inks[ink + 2]!;
      this.inks[4 * i + 3] = Math.min(255, inks[ink + 3]! * this.strengths[i]!);
    });
  }

  private build(bodies: readonly RigidBody[]): void {
    const { gl } = this;
    const numbers: number[] = [];
    this.drawn.length = 0;
    bodies.forEach((body, i) => {
      this.drawn.push(body);
      for (const shape of body.shapes) {
        addShape(numbers, shape, i);
      }
    });
    this.strengths = bodies.map(strengthOf);
    this.rows = Math.max(1, Math.ceil(bodies.length / ROW));
    this.poses = new Float32Array(4 * ROW * this.rows);
    this.inks = new Uint8Array(4 * ROW * this.rows);
    this.vertexCount = numbers.length / VERTEX;
    gl.bindBuffer(gl.ARRAY_BUFFER, this.buffer);
    gl.bufferData(gl.ARRAY_BUFFER, new Float32Array(numbers), gl.STATIC_DRAW);
    gl.bindBuffer(gl.ARRAY_BUFFER, null);
  }
}

function addShape(numbers: number[], shape: Shape, body: number): void {
  const kind = (shape.sensor ? 2 : 0) + (shape.body!.isStatic() ? 4 : 0);
  if (shape.type === 'CIRCLE') {
    const radius = shape.getRadius();
    const [x, y] = shape.getOrigin();
    for (const [dx, dy] of [
      [-1, -1],
      [1, -1],
      [1, 1],
      [-1, -1],
      [1, 1],
      [-1, 1],
    ] as const) {
      numbers.push(x + radius * dx, y + radius * dy, body, x, y, radius, 1 + kind, dx, dy, 0, 0, 0);
    }
  } else {
    addPolygon(numbers, shape.vertices, body, kind);
  }
}

/** A fan around the middle. Each triangle knows how far it is from its edge and from those beside it: near a corner these count, too. */
function addPolygon(numbers: number[], vertices: ArrayLike<number>, body: number, kind: number): void {
  const count = vertices.length / 2;
  const corner = (i: number): Vec2 => {
    const k = 2 * ((i + count) % count);
    return [vertices[k]!, vertices[k + 1]!];
  };
  let [mx, my] = [0, 0];
  for (let i = 0; i < count; i += 1) {
    mx += corner(i)[0] / count;
    my += corner(i)[1] / count;
  }
  /** A unit vector that points inwards. */
  const normal = (edge: number): Vec2 => {
    const [[ax, ay], [bx, by]] = [corner(edge), corner(edge + 1)];
    const size = Math.hypot(bx - ax, by - ay) * Math.sign((bx - ax) * (my - ay) - (by - ay) * (mx - ax));
    return [(ay - by) / size, (bx - ax) / size];
  };
  const away = (edge: number, [x, y]: Vec2): number => {
    const [ax, ay] = corner(edge);
    return dot(normal(edge), [x - ax, y - ay]);
  };
  /** Where a corner goes as both its edges move outwards by 1; less far where it is sharp. */
  const outward = (i: number): Vec2 => {
    const [one, other] = [normal(i - 1), normal(i)];
    const share = -1 / Math.max(0.2, 1 + dot(one, other));
    return [share * (one[0] + other[0]), share * (one[1] + other[1])];
  };
  for (let i = 0; i < count; i += 1) {
    const edges = [i - 1, i, i + 1];
    for (const [point, growth] of [
      [
        [mx, my],
        [0, 0],
      ],
      [corner(i), outward(i)],
      [corner(i + 1), outward(i + 1)],
    ] as [Vec2, Vec2][]) {
      numbers.push(...point, body, ...edges.map((edge) => away(edge, point)), kind);
      numbers.push(...growth, ...edges.map((edge) => dot(normal(edge), growth)));
    }
  }
}

function dot(a: Vec2, b: Vec2): number {
  return a[0] * b[0] + a[1] * b[1];
}

function link(gl: WebGL2RenderingContext): WebGLProgram {
  const program = gl.createProgram();
  for (const [type, source] of [
    [gl.VERTEX_SHADER, VERTEX_SHADER],
    [gl.FRAGMENT_SHADER, FRAGMENT_SHADER],
  ] as const) {
    const shader = gl.createShader(type)!;
    gl.shaderSource(shader, source);
    gl.compileShader(shader);
    gl.attachShader(program, shader);
  }
  ATTRIBUTES.forEach(([name], index) => {
    gl.bindAttribLocation(program, index, name);
  });
  gl.linkProgram(program);
  if (!gl.getProgramParameter(program, gl.LINK_STATUS)) {
    throw new Error(`The shaders do not link: ${gl.getProgramInfoLog(program)}`);
  }
  return program;
}
