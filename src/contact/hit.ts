import * as g from '../collide/layout.js';
import { SPECULATIVE_MARGIN } from '../config.js';
import { type NumberSink, type Vec2, vec2 } from '../math/vectors.js';
import type { Arbiter } from './arbiter.js';
import * as c from './layout.js';

/** How a collision began: what a sound or damage needs. Recycled by the engine: do not keep it beyond the handler. */
export class Hit {
  private speed = 0;
  private given = 0;
  private readonly point: Vec2 = [0, 0];
  private readonly normal: Vec2 = [0, 0];

  /** How fast the surfaces approached each other along the normal at the fastest contact, when they met or the step began, m/s, >= 0. */
  get approachSpeed(): number {
    return this.speed;
  }

  /** The normal impulse of the collision in the step, over all its contacts, N·s, >= 0. For friction as well see `arbiter.getImpulseForBody`. */
  get impulse(): number {
    return this.given;
  }

  /** Where the impulse acted: the mean of the contact points at the end of the step, weighted by their normal impulses, in world coordinates, m. */
  getPosition(): Vec2;
  getPosition<T extends NumberSink>(dst: T): T;
  getPosition<T extends NumberSink>(dst?: T): T | Vec2 {
    return vec2(this.point[0], this.point[1], 'Hit.getPosition', dst);
  }

  /** Unit vector from `arbiter.shapeA` towards `arbiter.shapeB`, along which the impulse acted. */
  getNormal(): Vec2;
  getNormal<T extends NumberSink>(dst: T): T;
  getNormal<T extends NumberSink>(dst?: T): T | Vec2 {
    return vec2(this.normal[0], this.normal[1], 'Hit.getNormal', dst);
  }

  /** @internal copies the outcome of the step, as handlers may change the arbiter */
  read(arbiter: Arbiter): void {
    this.speed = arbiter.numbers[arbiter.at + c.APPROACH]!;
    let x = 0;
    let y = 0;
    let sum = 0;
    for (const contact of arbiter.contacts) {
      // Points without any impulse weigh the same.
      const weight = contact.getNormalImpulse() + 1e-300;
      sum += weight;
      const share = weight / sum;
      contact.getPosition(this.point);
      x += share * (this.point[0] - x);
      y += share * (this.point[1] - y);
    }
    this.point[0] = x;
    this.point[1] = y;
    const nx = arbiter.numbers[arbiter.at + g.NX]!;
    const ny = arbiter.numbers[arbiter.at + g.NY]!;
    this.normal[0] = nx;
    this.normal[1] = ny;
    const [jx, jy] = arbiter.getImpulseForBody(arbiter.bodyB);
    this.given = Math.max(0, nx * jx + ny * jy);
  }
}

/**
 * @internal Writes to the record how fast the surfaces approach each other at the fastest contact; 0 if they separate. Call before the pair
 * is solved.
 */
export function noteApproach({ bodyA: a, bodyB: b, count, numbers: n, at: o }: Arbiter): void {
  let fastest = 0;
  for (let i = 0; i < count; i += 1) {
    const ax = n[o + g.X0 + g.POINT * i]!;
    const ay = n[o + g.Y0 + g.POINT * i]!;
    const bx = ax - n[o + g.DX]!;
    const by = ay - n[o + g.DY]!;
    const vx = b.vx - b.w * by - (a.vx - a.w * ay);
    const vy = b.vy + b.w * bx - (a.vy + a.w * ax);
    const speed = -(n[o + g.NX]! * vx + n[o + g.NY]! * vy);
    if (n[o + g.S0 + g.POINT * i]! <= SPECULATIVE_MARGIN && speed > fastest) {
      fastest = speed;
    }
  }
  n[o + c.APPROACH] = fastest;
}
