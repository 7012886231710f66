import { MIN_LENGTH } from '../config.js';
import type { Tape } from '../state/tape.js';
import { COS, POSE, SIN, X, Y } from './layout.js';

/** The straight line between an anchor on one body and one on another: a distance constraint has one, a pulley two. */
export class Link {
  /** Its direction when it was last long enough to have one. */
  nx = 1;
  ny = 0;

  /** `a` and `b`: the indices of the two members, and of their anchors. */
  constructor(
    private readonly a: number,
    private readonly b: number,
  ) {}

  /** Writes what influences the future to a tape, or reads it. */
  keep(tape: Tape): void {
    this.nx = tape.number(this.nx);
    this.ny = tape.number(this.ny);
  }

  /** Adds `ratio` times the length to C, and ratio · [−n, −rA × n, n, rB × n] to the Jacobian. */
  add(ratio: number, pose: Float64Array, anchors: Float64Array, out: Float64Array, c: number, j: number): void {
    const { a, b } = this;
    const p = a * POSE;
    const q = b * POSE;
    const ax = pose[p + COS]! * anchors[2 * a]! - pose[p + SIN]! * anchors[2 * a + 1]!;
    const ay = pose[p + SIN]! * anchors[2 * a]! + pose[p + COS]! * anchors[2 * a + 1]!;
    const bx = pose[q + COS]! * anchors[2 * b]! - pose[q + SIN]! * anchors[2 * b + 1]!;
    const by = pose[q + SIN]! * anchors[2 * b]! + pose[q + COS]! * anchors[2 * b + 1]!;
    const dx = pose[q + X]! + bx - pose[p + X]! - ax;
    const dy = pose[q + Y]! + by - pose[p + Y]! - ay;
    const length = Math.sqrt(dx * dx + dy * dy);
    if (length > MIN_LENGTH) {
      this.nx = dx / length;
      this.ny = dy / length;
    }
    const nx = ratio * this.nx;
    const ny = ratio * this.ny;
    out[c] = out[c]! + ratio * length;
    out[j + 3 * a] = -nx;
    out[j + 3 * a + 1] = -ny;
    out[j + 3 * a + 2] = ay * nx - ax * ny;
    out[j + 3 * b] = nx;
    out[j + 3 * b + 1] = ny;
    out[j + 3 * b + 2] = bx * ny - by * nx;
  }
}
