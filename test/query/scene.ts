import {
  type Broadphase,
  phys2D,
  type Ray,
  type RigidBody,
  type Shape,
  type Vec2,
  type World,
} from '../../src/index.js';
import type { Chance } from '../geometry/forms.js';
import { type Form, signedDistance } from '../geometry/reference.js';

const TYPES = ['dynamic', 'dynamic', 'kinematic', 'static'] as const;

/** What a ray does to a shape: distances along it, in m. */
export interface Crossing {
  at: number;
  inner: boolean;
  /** Against the ray. */
  normal: Vec2;
  /** At a corner, where the normals of both edges are right. */
  corner: boolean;
  /** A matter of rounding: it barely touches, or begins or ends on the surface. */
  unsure: boolean;
}

const UNSURE = 1e-7;

/** Local geometry as it was asked for: corners, or a centre. */
interface Local {
  points: Vec2[];
  radius: number;
}

/**
 * The same random bodies in a world for each broadphase, stepped, moved and reshaped since, and what a ray or a region meets there, worked
 * out from nothing but the geometry that the shapes were made with and where their bodies say they are.
 */
export class Scene {
  readonly worlds: readonly World[];
  /** Per world, in the same order. */
  readonly bodies: readonly RigidBody[][];
  readonly shapes: readonly Shape[][] = [[], []];
  /** In world coordinates, by the index that is also the user data of the shape. */
  forms: Form[] = [];
  private readonly locals: Local[] = [];

  constructor(
    readonly chance: Chance,
    count: number,
    readonly extent: number,
  ) {
    const broadphases: Broadphase[] = [phys2D.createBoxTreeBroadphase(), phys2D.createSweepAndPruneBroadphase()];
    this.worlds = broadphases.map((broadphase) => phys2D.createWorld({ broadphase, gravity: [0, 2] }));
    this.bodies = this.worlds.map(() => []);
    for (let i = 0; i < count; i += 1) {
      this.addBody();
    }
    for (const world of this.worlds) {
      for (let i = 0; i < 10; i += 1) {
        world.step(1 / 60);
      }
    }
    this.stir();
  }

  /** Does the same to a body, or its shape, of each world. */
  private each(bodies: number, act: (body: RigidBody) => void): void {
    for (const list of this.bodies) {
      act(list[bodies]!);
    }
  }

  private addBody(): void {
    const { chance, extent } = this;
    const type = TYPES[chance.index(TYPES.length)]!;
    const shapes = Array.from({ length: 1 + chance.index(3) }, () => this.makeLocal());
    const velocity: Vec2 = [chance.span(-3, 3), chance.span(-3, 3)];
    const placement = { position: [chance.span(0, extent), chance.span(0, extent)], rotation: chance.span(-9, 9) };
    const sensor = chance.next() < 0.2;
    const group = chance.index(4);
    this.worlds.forEach((world, w) => {
      const body = phys2D.createRigidBody({ type, ...placement, velocity, angularVelocity: velocity[0] });
      shapes.forEach((local, k) => {
        const index = this.locals.length - shapes.length + k;
        const params = { sensor, group, mask: group, userData: index };
        const shape = local.radius
          ? phys2D.createCircleShape({ radius: local.radius, origin: local.points[0]!, ...params })
          : phys2D.createPolygonShape({ vertices: local.points, ...params });
        body.addShape(shape);
        this.shapes[w]![index] = shape;
      });
      world.addRigidBody(body);
      this.bodies[w]!.push(body);
    });
  }

  private makeLocal(): Local {
    const { chance } = this;
    const size = chance.size(0.05, 3);
    const at: Vec2 = chance.next() < 0.5 ? [0, 0] : [chance.span(-1, 1), chance.span(-1, 1)];
    const kind = chance.index(4);
    const vertices =
      kind === 1
        ? phys2D.createBoxVertices(size, size)
        : phys2D.createRegularPolygonVertices(size, size * chance.size(1e-4, 1), 3 + chance.index(6));
    const local: Local =
      kind === 0
        ? { points: [at], radius: size / 2 }
        : { points: vertices.map(([x, y]) => [x + at[0], y + at[1]]), radius: 0 };
    this.locals.push(local);
    return local;
  }

  /** Moves, turns, reshapes and puts to sleep some bodies, without a step. */
  stir(): void {
    const { chance, extent, locals } = this;
    this.bodies[0]!.forEach((body, i) => {
      if (body.isStatic() || chance.next() < 0.6) {
        return;
      }
      const position: Vec2 = [chance.span(0, extent), chance.span(0, extent)];
      const rotation = chance.next() < 0.3 ? 0 : chance.span(-9, 9);
      this.each(i, (one) => one.setPosition(position));
      this.each(i, (one) => one.setRotation(rotation));
      const index = body.shapes[0]!.userData as number;
      if (chance.next() < 0.3) {
        const { points, radius } = locals[index]!;
        const factor = chance.span(0.5, 2);
        locals[index] = { points: points.map(([x, y]) => [factor * x, factor * y]), radius: factor * radius };
        this.each(i, (one) => one.shapes[0]!.scale(factor));
      } else if (chance.next() < 0.2) {
        this.each(i, (one) => one.sleep());
      }
    });
    this.forms = locals.map((_, index) => this.formOf(index));
  }

  /** Where a shape is, or would be with its body elsewhere. */
  formOf(index: number, body: RigidBody = this.shapes[0]![index]!.body!, t = 0): Form {
    const { points, radius } = this.locals[index]!;
    const [x, y] = body.getPosition();
    const [vx, vy] = t === 0 ? [0, 0] : body.getVelocity();
    const angle = body.getRotation() + (t === 0 ? 0 : t * body.getAngularVelocity());
    const [c, s] = [Math.cos(angle), Math.sin(angle)];
    const corners = points.flatMap(([px, py]) => [x + vx * t + c * px - s * py, y + vy * t + s * px + c * py]);
    return { corners: Float64Array.from(corners), radius };
  }

  /** The shapes that meet a form, and those of which it is a matter of rounding. */
  meeting(form: Form, tolerance: number): { sure: Set<number>; unsure: Set<number> } {
    const sure = new Set<number>();
    const unsure = new Set<number>();
    this.forms.forEach((other, index) => {
      const distance = signedDistance(form, other);
      if (Math.abs(distance) < tolerance) {
        unsure.add(index);
      } else if (distance < 0) {
        sure.add(index);
      }
    });
    return { sure, unsure };
  }

  /** What a ray meets, by shape. */
  crossings(ray: Ray, outerOnly: boolean): Map<number, Crossing> {
    const found = new Map<number, Crossing>();
    const [ox, oy] = [ray.origin[0]!, ray.origin[1]!];
    const scale = Math.max(Math.abs(ray.direction[0]!), Math.abs(ray.direction[1]!));
    const [x, y] = [ray.direction[0]! / scale, ray.direction[1]! / scale];
    const length = Math.hypot(x, y);
    const most = ray.maxFactor * scale * length;
    this.forms.forEach((form, index) => {
      const crossing = cross(form, ox, oy, x / length, y / length);
      const { at, inner, unsure } = crossing;
      if (at > -UNSURE && at < most + UNSURE && (!(inner && outerOnly) || unsure)) {
        found.set(index, { ...crossing, unsure: unsure || Math.abs(at - most) < UNSURE });
      }
    });
    return found;
  }

  /** Close to the boundary of something, within or without. */
  nearBoundary(): Vec2 {
    const { corners, radius } = this.forms[this.chance.index(this.forms.length)]!;
    const off = (this.chance.next() < 0.5 ? -1 : 1) * this.chance.size(1e-6, 1e-2);
    if (radius > 0) {
      const angle = this.chance.span(-4, 4);
      return [corners[0]! + (radius + off) * Math.cos(angle), corners[1]! + (radius + off) * Math.sin(angle)];
    }
    const share = this.chance.next();
    const along = (k: number) => corners[k]! + share * (corners[k + 2]! - corners[k]!);
    return [along(0) + off, along(1) + off];
  }

  /** Something on an outline: a corner, and one next to it. */
  randomEdge(): [Vec2, Vec2] {
    for (;;) {
      const { corners } = this.forms[this.chance.index(this.forms.length)]!;
      if (corners.length > 2) {
        const i = 2 * this.chance.index(corners.length / 2);
        const j = (i + 2) % corners.length;
        return [
          [corners[i]!, corners[i + 1]!],
          [corners[j]!, corners[j + 1]!],
        ];
      }
    }
  }
}

/** Where a line of unit direction crosses a form first, from its origin on: every edge is cut with it, or the circle. */
function cross({ corners, radius }: Form, ox: number, oy: number, x: number, y: number): Crossing {
  const { cuts, unsure: along } =
    radius > 0 ? cutCircle(corners, radius, ox, oy, x, y) : cutEdges(corners, ox, oy, x, y);
  cuts.sort((a, b) => a.at - b.at);
  const [first, last] = [cuts[0], cuts.at(-1)];
  if (along) {
    return { at: 0, inner: false, normal: [0, 0], corner: true, unsure: true };
  }
  if (first === undefined || last === undefined) {
    return { at: -Infinity, inner: false, normal: [0, 0], corner: true, unsure: false };
  }
  const inner = first.at < 0;
  const { at, normal, corner } = inner ? last : first;
  const unsure = last.at - first.at < UNSURE || Math.abs(first.at) < UNSURE || Math.abs(last.at) < UNSURE;
  const against = normal[0] * x + normal[1] * y > 0 ? -1 : 1;
  return { at, inner, normal: [against * normal[0], against * normal[1]], corner, unsure };
}

function cutCircle(corners: Float64Array, radius: number, ox: number, oy: number, x: number, y: number) {
  const [px, py] = [ox - corners[0]!, oy - corners[1]!];
  const height = x * py - y * px;
  if (Math.abs(height) > radius) {
    return { cuts: [], unsure: false };
  }
  const half = Math.sqrt((radius - height) * (radius + height));
  const cuts = [-half, half].map((side) => {
    const at = side - (px * x + py * y);
    return { at, normal: [(px + at * x) / radius, (py + at * y) / radius] as Vec2, corner: false };
  });
  return { cuts, unsure: false };
}

function cutEdges(corners: Float64Array, ox: number, oy: number, x: number, y: number) {
  const cuts: { at: number; normal: Vec2; corner: boolean }[] = [];
  for (let i = 0; i < corners.length; i += 2) {
    const j = (i + 2) % corners.length;
    const [px, py] = [corners[i]! - ox, corners[i + 1]! - oy];
    const [ex, ey] = [corners[j]! - corners[i]!, corners[j + 1]! - corners[i + 1]!];
    const length = Math.hypot(ex, ey);
    const rate = x * ey - y * ex;
    const share = (px * y - py * x) / rate;
    if (Math.abs(rate) < 1e-9 * length) {
      if (Math.abs(px * y - py * x) < UNSURE) {
        return { cuts, unsure: true };
      }
    } else if (share > -1e-9 && share < 1 + 1e-9) {
      cuts.push({
        at: (px * ey - py * ex) / rate,
        normal: [ey / length, -ex / length],
        corner: Math.abs(share - 0.5) > 0.5 - 1e-6,
      });
    }
  }
  return { cuts, unsure: false };
}

/** Indices of shapes. */
export function indices(shapes: readonly Shape[]): number[] {
  return shapes.map(({ userData }) => userData as number);
}
