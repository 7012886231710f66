import type { RigidBody } from '../body.js';
import { type NumberSink, type Vec2, type Vec2Like, vec2 } from '../math/vectors.js';
import type { Tape } from '../state/tape.js';
import { optional, options } from '../validate.js';
import { Link } from './link.js';
import {
  BoundedConstraint,
  type Bounds,
  checkedBody,
  checkedRatio,
  type TwoAnchorParams,
  takeBounds,
} from './two-body.js';

/** Options of `createPulleyConstraint`. The bounds are of the length of both links together, m; both are 0 by default, so give `upperBound`. */
export interface PulleyConstraintParams extends TwoAnchorParams, Bounds {
  /** The body where the second link begins; may be bodyB. */
  bodyC: RigidBody;
  /** The body where the second link ends. */
  bodyD: RigidBody;
  /** Where on body C, in its own coordinates, m. Default `[0, 0]`. */
  anchorC?: Vec2Like | undefined;
  /** Where on body D, likewise. Default `[0, 0]`. */
  anchorD?: Vec2Like | undefined;
  /** How much rope the first link gives up for each unit of length that the second one gains, not 0. Default 1. */
  ratio?: number | undefined;
}

/**
 * A rope from A over B and C to D, as in a block and tackle: bounds on the length of its two links together.
 *
 *     lower ≤ |wB − wA| + ratio · |wD − wC| ≤ upper,   w = x + R(θ) · anchor
 */
export class PulleyConstraint extends BoundedConstraint {
  /** Tells the kinds apart. */
  readonly type = 'PULLEY';

  private readonly first = new Link(0, 1);
  private readonly second = new Link(2, 3);

  /** @internal use `createPulleyConstraint` */
  constructor(params: PulleyConstraintParams) {
    const where = 'createPulleyConstraint';
    const { bodyC, bodyD } = options(where, params, true);
    super(where, 1, params, checkedBody(where, 'bodyC', bodyC), checkedBody(where, 'bodyD', bodyD));
    this.takeAnchor(where, 'anchorC', 2, params.anchorC);
    this.takeAnchor(where, 'anchorD', 3, params.anchorD);
    this.ratio = checkedRatio(where, optional(params.ratio, 1));
    takeBounds(this, where, params, 0, 0);
  }

  /** The body where the second link begins. */
  get bodyC(): RigidBody {
    return this.members[2]!;
  }

  /** The body where the second link ends. */
  get bodyD(): RigidBody {
    return this.members[3]!;
  }

  /** The anchor on body C, in its coordinates, m. */
  getAnchorC(): Vec2;
  getAnchorC<T extends NumberSink>(dst: T): T;
  getAnchorC<T extends NumberSink>(dst?: T): T | Vec2 {
    return vec2(this.anchors[4]!, this.anchors[5]!, 'PulleyConstraint.getAnchorC', dst);
  }

  /** Sets the anchor on body C, in its coordinates, m. */
  setAnchorC(anchor: Vec2Like): void {
    this.setAnchor('C', 2, anchor);
  }

  /** The anchor on body D, in its coordinates, m. */
  getAnchorD(): Vec2;
  getAnchorD<T extends NumberSink>(dst: T): T;
  getAnchorD<T extends NumberSink>(dst?: T): T | Vec2 {
    return vec2(this.anchors[6]!, this.anchors[7]!, 'PulleyConstraint.getAnchorD', dst);
  }

  /** Sets the anchor on body D, in its coordinates, m. */
  setAnchorD(anchor: Vec2Like): void {
    this.setAnchor('D', 3, anchor);
  }

  /** How much rope the first link gives up for each unit of length that the second one gains. */
  getRatio(): number {
    return this.ratio;
  }

  /** Sets the ratio, not 0. Wakes the constraint if changed. */
  setRatio(ratio: number): void {
    this.changeRatio(ratio);
  }

  /** @internal */
  override keep(tape: Tape): void {
    this.first.keep(tape);
    this.second.keep(tape);
    super.keep(tape);
  }

  /** @internal */
  measure(pose: Float64Array, out: Float64Array, c: number, j: number): void {
    this.first.add(1, pose, this.anchors, out, c, j);
    this.second.add(this.ratio, pose, this.anchors, out, c, j);
  }
}
