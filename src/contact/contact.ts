import * as g from '../collide/layout.js';
import { type NumberSink, type Vec2, vec2 } from '../math/vectors.js';
import type { Arbiter } from './arbiter.js';
import { atEnd, pointAtEnd } from './at-end.js';
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
    return vec2(atEnd.x, atEnd.y, 'Contact.getPosition', dst);
  }

  /** m; negative where the surfaces are apart. */
  getPenetration(): number {
    pointAtEnd(this.arbiter, this.which);
    return atEnd.penetration;
  }

  /** N·s along the arbiter's normal that body B got in the latest step, >= 0; body A got the opposite. */
  getNormalImpulse(): number {
    const { numbers: n, at: o } = this.arbiter;
    const earlier = this.arbiter.gaveBefore(this.which, n[o + g.NX]!, n[o + g.NY]!);
    return n[o + c.STEP_NORMAL + c.IMPULSES * this.which]! + Math.max(0, earlier);
  }

  /**
   * N·s along the tangent (−n.y, n.x) that body B got in the latest step. Two contacts have one friction, of which each is told the share that it
   * has of their normal impulses; and likewise where the shapes met twice in the step, of what they gave each other before.
   */
  getTangentImpulse(): number {
    const { numbers: n, at: o } = this.arbiter;
    const earlier = this.arbiter.gaveBefore(this.which, -n[o + g.NY]!, n[o + g.NX]!);
    return n[o + c.STEP_TANGENT + c.IMPULSES * this.which]! + earlier;
  }
}
