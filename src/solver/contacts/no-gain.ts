import { FAR } from '../../config.js';

// Where a bounce has to end with a share of the speed that it came with (Newton), friction that turns the bodies meanwhile may ask for more
// normal impulse than there is energy for (Kane & Levinson, "Dynamics: Theory and Applications", 1985). Without friction it never does. The
// solutions with and without friction both satisfy that share and the friction cone, and so do all between them, as both conditions are
// linear. Energy is a convex function along the way between: it is the same as before at one place, where as much of the friction is left
// as there can be.

/** Energies that differ by no larger a share count as equal: sums over many bodies are rounded. */
const ROUNDING = 1e-9;

/** The velocities of the bodies of an impact, and their masses: three numbers a body. The object is used again and again. */
export class Ledger {
  /** `[m, m, inertia]` of each body, 0 for what cannot move. */
  weights = new Float64Array(0);
  /** `[vx, vy, w]` of each: before the impact, after it, and after it without friction. */
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

  /** Whether the velocities of `after` are finite, and not too large. */
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

  /**
   * Goes from `without` towards `after`, with friction, until the energy is that of `before`, and leaves the outcome in `without`. @returns
   * the share of the way that it went.
   */
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
