import type { RigidBody } from '../body.js';
import { EDGE_STRIDE } from '../geometry/layout.js';
import { polygonArea, polygonCentre, polygonMasslessInertia } from '../geometry/mass.js';
import type { Outline } from '../geometry/outline.js';
import { convexVertices } from '../geometry/vertices.js';
import { doubles } from '../math/doubles.js';
import type { NumberSink, Vec2, Vec2Like } from '../math/vectors.js';
import { options } from '../validate.js';
import { BaseShape, type ShapeParams } from './shape.js';

/** Options of `createPolygonShape`. */
export interface PolygonParams extends ShapeParams {
  /**
   * At least three distinct corners of a convex polygon in body coordinates, m. Clockwise on screen; counter-clockwise
   * input is reversed, corners inside an edge are dropped. Copied.
   */
  vertices: ArrayLike<Vec2Like>;
}

/** A convex polygon with any number of corners. */
export class Polygon extends BaseShape {
  /** Of the class, as in Turbulenz. */
  static get version(): number {
    return 1;
  }

  /** Tells polygons from circles. */
  readonly type = 'POLYGON';

  /** @internal */
  readonly kind = 1;
  /** @internal corners in body coordinates, [x, y] each, clockwise */
  vertices: Float64Array;
  /** @internal [x, y, nx, ny] per corner, body coordinates */
  localEdges: Float64Array;
  /** @internal the same, turned with the body, relative to the body origin */
  edges: Float64Array;
  /** @internal n · p of each edge; a turn does not change it */
  offsets: Float64Array;

  /** @internal grows with every change of the geometry */
  geometryStamp = 0;
  /** @internal half of the least width; −1 if it has to be found */
  halfWidth = -1;

  /** @internal use `createPolygonShape` */
  constructor(params: PolygonParams) {
    const where = 'createPolygonShape';
    const given = options(where, params, true);
    const vertices = convexVertices(where, 'vertices', given.vertices);
    super(where, given);
    this.vertices = vertices;
    this.localEdges = doubles(vertices.length * 2);
    this.edges = doubles(vertices.length * 2);
    this.offsets = doubles(vertices.length / 2);
    this.refreshEdges();
  }

  /** Replaces the corners; as `PolygonParams.vertices`. Ignored during a step and for a static body in a world. Wakes the body. */
  setVertices(vertices: ArrayLike<Vec2Like>): void {
    const checked = convexVertices('Polygon.setVertices', 'vertices', vertices);
    if (!this.isLocked()) {
      this.takeVertices(checked);
      this.geometryChanged();
    }
  }

  /** @internal */
  takeVertices(checked: Float64Array): void {
    if (checked.length !== this.vertices.length) {
      this.localEdges = doubles(checked.length * 2);
      this.edges = doubles(checked.length * 2);
      this.offsets = doubles(checked.length / 2);
    }
    this.vertices = checked;
    this.refreshEdges();
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
    const centre = dst ?? ([0, 0] as Vec2);
    polygonCentre(this.vertices, centre);
    return centre;
  }

  override clone(): this {
    const vertices: Vec2[] = [];
    for (let i = 0; i < this.vertices.length; i += 2) {
      vertices.push([this.vertices[i]!, this.vertices[i + 1]!]);
    }
    return new Polygon({ ...this.commonParams(), vertices }) as this;
  }

  /** @internal */
  override place(body: RigidBody): void {
    const { x, y, cos: c, sin: s } = body;
    const local = this.localEdges;
    const edges = this.edges;
    let minX = Infinity;
    let minY = Infinity;
    let maxX = -Infinity;
    let maxY = -Infinity;
    for (let i = 0; i < local.length; i += EDGE_STRIDE) {
      const lx = local[i]!;
      const ly = local[i + 1]!;
      const px = c * lx - s * ly;
      const py = s * lx + c * ly;
      const nx = local[i + 2]!;
      const ny = local[i + 3]!;
      edges[i] = px;
      edges[i + 1] = py;
      edges[i + 2] = c * nx - s * ny;
      edges[i + 3] = s * nx + c * ny;
      if (px < minX) minX = px;
      if (px > maxX) maxX = px;
      if (py < minY) minY = py;
      if (py > maxY) maxY = py;
    }
    const bounds = this.bounds;
    bounds[0] = x + minX;
    bounds[1] = y + minY;
    bounds[2] = x + maxX;
    bounds[3] = y + maxY;
  }

  /** @internal */
  override outline(into: Outline): void {
    into.setPolygon(this.localEdges, this.offsets);
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
  override thickness(): number {
    if (this.halfWidth < 0) {
      this.halfWidth = this.leastWidth() / 2;
    }
    return this.halfWidth;
  }

  private leastWidth(): number {
    const { localEdges, offsets } = this;
    let width = Infinity;
    for (let i = 0; i < offsets.length; i += 1) {
      const nx = localEdges[EDGE_STRIDE * i + 2]!;
      const ny = localEdges[EDGE_STRIDE * i + 3]!;
      let depth = 0;
      for (let k = 0; k < localEdges.length; k += EDGE_STRIDE) {
        depth = Math.max(depth, offsets[i]! - nx * localEdges[k]! - ny * localEdges[k + 1]!);
      }
      width = Math.min(width, depth);
    }
    return width;
  }

  /** @internal */
  protected override scaleGeometry(scaleX: number, scaleY: number): void {
    this.mapGeometry(scaleX, 0, 0, scaleY, 0, 0);
  }

  /** @internal */
  protected override mapGeometry(m0: number, m1: number, m2: number, m3: number, m4: number, m5: number): void {
    const vertices = this.vertices;
    for (let i = 0; i < vertices.length; i += 2) {
      const x = vertices[i]!;
      const y = vertices[i + 1]!;
      vertices[i] = m0 * x + m2 * y + m4;
      vertices[i + 1] = m1 * x + m3 * y + m5;
    }
    this.refreshEdges();
  }

  private refreshEdges(): void {
    this.geometryStamp += 1;
    this.halfWidth = -1;
    const vertices = this.vertices;
    const length = vertices.length;
    for (let i = 0; i < length; i += 2) {
      const j = i + 2 === length ? 0 : i + 2;
      const x = vertices[i]!;
      const y = vertices[i + 1]!;
      const ex = vertices[j]! - x;
      const ey = vertices[j + 1]! - y;
      const size = Math.sqrt(ex * ex + ey * ey);
      const nx = ey / size;
      const ny = -ex / size;
      this.localEdges[2 * i] = x;
      this.localEdges[2 * i + 1] = y;
      this.localEdges[2 * i + 2] = nx;
      this.localEdges[2 * i + 3] = ny;
      this.offsets[i / 2] = nx * x + ny * y;
    }
  }
}
