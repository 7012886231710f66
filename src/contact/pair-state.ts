import * as g from '../collide/layout.js';
import { Slab } from '../math/doubles.js';
import type { Shape } from '../shape/shape.js';
import { ACCEPTED, ACTIVE, FIXED, FRESH, NEAR, ROCKS, SENSOR, SHOWN, SLEEPING, STRAINS, USED } from './bits.js';

/** Long before the first step. */
const LONG_AGO = -1e6;

/** The records of pairs. */
const slab = /* @__PURE__ */ new Slab();

/**
 * What steps ask of each of thousands of pairs, in as little memory as it takes, as that is what they wait for: of what is so or not, each is a bit of one number. {@link Arbiter} is
 * its public face.
 */
export abstract class PairState {
  /** @internal see `bits.ts` */
  bits: number = ACCEPTED;
  /** @internal where the record of the pair begins: what collision and solver found, see `collide/layout.ts` and `layout.ts` */
  at: number = slab.take(g.PAIR_STRIDE);
  /** @internal the slab that it is in */
  numbers: Float64Array = slab.numbers;
  /** The shape with the lower id. */
  shapeA: Shape;
  /** The other one: normals point from A to B. */
  shapeB: Shape;
  /** @internal among those of its world, from 1 on */
  readonly number: number;
  /** @internal the last step in which the broadphase reported the pair, and filters let it pass */
  seen = -1;
  /** @internal the last step in which the shapes interacted */
  lastInteraction = -1;
  /** @internal index in the world's list it is in */
  listIndex = -1;
  /** @internal where `Movers.foresight` tells how much nearer the surfaces are when they will meet, of which its points are; 0 if they are those of now */
  foreseen = 0;
  /** @internal the last step in which it bore far more than the bodies weigh for long */
  strained = LONG_AGO;
  /** @internal the step in which the present interaction began, or the last one */
  began = -1;
  /** @internal for so many steps on end it did, see `strainFor` */
  strain = 0;

  /** @internal */
  constructor(shapeA: Shape, shapeB: Shape, number: number) {
    this.shapeA = shapeA;
    this.shapeB = shapeB;
    this.number = number;
  }

  /**
   * The shapes interacted in the latest step. If not, and the arbiter is not `sleeping` either, it is kept of an interaction that is over, and
   * has to be skipped.
   */
  get active(): boolean {
    return this.is(ACTIVE);
  }

  /** In the latest step both bodies were asleep, interacting still; the arbiter is in no list of the world, and its impulses read 0. */
  get sleeping(): boolean {
    return this.is(SLEEPING);
  }

  /** One of the shapes is a sensor: no contacts, no physics. */
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

  /** @internal marks or unmarks */
  put(bits: number, on: boolean): void {
    this.bits = on ? this.bits | bits : this.bits & ~bits;
  }

  /** @internal which of the mixed values were set by hand: four bits */
  get fixed(): number {
    return (this.bits >> FIXED) & 15;
  }

  /** @internal bit 0 and 1: the velocity solver used the point when it was last there */
  get usedPoints(): number {
    return (this.bits >> USED) & 3;
  }

  /** @internal … for the first time in the latest step */
  get freshPoints(): number {
    return (this.bits >> FRESH) & 3;
  }

  /** @internal how many points `contacts` lists */
  get shown(): number {
    return (this.bits >> SHOWN) & 3;
  }

  /** @internal sets which points the solver used */
  use(points: number): void {
    this.bits = (this.bits & ~(3 << USED)) | (points << USED);
  }

  /** @internal joins islands */
  isSolid(): boolean {
    return (this.bits & (ACTIVE | ACCEPTED)) === (ACTIVE | ACCEPTED);
  }

  /** @internal has a place in the solver */
  isSolved(): boolean {
    return this.is(NEAR) || this.isSolid();
  }

  /** @internal sets for how many steps on end it is strained */
  strainFor(steps: number): void {
    this.strain = steps;
    this.put(STRAINS, steps > 0);
  }

  /** @internal neither strained, long since, if ever, nor rocking */
  calm(): void {
    this.strainFor(0);
    this.strained = LONG_AGO;
    this.unmark(ROCKS);
  }
}
