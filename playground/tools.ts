import { type PointConstraint, phys2D, type RigidBody, type Shape, type Vec2, type World } from '../src/index.js';

/** What a click does, and its name on the page. */
export const TOOLS = {
  grab: 'Grab',
  box: 'Box',
  disc: 'Ball',
  polygon: 'Stone',
  delete: 'Delete',
  explode: 'Explode',
} as const;

export type Tool = keyof typeof TOOLS;

/** m of the view's height for each: what is added to a scene is as large on the screen in all of them. */
const SIZE = 0.05;
const BLAST = 0.25;
/** m/s that a blast gives what is in its middle, for each root of a metre. */
const BLAST_SPEED = 5;

/** Holds a body at a point by a spring. The other end is on a static body, which need not be in a world. */
export class Grip {
  private readonly hand = phys2D.createRigidBody({ type: 'static' });
  private readonly spring: PointConstraint;

  constructor(
    private readonly world: World,
    readonly body: RigidBody,
    point: Vec2,
  ) {
    this.spring = phys2D.createPointConstraint({
      bodyA: this.hand,
      bodyB: body,
      anchorA: point,
      anchorB: body.transformWorldPointToLocal(point),
      stiff: false,
      frequency: 4,
      damping: 0.9,
      maxForce: 500 * Math.max(0.05, Math.min(1e6, body.getMass())),
    });
    world.addConstraint(this.spring);
    body.wake();
  }

  move(point: Vec2): void {
    this.spring.setAnchorA(point);
    this.body.wake();
  }

  /** The body keeps its velocity: it is thrown. */
  release(): void {
    this.world.removeConstraint(this.spring);
  }
}

/** The body to take hold of at a point: the nearest within `reach` m, dynamic ones first if only those are wanted. */
export function pick(world: World, point: Vec2, reach: number, dynamicOnly: boolean): RigidBody | null {
  const found: RigidBody[] = [];
  const fits = (body: RigidBody): boolean => body.isDynamic() || (!dynamicOnly && body.shapes.length > 0);
  for (const radius of [reach / 8, reach / 2, reach]) {
    const count = world.bodyCircleQuery(point, radius, found);
    const bodies = found.slice(0, count).filter(fits);
    const nearest = bodies.sort((a, b) => distance(a, point) - distance(b, point))[0];
    if (nearest !== undefined) {
      return nearest;
    }
  }
  return null;
}

function distance(body: RigidBody, [x, y]: Vec2): number {
  const [bx, by] = body.getPosition();
  return Math.hypot(bx - x, by - y);
}

/** Adds a body at a point. `height` of the view, m. */
export function addBody(world: World, tool: Tool, point: Vec2, height: number): RigidBody {
  const size = SIZE * height;
  const body = phys2D.createRigidBody({ position: point, rotation: 0.2, shapes: [shapeOf(tool, size)] });
  world.addRigidBody(body);
  return body;
}

function shapeOf(tool: Tool, size: number): Shape {
  if (tool === 'disc') {
    return phys2D.createCircleShape({ radius: size / 2, material: phys2D.createMaterial({ elasticity: 0.4 }) });
  }
  const vertices =
    tool === 'polygon'
      ? phys2D.createRegularPolygonVertices(size * 1.1, size * 1.1, 5)
      : phys2D.createBoxVertices(size, size);
  return phys2D.createPolygonShape({ vertices });
}

/** Pushes away what is around a point; less, the farther it is. @returns how many bodies. */
export function explode(world: World, point: Vec2, height: number): number {
  const found: RigidBody[] = [];
  const radius = BLAST * height;
  const count = world.bodyCircleQuery(point, radius, found);
  const speed = BLAST_SPEED * Math.sqrt(height);
  let pushed = 0;
  for (const body of found.slice(0, count)) {
    if (body.isDynamic()) {
      const [x, y] = body.getPosition();
      const away = Math.max(1e-3, Math.hypot(x - point[0], y - point[1]));
      const impulse = speed * body.getMass() * Math.max(0.1, 1 - away / radius);
      if (Number.isFinite(impulse)) {
        body.applyImpulse([(impulse * (x - point[0])) / away, (impulse * (y - point[1])) / away]);
        pushed += 1;
      }
    }
  }
  return pushed;
}
