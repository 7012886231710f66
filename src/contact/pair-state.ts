import * as g from '../collide/layout.js';
import { Slab } from '../math/doubles.js';
import type { Shape } from '../shape/shape.js';
import {
  ACCEPTED,
  ACTIVE,
  FIXED,
  FRESH,
  NEAR,
  ROCKS,
  SENSOR,
  SHOWN,
  SLEEPING,
  STRAINS,
  USED,
  USED_BEFORE,
} from './bits.js';

/** A step number long before the first. */
const LONG_AGO = -1e6;

/** The records of pairs. */
const slab = /* @__PURE__ */ new Slab();

/**
 * What each step reads of thousands of pairs. It is kept small, as steps wait for memory here: all that is true or false is a bit of one
 * number. {@link Arbiter} is its public face.
 */
export abstract class PairState {
  /** @internal see `bits.ts` */
  bits: number = ACCEPTED;
  /** @internal where the record of the pair begins: the output of collision and solver, see `collide/layout.ts` and `layout.ts` */
  at: number = slab.take(g.PAIR_STRIDE);
  /** @internal the slab that holds the record */
  numbers: Float64Array = slab.numbers;
  /** The shape with the lower id. */
  shapeA: Shape;
  /** The shape with the higher id: normals point from A to B. */
  shapeB: Shape;
  /** @internal the number of this object among those of its world, from 1 on */
  readonly number: number;
  /** @internal the last step in which the broadphase reported the pair and the filters let it pass */
  seen = -1;
  /** @internal the last step in which the shapes interacted */
  lastInteraction = -1;
  /** @internal index in the world's list of dynamic or static arbiters */
  listIndex = -1;
  /**
   * @internal if the points are those of a predicted meeting: index into `Movers.foresight`, which has how far the surfaces approach until
   * then; 0 if the points are those of the present placements
   */
  foreseen = 0;
  /** @internal the step from which on it no longer counts as strained, which is to bear far more than its bodies weigh */
  strainedUntil = LONG_AGO;
  /** @internal the step in which the present interaction began, or the last one */
  began = -1;
  /** @internal for how many steps on end it has borne far more than its bodies weigh, see `strainFor` */
  strain = 0;

  /** @internal */
  constructor(shapeA: Shape, shapeB: Shape, number: number) {
    this.shapeA = shapeA;
    this.shapeB = shapeB;
    this.number = number;
  }

  /**
   * Whether the shapes interacted in the latest step. An arbiter that is neither `active` nor `sleeping` is the cache of an interaction
   * that is over: skip it.
   */
  get active(): boolean {
    return this.is(ACTIVE);
  }

  /**
   * Whether in the latest step both bodies were asleep while the shapes still interacted. The arbiter is then in no list of the world, and
   * its impulses read 0.
   */
  get sleeping(): boolean {
    return this.is(SLEEPING);
  }

  /** Whether one of the shapes is a sensor: then there are no contacts and no physics. */
  get sensor(): boolean {
    return this.is(SENSOR);
  }

  /** @internal */
  is(bit: number): boolean {
    return (this.bits & bit) !== 0;
  }

  /** @internal */
  mark(bits: number): void {
    this.bits |= bits;
  }

  /** @internal */
  unmark(bits: number): void {
    this.bits &= ~bits;
  }

  /** @internal sets or clears bits */
  put(bits: number, on: boolean): void {
    this.bits = on ? this.bits | bits : this.bits & ~bits;
  }

  /** @internal which of the combined material values were set by hand: four bits */
  get fixed(): number {
    return (this.bits >> FIXED) & 15;
  }

  /** @internal bits 0 and 1: whether the velocity solver used the point when it last solved the pair */
  get usedPoints(): number {
    return (this.bits >> USED) & 3;
  }

  /** @internal bits 0 and 1: whether the latest step was the first in which it used the point */
  get freshPoints(): number {
    return (this.bits >> FRESH) & 3;
  }

  /** @internal how many points `contacts` lists */
  get shown(): number {
    return (this.bits >> SHOWN) & 3;
  }

  /** @internal after an impact: of the points that were used those are fresh that were not before this step */
  noteImpact(): void {
    const fresh = this.usedPoints & ~(this.bits >> USED_BEFORE);
    this.bits = (this.bits & ~(3 << FRESH)) | (fresh << FRESH);
  }

  /** @internal whether it joins its bodies to one island: active and accepted */
  isSolid(): boolean {
    return (this.bits & (ACTIVE | ACCEPTED)) === (ACTIVE | ACCEPTED);
  }

  /** @internal whether the solver has a contact for it: solid or speculative */
  isSolved(): boolean {
    return this.is(NEAR) || this.isSolid();
  }

  /** @internal sets for how many steps on end it has been strained */
  strainFor(steps: number): void {
    this.strain = steps;
    this.put(STRAINS, steps > 0);
  }

  /** @internal as if it had never been strained or rocking */
  calm(): void {
    this.strainFor(0);
    this.strainedUntil = LONG_AGO;
    this.unmark(ROCKS);
  }
}
