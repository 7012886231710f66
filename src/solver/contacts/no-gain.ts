import { FAR } from '../../config.js';

// Where a bounce has to end with a share of the speed that it came with (Newton), friction that turns the bodies meanwhile may ask for more normal impulse than there is energy for (Kane & Levinson, "Dynamics:
// Theory and Applications", 1985). Without friction it never does. Both solutions keep that share and the cone of friction, and so do all between them, as both are linear; and energy is a convex function along the way:
// it is as before at one place, where as much is left of friction as there can be.

/** Energies that differ by no larger a share are taken for the same: sums of many bodies are rounded. */
const ROUNDING = 1e-9;

/** The velocities of the bodies of an impact, and what they weigh: three numbers a body. Used again and again. */
export class Ledger {
  /** `[m, m, inertia]` of each body, 0 for what cannot move. */
  weights = new Float64Array(0);
  /** `[vx, vy, w]` of each: before the impact, after it, and after it as they would be without friction. */
  before = new Float64Array(0);
  after = new Float64Array(0);
  without = new Float64Array(0);
  private count = 0;

  /** Makes room for so many bodies. */
  open(bodies: number): void {
    this.count = 3 * bodies;
    if (this.weights.length < this.count) {
      const size = 2 * this.count;
      this.weights = new Float64Array(size);
      this.before = new Float64Array(size);
      this.after = new Float64Array(size);
      this.without = new Float64Array(size);
    }
  }

  /** Whether `after` is within reach. */
  isFinite(): boolean {
    let sum = 0;
    for (let k = 0; k < this.count; k += 1) {
      sum += Math.abs(this.after[k]!);
    }
    return sum <= FAR;
  }

  /** Whether `after` has more energy than `before`. */
  gains(): boolean {
    const { weights, before, after, count } = this;
    let was = 0;
    let is = 0;
    for (let k = 0; k < count; k += 1) {
      was += weights[k]! * before[k]! * before[k]!;
      is += weights[k]! * after[k]! * after[k]!;
    }
    return is > was * (1 + ROUNDING);
  }

  /** Goes so much of the way from `without` to `after`, with friction, as ends with the energy of `before`: `without` has what comes out. @returns that share of the way. */
  lessen(): number {
    const { weights, before, after, without, count } = this;
    let surplus = 0;
    let slope = 0;
    let bend = 0;
    for (let k = 0; k < count; k += 1) {
      const way = after[k]! - without[k]!;
      surplus += weights[k]! * (without[k]! * without[k]! - before[k]! * before[k]!);
      slope += weights[k]! * without[k]! * way;
      bend += weights[k]! * way * way;
    }
    const root = (Math.sqrt(Math.max(0, slope * slope - bend * surplus)) - slope) / bend;
    const kept = root > 0 ? (root < 1 ? root : 1) : 0;
    for (let k = 0; k < count; k += 1) {
      without[k] = without[k]! + kept * (after[k]! - without[k]!);
    }
    return kept;
  }
}
