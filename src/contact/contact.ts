import { type NumberSink, type Vec2, vec2 } from '../math/vectors.js';

/** One point of a collision. Recycled by the engine: do not keep it beyond the next step. */
export class Contact {
  static readonly version = 1;

  /** Belongs to the latest step; an inactive contact is a cache and has to be skipped. */
  active = false;
  /** Found but not used by the velocity solver, because the surfaces are apart here. */
  virtual = false;
  /** This is the first step in which the velocity solver uses the point. */
  fresh = false;

  /** @internal world position at the end of the step */
  x = 0;
  /** @internal */
  y = 0;
  /** @internal m, at the end of the step */
  penetration = 0;
  /** @internal N·s of the whole step */
  stepNormal = 0;
  /** @internal */
  stepTangent = 0;
  /** @internal N·s of the last sub-step, where the next one starts from */
  normal = 0;
  /** @internal */
  tangent = 0;

  /** World point half-way into the overlap, at the end of the step, m. */
  getPosition(): Vec2;
  getPosition<T extends NumberSink>(dst: T): T;
  getPosition<T extends NumberSink>(dst?: T): T | Vec2 {
    return vec2(this.x, this.y, dst);
  }

  /** m; negative where the surfaces are apart. */
  getPenetration(): number {
    return this.penetration;
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
