import { RigidBody } from '../body.js';
import { type NumberSink, type Vec2, type Vec2Like, vec2 } from '../math/vectors.js';
import type { Tape } from '../state/tape.js';
import { finite, instance, notNaN, optional, options, rangeError, vector } from '../validate.js';
import { BaseConstraint, checkBounds } from './constraint.js';
import type { ConstraintParams } from './params.js';

/** Options of constraints between two bodies. */
export interface TwoBodyParams extends ConstraintParams {
  /** The first body. A static one need not be in a world: it holds the other in place all the same. */
  bodyA: RigidBody;
  /** The second body, likewise. If it is bodyA, the constraint does nothing. */
  bodyB: RigidBody;
}

/** Options of constraints on the rotations of two bodies. */
export interface RatioParams extends TwoBodyParams {
  /** Turns of body A for one turn of body B, not 0; negative for gears that mesh, which turn in opposite directions. Default 1. */
  ratio?: number | undefined;
}

/** Options of constraints between points of two bodies. */
export interface TwoAnchorParams extends TwoBodyParams {
  /** Where on body A, in its own coordinates, m; for a point in the world use `bodyA.transformWorldPointToLocal(point)`. Default `[0, 0]`. */
  anchorA?: Vec2Like | undefined;
  /** Where on body B, likewise. Default `[0, 0]`. */
  anchorB?: Vec2Like | undefined;
}

/** The range of a constrained value. */
export interface Bounds {
  /** The lower limit, not above `upperBound`; −`Infinity` for none. If both are equal, the value is fixed. */
  lowerBound?: number | undefined;
  /** The upper limit; `Infinity` for none. */
  upperBound?: number | undefined;
}

const ORIGIN: Vec2Like = [0, 0];

/** A constraint between two bodies, which cannot be changed later. */
export abstract class TwoBodyConstraint extends BaseConstraint {
  /** @internal for the kinds that have one; else 1 */
  ratio = 1;

  /** @internal */
  constructor(where: string, dimension: number, params: TwoBodyParams, ...more: RigidBody[]) {
    const { bodyA, bodyB } = options(where, params, true);
    super(where, dimension, [checkedBody(where, 'bodyA', bodyA), checkedBody(where, 'bodyB', bodyB), ...more], params);
  }

  /** The first body. */
  get bodyA(): RigidBody {
    return this.members[0]!;
  }

  /** The second body. */
  get bodyB(): RigidBody {
    return this.members[1]!;
  }

  /** @internal */
  override keep(tape: Tape): void {
    this.ratio = tape.number(this.ratio);
    super.keep(tape);
  }

  /** @internal */
  protected changeRatio(ratio: number): void {
    checkedRatio(`${this.className}.setRatio`, ratio);
    if (ratio !== this.ratio) {
      this.ratio = ratio;
      this.rouse();
    }
  }
}

/** A constraint on the rotations of two bodies, such as two gears. */
export abstract class RatioConstraint extends TwoBodyConstraint {
  /** @internal */
  constructor(where: string, params: RatioParams) {
    super(where, 1, params);
    this.ratio = checkedRatio(where, optional(params.ratio, 1));
  }

  /** Turns of body A for one turn of body B. */
  getRatio(): number {
    return this.ratio;
  }

  /** Sets the ratio, not 0. Wakes the constraint if changed. */
  setRatio(ratio: number): void {
    this.changeRatio(ratio);
  }
}

/** A constraint between points of bodies. */
export abstract class AnchoredConstraint extends TwoBodyConstraint {
  /** @internal x, y of the anchors of the members, in their coordinates */
  readonly anchors: Float64Array;

  /** @internal */
  constructor(where: string, dimension: number, params: TwoAnchorParams, ...more: RigidBody[]) {
    super(where, dimension, params, ...more);
    this.anchors = new Float64Array(2 * this.members.length);
    this.takeAnchor(where, 'anchorA', 0, params.anchorA);
    this.takeAnchor(where, 'anchorB', 1, params.anchorB);
  }

  /** @internal */
  override keep(tape: Tape): void {
    super.keep(tape);
    tape.list(this.anchors);
  }

  /** The anchor on body A, in its coordinates, m. */
  getAnchorA(): Vec2;
  getAnchorA<T extends NumberSink>(dst: T): T;
  getAnchorA<T extends NumberSink>(dst?: T): T | Vec2 {
    return vec2(this.anchors[0]!, this.anchors[1]!, `${this.className}.getAnchorA`, dst);
  }

  /** Sets the anchor on body A, in its coordinates, m. */
  setAnchorA(anchor: Vec2Like): void {
    this.setAnchor('A', 0, anchor);
  }

  /** The anchor on body B, in its coordinates, m. */
  getAnchorB(): Vec2;
  getAnchorB<T extends NumberSink>(dst: T): T;
  getAnchorB<T extends NumberSink>(dst?: T): T | Vec2 {
    return vec2(this.anchors[2]!, this.anchors[3]!, `${this.className}.getAnchorB`, dst);
  }

  /** Sets the anchor on body B, in its coordinates, m. */
  setAnchorB(anchor: Vec2Like): void {
    this.setAnchor('B', 1, anchor);
  }

  /** @internal */
  protected setAnchor(name: string, k: number, anchor: Vec2Like): void {
    vector(`${this.className}.setAnchor${name}`, 'anchor', anchor, 2);
    if (anchor[0] !== this.anchors[2 * k] || anchor[1] !== this.anchors[2 * k + 1]) {
      this.putAnchor(k, anchor);
      this.moved();
      this.rouse();
    }
  }

  /** @internal takes an anchor from the options */
  protected takeAnchor(where: string, name: string, k: number, anchor: Vec2Like | undefined): void {
    this.putAnchor(k, vector(where, name, optional(anchor, ORIGIN), 2));
  }

  /** @internal called when an anchor has been moved */
  protected moved(): void {}

  /** @internal */
  private putAnchor(k: number, anchor: Vec2Like): void {
    this.anchors[2 * k] = anchor[0]!;
    this.anchors[2 * k + 1] = anchor[1]!;
  }
}

/** An anchored constraint that keeps a length, or a position along a line, within bounds. */
export abstract class BoundedConstraint extends AnchoredConstraint {
  /** The least length, m. */
  getLowerBound(): number {
    return this.lower;
  }

  /** Sets the least length, m: not above the upper bound, and for a distance constraint not below 0. Wakes the constraint if changed. */
  setLowerBound(lowerBound: number): void {
    this.setLower(lowerBound);
  }

  /** The greatest length, m. */
  getUpperBound(): number {
    return this.upper;
  }

  /** Sets the greatest length, m: not below the lower bound. Wakes the constraint if changed. */
  setUpperBound(upperBound: number): void {
    this.setUpper(upperBound);
  }
}

/** @internal */
export function checkedBody(where: string, name: string, body: unknown): RigidBody {
  return instance(where, name, body, RigidBody, 'a RigidBody');
}

/** @internal a finite number other than 0 */
export function checkedRatio(where: string, ratio: unknown): number {
  if (finite(where, 'ratio', ratio) === 0) {
    throw rangeError(where, 'ratio', 'a finite number, not 0', ratio);
  }
  return ratio as number;
}

/** @internal sets the bounds of a constraint under construction: those given, or the defaults */
export function takeBounds(
  constraint: BaseConstraint,
  where: string,
  params: Bounds,
  lower: number,
  upper: number,
): void {
  constraint.lower = notNaN(where, 'lowerBound', optional(params.lowerBound, lower));
  constraint.upper = notNaN(where, 'upperBound', optional(params.upperBound, upper));
  checkBounds(where, params.upperBound === undefined ? 'lowerBound' : 'upperBound', constraint.lower, constraint.upper);
  constraint.bounded = true;
}
