import type { Physics2DDevice, RigidBody, Shape, Vec2, World } from '../../../src/index.js';
import { deepestOverlap, type Outline } from '../../quality/claims/overlap.js';

/** s. */
export const DT = 1 / 60;

/** A scene of the bench. It uses only what all engines can be given, so that they can be compared. */
export interface SpeedScene {
  /** What it is, as tables have it. */
  readonly title: string;
  /** What `quality` returns, and its unit: that speed which comes of squashing, stretching or losing things shows. */
  readonly figure: string;
  /** Steps before the clock runs. */
  readonly warmUp: number;
  /** Steps that are timed. */
  readonly steps: number;
  /** Whether bodies are made in each step, which allocates. */
  readonly renews?: boolean;
  /** Whether steps are much alike, so that a slow engine may do fewer of either. */
  readonly steady: boolean;
  start(phys2D: Physics2DDevice): SpeedRun;
}

export interface SpeedRun {
  readonly world: World;
  /** What is timed, if that is more than a step of the world. */
  readonly act?: () => void;
  /** What is done before, untimed; `index` counts from the start, warm-up included. */
  readonly before?: (index: number) => void;
  quality(): number;
}

export interface Parts {
  readonly body: RigidBody;
  readonly outlines: readonly Outline[];
}

interface HeapMaterial {
  readonly friction?: number;
  readonly elasticity?: number;
  readonly density?: number;
}

interface BodyOptions {
  readonly type?: 'dynamic' | 'static' | 'kinematic';
  readonly rotation?: number;
  readonly velocity?: Vec2;
  readonly angularVelocity?: number;
  readonly bullet?: boolean;
  readonly sleeping?: boolean;
}

/** Adds bodies to a world, and remembers what they were made of. All are of one material, and without drag. */
export class Heap {
  readonly parts: Parts[] = [];
  private readonly material;

  constructor(
    private readonly phys2D: Physics2DDevice,
    readonly world: World,
    { friction = 0.6, elasticity = 0, density = 1 }: HeapMaterial = {},
  ) {
    this.material = phys2D.createMaterial({
      elasticity,
      density,
      staticFriction: friction,
      dynamicFriction: friction,
      rollingFriction: 0,
    });
  }

  get bodies(): RigidBody[] {
    return this.parts.map(({ body }) => body);
  }

  /** A body of any number of shapes. */
  add(outlines: readonly Outline[], position: Vec2, options: BodyOptions = {}): RigidBody {
    const shapes = outlines.map((outline) => this.shapeOf(outline));
    const body = this.phys2D.createRigidBody({ position, shapes, linearDrag: 0, angularDrag: 0, ...options });
    this.world.addRigidBody(body);
    this.parts.push({ body, outlines });
    return body;
  }

  box(width: number, height: number, position: Vec2, options?: BodyOptions): RigidBody {
    return this.add([box(width, height)], position, options);
  }

  /** mm. The deepest overlap of any two of these bodies; parts of one body that overlap would count, so there must be none. */
  overlap(parts: readonly Parts[] = this.parts): number {
    const bodies = parts.flatMap(({ body, outlines }) => outlines.map(() => body));
    const outlines = parts.flatMap((each) => each.outlines);
    return 1000 * deepestOverlap(bodies, (_, i) => outlines[i]!, false);
  }

  private shapeOf(outline: Outline): Shape {
    const { phys2D, material } = this;
    if ('radius' in outline) {
      return phys2D.createCircleShape({ radius: outline.radius, material });
    }
    const vertices = 'size' in outline ? phys2D.createBoxVertices(outline.size, outline.size) : outline.vertices;
    return phys2D.createPolygonShape({ vertices, material });
  }
}

/** A box along the axes around (x, y). */
export function box(width: number, height: number, x = 0, y = 0): Outline {
  const [w, h] = [width / 2, height / 2];
  return {
    vertices: [
      [x - w, y - h],
      [x + w, y - h],
      [x + w, y + h],
      [x - w, y + h],
    ],
  };
}

/** A regular polygon around the origin. */
export function regular(radius: number, sides: number): Outline {
  const corner = (_: unknown, i: number): [number, number] => {
    const angle = (2 * Math.PI * (i + 0.5)) / sides;
    return [radius * Math.cos(angle), radius * Math.sin(angle)];
  };
  return { vertices: Array.from({ length: sides }, corner) };
}

/** A closed ring of boards around the origin, `radius` wide within. */
export function ring(radius: number, thickness: number, sides: number): Outline[] {
  const outer = radius + thickness;
  const half = outer * Math.tan(Math.PI / sides);
  const corners: Vec2[] = [
    [radius, -half],
    [outer, -half],
    [outer, half],
    [radius, half],
  ];
  return Array.from({ length: sides }, (_, i) => {
    const angle = (2 * Math.PI * i) / sides;
    const [c, s] = [Math.cos(angle), Math.sin(angle)];
    return { vertices: corners.map(([x, y]): [number, number] => [c * x - s * y, s * x + c * y]) };
  });
}

/** How many bodies are farther than that from a point, or nowhere. */
export function countOutside(bodies: readonly RigidBody[], [cx, cy]: Vec2, distance: number): number {
  const isOut = ([x, y]: Vec2): boolean => !((x - cx) ** 2 + (y - cy) ** 2 < distance ** 2);
  return bodies.filter((body) => isOut(body.getPosition())).length;
}

/** mm. How far the body that sank most has sunk since. */
export function watchSag(bodies: readonly RigidBody[]): () => number {
  const heights = bodies.map((body) => body.getPosition()[1]);
  return () => 1000 * Math.max(...bodies.map((body, i) => body.getPosition()[1] - heights[i]!));
}
