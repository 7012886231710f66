import type { Ray, Rect } from '../../src/index.js';
import { generator } from '../scenes/mixed.js';

/** Random numbers that meet: a grid coarse enough that boxes touch, coincide and have no width or height all the time. */
export class RandomBoxes {
  private readonly random: () => number;

  /**
   * Not `extreme`: quarters and a few huge numbers, all exact in every sum. `extreme`: also infinite, tiny and odd numbers,
   * where sums are rounded or overflow.
   */
  constructor(
    seed: number,
    private readonly extreme: boolean,
  ) {
    this.random = generator(seed);
  }

  chance(probability: number): boolean {
    return this.random() < probability;
  }

  /** An integer in 0 … count − 1. */
  below(count: number): number {
    return Math.floor(count * this.random());
  }

  pick<T>(list: readonly T[]): T {
    return list[this.below(list.length)]!;
  }

  coordinate(): number {
    if (this.extreme && this.chance(0.25)) {
      return this.pick([-Infinity, Infinity, -1e300, 1e300, -1e-300, 5e-324, 1e17, -0, 0.1 * this.below(80), 1 / 3]);
    }
    return this.chance(0.03) ? this.pick([-1, 1]) * 2 ** 40 : this.below(80) / 4;
  }

  box(): Rect {
    const [a, b] = [this.coordinate(), this.coordinate()];
    if (this.extreme && this.chance(0.5)) {
      const [c, d] = [this.coordinate(), this.coordinate()];
      return [Math.min(a, c), Math.min(b, d), Math.max(a, c), Math.max(b, d)];
    }
    const size = this.chance(0.05) ? 60 : 10;
    return [a, b, a + this.below(size) / 4, b + this.below(size) / 4];
  }

  /** Where a thing may be next: a little further, larger or smaller, where it was, or anywhere. */
  after([x0, y0, x1, y1]: Rect): Rect {
    const [dx, dy] = [(this.below(9) - 4) / 4, (this.below(9) - 4) / 4];
    switch (this.below(5)) {
      case 0:
        return [x0, y0, x1, y1];
      case 1:
        return [x0 - Math.abs(dx), y0, x1, y1 + Math.abs(dy)];
      case 2:
        return [x0, y0, x0, y0];
      case 3:
        return this.box();
      default:
        return [x0 + dx, y0 + dy, x1 + dx, y1 + dy];
    }
  }

  /** Sometimes 0, but not among tiny numbers, whose squares are 0. */
  radius(): number {
    return this.pick([this.extreme ? 0.25 : 0, 0.25, 1, 3, 5, 30]);
  }

  /** Often along an axis, and along the sides of boxes. Divisions by its direction are exact unless `extreme`. */
  ray(): Ray {
    const steps = this.extreme ? [0, -0, 1, -3, 0.1, 1e-300, -1e300] : [0, 0, 1, -1, 0.5, -2, 4];
    let direction = [0, 0];
    while (direction[0] === 0 && direction[1] === 0) {
      direction = [this.pick(steps), this.pick(steps)];
    }
    const maxFactor = this.pick([Infinity, 0, 1, 4, 16, 64]);
    return { origin: [this.below(80) / 4, this.below(80) / 4], direction, maxFactor };
  }
}

/** The factor at which a ray meets a box, `Infinity` if never: where the times spent between both pairs of sides begin to coincide. */
export function meeting(box: Rect, { origin, direction }: Ray): number {
  let [from, to] = [0, Infinity];
  for (const axis of [0, 1] as const) {
    const [low, high] = [box[axis], box[axis === 0 ? 2 : 3]];
    const [o, d] = [origin[axis]!, direction[axis]!];
    if (d === 0) {
      to = low <= o && o <= high ? to : -1;
    } else {
      from = Math.max(from, ((d > 0 ? low : high) - o) / d);
      to = Math.min(to, ((d > 0 ? high : low) - o) / d);
    }
  }
  return from <= to ? from : Infinity;
}
