import type {
  MaterialParams,
  Physics2DDevice,
  PointConstraint,
  RigidBody,
  RigidBodyParams,
  Shape,
  ShapeParams,
  Vec2,
  World,
} from '../../src/index.js';

/** What a player holds down. */
export interface Controls {
  left: boolean;
  right: boolean;
  up: boolean;
  down: boolean;
}

/** Nothing held down. */
export const HANDS_OFF: Readonly<Controls> = { left: false, right: false, up: false, down: false };

/** What a scene does while it runs. */
export interface Play {
  /** To be called before each step. */
  readonly beforeStep?: (controls: Readonly<Controls>) => void;
  /** What a camera should follow. */
  readonly follow?: RigidBody;
}

export interface PartParams extends RigidBodyParams {
  readonly surface?: MaterialParams | undefined;
  readonly shape?: ShapeParams | undefined;
}

/** Makes bodies of one shape, and adds them to a world. */
export class Builder {
  constructor(
    readonly phys2D: Physics2DDevice,
    readonly world: World,
  ) {}

  box(x: number, y: number, width: number, height: number, params: PartParams = {}): RigidBody {
    return this.polygon(this.phys2D.createBoxVertices(width, height), { position: [x, y], ...params });
  }

  /** A static box between two corners. */
  wall(x1: number, y1: number, x2: number, y2: number, params: PartParams = {}): RigidBody {
    return this.polygon(this.phys2D.createRectangleVertices(x1, y1, x2, y2), { type: 'static', ...params });
  }

  disc(x: number, y: number, radius: number, params: PartParams = {}): RigidBody {
    const shape = this.phys2D.createCircleShape({ radius, ...this.common(params) });
    return this.add(shape, { position: [x, y], ...params });
  }

  polygon(vertices: Vec2[], params: PartParams): RigidBody {
    return this.add(this.phys2D.createPolygonShape({ vertices, ...this.common(params) }), params);
  }

  /** Joins two bodies, which do not interact, at a point of either. */
  pin(bodyA: RigidBody, anchorA: Vec2, bodyB: RigidBody, anchorB: Vec2): PointConstraint {
    const joint = this.phys2D.createPointConstraint({ bodyA, anchorA, bodyB, anchorB, ignoreInteractions: true });
    this.world.addConstraint(joint);
    return joint;
  }

  private common({ surface, shape }: PartParams): ShapeParams {
    return { ...shape, ...(surface === undefined ? {} : { material: this.phys2D.createMaterial(surface) }) };
  }

  private add(shape: Shape, { surface, shape: _, ...params }: PartParams): RigidBody {
    const body = this.phys2D.createRigidBody({ ...params, shapes: [shape] });
    this.world.addRigidBody(body);
    return body;
  }
}

/** Alike at rest and sliding, without resistance to rolling. */
export function friction(value: number, elasticity = 0): MaterialParams {
  return { staticFriction: value, dynamicFriction: value, rollingFriction: 0, elasticity };
}
