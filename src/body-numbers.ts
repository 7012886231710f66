import { Slab } from './math/doubles.js';

const COUNT = 25;
/** How many of the first numbers are the placement and the velocity of a body, the velocity last. */
export const MOTION = 8;
/** The range of the motion of the last step, with the clearance after it. */
export const LAST_MOTION = 11;
export const LAST_MOTION_END = 15;
/** The range of what was set by hand and lasts, but for the share of gravity, which follows. */
export const LASTING = 15;
export const LASTING_END = 24;

const slab = /* @__PURE__ */ new Slab();

/** The numbers of a body, in a slab: each step walks through those of all bodies, and as fields each would be boxed somewhere in memory. */
export abstract class BodyNumbers {
  /** @internal */
  readonly at = slab.take(COUNT);
  /** @internal */
  readonly numbers = slab.numbers;

  /** @internal m. Keeps its name. */
  get x(): number {
    return this.numbers[this.at]!;
  }
  /** @internal */
  set x(value: number) {
    this.numbers[this.at] = value;
  }

  /** @internal Keeps its name. */
  get y(): number {
    return this.numbers[this.at + 1]!;
  }
  /** @internal */
  set y(value: number) {
    this.numbers[this.at + 1] = value;
  }

  /** @internal rad */
  get angle(): number {
    return this.numbers[this.at + 2]!;
  }
  /** @internal */
  set angle(value: number) {
    this.numbers[this.at + 2] = value;
  }

  /** @internal Keeps its name. */
  get cos(): number {
    return this.numbers[this.at + 3]!;
  }
  /** @internal */
  set cos(value: number) {
    this.numbers[this.at + 3] = value;
  }

  /** @internal Keeps its name. */
  get sin(): number {
    return this.numbers[this.at + 4]!;
  }
  /** @internal */
  set sin(value: number) {
    this.numbers[this.at + 4] = value;
  }

  /** @internal m/s */
  get vx(): number {
    return this.numbers[this.at + 5]!;
  }
  /** @internal */
  set vx(value: number) {
    this.numbers[this.at + 5] = value;
  }

  /** @internal */
  get vy(): number {
    return this.numbers[this.at + 6]!;
  }
  /** @internal */
  set vy(value: number) {
    this.numbers[this.at + 6] = value;
  }

  /** @internal rad/s */
  get w(): number {
    return this.numbers[this.at + 7]!;
  }
  /** @internal */
  set w(value: number) {
    this.numbers[this.at + 7] = value;
  }

  /** @internal kg; right after `refreshMass` */
  get mass(): number {
    return this.numbers[this.at + 8]!;
  }
  /** @internal */
  set mass(value: number) {
    this.numbers[this.at + 8] = value;
  }

  /** @internal kg·m²; right after `refreshMass` */
  get inertia(): number {
    return this.numbers[this.at + 9]!;
  }
  /** @internal */
  set inertia(value: number) {
    this.numbers[this.at + 9] = value;
  }

  /** @internal m. The largest distance of a point of its shapes from the origin; right after `refreshMass` */
  get radius(): number {
    return this.numbers[this.at + 10]!;
  }
  /** @internal */
  set radius(value: number) {
    this.numbers[this.at + 10] = value;
  }

  /** @internal m. Motion of the last step. Keeps its name: other bundles read it */
  get lastDx(): number {
    return this.numbers[this.at + 11]!;
  }
  /** @internal */
  set lastDx(value: number) {
    this.numbers[this.at + 11] = value;
  }

  /** @internal Keeps its name. */
  get lastDy(): number {
    return this.numbers[this.at + 12]!;
  }
  /** @internal */
  set lastDy(value: number) {
    this.numbers[this.at + 12] = value;
  }

  /** @internal rad. Keeps its name. */
  get lastTurn(): number {
    return this.numbers[this.at + 13]!;
  }
  /** @internal */
  set lastTurn(value: number) {
    this.numbers[this.at + 13] = value;
  }

  /** @internal m. How far it may move in this step, in any direction, without coming near anything that it would be swept against */
  get clearance(): number {
    return this.numbers[this.at + 14]!;
  }
  /** @internal */
  set clearance(value: number) {
    this.numbers[this.at + 14] = value;
  }

  /** @internal as if it had not moved in the last step */
  forgetMotion(): void {
    this.numbers.fill(0, this.at + LAST_MOTION, this.at + LAST_MOTION_END);
  }

  /** @internal N */
  get fx(): number {
    return this.numbers[this.at + 15]!;
  }
  /** @internal */
  set fx(value: number) {
    this.numbers[this.at + 15] = value;
  }

  /** @internal */
  get fy(): number {
    return this.numbers[this.at + 16]!;
  }
  /** @internal */
  set fy(value: number) {
    this.numbers[this.at + 16] = value;
  }

  /** @internal N·m */
  get appliedTorque(): number {
    return this.numbers[this.at + 17]!;
  }
  /** @internal */
  set appliedTorque(value: number) {
    this.numbers[this.at + 17] = value;
  }

  /** @internal m/s */
  get surfaceX(): number {
    return this.numbers[this.at + 18]!;
  }
  /** @internal */
  set surfaceX(value: number) {
    this.numbers[this.at + 18] = value;
  }

  /** @internal */
  get surfaceY(): number {
    return this.numbers[this.at + 19]!;
  }
  /** @internal */
  set surfaceY(value: number) {
    this.numbers[this.at + 19] = value;
  }

  /** @internal the share of the velocity lost per second */
  get linearDrag(): number {
    return this.numbers[this.at + 20]!;
  }
  /** @internal */
  set linearDrag(value: number) {
    this.numbers[this.at + 20] = value;
  }

  /** @internal */
  get angularDrag(): number {
    return this.numbers[this.at + 21]!;
  }
  /** @internal */
  set angularDrag(value: number) {
    this.numbers[this.at + 21] = value;
  }

  /** @internal given mass, or −1: from the shapes */
  get fixedMass(): number {
    return this.numbers[this.at + 22]!;
  }
  /** @internal */
  set fixedMass(value: number) {
    this.numbers[this.at + 22] = value;
  }

  /** @internal given inertia, or −1: from the shapes */
  get fixedInertia(): number {
    return this.numbers[this.at + 23]!;
  }
  /** @internal */
  set fixedInertia(value: number) {
    this.numbers[this.at + 23] = value;
  }

  /** @internal how much of the world's gravity acts on it */
  get gravityScale(): number {
    return this.numbers[this.at + 24]!;
  }
  /** @internal */
  set gravityScale(value: number) {
    this.numbers[this.at + 24] = value;
  }
}
