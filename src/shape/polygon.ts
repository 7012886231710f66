import type { RigidBody } from '../body.js';
import { MAX_SIZE } from '../config.js';
import { EDGE_NX, EDGE_NY, EDGE_STRIDE, EDGES } from '../geometry/layout.js';
import { polygonArea, polygonCentre, polygonMasslessInertia } from '../geometry/mass.js';
import { type Outline, outlinePolygon } from '../geometry/outline.js';
import { convexVertices, createBoxVertices, repeatedVertex } from '../geometry/vertices.js';
import { doubles } from '../math/doubles.js';
import { type NumberSink, type Vec2, type Vec2Like, vec2 } from '../math/vectors.js';
import { options } from '../validate.js';
import { BaseShape, type ShapeParams } from './shape.js';
import { POLYGON } from './shape-kind.js';

/** Options of `createPolygonShape`. */
export interface PolygonParams extends ShapeParams {
  /**
   * At least three distinct corners of a convex polygon in body coordinates, m, each coordinate at most 1e75. Clockwise on screen;
   * counter-clockwise input is reversed, corners inside an edge are dropped. Copied.
   */
  vertices: ArrayLike<Vec2Like>;
}

/** The geometry of a polygon: shared by equal polygons, and never written to. */
interface Form {
  /** Corners in body coordinates, [x, y] each, clockwise. */
  readonly vertices: Float64Array;
  /** [x, y, nx, ny] per corner, body coordinates. */
  readonly localEdges: Float64Array;
  /** n · p of each edge; the same however the body is turned. */
  readonly offsets: Float64Array;
  /** Half of the least width, m. */
  readonly halfWidth: number;
}

/** The last form that was asked for: polygons are often made many alike. */
let latest: Form | null = null;

function formOf(corners: ArrayLike<number>): Form {
  if (latest === null || !isSame(latest.vertices, corners)) {
    latest = makeForm(corners);
  }
  return latest;
}

/** Compared to the bit: no result may depend on which other polygons there are. */
function isSame(a: Float64Array, b: ArrayLike<number>): boolean {
  let i = 0;
  while (i < a.length && Object.is(a[i], b[i])) {
    i += 1;
  }
  return i === a.length && i === b.length;
}

function makeForm(corners: ArrayLike<number>): Form {
  const { length } = corners;
  const vertices = doubles(length);
  const localEdges = doubles(length * 2);
  const offsets = doubles(length / 2);
  vertices.set(corners);
  for (let i = 0; i < length; i += 2) {
    const j = i + 2 === length ? 0 : i + 2;
    const x = vertices[i]!;
    const y = vertices[i + 1]!;
    const ex = vertices[j]! - x;
    const ey = vertices[j + 1]! - y;
    const size = Math.sqrt(ex * ex + ey * ey);
    const nx = ey / size;
    const ny = -ex / size;
    localEdges[2 * i] = x;
    localEdges[2 * i + 1] = y;
    localEdges[2 * i + EDGE_NX] = nx;
    localEdges[2 * i + EDGE_NY] = ny;
    offsets[i / 2] = nx * x + ny * y;
  }
  return { vertices, localEdges, offsets, halfWidth: leastWidth(localEdges, offsets) / 2 };
}

function leastWidth(localEdges: Float64Array, offsets: Float64Array): number {
  let width = Infinity;
  for (let i = 0; i < offsets.length; i += 1) {
    const nx = localEdges[EDGE_STRIDE * i + EDGE_NX]!;
    const ny = localEdges[EDGE_STRIDE * i + EDGE_NY]!;
    let depth = 0;
    for (let k = 0; k < localEdges.length; k += EDGE_STRIDE) {
      depth = Math.max(depth, offsets[i]! - nx * localEdges[k]! - ny * localEdges[k + 1]!);
    }
    width = Math.min(width, depth);
  }
  return width;
}

/** A convex polygon with any number of corners. */
export class Polygon extends BaseShape {
  /** Of the class, as in Turbulenz. */
  static get version(): number {
    return 1;
  }

  /** The kind of shape. */
  readonly type = 'POLYGON';

  /** @internal */
  declare readonly kind: typeof POLYGON;
  /** @internal */
  offsets: Float64Array;
  /** @internal */
  form: Form;

  /** @internal grows with every change of the geometry while it is in a world */
  geometryStamp = 1;

  /** @internal use `createPolygonShape` */
  constructor(params: PolygonParams) {
    const where = 'createPolygonShape';
    const given = options(where, params, true);
    const vertices = convexVertices(where, given.vertices);
    super(where, given, POLYGON, EDGES + vertices.length * 2);
    this.form = formOf(vertices);
    this.offsets = this.form.offsets;
  }

  /** @internal */
  get vertices(): Float64Array {
    return this.form.vertices;
  }

  /** @internal */
  get localEdges(): Float64Array {
    return this.form.localEdges;
  }

  /** The corners in body coordinates, m, clockwise on screen. `body.transformLocalPointToWorld` gives their places in the world. */
  getVertices(): Vec2[] {
    const { vertices } = this;
    return Array.from({ length: vertices.length / 2 }, (_, i) => [vertices[2 * i]!, vertices[2 * i + 1]!]);
  }

  /** Replaces the corners, with the rules of `PolygonParams.vertices`. Ignored during a step and for a static body in a world. Wakes the body. */
  setVertices(vertices: ArrayLike<Vec2Like>): void {
    const checked = convexVertices('Polygon.setVertices', vertices);
    if (!this.isLocked()) {
      this.takeVertices(checked);
      this.geometryChanged();
    }
  }

  /** @internal */
  takeVertices(checked: ArrayLike<number>): void {
    const form = formOf(checked);
    if (form.localEdges.length !== this.localEdges.length) {
      this.resize(EDGES + form.localEdges.length);
    }
    this.form = form;
    this.offsets = form.offsets;
    this.geometryStamp += 1;
  }

  override computeArea(): number {
    return polygonArea(this.vertices);
  }

  override computeMasslessInertia(): number {
    return polygonMasslessInertia(this.vertices);
  }

  override computeCenterOfMass(): Vec2;
  override computeCenterOfMass<T extends NumberSink>(dst: T): T;
  override computeCenterOfMass<T extends NumberSink>(dst?: T): T | Vec2 {
    const centre: Vec2 = [0, 0];
    polygonCentre(this.vertices, centre);
    return vec2(centre[0], centre[1], 'Polygon.computeCenterOfMass', dst);
  }

  override clone(): this {
    // Its own corners are not checked again: after scaling they might no longer pass as those of a new polygon.
    const copy = new Polygon({ ...this.commonParams(), vertices: createBoxVertices(1, 1) });
    copy.takeVertices(this.vertices);
    return copy as this;
  }

  /** @internal */
  override place(body: RigidBody): void {
    const { x, y, cos: c, sin: s } = body;
    const local = this.form.localEdges;
    const { numbers: n, at: o } = this;
    let minX = Infinity;
    let minY = Infinity;
    let maxX = -Infinity;
    let maxY = -Infinity;
    for (let i = 0; i < local.length; i += EDGE_STRIDE) {
      const lx = local[i]!;
      const ly = local[i + 1]!;
      const px = c * lx - s * ly;
      const py = s * lx + c * ly;
      const nx = local[i + EDGE_NX]!;
      const ny = local[i + EDGE_NY]!;
      const to = o + EDGES + i;
      n[to] = px;
      n[to + 1] = py;
      n[to + EDGE_NX] = c * nx - s * ny;
      n[to + EDGE_NY] = s * nx + c * ny;
      if (px < minX) minX = px;
      if (px > maxX) maxX = px;
      if (py < minY) minY = py;
      if (py > maxY) maxY = py;
    }
    n[o] = x + minX;
    n[o + 1] = y + minY;
    n[o + 2] = x + maxX;
    n[o + 3] = y + maxY;
  }

  /** @internal */
  override outline(into: Outline): void {
    outlinePolygon(into, this.localEdges, this.offsets);
  }

  /** @internal */
  override reach(): number {
    let squared = 0;
    for (let i = 0; i < this.vertices.length; i += 2) {
      const x = this.vertices[i]!;
      const y = this.vertices[i + 1]!;
      squared = Math.max(squared, x * x + y * y);
    }
    return Math.sqrt(squared);
  }

  /** @internal */
  override isRound(): boolean {
    return false;
  }

  /** @internal */
  protected override mapGeometry(m: ArrayLike<number>): boolean {
    const mapped = [...this.vertices];
    for (let i = 0; i < mapped.length; i += 2) {
      const x = mapped[i]!;
      const y = mapped[i + 1]!;
      mapped[i] = m[0]! * x + m[2]! * y + m[4]!;
      mapped[i + 1] = m[1]! * x + m[3]! * y + m[5]!;
    }
    const isRight = mapped.every((value) => Math.abs(value) <= MAX_SIZE) && repeatedVertex(mapped) < 0;
    if (!isRight || !(polygonArea(mapped) > 0)) {
      return false;
    }
    this.takeVertices(mapped);
    return true;
  }
}
