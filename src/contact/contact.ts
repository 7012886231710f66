import { roundness } from '../collide/along.js';
import * as g from '../collide/layout.js';
import { cos, sin } from '../math/trig.js';
import { type NumberSink, type Vec2, vec2 } from '../math/vectors.js';
import type { Arbiter } from './arbiter.js';
import * as c from './layout.js';

/** One point of a collision. Recycled by the engine: do not keep it beyond the next step. */
export class Contact {
  /** Of the class, as in Turbulenz. */
  static get version(): number {
    return 1;
  }

  /** @internal */
  constructor(
    private readonly arbiter: Arbiter,
    private readonly which: 0 | 1,
  ) {}

  /** Belongs to the latest step; an inactive contact is a cache and has to be skipped. */
  get active(): boolean {
    return this.arbiter.active && this.which < this.arbiter.count;
  }

  /** Found but not used by the velocity solver, because the surfaces are apart here. */
  get virtual(): boolean {
    return (this.arbiter.usedPoints & (1 << this.which)) === 0;
  }

  /** This is the first step in which the velocity solver uses the point. */
  get fresh(): boolean {
    return (this.arbiter.freshPoints & (1 << this.which)) !== 0;
  }

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
    const { numbers, at } = this.arbiter;
    return numbers[at + c.STEP_NORMAL + c.IMPULSES * this.which]!;
  }

  /**
   * N·s along the tangent (−n.y, n.x) that body B got in the latest step. Two contacts have one friction, of which each is told the share that it
   * has of their normal impulses.
   */
  getTangentImpulse(): number {
    const { numbers, at } = this.arbiter;
    return numbers[at + c.STEP_TANGENT + c.IMPULSES * this.which]!;
  }
}

/** What `pointAtEnd` found: scratch. */
const end = { x: 0.5, y: 0.5, penetration: 0.5 };

/**
 * Follows a point of the manifold from the placements that it was found for to those of now. Worked out when asked for, because most
 * contacts are never asked.
 */
function pointAtEnd(arbiter: Arbiter, which: 0 | 1): void {
  const { numbers: n, at: o } = arbiter;
  const a = arbiter.bodyA;
  const b = arbiter.bodyB;
  const x = n[o + g.X0 + g.POINT * which]!;
  const y = n[o + g.Y0 + g.POINT * which]!;
  const separation = n[o + g.S0 + g.POINT * which]!;
  const cA = cos(a.angle - n[o + g.ANGLE_A]!);
  const sA = sin(a.angle - n[o + g.ANGLE_A]!);
  const cB = cos(b.angle - n[o + g.ANGLE_B]!);
  const sB = sin(b.angle - n[o + g.ANGLE_B]!);
  const nx = n[o + g.NX]!;
  const ny = n[o + g.NY]!;
  const roundA = roundness(arbiter.shapeA, separation);
  const roundB = roundness(arbiter.shapeB, separation);
  const ax = x - nx * roundA;
  const ay = y - ny * roundA;
  const bx = x - n[o + g.DX]! + nx * roundB;
  const by = y - n[o + g.DY]! + ny * roundB;
  const endX = a.x + cA * ax - sA * ay + nx * roundA;
  const endY = a.y + sA * ax + cA * ay + ny * roundA;
  const gapX = b.x + cB * bx - sB * by - nx * roundB - endX;
  const gapY = b.y + sB * bx + cB * by - ny * roundB - endY;
  const gap = nx * gapX + ny * gapY;
  // Along the surfaces half-way too, but where one is round: that one goes with its centre.
  const share = roundA > 0 === roundB > 0 ? 0.5 : roundB > 0 ? 1 : 0;
  end.x = endX + share * gapX + (0.5 - share) * gap * nx;
  end.y = endY + share * gapY + (0.5 - share) * gap * ny;
  end.penetration = -separation - gap;
}
