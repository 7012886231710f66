import { cos, sin } from '../math/trig.js';
import { type NumberSink, type Vec2, vec2 } from '../math/vectors.js';
import type { Arbiter } from './arbiter.js';

/** One point of a collision. Recycled by the engine: do not keep it beyond the next step. */
export class Contact {
  static readonly version = 1;

  /** Belongs to the latest step; an inactive contact is a cache and has to be skipped. */
  active = false;
  /** Found but not used by the velocity solver, because the surfaces are apart here. */
  virtual = false;
  /** This is the first step in which the velocity solver uses the point. */
  fresh = false;

  /** @internal N·s of the whole step */
  stepNormal = 0;
  /** @internal */
  stepTangent = 0;
  /** @internal N·s of the last sub-step, where the next one starts from */
  normal = 0;
  /** @internal */
  tangent = 0;

  /** @internal */
  constructor(
    private readonly arbiter: Arbiter,
    private readonly which: 0 | 1,
  ) {}

  /** World point half-way into the overlap, at the end of the step, m. */
  getPosition(): Vec2;
  getPosition<T extends NumberSink>(dst: T): T;
  getPosition<T extends NumberSink>(dst?: T): T | Vec2 {
    pointAtEnd(this.arbiter, this.which);
    return vec2(end.x, end.y, dst);
  }

  /** m; negative where the surfaces are apart. */
  getPenetration(): number {
    pointAtEnd(this.arbiter, this.which);
    return end.penetration;
  }

  /** N·s along the arbiter's normal that body B got in the latest step, >= 0; body A got the opposite. */
  getNormalImpulse(): number {
    return this.stepNormal;
  }

  /** N·s along the tangent (−n.y, n.x) that body B got in the latest step. */
  getTangentImpulse(): number {
    return this.stepTangent;
  }

  /** @internal a new point: nothing is kept from before */
  reset(): void {
    this.active = false;
    this.virtual = true;
    this.fresh = false;
    this.stepNormal = 0;
    this.stepTangent = 0;
    this.normal = 0;
    this.tangent = 0;
  }

  /** @internal this is the point that `other` was */
  take(other: Contact): void {
    this.normal = other.normal;
    this.tangent = other.tangent;
    this.virtual = other.virtual;
  }
}

/** What `pointAtEnd` found: scratch. */
const end = { x: 0.5, y: 0.5, penetration: 0.5 };

/**
 * Follows a point of the manifold through the motion of the last step. Worked out when asked for, from what the bodies remember of that
 * motion, because most contacts are never asked; inside a step the bodies have not moved yet.
 */
function pointAtEnd(arbiter: Arbiter, which: 0 | 1): void {
  const m = arbiter.manifold;
  const a = arbiter.bodyA;
  const b = arbiter.bodyB;
  const x = which === 0 ? m.x0 : m.x1;
  const y = which === 0 ? m.y0 : m.y1;
  const separation = which === 0 ? m.separation0 : m.separation1;
  if (arbiter.sleeping || a.owner?.stepping || b.owner?.stepping) {
    end.x = a.x + x;
    end.y = a.y + y;
    end.penetration = -separation;
    return;
  }
  const cA = cos(a.lastTurn);
  const sA = sin(a.lastTurn);
  const cB = cos(b.lastTurn);
  const sB = sin(b.lastTurn);
  const half = 0.5 * separation;
  const ax = x - m.nx * half;
  const ay = y - m.ny * half;
  const bx = x + m.nx * half - m.dx;
  const by = y + m.ny * half - m.dy;
  const onAx = a.x + cA * ax - sA * ay;
  const onAy = a.y + sA * ax + cA * ay;
  const onBx = b.x + cB * bx - sB * by;
  const onBy = b.y + sB * bx + cB * by;
  end.x = 0.5 * (onAx + onBx);
  end.y = 0.5 * (onAy + onBy);
  end.penetration = -(m.nx * (onBx - onAx) + m.ny * (onBy - onAy));
}
