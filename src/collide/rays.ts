import { CENTRE_X, CENTRE_Y, EDGE_NX, EDGE_NY, EDGE_STRIDE, EDGES } from '../geometry/layout.js';
import type { Ray } from '../math/vectors.js';
import type { Circle } from '../shape/circle.js';
import type { Polygon } from '../shape/polygon.js';
import type { Shape } from '../shape/shape.js';
import { POLYGON } from '../shape/shape-kind.js';
import { works } from './polygon-works.js';

/** A ray o + d · f, 0 ≤ f < `most`, relative to the origin of a body; and where it hits a shape of that body. */
export class RayTest {
  ox = 0;
  oy = 0;
  dx = 1;
  dy = 0;
  most = Infinity;
  /** How many of d the direction of the ray as it was given is long, and how many of that it goes. */
  scale = 1;
  maxFactor = Infinity;
  /** A ray that starts inside a shape does not hit it. */
  outerOnly = false;
  /** The hit: its factor f, and the unit normal of the surface there, which faces against the ray. */
  factor = 0;
  nx = 0;
  ny = 0;

  /** Takes over a direction, scaled so that its larger component is 1, as those of any length shall be equally good. */
  aim({ direction, maxFactor }: Ray, outerOnly: boolean): void {
    const dx = direction[0]!;
    const dy = direction[1]!;
    this.scale = Math.max(Math.abs(dx), Math.abs(dy));
    this.dx = dx / this.scale;
    this.dy = dy / this.scale;
    this.most = maxFactor * this.scale;
    this.maxFactor = maxFactor;
    this.outerOnly = outerOnly;
  }

  /** The factor of the hit, in lengths of the direction as it was given. */
  get share(): number {
    return this.factor / this.scale + 0;
  }
}

/** Whether a ray hits the surface of a placed shape. Shapes are convex, so it does so from outside or, if it starts inside, from within. */
export function rayShape(shape: Shape, ray: RayTest): boolean {
  return shape.kind === POLYGON ? works!.rayPolygon(shape, ray) : rayCircle(shape, ray);
}

/** Clips the ray to the half-planes of the edges: it is inside from the last one it enters to the first one it leaves (Cyrus & Beck 1978). */
export function rayPolygon({ numbers: n, at, offsets }: Polygon, ray: RayTest): boolean {
  const { ox, oy, dx, dy } = ray;
  let enter = -Infinity;
  let leave = Infinity;
  let entered = 0;
  let left = 0;
  for (let i = 0; i < offsets.length; i += 1) {
    const nx = n[at + EDGES + EDGE_STRIDE * i + EDGE_NX]!;
    const ny = n[at + EDGES + EDGE_STRIDE * i + EDGE_NY]!;
    const height = nx * ox + ny * oy - offsets[i]!;
    const rate = nx * dx + ny * dy;
    if (rate === 0) {
      if (height > 0) {
        return false;
      }
    } else if (rate < 0) {
      if (-height / rate > enter) {
        enter = -height / rate;
        entered = i;
      }
    } else if (-height / rate < leave) {
      leave = -height / rate;
      left = i;
    }
  }
  if (enter > leave) {
    return false;
  }
  const outer = enter >= 0;
  const edge = at + EDGES + EDGE_STRIDE * (outer ? entered : left);
  const side = outer ? 1 : -1;
  return accept(ray, outer, outer ? enter : leave, side * n[edge + EDGE_NX]!, side * n[edge + EDGE_NY]!);
}

/** The ray is nearest to the centre at the factor `middle`; the surface lies half a chord before and behind that. */
function rayCircle({ numbers: n, at, radius }: Circle, ray: RayTest): boolean {
  const { dx, dy } = ray;
  const px = ray.ox - n[at + CENTRE_X]!;
  const py = ray.oy - n[at + CENTRE_Y]!;
  const squared = dx * dx + dy * dy;
  const middle = -(px * dx + py * dy) / squared;
  const qx = px + dx * middle;
  const qy = py + dy * middle;
  const chord = radius * radius - (qx * qx + qy * qy);
  if (chord < 0) {
    return false;
  }
  const half = Math.sqrt(chord / squared);
  const outer = middle - half >= 0;
  const factor = outer ? middle - half : middle + half;
  // Computed from the point nearest to the centre: from the origin of the ray, which may be far away, rounding would be in proportion to
  // that distance.
  const from = outer ? -half : half;
  const nx = qx + dx * from;
  const ny = qy + dy * from;
  // Far away the hit is not as exactly on the circle as the length of the normal has to be 1.
  const length = Math.sqrt(nx * nx + ny * ny) || 1;
  const side = outer ? 1 / length : -1 / length;
  return accept(ray, outer, factor, side * nx, side * ny);
}

function accept(ray: RayTest, outer: boolean, factor: number, nx: number, ny: number): boolean {
  const { most, scale, maxFactor, outerOnly } = ray;
  if (!(factor >= 0 && factor < most && factor / scale < maxFactor) || (!outer && outerOnly)) {
    return false;
  }
  ray.factor = factor;
  ray.nx = nx;
  ray.ny = ny;
  return true;
}
