import * as g from '../collide/layout.js';
import { type NumberSink, type Vec2, vec2 } from '../math/vectors.js';
import type { Arbiter } from './arbiter.js';
import { atEnd, pointAtEnd } from './at-end.js';
import * as c from './layout.js';

/** One contact point. Recycled by the engine: do not keep it beyond the next step. */
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

  /** Whether it belongs to the latest step. An inactive contact is a cached one: skip it. */
  get active(): boolean {
    return this.arbiter.active && this.which < this.arbiter.count;
  }

  /** Whether the velocity solver did not use the point, because the surfaces are apart here. */
  get virtual(): boolean {
    return ((this.arbiter.usedPoints >> this.which) & 1) === 0;
  }

  /** Whether the latest step is the first in which the velocity solver used the point. */
  get fresh(): boolean {
    return ((this.arbiter.freshPoints >> this.which) & 1) !== 0;
  }

  /** The contact point in world coordinates at the end of the step, half-way into the overlap, m. */
  getPosition(): Vec2;
  getPosition<T extends NumberSink>(dst: T): T;
  getPosition<T extends NumberSink>(dst?: T): T | Vec2 {
    pointAtEnd(this.arbiter, this.which);
    return vec2(atEnd.x, atEnd.y, 'Contact.getPosition', dst);
  }

  /** How deep the shapes overlap here at the end of the step, m; negative where the surfaces are apart. */
  getPenetration(): number {
    pointAtEnd(this.arbiter, this.which);
    return atEnd.penetration;
  }

  /** The normal impulse of the latest step on body B, along the arbiter's normal, N·s, >= 0. Body A received the opposite. */
  getNormalImpulse(): number {
    const { numbers: n, at: o } = this.arbiter;
    const earlier = this.arbiter.shareBefore(this.which, n[o + g.NX]!, n[o + g.NY]!);
    return n[o + c.STEP_NORMAL + c.IMPULSES * this.which]! + Math.max(0, earlier);
  }

  /**
   * The friction impulse of the latest step on body B, along the tangent (−n.y, n.x), N·s. Two contacts share one friction impulse: each
   * reports a part in proportion to its normal impulse. Where the shapes were collided twice in the step, the earlier impulses are shared
   * out likewise.
   */
  getTangentImpulse(): number {
    const { numbers: n, at: o } = this.arbiter;
    const earlier = this.arbiter.shareBefore(this.which, -n[o + g.NY]!, n[o + g.NX]!);
    return n[o + c.STEP_TANGENT + c.IMPULSES * this.which]! + earlier;
  }
}
